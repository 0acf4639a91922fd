// A vertex that the compute pass has posed and lit: passed on.
#include "lib/frame.glsl"
#include "lib/mirror.glsl"
#include "shared/tess.h"

layout(location = 0) in vec4 at;  // in clip space
layout(location = 1) in vec4 light;
layout(location = 2) in vec2 along;   // along, opacity
layout(location = 3) in uint number;  // grain, PLAIN_BLADE with it; the first bit: across
layout(location = 4) in vec4 sun;
layout(location = 5) in float facing;
layout(location = 6) in float highlight;
layout(location = 7) in float shadowTurn;  // by MASK_TURNS
layout(location = 8) in vec2 shadowPlace;  // the rest of maskAt
layout(location = 9) in vec3 since;

centroid out vec4 lit;  // as in geometry.vert.glsl
centroid out vec4 sunned;
centroid out vec2 sunward;
centroid out vec3 maskAt;
centroid out vec3 strip;
flat out uint grain;
out vec3 moved;

void main() {
    if (WATER_REFLECTION) {
        vec4 back = frame.invViewProj * at;
        cutAtWater(back.y / back.w);
    }
    gl_Position = at;
    lit = light;
    sunned = sun;
    sunward = vec2(facing, highlight);
    maskAt = vec3(shadowTurn * MASK_TURNS, shadowPlace);
    moved = TEMPORAL ? since : vec3(0.0);
    strip = vec3((number & PLAIN_BLADE) != 0u ? 0.5 : float(number >> 31), along);
    grain = number & ~(1u << 31);
}
