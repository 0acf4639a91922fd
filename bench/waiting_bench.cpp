// How long a person waits for the editor, on park at 1440 x 900: from a press until the frame that shows what it does
// is presented. Presses come at times of their own, as a hand's do, so that the frame under way then counts, too. The
// frames are those of a window but for the window system's share.
#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>

#include "app/app.h"
#include "bench/limits.h"
#include "techniques.h"
#include "tools/brush_target.h"
#include "ui/surface.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace {
using namespace sward;

constexpr int kWidth = 1440, kHeight = 900;

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// A framebuffer that is presented when it is drawn, and a hand whose events come at their times.
class LiveSurface final : public ui::Surface {
  public:
    LiveSurface() {
        glCreateTextures(GL_TEXTURE_2D, 1, &texture_);
        glTextureStorage2D(texture_, 1, GL_RGBA8, kWidth, kHeight);
        glCreateFramebuffers(1, &framebuffer_);
        glNamedFramebufferTexture(framebuffer_, GL_COLOR_ATTACHMENT0, texture_, 0);
    }
    ~LiveSurface() override {
        glDeleteFramebuffers(1, &framebuffer_);
        glDeleteTextures(1, &texture_);
    }
    int width() const override { return kWidth; }
    int height() const override { return kHeight; }
    void poll(InputQueue& queue, double) override {
        for (; !hand.empty() && hand.front().first <= now(); hand.pop_front()) queue.push(hand.front().second);
    }
    void bind() override { glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_); }
    void present() override { glFinish(); }

    std::deque<std::pair<double, InputEvent>> hand;  // in the order of their times

  private:
    unsigned texture_ = 0, framebuffer_ = 0;
};

InputEvent moved(double x, double y) { return {InputKind::Move, x, y}; }
InputEvent button(bool down) { return {InputKind::Button, 0, 0, 0, down}; }
InputEvent key(int code, bool down) { return {InputKind::Key, 0, 0, code, down}; }

struct Desk {
    Document doc{tables()};
    LiveSurface* surface = nullptr;
    std::unique_ptr<EditorApp> app;

    explicit Desk(const std::string& project) {
        Gpu* context = gpu();  // current from here on
        CHECK(context);
        CHECK(bool(doc.open(std::string(SWARD_SOURCE_DIR) + "/projects/" + project)));
        auto made = std::make_unique<LiveSurface>();
        surface = made.get();
        app = std::make_unique<EditorApp>(doc, *context, std::move(made), false);
        app->strokeTiming.on = false;
        rest();
    }
    void frames(double seconds) {
        for (const double end = now() + seconds; now() < end;) runFrame(*app);
    }
    // Until the full picture is there: programs are compiled then, and the editor knows what pictures cost.
    void rest() {
        const double end = now() + 60;
        for (int still = 0; still < 8 && now() < end;) {
            runFrame(*app);
            still = app->picture.resolution.drawnScale >= 1 && app->clock.wanted <= 0 ? still + 1 : 0;
        }
    }
    // Begins to refine another picture, and is so long at it.
    void refine(double seconds) {
        app->view.camera.yaw += 0.002;
        frames(seconds);
    }
    glm::dvec2 middleOf(const char* widget) const {
        const ui::Widget& w = app->book.widgets.at(widget);
        return {(w.x0 + w.x1) / 2, (w.y0 + w.y1) / 2};
    }
    // ms from the first event's time, a moment from now, until `shown` holds after a frame.
    template <class Shown>
    double answerMs(double moment, const std::vector<InputEvent>& events, const Shown& shown) {
        const double at = now() + moment;
        for (size_t i = 0; i < events.size(); ++i)
            surface->hand.emplace_back(at + 0.001 * static_cast<double>(i), events[i]);
        for (const double end = at + 5; now() < end;) {
            runFrame(*app);
            if (shown()) return 1000 * (now() - at);
        }
        return NAN;
    }
};

