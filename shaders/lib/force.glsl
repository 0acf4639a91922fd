// What presses on the grass at a place: what stands or went there, and what is painted. Needs: const bool FORCES,
// FORCE_MAP.
#include "lib/density.glsl"
#include "numerics/gust.h"
#include "shared/bindings.h"
#include "shared/wind.h"

layout(std140, binding = UBO_FORCE) uniform ForceBlock { ForceGlobals force; };
layout(binding = TEX_FORCE) uniform sampler2D forcesAround;
layout(binding = TEX_FORCE_MAP) uniform sampler2D forceMap;

// x, y: push (m per m); z: press. at: x, z relative to the eye; uv: as a share of the terrain.
vec3 forceHere(vec2 at, vec2 uv) {
    vec3 sum = vec3(0.0);
    vec2 inMap = (at - force.corner) * force.share;
    if (FORCES && inMap == clamp(inMap, vec2(0.0), vec2(1.0))) sum = textureLod(forcesAround, inMap, 0.0).rga;
    if (FORCE_MAP) sum += paintedForce(textureLod(forceMap, uv * field.forceTiling, 0.0));
    return forceOf(sum);
}
