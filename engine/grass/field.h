// What all of grass's tiers share of a field: patches, blade textures, maps, and how much light grass leaves to the
// soil. Does not: draw.
#pragma once
#include "frame/color_image.h"
#include "frame/draw_context.h"
#include "grass/appearance.h"
#include "grass/cells.h"
#include "grass/slice_textures.h"
#include "scene/unique.h"

namespace sward {

struct FieldSpecies {
    uint64_t key = 0;  // patchKey
    Patch patch;
    UniqueBlades unique;    // where each cell has blades of its own; else empty
    uint64_t uniqueOf = 0;  // what they were made of: uniqueKey, and the density
    Map uniqueDensity;
    uint64_t uniqueKey = 0;  // another each time that they are made
    // What is drawn blade by blade; slices, masks and means are the patch's.
    const Patch& drawn() const { return unique.empty() ? patch : unique.patch; }
    uint64_t drawnKey() const { return unique.empty() ? key : uniqueKey; }
    Buffer globals;  // SpeciesGlobals
    Rgba8 bladeImage;
    uint64_t bladeHash = 0;  // of the image: hashed when it is loaded, not each frame
    Texture bladeTexture;
    std::string textureOf = "?";
    Look look;  // of the patch, for appearances
    uint64_t lookKey = 0;
    // Slices, kept by grass/slices.cpp while a tier wants them.
    uint64_t sliceKey = 0;    // of what the textures were made from; 0: none
    uint64_t sliceAsked = 0;  // the same without a look at the blade's image, once they are there
    SliceTextures slices;
    Job<SliceImages> bake;
    uint64_t bakeOf = 0;  // what it makes
    uint64_t gainKey = 0;
    Gains gains;
    Buffer sliceGlobals;  // SliceGlobals
};
struct FieldState : EffectState {
    std::vector<std::unique_ptr<FieldSpecies>> species;  // the field's first MAX_SPECIES
    Buffer cover;
    Texture everywhere;  // the density of species without a map, where others have one: 1
    void jobs(std::vector<JobNews>& out) const override;
};

// Row of the effect "grass/field" (techniques.cpp): runs in scenes with Grass and Terrain.
const EffectRow& fieldEffect();
// Says why far grass is darker; the programs that draw it make it so.
const EffectRow& farDarkeningEffect();

// The query for a species' drawn blades in this view.
CellQuery drawnQuery(const DrawContext& ctx, const GrassField& field, size_t species);

// Instance attributes 0 to 3 of a mesh: cell, corner relative to the eye, mirror, shift, as CellInstance and SliceCell
// are.
void describeCells(GLuint mesh, GLuint cells, size_t stride, GLuint indices);
// Blending and tests of the field's way with part-covered pixels (section 4.2), and back.
void beginTransparency(const DrawContext& ctx, const GrassField& field);
void endTransparency();
// Shape and veins of a species' blades: its texture, or one that is made.
Rgba8 bladeImage(const Project& project, const Species& species);
// What shaders of this field know at compile time beside features.
std::string fieldConstants(const GrassField& field);
// One of these texts for each value of each constant, and all ways to light slices (ProgramRow::variants).
std::vector<std::string> fieldVariants();

}  // namespace sward
