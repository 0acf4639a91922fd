// How fine the viewport is drawn: in full when at rest; while something moves on a slow renderer, as fine as the time
// allows. The full picture of a slow renderer is drawn in parts, a few a frame, so that input never waits for it.
// Pure: it is told the time, what changed and what a drawing cost, and says what to draw next.
// Does not: draw, nor count what the rest of a frame costs.
#pragma once

namespace sward {

struct Resolution {
    double movingScale = 1;    // side of the drawn image over the viewport's, learnt from what drawings cost
    double drawnScale = 0;     // of the image on the screen; 0: none yet; below 1 until the last part of the full one is there
    bool stale = true;         // what is on the screen is not what would be drawn now
    double lastChange = -1e9;  // seconds
    double fullMs = 0;         // what a full drawing costs, as far as is known; 0: nothing is known
    int grid = 1;              // the full drawing is made in grid x grid parts ...
    int part = 0;              // ... of which this is next
    double partsMs = 0;        // what the parts so far have cost
};
struct ResolutionPlan {
    bool draw = false;
    double scale = 1;
    int msaa = 4;
    int grid = 1, part = 0;  // of the full drawing
};

inline constexpr double kMinScale = 0.25;     // of the side
inline constexpr double kSlowMs = 50;         // a drawing slower than this is coarsened while something moves
inline constexpr double kTargetMs = 45;       // what a drawing may cost then: 15 frames a second with the rest of a frame
inline constexpr double kRestSeconds = 0.25;  // without a change until the image is refined
inline constexpr int kMaxGrid = 8;            // parts along a side

// `changed`: camera, scene, size or decal differ from what was last drawn.
ResolutionPlan planDrawing(Resolution& r, double now, bool changed);
// What the drawing just made cost.
void learnDrawing(Resolution& r, const ResolutionPlan& plan, double ms);
// Seconds until a drawing will be wanted though nothing changes; negative: never.
double secondsToRefine(const Resolution& r, double now);

}  // namespace sward
