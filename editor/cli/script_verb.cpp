#include "app/film.h"
#include "cli/cli.h"
#include "cli/interrupt.h"
#include "core/log.h"
#include "model/bakes.h"
#include "model/document.h"
#include "model/scene_export.h"
#include "script/script.h"
#include "techniques.h"
#include "ui/driver.h"

namespace sward {
namespace {

// The editor without a window, made at the first ui.* call: scripts that only make maps need no OpenGL context.
class LazyUi final : public UiDriver {
  public:
    LazyUi(Document& document, std::pair<int, int> size, float density)
        : document_(document), size_(size), density_(density) {}
    Status click(const std::string& label) override {
        return with([&](UiDriver& d) { return d.click(label); });
    }
    Status rightClick(const std::string& label) override {
        return with([&](UiDriver& d) { return d.rightClick(label); });
    }
    Status drop(const std::filesystem::path& file) override {
        return with([&](UiDriver& d) { return d.drop(file); });
    }
    Status set(const std::string& label, const std::string& text) override {
        return with([&](UiDriver& d) { return d.set(label, text); });
    }
    Result<std::string> get(const std::string& label) override {
        if (Status s = make(); !s) return s.error();
        return driver_->get(label);
    }
    bool exists(const std::string& label) override { return make() && driver_->exists(label); }
    Status key(const std::string& chord) override {
        return with([&](UiDriver& d) { return d.key(chord); });
    }
    Result<std::array<double, 4>> rect(const std::string& label) override {
        if (Status s = make(); !s) return s.error();
        return driver_->rect(label);
    }
    Status drag(double x1, double y1, double x2, double y2, const std::string& held) override {
        return with([&](UiDriver& d) { return d.drag(x1, y1, x2, y2, held); });
    }
    Status wait(int frames) override {
        return with([&](UiDriver& d) { return d.wait(frames); });
    }
    Status screenshot(const std::filesystem::path& file) override {
        return with([&](UiDriver& d) { return d.screenshot(file); });
    }

    // Its context, for pictures without widgets.
    Result<Gpu*> gpu() {
        if (Status s = make(); !s) return s.error();
        return gpu_.get();
    }
    // The view of a camera: now if the editor is there, else once it is made.
    void useCamera(const std::string& name) {
        camera_ = name;
        if (driver_)
            if (Status s = driver_->set("Viewport/Camera", name); !s) logWarning(s.error().text());
    }

  private:
    Status make() {
        if (driver_) return {};
        auto gpu = makeHeadlessGpu();
        if (!gpu) return gpu.error();
        gpu_ = std::move(*gpu);
        driver_ = makeHeadlessUi(document_, *gpu_, size_.first, size_.second, density_);
        if (camera_.empty() || document_.play()) return {};  // in play the view is the walker's
        return driver_->set("Viewport/Camera", camera_);
    }
    template <class F>
    Status with(F&& f) {
        if (Status s = make(); !s) return s;
        return f(*driver_);
    }
    Document& document_;
    std::pair<int, int> size_;
    float density_;
    std::unique_ptr<Gpu> gpu_;
    std::unique_ptr<UiDriver> driver_;
    std::string camera_;
};

}  // namespace

int scriptVerb(const ScriptOptions& o) {
    const auto size = parseSize(o.size);
    if (!size) return report(size.error());
    Document document(tables());
    if (!o.project.empty())
        if (Status s = document.open(o.project); !s) return report(s.error());
    LazyUi lazy(document, *size, o.density);
    std::unique_ptr<UiDriver> window;
    ScriptHost host{document};
    const Interruptible here;  // a script that is stopped takes its temporary folders along
    host.stopped = interrupted;
    host.ui = &lazy;
    offerBakes(host);
    offerExport(host);
    if (!o.window) offerFilms(host, [&lazy] { return lazy.gpu(); });
    host.useCamera = [&](const std::string& name) { lazy.useCamera(name); };
    if (o.window) {
        auto made = makeWindowUi(document, 1440, 900);
        if (!made) return report(made.error());
        window = std::move(*made);
        host.ui = window.get();
        host.useCamera = [&](const std::string& name) {
            if (Status s = window->set("Viewport/Camera", name); !s) logWarning(s.error().text());
        };
    }
    if (Status s = runScript(o.file, host); !s) return report(s.error());
    return 0;
}

}  // namespace sward
