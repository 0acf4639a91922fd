// The handles that move, turn and scale what is chosen: where they are on the screen, which the pointer is on, and what
// a drag of one means. Pure. Axes are the world's: x east, y up, z south.
// A drag never runs away: where a ray and an axis or plane are within two degrees of each other, or would meet behind
// the eye or fifty times as far as the pivot, nothing moves; a ring turns by the way along its tangent on the screen.
// Does not: draw, or change anything (panels/viewport_gizmo.h); what a motion does to fields: tools/motion.h.
#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tools/handles.h"
#include "tools/motion.h"

namespace sward {

// What the left button does beside choosing; Path: instead (tools/path_tool.h).
enum class GizmoMode { Select, Move, Turn, Scale, Path };
enum class GizmoShape { Axis, Plane, Free, Ring, Size };
struct GizmoPart {
    const char* name;  // "move x": also of its widget
    GizmoMode mode;
    GizmoShape shape;
    glm::dvec3 axis;  // an axis' way; a plane's or ring's normal; else 0
};
// All handles.
std::span<const GizmoPart> gizmoParts();
// Whether a handle does anything to one of these: water only rises and sinks, only objects have a size, lamps turn only
// about others.
bool partFits(const GizmoPart& part, std::span<const HandleKind> chosen);

// --- on the screen
// How the scene is seen; lengths on the screen in pixels, from its top left.
struct GizmoView {
    glm::dvec3 eye{0}, forward{0, 0, -1};
    double metresPerPixel = 0.01;  // at the pivot, so that handles are of one size wherever it stands
    std::function<std::optional<glm::dvec2>(const glm::dvec3&)> project;
};
struct ScreenPart {
    const GizmoPart* part = nullptr;
    std::vector<glm::dvec2> line;  // a plane's corners; of a ring, the half that faces the eye
    glm::dvec2 grip{0};            // a place on it
};
// Handles that fit and can be seen from where they could be dragged: no axis that points at the eye, no plane seen from
// its edge.
std::vector<ScreenPart> screenParts(GizmoMode mode, std::span<const HandleKind> chosen, const glm::dvec3& pivot,
                                    const GizmoView& view);
// The one that the pointer is on: the middle first, then planes, then the nearest line within eight pixels.
const ScreenPart* partAt(std::span<const ScreenPart> parts, const glm::dvec2& pointer);

// --- in the hand
struct GizmoRay {
    glm::dvec3 from{0}, way{0, 0, -1};  // unit
};
// Metres along an axis through the pivot of its point nearest to the ray; nothing where a drag would run away.
std::optional<double> alongAxis(const glm::dvec3& pivot, const glm::dvec3& axis, const GizmoRay& ray);
// Where the ray meets a plane through the pivot; likewise.
std::optional<glm::dvec3> onPlane(const glm::dvec3& pivot, const glm::dvec3& normal, const GizmoRay& ray);

// Sizes to which a drag snaps while Ctrl is held.
struct GizmoSteps {
    float grid = 0.5f;    // metres, of places in the world
    float angleDeg = 15;  // of a turn
    float scale = 0.1f;   // of a factor
};
// A handle in the hand: what stays as it was when it was taken.
struct GizmoGrab {
    const GizmoPart* part = nullptr;
    glm::dvec3 pivot{0};
    glm::dvec2 centre{0}, pointer{0};  // of the pivot and of the hand, on the screen
    GizmoRay ray;                      // through the hand
    glm::dvec3 forward{0, 0, -1};      // of the eye
    glm::dvec2 tangent{1, 0};          // of a ring: pixels a radian on the screen
};
GizmoGrab grabPart(const ScreenPart& part, const glm::dvec3& pivot, const GizmoView& view, const glm::dvec2& pointer,
                   const GizmoRay& ray);
// What has been done since, with the hand at `pointer` and `ray` through it; nothing where a drag would run away: what
// was done last stays. `steps`: null, or to which it snaps.
std::optional<Motion> motionOf(const GizmoGrab& grab, const glm::dvec2& pointer, const GizmoRay& ray,
                               const GizmoSteps* steps);
// To the next multiple; a step of 0 or less changes nothing.
double snapped(double value, double step);

}  // namespace sward
