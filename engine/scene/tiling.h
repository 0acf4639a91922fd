// Where on its map a place of the terrain lies. Every map has a tiling: how often it repeats over Terrain.mapSize
// metres, or over the whole terrain where that is 0; so that texels stay small on a field of any size (Jahrmann and
// Wimmer 2013, section 6.2). A map that lies on the terrain once ends there: its edge texels go on beyond. One that
// repeats begins again, and should be seamless; heights are mirrored from repeat to repeat instead, so that no map has
// a cliff at its seams. Does not: know which field is whose tiling; the map's row says it (scene/map_row.h).
#pragma once
#include "scene/components.h"

namespace sward {

struct Tiling {
    glm::dvec2 metres{1};  // that one repeat covers
    bool repeats = false;  // else it lies on the terrain once
    bool operator==(const Tiling&) const = default;
};
// Of a map of this tiling (above 0, finite) on the terrain.
Tiling tilingOf(const Terrain& t, float tiling);
// Metres that a map of tiling 1 covers.
glm::dvec2 mapExtent(const Terrain& t);
// As shaders take it (shared/grass.h): 0 where it does not repeat.
float shaderTiling(const Terrain& t, float tiling);

// One channel at terrain-relative (x, z) in metres, bilinear by the rule that shaders use (numerics/bilinear.h). Any
// finite x, z.
float tiledSample(const Map& map, const Tiling& tiling, double x, double z, int c = 0);
// The same of a map of heights, mirrored from repeat to repeat.
float mirroredSample(const Map& map, const Tiling& tiling, double x, double z);

}  // namespace sward
