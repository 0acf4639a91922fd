// Light past another species that stands among blades: Beer's law over its leaves above a point, as evenly spread as
// their area over their height.

#ifndef __cplusplus
#include "numerics/basics.h"
#include "numerics/glsl.h"
#include "numerics/slope.h"
#endif

// Share of a species' leaves of this mean height (m) that is above a point so high over the ground (m).
FN real shareAbove(real height, real high) { return clamp(1.0f - high / max(height, kTiny), real(0.0), real(1.0)); }
// Optical depth of the share of them above, at density 1. area: of its leaves, m2 a m2, towards a level view and
// towards the zenith; towards: the light, unit; rise: of it over the ground, of which less than 0.1 counts as that.
FN real depthAbove(vec2 area, real share, vec3 towards, real rise) {
    return share * leafDepth(area, towards, max(rise, real(0.1)));
}
// The same for all of the sky's light, of which all leaves leave so much. A point among none has all of it.
FN real skyDepthAbove(real left, real share) { return -log(clamp(left, real(1e-6), real(1.0))) * share; }
