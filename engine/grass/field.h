// What all of a field's tiers share, field by field: patches, blade textures, maps, and how much light grass leaves to
// the soil. Does not: draw.
#pragma once
#include "frame/color_image.h"
#include "frame/draw_context.h"
#include "grass/appearance.h"
#include "grass/cells.h"
#include "grass/drawing.h"
#include "grass/slice_settings.h"
#include "grass/slice_textures.h"
#include "scene/technique.h"
#include "scene/unique.h"

namespace sward {

// A species' blades as they are drawn this frame, for passes that draw them once more. Nothing selected: count 0.
struct BladeDraws {
    GLuint mesh = 0, indices = 0, buffer = 0,
           globals = 0;  // vertex array with cells; indices of whole strips; SSBO_BLADES; UBO_SPECIES
    const CellDraw* cells = nullptr;
    size_t count = 0;
    GLuint shadowCommands =
        0;  // `count` commands that the GPU made of cells that it chose, at shadowOffset bytes; 0: the cells are here
    size_t shadowOffset = 0;
    uint32_t strips = 0;  // blades that the indices hold
    int segments = 0;
    uint32_t verticesABlade = 0;  // of drawCommand (grass/cells.h)
    float shading = 1;            // share of them that is enough to shade the soil as all of them would
};

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
    GLuint density = 0;  // the texture of its density map; 0: it grows everywhere, and so do its field's other species
    BladeShade shade;    // by grass/mask
    BladeDraws draws;    // by grass/geometry
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

// A field as this view draws it.
struct GrassView {
    FieldEntity of;
    FeatureSet own;         // what this field asks for in this view
    FeatureSet features;    // the scene's without other fields': what this field's programs are compiled for
    std::string constants;  // featureConstants(features)
    FieldTiers tiers;
    template <class C>
    const C& settings() const {
        return of.settings<C>();
    }
};
struct Field {
    std::string name;               // its entity's
    std::optional<GrassView> view;  // of the frame that is drawn
    std::vector<std::unique_ptr<FieldSpecies>> species;
    Buffer cover;        // CoverGlobals
    Texture everywhere;  // the density of species without a map, where others of the field have one: 1
    GLuint orientation = 0, vegetation = 0, occlusion = 0, forces = 0,
           bladeHeights = 0;  // textures of its maps; 0: none
    const GrassField& grows() const { return view->of.grows; }
};
struct GrassFields : EffectState {
    std::vector<std::unique_ptr<Field>> all;  // in the order of their names
    Buffer soil;                              // SoilGlobals
    void jobs(std::vector<JobNews>& out) const override;
};

// The fields that this frame draws by a feature; none before grass/field has ticked.
std::vector<Field*> fieldsWith(const DrawContext& ctx, Feature f);
// What a stem keeps for each species of each field: the numbers are those of GrassFields::all and Field::species.
template <class S>
struct PerSpecies {
    std::vector<std::vector<std::unique_ptr<S>>> fields;
    // Made where it is absent.
    S& at(size_t field, size_t species) {
        if (fields.size() <= field) fields.resize(field + 1);
        auto& one = fields[field];
        if (one.size() <= species) one.resize(species + 1);
        if (!one[species]) one[species] = std::make_unique<S>();
        return *one[species];
    }
    // Forgets fields and species that are gone, and those of fields that are not drawn by a feature.
    void keep(const GrassFields& of, Feature drawn) {
        fields.resize(of.all.size());
        for (size_t i = 0; i < fields.size(); ++i)
            fields[i].resize(has(of.all[i]->view->own, drawn) ? of.all[i]->species.size() : 0);
    }
};
// Calls visit(field, species, its state) for the species of the fields that this frame draws by a feature.
template <class S, class F>
void eachSpecies(const DrawContext& ctx, PerSpecies<S>& states, Feature f, F&& visit) {
    if (!ctx.shared.grass) return;
    const GrassFields& grass = *ctx.shared.grass;
    for (size_t i = 0; i < grass.all.size(); ++i) {
        if (!has(grass.all[i]->view->own, f)) continue;
        for (size_t k = 0; k < grass.all[i]->species.size(); ++k) visit(*grass.all[i], k, states.at(i, k));
    }
}

// Row of the effect "grass/field" (techniques.cpp): runs in scenes with Grass and Terrain.
const EffectRow& fieldEffect();
// Says why far grass is darker; the programs that draw it make it so.
const EffectRow& farDarkeningEffect();
// Refuses a population of blades of their own that is too large to be made.
const EffectRow& uniqueEffect();

// Its maps and globals for what is drawn next.
void bindField(const Field& field);
// The query for a species' drawn blades in this view.
CellQuery drawnQuery(const DrawContext& ctx, const Field& field, size_t species);
// The query for cells of a species' patch in this view, by a range of distances.
CellQuery patchQuery(const DrawContext& ctx, const Field& field, size_t species, float pixelsPerMetre);

// Instance attributes 0 to 3 of a mesh: cell, corner relative to the eye, mirror, shift, as CellInstance and SliceCell
// are.
void describeCells(GLuint mesh, GLuint cells, size_t stride, GLuint indices);
// Makes the pass's program current for a field, binds its maps, and begins its transparency; false if it does not
// compile.
bool beginField(DrawContext& ctx, const Field& field, size_t program, const std::string& constants);
// Blending and tests of the field's way with part-covered pixels (section 4.2), and back.
void beginTransparency(const DrawContext& ctx, const Field& field);
void endTransparency();
// Shape and veins of a species' blades: its texture, or one that is made.
Rgba8 bladeImage(const Project& project, const Species& species);
// What shaders of this field know at compile time beside features.
std::string fieldConstants(const FieldEntity& field);
std::string fieldConstants(const GrassDrawing& drawing, const GrassSlices& slices);
// One of these texts for each value of each constant, and all ways to light slices (ProgramRow::variants).
std::vector<std::string> fieldVariants();

}  // namespace sward
