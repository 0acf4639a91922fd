// What a forest leaves of the light on the ground, tree by tree: each throws its own shade, so that glades are lit and
// edges are where trees end. Light goes through a species' own air by Beer's law; of several trees the depths add up.
// Pure. Does not: shade within the forest (volume_bake.h), nor replace shadow maps near the eye.
// Cost: 4 us a tree; 3 bytes a texel.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "mesh/facing.h"
#include "mesh/mesh.h"
#include "scene/components.h"
#include "world/forest_stand.h"

namespace sward {

// Extinction (1/m) of a tree at its full height, on a grid about its trunk.
struct TreeAir {
    int side = 0, layers = 0;       // parts along x and z, and upwards; 0: of no tree
    double part = 0.5;              // metres of a part's edge
    double height = 0;              // metres
    std::vector<float> extinction;  // x fastest, then z, then upwards; x and z from -side / 2 * part on
    Facing facing = evenFacing();
    float litFacing = 1;  // leaf_depth.h
};
TreeAir treeAir(const Mesh& mesh);

// Optical depth between level ground around a tree's foot and a light: an image that begins at `first`.
struct TreeShade {
    glm::dvec2 first{0};  // metres from the foot
    double texel = 0.5;   // metres
    glm::ivec2 size{0};
    std::vector<float> depth;
    // Linear between texels; 0 beyond.
    float at(const glm::dvec2& place) const;
};
// Towards a light (unit, y up); it is taken to stand no lower than 6 degrees. verticalScale: Forest's, of the tree.
TreeShade shadeTowards(const TreeAir& air, const glm::dvec3& light, double verticalScale = 1);
// Towards all of the sky: the depth that leaves as much of its light.
TreeShade shadeOfSky(const TreeAir& air, double verticalScale = 1);

// Shares of the sky's light that trees leave which stand farther away than their own shade goes, over the whole
// terrain (low_sky.h).
struct LowSky {
    glm::ivec2 size{0};           // 0: no such trees
    std::vector<glm::vec2> left;  // on level ground, on what stands upright
    // Linear between cells; place: share of the terrain.
    glm::vec2 at(const glm::dvec2& place) const;
};

// Over the whole terrain: shares of the sun's light that reach the ground, of the sky's, and of the sky's that reach
// what stands upright on it, as grass does.
struct ShadeMap {
    glm::ivec2 size{0};
    std::vector<uint8_t> shares;  // three a texel
};
inline constexpr int kMostShadeSide = 756;
// Adds the forests one by one, then makes bytes of it.
class ShadeSum {
  public:
    // sun: towards it, unit; its height over the horizon as for shadeTowards.
    ShadeSum(const Terrain& terrain, const glm::dvec3& origin, const glm::dvec3& sun);
    // airs: by species. verticalScale: Forest's.
    void add(const StandingForest& forest, const std::vector<TreeAir>& airs, double verticalScale = 1);
    ShadeMap map(const LowSky& low = {}) const;

  private:
    const Terrain& terrain_;
    glm::dvec3 origin_, sun_;
    glm::ivec2 size_{0};
    glm::dvec2 texel_{0};
    std::vector<float> heights_, sunDepth_, skyDepth_;
};

}  // namespace sward
