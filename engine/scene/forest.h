// A forest over the terrain: which kinds of trees, how many, where, and how far each is drawn as a mesh.
// Its trees stand in triangular tiles that fit together (Decaudin and Neyret 2004, section 7): world/forest_tiles.h.
// Does not: say where a tree stands (world/forest_stand.h), grow its mesh (mesh/tree_shapes.h), or draw it.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/enum_names.h"
#include "maps/map.h"
#include "mesh/tree_shapes.h"
#include "scene/rows.h"

namespace sward {

// How many tiles there are: the paper's eight, of edges of two colours; or 32, of four colours.
enum class TileVariety { Eight, ThirtyTwo };
inline constexpr auto kTileVarieties = enumNames<TileVariety>("eight", "thirty-two");
// How a forest is drawn: near trees as meshes and volumes beyond; all as meshes; or, to compare with, the eight tiles
// as pictures that lie on the ground.
enum class ForestTechnique { Texcells, Trees, Flat };
inline constexpr auto kForestTechniques = enumNames<ForestTechnique>("texcells", "trees", "flat");
// How volumes lie in the GPU's memory: 4 bytes a texel, or blocks of 4 x 4 texels in 16 bytes (BC7).
enum class VolumeStorage { Plain, Compressed };
inline constexpr auto kVolumeStorages = enumNames<VolumeStorage>("plain", "compressed");

struct TreeSpecies {
    std::string name = "spruce";
    TreeKind kind = TreeKind::Conifer;
    std::string file;   // .glb or .gltf in the project's folder that stands there instead of a grown tree; empty: grown
    float share = 1;    // of all trees, against the others' shares
    float height = 12;  // metres; of a file: the tree is scaled to it
    float crown = 0.32f;                         // width of a grown tree's crown, as a share of its height
    int leaves = 2400;                           // of a grown tree, at its nearest
    glm::vec3 leafColor{0.055f, 0.115f, 0.03f};  // reflectance
    glm::vec3 barkColor{0.11f, 0.085f, 0.065f};  // reflectance
    float translucency = 0.5f;                   // light that shines through leaves, as a share of what is reflected
    glm::dvec2 size{0.75, 1.15};                 // factor of its height, from and to
    int seed = 1;                                // another number: another tree
};
// A tree placed by hand, always drawn as a mesh.
struct PlacedTree {
    std::string name = "tree";
    int species = 0;       // of Forest::species, counted from 0
    glm::dvec2 at{0};      // x, z from the terrain's corner (m)
    float size = 1;        // factor of its species' height
    float headingDeg = 0;  // turn about the upright
};
struct Forest {
    std::vector<TreeSpecies> species{1};
    float perHectare = 400;      // trees on 10,000 m2, at density 1
    float distance = 3.5f;       // metres between two trunks at least
    MapField density;            // one channel: share of the trees that stand; absent: 1 everywhere
    float densityTiling = 1;     // repeats over Terrain.mapSize
    glm::dvec2 slopeDeg{0, 40};  // of the ground at the trunk
    float tileSize = 16;         // metres: edge of a tile
    TileVariety variety = TileVariety::ThirtyTwo;
    std::vector<PlacedTree> placed;  // beside those that grow
    // Factor of all heights alone, of meshes and of the baked volumes, which stay as they are: s_z of the paper's
    // section 5. Crowns keep their width, trunks theirs.
    float verticalScale = 1;  // 0.25 to 4
    ForestTechnique technique = ForestTechnique::Texcells;
    float meshesTo = 60;   // metres: trees are drawn as meshes up to here, as volumes beyond; inf: as meshes
    float meshDetail = 1;  // factor of the distances from which meshes have fewer and larger leaves
    float voxel = 0.25f;   // metres: of the volumes, along all three axes
    VolumeStorage storage = VolumeStorage::Plain;
    float silhouetteDeg = 60;  // seen at a smaller angle to their ground, slices face the eye
    float slant = 2;           // how far a slice may then rise across a tile, in heights of the forest
    float stiffness = 15;      // against wind: it leans by Wind.strength over this (m per m)
    bool castShadows = true;   // they shade the ground, the grass and objects
    int seed = 1;
};

// The most trees that one tile holds within it and on one of its edges.
inline constexpr int kMostInside = 14, kMostOnEdge = 6;
inline constexpr double kMostForestTrees = 200'000;  // of one Forest that the whole terrain may ask for

// A species that stands: it has a share and a height.
bool stands(const TreeSpecies& species);
// How far its trees are drawn as meshes by its technique (m); inf: everywhere.
float meshesTo(const Forest& forest);
// Whether it asks for any tree.
bool grows(const Forest& forest);

const ComponentRow& forestRow();

}  // namespace sward
