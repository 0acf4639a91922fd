// What painting shows over the picture beside the brush's ring: the shape of the brush, laid over the ground, and the
// lines about which strokes are mirrored, with the ring's images.
// Does not: paint.
#pragma once
#include "app/layout.h"
#include "app/viewport.h"
#include "model/document.h"
#include "model/map_import.h"
#include "tools/brush_book.h"

namespace sward {

// The shape under the pointer as a veil, the lighter the heavier a stamp weighs there; nothing for round brushes.
void drawBrushShape(const Document& document, const FlyCamera& camera, const ViewportHand& hand, BrushBook& brushes);
// The lines over the terrain's middle while a brush is in the hand and mirrors, and a cross where the images are.
void drawMirror(const Document& document, const FlyCamera& camera, const ViewportHand& hand, const BrushBook& brushes);
// The ground as a picture of heights would leave it: a grid of lines, and the rectangle's border.
void drawPlacedHeights(const Document& document, const FlyCamera& camera, const Rect& view, const Map& source,
                       const HeightPlace& place);

}  // namespace sward
