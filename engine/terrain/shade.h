// Shadows of hills: a map of the height below which the sun is hidden by the terrain, for shaders/lib/shadow.glsl to
// look up. One sweep from the sun's side over the height map: hidden(p) = max over q towards the sun of height(q) -
// distance * slope of the ray, by the recurrence hidden(p) = max(height(q), hidden(q)) - step * slope. Exact for every
// distance, for ground, blades and objects alike, and made anew only when the sun moves; when heights change, along the
// rays that pass over them. Does not: overhangs, objects (objects/shadow.h). Nothing is done with the sun on the
// horizon or below. Cost: 4 MiB; about 15 ms for 1024 x 1024 on one core when the sun moves.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "scene/components.h"
#include "scene/rows.h"

namespace sward {

// Row of the effect "terrain/shade" (techniques.cpp): runs in scenes with TerrainShadows and Terrain.
const EffectRow& shadeEffect();

// Rows of metres, z rows; texel centres lie at (i + 0.5) / width of the terrain.
struct HeightGrid {
    int width = 0, height = 0;
    std::vector<float> metres;
};
// The terrain's heights, at most 1024 a side; one of 0 m without a height map.
HeightGrid shadeHeights(const Terrain& t);
// Below which height the sun is hidden; far below the ground where nothing hides it. sun: unit, y above 0.
HeightGrid hiddenHeights(const HeightGrid& heights, const glm::dvec2& size, const glm::vec3& sun);

// A part of a grid: columns [x0, x1[ of the rows [y0, y1[.
struct GridPart {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};
// Brings a grid that shadeHeights made of the same terrain up to date, where tiles of its height map differ from
// `before` (of the same shape). Returns around what changed; the grid is then what shadeHeights would make.
GridPart updateShadeHeights(HeightGrid& grid, const Map& before, const Terrain& t);
// The same for what hiddenHeights made of heights that have changed within a part since.
void updateHiddenHeights(HeightGrid& hidden, const HeightGrid& heights, const glm::dvec2& size, const glm::vec3& sun,
                         const GridPart& changed);

}  // namespace sward
