// Shares of the light of sun, sky and ground that a forest's air lets through, by its volume (forest/texcells.h).
// Fragments only.
#include "shared/bindings.h"
#include "shared/forest.h"

layout(std140, binding = UBO_FOREST) uniform ForestBlock { ForestGlobals forest; };
layout(binding = TEX_FOREST_LIGHT) uniform sampler2DArray lightImage;

// uv: lattice coordinates as stored, a share of the cells that repeat; at: share of the forest's height.
vec3 lightShares(vec2 uv, float at) {
    float part = clamp(at * forest.lightSlabs - 0.5, 0.0, forest.lightSlabs - 1.0);
    float low = floor(part);
    return mix(textureLod(lightImage, vec3(uv, low), 0.0).rgb,
               textureLod(lightImage, vec3(uv, min(low + 1.0, forest.lightSlabs - 1.0)), 0.0).rgb, part - low);
}
