// How a leaf answers light from one direction. Needs: const bool TRANSLUCENCY, GLOSS.
#include "numerics/leaf.h"

// Light sent to the eye by a leaf of reflectance c that faces n (the side towards the eye), lit by `light` (irradiance
// over pi) from `towards`. looks: translucency, gloss, roughness.
vec3 leafLight(vec3 c, vec3 looks, vec3 n, vec3 toEye, vec3 towards, vec3 light) {
    return leafSends(c, vec3(TRANSLUCENCY ? looks.x : 0.0, GLOSS ? looks.y : 0.0, looks.z), n, toEye, towards) * light;
}
