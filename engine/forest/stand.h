// The scene's forests as they stand: which trees, and the meshes of their species at three levels.
// One system a frame brings both up to date; what draws them reads the list. Does not: draw.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "frame/draw_context.h"
#include "mesh/mesh.h"
#include "world/forest_stand.h"

namespace sward {

// Shares of a tree's leaves at each level, and the distance (m, of a tree of 12 m) from which the next one is drawn.
inline constexpr int kTreeLevels = 3;
inline constexpr float kTreeKeep[kTreeLevels] = {1, 0.35f, 0.12f};
inline constexpr double kTreeLevelEnds[kTreeLevels - 1] = {22, 55};

struct ForestHere {
    std::string entity;
    Forest rule;                     // what the rest was made of
    std::optional<Terrain> terrain;  // likewise
    glm::dvec3 origin{0};            // of the terrain
    std::vector<std::string> files;  // versions of species' files
    std::shared_ptr<const StandingForest> stand;
    std::vector<Mesh> meshes;  // by species; empty: none stands, or its file cannot be read
    // By species: mean reflectance of leaves; share of its area that is leaves; share of the light on it that it sends
    // on.
    std::vector<glm::vec3> colors;
    std::vector<float> leaves;
    std::vector<glm::vec3> scatter;
    // What shines through a species' leaves, as a share of what they reflect, in the mean of all its area.
    float throughOf(size_t i) const { return leaves[i] * rule.species[i].translucency; }
    // Light in its air, by forest/texcells while there are volumes; 0: none. What they name is that effect's.
    GLuint light = 0, lightGlobals = 0;
    uint64_t stood = 0, grown = 0;  // another number each time that the stand, or tiles and meshes, are made anew
};
struct ForestsState : EffectState {
    std::vector<std::unique_ptr<ForestHere>> all;  // in the order of names
    uint64_t times = 0;
};
// Row of the effect "forest/stand" (effects.cpp): runs in scenes with a Forest and a Terrain.
const EffectRow& forestEffect();

}  // namespace sward
