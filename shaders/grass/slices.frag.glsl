// A texel of a vertical slice: whether its blade is drawn here (density, distance, family), and how it is lit:
// reflectance times the light of each image (Boulanger, Pattanaik and Bouatouch 2006, sections 3.3, 3.4, 4.2).
#include "lib/frame.glsl"
#include "numerics/glsl.h"
#include "numerics/basics.h"
#include "numerics/hash.h"
#include "numerics/bilinear.h"
#include "numerics/lod.h"
#include "numerics/opacity.h"
#include "numerics/weights.h"
#include "numerics/leaf.h"
#include "lib/light.glsl"
#include "lib/lamps.glsl"
#include "lib/shadow.glsl"
#include "lib/cover.glsl"
#include "lib/slices.glsl"
#include "lib/transparency.glsl"

in vec3 texel;
in vec3 foot;
flat in vec4 images;
flat in vec4 axes;
flat in float lightLayer;
in vec3 gain;
in vec3 brighter;
in vec4 lamp[3];
in vec3 ambient;
in vec4 haze;
in vec2 weights;
out vec4 color;
float level;  // of detail
float fine;   // of what is lit: a mean of normals has less contrast than blades; opacity is a mean

// A random number fixed to the slice: it moves with it, and its grains are about a pixel.
uint grain(float level) {
    vec2 size = vec2(textureSize(sliceThreshold, 0).xy) * exp2(-floor(level));
    ivec2 at = ivec2(texel.xy * size);
    return hash2(uint(at.x) + 2048u * uint(at.y), uint(texel.z + 0.5) + 64u * uint(level));
}

// Lamps on the images: facing, side +, side -, above.
vec3 lampsSend(vec3 reflectance, vec4 lit, float above) {
    if (!LAMPS) return vec3(0.0);
    vec4 sum[3] = lamp;
    if (WEIGHTS_PER_PIXEL) lampsOn(foot + vec3(0.0, texel.y * slices.top, 0.0), axes, sum);
    vec4 numbers = vec4(lit.xzw, above);
    return reflectance * brighter * vec3(dot(sum[0], numbers), dot(sum[1], numbers), dot(sum[2], numbers));
}

vec3 radiance(vec3 reflectance, float open, vec4 stored) {
    bool front = !(lightLayer > 0.0);
    float visible = sunVisible(foot + vec3(0.0, texel.y * slices.top, 0.0), vec3(0.0));
    float above = front ? stored.z : stored.w, below = front ? stored.w : stored.z;
    vec3 light = ambient * reflectance * open;
    if (STORAGE == FULL_STORAGE) {
        float layers = float(textureSize(sliceReflectance, 0).z), first = texel.z + (front ? 0.0 : 5.0 * layers);
        vec3 sum = vec3(0.0);
        for (int i = 0; i < 4; ++i) {  // facing, side +, side -, above: images 0, 2, 3, 4
            float image = i == 0 ? 0.0 : float(i + 1);
            vec3 weight = vec3(images[i]) * gain * visible;
            if (LAMPS) weight += brighter * vec3(lamp[0][i], lamp[1][i], lamp[2][i]);
            sum += weight * textureLod(sliceLight, vec3(texel.xy, first + image * layers), fine).rgb;
        }
        return light + sum;
    }
    vec4 lit = textureLod(sliceLight, vec3(texel.xy, texel.z + lightLayer), fine);
    vec2 sun = LIGHT_COSINE ? cosineOf(vec3(lit.x, lit.z, above), vec3(0.0, lit.w, below), images.xyz)
                            : vec2(dot(images, vec4(lit.xzw, above)),
                                   dot(images, vec4(0.0, lit.wz, below)) + (1.0 - dot(images, vec4(1.0))) * lit.x);
    return light + leavesSend(reflectance, sun) * gain * visible + lampsSend(reflectance, lit, above);
}

void main() {
    level = max(textureQueryLod(sliceThreshold, texel.xy).y + log2(slices.sharpness), 0.0);
    fine = max(level - 1.5, 0.0);
    vec4 stored = textureLod(sliceThreshold, texel, level);
    vec2 uv = mapPlace(foot.xz + frame.eye.xz);
    float density = sliceDensity(fieldDensity(uv), weights.x) * weights.y;
    float alpha = coveredAlpha(texelOpacity(stored.x, stored.y, density, slices.fade, level), grain(level));
    if (!(alpha > 0.0)) discard;
    vec4 leaf = textureLod(sliceReflectance, texel, fine);
    leaf.rgb = paintedOver(leaf.rgb, uv);
    vec3 light = clamp(radiance(leaf.rgb, leaf.a, stored), vec3(0.0), vec3(kBrightest));
    color = vec4(light * haze.w + haze.rgb, alpha);
    if (viewMode() == VIEW_TIERS) color.rgb = vec3(0.05, 0.15, 0.9) * (0.4 + 0.6 * texel.y);
    if (viewMode() == VIEW_NORMALS) color.rgb = vec3(0.5, 0.5, 1.0);
    if (viewMode() == VIEW_OVERDRAW) color = vec4(1.0 / 32.0, 0.0, 0.0, 0.0);
    if (viewMode() == VIEW_DENSITY) color.rgb = mix(vec3(0.1, 0.4, 0.1), vec3(0.1, 0.9, 0.2), texel.y);
}
