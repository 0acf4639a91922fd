// What C++ and GLSL both read of a frame: layout std140 (vec4 and mat4 only), binding numbers, limits.
// Positions are relative to the eye; directions are in world axes; light in the renderer's exposed units.
#ifdef __cplusplus
#pragma once
#define SHARED_MAT4 glm::mat4
#define SHARED_VEC4 glm::vec4
namespace sward {
#else
#define SHARED_MAT4 mat4
#define SHARED_VEC4 vec4
#endif

struct FrameGlobals {
    SHARED_MAT4 viewProj;      // eye-relative world to clip, reversed depth: 1 near, 0 infinitely far
    SHARED_MAT4 invViewProj;
    SHARED_VEC4 viewport;      // width, height, 1/width, 1/height
    SHARED_VEC4 eye;           // position relative to the terrain's corner (m); w: height above the highest ground (m)
    SHARED_VEC4 terrain;       // size x, size z, 1/size x, 1/size z
    SHARED_VEC4 sunDirection;  // towards the sun; w: 1 if it is above the horizon
    SHARED_VEC4 sunLight;      // irradiance on a surface that faces it, divided by pi
    SHARED_VEC4 skyLight;      // irradiance from the sky on level ground, divided by pi
    SHARED_VEC4 skyGain;       // factor of numerics/sky.h radiances: exposure and white balance
    SHARED_VEC4 skySun;        // the sun that the sky is computed for; w: turbidity
    SHARED_VEC4 groundLight;   // what the ground throws back, divided by pi
    SHARED_VEC4 horizon[3];    // sky at the horizon towards the sun, across and away from it; w: 0
    SHARED_VEC4 haze;          // x: extinction per metre (0: none)
    SHARED_VEC4 heights;       // height above the eye = x + y * (texel - z): z is subtracted first (T-4)
    SHARED_VEC4 groundColor;   // mean reflectance of the soil; w: tiles per metre
    SHARED_VEC4 mode;          // x: ViewMode; y: exposure factor; z: samples a pixel; w: factor of widths where fewer blades are drawn
    SHARED_VEC4 decal;         // brush: centre x, z relative to the eye, radius (0: none), falloff
};

// How grass looks from where it is not drawn as blades; one a species, written by the grass domain for the ground.
struct CoverSpecies {
    SHARED_VEC4 albedo;        // mean reflectance of what is seen of its blades; w: blade area per m2 of ground at density 1
    SHARED_VEC4 ambient;       // mean ambient light on what is seen, darkened towards the root; w: mean height (m)
    SHARED_VEC4 shape;         // x: tangent of the mean lean; y: share of light left at the soil under full density;
                               // z, w: horizontal and vertical part of the normals of what is seen, darkened likewise
    SHARED_VEC4 clumps;        // x: clump size (m); y: share of lightness; z, w: 0
};
struct CoverGlobals {
    CoverSpecies species[4];   // MAX_SPECIES
    SHARED_VEC4 tiers;         // x: number of species; y: minGeom; z: 1/(maxGeom - minGeom), see lodRamp; w: cell size (m)
    SHARED_VEC4 tiling;        // repeats over the terrain of orientation, vegetation, ambient occlusion; w: seed
};

// What the vertex shader of blades reads of a species.
struct SpeciesGlobals {
    SHARED_VEC4 rootColor;     // w: ambient light left at the root
    SHARED_VEC4 midColor;      // w: lean (m per m) towards the painted direction, at full strength
    SHARED_VEC4 tipColor;      // w: clump size (m)
    SHARED_VEC4 clumps;        // x: lean (m per m) at full clump value; y: share of height; z: share of lightness; w: cell size (m)
    SHARED_VEC4 counts;        // x: segments; y: seed; z: fade (omega); w: species index
};

// An object that stands somewhere: rows of the matrix to eye-relative positions.
struct ObjectInstance {
    SHARED_VEC4 row[3];
};

// Shadow maps around the eye, each farther and coarser than the last.
#define SHADOW_CASCADES 3
struct ShadowGlobals {
    SHARED_MAT4 toMap[SHADOW_CASCADES];  // eye-relative to the map: x, y in [0, 1], z depth (1: nearest to the sun)
    SHARED_VEC4 reach;         // distance from the eye to which each map serves; w: 0
    SHARED_VEC4 texel;         // metres a texel of each; w: width and height of a texel as a share of the map
};

// A piece of ground to draw: 16 x 16 quads.
struct TerrainNode {
    SHARED_VEC4 place;         // corner relative to the eye x, z; corner relative to the terrain's corner x, z
    SHARED_VEC4 level;         // spacing of its vertices (m); distance where morphing begins; 1/(end - begin); w: 0
};
#define NODES_PER_DRAW 256

#ifdef __cplusplus
static_assert(sizeof(TerrainNode) == 32 && sizeof(SpeciesGlobals) == 80);
}
#endif

// Uniform buffers
#define UBO_FRAME 0
#define UBO_COVER 1
#define UBO_SPECIES 2
#define UBO_NODES 3
#define UBO_SHADOW 6
// Storage buffers
#define SSBO_BLADES 0
// Textures
#define TEX_HEIGHT 0
#define TEX_TERRAIN_MAP 1
#define TEX_GROUND 2
#define TEX_ORIENTATION 4
#define TEX_VEGETATION 5
#define TEX_OCCLUSION 6
#define TEX_BLADE 7
#define TEX_DENSITY 8      // and the MAX_SPECIES - 1 that follow
#define TEX_SCENE 8        // post passes: nothing of the above is bound for them
#define TEX_DEPTH 9
#define TEX_SHADOW 12      // bound by who makes them, for the whole frame
#define TEX_SHADE 13
#define TEX_OBJECT 7       // as blades: bound for each draw
// Limits
#define MAX_SPECIES 4
