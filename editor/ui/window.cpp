#include "ui/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "ui/imgui_compat.h"
#include "ui/keys.h"

namespace sward::ui {
namespace {

struct Events {
    std::deque<InputEvent> list;
    bool refresh = false;  // the window system wants its pixels again
    bool close = false;
    bool moved = false;  // the pointer's place is known:
    double x = 0, y = 0;
};

Events& eventsOf(GLFWwindow* w) { return *static_cast<Events*>(glfwGetWindowUserPointer(w)); }

// Shortcuts go by what the key types, not by where it lies: on AZERTY, Ctrl+Z is where a French designer expects it.
int layoutKey(int key, int scancode) {
    if (key < GLFW_KEY_A || key > GLFW_KEY_Z) {
        if (key != GLFW_KEY_SEMICOLON && key != GLFW_KEY_COMMA) return key;
    }
    const char* name = glfwGetKeyName(key, scancode);
    if (!name || !name[0] || name[1]) return key;
    if (name[0] >= 'a' && name[0] <= 'z') return GLFW_KEY_A + (name[0] - 'a');
    return key;
}

void onKey(GLFWwindow* w, int key, int scancode, int action, int) {
    if (action == GLFW_REPEAT || key < 0) return;
    eventsOf(w).list.push_back({InputKind::Key, 0, 0, layoutKey(key, scancode), action == GLFW_PRESS});
}
void onChar(GLFWwindow* w, unsigned c) {
    eventsOf(w).list.push_back({InputKind::Char, 0, 0, static_cast<int>(c), false});
}
void onMove(GLFWwindow* w, double x, double y) {
    Events& events = eventsOf(w);
    events.moved = true;
    events.x = x, events.y = y;
    events.list.push_back({InputKind::Move, x, y, 0, false});
}
// Only before any motion is the pointer asked for: later it may be ahead of the events still to be read, and a button
// would go up in the wrong place.
void onButton(GLFWwindow* w, int button, int action, int) {
    double x, y;
    glfwGetCursorPos(w, &x, &y);
    if (!eventsOf(w).moved) onMove(w, x, y);
    eventsOf(w).list.push_back({InputKind::Button, 0, 0, button, action == GLFW_PRESS});
}
void onWheel(GLFWwindow* w, double dx, double dy) { eventsOf(w).list.push_back({InputKind::Wheel, dx, dy, 0, false}); }
void onDrop(GLFWwindow* w, int count, const char** files) {
    for (int i = 0; i < count; ++i) eventsOf(w).list.push_back({InputKind::Drop, 0, 0, 0, false, files[i]});
}
void onClose(GLFWwindow* w) {
    eventsOf(w).close = true;
    glfwSetWindowShouldClose(w, GLFW_FALSE);
}
void onRefresh(GLFWwindow* w) { eventsOf(w).refresh = true; }

void setClipboard(void* w, const char* text) { glfwSetClipboardString(static_cast<GLFWwindow*>(w), text); }
const char* clipboard(void* w) {
    const char* text = glfwGetClipboardString(static_cast<GLFWwindow*>(w));
    return text ? text : "";
}

class Window final : public Surface {
  public:
    explicit Window(GLFWwindow* window) : window_(window) {
        glfwSetWindowUserPointer(window, &events_);
        glfwSetKeyCallback(window, onKey);
        glfwSetCharCallback(window, onChar);
        glfwSetCursorPosCallback(window, onMove);
        glfwSetMouseButtonCallback(window, onButton);
        glfwSetScrollCallback(window, onWheel);
        glfwSetDropCallback(window, onDrop);
        glfwSetWindowCloseCallback(window, onClose);
        glfwSetWindowRefreshCallback(window, onRefresh);
    }
    ~Window() override {
        glfwDestroyWindow(window_);
        glfwTerminate();
    }
    int width() const override { return points(size(glfwGetWindowSize).first); }
    int height() const override { return points(size(glfwGetWindowSize).second); }
    int pixelWidth() const override { return size(glfwGetFramebufferSize).first; }
    int pixelHeight() const override { return size(glfwGetFramebufferSize).second; }
    void poll(InputQueue& queue, double seconds) override {
        if (seconds > 0)
            glfwWaitEventsTimeout(seconds);
        else
            glfwPollEvents();
        if (std::exchange(events_.refresh, false)) onMove(window_, events_.x, events_.y);  // any event makes a frame
        const double unit = coordinatesPerPoint();
        for (InputEvent& e : events_.list) {
            if (e.kind == InputKind::Move) e.x /= unit, e.y /= unit;
            queue.push(e);
        }
        events_.list.clear();
    }
    bool closeRequested() const override { return events_.close; }
    bool takeCloseRequest() override { return std::exchange(events_.close, false); }
    void bind() override { glBindFramebuffer(GL_FRAMEBUFFER, 0); }
    void present() override { glfwSwapBuffers(window_); }
    void setTitle(const std::string& title) override { glfwSetWindowTitle(window_, title.c_str()); }
    void setCursor(Cursor cursor) override {
        if (cursor == shown_) return;
        shown_ = cursor;
        glfwSetCursor(window_, cursors_[static_cast<size_t>(cursor)]);
    }
    void captureMouse(bool captured) override {
        glfwSetInputMode(window_, GLFW_CURSOR, captured ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
        double x, y;  // back where it was when it was captured, of which no event tells
        glfwGetCursorPos(window_, &x, &y);
        if (!captured) onMove(window_, x, y);
    }
    GLFWwindow* handle() const { return window_; }

  private:
    // Of the window's coordinates, which some systems scale for dense screens and others do not.
    double coordinatesPerPoint() const {
        float x = 1, y = 1;
        glfwGetWindowContentScale(window_, &x, &y);
        const double coordinates = std::max(1, size(glfwGetWindowSize).first), pixels = std::max(1, pixelWidth());
        return std::max(1.0, static_cast<double>(x) * coordinates / pixels);
    }
    int points(int coordinates) const { return static_cast<int>(std::lround(coordinates / coordinatesPerPoint())); }
    std::pair<int, int> size(void (*get)(GLFWwindow*, int*, int*)) const {
        int w = 0, h = 0;
        get(window_, &w, &h);
        return {w, h};
    }
    GLFWwindow* window_;
    Events events_;
    Cursor shown_ = Cursor::Arrow;
    GLFWcursor* cursors_[4] = {nullptr, glfwCreateStandardCursor(GLFW_IBEAM_CURSOR),
                               glfwCreateStandardCursor(GLFW_HRESIZE_CURSOR),
                               glfwCreateStandardCursor(GLFW_VRESIZE_CURSOR)};
};

Error noWindow(const std::string& what) {
    const char* detail = nullptr;
    glfwGetError(&detail);
    return noContext(what + (detail ? std::string(": ") + detail : ""),
                     "set DISPLAY, or use the verbs render and script, which need no window");
}

}  // namespace

Result<std::unique_ptr<Surface>> openWindow(int width, int height, const std::string& title) {
    if (!glfwInit()) return noWindow("no display to open a window on");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    GLFWwindow* window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
    if (!window) {
        const Error error = noWindow("no window with OpenGL 4.5");
        glfwTerminate();
        return error;
    }
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);
    return std::unique_ptr<Surface>(std::make_unique<Window>(window));
}

void installClipboard(Surface& surface) {
    Window* window = dynamic_cast<Window*>(&surface);
    if (!window) return;
    setClipboardFunctions(clipboard, setClipboard, window->handle());
}

}  // namespace sward::ui
