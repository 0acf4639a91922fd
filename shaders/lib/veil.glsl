// The picture in which a forest's slices add up (forest/veil.h). Needs: const bool MULTISAMPLED.
#include "shared/bindings.h"

layout(binding = TEX_FOREST_VEIL) uniform sampler2D veilPlain;
layout(binding = TEX_FOREST_VEIL_SAMPLES) uniform sampler2DMS veilSamples;

vec4 veilAt(ivec2 pixel, int number) {
    return MULTISAMPLED ? texelFetch(veilSamples, pixel, number) : texelFetch(veilPlain, pixel, 0);
}
