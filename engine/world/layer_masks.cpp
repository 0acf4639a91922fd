// Index: slope, height · noise · water · object · path · rows.
#include "world/layer_masks.h"

#include <algorithm>
#include <cmath>

#include "core/jobs.h"
#include "core/numerics.h"
#include "maps/distances.h"
#include "mesh/mesh_io.h"
#include "scene/ground_path.h"
#include "scene/tiling.h"
#include "world/placement.h"
#include "world/water.h"

namespace sward {
namespace {

// --- slope, height -------------------------------------------------------------------------------------------------
// Two places a texel to either side, within the texels of a map that ends at the terrain's edge.
struct Span {
    double low, high;
};
Span spanAround(double at, double texel, double size, bool ends) {
    if (!ends) return {at - texel, at + texel};
    return {std::clamp(at - texel, texel / 2, size - texel / 2), std::clamp(at + texel, texel / 2, size - texel / 2)};
}
double rise(double low, double high, const Span& over) {
    return over.high > over.low ? (high - low) / (over.high - over.low) : 0;
}

Result<Measure> measureSlope(MaskScene& scene, const MapMask&) {
    const Terrain& t = *scene.ground.terrain;
    if (!t.height.present()) return Measure([](double, double) { return 0.0f; });
    const Tiling tiling = tilingOf(t, t.heightTiling);
    const glm::dvec2 texel = tiling.metres / glm::dvec2(t.height.map.info().width, t.height.map.info().height);
    return Measure([&t, texel, ends = !tiling.repeats](double x, double z) {
        const Span xs = spanAround(x, texel.x, t.size.x, ends), zs = spanAround(z, texel.y, t.size.y, ends);
        const double dx = rise(terrainHeight(t, xs.low, z), terrainHeight(t, xs.high, z), xs),
                     dz = rise(terrainHeight(t, x, zs.low), terrainHeight(t, x, zs.high), zs);
        return static_cast<float>(glm::degrees(std::atan(std::hypot(dx, dz))));
    });
}

Result<Measure> measureHeight(MaskScene& scene, const MapMask&) {
    const Terrain& t = *scene.ground.terrain;
    return Measure([&t](double x, double z) { return static_cast<float>(terrainHeight(t, x, z)); });
}

// --- noise ---------------------------------------------------------------------------------------------------------
// A number in [0, 1] that varies smoothly over about one unit.
float valueNoise(double x, double z, uint32_t seed) {
    const double cx = std::floor(x), cz = std::floor(z);
    const auto smooth = [](double t) { return static_cast<float>(t * t * (3 - 2 * t)); };
    const auto at = [&](int i, int j) {
        return f32::hashUnit(f32::cellHash(static_cast<int>(cx) + i, static_cast<int>(cz) + j, seed));
    };
    return f32::bilinearMix(at(0, 0), at(1, 0), at(0, 1), at(1, 1), smooth(x - cx), smooth(z - cz));
}

Result<Measure> measureNoise(MaskScene&, const MapMask& mask) {
    const double size = std::max(static_cast<double>(mask.size), 1e-3);
    const auto seed = static_cast<uint32_t>(mask.seed);
    return Measure([size, seed](double x, double z) {
        return (2 * valueNoise(x / size, z / size, seed) + valueNoise(2 * x / size, 2 * z / size, seed + 1)) / 3;
    });
}

// --- water ---------------------------------------------------------------------------------------------------------
constexpr double kMostCells = 1024, kSmallestCell = 0.05;

void layRaster(WaterDistances& w, const Terrain& t) {
    const double side = std::max(t.size.x, t.size.y);
    w.cell = std::max(side / kMostCells, kSmallestCell);
    w.width = std::max(static_cast<int>(std::ceil(t.size.x / w.cell)), 1);
    w.height = std::max(static_cast<int>(std::ceil(t.size.y / w.cell)), 1);
}

bool wetAt(const std::vector<WaterPlace>& waters, const Terrain& t, double x, double z) {
    const double height = terrainHeight(t, x, z);
    return std::any_of(waters.begin(), waters.end(), [&](const WaterPlace& place) {
        return height < static_cast<double>(place.water->level) && within(place, x, z);
    });
}

std::vector<uint8_t> wetCells(const WaterDistances& w, const Terrain& t, const std::vector<WaterPlace>& waters) {
    std::vector<uint8_t> wet(static_cast<size_t>(w.width) * static_cast<size_t>(w.height));
    parallelFor(static_cast<size_t>(w.height), [&](size_t z) {
        for (int x = 0; x < w.width; ++x)
            wet[z * static_cast<size_t>(w.width) + static_cast<size_t>(x)] =
                wetAt(waters, t, (x + 0.5) * w.cell, (static_cast<double>(z) + 0.5) * w.cell);
    });
    return wet;
}

void updateWater(WaterDistances& w, const Terrain& t, const std::vector<WaterPlace>& waters) {
    const auto [offset, scale] = heightScale(t);
    std::string of = fmt::format("{} {} {} {} {} {}", t.size.x, t.size.y, offset, scale, t.heightTiling, t.mapSize);
    for (const WaterPlace& place : waters)
        of += fmt::format(" {} {} {} {}", place.water->level, place.middle.x, place.middle.y, place.radius);
    if (w.of == of && w.heights.sameTiles(t.height.map)) return;
    w.of = std::move(of);
    w.heights = t.height.map;
    const double before = w.cell;
    layRaster(w, t);
    std::vector<uint8_t> wet = wetCells(w, t, waters);
    if (wet == w.wet && before == w.cell) return;
    w.wet = std::move(wet);
    w.metres = distancesTo(w.wet, w.width, w.height, 1);
    for (float& d : w.metres) d *= static_cast<float>(w.cell);
    ++w.version;
}

// Bilinear between the cells' middles. Water reaches half a cell beyond the middle of its last one.
float waterDistance(const WaterDistances& w, double x, double z) {
    const f64::BilinearTap t = f64::bilinearTap(std::clamp(x / (w.width * w.cell), 0.0, 1.0),
                                                std::clamp(z / (w.height * w.cell), 0.0, 1.0), w.width, w.height);
    const auto at = [&](int i, int j) {
        return w.metres[static_cast<size_t>(j) * static_cast<size_t>(w.width) + static_cast<size_t>(i)];
    };
    const float d = f32::bilinearMix(at(t.x0, t.y0), at(t.x1, t.y0), at(t.x0, t.y1), at(t.x1, t.y1),
                                     static_cast<float>(t.fx), static_cast<float>(t.fy));
    return std::isfinite(d) ? std::max(d - static_cast<float>(w.cell / 2), 0.0f) : INFINITY;
}

Result<Measure> measureWater(MaskScene& scene, const MapMask&) {
    const std::vector<WaterPlace> waters = watersOf(*scene.project, scene.ground);
    if (waters.empty()) return unsound("the scene has no water", "add an entity with Water");
    updateWater(scene.water, *scene.ground.terrain, waters);
    const WaterDistances& distances = scene.water;
    return Measure([&distances](double x, double z) { return waterDistance(distances, x, z); });
}

std::string waterInputs(MaskScene& scene, const MapMask&) {
    const std::vector<WaterPlace> waters = watersOf(*scene.project, scene.ground);
    if (waters.empty()) return "none";
    updateWater(scene.water, *scene.ground.terrain, waters);
    return std::to_string(scene.water.version);
}

// --- object --------------------------------------------------------------------------------------------------------
struct Standing {
    glm::dvec2 at{0};  // relative to the terrain's corner
    const StaticMesh* mesh = nullptr;
};
Result<Standing> standing(const MaskScene& scene, const MapMask& mask) {
    const Project& p = *scene.project;
    if (mask.object.empty()) return unsound("it names no object", "name an entity that has a place");
    const Entity e = findEntity(p, mask.object);
    if (e == kNoEntity) return unsound(fmt::format("there is no entity \"{}\"", mask.object), "name another");
    const Transform* transform = p.registry.get<Transform>(e);
    const StaticMesh* mesh = p.registry.get<StaticMesh>(e);
    if (mesh && mesh->file.empty()) mesh = nullptr;
    if (!transform && !mesh)
        return unsound(fmt::format("\"{}\" stands nowhere", mask.object), "give it a Transform or name another");
    const glm::dvec3 at = (transform ? transform->position : glm::dvec3(0)) - scene.ground.origin;
    return Standing{{at.x, at.z}, mesh};
}

std::string outlineKey(const Project& p, const StaticMesh& mesh) {
    return fmt::format("{} {} {} {}", fileVersion(p.dir, mesh.file), mesh.rotationDeg.x, mesh.rotationDeg.y,
                       mesh.rotationDeg.z);
}

// Null with a fault if the object's file cannot be read.
Result<std::shared_ptr<const Footprint>> outlineOf(MaskScene& scene, const std::string& entity,
                                                   const StaticMesh& mesh) {
    ObjectOutline& held = scene.outlines[entity];
    std::string of = outlineKey(*scene.project, mesh);
    if (held.footprint && held.of == of) return held.footprint;
    const Result<Mesh> read = readMesh(scene.project->dir, mesh.file);
    if (!read) return read.error();
    held = {std::move(of),
            std::make_shared<const Footprint>(makeFootprint(*read, glm::mat3(rotationOf(mesh.rotationDeg)), INFINITY))};
    return held.footprint;
}

Result<Measure> measureObject(MaskScene& scene, const MapMask& mask) {
    const Result<Standing> found = standing(scene, mask);
    if (!found) return found.error();
    const glm::dvec2 at = found->at;
    if (!found->mesh)
        return Measure([at](double x, double z) { return static_cast<float>(std::hypot(x - at.x, z - at.y)); });
    const Result<std::shared_ptr<const Footprint>> outline = outlineOf(scene, mask.object, *found->mesh);
    if (!outline) return outline.error();
    if ((*outline)->empty()) return unsound(fmt::format("\"{}\" has an object without triangles", mask.object), "");
    const double scale = static_cast<double>(found->mesh->scale);
    return Measure([at, scale, shape = *outline](double x, double z) {
        const glm::vec2 place((x - at.x) / scale, (z - at.y) / scale);
        return std::max(outlineAt(*shape, place).x * static_cast<float>(scale), 0.0f);
    });
}

std::string objectInputs(MaskScene& scene, const MapMask& mask) {
    const Result<Standing> found = standing(scene, mask);
    if (!found) return found.error().message;
    std::string text = fmt::format("{} {}", found->at.x, found->at.y);
    if (found->mesh) text += fmt::format(" {} {}", outlineKey(*scene.project, *found->mesh), found->mesh->scale);
    return text;
}

// --- path ----------------------------------------------------------------------------------------------------------
// Metres beside the path's width; infinite beyond where the mask can tell a difference.
Result<Measure> measurePath(MaskScene& scene, const MapMask& mask) {
    const Result<const GroundPath*> path = pathNamed(scene, mask.object);
    if (!path) return path.error();
    GroundCurve curve = groundCurve(**path);
    const double half = static_cast<double>((*path)->width) / 2,
                 last = static_cast<double>(std::isfinite(mask.to) ? mask.to : mask.from),
                 reach = half + std::max(last, 0.0) + static_cast<double>(mask.falloff);
    return Measure([curve = std::move(curve), half, reach](double x, double z) {
        return static_cast<float>(std::max(nearestOn(curve, {x, z}, reach).distance - half, 0.0));
    });
}

std::string pathInputs(MaskScene& scene, const MapMask& mask) { return pathText(scene, mask.object); }

// --- rows ----------------------------------------------------------------------------------------------------------
constexpr MaskRow kRows[] = {
    {"deg", 0, 90, true, measureSlope, nullptr},      {"m", -10, 100, true, measureHeight, nullptr},
    {"", 0, 1, false, measureNoise, nullptr},         {"m", 0, 50, false, measureWater, waterInputs},
    {"m", 0, 50, false, measureObject, objectInputs}, {"m", 0, 20, false, measurePath, pathInputs},
};
static_assert(std::size(kRows) == kMaskBys.size());

}  // namespace

Result<const GroundPath*> pathNamed(const MaskScene& scene, const std::string& entity) {
    const GroundPath* path = scene.project->registry.get<GroundPath>(findEntity(*scene.project, entity));
    if (!path)
        return unsound(entity.empty() ? "it names no path" : fmt::format("there is no path \"{}\"", entity),
                       "name an entity with a GroundPath");
    if (groundCurve(*path).pieces.empty())
        return unsound(fmt::format("the path \"{}\" has no points", entity), "give it some");
    return path;
}

std::string pathText(const MaskScene& scene, const std::string& entity) {
    const GroundPath* path = scene.project->registry.get<GroundPath>(findEntity(*scene.project, entity));
    if (!path) return "none";
    std::string text = fmt::format("{} {} {}", path->width, path->falloff, path->closed);
    for (const PathPoint& point : path->points) text += fmt::format(" {} {}", point.at.x, point.at.y);
    return text;
}

std::span<const MaskRow> maskRows() { return kRows; }

float maskShare(const MapMask& mask, float measured) {
    const bool inside = measured >= mask.from && measured <= mask.to;
    const float beyond = measured < mask.from ? mask.from - measured : measured - mask.to;
    const float share = inside ? 1 : mask.falloff > 0 ? std::clamp(1 - beyond / mask.falloff, 0.0f, 1.0f) : 0;
    return mask.invert ? 1 - share : share;
}

}  // namespace sward
