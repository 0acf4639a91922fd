// Which trees of a Forest stand, and in which of the terrain's triangles: for drawing by meshes and by volumes, for the
// truth, for export. A tree stands where its tile or edge has it, where the density reaches its threshold (a hash) and
// the ground at its trunk is neither too steep nor too level. Pure.
// Does not: draw. Cost: 0.5 us a tree.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "scene/project.h"
#include "world/forest_tiles.h"
#include "world/ground.h"

namespace sward {

struct StandingTree {
    glm::dvec3 at{0};  // foot of its trunk in the world
    uint32_t species = 0;
    float size = 1;        // factor of its species' height
    float headingDeg = 0;  // turn about the upright
    glm::vec2 stored{0};   // lattice coordinates of its foot in the cells that repeat
    float chance = 0;      // in [0, 1[, its own: who draws it near the distance where meshes end
    bool byHand = false;   // it is in no triangle, and a mesh at any distance
    float upright = 1;     // factor of its height alone: Forest::verticalScale
};
// Where a triangle's list has the trees within it and those across its edges, by family.
inline constexpr int kTreeSlots = kMostInside + 3 * kMostOnEdge;
constexpr int firstSlot(EdgeFamily f) { return kMostInside + static_cast<int>(f) * kMostOnEdge; }
// A triangle of the lattice in which a tree stands, or into which one reaches.
struct ForestTriangle {
    glm::ivec2 cell{0};  // of the lattice
    ForestTile tile;
    std::array<int32_t, kTreeSlots> trees{};  // into StandingForest::trees; -1: none stands
};
struct StandingForest {
    ForestTiles tiles;
    std::vector<StandingTree> trees;
    std::vector<ForestTriangle> triangles;
    glm::dvec3 origin{0};  // of the lattice, in the world
    uint32_t seed = 0;     // of the lattice's colours
    uint64_t hash = 0;     // over all trees
};
// Nothing without a terrain, or where more than kMostForestTrees are asked for.
StandingForest standingForest(const Forest& forest, const Ground& ground);

// A forest whose trees are asked for by place. None is kept, so that bytes and time go by its tiles and by the trees
// placed by hand, however large the terrain.
struct ForestPlaces {
    Forest rule;
    ForestTiles tiles;                                // none: no tree stands
    std::vector<std::pair<double, uint32_t>> byHand;  // of rule.placed, by x: metres from the terrain's corner, index
};
ForestPlaces forestPlaces(const Forest& forest, const Ground& ground);
// Replaces `out` by the trees of standingForest whose feet lie within `reach` metres of a place in the world (x, z):
// those of the lattice in a fixed order, then those placed by hand. `ground`: that of forestPlaces. Returns how many
// trees it looked at: those of the cells around the place, stand they or not.
size_t treesNear(const ForestPlaces& places, const Ground& ground, const glm::dvec2& at, double reach,
                 std::vector<StandingTree>& out);

// Whether a tree at this distance (m) from the eye is drawn as a mesh; else its volume is. Each tree changes at a
// distance of its own, within a tenth of meshesTo, so that no ring of trees changes at once.
bool isMesh(const Forest& forest, const StandingTree& tree, double distance);
// The farthest at which any is, and the nearest at which none may be.
double meshesEnd(const Forest& forest);
double volumesBegin(const Forest& forest);

// The mesh of a species at its full height, standing on the origin: grown, or from its file in `dir`, the project's
// folder. Errors: a file that cannot be read.
Result<Mesh> treeMesh(const std::filesystem::path& dir, const TreeSpecies& species);
// A tree's rotation and size, of its species' mesh, and how much higher it stands than that.
glm::dmat3 turnOf(const StandingTree& tree);
// Its height in metres, of its species'.
float heightOf(const StandingTree& tree, const TreeSpecies& species);
// What wind does to that: what stands leans by so much (m per m along x and z), and its foot stays.
glm::dmat3 leaning(const glm::dvec2& lean);
// Metres, of a tree at its full height, at its foot; of one from a file it is taken to be a fiftieth of the height.
double trunkRadius(const TreeSpecies& species);

// Every entity's Forest that has trees, in the order of names.
std::vector<std::pair<std::string, const Forest*>> forestsOf(const Project& p);

// Whether both have the same tiles and the same species, and whether they also have the same trees on the same ground.
bool sameTiles(const Forest& a, const Forest& b);
bool sameForest(const Forest& a, const Forest& b);

}  // namespace sward
