// How much light a field's other species leave to a point of a blade: none where there is one species alone. Any stage
// but fragments. Needs: OTHERS_EACH where there are others, which a field's programs are compiled with (frame/soil.h):
// for each of its species OTHER_SPECIES. Texture arrays take constant numbers alone on some drivers.
#include "lib/density.glsl"
#include "lib/frame.glsl"
#include "lib/species.glsl"
#include "numerics/others.h"
#include "shared/bindings.h"
#include "shared/soil.h"

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
// high: of the point over the ground (m); towards: the light, unit, or 0 of the sky.
OtherWay wayThrough(SoilSpecies other, vec2 uv, float high, vec3 towards) {
    float share = shareAbove(other.height, high), above = share * other.height;
    if (towards == vec3(0.0)) return OtherWay(skyDepthAbove(other.skyLeft, share), uv, above);
    float level = length(towards.xz), reach = 0.5 * above * level / max(towards.y, 0.1);
    return OtherWay(depthAbove(other.area, share, towards),
                    uv + towards.xz * (reach / max(level, 1e-4)) * frame.mapShare, reach);
}
#define OTHER_DENSITY(number, map)                                                                      \
    ((map) < 0 ? 1.0                                                                                    \
               : textureLod(soilMap[max(map, 0)], tiled(way.middle, soilGrowth.species[number].tiling), \
                            levelOver(way.reach, textureSize(soilMap[max(map, 0)], 0)))                 \
                     .r)
#define OTHER_SPECIES(own, number, map)                                           \
    if (species.index != own) {                                                   \
        OtherWay way = wayThrough(soilGrowth.species[number], uv, high, towards); \
        depth += way.depth * OTHER_DENSITY(number, map);                          \
    }
float othersLeave(vec2 uv, float high, vec3 towards) {
    float depth = 0.0;
    OTHERS_EACH
    return exp(-depth * bladeShare(uv));
}
#else
float othersLeave(vec2 uv, float high, vec3 towards) { return 1.0; }
#endif
