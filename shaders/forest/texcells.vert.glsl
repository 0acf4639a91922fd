// A corner of one slice of one tile. Slices lie parallel to the tile's ground, or are tilted towards the eye by moving
// their corners up and down. The nearer one always comes first.
#include "lib/frame.glsl"
#include "lib/light.glsl"
#include "lib/mirror.glsl"
#include "lib/wind.glsl"
#include "numerics/correction.h"
#include "numerics/forest.h"
#include "shared/bindings.h"
#include "shared/forest.h"

layout(std430, binding = SSBO_FOREST_TILES) readonly buffer TilesBlock { TileInView tiles[]; };
// Of all slices, in the order in which they are drawn: FOREST_MOST_SLICES times the tile, and its slice; FOREST_CHUNK
// each instance, the last ones filled up with slices that no tile has.
layout(std430, binding = SSBO_FOREST_SLICES) readonly buffer SlicesBlock { uint slices[]; };
layout(std140, binding = UBO_FOREST) uniform ForestBlock { ForestGlobals forest; };
layout(location = 0) uniform int first;  // slice of the draw

out vec3 position;     // relative to the eye
out vec2 stored;       // lattice coordinates in the cells that repeat
flat out int number;   // of the tile
flat out vec2 blend;   // shares of the finer and of the coarser level
flat out vec3 facing;  // unit normal of the slice
out float path;        // slabs' heights that lie between two slices along the line of sight
out vec4 haze;         // its colour; share of the light that it takes
flat out vec2 canopy;  // TileInView::canopy
flat out int sunRise;  // TileInView::rise
flat out int level;    // TileInView::level

// Corners in the cell, as edges' families are named by (numerics/forest.h).
vec2 cornerOf(int corner, bool up) {
    if (up) return vec2(corner == 1 ? 1.0 : 0.0, corner == 2 ? 1.0 : 0.0);
    return vec2(corner == 1 ? 0.0 : 1.0, corner == 2 ? 0.0 : 1.0);
}

// Half of a tilted slice lies under the ground or over the trees: cut away.
void cutAtReach(TileInView t, float over) {
    vec3 begin = vec3(t.corner[0].w, t.corner[1].w, t.corner[2].w);
    float low = max(max(begin.x, begin.y), begin.z);
    float high = min(min(begin.x, begin.y), begin.z) + float(t.slices) * t.spacing;
    if (!WATER_REFLECTION) gl_ClipDistance[0] = 1.0;
    gl_ClipDistance[1] = over - low;
    gl_ClipDistance[2] = high - over;
}

void main() {
    uint which = slices[first + gl_InstanceID * FOREST_CHUNK + gl_VertexID / 3];
    number = int(which / uint(FOREST_MOST_SLICES));
    TileInView t = tiles[number];
    int k = int(which % uint(FOREST_MOST_SLICES)), corner = gl_VertexID % 3;
    int slice = k < t.slices - t.below ? t.below + k : t.slices - 1 - k;
    float share = t.coarser;
    // Slices by pairs: the lower one becomes the pair's, between the two, while the upper one fades.
    bool lower = (slice & 1) == 0;
    blend = lower ? vec2(1.0 - share, share) : vec2(1.0 - share, 0.0);
    float rise = (float(slice) + 0.5 + (lower ? 0.5 * share : 0.0)) * t.spacing;
    position = t.corner[corner].xyz + vec3(0.0, t.corner[corner].w + rise, 0.0);
    stored = t.stored + cornerOf(corner, t.up == 1);
    // Crowns sway: what stands there leans, so that the look-up is sheared the other way.
    if (WIND)
        stored -= toLattice(windLeanAt(position.xz, -1.0, forest.sway) * (t.corner[corner].w + rise), forest.edge);
    vec3 low[3];
    for (int i = 0; i < 3; ++i) low[i] = t.corner[i].xyz + vec3(0.0, t.corner[i].w, 0.0);
    facing = normalize(cross(low[2] - low[0], low[1] - low[0]));
    float distance = length(position);
    vec3 way = position / distance;
    // The way that leaves were baked along: their depth is as there (forest/stretch.h).
    float stretch = length(position * vec3(forest.verticalScale, 1.0, forest.verticalScale)) / distance;
    path = t.path * slantFactor(facing.xzy, way.xzy) * stretch;
    haze = vec4(hazeColor(position), hazeShare(distance));
    canopy = t.canopy;
    sunRise = t.rise;
    level = t.level;
    cutAtWater(position.y);
    cutAtReach(t, t.corner[corner].w + rise);
    gl_Position = k < t.slices ? frame.viewProj * vec4(position, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
