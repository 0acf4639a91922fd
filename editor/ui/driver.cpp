#include "ui/driver.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "maps/map_io.h"
#include "ui/imgui_compat.h"
#include "ui/keys.h"
#include "ui/window.h"

namespace sward {
namespace {

using ui::Kind;
using ui::Widget;

std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

class Driver : public UiDriver {
  public:
    explicit Driver(EditorApp& app) : app_(app) {}

    Status click(const std::string& label) override { return press(label, 0); }
    Status rightClick(const std::string& label) override { return press(label, 1); }
    Status drop(const std::filesystem::path& file) override {
        push({InputKind::Drop, 0, 0, 0, false, file.string()});
        settle();
        return {};
    }
    Status set(const std::string& label, const std::string& text) override;
    Result<std::string> get(const std::string& label) override {
        const Result<Widget> w = reveal(label);
        if (!w) return w.error();
        return w->value;
    }
    bool exists(const std::string& label) override {
        const bool there = static_cast<bool>(reveal(label));
        closeMenus();
        return there;
    }
    Status key(const std::string& chord) override;
    Result<std::array<double, 4>> rect(const std::string& label) override {
        const Result<Widget> w = reveal(label);
        if (!w) return w.error();
        return std::array<double, 4>{w->x0, w->y0, w->x1, w->y1};
    }
    Status drag(double x1, double y1, double x2, double y2, const std::string& held) override;
    Status wait(int count) override {
        frames(std::max(count, 0));
        return {};
    }
    Status screenshot(const std::filesystem::path& file) override;

  private:
    const Widget* find(const std::string& label) const {
        const auto it = app_.book.widgets.find(label);
        return it == app_.book.widgets.end() ? nullptr : &it->second;
    }
    void frames(int count) {
        for (int i = 0; i < count; ++i) runFrame(app_);
    }
    void push(const InputEvent& e) { app_.queue.push(e); }
    void pushKey(int key, bool down) { push({InputKind::Key, 0, 0, key, down}); }
    void moveTo(double x, double y) { push({InputKind::Move, x, y, 0, false}); }
    // Until input, strokes and edits are worked off.
    void settle() {
        frames(2);
        for (int i = 0; i < 10000 && (app_.queue.pending() || app_.doc.stroking() || !app_.edits.deferred.empty()); ++i)
            runFrame(app_);
    }
    void clickAt(const Widget& w, int button = 0);
    Status press(const std::string& label, int button) {
        const Result<Widget> w = reveal(label);
        if (!w) return w.error();
        if (!w->enabled) return usage("'" + label + "' is disabled");
        clickAt(*w, button);
        settle();
        return {};
    }
    void closeMenus();
    Result<Widget> reveal(const std::string& label);
    bool openWayTo(const std::string& label);
    void typeText(const std::string& text);
    // A list's item by its text, or by an unambiguous tail of it: maps are named so elsewhere too.
    Status choose(const std::string& label, const std::string& text);
    Status setVector(const std::string& label, const std::string& text);
    Status typed(const std::string& label);

