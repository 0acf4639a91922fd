// Ground under a point. Needs: const bool TERRAIN_HEIGHTS, TERRAIN_BEYOND.
#include "lib/frame.glsl"
#include "numerics/bilinear.h"
#include "numerics/land.h"
#include "shared/bindings.h"

layout(binding = TEX_HEIGHT) uniform sampler2D heightMap;

// Height relative to the eye at terrain-relative metres. A height map that repeats is mirrored from repeat to repeat
// (scene/tiling.h).
float groundHeight(vec2 place) {
    if (!TERRAIN_HEIGHTS) return frame.groundBase;
    ivec2 size = textureSize(heightMap, 0);
    vec2 uv = place * frame.terrainShare;
    if (frame.heightTiling > 0.0)
        uv = vec2(mirrorUnit(place.x * frame.mapShare.x * frame.heightTiling),
                  mirrorUnit(place.y * frame.mapShare.y * frame.heightTiling));
    BilinearTap t = bilinearTap(uv.x, uv.y, size.x, size.y);
    float base = frame.groundTexel;
    float h = bilinearMix(texelFetch(heightMap, ivec2(t.x0, t.y0), 0).r - base,
                          texelFetch(heightMap, ivec2(t.x1, t.y0), 0).r - base,
                          texelFetch(heightMap, ivec2(t.x0, t.y1), 0).r - base,
                          texelFetch(heightMap, ivec2(t.x1, t.y1), 0).r - base, t.fx, t.fy);
    float height = frame.groundBase + frame.groundScale * h;
    if (!TERRAIN_BEYOND || frame.heightTiling > 0.0) return height;
    return mix(height, frame.landLevel, landMean(beyondBy(place, frame.terrainSize), frame.landFade));
}

// Steps along x and z (m) over which the ground's slope is taken: at least a texel of its map.
vec2 slopeSteps(float step) {
    vec2 repeat = frame.heightTiling > 0.0 ? vec2(1.0) / (frame.mapShare * frame.heightTiling) : frame.terrainSize;
    return max(vec2(step), repeat / vec2(textureSize(heightMap, 0)));
}
// Rise of the ground a metre along x and z, over `step` metres from a place whose height is known; 0 on flat ground.
vec2 groundSlope(vec2 place, float height, float step) {
    if (!TERRAIN_HEIGHTS) return vec2(0.0);
    vec2 d = slopeSteps(step);
    return vec2(groundHeight(place + vec2(d.x, 0.0)) - height, groundHeight(place + vec2(0.0, d.y)) - height) / d;
}
// Upward unit normal by central differences over `step` metres; exactly up on flat ground (T-5).
vec3 groundNormal(vec2 place, float step) {
    if (!TERRAIN_HEIGHTS) return vec3(0.0, 1.0, 0.0);
    vec2 d = slopeSteps(step);
    float dx = groundHeight(place + vec2(d.x, 0.0)) - groundHeight(place - vec2(d.x, 0.0));
    float dz = groundHeight(place + vec2(0.0, d.y)) - groundHeight(place - vec2(0.0, d.y));
    return normalize(vec3(-dx / (2.0 * d.x), 1.0, -dz / (2.0 * d.y)));
}
