// The terrain as the CPU sees it: heights, bounds, and the ray that finds the ground under the mouse.
// Does not: draw. Heights are relative to the terrain's Transform; bilinear by the rule that shaders use.
#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "scene/project.h"

namespace sward {

// The scene's one terrain and where it stands, or null. Grass without one is not drawn.
struct Ground {
    const Terrain* terrain = nullptr;
    glm::dvec3 origin{0};  // the terrain's corner x = z = 0 in the world
};
// The first entity by name that has a Terrain.
Ground findGround(const Project& p);

// Whether both have the same size and the same heights everywhere.
bool sameGround(const Terrain& a, const Terrain& b);

// Metres at terrain-relative (x, z); beyond the terrain as at its edge, or as the map repeats (scene/tiling.h). 0
// without a height map.
double terrainHeight(const Terrain& t, double x, double z);
// Unit, upward, by differences over a texel of the height map or the grid's spacing, whichever is wider; straight up
// without a height map.
glm::dvec3 terrainNormal(const Terrain& t, double x, double z);
// What a texel of the height map means: metres = offset + scale * texel.
std::pair<double, double> heightScale(const Terrain& t);

// Lowest and highest height over a fixed grid of kBoundsGrid x kBoundsGrid parts of the map: bounds depend neither on
// the map's resolution nor on how often it repeats. Parts are rebuilt where the map's tiles differ.
inline constexpr int kBoundsGrid = 64;
struct HeightBounds {
    std::vector<std::pair<float, float>> parts;  // row-major, z rows; one part if flat
    float low = 0, high = 0;
    Map of;                                 // map that the bounds were taken from ...
    std::pair<double, double> scale{0, 0};  // ... and its heightScale
    glm::dvec2 repeat{0};                   // metres that the map covers before it is mirrored; 0: it does not repeat
    // Bounds over terrain-relative [x0, x1] x [z0, z1] of a terrain of this size.
    std::pair<float, float> over(const glm::dvec2& size, double x0, double z0, double x1, double z1) const;
};
// Brings the bounds up to date with the terrain's height map; cheap while its tiles are the same.
void updateHeightBounds(HeightBounds& b, const Terrain& t);

}  // namespace sward
