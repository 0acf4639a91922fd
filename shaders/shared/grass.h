// What shaders read of a field and of its species' blades. Does not: hold slices (slices.h), tessellation (tess.h) or
// the choice of cells (cells.h).
#pragma once
#include "shared/types.h"
#define MAX_SPECIES 16   // of a field
#define SHADOW_QUADS 2   // at most, of a blade's shadow on the ground
#define TRACED_RISE 3    // numbers by elevation alone
#define TRACED_TERMS 8   // and by the way that light and eye stand to each other, of one elevation of the light
#define TRACED_LIGHTS 7  // elevations of the light (tracedLightAt)
#define TRACED_DIRECT 56
#define TRACED_HEIGHTS 3  // from the soil up to the mask's height, at which light from blade to blade is told
#define TRACED_FILL 21    // heights of each elevation of the light
#define TRACED_GREY 0.1   // reflectance of the lawn that tells what painted grass shows
#ifdef __cplusplus
namespace sward {
#endif

// Of one species, for shaders of all.
struct STD140 SpeciesInField {
    float tiling;     // of its density map, as FieldGlobals has tilings
    float height;     // mean (m)
    float gusts;      // lean (m per m) of a full gust; 0 in a calm
    float skyLeft;    // share of the sky's light left there
    float scattered;  // share of the light on what faces the sun that comes there from blade to blade
};

// What shaders of all of a field's species read. Tilings: repeats over what a map of tiling 1 covers; 0: the map lies
// on the terrain once, and its edge texels go on beyond (scene/tiling.h).
struct STD140 FieldGlobals {
    SpeciesInField species[MAX_SPECIES];
    int speciesCount;
    float minGeom;  // distance where blades begin to give way to slices (m)
    float geomInv;  // 1 / (maxGeom - minGeom), as lodRamp takes it
    float cellSize;
    // These four repeat even where their tiling is 1.
    float orientationTiling;
    float vegetationTiling;
    float occlusionTiling;
    float forceTiling;
    float heightTiling;    // of the map of blades' heights
    float shadeFrom;       // distance from which soil is shaded in the mean (m)
    float shadeInv;        // lodInverse to where it is so alone
    float farDarkening;    // share of light that far grass loses
    float farDarkeningAt;  // distance at which it has (m)
};

// What shaders of one species' blades read.
struct STD140 SpeciesGlobals {
    vec4 traced[TRACED_DIRECT];      // of numerics/traced.h: of direct light, elevation by elevation of the light
    vec4 tracedFill[TRACED_FILL];    // likewise of what comes of it from blade to blade, height by height
    vec4 tracedSky[TRACED_RISE];     // of the sky's
    vec4 tracedGround[TRACED_RISE];  // of light from below
    vec3 rootColor;
    float rootOpen;  // ambient light left at the root
    vec3 midColor;
    float leanAtFull;  // lean (m per m) towards the painted direction, at full strength
    vec3 tipColor;
    float clumpSize;       // m; 0: no clumps
    float clumpLean;       // lean (m per m) at full clump value
    float clumpHeight;     // share of height
    float clumpLightness;  // share of lightness
    float cellSize;        // m
    int segments;          // of a blade
    uint seed;
    float fade;  // omega of numerics/opacity.h
    int index;   // of the species in FieldGlobals
    vec2 area;   // as SliceGlobals has it
    // Of grass/blade_cover.h: sums of a blade's control point and tip by these shares
    vec2 middle;      // the middle of what its image leaves of it
    vec2 reach;       // the area of that over the width
    float covered;    // mean of the image's alpha
    float middleRow;  // of what the image leaves: along the blade, 0 to 1
    float lightRow;   // lib/straight.glsl
    float translucency;
    float gloss;
    float roughness;   // of the gloss
    float maskRadius;  // of its shadow mask's cylinder (m)
    float maskHeight;  // m
    float maskReach;   // how far from a blade stands what shades it (m)
    float spread;      // as Sown
    float step;
    float sownShare;
    uint sowSeed;       // of cells' chances
    float recollision;  // share of the light that a blade sends which meets another; 0: that is not known
    vec3 imageColor;    // mean of its image (linear), for blades that are drawn without it (grass/blade_cover.h)
};

// A blade of a patch (scene/population.h). control and tip are relative to the root, metres.
struct Blade {
    vec2 root;        // in the cell, [0, cellSize)
    float width;      // metres
    float threshold;  // k/255, k in 1..255: it exists where the density reaches it (B-13)
    vec3 control;     // as numerics/blade.h has it
    float hue;        // radians, by numerics/population.h bladeTint
    vec3 tip;
    float lightness;  // factor about 1
    vec2 facing;      // unit: the direction it bends towards
    float dither;     // ]0, 1]: turns opacity into a number of samples without bias
    float spare;      // 0: storage buffers give blades 64 bytes
};

// A cell as what instances a patch's blades reads it.
struct CellInstance {
    ivec2 cell;
    vec2 corner;  // relative to the eye
    vec2 mirror;  // numerics/population.h, CellVersion
    vec2 shift;
    int quads;     // of its blades' strips, of equal height
    float unused;  // keeps the size a multiple of 8 bytes, as shaders have it
};

// A blade that stands on an object (grass/mesh_geometry.h), in the mesh's own lengths.
struct MeshBladeRoot {
    vec3 position;
    uint blade;  // of the patch; MIRRORED_ROOT: the bitangent is the other way round
    uvec2 turn;  // as two by two packSnorm2x16: the quaternion that turns x, y, z to tangent, normal, bitangent
    uvec2 bend;  // packHalf2x16: curvature as CarrierVertex has it, and last the density of the place
    vec2 uv;
    ivec2 cell;
    uvec4 corners;  // the mesh's vertices around it; packUnorm2x16 of the weights of the first two
};
#define MIRRORED_ROOT 0x80000000u

#ifdef __cplusplus
}
#endif
