// Blades that are drawn straight, as one quad or one triangle: whatever looks at one side of them alone sees as much
// of them as of the bent blade, and as high. From the moments of the image's alpha (grass/blade_cover.h). Any stage but
// fragments.
#include "lib/species.glsl"
#include "numerics/population.h"

// The middle of what the image leaves of a blade, and its area over its width: so long a rectangle shows as much.
vec3 coveredMiddle(BladePose pose) { return species.middle.x * pose.control + species.middle.y * pose.tip; }
vec3 coveredReach(BladePose pose) { return species.reach.x * pose.control + species.reach.y * pose.tip; }
// Where row v of a quad is.
vec3 straightRow(BladePose pose, float v) {
    return coveredMiddle(pose) + coveredReach(pose) * ((v - species.middleRow) / species.covered);
}

// A triangle: its base, its apex, which is about as high as the tip, and how wide the base is.
struct PlainBlade {
    vec3 base, apex;
    float width;
};
PlainBlade plainBlade(BladePose pose, float width) {
    vec3 middle = coveredMiddle(pose), reach = coveredReach(pose);
    float along = clamp(1.5 * dot(pose.tip - middle, reach) / max(dot(reach, reach), 1e-12), 0.75, 3.0);
    return PlainBlade(middle - reach * (along / 3.0), middle + reach * (along / 1.5), 2.0 * width / along);
}
// The row of the blade that a row of the triangle stands for.
float plainRow(float v) { return mix(1.5 * species.middleRow - 0.5, 1.0, v); }
