// A texel of a vertical slice: whether its blade is drawn here (density, distance, family), and how it is lit:
// reflectance times the light of each image (Boulanger, Pattanaik and Bouatouch 2006, sections 3.3, 3.4, 4.2).
#include "lib/frame.glsl"
#include "lib/motion.glsl"
#include "lib/shadow.glsl"
#include "lib/slice_light.glsl"
#include "lib/sliver.glsl"
#include "lib/slices.glsl"
#include "lib/transparency.glsl"
#include "numerics/hash.h"
#include "numerics/opacity.h"

centroid in vec3 texel;
in vec2 unmoved;
in vec3 foot;
flat in vec4 images;
flat in vec4 axes;
flat in float lightLayer;
flat in float chance;
in vec3 gain;
in vec3 brighter;
in vec4 lamp[3];
in vec3 ambient;
in vec4 haze;
in vec3 moved;
in vec2 weights;
in float high;  // lookHeight of the view
layout(location = 0) out vec4 color;
float level;  // of detail
float fine;   // of what is lit: a mean of normals has less contrast than blades; opacity is a mean

// A random number fixed to the slice: it moves with it, and its grains are about a pixel.
uint grain(float level) {
    vec2 size = vec2(textureSize(sliceThreshold, 0).xy) * exp2(-floor(level));
    ivec2 at = ivec2(texel.xy * size);
    return hash2(uint(at.x) + 2048u * uint(at.y), uint(texel.z + 0.5) + 64u * uint(level));
}

SliceSpot spotHere() {
    SliceSpot s;
    s.texel = texel;
    vec3 at = foot + vec3(0.0, texel.y * slices.top, 0.0);
    s.visible = sunVisible(at, vec3(0.0));
    s.images = images;
    s.lightLayer = lightLayer;
    float even = sliceLevel(fine, high);
    s.gain = gain * even, s.brighter = brighter, s.ambient = ambient * even;
    s.lamp = lamp;
    if (LAMPS && WEIGHTS_PER_PIXEL) lampsOnImages(at, axes, kLevel, kOnGround, s.lamp);
    s.fine = fine;
    return s;
}

void main() {
    level = max(textureQueryLod(sliceThreshold, unmoved).y + log2(slices.sharpness), 0.0);
    fine = max(level - 1.5, 0.0);
    vec4 stored = textureLod(sliceThreshold, texel, level);
    vec2 uv = mapPlace(foot.xz + frame.eye.xz);
    float density = sliceDensity(fieldDensity(uv), weights.x) * weights.y;
    float alpha = coveredAlpha(TRANSPARENCY, storedOpacity(stored, density, level, chance), grain(level));
    if (!(alpha > 0.0) || !lies(vec2(0.5 * texel.x, texel.y))) discard;
    tellMotion(moved);
    vec4 leaf = textureLod(sliceReflectance, texel, fine);
    leaf.rgb = paintedOver(leaf.rgb, uv, unitOr(-foot, 1e-6, vec3(0.0, 1.0, 0.0)));
    vec3 light = clamp(sliceRadiance(spotHere(), leaf.rgb, leaf.a, stored), vec3(0.0), vec3(kBrightest));
    color = vec4(light * haze.w + haze.rgb, alpha);
    if (viewMode() == VIEW_TIERS) color.rgb = vec3(0.05, 0.15, 0.9) * (0.4 + 0.6 * texel.y);
    if (viewMode() == VIEW_NORMALS) color.rgb = vec3(0.5, 0.5, 1.0);
    if (viewMode() == VIEW_OVERDRAW) color = vec4(1.0 / 32.0, 0.0, 0.0, 0.0);
    if (viewMode() == VIEW_DENSITY) color.rgb = mix(vec3(0.1, 0.4, 0.1), vec3(0.1, 0.9, 0.2), texel.y);
}
