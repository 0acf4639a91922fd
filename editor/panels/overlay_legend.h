// What the colours of the map overlay mean, in the viewport's upper right corner, where there is sky.
// Does not: draw the overlay; engine/post/map_overlay.h does.
#pragma once
#include "app/layout.h"
#include "model/document.h"
#include "tools/brush_book.h"

namespace sward {

// In the upper right corner of `view`, for a camera that looks towards `yaw`. Nothing while the overlay is off.
void drawOverlayLegend(const Document& document, BrushBook& brushes, double yaw, const Rect& view);

}  // namespace sward
