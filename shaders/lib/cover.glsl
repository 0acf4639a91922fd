// Painted maps that say how grass stands and looks.
// Needs: const bool GRASS_ORIENTATION, GRASS_VEGETATION; frame.glsl.
#include "lib/density.glsl"
layout(binding = TEX_ORIENTATION) uniform sampler2D orientationMap;
layout(binding = TEX_VEGETATION) uniform sampler2D vegetationMap;

// Painted direction (x, z), its length the strength in [0, 1]; 0 where nothing is painted. In fragments, the mean over the pixel.
vec2 paintedLean(vec2 uv) {
    if (!GRASS_ORIENTATION) return vec2(0.0);
    vec2 d = (texture(orientationMap, uv * cover.tiling.x).rg - 0.5) * 2.0;
    float l = length(d);
    return l < 1.0 / 255.0 ? vec2(0.0) : d / max(l, 1.0);
}
