#include "terrain/lod.h"

#include <algorithm>

namespace sward {
namespace {

constexpr double kMorphStart = 0.75;   // of a level's range: from here vertices move to the next level's
constexpr double kHorizonSine = 0.01;  // up to here the sky is as it is at the horizon (numerics/sky.h)

struct Selection {
    const Terrain& terrain;
    const TerrainLod& lod;
    const HeightBounds& bounds;
    glm::dvec3 eye;
    const Frustum& frustum;
    double above;  // of the eye over the highest ground: part of every distance
    std::vector<TerrainNode> out;

    double range(int level) const { return lod.range * std::exp2(level); }

    double distance(double x, double z, double size) const {
        const double dx = std::max({x - eye.x, 0.0, eye.x - (x + size)}),
                     dz = std::max({z - eye.z, 0.0, eye.z - (z + size)});
        return std::sqrt(dx * dx + dz * dz + above * above);
    }

    bool visible(double x, double z, double size) const {
        if (x >= terrain.size.x + lod.reach || z >= terrain.size.y + lod.reach) return false;
        auto [low, high] = bounds.over(terrain.size, x, z, x + size, z + size);
        if (lod.reach > 0) low = std::min(low, lod.landLevel), high = std::max(high, lod.landLevel);
        if (const double d = distance(x, z, size); d > lod.hidden && high - eye.y < kHorizonSine * d) return false;
        return frustum.touches(glm::vec3(x - eye.x, low - eye.y, z - eye.z),
                               glm::vec3(x + size - eye.x, high - eye.y, z + size - eye.z));
    }

    void add(double x, double z, int level) {
        const double spacing = lod.spacing * std::exp2(level), end = range(level), begin = end * kMorphStart;
        TerrainNode n;
        n.corner = {x - eye.x, z - eye.z};
        n.place = {x, z};
        n.spacing = static_cast<float>(spacing);
        n.morphFrom = static_cast<float>(begin);
        n.morphInv = static_cast<float>(1 / (end - begin));
        if (level == lod.levels - 1) n.morphFrom = std::numeric_limits<float>::max();  // nothing coarser to morph to
        out.push_back(n);
    }

    // A quad of the tree is two nodes a side, so that a parent can draw the quarters that its children leave.
    void quad(double x, double z, int level) {
        const double node = kNodeQuads * lod.spacing * std::exp2(level);
        for (int i = 0; i < 4; ++i) {
            const double qx = x + (i & 1) * node, qz = z + (i >> 1) * node;
            if (!visible(qx, qz, node)) continue;
            if (level > 0 && distance(qx, qz, node) < std::min(range(level - 1), lod.plainFrom))
                quad(qx, qz, level - 1);
            else
                add(qx, qz, level);
        }
    }
};

}  // namespace

TerrainLod terrainLod(const Terrain& t, double reach) {
    TerrainLod lod;
    const double extent = std::max(t.size.x, t.size.y), all = extent + 2 * reach;
    lod.reach = reach;
    lod.spacing = t.height.present() ? t.gridSpacing : extent / (2 * kNodeQuads);
    lod.range = std::max<double>(t.lodDistance, 3.5 * 2 * kNodeQuads * lod.spacing);
    while (2 * kNodeQuads * lod.spacing * std::exp2(lod.levels - 1) < all) ++lod.levels;
    return lod;
}

bool touches(const Terrain& t, const TerrainNode& n) {
    const double side = kNodeQuads * static_cast<double>(n.spacing), x = static_cast<double>(n.place.x),
                 z = static_cast<double>(n.place.y);
    return x < t.size.x && z < t.size.y && x + side > 0 && z + side > 0;
}

std::vector<TerrainNode> selectNodes(const Terrain& t, const TerrainLod& lod, const HeightBounds& bounds,
                                     const glm::dvec3& eye, const Frustum& frustum) {
    Selection s{t, lod, bounds, eye, frustum, std::max(eye.y - bounds.high, 0.0), {}};
    s.quad(-lod.reach, -lod.reach, lod.levels - 1);
    std::stable_partition(s.out.begin(), s.out.end(), [&](const TerrainNode& n) { return touches(t, n); });
    return std::move(s.out);
}

}  // namespace sward
