// How much of the sun reaches a point past objects, hills and far trees. Needs: const bool OBJECT_SHADOWS,
// TERRAIN_SHADOWS, FOREST_VOLUMES.
// Objects: shadow maps around the eye (objects/shadow.h). Hills: below which height the sun is hidden
// (terrain/shade.h). Trees that are drawn as volumes: what they leave of the light on the ground
// (forest/shade_map.h).
#include "lib/frame.glsl"
#include "lib/shadow_taps.glsl"
#include "shared/bindings.h"
#include "shared/objects.h"

layout(std140, binding = UBO_SHADOW) uniform ShadowBlock { ShadowGlobals shadow; };
layout(binding = TEX_SHADOW) uniform sampler2DArrayShadow shadowMap;
layout(binding = TEX_SHADE) uniform sampler2D shadeMap;
layout(binding = TEX_FOREST_SHADE) uniform sampler2D forestShade;

// Share of light past objects by one map.
float sunInMap(int map, vec3 position, vec3 normal) {
    float texel = shadow.cascades[map].texel;
    float facing = clamp(dot(normal, frame.sunDirection), 0.0, 1.0);
    vec3 p = position + normal * (texel * shadowRaise(facing));
    return shadowTaps(shadowMap, (shadow.cascades[map].toMap * vec4(p, 1.0)).xyz, float(map), shadow.texelShare);
}

// The finest map that reaches there, blended into the next over its last tenth; light beyond the last.
float sunPastObjects(vec3 position, vec3 normal) {
    float distance = length(position);
    int map = 0;
    while (map < SHADOW_CASCADES && distance > shadow.cascades[map].reach) ++map;
    if (map == SHADOW_CASCADES) return 1.0;
    float share = smoothstep(0.9, 1.0, distance / shadow.cascades[map].reach);
    float here = sunInMap(map, position, normal);
    if (share <= 0.0) return here;
    return mix(here, map + 1 < SHADOW_CASCADES ? sunInMap(map + 1, position, normal) : 1.0, share);
}

// Soft over a quarter of what the sun's ray falls from texel to texel.
float sunPastHills(vec3 position) {
    vec3 at = position + frame.eye;
    float above = at.y - textureLod(shadeMap, at.xz * frame.terrainShare, 0.0).r;
    vec2 across = frame.sunDirection.xz;
    float cell = frame.terrainSize.x / float(textureSize(shadeMap, 0).x);
    float soft = 0.02 + 0.25 * cell * frame.sunDirection.y / max(length(across), 0.01);
    return smoothstep(-soft, 0.0, above);
}

// 1: in the sun; 0: in shadow. position: relative to the eye; normal: unit, of the surface there, or 0 on what is in no
// shadow map itself (ground, grass) and so needs no distance from its own shadow.
float sunPastMeshes(vec3 position, vec3 normal) {
    if (frame.sunIsUp <= 0.0) return 1.0;
    float share = 1.0;
    if (OBJECT_SHADOWS) share = sunPastObjects(position, normal);
    if (TERRAIN_SHADOWS) share *= sunPastHills(position);
    return share;
}

// What trees leave of the sun's light and of the sky's on the ground, and of the sky's on what stands upright there; of
// the sun's, trees that are meshes in shadow maps count as well.
vec3 pastTrees(vec3 position) {
    vec2 at = (position.xz + frame.eye.xz) * frame.terrainShare;
    // Texels that a pixel covers there; the way up the picture is what the projection's second row measures.
    vec3 up = vec3(frame.viewProj[0].y, frame.viewProj[1].y, frame.viewProj[2].y);
    vec2 texels = length(position) * 2.0 * frame.pixelShare.y / length(up) * frame.terrainShare *
                  vec2(textureSize(forestShade, 0));
    return textureLod(forestShade, at, log2(max(max(texels.x, texels.y), 1.0))).rgb;
}
// What trees leave of the sun's light where they are not meshes, which are in shadow maps.
float sunPastTrees(vec3 position) {
    return mix(1.0, pastTrees(position).r, smoothstep(frame.treesShadeFrom, frame.treesShadeTo, length(position)));
}
// What they leave of the sky's, near and far.
float skyPastTrees(vec3 position) { return FOREST_VOLUMES ? pastTrees(position).g : 1.0; }
float skyOnGrassPastTrees(vec3 position) { return FOREST_VOLUMES ? pastTrees(position).b : 1.0; }
float sunVisible(vec3 position, vec3 normal) {
    if (frame.sunIsUp <= 0.0) return 1.0;
    float share = sunPastMeshes(position, normal);
    if (FOREST_VOLUMES) share *= sunPastTrees(position);
    return share;
}
