// What grows on the ground under a fragment, over all fields: the share of light that it leaves to the soil. Needs: const
// bool GRASS, GRASS_DENSITY, GRASS_HEIGHTS, GRASS_OCCLUSION; the numbers that the program is compiled with (grass/field.cpp,
// soilText): how many fields and species there are, and by each which of soilMap it reads, -1 none; ground_light.glsl.
#include "shared/soil.h"
layout(std140, binding = UBO_SOIL) uniform SoilBlock { SoilGlobals soilCover; };
layout(binding = TEX_SOIL) uniform sampler2D soilMap[MAX_SOIL_MAPS];

// The density of a species, filtered for the pixel.
float soilDensity(int species, vec2 uv) {
    if (!GRASS_DENSITY || SOIL_DENSITY[species] < 0) return 1.0;
    return texture(soilMap[SOIL_DENSITY[species]], tiled(uv, soilCover.species[species].tiling)).r;
}

// What one field leaves. grown: adds how dense its species are; sky: becomes what its map says, where that is less.
SoilShares soilUnderField(int field, vec2 uv, float distance, inout float grown, inout float sky) {
    SoilField f = soilCover.fields[field];
    float left = 1.0, tall = 1.0;
    if (GRASS_HEIGHTS && SOIL_HEIGHT[field] >= 0) tall = texture(soilMap[SOIL_HEIGHT[field]], tiled(uv, f.heightTiling)).r;
    if (GRASS_OCCLUSION && SOIL_OCCLUSION[field] >= 0)
        sky = min(sky, textureLod(soilMap[SOIL_OCCLUSION[field]], uv * f.occlusionTiling, 0.0).r);
    for (int i = 0; i < SOIL_SPECIES; ++i) {
        if (SOIL_FIELD_OF[i] != field) continue;
        float density = soilDensity(i, uv);
        left *= soilLeft(soilCover.species[i].shade, density, tall);
        grown += density;
    }
    return soilShares(left, 1.0 - lodRamp(distance, f.shadeFrom, f.shadeInv), 1.0);
}

// Of what one field leaves, the next takes its share. The sky that the ground sees is the least that any map says.
SoilShares soilUnder(vec2 uv, float distance, out float grown) {
    float sky = 1.0;
    grown = 0.0;
    SoilShares all = SoilShares(1.0, 1.0, 1.0);
    if (!GRASS) return all;
    for (int i = 0; i < SOIL_FIELDS; ++i) {
        SoilShares one = soilUnderField(i, uv, distance, grown, sky);
        all.mean *= one.mean;
        all.casting *= one.casting;
    }
    all.ambient = all.mean * sky;
    return all;
}
