// How much light a field's other species leave to a point of a blade: none where there is one species alone. Any stage
// but fragments. Needs: OTHERS_EACH where there are others, which a field's programs are compiled with (frame/soil.h):
// for each of its species OTHER_SPECIES. Texture arrays take constant numbers alone on some drivers.
#include "lib/density.glsl"
#include "lib/frame.glsl"
#include "lib/species.glsl"
#include "numerics/others.h"
#include "numerics/traced.h"
#include "shared/bindings.h"
#include "shared/soil.h"

// Of a light on a point among blades that would light what faces it by 1.
struct OthersLight {
    float leave;  // share of it that other species leave
    float area;   // of their leaves towards a level view, m2 a m2 of ground
    vec3 fill;    // what comes of the sun's from blade to blade, on a blade of any direction
};
#ifdef OTHERS_EACH
layout(std140, binding = UBO_SOIL) uniform SoilBlock { SoilGlobals soilGrowth; };
layout(binding = TEX_SOIL) uniform sampler2D soilMap[MAX_SOIL_MAPS];

// The way of light through a species at density 1: its optical depth, and where on the ground its middle lies, with how
// much of it to both sides (m).
struct OtherWay {
    float depth;
    vec2 middle;
    float reach;
};
// high: of the point over the ground (m); towards: the light, unit, or 0 of the sky; rise: of that over the ground.
OtherWay wayThrough(SoilSpecies other, vec2 uv, float high, vec3 towards, float rise) {
    float share = shareAbove(other.height, high), above = share * other.height;
    if (towards == vec3(0.0)) return OtherWay(skyDepthAbove(other.skyLeft, share), uv, above);
    float level = length(towards.xz), reach = 0.5 * above * level / max(rise, 0.1);
    return OtherWay(depthAbove(other.area, share, towards, rise),
                    uv + towards.xz * (reach / max(level, 1e-4)) * frame.mapShare, reach);
}
#define OTHER_DENSITY(number, map)                                                                      \
    ((map) < 0 ? 1.0                                                                                    \
               : textureLod(soilMap[max(map, 0)], tiled(way.middle, soilGrowth.species[number].tiling), \
                            levelOver(way.reach, textureSize(soilMap[max(map, 0)], 0)))                 \
                     .r)
// What comes of the sun's light from blade to blade of another species, so high (m).
vec3 fillOf(SoilSpecies other, float high) {
    vec3 heights = tracedHeights(high / max(other.maskHeight, 1e-4));
    vec3 sum = vec3(0.0);
    for (int i = 0; i < TRACED_HEIGHTS; ++i) sum += other.sunFill[i].rgb * heights[i];
    return sum;
}
// Each species' fill is dimmed by all others, whichever was the first.
#define OTHER_SPECIES(own, number, map)                                                                              \
    if (species.index != own) {                                                                                      \
        OtherWay way = wayThrough(soilGrowth.species[number], uv, high, towards, rise);                              \
        float density = OTHER_DENSITY(number, map) * share, passes = exp(-way.depth * density);                      \
        float area = soilGrowth.species[number].area.x;                                                              \
        light.area += area * density;                                                                                \
        light.fill = light.fill * passes + light.leave * fillOf(soilGrowth.species[number], high) * area * density / \
                                               (1.0 - exp(-max(area, 1e-3)));                                        \
        light.leave *= passes;                                                                                       \
    }
OthersLight othersLight(vec2 uv, float high, vec3 towards, float rise) {
    float share = bladeShare(uv);
    OthersLight light = OthersLight(1.0, 0.0, vec3(0.0));
    OTHERS_EACH
    return light;
}
#else
OthersLight othersLight(vec2 uv, float high, vec3 towards, float rise) { return OthersLight(1.0, 0.0, vec3(0.0)); }
#endif
