// What slices of a species are drawn with (grass/slices.h). Does not: hold their images.
#pragma once
#include "shared/types.h"
// Views for which grass's mean looks are tabulated: azimuths around, elevations from level to the zenith (lookHeight of
// numerics/traced.h).
#define LOOK_AZIMUTHS 16
#define LOOK_ELEVATIONS 8
#define LOOK_VIEWS 128
#define FAR_LEVELS 8      // of the horizontal slice's images, from the finest on: coarser ones are as the last
#define SLICE_LEVELS 8    // of vertical slices' images likewise
#define LEVEL_FACTORS 16  // vec4s for factors by LOOK_ELEVATIONS and SLICE_LEVELS
#define PAINT_SCALE 4.0   // of LookGain's factors of paint
#define SHINE_SCALE 0.25  // of LookGain's highlights on paint
#define THIN_DENSITY 8    // 1 / the density of LookGain's thin
// Texels of the image of lamps' gains: x, (1 - cosine of the azimuth between eye and light) / 2; y and z, elevations of
// eye and light as above.
#define LAMP_AZIMUTHS 7
#define LAMP_ELEVATIONS 5
#ifdef __cplusplus
namespace sward {
#endif

// Factors by which slices, seen from one of the tabulated views, get the radiance of the blades they stand for. Red,
// green and blue are shares of SliceGlobals::gainScale, 10 bits each from the lowest on: rays look them up by the
// pixel.
struct STD140 LookGain {
    uint across;  // of vertical slices
    uint above;   // of the horizontal slice
    uint laid;    // of vertical slices where grass lies, on top
    uint thin;    // of the horizontal slice at a density of 1 / THIN_DENSITY
    // By how much paint is drawn brighter, as shares of PAINT_SCALE: of vertical slices, and of the horizontal one.
    // Factors above are for blades' own colours, of which images show others than a view does.
    uint paintAcross;
    uint paintAbove;
    uint shine;  // what paint is brighter by for highlights, as reflectance: a share of SHINE_SCALE
    // By what share it brightens as blades lean (m per m), as shares of leanScale, of which half is 0: times the lean
    // along x, along z, the squares of these, and their product.
    uint leanX;
    uint leanZ;
    uint leanXX;
    uint leanZZ;
    uint leanXZ;
};

struct STD140 SliceGlobals {
    float cellSize;      // m
    float top;           // height of the vertical slices (m)
    int slices;          // along an axis
    float reflectScale;  // reflectance at full scale
    float minGeom;       // distance from which slices stand for blades (m)
    float geomInv;       // its lodInverse
    float minBTF;        // distance from which the horizontal slice stands for vertical ones (m)
    float btfInv;        // its lodInverse
    vec2 area;           // blade area towards x: a level view, y: the zenith (m2 a m2)
    vec2 laidArea;       // the same of grass that lies, pressed down
    vec2 eyeCell;        // x, z of the cell that the eye is over
    vec2 inCell;         // where in it, in cells (B-17)
    vec4 sunWeights;     // of the images x+, y, z+, x-; z- is what is left to 1
    vec4 gainScale;      // greatest factor of LookGain's across, above, laid and thin
    vec4 farLevels[2];   // by level: by how much brighter it is drawn than it says, so that all are as bright as the
                         // first
    vec4 thinner[2];     // by LOOK_ELEVATIONS: by how much brighter vertical slices are drawn where they stand for
                         // one blade in THIN_DENSITY: the others, drawn one by one, do not hide what is dark there
    // Of vertical slices, by LOOK_ELEVATIONS and, fastest, by the level of what is lit: by how much brighter they are
    // drawn than they say.
    vec4 sliceLevels[LEVEL_FACTORS];
    vec3 ambient;     // light from all around that vertical slices receive
    float fade;       // omega of numerics/opacity.h
    vec3 farAmbient;  // that the horizontal slice receives
    float steepest;   // tangent of the elevation above which vertical slices give way
    vec3 hotSpot;     // by what share the sun's light is brighter where one looks along it (tracedGlow)
    uint seed;
    vec3 lampHotSpot;      // the same of lamps: numbers of a polynomial by their elevation (tracedRise)
    int species;           // index in FieldGlobals
    float farTexels;       // of the horizontal slice, along an axis
    float farHeight;       // of the horizontal slice (m)
    float farDepth;        // its optical depth
    float clumpLean;       // lean (m per m) at full clump value
    float clumpHeight;     // share of height
    float clumpLightness;  // share of lightness
    float clumpSize;       // m; 0: no clumps
    float leanAtFull;      // lean (m per m) at full paint
    float translucency;
    float meanHeight;  // cells
    float sharpness;   // 2^-(levels finer than a pixel)
    int layers;        // of the vertical slices' images: those across z are the last `slices` of them
    float spread;      // as Sown
    float step;
    float sownShare;
    uint sowSeed;       // of cells' chances
    float leanScale;    // greatest share of LookGain's leans
    float recollision;  // as SpeciesGlobals has it
    float farRise;      // by how much the horizontal slice lies higher where it is seen from afar, almost level (m)
    float riseFrom;     // distance from which it rises to that (m)
    LookGain gains[LOOK_VIEWS];
};

#ifdef __cplusplus
}
#endif
