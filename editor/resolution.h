// How fine the viewport is drawn: full when at rest; while something moves on a slow renderer, as fine as the time allows.
// Pure: it is told the time, what changed and what a drawing cost, and says what to draw next.
// Does not: draw, nor count what the rest of a frame costs.
#pragma once

namespace sward {

struct Resolution {
    double movingScale = 1;    // side of the drawn image over the viewport's, learnt from what drawings cost
    double drawnScale = 0;     // of the image on the screen; 0: none yet
    bool stale = true;         // what is on the screen is not what would be drawn now
    double lastChange = -1e9;  // seconds
};
struct ResolutionPlan {
    bool draw = false;
    double scale = 1;
    int msaa = 4;
};

inline constexpr double kMinScale = 0.25;      // of the side
inline constexpr double kSlowMs = 50;          // a drawing slower than this is coarsened while something moves
inline constexpr double kTargetMs = 45;        // what a drawing may cost then: 15 frames a second with the rest of a frame
inline constexpr double kRestSeconds = 0.25;   // without a change until the image is refined

// `changed`: camera, scene, size or decal differ from what was last drawn.
ResolutionPlan planDrawing(Resolution& r, double now, bool changed);
// What the drawing just made at `scale` cost.
void learnDrawing(Resolution& r, double scale, double ms);
// Seconds until a drawing will be wanted though nothing changes; negative: never.
double secondsToRefine(const Resolution& r, double now);

}  // namespace sward
