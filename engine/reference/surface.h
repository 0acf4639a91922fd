// What the reference's parts tell each other: rays, what they meet, and images as rays see them.
// Positions are metres from the terrain's corner (from the world's origin without a terrain), in double: cells and hits
// keep their digits 90 km out.
#pragma once
#include <glm/glm.hpp>
#include <limits>
#include <vector>

#include "frame/color_image.h"
#include "maps/map.h"

namespace sward {

inline constexpr uint32_t kNoFlower = ~uint32_t{0};

struct Ray {
    glm::dvec3 origin;
    glm::dvec3 way;  // unit
    double near = 0, far = std::numeric_limits<double>::infinity();
    uint32_t grain = 0;         // decides which part-covered edges it passes: another number, another choice
    uint32_t left = kNoFlower;  // the flower that it comes from: it would turn to the ray, and be met once more
};

enum class Met { Ground, Object, Blade, Flower, Water };
struct Surface {
    Met met = Met::Ground;
    double t = 0;
    glm::dvec3 at{0};
    glm::vec3 normal{0, 1, 0};  // unit, on the side that the ray came from
    glm::vec3 face{0, 1, 0};    // normal of the surface as it is, which a smooth normal may differ from
    glm::vec3 color{0};         // reflectance
    glm::vec3 looks{0};         // of a leaf, a blade's or a tree's: translucency, gloss, roughness
    glm::vec3 tint{1};          // of all that it sends: a blade's image
    float open = 1;             // of a blade or flower: ambient light left so near to its root, where nothing is traced
    uint32_t flower = kNoFlower;
    uint32_t field = 0;   // of a blade: the number of its field (grass_rays.h)
    bool beyond = false;  // of ground: beyond the terrain, where its colour tells what grows, too
    bool ofTree = false;  // of an object: it is a tree of a forest
    uint32_t object = 0;  // likewise: its number, as placedMeshes has them, then the scattered ones, then trees
    bool onMesh = false;  // of a blade: it grows on a mesh, where none of the terrain's maps is read
    glm::dvec2 place{0};  // as a share of the terrain, where the maps are read: a blade's root
};

// Colour and alpha of an image, linear.
struct TexelGrid {
    int width = 0, height = 0;
    std::vector<glm::vec4> texels;  // rows first
    // Bilinear, texel centres at (i + 0.5) / n; beyond the edges it repeats, or the edge holds.
    glm::vec4 at(double u, double v, bool repeat) const;
};
// The image's sRGB colours, linear; alpha as it is.
TexelGrid texelGridOf(const Rgba8& image);
// A painted map read as shaders read it: it repeats `tiling` times over what a map of tiling 1 covers; colours, of sRGB
// maps, linear.
glm::vec4 paintedAt(const Map& map, const glm::dvec2& place, double tiling, bool srgb);

}  // namespace sward
