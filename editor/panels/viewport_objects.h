// Choosing in the viewport: a click or a box picks objects and icons; what is chosen stands in a box of lines.
// Does not: move what is chosen (panels/viewport_gizmo.h), nor hold the maths (tools/scene_objects.h, tools/handles.h).
#pragma once
#include <imgui.h>

#include <optional>
#include <string>
#include <vector>

#include "app/edits.h"
#include "app/layout.h"
#include "app/messages.h"
#include "app/selection.h"
#include "model/document.h"
#include "tools/camera_control.h"
#include "tools/object_tool.h"
#include "ui/input_queue.h"

namespace sward {

// What the select tool touches; all must outlive the call.
struct ObjectParts {
    Document& doc;
    Selection& selection;
    ObjectTool& tool;
    Edits& edits;
    Messages& messages;
    const FlyCamera& camera;
    const Rect& view;  // of the image, window coordinates
    double seconds;    // scene time that is shown
    bool active;       // it is the tool in the hand
    bool waits;        // for files of objects; else one is read a frame, and its objects are found after that
};

// What of the scene is under a place in the window: an object's triangles, unless ground or an icon lie before them;
// else the icon there; "": neither.
std::string entityAt(const ObjectParts& parts, double x, double y);
// The same with what is known of it; nothing: neither.
std::optional<ObjectHit> hitAt(const ObjectParts& parts, double x, double y);
// Objects and icons whose middle lies in the box on the screen, seen or not, in the order of their names.
std::vector<std::string> entitiesIn(const ObjectParts& parts, const ChoosingBox& box);

// --- in the hand: the left button with the select tool
// Where the button goes down.
void beginChoosing(const ObjectParts& parts, double x, double y);
// Where the pointer goes; from four pixels on a box is drawn.
void dragChoosing(const ObjectParts& parts, double x, double y);
// Where it goes up: the click or the box chooses, a click also which of a rule's or a forest's many it is, and says so.
// Ctrl toggles, Shift adds, a click on nothing lets all go.
void endChoosing(const ObjectParts& parts, const FrameInput& in);

// Boxes around what is chosen, icons, the box in the hand. Scripts find "Viewport/Icon NAME", and objects in sight as
// "Viewport/Object NAME": of all while the scene has 500 at most, else of those chosen.
void drawObjects(const ObjectParts& parts);

// The brackets of a box and, faint, its edges.
void drawBox(const ObjectParts& parts, const Corners& corners, ImU32 color);

// What the context menu is for: what is under the pointer is chosen, unless it is already.
void chooseForMenu(const ObjectParts& parts, double x, double y);

// Where the middle of what is chosen is, and how far it reaches from there, metres; nothing if none has a place.
struct Extent {
    glm::dvec3 middle{0};
    double radius = 0;
};
std::optional<Extent> extentOf(const ObjectParts& parts);

}  // namespace sward
