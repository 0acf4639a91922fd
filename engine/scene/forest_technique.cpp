#include "scene/forest_technique.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/json.h"
#include "scene/project.h"

namespace sward {
namespace {

using Settings = std::vector<std::vector<std::string>>;

constexpr float kFewerDistances[] = {0, 0.5f, 2};  // of the forest's own, at which meshes end
constexpr float kOtherAngles[] = {0, 24, 90};      // at which slices turn to the eye: never, as published, always

std::string meshesUpTo(float metres) { return fmt::format("meshesTo={:g}", metres); }

Settings texcells(const Forest& f) {
    const std::string own = meshesUpTo(f.meshesTo);
    Settings out{{own, "msaa=4"}, {own, "msaa=1"}, {own, kTemporalSetting}};
    for (const float share : kFewerDistances) out.push_back({meshesUpTo(share > 0 ? share * f.meshesTo : 0), "msaa=4"});
    for (const float degrees : kOtherAngles) out.push_back({own, fmt::format("silhouetteDeg={:g}", degrees), "msaa=4"});
    return out;
}
Settings trees(const Forest& f) {
    const auto detail = [&](float factor) { return fmt::format("meshDetail={:g}", factor * f.meshDetail); };
    return {{detail(1), "msaa=4"},
            {detail(1), "msaa=1"},
            {detail(1), kTemporalSetting},
            {detail(0.5f), "msaa=4"},
            {detail(2), "msaa=4"}};
}
Settings flat(const Forest&) { return {{"msaa=4"}, {"msaa=1"}, {kTemporalSetting}}; }

// Factors of the forest's own: how far meshes go, below which angle slices face the eye, how many leaves meshes keep.
constexpr KnobRow kMeshes{"meshesTo", true, 1, 0, 1e30, true};
constexpr KnobRow kAngle{"silhouetteDeg", true, 1, 0, 1e30, true};
constexpr KnobRow kDetail{"meshDetail", true, 1, 0, 1e30, true};
constexpr KnobRow kTexcellsKnobs[] = {kMeshes, kAngle, kDetail, kSamplesKnob};
constexpr KnobRow kTreesKnobs[] = {kDetail, kSamplesKnob};
constexpr KnobRow kFlatKnobs[] = {kSamplesKnob};

std::string turnedBy(const char* name, float own, double factor, double least, double most) {
    const double turned = std::clamp(static_cast<double>(own) * factor, least, most);
    return std::string(name) + "=" + shortestText(static_cast<float>(std::round(turned * 1000) / 1000));
}
std::string detailTurned(const Forest& f, double factor) {
    return turnedBy("meshDetail", f.meshDetail, factor, 0.05, 1e6);
}
SettingValues texcellsTurned(const Forest& f, std::span<const double> k) {
    return {turnedBy("meshesTo", f.meshesTo, k[0], 0, 1e6), turnedBy("silhouetteDeg", f.silhouetteDeg, k[1], 0, 90),
            detailTurned(f, k[2]), samplesTurned(k[3])};
}
SettingValues treesTurned(const Forest& f, std::span<const double> k) {
    return {detailTurned(f, k[0]), samplesTurned(k[1])};
}
SettingValues flatTurned(const Forest&, std::span<const double> k) { return {samplesTurned(k[0])}; }

constexpr ForestTechniqueRow kForestRows[] = {
    {"forest-texcells", ForestTechnique::Texcells, 0x1b6e3c, texcells, kTexcellsKnobs, texcellsTurned},
    {"forest-trees", ForestTechnique::Trees, 0x7a4b1e, trees, kTreesKnobs, treesTurned},
    {"forest-flat", ForestTechnique::Flat, 0x9fb8a4, flat, kFlatKnobs, flatTurned},
};

}  // namespace

std::span<const ForestTechniqueRow> forestTechniques() { return kForestRows; }

const ForestTechniqueRow* findForestTechnique(std::string_view name) {
    for (const ForestTechniqueRow& row : kForestRows)
        if (name == row.name) return &row;
    return nullptr;
}

const ForestTechniqueRow& techniqueOf(const Forest& forest) {
    for (const ForestTechniqueRow& row : kForestRows)
        if (row.technique == forest.technique) return row;
    return kForestRows[0];
}

std::vector<std::pair<std::string, const Forest*>> growingForests(const Project& project) {
    std::vector<std::pair<std::string, const Forest*>> out;
    for (const auto& [name, e] : project.entities)
        if (const Forest* f = project.registry.get<Forest>(e); f && grows(*f)) out.push_back({name, f});
    return out;
}

}  // namespace sward
