// Painted maps that say how much grows. Needs: frame.glsl.
layout(std140, binding = UBO_COVER) uniform CoverBlock { CoverGlobals cover; };
layout(binding = TEX_DENSITY) uniform sampler2D densityMap[MAX_SPECIES];
