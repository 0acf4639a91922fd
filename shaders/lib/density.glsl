// Painted maps that the ground reads too: how much grows, how high, and how much of the sky it sees. Needs: const bool
// GRASS_OCCLUSION, GRASS_HEIGHTS. uv: of mapPlace.
#include "lib/frame.glsl"
#include "shared/bindings.h"
#include "shared/grass.h"

layout(std140, binding = UBO_FIELD) uniform FieldBlock { FieldGlobals field; };
layout(binding = TEX_DENSITY) uniform sampler2D densityMap;
layout(binding = TEX_BLADE_HEIGHT) uniform sampler2D bladeHeightMap;
layout(binding = TEX_OCCLUSION) uniform sampler2D occlusionMap;

// Share of their height that blades rooted here have.
float bladeShare(vec2 uv) {
    if (!GRASS_HEIGHTS) return 1.0;
    return textureLod(bladeHeightMap, tiled(uv, field.heightTiling), 0.0).r;
}

float skyShare(vec2 uv) {
    if (!GRASS_OCCLUSION) return 1.0;
    return textureLod(occlusionMap, uv * field.occlusionTiling, 0.0).r;
}
