// Paths in the viewport: their curves and widths on the ground, and the path tool: clicks add and insert points, drags
// move them. Each click or drag is one undo step.
// Does not: hold what a click makes of a path (tools/path_tool.h).
#pragma once
#include "panels/viewport_objects.h"

namespace sward {

// Whether the left button draws paths.
bool drawsPaths(const ObjectParts& parts);
// The entity chosen last, if it has a GroundPath; else "".
std::string pathInHand(const ObjectParts& parts);

// --- once a frame, around the drawing of the image
// What the pointer is on; nothing unless `free`: over the image, with no gesture.
void hoverPath(const ObjectParts& parts, const FrameInput& in, bool free);
// The path chosen last, and, with the tool in the hand, all of them. Scripts find points as "Viewport/Point 0".
void drawPaths(const ObjectParts& parts);

// --- in the hand
// Where the button goes down: on a point takes it, on the curve inserts one, on another path chooses that; on the
// ground adds a point to the path chosen, or begins a new path. True if a point is in the hand then.
bool grabPath(const ObjectParts& parts, const FrameInput& in);
// To a place in the window; beyond the terrain the point stays. The first two pixels change nothing.
void dragPath(const ObjectParts& parts, double x, double y);
// Lets go; the undo step ends with the frame.
void releasePath(const ObjectParts& parts);
// The path is as it was before the button went down.
void cancelPath(const ObjectParts& parts);

// --- by keys
// Removes the chosen point. False: there is none, or it is not the tool.
bool removePathPoint(const ObjectParts& parts);
// A new path whose first point lies where the middle of the view meets the ground; it is chosen then.
void beginPath(const ObjectParts& parts);
// The tool is laid down; the path stays chosen.
void endPath(const ObjectParts& parts);

}  // namespace sward
