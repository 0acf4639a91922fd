// Objects and the shadow maps that they are drawn into (objects/shadow.h). Does not: hold hills' shadows, which are a
// texture.
#pragma once
#include "shared/bindings.h"
#include "shared/types.h"
#define SHADOW_CASCADES 3
#ifdef __cplusplus
namespace sward {
#endif

// An object that stands somewhere: rows of the matrix to eye-relative positions.
struct ObjectInstance {
    vec4 row[3];
};

// A shadow map around the eye.
struct STD140 ShadowCascade {
    mat4 toMap;   // eye-relative to the map: x, y in [0, 1], z depth (1: nearest to the sun)
    float reach;  // distance from the eye to which it serves (m)
    float texel;  // metres a texel
};

struct STD140 ShadowGlobals {
    ShadowCascade cascades[SHADOW_CASCADES];  // each farther and coarser than the last
    float texelShare;                         // width and height of a texel as a share of a map
};

#ifdef __cplusplus
}
#endif
