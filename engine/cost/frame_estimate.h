// What a frame of a view will take, from counts, before any work for it begins; and what to change where that is too
// long. Counted are blades that are drawn one by one: millions of them are what makes a frame long.
// Does not: draw, nor measure. A software rasteriser takes about a millionth of a second for a blade, whether it draws
// strips or tessellates (football at 320 x 240, two cores at 2.1 GHz: 1.2 and 1.0); near ones, which are larger and
// throw shadows, take several. Cost: that of submittedBlades, 10 to 40 ms for football, and as much for each technique
// that is tried.
#pragma once
#include <string>
#include <vector>

#include "cost/frame_stats.h"

namespace sward {

inline constexpr double kSecondsABlade = 1e-6;  // of a software rasteriser
inline constexpr double kLongFrame = 10;        // seconds from which on a frame is called long

// Whether a frame of any view may be long: by the population, which costs no look at cells.
bool mayBeLong(const Project& project);

struct FieldEstimate {
    std::string entity, technique;
    uint64_t blades = 0;
    double seconds = 0;
};
struct FrameEstimate {
    double seconds = 0;
    std::vector<FieldEstimate> fields;  // slowest first
};
// Seconds that a software rasteriser takes for a frame from `camera`, and for which fields: from the blades of the
// cells that are drawn one by one, at kSecondsABlade. Pixels of the view: width x height.
FrameEstimate estimateFrame(const Project& project, const Tables& tables, const ViewCamera& camera, int width,
                            int height);

// A technique by which the view takes least among those that still draw blades one by one, if that is not long; else
// one that draws none. Empty: there is no better one.
std::string quickerTechnique(const Project& project, const Tables& tables, const ViewCamera& camera, int width,
                             int height, const FieldEstimate& slow);

// "human: about 295 s a frame: turf draws 295 million blades one by one (geometry); hybrid is quicker:
// turf.GrassField.technique=hybrid". Empty where no frame is long. `camera`: what the text begins with.
std::string longFrameText(const Project& project, const Tables& tables, const ViewCamera& view, int width, int height,
                          const std::string& camera);

}  // namespace sward
