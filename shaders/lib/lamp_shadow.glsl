// How much of a lamp's light reaches a point past objects and hills. Needs: const bool LAMPS, LAMP_SHADOWS, LAMP_HILLS.
// Objects: what each lamp sees (objects/lamp_shadow.h). Hills: how high one must stand to see it
// (terrain/lamp_hills.h).
#include "lib/lamp_hills.glsl"
#include "lib/lamps.glsl"
#include "lib/shadow_taps.glsl"
#include "shared/bindings.h"
#include "shared/objects.h"

layout(std140, binding = UBO_LAMP_SHADOW) uniform LampShadowBlock { LampShadowGlobals lampShadow; };
layout(binding = TEX_LAMP_SHADOW) uniform sampler2DArrayShadow lampShadowMaps;

// Where a point that lies so from the lamp is in the cube around it: face, place in it, metres along its axis.
struct CubePlace {
    float face, depth;
    vec2 at;
};
CubePlace cubePlace(vec3 from) {
    vec3 size = abs(from);
    CubePlace c;
    int axis = size.x >= max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
    vec2 across = axis == 0 ? from.zy : axis == 1 ? from.xz : from.xy;
    c.depth = max(size[axis], LAMP_SHADOW_NEAR);
    c.face = float(2 * axis + (from[axis] < 0.0 ? 1 : 0));
    c.at = 0.5 + 0.5 * LAMP_SHADOW_SHARE * across / c.depth;
    return c;
}

float lampTaps(float layer, vec3 at) { return shadowTaps(lampShadowMaps, at, layer, 1.0 / float(LAMP_SHADOW_SIDE)); }

float inCube(int i, vec3 position, vec3 normal) {
    vec3 from = position - lamps.lights[i].place;
    float texel = 2.0 * cubePlace(from).depth / (LAMP_SHADOW_SHARE * float(LAMP_SHADOW_SIDE));
    float facing = clamp(-dot(normal, from) / max(length(from), 1e-6), 0.0, 1.0);
    CubePlace c = cubePlace(from + normal * (texel * shadowRaise(facing)));
    return lampTaps(float(LAMP_MAPS * i) + c.face, vec3(c.at, LAMP_SHADOW_NEAR / c.depth));
}

float inCascade(int i, int map, vec3 position, vec3 normal) {
    ShadowCascade cascade = lampShadow.lamps[i].cascades[map];
    float facing = clamp(dot(normal, lamps.lights[i].place), 0.0, 1.0);
    vec3 p = position + normal * (cascade.texel * shadowRaise(facing));
    return lampTaps(float(LAMP_MAPS * i + map), (cascade.toMap * vec4(p, 1.0)).xyz);
}
// The finest map that reaches there, blended into the next over its last tenth; light beyond the last.
float inCascades(int i, vec3 position, vec3 normal) {
    float distance = length(position);
    int map = 0;
    while (map < LAMP_MAPS && distance > lampShadow.lamps[i].cascades[map].reach) ++map;
    if (map == LAMP_MAPS) return 1.0;
    float share = smoothstep(0.9, 1.0, distance / lampShadow.lamps[i].cascades[map].reach);
    float here = inCascade(i, map, position, normal);
    if (share <= 0.0) return here;
    return mix(here, map + 1 < LAMP_MAPS ? inCascade(i, map + 1, position, normal) : 1.0, share);
}

// Of lamp i, at a position relative to the eye; normal: unit, of the surface there, or 0 on what is in no shadow map
// itself (ground, grass) and so needs no distance from its own shadow.
float lampVisible(int i, vec3 position, vec3 normal) {
    if (!(LAMP_SHADOWS || LAMP_HILLS) || i >= castingLamps()) return 1.0;
    float share = 1.0;
    if (LAMP_SHADOWS)
        share = lamps.lights[i].isPoint > 0.0 ? inCube(i, position, normal) : inCascades(i, position, normal);
    if (LAMP_HILLS && share > 0.0) share *= lampPastHills(i, position);
    return share;
}
// What comes of it: lampAt where nothing stands in the way.
LampHere lampReaching(int i, vec3 at, vec3 normal) {
    LampHere here = lampAt(i, at);
    here.light *= lampVisible(i, at, normal);
    return here;
}
