// What the colours of the map overlay mean, in the viewport's upper right corner, where there is sky.
// Does not: draw the overlay; engine/post/map_overlay.h does.
#pragma once
#include "app/app.h"

namespace sward {

// What the ends of a scale of amounts mean on this map.
struct AmountEnds {
    const char *least, *most;
};
AmountEnds amountEnds(const FieldRow& map);
void drawOverlayLegend(EditorApp& app);

}  // namespace sward
