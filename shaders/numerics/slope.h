// Grass on a hillside: blades stand upright, so that lowering each place by what the ground has risen there leaves
// lines straight and blades as far apart as they were: what hides what is told on level ground, by ways so lowered.

#ifndef __cplusplus
#include "numerics/glsl.h"
#endif

// Light that rises less over the ground is dimmed by its grass as this is.
const real kLeastRise = real(0.15);
// By how much a way rises over ground of this slope (rise a metre along x and z).
FN real riseOver(vec3 way, vec2 slope) { return way.y - slope.x * way.x - slope.y * way.z; }
// A way, or an offset from a root, as it is over the level ground; not unit.
FN vec3 overLevel(vec3 way, vec2 slope) { return vec3(way.x, riseOver(way, slope), way.z); }
// Area of leaves (m2 a m2 of ground) that faces a way (unit). area: of those towards a level view and the zenith.
FN real areaFacing(vec2 area, vec3 way) {
    real across2 = area.x * area.x * (1.0f - way.y * way.y), above = area.y * way.y;
    return sqrt(max(across2 + above * above, real(0.0)));
}
// Optical depth of all leaves along it, of which a metre rises so far.
FN real leafDepth(vec2 area, vec3 way, real rise) { return areaFacing(area, way) / rise; }

// What a view sees lit of leaves, to a factor: those above a seen one hide it from the eye by so much a unit of depth,
// and from the light.
FN real seenLit(real eyes, real lights) {
    real both = eyes + lights;
    return both < real(1e-3) ? real(1.0) - real(0.5) * both : (1.0f - exp(-both)) / both;
}
// How many times as bright leaves are in a light for the slope of their ground, where the view is the one over level
// ground: the first order of single scattering. Towards the eye and the light, unit. What would be less than 0.05 over
// the ground counts as that; the light is gone where it comes from below.
FN real slopeBrightens(vec2 area, vec3 toEye, vec3 towards, vec2 slope) {
    real least = real(0.05), rise = riseOver(towards, slope);
    real eyes = leafDepth(area, toEye, max(riseOver(toEye, slope), least));
    real level = leafDepth(area, towards, max(towards.y, least)), here = leafDepth(area, towards, max(rise, least));
    return clamp(rise / least, real(0.0), real(1.0)) * seenLit(eyes, here) / seenLit(eyes, level);
}
