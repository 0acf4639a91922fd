// A fragment of a flower: its image, coloured, in the light of its corners; covers its pixel as blades do.
#include "lib/frame.glsl"
#include "lib/light.glsl"
#include "lib/motion.glsl"
#include "lib/sliver.glsl"
#include "lib/transparency.glsl"
#include "numerics/flower.h"
#include "shared/bindings.h"
#include "shared/flowers.h"

layout(std140, binding = UBO_FLOWERS) uniform FlowerBlock { FlowerGlobals flowers; };
layout(binding = TEX_BLADE) uniform sampler2D image;

in vec2 uv;
in vec4 lit;
in vec3 shown;
flat in vec3 petal;
flat in uint grain;
in vec3 moved;
layout(location = 0) out vec4 color;

void main() {
    vec4 t = texture(image, uv);
    float alpha = coveredAlpha(COVERAGE, t.a, grain);
    if (!(alpha > 0.0) || !lies(uv)) discard;
    tellMotion(moved);
    vec3 light = flowerColor(t.rgb, petal, flowers.center, flowers.stem, flowers.made != 0) * lit.rgb;
    vec2 way = (gl_FragCoord.xy * frame.pixelShare * 2.0 - 1.0);
    vec4 there = frame.invViewProj * vec4(way, 1.0, 1.0);
    light = mix(light, horizonColor(there.xz / there.w), lit.w);
    color = vec4(clamp(light, vec3(0.0), vec3(kBrightest)), 1.0);
    if (viewMode() == VIEW_TIERS) color.rgb = vec3(0.9, 0.8, 0.1);
    if (viewMode() == VIEW_NORMALS) color.rgb = shown * 0.5 + 0.5;
    if (viewMode() == VIEW_OVERDRAW) color = vec4(1.0 / 32.0, 0.0, 0.0, 0.0);
    if (viewMode() == VIEW_DENSITY) color.rgb = vec3(0.9, 0.8, 0.1);
}
