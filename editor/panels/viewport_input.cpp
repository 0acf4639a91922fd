#include "panels/viewport_input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "panels/viewport_compare.h"
#include "panels/viewport_rings.h"
#include "playtest/playtest.h"
#include "tools/brush_target.h"
#include "world/ground.h"
#include "world/view_camera.h"

namespace sward {
namespace {

// Orbits and pans turn about what lies in the middle of the view.
void takePivot(EditorApp& app, std::optional<glm::dvec3> point) {
    Viewport& v = app.viewport;
    if (point) v.camera.distance = std::max(0.05, glm::dot(*point - v.camera.eye, forwardOf(v.camera)));
}

void beginPaint(EditorApp& app) {
    Viewport& v = app.viewport;
    const std::optional<glm::dvec3> at = groundAt(app, app.in.x, app.in.y);
    if (!at) return;
    const std::optional<ConstFieldRef> map = chosenMap(app);
    if (!map) return showError(app, failed("there is no map to paint on", "add a GrassField to an entity"));
    const glm::dvec3 origin = findGround(app.doc.project()).origin;
    const std::vector<BrushSettings> brushes = strokeBrushes(app, app.in.ctrl(), app.in.shift());
    if (brushes.empty()) return say(app, "there is no grass to erase");
    if (!accept(app, app.doc.beginStrokes(brushes, at->x - origin.x, at->z - origin.z, true))) return;
    v.gesture = Gesture::Paint;
}

void beginGesture(EditorApp& app) {
    Viewport& v = app.viewport;
    v.lastX = app.in.x, v.lastY = app.in.y;
    if (app.in.pressed[1]) {
        v.gesture = Gesture::Look;
    } else if (app.in.pressed[2]) {
        takePivot(app, groundAt(app, app.in.x, app.in.y));
        v.gesture = Gesture::Pan;
    } else if (app.in.pressed[0] && app.in.alt()) {
        takePivot(app, groundAt(app, static_cast<double>(v.rect.x + v.rect.w / 2),
                                static_cast<double>(v.rect.y + v.rect.h / 2)));
        v.gesture = Gesture::Orbit;
    } else if (app.in.pressed[0] && grabSplit(app)) {
        v.gesture = Gesture::Split;
    } else if (app.in.pressed[0] && grabRing(app)) {
        v.gesture = Gesture::Ring;
    } else if (app.in.pressed[0] && app.doc.isOpen() && app.brushes.tool != kLookTool && !app.doc.stroking()) {
        beginPaint(app);
    }
}

void stepGesture(EditorApp& app) {
    Viewport& v = app.viewport;
    const glm::dvec3 origin = v.gesture == Gesture::Paint ? findGround(app.doc.project()).origin : glm::dvec3(0);
    for (const auto& [x, y] : app.in.path) {
        const double dx = x - v.lastX, dy = y - v.lastY;
        v.lastX = x, v.lastY = y;
        if (v.gesture == Gesture::Look) look(v.camera, dx, dy);
        if (v.gesture == Gesture::Orbit) orbit(v.camera, dx, dy);
        if (v.gesture == Gesture::Pan) pan(v.camera, dx, dy, static_cast<double>(v.rect.h));
        if (v.gesture == Gesture::Ring) dragRing(app, x, y);
        if (v.gesture == Gesture::Split) dragSplit(app, x);
        if (v.gesture != Gesture::Paint) continue;
        if (const auto at = groundAt(app, x, y)) app.doc.strokeTo(at->x - origin.x, at->z - origin.z);
    }
}

bool buttonHeld(const EditorApp& app) {
    switch (app.viewport.gesture) {
        case Gesture::Look:
            return app.in.buttons[1];
        case Gesture::Pan:
            return app.in.buttons[2];
        default:
            return app.in.buttons[0];
    }
}

void flyByKeys(EditorApp& app) {
    Viewport& v = app.viewport;
    v.flying = false;
    if (v.gesture != Gesture::Look || app.in.ctrl()) return;
    const auto axis = [&](int more, int less) {
        return (app.in.keys[static_cast<size_t>(more)] ? 1.0 : 0.0) -
               (app.in.keys[static_cast<size_t>(less)] ? 1.0 : 0.0);
    };
    const glm::dvec3 direction{axis(GLFW_KEY_D, GLFW_KEY_A), axis(GLFW_KEY_E, GLFW_KEY_Q),
                               axis(GLFW_KEY_W, GLFW_KEY_S)};
    v.flying = glm::length(direction) > 0;
    fly(v.camera, direction, app.deltaSeconds * (app.in.shift() ? 3 : 1));
}

// The eye stays a hand's breadth above the ground.
void stayAbove(EditorApp& app) {
    constexpr double kLeast = 0.1;
    glm::dvec3& eye = app.viewport.camera.eye;
    if (!app.doc.isOpen()) return;
    const Ground ground = findGround(app.doc.project());
    if (!ground.terrain) return;
    const double x = eye.x - ground.origin.x, z = eye.z - ground.origin.z;
    if (x < 0 || z < 0 || x > ground.terrain->size.x || z > ground.terrain->size.y) return;
    eye.y = std::max(eye.y, ground.origin.y + terrainHeight(*ground.terrain, x, z) + kLeast);
}

void wheel(EditorApp& app) {
    Viewport& v = app.viewport;
    if (app.in.wheelY == 0) return;
    if (v.gesture == Gesture::Look) {
        changeSpeed(v.camera, app.in.wheelY);
        app.status = fmt::format("fly speed {:.3g} m/s", v.camera.speed);
    } else if (v.hovered) {
        dolly(v.camera, v.ground ? *v.ground : pivotOf(v.camera), app.in.wheelY);
    }
}

// Escape lets a ring go where it was.
void cancelByKey(EditorApp& app) {
    const std::vector<int>& keys = app.in.pressedKeys;
    if (app.viewport.gesture != Gesture::Ring || std::find(keys.begin(), keys.end(), GLFW_KEY_ESCAPE) == keys.end())
        return;
    cancelRing(app);
    app.viewport.gesture = Gesture::None;
}

// While it is played a click takes the mouse; nothing is flown or painted.
void playInput(EditorApp& app, bool over) {
    app.viewport.ground.reset();
    app.viewport.flying = false;
    if (over && app.in.pressed[0] && app.doc.play()->runs()) captureMouse(app, true);
}

double focalPixels(const Viewport& v) {
    return static_cast<double>(v.rect.h) / 2 / std::tan(glm::radians(static_cast<double>(v.camera.fovDeg)) / 2);
}

}  // namespace

std::optional<glm::dvec3> groundAt(const EditorApp& app, double x, double y) {
    const Viewport& v = app.viewport;
    if (!app.doc.isOpen() || v.rect.w < 1 || v.rect.h < 1) return std::nullopt;
    return pickGround(app.doc.project(), viewOf(v.camera), static_cast<int>(v.rect.w), static_cast<int>(v.rect.h),
                      x - static_cast<double>(v.rect.x), y - static_cast<double>(v.rect.y));
}

glm::dvec3 rayThrough(const Viewport& v, double x, double y) {
    const glm::dvec3 forward = forwardOf(v.camera), right{std::cos(v.camera.yaw), 0, std::sin(v.camera.yaw)};
    const double focal = focalPixels(v);
    return glm::normalize(forward + right * ((x - static_cast<double>(v.rect.x + v.rect.w / 2)) / focal) -
                          glm::cross(right, forward) * ((y - static_cast<double>(v.rect.y + v.rect.h / 2)) / focal));
}

std::optional<glm::dvec2> projectPoint(const Viewport& v, const glm::dvec3& p) {
    const glm::dvec3 forward = forwardOf(v.camera);
    const glm::dvec3 right{std::cos(v.camera.yaw), 0, std::sin(v.camera.yaw)};
    const glm::dvec3 up = glm::cross(right, forward), d = p - v.camera.eye;
    const double depth = glm::dot(d, forward);
    if (depth < 0.05) return std::nullopt;
    const double half = focalPixels(v);
    return glm::dvec2{static_cast<double>(v.rect.x + v.rect.w / 2) + glm::dot(d, right) / depth * half,
                      static_cast<double>(v.rect.y + v.rect.h / 2) - glm::dot(d, up) / depth * half};
}

void viewportInput(EditorApp& app, bool over) {
    Viewport& v = app.viewport;
    v.hovered = over;
    if (playing(app)) return playInput(app, over);
    cancelByKey(app);
    hoverSplit(app, over);
    hoverRing(app, over && !app.accuracy.comparison.gripHovered);
    if (v.gesture == Gesture::None && over && app.in.pressed.any())
        beginGesture(app);
    else if (v.gesture != Gesture::None)
        stepGesture(app);
    const glm::dvec3 before = v.camera.eye;
    flyByKeys(app);
    wheel(app);
    if (v.camera.eye != before || v.gesture == Gesture::Orbit || v.gesture == Gesture::Pan) stayAbove(app);
    if (v.gesture != Gesture::None && !buttonHeld(app)) {
        if (v.gesture == Gesture::Paint) app.doc.endStroke();
        if (v.gesture == Gesture::Ring) releaseRing(app);
        v.gesture = Gesture::None;
    }
    v.ground = over || v.gesture == Gesture::Paint ? groundAt(app, app.in.x, app.in.y) : std::nullopt;
}

}  // namespace sward
