// What every shader may read of a frame. Positions are relative to the eye; directions are in world axes; light is in
// the renderer's exposed units. Does not: hold what only one domain's shaders read.
#pragma once
#include "shared/types.h"
#ifdef __cplusplus
namespace sward {
#endif

struct STD140 FrameGlobals {
    mat4 viewProj;  // eye-relative world to clip, reversed depth: 1 near, 0 infinitely far
    mat4 invViewProj;
    vec2 pixels;      // width and height of the picture
    vec2 pixelShare;  // 1/width, 1/height
    vec3 eye;         // relative to the terrain's corner (m)
    float eyeAbove;   // height of the eye above the highest ground (m), at least 0
    // The terrain and its maps (scene/tiling.h).
    vec2 terrainSize;     // along x and z (m)
    vec2 terrainShare;    // 1 / terrainSize
    vec2 mapShare;        // 1 / metres that a map of tiling 1 covers, along x and z
    float heightTiling;   // of the height map; 0: it lies on the terrain once, and its edge texels go on beyond
    float terrainTiling;  // of the terrain map, likewise
    // Height above the eye = groundBase + groundScale * (texel - groundTexel), subtracted first (T-4).
    float groundBase;
    float groundScale;
    float groundTexel;
    float soilRepeats;  // repeats of the soil's texture a metre
    vec3 soilColor;     // its mean reflectance
    // Light.
    float exposure;     // factor of all light
    vec3 sunDirection;  // towards the sun, unit
    float sunIsUp;      // 1 if it stands above the horizon, else 0
    vec3 sunLight;      // irradiance on a surface that faces it, divided by pi
    float sunCasts;     // 1 if it casts shadows, else 0
    vec3 skyLight;      // irradiance from the sky on level ground, divided by pi
    float haze;         // extinction a metre; 0: none
    vec3 groundLight;   // what the ground throws back, divided by pi
    float turbidity;    // of the sky; 0: it is uniform
    vec3 skySun;        // direction of the sun that the sky is computed for
    float horizonMiddle;
    vec3 skyGain;  // factor of numerics/sky.h radiances: exposure and white balance
    float horizonScale;
    vec4 horizon[5];  // rgb: the sky at the horizon; with middle and scale as horizonLight has it (numerics/light.h)
    // The land beyond the terrain (world/land.h).
    vec3 landMean;    // reflectance of the terrain with what grows on it
    float landReach;  // metres beyond the terrain's edges; 0: there is none
    vec3 landGrass;   // reflectance of its grass
    float landFade;   // 1 / metres over which it comes to the mean; 0: it does not
    vec3 skyGlow;  // as sunLight, the part of skyLight that comes from around the sun (sky/daylight.h); else it is even
    uint aroundSlots;  // entries of the table of cells (below)
    // The view.
    int mode;              // ViewMode
    int samples;           // a pixel
    float widening;        // factor of blades' widths where fewer of them are drawn
    float mirrored;        // 1 in a view that water mirrors, else 0
    float mirrorHeight;    // relative to the eye: below it such a view is cut
    float decalRadius;     // of the brush (m); 0: none is shown
    vec2 decalAt;          // its centre: x, z relative to the eye
    vec2 pixelFrom;        // the picture's lower left corner, in pixels of the whole of which it may be a part
    float decalFalloff;    // share of the radius over which it fades
    float treesShadeFrom;  // metres from the eye over which far trees' shade on the ground sets in (forest/texcells.h)
    float treesShadeTo;
    float landLevel;   // height to which the land beyond comes, relative to the eye
    uint chanceShift;  // 256ths by which this frame moves the chances that samples are covered (post/antialias.h)
    float lookShare;   // of a pixel's width, over which maps are looked up along the ground (lib/looks.glsl)
    // What objects leave of light from all around on the ground (lib/ground_around.glsl): the cells that have some lie
    // from here to before there.
    ivec2 aroundFrom;
    ivec2 aroundTo;
};

#ifdef __cplusplus
}
#endif
