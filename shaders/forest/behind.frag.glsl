// The depth up to which a pixel shows slices: of the scene's farthest sample. Needs: const bool MULTISAMPLED.
#include "lib/frame.glsl"
#include "shared/bindings.h"

layout(binding = TEX_DEPTH) uniform sampler2D depthPlain;
layout(binding = TEX_DEPTH_SAMPLES) uniform sampler2DMS depthSamples;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (MULTISAMPLED) {
        float farthest = 1.0;
        for (int i = 0; i < frame.samples; ++i) farthest = min(farthest, texelFetch(depthSamples, pixel, i).r);
        gl_FragDepth = farthest;
    } else {
        gl_FragDepth = texelFetch(depthPlain, pixel, 0).r;
    }
}
