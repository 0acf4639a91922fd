// One direction of the blur of what is far (numerics/blur.h).
#include "lib/frame.glsl"
#include "numerics/glsl.h"
#include "numerics/basics.h"
#include "numerics/blur.h"
#include "lib/scene_depth.glsl"
layout(binding = TEX_SCENE) uniform sampler2D scene;
layout(location = 0) uniform ivec2 along;
layout(location = 1) uniform float reach;
out vec4 color;

const float kNear = 0.05;  // metres: the near plane, so that distance = near / depth

float shareAt(ivec2 pixel) {
    float depth = sceneDepth(clamp(pixel, ivec2(0), ivec2(frame.pixels) - 1));
    return depth > 0.0 ? farShare(kNear / depth, reach) : 1.0;
}
vec3 lightAt(vec2 pixel) {
    vec3 c = textureLod(scene, pixel * frame.pixelShare, 0.0).rgb;
    return all(lessThan(abs(c), vec3(kBrightest * 2.0))) ? c : vec3(0.0);  // false for NaN
}

void main() {
    vec2 at = gl_FragCoord.xy;
    ivec2 pixel = ivec2(at);
    float share = shareAt(pixel);
    vec3 w = blurWeights(share, GAUSSIAN);
    vec3 sum = lightAt(at) * w.x;
    float total = w.x;
    for (int side = -1; side <= 1; side += 2) {
        for (int tap = 0; tap < 2; ++tap) {
            float offset = tap == 0 ? 1.5 : 3.0;
            ivec2 there = pixel + along * int(float(side) * (tap == 0 ? 2.0 : 3.0));
            float weight = (tap == 0 ? w.y : w.z) * shareAt(there);
            sum += lightAt(at + vec2(along) * (float(side) * offset)) * weight;
            total += weight;
        }
    }
    color = vec4(sum / total, 1.0);
}