    EditorApp& app_;
};

// A person's hand moves, rests, presses and lets go; each is a frame.
void Driver::clickAt(const Widget& w, int button) {
    moveTo(static_cast<double>(w.x0 + w.x1) / 2, static_cast<double>(w.y0 + w.y1) / 2);
    frames(2);
    push({InputKind::Button, 0, 0, button, true});
    frames(1);
    push({InputKind::Button, 0, 0, button, false});
    frames(2);
    ui::forgetClicks();  // the next one is no double click
}

// Opens what hides the widget: its entity, a folded section, a menu or list, a panel's tab. True if something was
// opened.
bool Driver::openWayTo(const std::string& label) {
    const size_t slash = label.find('/');
    const std::string panel = label.substr(0, slash), rest = slash == std::string::npos ? "" : label.substr(slash + 1);
    if (panel == "Inspector" && !rest.empty()) {
        const std::string entity = rest.substr(0, rest.find('.'));
        if (shownEntity(app_.selection) != entity && find("Outliner/" + entity))
            return static_cast<bool>(click("Outliner/" + entity));
    }
    if (const Widget* tab = find("Tabs/" + panel); tab && app_.layout.tab != panel)
        return static_cast<bool>(click("Tabs/" + panel));
    for (size_t end = label.size(); end-- > 0;) {
        if (label[end] != '/' && label[end] != '.') continue;
        const std::string parent = label.substr(0, end);
        const Widget* w = find(parent);
        if (!w || w->open || (w->kind != Kind::Menu && w->kind != Kind::Combo && w->kind != Kind::Section)) continue;
        return static_cast<bool>(click(parent));
    }
    if (label.starts_with("Menu/") &&
        rest.find('/') != std::string::npos) {  // a menu within reach only once another closed
        closeMenus();
        return false;
    }
    return false;
}

Result<Widget> Driver::reveal(const std::string& label) {
    frames(1);
    for (int tries = 0; tries < 6 && !find(label); ++tries) {
        if (!openWayTo(label)) break;
        frames(1);
    }
    const Widget* w = find(label);
    if (!w) return usage("there is no widget '" + label + "'", "widgets are named Panel/Label, such as Brush/Radius");
    for (int tries = 0; tries < 3 && w && !w->visible; ++tries) {
        app_.book.reveal = label;
        frames(3);
        w = find(label);
    }
    if (!w) return usage("'" + label + "' went away while it was scrolled to");
    return *w;
}

void Driver::closeMenus() {
    for (int i = 0; i < 3; ++i) {
        const auto open = [](const auto& item) {
            return item.second.open && (item.second.kind == Kind::Menu || item.second.kind == Kind::Combo);
        };
        if (std::none_of(app_.book.widgets.begin(), app_.book.widgets.end(), open)) return;
        pushKey(GLFW_KEY_ESCAPE, true);
        pushKey(GLFW_KEY_ESCAPE, false);
        frames(3);
    }
}

void Driver::typeText(const std::string& text) {
    pushKey(GLFW_KEY_LEFT_CONTROL, true);
    pushKey(GLFW_KEY_A, true);
    frames(1);
    pushKey(GLFW_KEY_A, false);
    pushKey(GLFW_KEY_LEFT_CONTROL, false);
    frames(2);
    if (text.empty()) {
        pushKey(GLFW_KEY_DELETE, true);
        pushKey(GLFW_KEY_DELETE, false);
    }
    for (size_t i = 0; i < text.size();) {  // UTF-8
        const unsigned char c = static_cast<unsigned char>(text[i]);
        const int extra = c >= 0xF0 ? 3 : c >= 0xE0 ? 2 : c >= 0xC0 ? 1 : 0;
        int code = extra == 3 ? c & 7 : extra == 2 ? c & 15 : extra == 1 ? c & 31 : c;
        for (int k = 1; k <= extra && i + static_cast<size_t>(k) < text.size(); ++k)
            code = code << 6 | (static_cast<unsigned char>(text[i + static_cast<size_t>(k)]) & 63);
        push({InputKind::Char, 0, 0, code, false});
        i += static_cast<size_t>(extra) + 1;
    }
    pushKey(GLFW_KEY_ENTER, true);
    pushKey(GLFW_KEY_ENTER, false);
    settle();
    frames(2);
}

// What the interface says of a value that was typed.
Status Driver::typed(const std::string& label) {
    const auto error = app_.book.errors.find(label);
    if (error != app_.book.errors.end()) return failed(label + ": " + error->second);
    return {};
}

Status Driver::choose(const std::string& label, const std::string& text) {
    const Widget* combo = find(label);
    if (combo && combo->value == text) return {};
    if (const Status opened = click(label); !opened) return opened;
    frames(2);
    std::string known;
    std::vector<std::string> exact, tails;
    const std::string prefix = label + "/", wanted = lower(text);
    for (const auto& [path, widget] : app_.book.widgets) {
        if (!path.starts_with(prefix)) continue;
        const std::string item = path.substr(prefix.size()), plain = lower(item.substr(0, item.find(" (")));
        if (plain == wanted || lower(item) == wanted) exact.push_back(path);
        if (plain.ends_with(wanted)) tails.push_back(path);
        known += (known.empty() ? "" : ", ") + item;
    }
    if (exact.size() == 1) return click(exact.front());
    if (exact.empty() && tails.size() == 1) return click(tails.front());
    closeMenus();
    return usage("'" + label + "' has no choice '" + text + "'", known.empty() ? "" : "it has " + known);
}

// "[1, 2, 3]" into the fields .x, .y and .z.
Status Driver::setVector(const std::string& label, const std::string& text) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == ',')
            parts.emplace_back();
        else if (c != '[' && c != ']' && c != ' ')
            parts.back() += c;
    }
    const std::string axes = parts.size() == 2 ? "xz" : "xyz";
    if (parts.size() != axes.size()) return usage("'" + text + "' is no vector", "write [x, y, z]");
    for (size_t i = 0; i < parts.size(); ++i)
        if (const Status status = set(label + "." + axes[i], parts[i]); !status) return status;
    return {};
}

Status Driver::set(const std::string& label, const std::string& text) {
    const Result<Widget> w = reveal(label);
    if (!w) return w.error();
    if (!w->enabled) return usage("'" + label + "' is disabled");
    switch (w->kind) {
        case Kind::Checkbox:
            if (text != "true" && text != "false") return usage("'" + label + "' takes true or false");
            return w->value == text ? Status{} : click(label);
        case Kind::Combo:
            return choose(label, text);
        case Kind::Vector:
            return setVector(label, text);
        case Kind::Slider:
            pushKey(GLFW_KEY_LEFT_CONTROL, true);
            clickAt(*w);
            pushKey(GLFW_KEY_LEFT_CONTROL, false);
            frames(3);
            typeText(text);
            return typed(label);
        case Kind::Text:
            clickAt(*w);
            typeText(text);
            return typed(label);
        default:
            return usage("'" + label + "' has no value to set");
    }
}

