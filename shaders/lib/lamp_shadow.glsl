// How much of a lamp's light reaches a point past objects and hills. Needs: const bool LAMPS, LAMP_SHADOWS, LAMP_HILLS.
// Objects: what each lamp sees (objects/lamp_shadow.h). Hills: how high one must stand to see it
// (terrain/lamp_hills.h).
#include "lib/frame.glsl"
#include "lib/lamp_hills.glsl"
#include "lib/lamps.glsl"
#include "lib/shadow_taps.glsl"
#include "shared/bindings.h"
#include "shared/objects.h"

layout(std140, binding = UBO_LAMP_SHADOW) uniform LampShadowBlock { LampShadowGlobals lampShadow; };
layout(binding = TEX_LAMP_SHADOW) uniform sampler2DArrayShadow lampShadowMaps;

// Where a point that lies so from the lamp is in the cube around it: axis and face, place in it, metres along its axis.
struct CubePlace {
    int axis;
    float face, depth;
    vec2 at;
};
CubePlace cubePlace(vec3 from) {
    vec3 size = abs(from);
    CubePlace c;
    c.axis = size.x >= max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
    vec2 across = c.axis == 0 ? from.zy : c.axis == 1 ? from.xz : from.xy;
    c.depth = max(size[c.axis], LAMP_SHADOW_NEAR);
    c.face = float(2 * c.axis + (from[c.axis] < 0.0 ? 1 : 0));
    c.at = 0.5 + 0.5 * LAMP_SHADOW_SHARE * across / c.depth;
    return c;
}

// Share of light by the four texels around a place (z: depth) in a layer, of a surface whose depth changes by `slope`
// across the map: each is compared with what the surface has in that texel's middle, so that none shades itself.
float lampTexels(float layer, vec3 at, vec2 slope) {
    vec2 p = at.xy * float(LAMP_SHADOW_SIDE) - 0.5, low = floor(p), share = p - low;
    vec4 left;
    for (int k = 0; k < 4; ++k) {
        vec2 middle = (low + vec2(k & 1, k >> 1) + 0.5) / float(LAMP_SHADOW_SIDE);
        left[k] = texture(lampShadowMaps, vec4(middle, layer, max(at.z + dot(slope, middle - at.xy), 0.0)));
    }
    vec2 sides = mix(left.xz, left.yw, share.x);
    return mix(sides.x, sides.y, share.y);
}
// What is in no map: softer, by its own depth alone.
float lampTaps(float layer, vec3 at) { return shadowTaps(lampShadowMaps, at, layer, 1.0 / float(LAMP_SHADOW_SIDE)); }

float inCube(int i, vec3 position, vec3 normal) {
    vec3 from = position - lamps.lights[i].place;
    CubePlace c = cubePlace(from);
    float layer = float(LAMP_MAPS * i);
    if (normal == vec3(0.0)) return lampTaps(layer + c.face, vec3(c.at, LAMP_SHADOW_NEAR / c.depth));
    from += normal * (2.0 * c.depth / (LAMP_SHADOW_SHARE * float(LAMP_SHADOW_SIDE)));
    c = cubePlace(from);
    vec2 across = c.axis == 0 ? normal.zy : c.axis == 1 ? normal.xz : normal.xy;
    float away = min(dot(normal, from), -1e-3 * c.depth);
    return lampTexels(layer + c.face, vec3(c.at, LAMP_SHADOW_NEAR / c.depth),
                      across * (2.0 / LAMP_SHADOW_SHARE * LAMP_SHADOW_NEAR / away));
}

float inCascade(int i, int map, vec3 position, vec3 normal) {
    ShadowCascade cascade = lampShadow.lamps[i].cascades[map];
    vec3 at = (cascade.toMap * vec4(position + normal * cascade.texel, 1.0)).xyz;
    float layer = float(LAMP_MAPS * i + map);
    if (normal == vec3(0.0)) return lampTaps(layer, at);
    // Of the normal along the map's axes, each a map's width long.
    mat3 rows = transpose(mat3(cascade.toMap));
    vec3 n = vec3(dot(normal, rows[0]) / dot(rows[0], rows[0]), dot(normal, rows[1]) / dot(rows[1], rows[1]),
                  dot(normal, rows[2]) / dot(rows[2], rows[2]));
    return lampTexels(layer, at, -n.xy / max(n.z, 1e-3 * inversesqrt(dot(rows[2], rows[2]))));
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

// Of lamp i, at a position relative to the eye. normal: of the surface there, as long as it is to be raised against its
// own shadow, in texels (1 for facets under smooth normals); 0 on what is in no shadow map itself (ground, grass).
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
// Diffuse light of all lamps on a surface that faces n, unit; normal: as lampVisible has it.
vec3 lampLight(vec3 at, vec3 n, vec3 normal) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < lampCount(); ++i) {
        LampHere l = lampAt(i, at);
        float facing = dot(n, l.direction);
        if (facing > 0.0) sum += l.light * (facing * lampVisible(i, at, normal));
    }
    return min(sum, vec3(kBrightest));
}
