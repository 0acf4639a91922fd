// Shares of the light of sun, sky and ground that a forest's air lets through, by its volume (forest/texcells.h).
// Fragments only.
#include "shared/bindings.h"
#include "shared/forest.h"

layout(std140, binding = UBO_FOREST) uniform ForestBlock { ForestGlobals forest; };
layout(binding = TEX_FOREST_LIGHT) uniform sampler3D lightImage;

// uv: lattice coordinates as stored, a share of the cells that repeat; at: share of the forest's height. Of the sun, of
// the sky, of the ground; and of the sun past the crown's own leaves alone. rise: of FOREST_RISES, by the ground's
// slope.
vec4 lightShares(vec2 uv, float at, int rise) {
    float layers = float(textureSize(lightImage, 0).z / FOREST_RISES);
    float layer = float(rise) * layers + clamp(at * layers, 0.5, layers - 0.5);
    return textureLod(lightImage, vec3(uv, layer / (layers * float(FOREST_RISES))), 0.0);
}

// A probability (0 to 1) whose odds are so many times (more than 0) as great.
float oddsTimes(float probability, float times) { return probability * times / (1.0 + probability * (times - 1.0)); }