Status Driver::key(const std::string& text) {
    const std::optional<Chord> chord = parseChord(text);
    if (!chord) return usage("'" + text + "' is no key", "write ctrl+z, f5, [ or shift+left");
    frames(1);
    const std::pair<bool, int> modifiers[] = {
        {chord->ctrl, GLFW_KEY_LEFT_CONTROL}, {chord->shift, GLFW_KEY_LEFT_SHIFT}, {chord->alt, GLFW_KEY_LEFT_ALT}};
    for (const auto& [held, code] : modifiers)
        if (held) pushKey(code, true);
    pushKey(chord->key, true);
    const char c = keyChar(chord->key);
    if (c && !chord->ctrl && !chord->alt)
        push({InputKind::Char, 0, 0, chord->shift ? std::toupper(static_cast<unsigned char>(c)) : c, false});
    frames(1);
    pushKey(chord->key, false);
    for (const auto& [held, code] : modifiers)
        if (held) pushKey(code, false);
    settle();
    return {};
}

Status Driver::drag(double x1, double y1, double x2, double y2, const std::string& held) {
    constexpr int kSteps = 12;
    const std::optional<Chord> chord = held.empty() ? Chord{} : parseChord(held + "+a");
    if (!chord) return usage("'" + held + "' are no modifiers", "write ctrl, shift, alt or ctrl+shift");
    const std::pair<bool, int> modifiers[] = {
        {chord->ctrl, GLFW_KEY_LEFT_CONTROL}, {chord->shift, GLFW_KEY_LEFT_SHIFT}, {chord->alt, GLFW_KEY_LEFT_ALT}};
    for (const auto& [down, code] : modifiers)
        if (down) pushKey(code, true);
    moveTo(x1, y1);
    frames(2);
    push({InputKind::Button, 0, 0, 0, true});
    frames(1);
    for (int i = 1; i <= kSteps; ++i) {
        moveTo(x1 + (x2 - x1) * i / kSteps, y1 + (y2 - y1) * i / kSteps);
        frames(1);
    }
    push({InputKind::Button, 0, 0, 0, false});
    for (const auto& [down, code] : modifiers)
        if (down) pushKey(code, false);
    settle();
    ui::forgetClicks();
    return {};
}

Status Driver::screenshot(const std::filesystem::path& file) {
    Status status;
    app_.clock.refineNow = true;
    frames(2);
    app_.beforePresent = [&](ui::Surface& s) {
        std::vector<uint8_t> pixels = readSurface(s);
        for (size_t i = 3; i < pixels.size(); i += 4) pixels[i] = 255;
        status = writeImagePng(file, s.pixelWidth(), s.pixelHeight(), 4, pixels);
    };
    frames(1);
    app_.clock.refineNow = false;
    return status;
}

// The editor comes with its driver; the window's GPU too.
class OwningDriver final : public UiDriver {
  public:
    OwningDriver(Document& document, Gpu* gpu, std::unique_ptr<Gpu> owned, std::unique_ptr<ui::Surface> surface)
        : gpu_(std::move(owned)), app_(document, gpu_ ? *gpu_ : *gpu, std::move(surface), false), driver_(app_) {}
    Status click(const std::string& label) override { return driver_.click(label); }
    Status rightClick(const std::string& label) override { return driver_.rightClick(label); }
    Status drop(const std::filesystem::path& file) override { return driver_.drop(file); }
    Status set(const std::string& label, const std::string& text) override { return driver_.set(label, text); }
    Result<std::string> get(const std::string& label) override { return driver_.get(label); }
    bool exists(const std::string& label) override { return driver_.exists(label); }
    Status key(const std::string& chord) override { return driver_.key(chord); }
    Result<std::array<double, 4>> rect(const std::string& label) override { return driver_.rect(label); }
    Status drag(double x1, double y1, double x2, double y2, const std::string& held) override {
        return driver_.drag(x1, y1, x2, y2, held);
    }
    Status wait(int frames) override { return driver_.wait(frames); }
    Status screenshot(const std::filesystem::path& file) override { return driver_.screenshot(file); }

  private:
    std::unique_ptr<Gpu> gpu_;
    EditorApp app_;
    Driver driver_;
};

}  // namespace

std::unique_ptr<UiDriver> makeUiDriver(EditorApp& app) { return std::make_unique<Driver>(app); }

std::unique_ptr<UiDriver> makeHeadlessUi(Document& document, Gpu& gpu, int width, int height, float density) {
    return std::make_unique<OwningDriver>(document, &gpu, nullptr, ui::makeHeadlessSurface(width, height, density));
}

Result<std::unique_ptr<UiDriver>> makeWindowUi(Document& document, int width, int height) {
    auto window = ui::openWindow(width, height, "Sward");
    if (!window) return window.error();
    auto gpu = adoptCurrentGpu();
    if (!gpu) return gpu.error();
    return std::unique_ptr<UiDriver>(
        std::make_unique<OwningDriver>(document, nullptr, std::move(*gpu), std::move(*window)));
}

}  // namespace sward
