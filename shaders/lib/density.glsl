// Painted maps that the ground reads too: how much grows, and how much of the sky it sees. Needs: const bool GRASS_OCCLUSION; frame.glsl.
layout(std140, binding = UBO_COVER) uniform CoverBlock { CoverGlobals cover; };
layout(binding = TEX_DENSITY) uniform sampler2D densityMap[MAX_SPECIES];
layout(binding = TEX_OCCLUSION) uniform sampler2D occlusionMap;

float skyShare(vec2 uv) {
    if (!GRASS_OCCLUSION) return 1.0;
    return textureLod(occlusionMap, uv * cover.tiling.z, 0.0).r;
}
