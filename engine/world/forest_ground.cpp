#include "world/forest_ground.h"

#include <algorithm>

#include "core/numerics.h"

namespace sward {
namespace {

// A triangle's corner k in its cell.
glm::ivec2 cornerOf(bool up, size_t k) { return up ? glm::ivec2(k == 1, k == 2) : glm::ivec2(k != 1, k != 2); }

f64::vec3 upwards(const glm::dvec3& v) { return f64::vec3(v.x, v.z, v.y); }

}  // namespace

std::array<glm::dvec3, 3> groundUnder(const StandingForest& f, const ForestTriangle& t, const Terrain& terrain) {
    std::array<glm::dvec3, 3> out;
    for (size_t k = 0; k < 3; ++k) {
        const glm::ivec2 at = t.cell + cornerOf(t.tile.up, k);
        const f64::vec2 place = f64::fromLattice({at.x, at.y}, f.tiles.edge);
        out[k] = f.origin + glm::dvec3(place.x, terrainHeight(terrain, place.x, place.y), place.y);
    }
    return out;
}

bool mayStandOver(const std::array<glm::dvec3, 3>& g) {
    return f64::groundUsable(upwards(g[0] - g[0]), upwards(g[1] - g[0]), upwards(g[2] - g[0]));
}

std::vector<ForestCount> countForests(const Project& project) {
    std::vector<ForestCount> out;
    const Ground ground = findGround(project);
    for (const auto& [entity, forest] : forestsOf(project)) {
        const StandingForest f = standingForest(*forest, ground);
        ForestCount c{entity, kForestTechniques[forest->technique], f.trees.size(), f.triangles.size(), 0};
        for (const ForestTriangle& t : f.triangles) c.cliffs += !mayStandOver(groundUnder(f, t, *ground.terrain));
        out.push_back(std::move(c));
    }
    return out;
}

}  // namespace sward
