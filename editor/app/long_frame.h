// Scenes of which a picture with all blades would take a software renderer too long (cost/frame_estimate.h): noticed
// before it is tried, so that the window goes on; few of the blades are drawn until the person chooses.
// Does not: draw, nor hold the renderer back; app/resolution.h takes the share.
#pragma once
#include <cstdint>
#include <string>

#include "cost/frame_estimate.h"
#include "world/view_camera.h"

namespace sward {

struct LongFrame {
    double seconds = 0;     // that all blades of the view would take; 0: not too long
    FieldEstimate slowest;  // the field that takes most of it
    bool all = false;       // the person wants them all, until grass changes in kind or number
    // What this was found for.
    uint64_t grass = 0;  // techniques and densities
    uint64_t revision = ~uint64_t{0};
    ViewCamera camera;
    int width = 0, height = 0;
};
// What the picture is to be of.
struct LongView {
    const Project& project;
    const Tables& tables;
    uint64_t revision = 0;  // of the document
    const ViewCamera& camera;
    int width = 0, height = 0;  // pixels
};

// Looks anew where the technique or the density of a field changed, and `atRest` where anything did. Cost: that of
// estimateFrame then, if the project may be long at all.
void followLongFrame(LongFrame& f, const LongView& view, bool atRest);
// Share of the blades that pictures get, in (0, 1]: those of a second's drawing where all would take too long.
double shareOfBlades(const LongFrame& f);
// "All 295 million blades of turf (geometry) would take about 295 s a frame: 1 in 295 is drawn."
std::string longFrameNotice(const LongFrame& f);

}  // namespace sward
