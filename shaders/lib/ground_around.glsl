// Share of light from all around that objects leave on the ground, with what they throw back, in its colours
// (reference/ground_around.h). Needs: const bool OBJECT_LIGHT.
#include "lib/frame.glsl"
#include "numerics/hash.h"
#include "shared/bindings.h"
#include "shared/objects.h"

layout(binding = TEX_AROUND) uniform sampler2D aroundShare;
layout(binding = TEX_AROUND_CELLS) uniform usampler2D aroundCells;

// Number of a cell's tile; -1: nothing is changed there.
int aroundTile(ivec2 cell) {
    if (any(lessThan(cell, frame.aroundFrom)) || any(greaterThanEqual(cell, frame.aroundTo))) return -1;
    uint key = uint(cell.x) | uint(cell.y) << 16u, last = frame.aroundSlots - 1u,
         slot = hash2(uint(cell.x), uint(cell.y)) & last;
    for (;; slot = (slot + 1u) & last) {
        uvec2 entry = texelFetch(aroundCells, ivec2(slot % uint(AROUND_TABLE), slot / uint(AROUND_TABLE)), 0).xy;
        if (entry.x == key) return int(entry.y);
        if (entry.x == AROUND_EMPTY) return -1;
    }
}

// At a point of the ground, relative to the eye.
vec3 groundAround(vec3 position) {
    if (!OBJECT_LIGHT) return vec3(1.0);
    vec2 at = (position.xz + frame.eye.xz) / AROUND_CELL, cell = floor(at);
    int tile = aroundTile(ivec2(cell));
    if (tile < 0) return vec3(1.0);
    vec2 corner = vec2(tile % AROUND_ACROSS, tile / AROUND_ACROSS) * float(AROUND_SIDE);
    vec2 texel = corner + 0.5 + (at - cell) * float(AROUND_SIDE - 1);
    return textureLod(aroundShare, texel / vec2(textureSize(aroundShare, 0)), 0.0).rgb;
}
