// Numbers that C++ binds buffers and textures at and shaders read them from: all in one place, so that one sees which
// are free. Does not: say what lies there; the structs are in the other headers of this folder.
#pragma once

// Uniform buffers
#define UBO_FRAME 0
#define UBO_FIELD 1
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
#define UBO_FOREST 14
#define UBO_LAMP_SHADOW 15
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
#define SSBO_OBJECT_LIGHT 6  // as chosen cells: bound for each draw
#define SSBO_FOREST_TILES 1  // as cells: bound for each draw
#define SSBO_FOREST_FEET 3
#define SSBO_FOREST_SLICES 4
// Images
#define IMAGE_LAMP_HILLS 0
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
#define TEX_FAR_REFLECTANCE 7  // the horizontal slice, where it is read together with the vertical ones
#define TEX_FAR_THRESHOLD 15
#define TEX_FAR_LIGHT 11
#define TEX_SLICE_REFLECTANCE 16
#define TEX_SLICE_THRESHOLD 17
#define TEX_SLICE_LIGHT 18
#define TEX_WIND 19   // as TEX_SHADOW
#define TEX_FORCE 20  // as TEX_SHADOW
#define TEX_FORCE_MAP 21
#define TEX_REFLECTION 22
#define TEX_FLOWERS 23     // density
#define TEX_SOIL 24        // and the MAX_SOIL_MAPS - 1 that follow: what the ground reads of fields
#define TEX_SHELL_ENDS 44  // where rays leave the shells over meshes
#define TEX_SHELL_LEAVING 45
#define TEX_FOREST_SLABS 46
#define TEX_FOREST_LIGHT 48
#define TEX_FOREST_SLOTS 49
#define TEX_FOREST_SHADE 50  // as TEX_SHADOW
#define TEX_FOREST_VEIL 51
#define TEX_FOREST_NEAREST 52
#define TEX_SKY 53  // as TEX_SHADOW
#define TEX_AIR 54
#define TEX_LAMP_GAINS 55   // of the species that is drawn
#define TEX_LAMP_SHADOW 56  // as TEX_SHADOW
#define TEX_LAMP_HILLS 57
#define TEX_MOTION 58
#define TEX_HISTORY 59  // of frames that add up: their mean, and how far away it was
#define TEX_HISTORY_DISTANCE 60
#define TEX_SUN_GAINS 61  // on meshes, of the species that is drawn
#define TEX_AROUND 62     // as TEX_SHADOW
#define TEX_AROUND_CELLS 63
#define TEX_SHADOW 12  // bound by who makes them, for the whole frame
#define TEX_SHADE 13
#define TEX_OBJECT 7  // as blades: bound for each draw
#define TEX_MASK 14
