// Draws the ground: heights by level of detail without cracks, soil under the terrain map, grass's mean colour
// where blades are not drawn. Level of detail: F. Strugar, "Continuous Distance-Dependent Level of Detail for Rendering
// Heightmaps", 2009 (CDLOD): quadtree nodes by distance, vertices that morph to the next level's before it begins.
// Distances are horizontal plus the eye's height above the highest ground, so that both sides of a border agree however
// steep it is. Colour: Jahrmann and Wimmer 2013, equation 1. Levels follow gridSpacing and lodDistance in metres, not
// the map's texels: a finer map costs no triangle. Beyond where half the land's relief is a pixel it is a plane to the
// eye, and takes as few nodes as can be. Does not: shadows, holes, overhangs. Cost at defaults: some 100-200 nodes of
// 512 triangles, about 30 more for each doubling of the terrain up to there, 3 beyond; level ground: 4 nodes of 2
// triangles, whatever its size.
#pragma once
#include "scene/rows.h"

namespace sward {
// Row of the effect "terrain/ground" (techniques.cpp): runs in scenes with Terrain.
const EffectRow& groundEffect();
// The depth of land that is not level, before all else: hills hide grass. Reads the nodes that the ground has chosen.
const EffectRow& groundDepthEffect();
}  // namespace sward
