// Painted maps that say how grass stands and looks.
// Needs: const bool GRASS_ORIENTATION, FAR_DARKENING.
#include "lib/density.glsl"
#include "numerics/blur.h"
#include "numerics/population.h"
#include "shared/bindings.h"

layout(binding = TEX_ORIENTATION) uniform sampler2D orientationMap;
layout(binding = TEX_VEGETATION) uniform sampler2D vegetationMap;

// What grass at a distance keeps of its light.
float darkened(float distance) {
    return FAR_DARKENING ? farLight(distance, field.farDarkening, field.farDarkeningAt) : 1.0;
}

// Painted direction (x, z), its length the strength in [0, 1]; 0 where nothing is painted. In fragments, the mean over
// the pixel.
vec2 paintedLean(vec2 uv) {
    if (!GRASS_ORIENTATION) return vec2(0.0);
    vec2 texel = texture(orientationMap, uv * field.orientationTiling).rg;
    return paintOf(texel.x, texel.y);
}
