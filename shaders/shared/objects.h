// Objects and the shadow maps that they are drawn into (objects/shadow.h). Does not: hold hills' shadows, which are a
// texture.
#pragma once
#include "shared/light.h"
#include "shared/types.h"
#define SHADOW_CASCADES 3
#define LAMP_MAPS 6              // of a lamp: faces of a cube, or cascades
#define LAMP_SHADOW_SIDE 512     // texels of a map of what shades lamps' light
#define LAMP_SHADOW_SHARE 0.988  // of such a map's width that a face of a lamp's cube takes: the rest is room for taps
#define LAMP_SHADOW_NEAR 0.02    // metres from a lamp: what is nearer shades nothing
#ifdef __cplusplus
namespace sward {
#endif

// An object that stands somewhere: rows of the matrix to eye-relative positions.
struct ObjectInstance {
    vec4 row[3];
};

// Number of a first vertex of objects that no rays have found light for (lib/object_light.glsl).
#define NO_OBJECT_LIGHT 0xFFFFFFFFu

// What objects leave of light from all around on the ground (lib/ground_around.glsl).
#define AROUND_CELL 2.0   // metres a side of its squares
#define AROUND_SIDE 17    // points along a side, those on its corners included
#define AROUND_ACROSS 60  // squares a row of the texture
#define AROUND_TABLE 256  // entries a row of the table
#define AROUND_EMPTY 0xFFFFFFFFu

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

// Of a directional lamp (objects/lamp_shadow.h).
struct STD140 LampCascades {
    ShadowCascade cascades[LAMP_MAPS];
};

// Layers of their maps: lamp i has those from LAMP_MAPS * i on, faces of a cube if it stands somewhere.
struct STD140 LampShadowGlobals {
    LampCascades lamps[MAX_LIGHTS];  // those that cast shadows, as LightsGlobals has them
};

#ifdef __cplusplus
}
#endif
