// What C++ and GLSL both read of a frame: layout std140 (vec4 and mat4 only), binding numbers, limits.
// Positions are relative to the eye; directions are in world axes; light in the renderer's exposed units.
#ifdef __cplusplus
#pragma once
#define SHARED_MAT4 glm::mat4
#define SHARED_VEC4 glm::vec4
#define SHARED_VEC2 glm::vec2
#define SHARED_IVEC2 glm::ivec2
#define SHARED_UINT uint32_t
namespace sward {
#else
#define SHARED_MAT4 mat4
#define SHARED_VEC4 vec4
#define SHARED_VEC2 vec2
#define SHARED_IVEC2 ivec2
#define SHARED_UINT uint
#endif

struct FrameGlobals {
    SHARED_MAT4 viewProj;  // eye-relative world to clip, reversed depth: 1 near, 0 infinitely far
    SHARED_MAT4 invViewProj;
    SHARED_VEC4 viewport;  // width, height, 1/width, 1/height
    SHARED_VEC4 eye;       // position relative to the terrain's corner (m); w: height above the highest ground (m)
    SHARED_VEC4 terrain;   // size x, size z, 1/size x, 1/size z
    SHARED_VEC4 maps;  // 1 / metres that a map of tiling 1 covers, along x and z; tiling of heights, and of the terrain
                       // map, as below
    SHARED_VEC4 sunDirection;  // towards the sun; w: 1 if it is above the horizon
    SHARED_VEC4 sunLight;      // irradiance on a surface that faces it, divided by pi; w: 1 if it casts shadows
    SHARED_VEC4 skyLight;      // irradiance from the sky on level ground, divided by pi
    SHARED_VEC4 skyGain;       // factor of numerics/sky.h radiances: exposure and white balance
    SHARED_VEC4 skySun;        // the sun that the sky is computed for; w: turbidity, 0: a uniform sky
    SHARED_VEC4 groundLight;   // what the ground throws back, divided by pi
    SHARED_VEC4 horizon[5];    // sky at the horizon, as numerics/light.h has it (horizonLight)
    SHARED_VEC4 haze;          // x: extinction per metre (0: none)
    SHARED_VEC4 heights;       // height above the eye = x + y * (texel - z): z is subtracted first (T-4)
    SHARED_VEC4 groundColor;   // mean reflectance of the soil; w: tiles per metre
    SHARED_VEC4
        mode;  // x: ViewMode; y: exposure factor; z: samples a pixel; w: factor of widths where fewer blades are drawn
    SHARED_VEC4 mirror;  // x: 1 in a view that water mirrors, else 0; y: height relative to the eye below which that
                         // view is cut
    SHARED_VEC4 decal;   // brush: centre x, z relative to the eye, radius (0: none), falloff
};

// A light beside the sun.
struct LightGlobals {
    SHARED_VEC4 place;  // w 0: unit vector towards it; w 1: where it is, relative to the eye
    SHARED_VEC4 color;  // irradiance on a surface that faces it, divided by pi, before attenuation; w: beta (1/m2)
    SHARED_VEC4
        weights;  // of a directional one: xPos, yPos, zPos, xNeg of numerics/weights.h; zNeg is what is left of 1
};
struct LightsGlobals {
    SHARED_VEC4 count;       // x: lights; y: how many of them, the first ones, cast shadows
    LightGlobals lights[8];  // MAX_LIGHTS
};

// The wind, about the eye (world/wind.h).
struct WindGlobals {
    SHARED_VEC4 way;  // x, z of the unit vector along which it blows; strength: lean (m per m) of a full gust at
                      // stiffness 1; turbulence
    SHARED_VEC4
        begin;  // the eye's place in the picture of gusts, in repeats of it: along, across; the same for finer gusts
    SHARED_VEC4 rate;    // repeats a metre: along, across; the same for finer gusts
    SHARED_VEC4 phases;  // x: of quivers (turns); y, z, w: WindPhase of the eye (numerics/wind.h)
    SHARED_VEC4 waves;   // c1, c2, c3, epsilon of equation 9
};

// The map of what presses on the grass, around the eye (grass/forces.h).
struct ForceGlobals {
    SHARED_VEC4 square;  // x, z of its corner relative to the eye; 1/side (1/m); w: 0
};

#define MAX_SPECIES 16  // of a field
// Of one species, for shaders of all.
struct SpeciesCover {
    SHARED_VEC4 of;            // tiling of its density map; share of light left at the soil under full density; mean height (m);
                               // lean (m per m) of a full gust, 0 in a calm
};
// What shaders of all of a field's species read.
struct CoverGlobals {
    SHARED_VEC4 tiers;  // x: number of species; y: minGeom; z: 1/(maxGeom - minGeom), see lodRamp; w: cell size (m)
    // Tilings: repeats over what a map of tiling 1 covers; 0: the map lies on the terrain once, and its edge texels go
    // on beyond (scene/tiling.h).
    SHARED_VEC4 tiling;       // of orientation, vegetation, ambient occlusion, forces: they repeat even where that is 1
    SHARED_VEC4 bladeHeight;  // x: its tiling; y, z, w: 0
    SpeciesCover species[MAX_SPECIES];
    SHARED_VEC4 shadows;      // x: distance from which soil is shaded in the mean (m); y: lodInverse to where it is so
                          // alone; z: share of light that far grass loses; w: distance at which it has (m)
};

// What the ground reads of what grows on it (lib/soil.glsl).
struct SoilField {
    SHARED_VEC2 near;          // distance from which soil is shaded in the mean (m); lodInverse to where it is so alone
    SHARED_VEC2 tilings;       // of the blade-height map, as CoverGlobals has it; of the ambient-occlusion map
};
struct SoilSpecies {
    SHARED_VEC2 shade;         // share of light left at the soil under full density; tiling of the density map
    SHARED_VEC2 unused;
};
#define MAX_FIELDS 8
#define MAX_SOIL_SPECIES 64
struct SoilGlobals {
    SoilField fields[MAX_FIELDS];
    SoilSpecies species[MAX_SOIL_SPECIES];
};

// Views for which grass's mean looks are tabulated: azimuths around, elevations from level to the zenith (sine =
// (i/(n-1))^2).
#define LOOK_AZIMUTHS 8
#define LOOK_ELEVATIONS 4
#define LOOK_VIEWS 32
// What slices of a species are drawn with.
struct SliceGlobals {
    SHARED_VEC4 shape;  // x: cell size (m); y: height of the vertical slices (m); z: slices along an axis; w:
                        // reflectance at full scale
    SHARED_VEC4 tiers;  // x: minGeom; y: its lodInverse; z: minBTF; w: its lodInverse
    SHARED_VEC4 areas;  // blade area towards x: a level view, y: the zenith (m2 a m2); z: height of the horizontal
                        // slice (m); w: its optical depth
    SHARED_VEC4 eyeCell;  // x, z of the cell that the eye is over; where in it, in cells (B-17)
    SHARED_VEC4
        counts;  // x: fade (omega); y: seed; z, w: texels of the horizontal slice, and of a vertical one's width
    SHARED_VEC4 sunWeights;  // of the images x+, y, z+, x-; z- is what is left to 1
    SHARED_VEC4 ambient;     // that vertical slices receive; w: species index
    SHARED_VEC4 farAmbient;  // that the horizontal slice receives; w: tangent of the elevation above which vertical
                             // slices give way
    SHARED_VEC4 clumps;      // x: lean (m per m); y: share of height; z: share of lightness; w: clump size (m)
    SHARED_VEC4 lean;  // x: lean (m per m) at full paint; y: translucency; z: mean height (cells); w: 2^-(levels finer
                       // than a pixel)
    SHARED_VEC4 laid;  // of grass that lies, pressed down: x, y: its area as in areas
    SHARED_VEC4 gains[LOOK_VIEWS];      // rgb: factor of vertical slices; w: brighter by a lean (m per m) towards +x
    SHARED_VEC4 farGains[LOOK_VIEWS];   // rgb: factor of the horizontal slice; w: by one towards +z
    SHARED_VEC4 laidGains[LOOK_VIEWS];  // rgb: factor of either where grass lies, on top
};

// What the vertex shader of blades reads of a species.
struct SpeciesGlobals {
    SHARED_VEC4 rootColor;  // w: ambient light left at the root
    SHARED_VEC4 midColor;   // w: lean (m per m) towards the painted direction, at full strength
    SHARED_VEC4 tipColor;   // w: clump size (m)
    SHARED_VEC4
        clumps;  // x: lean (m per m) at full clump value; y: share of height; z: share of lightness; w: cell size (m)
    SHARED_VEC4 counts;  // x: segments; y: seed; z: fade (omega); w: species index
    SHARED_VEC4 looks;   // x: translucency; y: gloss; z: its roughness; w: 0
    SHARED_VEC4 mask;    // of its shadow mask, x: radius; y: height (m); z, w: 0
};

// Water, about the eye (world/water.h).
#define WATER_WAVES 10
struct WaterGlobals {
    SHARED_VEC4 place;   // height relative to the eye; y, z: texture coordinates of what it mirrors, a clip unit (0:
                         // only the sky); w: 0
    SHARED_VEC4 square;  // low x, z and high x, z of what may be seen of it, relative to the eye
    SHARED_VEC4 color;   // of deep water; w: metres from the surface at which mirrored things are taken to be
    SHARED_VEC4 extinction;          // 1/m; w: 0
    SHARED_VEC4 waves[WATER_WAVES];  // of full strength: x, z: turns a metre; phase at the eye (turns); slope
};

// What shaders read of one kind of flowers.
struct FlowerGlobals {
    SHARED_VEC4 shape;   // height; its variation; size of heads; side of a cell (m)
    SHARED_VEC4 counts;  // flowers a cell; seed; tiling of the density map as CoverGlobals has it (-1: there is none);
                         // 1: the image is made by the program
    SHARED_VEC4 range;   // distance from which flowers are left out; lodInverse to where all are; greatest widening;
                         // height of the head in the image, as a share
    SHARED_VEC4 petal;
    SHARED_VEC4 second;
    SHARED_VEC4 center;
    SHARED_VEC4 stem;
};
// A cell that flowers are drawn of.
struct FlowerCell {
    SHARED_IVEC2 cell;
    SHARED_VEC2 corner;  // relative to the eye
};

// How a species' blades are tessellated (grass/tessellated.h).
struct TessGlobals {
    SHARED_VEC4
        range;  // x: distance from which no blade is drawn (m); y: share of blades missing at each metre; z: 1 / metres
                // over which blades get lower before that; w: how much wider blades become, at most (1: not)
    SHARED_VEC4 level;  // x: greatest level; y: pixels a quad (0: levels by distance); z: near plane (m); w: pixels of
                        // a metre at 1 m
    SHARED_VEC4 plain;  // x: pixels below which a blade of level 1 is a plain triangle; y: its width as a factor of the
                        // blade's; z, w: 0
};
// How cells are chosen (grass/gpu_cells.h).
struct CullGlobals {
    SHARED_VEC4 planes[6];  // of the view, inwards
    SHARED_VEC4 eye;        // as CellGrid of numerics/cells.h: the cell that the eye is over; where in it (m)
    SHARED_VEC4 grid;  // where the terrain ends, x, z (m); z: side of a cell (m); w: how far blades reach beyond it (m)
    SHARED_VEC4 field;   // x, y: cells along x and z; z: square of the distance from which none is drawn (m2); w: how
                         // far shadows reach (m)
    SHARED_VEC4 rule;    // as CellRule: fade, thinning, rangeMin, rangeInv
    SHARED_VEC4 levels;  // as tessMost: s (0: blades are not tessellated), dmax, quadsAtOneMetre, reach
    SHARED_VEC4 strips;  // x: pixels of a blade's sagitta at 1 m; y: most quads; z: share of the blades drawn; w:
                         // distance from which blades of one quad are plain triangles (m)
    SHARED_VEC4 texels;   // x, y: of the density map, a cell; z: seed; w: blades at most in a piece
    SHARED_VEC4 counted;  // x: share of the chosen blades that is drawn; y: 1 if they are to be counted; z: 1 if each
                          // cell has blades of its own; w: 0
};
// Of the cells that were chosen, without those of which only shadows are seen.
struct ChosenCounts {
    SHARED_UINT cells;
    SHARED_UINT blades;  // drawn
};
// Cells of which some may be chosen, and the heights between which their ground lies, relative to the eye.
struct NodeOfCells {
    SHARED_IVEC2 cell;  // the first of kNodeSide x kNodeSide (numerics/cells.h)
    SHARED_VEC2 heights;
};
// A cell whose blades are drawn; none: no such cell.
struct ChosenCell {
    SHARED_IVEC2 cell;
    SHARED_UINT first;  // blade of the patch
    SHARED_UINT look;  // from the lowest bit: 22 bits, how many blades; 7, its greatest level; 1, all of it is in view;
                       // 1, its blades may be, not just their shadows; 1, its blades are all plain triangles
};
#define CHOSEN_LEVEL 22
#define CHOSEN_WHOLE 29
#define CHOSEN_SEEN 30
#define CHOSEN_PLAIN 31
// A cell as what instances a patch's blades reads it.
struct CellInstance {
    SHARED_IVEC2 cell;
    SHARED_VEC2 corner;         // relative to the eye
    SHARED_VEC2 mirror, shift;  // numerics/population.h, CellVersion
};
// Blades of a chosen cell, one after the other with those of other cells.
struct TessCell {
    SHARED_IVEC2 cell;
    SHARED_VEC2 corner;         // relative to the eye
    SHARED_VEC2 mirror, shift;  // numerics/population.h, CellVersion
    SHARED_UINT first;          // blade of the patch
    SHARED_UINT slot;           // place of its first blade among all cells' blades
    SHARED_UINT level;          // greatest of its blades'; 0: all are plain triangles
    SHARED_UINT vertex;         // of its first blade's strip
};
// Words of the list of chosen cells: pieces, 0, 0, 0; by batch, and for its end, the arguments of
// glDispatchComputeIndirect that take each of its pieces, and its first piece; then the commands of
// glMultiDrawArraysIndirect that draw a point a blade.
#define LIST_PIECES 0
#define LIST_BATCHES 4
#define LIST_GROUP 64  // pieces that one group takes

// An object that stands somewhere: rows of the matrix to eye-relative positions.
struct ObjectInstance {
    SHARED_VEC4 row[3];
};

// Shadow maps around the eye, each farther and coarser than the last.
#define SHADOW_CASCADES 3
struct ShadowGlobals {
    SHARED_MAT4 toMap[SHADOW_CASCADES];  // eye-relative to the map: x, y in [0, 1], z depth (1: nearest to the sun)
    SHARED_VEC4 reach;                   // distance from the eye to which each map serves; w: 0
    SHARED_VEC4 texel;                   // metres a texel of each; w: width and height of a texel as a share of the map
};

// A piece of ground to draw: 16 x 16 quads.
struct TerrainNode {
    SHARED_VEC4 place;  // corner relative to the eye x, z; corner relative to the terrain's corner x, z
    SHARED_VEC4 level;  // spacing of its vertices (m); distance where morphing begins; 1/(end - begin); w: 0
};
#define NODES_PER_DRAW 256

#ifdef __cplusplus
static_assert(sizeof(TerrainNode) == 32 && sizeof(TessCell) == 48 && sizeof(ChosenCell) == 16 &&
              sizeof(SpeciesGlobals) == 112);
}
#endif

