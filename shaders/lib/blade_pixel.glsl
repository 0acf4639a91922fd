// A fragment of a blade: what its vertices were lit with, its mask, its texture, and how it covers its pixel. Fragment
// shaders only. Needs: const bool SUN, BLADE_SHADOWS, CASTING_LIGHTS, TRANSLUCENCY, GLOSS, TEMPORAL; const int
// TRANSPARENCY.
#include "lib/frame.glsl"
#include "lib/mask.glsl"
#include "lib/motion.glsl"
#include "lib/sliver.glsl"
#include "lib/species.glsl"
#include "lib/transparency.glsl"
#include "numerics/leaf.h"
#include "shared/bindings.h"
#include "shared/tess.h"

layout(binding = TEX_BLADE) uniform sampler2D bladeTexture;

centroid in vec4 lit;
centroid in vec4 sunned;
centroid in vec2 sunward;
centroid in vec3 maskAt;
centroid in vec3 strip;
flat in uint grain;
in vec3 moved;
layout(location = 0) out vec4 color;

// What the blade sends of the sun's light.
vec3 sunSent() {
    float facing = clamp(sunward.x, -1.0, 1.0);  // on slivers what is interpolated runs out of them
    vec3 sent = leafSent(sunned.rgb, facing, TRANSLUCENCY ? species.translucency : 0.0);
    if (GLOSS) sent += frame.sunLight * sunward.y;
    if (frame.sunCasts > 0.0) sent *= maskLight(maskAt, sunned.w);
    return sent;
}
// t: the texture's colour there; alpha: of what is written.
vec4 bladePixel(vec4 t, float alpha) {
    tellMotion(moved);
    vec3 light = lit.rgb;
    if (SUN && BLADE_SHADOWS && CASTING_LIGHTS) light += sunSent();
    vec4 c = vec4(clamp(light * mix(t.rgb * 2.0, vec3(1.0), lit.w), vec3(0.0), vec3(kBrightest)), alpha);
    if (viewMode() == VIEW_TIERS) c.rgb = vec3(0.85, 0.05, 0.03) * (0.4 + 0.6 * strip.y);
    if (viewMode() == VIEW_NORMALS) c.rgb = lit.rgb;
    if (viewMode() == VIEW_OVERDRAW) c = vec4(1.0 / 32.0, 0.0, 0.0, 0.0);
    if (viewMode() == VIEW_DENSITY) c.rgb = mix(vec3(0.1, 0.4, 0.1), vec3(0.1, 0.9, 0.2), strip.y);
    return c;
}
// t: the texture's colour and alpha there.
void drawBlade(vec4 t) {
    float alpha = coveredAlpha(TRANSPARENCY, t.a * strip.z, grain & ~PLAIN_BLADE);
    if (!(alpha > 0.0) || !lies(strip.xy)) discard;
    color = bladePixel(t, alpha);
}
