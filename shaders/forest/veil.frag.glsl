// Lays what slices have added up to over the scene, but for samples that lie before the nearest slice.
#include "shared/bindings.h"

layout(binding = TEX_FOREST_VEIL) uniform sampler2D veil;
layout(binding = TEX_FOREST_NEAREST) uniform sampler2D nearest;

out vec4 color;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    color = texelFetch(veil, pixel, 0);
    gl_FragDepth = texelFetch(nearest, pixel, 0).r;
}
