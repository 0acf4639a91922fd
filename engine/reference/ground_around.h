// What objects change of the light from all around on the ground about them: the shade where they stand, and what they
// throw back. Found by rays (reference/around_tracer.h) at the corners of squares of 2 m, over as far as an object may
// reach; every half metre within those that differ, or in which something stands; and 16 a side at the foot of objects
// of less than 8 m, and where the light changes by much. Squares without a change are left out.
// Does not: hills, which the map of ambient occlusion has (reference/occlusion.h); light of lamps. Cost on two cores:
// 0.3 s for rockery, 4 s for park, under whose trees most rays meet leaves. 36 bytes a point in the cache folder, 2.3
// kB a square on the GPU.
#pragma once
#include "reference/around_tracer.h"
#include "world/placement.h"

namespace sward {

struct Mesh;

inline constexpr double kGroundAside =
    0.0137;  // metres along x and z by which points lie aside: walls often stand on round ones
inline constexpr size_t kMostGroundTiles = 16384;  // of a scene: beyond, the ground is lit as in the open

// Where an object stands over the terrain, in terrain-relative metres of x and z.
struct StandingBox {
    glm::dvec2 low{0}, high{0};          // all of it
    glm::dvec2 footLow{0}, footHigh{0};  // what lies less than a metre above the ground; low above high: nothing
    double top = 0;                      // of its highest point above the ground below it (m)
};
// That of an object as it is placed.
StandingBox standingBox(const Ground& ground, const PlacedMesh& placed, const Mesh& mesh);

// A square of the ground.
struct GroundTile {
    glm::ivec2 cell{0};                 // its number along x and z, from the terrain's corner
    int side = 2;                       // points along a side, those on its corners included
    std::vector<AroundFactors> change;  // side x side, rows of x; within objects as beside them
};
// Those with a change, in the order of z, then x. Errors: Failed when cancelled.
Result<std::vector<GroundTile>> traceGround(const AroundTracer& tracer, const Project& p,
                                            const std::vector<StandingBox>& boxes, const JobControl& control);

// Tiles as the renderer reads them (shaders/lib/ground_around.glsl): the share of light that is left, an atlas of
// AROUND_ACROSS tiles a row of AROUND_SIDE points a side, and a table of cells by their hash.
struct PackedGround {
    std::vector<glm::vec4> share;   // rows of AROUND_ACROSS * AROUND_SIDE; empty without tiles
    std::vector<glm::uvec2> table;  // x: a cell's x, and its z times 2^16, or AROUND_EMPTY; y: its tile; a power
                                    // of two of them, at f32::hash2 of x and z or after
    glm::ivec2 from{0}, to{0};      // the cells that have tiles lie from here to before there
};
// Packs tiles under these lights.
PackedGround packGround(const std::vector<GroundTile>& tiles, const AroundLights& lights);

}  // namespace sward