// Uniform buffers
#define UBO_FRAME 0
#define UBO_COVER 1
#define UBO_SPECIES 2
#define UBO_TESS 3
#define UBO_SLICES 4
#define UBO_WIND 5
#define UBO_SHADOW 6
#define UBO_LIGHTS 7
#define UBO_NODES 8
#define UBO_FORCE 9
#define UBO_WATER 10
#define UBO_FLOWERS 11
#define UBO_CULL 12
#define UBO_SOIL 13
// Storage buffers
#define SSBO_BLADES 0
#define SSBO_CELLS 1
#define SSBO_VERTICES 2
#define SSBO_COMMANDS 3
#define SSBO_LIST 4
#define SSBO_COUNTS 4  // where cells are chosen, before they are listed
#define SSBO_NODES 5
#define SSBO_CHOSEN 6
#define SSBO_UP_TO 7
// Textures
#define TEX_HEIGHT 0
#define TEX_TERRAIN_MAP 1
#define TEX_GROUND 2
#define TEX_BLADE_HEIGHT 3
#define TEX_ORIENTATION 4
#define TEX_VEGETATION 5
#define TEX_OCCLUSION 6
#define TEX_BLADE 7
#define TEX_DENSITY 8  // of the species that is drawn
#define TEX_SCENE 8    // post passes: nothing of the above is bound for them
#define TEX_DEPTH 9    // of one sample
#define TEX_DEPTH_SAMPLES 10
#define TEX_SLICE_REFLECTANCE 16
#define TEX_SLICE_THRESHOLD 17
#define TEX_SLICE_LIGHT 18
#define TEX_WIND 19   // as TEX_SHADOW
#define TEX_FORCE 20  // as TEX_SHADOW
#define TEX_FORCE_MAP 21
#define TEX_REFLECTION 22
#define TEX_FLOWERS 23  // density
#define TEX_SOIL 24  // and the MAX_SOIL_MAPS - 1 that follow: what the ground reads of fields
#define TEX_SHADOW 12   // bound by who makes them, for the whole frame
#define TEX_SHADE 13
#define TEX_OBJECT 7  // as blades: bound for each draw
#define TEX_MASK 14
// Limits
#define MAX_LIGHTS 8
#define MAX_SOIL_MAPS 20  // of all fields together
