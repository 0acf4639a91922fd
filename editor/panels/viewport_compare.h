// What a comparison lays over the viewport's picture: the other picture or the map of errors right of a line, and the
// line's grip. Does not: make what it shows (accuracy/accuracy.h).
#pragma once
#include <string>

#include "accuracy/accuracy.h"
#include "app/viewport.h"
#include "ui/input_queue.h"

namespace sward {

// What stands beside the line.
struct SideNames {
    std::string own, other;
    float top = 6;  // below the picture's upper edge, pixels
};

// Within the viewport's clip rectangle, after its image. Nothing while the comparison is off.
void drawComparison(const Comparison& c, const ViewportHand& hand, const SideNames& names);
// --- the grip in the line's middle; the rest of the line takes no clicks, so that painting goes on beneath it
// `over`: the pointer is over the image. A grip in the hand is let go once there is no line.
void hoverSplit(Comparison& c, ViewportHand& hand, const FrameInput& in, bool over);
// True if the pointer is on it and no modifier says otherwise.
bool grabSplit(const Comparison& c, const FrameInput& in);
// To a place in the window; stops at the picture's edges.
void dragSplit(Comparison& c, const Rect& view, double x);
// After the comparison may have ended: a grip in the hand goes with its line.
void releaseSplit(const Comparison& c, ViewportHand& hand);

}  // namespace sward
