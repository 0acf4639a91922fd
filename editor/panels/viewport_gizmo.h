// The gizmo in the viewport: drawn at the entity chosen last, and dragged with the mouse. One drag is one undo step.
// Does not: hold the maths (tools/gizmo.h, tools/motion.h).
#pragma once
#include "panels/viewport_objects.h"

namespace sward {

// --- once a frame, around the drawing of the image
// What the pointer is on, of the gizmo as last drawn; nothing unless `free`: over the image, with no gesture.
void hoverGizmo(const ObjectParts& parts, const FrameInput& in, bool free);
// Scripts find each handle as "Viewport/Gizmo move x"; its value is the place along that axis, metres.
void drawGizmo(const ObjectParts& parts);

// --- in the hand
// True if the pointer is on a handle.
bool grabGizmo(const ObjectParts& parts, const FrameInput& in);
// To a place in the window; Ctrl snaps. The first two pixels change nothing.
void dragGizmo(const ObjectParts& parts, double x, double y, bool snap);
// Lets go; the undo step ends with the frame.
void releaseGizmo(const ObjectParts& parts);
// Everything is where it was.
void cancelGizmo(const ObjectParts& parts);

}  // namespace sward