// Median and slowest of what a press takes while the picture refines, each at another moment of it.
template <class Once>
void reportAnswers(const char* what, const Once& once) {
    std::vector<double> ms;
    for (int i = 0; i < 16; ++i) ms.push_back(once(0.35 + 0.09 * i, 0.001 * ((i * 37) % 60)));
    reportLimit(fmt::format("{} while the picture refines, median", what).c_str(), median(ms), 50, "ms");
    reportLimit(fmt::format("{} while the picture refines, slowest of 16", what).c_str(),
                *std::max_element(ms.begin(), ms.end()), 50, "ms");
}

SWARD_LIMITS("waiting", [] {
    Desk desk("park");
    EditorApp& app = *desk.app;
    const auto has = [&](const char* widget) { return app.book.widgets.contains(widget); };
    reportAnswers("menu File opens", [&](double refining, double moment) {
        const glm::dvec2 at = desk.middleOf("Menu/File");
        desk.surface->hand.emplace_back(now(), moved(at.x, at.y));
        desk.refine(refining);
        const double ms =
            desk.answerMs(moment, {button(true), button(false)}, [&] { return has("Menu/File/Open..."); });
        desk.surface->hand.emplace_back(now(), key(GLFW_KEY_ESCAPE, true));
        desk.surface->hand.emplace_back(now(), key(GLFW_KEY_ESCAPE, false));
        desk.frames(0.3);
        return ms;
    });
    reportAnswers("the key of a tool", [&](double refining, double moment) {
        const std::string before = app.brushes.tool;
        desk.surface->hand.emplace_back(now(), moved(700, 450));
        desk.refine(refining);
        return desk.answerMs(moment, {key(GLFW_KEY_V, true), key(GLFW_KEY_V, false)},
                             [&] { return app.brushes.tool != before; });
    });
});

// Pictures of a quick stroke, in which each frame has stamps, as coarse as the editor draws them while it lasts.
SWARD_LIMITS("painting", [] {
    Desk desk("park");
    EditorApp& app = *desk.app;
    selectTool(desk.doc, app.brushes, app.messages, "subtract");
    desk.rest();
    std::vector<double> taps;
    for (int i = 0; i < 9; ++i) {
        const double x = 500 + 40 * i, y = 620;
        desk.surface->hand.emplace_back(now(), moved(x, y));
        desk.rest();
        const uint64_t before = desk.doc.revision();
        taps.push_back(desk.answerMs(0.013 * i, {button(true), button(false)}, [&] {
            return desk.doc.revision() != before && app.picture.drawnRevision == desk.doc.revision();
        }));
    }
    reportLimit("a tap is seen on park, median", median(taps), 200, "ms");
    reportLimit("a tap is seen on park, slowest of 9", *std::max_element(taps.begin(), taps.end()), 200, "ms");
    constexpr double kSeconds = 3;
    const double begin = now() + 0.01;
    desk.surface->hand.emplace_back(begin, moved(400, 600));
    desk.surface->hand.emplace_back(begin, button(true));
    for (double t = 0; t < kSeconds; t += 1.0 / 60)
        desk.surface->hand.emplace_back(begin + t, moved(600 + 250 * std::sin(4 * t), 600 + 40 * std::sin(2.3 * t)));
    desk.frames(1);  // programs of other details are compiled meanwhile
    int pictures = 0;
    uint64_t last = app.picture.drawnRevision;
    const double from = now();
    while (now() < begin + kSeconds) {
        runFrame(app);
        pictures += std::exchange(last, app.picture.drawnRevision) != app.picture.drawnRevision;
    }
    const double each = 1000 * (now() - from) / std::max(pictures, 1);
    desk.surface->hand.emplace_back(now(), button(false));
    desk.frames(0.3);
    std::fprintf(stderr, "painting: pictures of %.3f of the side, %.3f of the blades\n",
                 app.picture.resolution.movingScale, app.picture.resolution.movingDetail);
    reportLimit("a picture while painting park", each, 200, "ms");
});

}  // namespace
