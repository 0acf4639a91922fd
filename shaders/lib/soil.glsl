// What grows on the ground under a fragment, over all fields: the share of light that it leaves to the soil. Needs:
// const bool GRASS, GRASS_HEIGHTS and those of ground_light.glsl; ground_light.glsl; SOIL_EACH, which the program is
// compiled with (frame/soil.h): for each field SOIL_FIELD, then SOIL_SPECIES for each of its species, then SOIL_SHARE.
// Texture arrays take constant numbers alone on some drivers, so that a loop over species would not do.
#include "lib/frame.glsl"
#include "lib/ground_light.glsl"
#include "numerics/lod.h"
#include "shared/bindings.h"
#include "shared/soil.h"
layout(std140, binding = UBO_SOIL) uniform SoilBlock { SoilGlobals soilGrowth; };
layout(binding = TEX_SOIL) uniform sampler2D soilMap[MAX_SOIL_MAPS];

#ifndef SOIL_EACH
#define SOIL_EACH  // nothing grows
#endif
// What a map says, filtered for the pixel, or from its finest level; 1 where there is none (-1).
#define SOIL_TEXEL(map, at) ((map) < 0 ? 1.0 : texture(soilMap[max(map, 0)], at).r)
#define SOIL_FINEST(map, at) ((map) < 0 ? 1.0 : textureLod(soilMap[max(map, 0)], at, 0.0).r)

// What a density map says, a mean over so many metres or the pixel, of what stands half-way to where the sun's light
// comes in over grass of that height (m).
#define SOIL_TOWARDS_SUN(map, number)                                                                            \
    ((map) < 0 || !SUN                                                                                           \
         ? density                                                                                               \
         : textureLod(                                                                                           \
               soilMap[max(map, 0)],                                                                             \
               tiled(uv + sunStep(soilGrowth.species[number].height, slope), soilGrowth.species[number].tiling), \
               soilLevel(soilGrowth.species[number].height, slope, textureSize(soilMap[max(map, 0)], 0),         \
                         textureQueryLod(soilMap[max(map, 0)], tiled(uv, soilGrowth.species[number].tiling)).y)) \
               .r)

#define SOIL_FIELD(field, heights, occlusion)                                     \
    left = kAllLeft;                                                              \
    tall = SOIL_TEXEL(heights, tiled(uv, soilGrowth.fields[field].heightTiling)); \
    sky = min(sky, SOIL_FINEST(occlusion, uv * soilGrowth.fields[field].occlusionTiling));
#define SOIL_SPECIES(number, map)                                                                                      \
    density = SOIL_TEXEL(map, tiled(uv, soilGrowth.species[number].tiling));                                           \
    left = times(left, soilLeft(soilGrowth.species[number].area,                                                       \
                                vec2(soilGrowth.species[number].skyLeft, soilGrowth.species[number].scattered), slope, \
                                density, SOIL_TOWARDS_SUN(map, number), tall));                                        \
    grown += density;
#define SOIL_SHARE(field) all = soilUnderBoth(all, soilOf(soilGrowth.fields[field], left, distance));

// Half-way to where the sun's light comes in over grass so high (m), level: as maps have places; and metres.
float sunReach(float height, vec2 slope) {
    return 0.5 * height * length(frame.sunDirection.xz) / max(riseOver(frame.sunDirection, slope), 0.1);
}
vec2 sunStep(float height, vec2 slope) {
    vec2 way = frame.sunDirection.xz;
    return way * (sunReach(height, slope) / max(length(way), 1e-4)) * frame.mapShare;
}
float soilLevel(float height, vec2 slope, ivec2 size, float pixel) {
    return max(levelOver(sunReach(height, slope), size), pixel);
}

SoilShares soilOf(SoilField f, SoilLeft left, float distance) {
    return soilShares(left, 1.0 - lodRamp(distance, f.shadeFrom, f.shadeInv), 1.0);
}
// Of what one field leaves, the next takes its share.
SoilShares soilUnderBoth(SoilShares a, SoilShares b) {
    return SoilShares(a.ambient, times(a.mean, b.mean), times(a.casting, b.casting));
}

// grown: how dense all species are together. The sky that the ground sees is the least that any field's map says.
SoilShares soilUnder(vec2 uv, vec2 slope, float distance, out float grown) {
    SoilLeft left = kAllLeft;
    float tall = 1.0, sky = 1.0, density = 0.0;
    grown = 0.0;
    SoilShares all = SoilShares(1.0, left, left);
    SOIL_EACH
    all.ambient = all.mean.sky * sky;
    return all;
}
