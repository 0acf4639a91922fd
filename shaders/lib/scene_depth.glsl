// Depth of a pixel of the scene: of its first sample. Needs: const bool MULTISAMPLED.
#include "shared/bindings.h"

layout(binding = TEX_DEPTH) uniform sampler2D depthPlain;
layout(binding = TEX_DEPTH_SAMPLES) uniform sampler2DMS depthSamples;

float sceneDepth(ivec2 pixel) {
    return MULTISAMPLED ? texelFetch(depthSamples, pixel, 0).r : texelFetch(depthPlain, pixel, 0).r;
}
