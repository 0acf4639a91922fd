// The viewport's picture: when it is drawn anew, how fine, and in how many parts.
// Does not: take input, nor put it on the screen.
#pragma once
#include <optional>

#include "app/frame_clock.h"
#include "app/messages.h"
#include "app/viewport.h"
#include "model/document.h"
#include "tools/brush_book.h"

namespace sward {

// What drawing the scene reads and writes; all must outlive the call.
struct SceneParts {
    Document& doc;
    Renderer& renderer;
    ViewportPicture& picture;
    ViewCounts& counts;
    const FrameClock& clock;
    Messages& messages;
};

// Draws what is due of what is `wanted` (its size in pixels: nothing below 1 x 1); `inputWaits`: what came in since
// waits for the frame, and goes first. Afterwards picture.texture holds the image to show, if picture.hasImage. What
// keeps the scene from being drawn is shown until it is mended.
void drawScene(const SceneParts& parts, const ViewCamera& camera, const ViewSettings& wanted, bool inputWaits);
// True if the renderer is quick enough to draw the brush's decal anew with every motion of the pointer.
bool drawsDecal(const ViewportPicture& picture, const FrameClock& clock);
// The brush on the ground under the pointer; none where it paints nothing.
BrushDecal decalOf(const Document& document, const ViewportHand& hand, BrushBook& brushes);
// Gives the GL objects back; the next drawing makes new ones.
void freePicture(ViewportPicture& picture);

}  // namespace sward
