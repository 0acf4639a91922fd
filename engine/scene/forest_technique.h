// How a forest is drawn, as rows of sweeps and plots: one a value of Forest::technique, beside those of grass
// (scene/technique.h), whose names they do not share. Does not: draw; Forest's own features say what runs.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/forest.h"
#include "scene/technique.h"

namespace sward {

struct Project;

struct ForestTechniqueRow {
    const char* name;           // in tables and on the command line: "forest-" and the value's name
    ForestTechnique technique;  // what Forest::technique then is
    uint32_t color;             // in plots: 0xRRGGBB; of no technique of grass
    // Settings that `cost` tries, each a list of NAME=VALUE around the forest's own; as many for every forest.
    std::vector<std::vector<std::string>> (*sweep)(const Forest&);
    std::span<const KnobRow> knobs;                                         // what `fit` turns
    SettingValues (*turned)(const Forest&, std::span<const double> knobs);  // values that knobs stand for
};

std::span<const ForestTechniqueRow> forestTechniques();
// The row named so, or null.
const ForestTechniqueRow* findForestTechnique(std::string_view name);
// The row that draws it so.
const ForestTechniqueRow& techniqueOf(const Forest& forest);
// The project's forests that have trees, in the order of their entities' names, each with that name.
std::vector<std::pair<std::string, const Forest*>> growingForests(const Project& project);

}  // namespace sward
