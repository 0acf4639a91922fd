// What stands around and over the viewport's image: its header, the brush's ring, the red bar of the last error.
// Does not: draw the scene (panels/viewport_scene.h) or take input (panels/viewport_input.h). All within the viewport's
// window.
#pragma once
#include "app/viewport.h"
#include "model/document.h"
#include "tools/brush_book.h"

namespace sward {

// The camera and what is shown, in the first line of the viewport's area; a camera that is chosen moves the view.
void drawViewportHeader(const Document& document, ViewState& view, Gesture gesture);
// Room for the image in what the header leaves of `area`, as one item; its rectangle in window coordinates.
Rect layImage(const Rect& area);
// The brush's edge on the ground, and where its full strength ends. Where the scene is slow to draw it stands in for
// the decal: drawn over the image, it follows the pointer at the speed of the interface. Nothing where nothing is
// painted.
void drawBrushRing(const Document& document, const FlyCamera& camera, const ViewportHand& hand, BrushBook& brushes);
// What is wrong, over the picture's upper edge, until the person dismisses it; nothing if `notice` is empty.
void drawErrorBar(std::string& notice, const Rect& view);

}  // namespace sward
