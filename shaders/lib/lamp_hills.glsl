// Hills that shade lamps' light: how the maps of terrain/lamp_hills.h are laid out, and how they are looked up. Needs:
// const bool LAMPS, LAMP_HILLS. A map has a line a column, along which light goes from its first row on; a texel holds
// the most that any ground before it demands (hillDemand) of what is to see the lamp. Lines of a lamp that stands
// somewhere are rays around it, the finer the nearer; those of a directional one lie side by side over the terrain.
#include "lib/frame.glsl"
#include "lib/lamps.glsl"
#include "shared/bindings.h"
#include "shared/terrain.h"

layout(binding = TEX_LAMP_HILLS) uniform sampler2DArray lampHills;

const float kTurn = 6.283185307;

// Where lines begin, metres from the terrain's corner: the lamp, or the terrain's middle. And how far they go.
vec2 hillsFrom(int i) {
    return lamps.lights[i].isPoint > 0.0 ? lamps.lights[i].place.xz + frame.eye.xz : 0.5 * frame.terrainSize;
}
float hillsReach(int i) {
    vec2 from = hillsFrom(i);
    return max(length(max(abs(from), abs(frame.terrainSize - from))), 1e-3);
}
// The level direction in which a directional lamp's light goes.
vec2 hillsAlong(int i) {
    vec2 towards = lamps.lights[i].place.xz;
    float level = length(towards);
    return level > 1e-6 ? -towards / level : vec2(1.0, 0.0);
}
// By how much such light falls a metre of its way.
float hillsFall(int i) { return lamps.lights[i].place.y / max(length(lamps.lights[i].place.xz), 1e-4); }

// Metres from where the line begins, for a row in [0, 1].
float hillDistance(int i, float row) {
    return lamps.lights[i].isPoint > 0.0 ? hillsReach(i) * row * row : hillsReach(i) * (2.0 * row - 1.0);
}
// A place in the map, both in [0, 1], as metres from the terrain's corner.
vec2 hillPlace(int i, vec2 at) {
    float distance = hillDistance(i, at.y);
    if (lamps.lights[i].isPoint > 0.0) return hillsFrom(i) + distance * vec2(cos(at.x * kTurn), sin(at.x * kTurn));
    vec2 along = hillsAlong(i);
    return hillsFrom(i) + along * distance + vec2(-along.y, along.x) * (hillsReach(i) * (2.0 * at.x - 1.0));
}
// What ground so high (relative to the eye), so far along, demands: by a lamp that stands somewhere the slope up to it
// from there, else how high it would stand at the line's begin.
float hillDemand(int i, float height, float distance) {
    if (lamps.lights[i].isPoint > 0.0) return (height - lamps.lights[i].place.y) / max(distance, 1e-2);
    return height + frame.eye.y + distance * hillsFall(i);
}

// Metres by which what lies between texels may differ from the ground, so that no slope in grazing light shades itself.
const float kSlack = 0.02;
// Share of the light: soft over a quarter of what it falls from texel to texel.
float lampPastHills(int i, vec3 position) {
    vec2 from = position.xz + frame.eye.xz - hillsFrom(i);
    float reach = hillsReach(i), distance, fall, step = 1.0 / float(LAMP_HILLS_STEPS);
    vec2 at;
    if (lamps.lights[i].isPoint > 0.0) {
        distance = length(from);
        at = vec2(distance > 0.0 ? atan(from.y, from.x) / kTurn : 0.0, sqrt(distance / reach));
        step *= 2.0 * reach * at.y;
        fall = (lamps.lights[i].place.y - position.y) / max(distance, 1e-2);
    } else {
        vec2 along = hillsAlong(i);
        distance = dot(from, along);
        at = 0.5 + 0.5 * vec2(dot(from, vec2(-along.y, along.x)), distance) / reach;
        step *= 2.0 * reach;
        fall = hillsFall(i);
    }
    float over = hillDemand(i, position.y, distance) - textureLod(lampHills, vec3(at, float(i)), 0.0).r;
    if (lamps.lights[i].isPoint > 0.0) over *= max(distance, 1e-2);
    float soft = 0.02 + 0.25 * step * abs(fall);
    return smoothstep(-soft - kSlack, -kSlack, over);
}
