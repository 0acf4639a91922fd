#include "reference/occlusion.h"

#include "core/hash.h"
#include "core/numerics.h"
#include "world/ground.h"

namespace sward {
namespace {

constexpr uint32_t kVersion = 2;  // of the method: another one gives other maps
constexpr int kDefaultSide = 512;

const MapField* existingMap(const Project& p) {
    for (const auto& [name, e] : p.entities)
        if (const GrassField* f = p.registry.get<GrassField>(e))
            return f->ambientOcclusion.present() ? &f->ambientOcclusion : nullptr;
    return nullptr;
}

MapInfo infoFor(const Project& p, const Terrain& t, const OcclusionSettings& s) {
    const MapField* existing = existingMap(p);
    if (s.size == 0 && existing) return {existing->map.info().width, existing->map.info().height, 1, PixelType::U8};
    const int side = s.size > 0 ? s.size : kDefaultSide;
    const double longer = std::max(t.size.x, t.size.y);
    const auto texels = [&](double extent) {
        return std::max(static_cast<int>(std::lround(side * extent / longer)), 1);
    };
    return {texels(t.size.x), texels(t.size.y), 1, PixelType::U8};
}

// Two unit vectors across n.
void axesAcross(const glm::vec3& n, glm::vec3& u, glm::vec3& v) {
    u = glm::normalize(glm::cross(std::abs(n.x) < 0.7f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0), n));
    v = glm::cross(n, u);
}

}  // namespace

// Malley's method: points spread evenly over a disc, lifted onto the hemisphere, are weighted by the cosine.
double skySeen(const RayScene& rays, const TerrainSurface& ground, double x, double z, const glm::dvec2& spread,
               int samples, uint32_t id) {
    const int side = std::max(static_cast<int>(std::sqrt(samples)), 1);
    int open = 0;
    for (int i = 0; i < side * side; ++i) {
        const uint32_t h = f32::hash2(id, static_cast<uint32_t>(i));
        const auto random = [&](uint32_t n) { return f32::hashUnit(f32::hash2(h, n)); };
        const double px = x + (random(0) - 0.5) * spread.x, pz = z + (random(1) - 0.5) * spread.y;
        const glm::vec3 n = ground.normalAt(px, pz), from = ground.at(px, pz) + n * 2e-3f;
        const float r = std::sqrt((static_cast<float>(i % side) + random(2)) / static_cast<float>(side));
        const float turn = 6.2831853f * (static_cast<float>(i / side) + random(3)) / static_cast<float>(side);
        glm::vec3 u, v;
        axesAcross(n, u, v);
        const glm::vec3 way =
            u * (r * std::cos(turn)) + v * (r * std::sin(turn)) + n * std::sqrt(std::max(1 - r * r, 0.0f));
        open += !rays.hits(from, way);
    }
    return static_cast<double>(open) / (side * side);
}

Result<Map> bakeOcclusion(const Project& p, const OcclusionSettings& settings, JobControl& control) {
    const Ground ground = findGround(p);
    if (!ground.terrain)
        return unsound("there is no Terrain to bake ambient occlusion for", "add an entity with a Terrain").at(p.dir);
    const Result<SceneTriangles> triangles = sceneTriangles(p, control, SolidsTaken::WithoutTraced);
    if (!triangles) return triangles.error();
    const Result<RayScene> rays = RayScene::make(triangles->meshes, triangles->scattered);
    if (!rays) return rays.error();
    const TerrainSurface surface = terrainSurface(*ground.terrain);
    const MapInfo info = infoFor(p, *ground.terrain, settings);
    const glm::dvec2 texel(ground.terrain->size.x / info.width, ground.terrain->size.y / info.height);
    std::vector<uint8_t> texels(static_cast<size_t>(info.width) * static_cast<size_t>(info.height));
    std::atomic<int> done = 0;
    parallelFor(static_cast<size_t>(info.height), [&](size_t y) {
        for (int x = 0; x < info.width && !control.cancelled(); ++x) {
            const uint32_t id = f32::hash2(static_cast<uint32_t>(x), static_cast<uint32_t>(y));
            const double seen = skySeen(*rays, surface, (x + 0.5) * texel.x, (static_cast<double>(y) + 0.5) * texel.y,
                                        texel, settings.samples, id);
            texels[y * static_cast<size_t>(info.width) + static_cast<size_t>(x)] =
                static_cast<uint8_t>(std::lround(255 * seen));
        }
        control.setProgress(static_cast<double>(++done) / info.height);
    });
    if (control.cancelled()) return failed("cancelled");
    Map map(info);
    map.writeRows(0, info.height, texels.data());
    return map;
}

uint64_t occlusionHash(const Project& p, const OcclusionSettings& settings) {
    const Ground ground = findGround(p);
    const MapInfo info = ground.terrain ? infoFor(p, *ground.terrain, settings) : MapInfo{};
    const uint64_t parts[] = {kVersion, sceneTrianglesHash(p, SolidsTaken::WithoutTraced),
                              static_cast<uint64_t>(settings.samples), static_cast<uint64_t>(info.width),
                              static_cast<uint64_t>(info.height)};
    return hashBytes(parts, sizeof(parts));
}

}  // namespace sward
