#include "cost/frame_estimate.h"

#include <algorithm>

#include "scene/project.h"
#include "scene/technique.h"

namespace sward {
namespace {

double secondsToPlace(uint64_t blades) { return static_cast<double>(blades) * kSecondsABlade; }

std::string techniqueIn(const Project& project, const std::string& entity) {
    const GrassField* field = project.registry.get<GrassField>(findEntity(project, entity));
    return field ? field->technique : "";
}

std::string counted(uint64_t blades) {
    return blades < 10'000'000 ? fmt::format("{:.1f} million", static_cast<double>(blades) / 1e6)
                               : fmt::format("{:.0f} million", static_cast<double>(blades) / 1e6);
}

}  // namespace

bool mayBeLong(const Project& project) { return virtualBlades(project) * kSecondsABlade > kLongFrame; }

FrameEstimate estimateFrame(const Project& project, const Tables& tables, const ViewCamera& camera, int width,
                            int height) {
    FrameEstimate all;
    for (const SpeciesBlades& s : bladesBySpecies(project, tables, camera, width, height)) {
        if (all.fields.empty() || all.fields.back().entity != s.entity)
            all.fields.push_back({s.entity, techniqueIn(project, s.entity)});
        all.fields.back().blades += s.drawn;
        all.fields.back().seconds += secondsToPlace(s.drawn);
        all.seconds += secondsToPlace(s.drawn);
    }
    std::stable_sort(all.fields.begin(), all.fields.end(),
                     [](const FieldEstimate& a, const FieldEstimate& b) { return a.seconds > b.seconds; });
    return all;
}

std::string quickerTechnique(const Project& project, const Tables& tables, const ViewCamera& camera, int width,
                             int height, const FieldEstimate& slow) {
    std::string best, without;
    double least = kLongFrame;
    for (const TechniqueRow& row : tables.techniques) {
        if (slow.technique == row.name) continue;
        Project other = snapshot(project, tables.components);
        auto field = findField(other, tables.components, slow.entity + ".GrassField.technique");
        if (!field || !setFieldText(*field, row.name)) continue;
        const FrameEstimate e = estimateFrame(other, tables, camera, width, height);
        if (e.seconds == 0 && without.empty()) without = row.name;
        if (e.seconds > 0 && e.seconds < least) best = row.name, least = e.seconds;
    }
    return best.empty() ? without : best;
}

std::string longFrameText(const Project& project, const Tables& tables, const ViewCamera& view, int width, int height,
                          const std::string& camera) {
    if (!mayBeLong(project)) return {};
    const FrameEstimate e = estimateFrame(project, tables, view, width, height);
    if (!(e.seconds > kLongFrame)) return {};
    const FieldEstimate& slow = e.fields.front();
    const std::string other = quickerTechnique(project, tables, view, width, height, slow);
    return fmt::format("{}: about {:.0f} s a frame: {} draws {} blades one by one ({}){}", camera, e.seconds,
                       slow.entity, counted(slow.blades), slow.technique,
                       other.empty()
                           ? std::string()
                           : fmt::format("; {} is quicker: {}.GrassField.technique={}", other, slow.entity, other));
}

}  // namespace sward
