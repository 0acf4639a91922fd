#include "world/keep_off.h"

#include <algorithm>
#include <cmath>

#include "mesh/mesh_io.h"
#include "world/placement.h"

namespace sward {
namespace {

constexpr size_t kMostOutlines = 256;  // at most 256 KB each

// Metres of the mesh, as it stands, over its origin that are low over the ground.
double topOf(const Ground& ground, const PlacedMesh& placed) {
    const glm::dvec3 at = placed.at - ground.origin;
    return terrainHeight(*ground.terrain, at.x, at.z) + kLowM - at.y;
}

std::string outlineOf(const Project& p, const Ground& ground, const PlacedMesh& placed) {
    const glm::dvec3& turn = placed.mesh->rotationDeg;
    return fmt::format("{} {} {} {} {} {:.3f}", fileVersion(p.dir, placed.mesh->file), turn.x, turn.y, turn.z,
                       placed.mesh->scale, topOf(ground, placed));
}

std::shared_ptr<const Footprint> makeOutline(const Project& p, const Ground& ground, const PlacedMesh& placed) {
    const Result<Mesh> mesh = readMesh(p.dir, placed.mesh->file);
    if (!mesh) return std::make_shared<const Footprint>();
    const double top = topOf(ground, placed) / static_cast<double>(placed.mesh->scale);
    return std::make_shared<const Footprint>(
        makeFootprint(*mesh, glm::mat3(rotationOf(placed.mesh->rotationDeg)), static_cast<float>(top)));
}

// From the origin to the farthest corner of the raster, beyond which there is no outline.
double reachOf(const Footprint& f) {
    const glm::vec2 far = glm::max(glm::abs(f.low), glm::abs(f.high()));
    return static_cast<double>(glm::length(far));
}

std::vector<const GroundPath*> groundPathsOf(const Project& p) {
    std::vector<const GroundPath*> out;
    for (const auto& [name, e] : p.entities)
        if (const GroundPath* path = p.registry.get<GroundPath>(e)) out.push_back(path);
    return out;
}

}  // namespace

bool KeepOff::holds(double x, double z) const {
    const glm::dvec2 place(x, z);
    for (const Strip& s : paths) {
        const bool near = x >= s.box.low.x && x <= s.box.high.x && z >= s.box.low.y && z <= s.box.high.y;
        if (near && nearestOn(s.curve, place, s.half).distance < s.half) return true;
    }
    for (const Standing& o : objects) {
        const glm::dvec2 from = place - o.at;
        if (glm::dot(from, from) > o.reach * o.reach) continue;
        const double distance = static_cast<double>(outlineAt(*o.outline, glm::vec2(from / o.scale)).x) * o.scale;
        if (distance < gap) return true;
    }
    return false;
}

KeepOff keepOffOf(const Project& p, const Ground& ground, const Scatter& s, Footprints& outlines) {
    KeepOff off;
    if (!ground.terrain) return off;
    off.gap = static_cast<double>(s.gap);
    if (s.keepOffPaths)
        for (const GroundPath* path : groundPathsOf(p)) {
            KeepOff::Strip strip{groundCurve(*path), static_cast<double>(path->width) / 2 + off.gap, {}};
            strip.box = boxOf(strip.curve, strip.half);
            if (!strip.curve.pieces.empty()) off.paths.push_back(std::move(strip));
        }
    Footprints kept;
    if (s.keepOffObjects)
        for (const PlacedMesh& placed : placedMeshes(p)) {
            const std::string key = outlineOf(p, ground, placed);
            const auto held = outlines.find(key);
            std::shared_ptr<const Footprint>& outline = kept[key];
            if (!outline) outline = held != outlines.end() ? held->second : makeOutline(p, ground, placed);
            if (outline->empty()) continue;
            const double scale = static_cast<double>(placed.mesh->scale);
            const glm::dvec3 at = placed.at - ground.origin;
            off.objects.push_back({outline, {at.x, at.z}, scale, reachOf(*outline) * scale + off.gap});
        }
    if (outlines.size() > kMostOutlines) outlines.clear();
    outlines.merge(kept);
    return off;
}

std::string keepOffInputs(const Project& p, const Ground& ground, const Scatter& s) {
    if (!ground.terrain || !keepsOff(s)) return {};
    std::string text = fmt::format("{}", s.gap);
    if (s.keepOffPaths)
        for (const GroundPath* path : groundPathsOf(p)) {
            text += fmt::format("|{} {}", path->width, path->closed);
            for (const PathPoint& point : path->points) text += fmt::format(" {} {}", point.at.x, point.at.y);
        }
    if (s.keepOffObjects)
        for (const PlacedMesh& placed : placedMeshes(p))
            text += fmt::format("#{} {} {}", outlineOf(p, ground, placed), placed.at.x, placed.at.z);
    return text;
}

}  // namespace sward
