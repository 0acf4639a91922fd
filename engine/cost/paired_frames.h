// What one state of a scene costs more than another: frames of both in turn, so that a change of the machine's load
// meets both, and the median of the differences of pairs with an interval that supposes nothing of how times scatter:
// two of the ordered differences (Conover, Practical Nonparametric Statistics, 1999, section 3.2: a confidence
// interval for a quantile). One frame a call, so that whoever measures may stop or wait between any two.
// Does not: know what the two states are.
#pragma once
#include <array>
#include <span>
#include <string>
#include <vector>

#include "core/error.h"
#include "frame/renderer.h"

namespace sward {

struct PairedDifference {
    double median = 0, low = 0, high = 0;
    double confidence = 0;  // how sure it is that the true median lies in [low, high]; 0 of fewer than two pairs
    int pairs = 0;
};
// Of a[i] - b[i], as many as both have. The interval is the narrowest of at least 95%, else the widest there is: of 7
// pairs it runs from the least to the greatest, 98%.
PairedDifference pairedDifference(std::span<const double> a, std::span<const double> b);
// Of milliseconds: "0.80 ms (0.60 to 1.1)". `sign`: "+" before a median above 0.
std::string differenceText(const PairedDifference& ms, bool sign = false);

struct FrameSide {
    Renderer& renderer;
    const Project& project;
};
struct PairedFrames {
    int pairs = 7;
    bool settles = false;  // a frame that is not counted comes before each: both sides share a renderer, and what
                           // differs is uploaded in it
    int drawn = 0;         // frames so far
    std::array<std::vector<double>, 2> ms = {},
                                       blades = {};  // of each side: the timed frames, and the blades that they drew
};
// Frames that all pairs take.
int framesOf(const PairedFrames& frames);
bool allDrawn(const PairedFrames& frames);
// Draws the next frame, waits for it, and keeps what it took if it counts. Pairs begin with either side in turn.
// Fails as Renderer::draw.
Status drawNext(PairedFrames& frames, const std::array<FrameSide, 2>& sides, const ViewCamera& camera,
                const ViewSettings& settings);
// Something else was drawn since the last frame: the one that is not counted comes again.
void interrupt(PairedFrames& frames);
// The first side's less the second's.
PairedDifference msBetween(const PairedFrames& frames);
PairedDifference bladesBetween(const PairedFrames& frames);

}  // namespace sward
