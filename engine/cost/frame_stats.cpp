#include "cost/frame_stats.h"

#include <set>

#include <sys/resource.h>

#include "core/json.h"
#include "frame/draw_context.h"
#include "gpu/timer.h"
#include "grass/cells.h"
#include "grass/drawing.h"
#include "world/drawn_project.h"
#include "world/view_camera.h"

namespace sward {
namespace {

// The value below which a share of the sorted values lies (nearest rank).
double quantile(const std::vector<double>& sorted, double share) {
    if (sorted.empty()) return 0;
    return sorted[std::min(sorted.size() - 1, static_cast<size_t>(share * static_cast<double>(sorted.size())))];
}

Json frameMs(std::vector<double> ms) {
    std::sort(ms.begin(), ms.end());
    Json j;
    j["median"] = quantile(ms, 0.5);
    j["p95"] = quantile(ms, 0.95);
    j["min"] = ms.empty() ? 0.0 : ms.front();
    return j;
}

Json passJson(const PassStats& p) {
    Json j;
    j["name"] = p.name;
    j["ms"] = p.ms;
    j["draws"] = p.draws;
    j["instances"] = p.instances;
    j["vertices"] = p.vertices;
    j["fragments"] = p.fragments;
    return j;
}

Json names(const std::vector<std::string>& list) {
    Json j = Json::makeArray();
    for (const std::string& n : list) j.push(n);
    return j;
}

// Of all fields; names of several are joined by "+".
std::string techniqueOf(const Project& p) {
    std::string out;
    std::set<std::string> seen;
    for (const auto& [name, field] : fieldsOf(p))
        if (seen.insert(field.grows.technique).second) out += (out.empty() ? "" : "+") + field.grows.technique;
    return out.empty() ? "none" : out;
}

Json bladesJson(const FrameStats& s) {
    Json j;
    j["virtual"] = static_cast<uint64_t>(std::llround(s.bladesVirtual));
    j["geometry"] = s.bladesGeometry;
    j["geometry_visible"] = s.bladesVisible;
    j["slice_quads"] = s.sliceQuads;
    j["macro_cells"] = s.macroCells;
    return j;
}

// There only where a scene has forests.
void addForests(Json& all, const std::vector<ForestCount>& forests) {
    for (const ForestCount& f : forests) {
        Json j;
        j["name"] = f.entity;
        j["trees"] = f.trees;
        j["tiles"] = f.tiles;
        j["cliffs"] = f.cliffs;
        all["forests"].push(std::move(j));
    }
}

Json memoryJson(const FrameStats& s) {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    Json j;
    j["gpu_bytes"] = s.gpuBytes;
    j["bake_bytes"] = 0;
    j["host_peak_bytes"] = static_cast<uint64_t>(usage.ru_maxrss) * 1024;
    return j;
}

Json recordJson(const FrameRecord& r, const Project& project, const Gpu& gpu, int width, int height, int msaa) {
    Json j;
    j["sward"] = SWARD_VERSION;
    j["renderer"] = gpu.renderer;
    j["project"] = project.name;
    j["camera"] = r.camera;
    j["technique"] = techniqueOf(project);
    j["size"].push(width);
    j["size"].push(height);
    j["msaa"] = msaa;
    j["frames"] = r.frameMs.size();
    j["frame_ms"] = frameMs(r.frameMs);
    j["timing"] = GpuTimer::kind(gpu);
    j["passes"] = Json::makeArray();
    for (const PassStats& p : r.stats.passes) j["passes"].push(passJson(p));
    j["blades"] = bladesJson(r.stats);
    addForests(j, r.forests);
    j["memory"] = memoryJson(r.stats);
    j["features"] = names(r.stats.features);
    j["programs"] = names(r.stats.programs);
    j["systems"] = names(r.stats.systems);
    return j;
}

// What is looked at, for counts.
struct Counted {
    const Project& project;
    std::span<const TechniqueRow> techniques;
    const ViewCamera& camera;
    int width, height;
};

float fadeOf(const FieldEntity& field) { return field.settings<GrassDrawing>().fade; }

// each(name of the field's entity, species, query) over the species of all fields that grow over the terrain.
template <class F>
void overSpecies(const Counted& c, F&& each) {
    const Ground ground = findGround(c.project);
    if (!ground.terrain) return;
    HeightBounds bounds;
    updateHeightBounds(bounds, *ground.terrain);
    const Frustum frustum = frustumOf(viewProjection(c.camera, c.width, c.height));
    const QueryFrom from{c.camera.eye - ground.origin, frustum, pixelsPerMetre(c.camera, c.height)};
    for (const auto& [name, field] : fieldsOf(c.project)) {
        const GrassField& f = field.grows;
        if (!f.onTerrain) continue;
        for (const Species& s : f.species) {
            const UniqueBlades own = isUnique(f) ? makeUnique(s, f, *ground.terrain) : UniqueBlades{};
            const Patch patch = isUnique(f) ? own.patch : makePatch(s, f.cellSize, static_cast<uint32_t>(f.seed));
            CellQuery q = cellQuery({*ground.terrain, bounds, f, s, patch,
                                     tiersOf(c.techniques, field, from.pixelsPerMetre).blades, fadeOf(field)},
                                    from);
            if (!own.empty()) q.unique = &own;
            each(name, s, q);
        }
    }
}

uint64_t submitted(const CellQuery& q) {
    uint64_t sum = 0;
    for (const CellDraw& c : selectCells(q)) sum += c.last - c.first;
    return sum;
}

}  // namespace

uint64_t visibleBlades(const Project& project, const Tables& tables, const ViewCamera& camera, int width, int height) {
    DrawnProject drawn;
    uint64_t sum = 0;
    overSpecies({drawn.of(project, tables.components), tables.techniques, camera, width, height},
                [&](const std::string&, const Species&, const CellQuery& q) { sum += countVisible(q); });
    return sum;
}

uint64_t submittedBlades(const Project& project, const Tables& tables, const ViewCamera& camera, int width,
                         int height) {
    uint64_t sum = 0;
    for (const SpeciesBlades& s : bladesBySpecies(project, tables, camera, width, height)) sum += s.drawn;
    return sum;
}

std::vector<SpeciesBlades> bladesBySpecies(const Project& project, const Tables& tables, const ViewCamera& camera,
                                           int width, int height) {
    DrawnProject drawn;
    const Project& p = drawn.of(project, tables.components);
    std::vector<SpeciesBlades> out;
    overSpecies({p, tables.techniques, camera, width, height},
                [&](const std::string& entity, const Species& s, const CellQuery& q) {
                    const double mean = s.density.present() && s.bladesPerM2 > 0 ? s.density.map.mean() : 1;
                    const double area = q.terrain.size.x * q.terrain.size.y;
                    out.push_back({entity, s.name, static_cast<double>(s.bladesPerM2) * mean * area, submitted(q)});
                });
    return out;
}

std::string frameStatsJson(const std::vector<FrameRecord>& records, const Project& project, const Gpu& gpu, int width,
                           int height, int msaa) {
    if (records.size() == 1) return writeJson(recordJson(records[0], project, gpu, width, height, msaa));
    Json all;
    all["renderer"] = gpu.renderer;
    all["cameras"] = Json::makeArray();
    for (const FrameRecord& r : records) all["cameras"].push(recordJson(r, project, gpu, width, height, msaa));
    return writeJson(all);
}

}  // namespace sward
