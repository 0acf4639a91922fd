#include "panels/viewport_input.h"

#include <algorithm>
#include <cmath>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <fmt/format.h>

#include "panels/viewport_compare.h"
#include "panels/viewport_gizmo.h"
#include "panels/viewport_path.h"
#include "panels/viewport_place.h"
#include "tools/brush_target.h"
#include "world/ground.h"
#include "world/view_camera.h"

namespace sward {
namespace {

constexpr double kClick = 4;  // pixels until a click of the right button is a look around

// Orbits and pans turn about what lies in the middle of the view.
void takePivot(FlyCamera& camera, std::optional<glm::dvec3> point) {
    if (point) camera.distance = std::max(0.05, glm::dot(*point - camera.eye, forwardOf(camera)));
}

// The ground under the pointer, as a stroke that is under way sees it: as it was when the stroke began. Ground that
// rises towards the eye would draw the stroke after it, the farther the slower the machine. The height is that of now.
std::optional<glm::dvec3> paintedAt(const Document& doc, const FlyCamera& camera, const ViewportHand& hand, double x,
                                    double y) {
    const Rect& view = hand.rect;
    const Ground ground = doc.ground();
    if (!doc.stroking() || !hand.groundBefore || !ground.terrain) return groundAt(doc, camera, view, x, y);
    std::optional<glm::dvec3> at =
        pickGround(Ground{&*hand.groundBefore, ground.origin}, viewOf(camera), static_cast<int>(view.w),
                   static_cast<int>(view.h), x - static_cast<double>(view.x), y - static_cast<double>(view.y));
    if (at) at->y = ground.origin.y + terrainHeight(*ground.terrain, at->x - ground.origin.x, at->z - ground.origin.z);
    return at;
}

void beginPaint(const PaintParts& p, const FlyCamera& camera, ViewportHand& hand, const FrameInput& in) {
    const std::optional<glm::dvec3> at = groundAt(p.doc, camera, hand.rect, in.x, in.y);
    if (!at) return;
    const std::optional<ConstFieldRef> map = chosenMap(p.doc, p.brushes);
    if (!map) return showError(p.messages, failed("there is no map to paint on", "add a GrassField to an entity"));
    const Ground ground = p.doc.ground();
    const glm::dvec3 origin = ground.origin;
    const bool line = in.alt() && in.shift();  // straight on from where the last stroke ended
    if (line && !hand.strokeEnd) return say(p.messages, "a straight line goes on from a stroke: paint one first");
    const glm::dvec3 from = line ? *hand.strokeEnd : *at;
    const std::vector<BrushSettings> brushes = strokeBrushes(p.doc, p.brushes, in.ctrl(), in.shift() && !line);
    if (brushes.empty()) return say(p.messages, "there is no grass to erase");
    hand.groundBefore = *ground.terrain;
    if (!accept(p.messages, p.doc.beginStrokes(brushes, from.x - origin.x, from.z - origin.z, true))) return;
    if (line) p.doc.strokeTo(at->x - origin.x, at->z - origin.z);
    hand.gesture = Gesture::Paint;
    hand.strokeBegin = from, hand.strokeEnd = *at;
}

// A gesture that turns or moves the view; false if the buttons mean none.
bool beginMove(const Document& doc, FlyCamera& camera, ViewportHand& hand, const FrameInput& in) {
    const Rect& r = hand.rect;
    if (in.pressed[1]) {
        hand.gesture = Gesture::Look;
    } else if (in.pressed[2]) {
        takePivot(camera, groundAt(doc, camera, r, in.x, in.y));
        hand.gesture = Gesture::Pan;
    } else if (in.pressed[0] && in.alt() && !in.shift()) {
        takePivot(camera,
                  groundAt(doc, camera, r, static_cast<double>(r.x + r.w / 2), static_cast<double>(r.y + r.h / 2)));
        hand.gesture = Gesture::Orbit;
    }
    return hand.gesture != Gesture::None;
}

void beginGesture(const HandParts& parts, FlyCamera& camera, ViewportHand& hand, const FrameInput& in) {
    const PaintParts& p = parts.paint;
    hand.lastX = in.x, hand.lastY = in.y, hand.way = 0;
    if (beginMove(p.doc, camera, hand, in) || !in.pressed[0]) return;
    if (grabSplit(parts.comparison, in)) {
        hand.gesture = Gesture::Split;
    } else if (grabRing(parts.rings, in, p.edits)) {
        hand.gesture = Gesture::Ring;
    } else if (grabGizmo(parts.objects, in)) {
        hand.gesture = Gesture::Gizmo;
    } else if (drawsPaths(parts.objects)) {
        if (grabPath(parts.objects, in)) hand.gesture = Gesture::Path;
    } else if (parts.objects.active && !parts.objects.tool.placing.empty()) {
        if (!placeObject(parts.objects, in.x, in.y)) say(p.messages, "there is no ground to place it on");
    } else if (parts.objects.active) {
        beginChoosing(parts.objects, in.x, in.y);
        hand.gesture = Gesture::Choose;
    } else if (p.doc.isOpen() && p.brushes.tool != kViewTool && !p.doc.stroking()) {
        beginPaint(p, camera, hand, in);
    }
}

void stepGesture(const HandParts& parts, FlyCamera& camera, ViewportHand& hand, const FrameInput& in) {
    const PaintParts& p = parts.paint;
    const glm::dvec3 origin = hand.gesture == Gesture::Paint ? p.doc.ground().origin : glm::dvec3(0);
    for (const auto& [x, y] : in.path) {
        const double dx = x - hand.lastX, dy = y - hand.lastY;
        hand.lastX = x, hand.lastY = y;
        hand.way += std::hypot(dx, dy);
        if (hand.gesture == Gesture::Look) look(camera, dx, dy);
        if (hand.gesture == Gesture::Orbit) orbit(camera, dx, dy);
        if (hand.gesture == Gesture::Pan) pan(camera, dx, dy, static_cast<double>(hand.rect.h));
        if (hand.gesture == Gesture::Ring) dragRing(parts.rings, p.messages, x, y);
        if (hand.gesture == Gesture::Split) dragSplit(parts.comparison, hand.rect, x);
        if (hand.gesture == Gesture::Choose) dragChoosing(parts.objects, x, y);
        if (hand.gesture == Gesture::Gizmo) dragGizmo(parts.objects, x, y, in.ctrl());
        if (hand.gesture == Gesture::Path) dragPath(parts.objects, x, y);
        if (hand.gesture != Gesture::Paint) continue;
        if (const auto at = paintedAt(p.doc, camera, hand, x, y)) {
            p.doc.strokeTo(at->x - origin.x, at->z - origin.z);
            hand.strokeEnd = *at;
        }
    }
}

bool buttonHeld(Gesture gesture, const FrameInput& in) {
    switch (gesture) {
        case Gesture::Look:
            return in.buttons[1];
        case Gesture::Pan:
            return in.buttons[2];
        default:
            return in.buttons[0];
    }
}

void endGesture(ViewportHand& hand, const HandParts& parts, const FrameInput& in) {
    if (hand.gesture == Gesture::Paint) parts.paint.doc.endStroke();
    if (hand.gesture == Gesture::Ring) releaseRing(parts.rings.tiers);
    if (hand.gesture == Gesture::Choose) endChoosing(parts.objects, in);
    if (hand.gesture == Gesture::Gizmo) releaseGizmo(parts.objects);
    if (hand.gesture == Gesture::Path) releasePath(parts.objects);
    if (hand.gesture == Gesture::Look && hand.way < kClick && parts.objects.active)
        chooseForMenu(parts.objects, in.x, in.y);
    hand.gesture = Gesture::None;
}

void flyByKeys(FlyCamera& camera, ViewportHand& hand, const FrameInput& in, double seconds) {
    hand.flying = false;
    if (hand.gesture != Gesture::Look || in.ctrl()) return;
    const auto axis = [&](int more, int less) {
        return (in.keys[static_cast<size_t>(more)] ? 1.0 : 0.0) - (in.keys[static_cast<size_t>(less)] ? 1.0 : 0.0);
    };
    const glm::dvec3 direction{axis(GLFW_KEY_D, GLFW_KEY_A), axis(GLFW_KEY_E, GLFW_KEY_Q),
                               axis(GLFW_KEY_W, GLFW_KEY_S)};
    hand.flying = glm::length(direction) > 0;
    if (hand.flying) hand.way += kClick;  // that was no click
    fly(camera, direction, seconds * (in.shift() ? 3 : 1));
}

// The eye stays a hand's breadth above the ground.
void stayAbove(const Document& doc, glm::dvec3& eye) {
    constexpr double kLeast = 0.1;
    if (!doc.isOpen()) return;
    const Ground ground = doc.ground();
    if (!ground.terrain) return;
    const double x = eye.x - ground.origin.x, z = eye.z - ground.origin.z;
    if (x < 0 || z < 0 || x > ground.terrain->size.x || z > ground.terrain->size.y) return;
    eye.y = std::max(eye.y, ground.origin.y + terrainHeight(*ground.terrain, x, z) + kLeast);
}

void wheel(FlyCamera& camera, const ViewportHand& hand, double notches, Messages& messages) {
    if (notches == 0) return;
    if (hand.gesture == Gesture::Look) {
        changeSpeed(camera, notches);
        messages.status = fmt::format("fly speed {:.3g} m/s", camera.speed);
    } else if (hand.hovered) {
        dolly(camera, hand.ground ? *hand.ground : pivotOf(camera), notches);
    }
}

// Escape lets a ring, a handle or a path's point go where it was, and chooses nothing.
void cancelByKey(ViewportHand& hand, const FrameInput& in, const HandParts& parts) {
    const std::vector<int>& keys = in.pressedKeys;
    if (std::find(keys.begin(), keys.end(), GLFW_KEY_ESCAPE) == keys.end()) return;
    const PaintParts& p = parts.paint;
    if (hand.gesture == Gesture::Ring) cancelRing(parts.rings.tiers, p.doc, p.edits, p.messages);
    if (hand.gesture == Gesture::Gizmo) cancelGizmo(parts.objects);
    if (hand.gesture == Gesture::Path) cancelPath(parts.objects);
    if (hand.gesture == Gesture::Choose) parts.objects.tool.box.reset();
    if (hand.gesture == Gesture::Ring || hand.gesture == Gesture::Gizmo || hand.gesture == Gesture::Path ||
        hand.gesture == Gesture::Choose)
        hand.gesture = Gesture::None;
    else
        parts.objects.tool.placing.clear();
}

double focalPixels(const FlyCamera& camera, const Rect& view) {
    return static_cast<double>(view.h) / 2 / std::tan(glm::radians(static_cast<double>(camera.fovDeg)) / 2);
}

}  // namespace

std::optional<glm::dvec3> groundAt(const Document& document, const FlyCamera& camera, const Rect& view, double x,
                                   double y) {
    if (!document.isOpen() || view.w < 1 || view.h < 1) return std::nullopt;
    return pickGround(document.standing(), viewOf(camera), static_cast<int>(view.w), static_cast<int>(view.h),
                      x - static_cast<double>(view.x), y - static_cast<double>(view.y));
}

glm::dvec3 rayThrough(const FlyCamera& camera, const Rect& view, double x, double y) {
    const glm::dvec3 forward = forwardOf(camera), right{std::cos(camera.yaw), 0, std::sin(camera.yaw)};
    const double focal = focalPixels(camera, view);
    return glm::normalize(forward + right * ((x - static_cast<double>(view.x + view.w / 2)) / focal) -
                          glm::cross(right, forward) * ((y - static_cast<double>(view.y + view.h / 2)) / focal));
}

std::optional<glm::dvec2> projectPoint(const FlyCamera& camera, const Rect& view, const glm::dvec3& p) {
    const glm::dvec3 forward = forwardOf(camera);
    const glm::dvec3 right{std::cos(camera.yaw), 0, std::sin(camera.yaw)};
    const glm::dvec3 up = glm::cross(right, forward), d = p - camera.eye;
    const double depth = glm::dot(d, forward);
    if (depth < 0.05) return std::nullopt;
    const double half = focalPixels(camera, view);
    return glm::dvec2{static_cast<double>(view.x + view.w / 2) + glm::dot(d, right) / depth * half,
                      static_cast<double>(view.y + view.h / 2) - glm::dot(d, up) / depth * half};
}

bool playInput(const HandInput& input, ViewportHand& hand) {
    hand.hovered = input.over;
    hand.ground.reset();
    hand.flying = false;
    return input.over && input.in.pressed[0];
}

void viewportInput(const HandInput& input, FlyCamera& camera, ViewportHand& hand, const HandParts& parts) {
    const FrameInput& in = input.in;
    const PaintParts& paint = parts.paint;
    hand.hovered = input.over;
    cancelByKey(hand, in, parts);
    hoverSplit(parts.comparison, hand, in, input.over);
    const bool free = input.over && !parts.comparison.gripHovered && hand.gesture == Gesture::None;
    hoverRing(parts.rings, in, free && !in.ctrl() && !in.shift() && !in.alt());
    hoverGizmo(parts.objects, in, free && !parts.rings.tiers.hover && !in.alt());
    hoverPath(parts.objects, in, free && !parts.rings.tiers.hover && !in.alt());
    if (hand.gesture == Gesture::None && input.over && in.pressed.any())
        beginGesture(parts, camera, hand, in);
    else if (hand.gesture != Gesture::None)
        stepGesture(parts, camera, hand, in);
    const glm::dvec3 before = camera.eye;
    flyByKeys(camera, hand, in, input.seconds);
    wheel(camera, hand, in.wheelY, paint.messages);
    if (camera.eye != before || hand.gesture == Gesture::Orbit || hand.gesture == Gesture::Pan)
        stayAbove(paint.doc, camera.eye);
    if (hand.gesture != Gesture::None && !buttonHeld(hand.gesture, in)) endGesture(hand, parts, in);
    hand.ground =
        input.over || hand.gesture == Gesture::Paint ? paintedAt(paint.doc, camera, hand, in.x, in.y) : std::nullopt;
}

}  // namespace sward
