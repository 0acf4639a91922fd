// Objects that stand where a rule scatters them over the terrain, instead of as entities one by one.
// Does not: say where; world/scatter.h does, and drawing, tracing and picking ask it.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "maps/map.h"
#include "scene/rows.h"

namespace sward {

struct ScatterMesh {
    std::string name = "mesh";
    std::string file;  // .glb or .gltf; empty: none of it
    float share = 1;   // of all objects, against the others' shares
};
// Ranges go from x to y.
struct Scatter {
    std::vector<ScatterMesh> meshes{1};
    float perHectare = 100;            // objects on 10,000 m2, at density 1, before slopes and heights are left out
    MapField density;                  // one channel; absent: 1 everywhere
    float densityTiling = 1;           // repeats over Terrain.mapSize
    float distance = 1;                // metres between two of them at least, from origin to origin seen from above
    glm::dvec2 slopeDeg{0, 35};        // of the ground
    glm::dvec2 heights{-1e5, 1e5};     // of the ground, metres as the terrain's heights count
    glm::dvec2 size{0.8, 1.2};         // factor of a mesh's size
    glm::dvec2 headingDeg{-180, 180};  // turn about the upright, counter-clockwise from above
    float alignToGround = 0;           // 0: upright; 1: as the ground's normal
    bool keepOffPaths = true;          // none stands on the width of a GroundPath
    bool keepOffObjects = true;        // nor on a StaticMesh, where that is low over the ground (world/keep_off.h)
    float gap = 0.5f;                  // metres beside both that stay free, to an object's origin
    bool castShadows = true;
    int seed = 1;
};

// How dense objects may stand that keep a distance of 1 m and come one after the other, as a number a square metre.
// Above, ever fewer find room (world/scatter.h).
inline constexpr double kDensestScatter = 0.6269;
inline constexpr double kMostScattered = 200'000;  // objects of one Scatter that the whole terrain may ask for

// A mesh that is scattered: it has a file and a share.
bool isScattered(const ScatterMesh& mesh);
// Whether paths or objects are in its way.
bool keepsOff(const Scatter& scatter);
// Whether the rule asks for any object.
bool scatters(const Scatter& scatter);

const ComponentRow& scatterRow();

}  // namespace sward
