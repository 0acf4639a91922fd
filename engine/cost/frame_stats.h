// What a rendered picture cost and drew, as the JSON that `render --stats` writes (README, "Statistics").
// Does not: draw.
#pragma once
#include <string>
#include <vector>

#include "frame/renderer.h"
#include "world/forest_ground.h"
#include "world/view_camera.h"

namespace sward {

struct FrameRecord {
    std::string camera;
    std::vector<double> frameMs;  // one a measured frame, each with one finish at its end
    FrameStats stats;             // of a separate frame with a timer around each pass
    std::vector<ForestCount> forests;
};

// Blades whose opacity is above 0 and whose root is in view, counted on the CPU by the shaders' own rule.
uint64_t visibleBlades(const Project& project, const Tables& tables, const ViewCamera& camera, int width, int height);

// Blades that the view would submit, at full detail, by technique and distances; without drawing.
uint64_t submittedBlades(const Project& project, const Tables& tables, const ViewCamera& camera, int width, int height);

// Of one species of a field: how many there are, and how many the view would submit (submittedBlades).
struct SpeciesBlades {
    std::string entity, species;
    double population = 0;
    uint64_t drawn = 0;
};
// Field by field, in the order of names and of each field's species.
std::vector<SpeciesBlades> bladesBySpecies(const Project& project, const Tables& tables, const ViewCamera& camera,
                                           int width, int height);

// One camera: its object; several: {"cameras": [...]}.
std::string frameStatsJson(const std::vector<FrameRecord>& records, const Project& project, const Gpu& gpu, int width,
                           int height, int msaa);

}  // namespace sward
