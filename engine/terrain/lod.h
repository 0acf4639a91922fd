// Selects the pieces of ground to draw for an eye: CDLOD's quadtree (see ground.h). Pure.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "frame/draw_context.h"

namespace sward {

inline constexpr int kNodeQuads = 16;  // a node is a square of kNodeQuads^2 quads
struct TerrainLod {
    double spacing = 0.25;                                    // metres, level 0
    double range = 30;                                        // metres to which level 0 reaches; level l to range * 2^l
    int levels = 1;                                           // the last covers the whole terrain
    double hidden = std::numeric_limits<double>::infinity();  // metres from which haze hides all land that does not
                                                              // stand before the sky
    double plainFrom =
        std::numeric_limits<double>::infinity();  // metres from which all land is a plane to within a pixel: as few
                                                  // nodes as can be, whose levels may differ by more than one
    double reach = 0;                             // metres of land beyond the terrain's edges
    float landLevel = 0;                          // that such land may come to
};
// Levels for a terrain, with the range widened where it is too short for morphing (3.5 nodes of level 0). Level ground
// (no height map) is one level, whatever its size, and of each node the four corners do: what is drawn on nodes takes
// from corners only what is linear between them.
TerrainLod terrainLod(const Terrain& t, double reach = 0);
// Whether any of a node lies on the terrain.
bool touches(const Terrain& t, const TerrainNode& node);
// Nodes within the frustum, each point of the ground in exactly one; those that touch the terrain first. eye: relative
// to the terrain's corner.
std::vector<TerrainNode> selectNodes(const Terrain& t, const TerrainLod& lod, const HeightBounds& bounds,
                                     const glm::dvec3& eye, const Frustum& frustum);

}  // namespace sward
