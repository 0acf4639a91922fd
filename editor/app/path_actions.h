// What menus do with a path on the ground: a way of the camera along it, a walk along it in play.
// Does not: draw it (panels/viewport_path.h).
#pragma once
#include <string>

#include "app/messages.h"
#include "app/play_control.h"
#include "app/selection.h"
#include "model/document.h"

namespace sward {

// The path that menus are for: that of the entity chosen last, else the first by name; "": there is none.
std::string pathMeant(const Document& document, const Selection& selection);
// Gives the path's entity a CameraPath along it at a walker's eye height and speed, as one undo step; what it had of
// the kind is replaced.
void cameraFromPath(Document& document, const Selection& selection, Messages& messages);
// The walker goes along the path: in the play under way, or in one that starts at the path's beginning.
void walkPath(const PlayParts& parts, const Selection& selection, const FlyCamera& view, ViewportHand& hand,
              const Edits& edits, bool typing);

}  // namespace sward
