// What the select tool keeps between frames: its mode and sizes, the gizmo in the hand, the box that is drawn.
// Does not: choose (app/selection.h) or move anything (panels/viewport_gizmo.h).
#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tools/gizmo.h"
#include "tools/path_tool.h"
#include "tools/scene_objects.h"

namespace sward {

struct GizmoDrag {
    GizmoGrab grab;
    std::vector<EntityStart> starts;
    bool overGround = false;  // the middle follows the ground under the pointer ...
    glm::dvec2 offset{0};     // ... this far from it, pixels
    bool moved = false;       // a click is no drag
};
// From where the button went down to where the pointer is, window coordinates.
struct ChoosingBox {
    glm::dvec2 from{0}, to{0};
};

struct ObjectTool {
    GizmoMode mode = GizmoMode::Move;
    GizmoSteps steps;
    bool alongGround = false;  // what does not stand on the ground follows it, too
    SceneObjects objects;
    std::vector<ScreenPart> shown;     // the gizmo as last drawn ...
    glm::dvec3 pivot{0};               // ... and where
    const GizmoPart* hover = nullptr;  // what the pointer is on
    std::optional<GizmoDrag> drag;
    std::optional<ChoosingBox> box;
    // Of the many that a rule or a forest puts there, the one that was clicked, while its entity is chosen.
    std::optional<ObjectHit> one;
    uint64_t oneRevision = 0;  // of the document then; at another it may stand elsewhere
    std::string placing;       // file of the object that clicks place; empty: they choose
    bool randomTurn = false;   // what is placed is turned by an angle of its own
    bool menu = false;         // the context menu is to be opened
    PathTool path;
};

}  // namespace sward
