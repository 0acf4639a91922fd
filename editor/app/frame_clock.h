// When frames come, and how fine the next one is to be.
// Does not: measure time; the frame loop sets it.
#pragma once

namespace sward {

struct FrameClock {
    bool fixed = false;       // without a window: frames of a fixed length, and pictures that wait for all they show
    double now = 0;           // seconds since the start, as frames count them
    double delta = 1.0 / 60;  // seconds since the last frame, 0.001 to 0.25
    int wanted = 3;           // frames still to be built though nothing comes in: ImGui settles a few after any event
    bool refineNow = false;   // screenshots: draw in full though something moves
};

}  // namespace sward
