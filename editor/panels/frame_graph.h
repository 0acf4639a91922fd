// The graph of the editor's last frames: a bar each, its lower part the panels, and the budget as a line that the mouse
// drags. Does not: measure (app/frame_times.h).
#pragma once
#include "app/frame_times.h"

namespace sward {

// In the present window, as wide as it; `height` in points. A line of numbers stands above it.
void drawFrameGraph(FrameTimes& times, float height);

}  // namespace sward
