// What the colours of the map overlay mean, in the viewport's upper right corner, where there is sky.
// Does not: draw the overlay; engine/post/map_overlay.h does.
#pragma once
#include "app/app.h"

namespace sward {

void drawOverlayLegend(EditorApp& app);

}  // namespace sward
