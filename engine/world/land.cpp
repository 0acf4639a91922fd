#include "world/land.h"

#include <algorithm>

#include "core/numerics.h"
#include "scene/technique.h"
#include "scene/tiling.h"

namespace sward {
namespace {

constexpr int kSide = 24;  // places a side over which means are taken
// Of its leaves' reflectance, what a canopy sends: the rest falls on leaves again, or shades (mean of the samples).
constexpr float kCanopySends = 0.5f;
constexpr float kTakesLight = 0.6f;  // Beer's law, by leaf area

bool repeats(const Terrain& t, float tiling) { return tilingOf(t, tiling).repeats; }

glm::vec3 decoded(const glm::vec3& srgb) {
    return {f32::srgbDecode(srgb.x), f32::srgbDecode(srgb.y), f32::srgbDecode(srgb.z)};
}
// Colour and opacity of an sRGB map at a place; opacity 0 where there is none.
glm::vec4 paintAt(const Terrain& t, const MapField& map, float tiling, double x, double z) {
    if (!map.present() || map.map.info().channels < 4) return glm::vec4(0);
    const Tiling over = tilingOf(t, tiling);
    glm::vec4 c;
    for (int k = 0; k < 4; ++k) c[k] = tiledSample(map.map, over, x, z, k);
    return {decoded(glm::vec3(c)), c.w};
}

glm::vec3 leavesOf(const Species& s) { return 0.2f * s.rootColor + 0.5f * s.midColor + 0.3f * s.tipColor; }

// Adds what a field has at a place: leaf area, and that times its colour.
void addGrass(const Terrain& t, const GrassField& f, double x, double z, float& area, glm::vec3& colour) {
    const glm::vec4 paint = paintAt(t, f.vegetation, f.vegetationTiling, x, z);
    for (const Species& s : f.species) {
        const float density =
            s.density.present() ? tiledSample(s.density.map, tilingOf(t, s.densityTiling), x, z) : 1.0f;
        const float here = density * s.bladesPerM2 * s.height * s.width;
        area += here;
        colour += here * glm::mix(leavesOf(s), glm::vec3(paint), paint.w);
    }
}

// Soil that lies under so much leaf area, and what is seen of it and of that.
struct Covered {
    float left;  // of the light on the soil
    glm::vec3 sends;
};
Covered coveredBy(const glm::vec3& soil, float area, const glm::vec3& colour) {
    const glm::vec3 grass = area > 0 ? kCanopySends * colour / area : glm::vec3(0);
    const float left = std::exp(-kTakesLight * area);
    return {left, f32::landSends(soil * left, grass, left, glm::vec3(0), 0)};
}

// Sums over places, of those where more grass than soil is seen, and of the others.
struct Places {
    glm::vec3 sends{0};
    int count = 0;
};

// The mean is that of places with grass or of bare ones, whichever are more: a mixture of both stands nowhere.
void sumMeans(const Project& p, const Terrain& t, Land& land) {
    const auto fields = fieldsOf(p);
    glm::vec3 grassColours(0);
    float areas = 0;
    Places grown, bare;
    for (int i = 0; i < kSide * kSide; ++i) {
        const double x = t.size.x * (i % kSide + 0.5) / kSide, z = t.size.y * (i / kSide + 0.5) / kSide;
        const glm::vec4 paint = paintAt(t, t.terrainMap, t.terrainMapTiling, x, z);
        const glm::vec3 soil = f32::soilColor(t.groundColor, t.groundColor, glm::vec3(paint), paint.w);
        float area = 0;
        glm::vec3 colour(0);
        for (const auto& [name, field] : fields)
            if (field.grows.onTerrain) addGrass(t, field.grows, x, z, area, colour);
        areas += area, grassColours += colour;
        const Covered here = coveredBy(soil, area, colour);
        Places& of = here.left < 0.5f ? grown : bare;
        of.sends += here.sends, ++of.count;
    }
    const Places& more = grown.count >= bare.count ? grown : bare;
    land.mean = more.sends / static_cast<float>(std::max(more.count, 1));
    land.grass = areas > 0 ? kCanopySends * grassColours / areas : land.mean;
}

double edgesHeight(const Terrain& t) {
    if (!t.height.present()) return 0;
    double sum = 0;
    for (int i = 0; i < kSide; ++i) {
        const double s = (i + 0.5) / kSide;
        sum += terrainHeight(t, s * t.size.x, 0) + terrainHeight(t, s * t.size.x, t.size.y) +
               terrainHeight(t, 0, s * t.size.y) + terrainHeight(t, t.size.x, s * t.size.y);
    }
    return sum / (4 * kSide);
}

}  // namespace

Land landOf(const Project& p) {
    Land land;
    const Terrain* t = findGround(p).terrain;
    if (!t || t->beyond == LandBeyond::None) return land;
    land.reach = kLandReach;
    if (t->beyond == LandBeyond::Fade && !(t->mapSize > 0))
        land.fade = static_cast<float>(4 / std::max(t->size.x, t->size.y));
    land.level = static_cast<float>(edgesHeight(*t));
    sumMeans(p, *t, land);
    return land;
}

glm::vec3 groundSends(const Terrain& t, std::span<const GrassField* const> fields, double x, double z,
                      const glm::vec3& soil) {
    float area = 0;
    glm::vec3 colour(0);
    for (const GrassField* f : fields)
        if (f->onTerrain) addGrass(t, *f, x, z, area, colour);
    return coveredBy(soil, area, colour).sends;
}

double landHeight(const Terrain& t, const Land& land, double x, double z) {
    const double edge = terrainHeight(t, x, z);
    if (!(land.fade > 0) || repeats(t, t.heightTiling)) return edge;
    const double share = f64::landMean(f64::beyondBy({x, z}, t.size), static_cast<double>(land.fade));
    return edge + (static_cast<double>(land.level) - edge) * share;
}

}  // namespace sward
