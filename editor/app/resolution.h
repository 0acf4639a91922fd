// How fine the viewport is drawn: in full when at rest; while something moves on a slow renderer, as fine as the time
// allows: first a smaller image, then fewer and wider blades. The full picture of a slow renderer is drawn in strips
// from the top down, a few a frame, so that input never waits for it. Pure: it is told the time, what changed and what
// a drawing cost, and says what to draw next. Does not: draw, nor count what the rest of a frame costs.
#pragma once

namespace sward {

struct Resolution {
    double movingScale = 1;   // side of the drawn image over the viewport's, learnt from what drawings cost
    double movingDetail = 1;  // share of the blades drawn then
    double drawnScale =
        0;  // of the image on the screen; 0: none yet; below 1 until the last strip of the full one is there
    bool stale = true;         // what is on the screen is not what would be drawn now
    double lastChange = -1e9;  // seconds
    double fullMs = 0;         // what a full drawing costs, as far as is known; 0: nothing is known
    double done = 0;           // share of the full picture's height that is there
    double strip = 1;          // height of its next strip, as a share
    double stripsMs = 0;       // what its strips so far have cost
};
struct ResolutionPlan {
    bool draw = false;
    double scale = 1;
    int msaa = 4;
    double detail = 1;
    double from = 0, to = 1;  // strip of the full picture, as shares of its height from the top

    // The picture in one piece: no strip of it.
    bool whole() const { return from <= 0 && to >= 1; }
};

inline constexpr double kMinScale = 0.25;       // of the side
inline constexpr double kMinDetail = 1.0 / 16;  // of the blades
inline constexpr double kSlowMs = 50;           // a drawing slower than this is coarsened while something moves
inline constexpr double kTargetMs = 45;  // what a drawing may cost then: 15 frames a second with the rest of a frame
inline constexpr double kStripMs = 120;  // what a strip should cost
inline constexpr double kMinStrip = 1.0 / 24;  // of the height
inline constexpr double kRestSeconds = 0.25;   // without a change until the image is refined

// `changed`: camera, scene, size or decal differ from what was last drawn.
ResolutionPlan planDrawing(Resolution& r, double now, bool changed);
// What the drawing just made cost.
void learnDrawing(Resolution& r, const ResolutionPlan& plan, double ms);
// Seconds until a drawing will be wanted though nothing changes; negative: never.
double secondsToRefine(const Resolution& r, double now);

}  // namespace sward
