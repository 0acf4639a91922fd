// What all of a field's tiers share in one view: where they draw, by which programs, and how much light grass leaves to
// the soil. Does not: draw, or know how it grew (grass/grown.h).
#pragma once
#include "frame/draw_context.h"
#include "grass/cells.h"
#include "grass/drawing.h"
#include "grass/grown.h"
#include "scene/technique.h"

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

// A species as this view draws it.
struct FieldSpecies {
    const GrownSpecies* grown = nullptr;  // of the field's GrownField, by the same number
    BladeDraws draws;                     // by grass/geometry
    Buffer sliceGlobals;                  // SliceGlobals, by grass/far while a tier wants slices
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
    const GrownField* grown = nullptr;
    size_t number = 0;              // among GrownFields::all
    std::optional<GrassView> view;  // of the frame that is drawn
    std::vector<FieldSpecies> species;
    Buffer globals;  // FieldGlobals
    uint64_t globalsHash = 0;
    const GrassField& grows() const { return view->of.grows; }
    bool draws(Feature f) const { return has(view->own, f); }
};
// The fields of a view: those of GrownFields, in the same order.
struct GrassFields : EffectState {
    std::vector<std::unique_ptr<Field>> all;
    Buffer soil;  // SoilGlobals
    uint64_t soilHash = 0;
};

// The fields that this view draws by a feature; none before grass/field has ticked.
std::vector<Field*> fieldsWith(const DrawContext& ctx, Feature f);
// What a stem keeps for each species of each field, for the project or for one of its views.
template <class S>
struct PerSpecies {
    std::vector<std::vector<std::unique_ptr<S>>> fields;  // by Field::number
    // Made where it is absent.
    S& at(size_t field, size_t species) {
        if (fields.size() <= field) fields.resize(field + 1);
        auto& one = fields[field];
        if (one.size() <= species) one.resize(species + 1);
        if (!one[species]) one[species] = std::make_unique<S>();
        return *one[species];
    }
    // Forgets fields and species that are gone, and those of fields that are not drawn by a feature. `all`: of
    // GrownFields for what is kept for the project, of GrassFields for what is kept for a view.
    template <class Fields>
    void keep(const Fields& all, Feature drawn) {
        fields.resize(all.size());
        for (size_t i = 0; i < fields.size(); ++i) fields[i].resize(all[i]->draws(drawn) ? all[i]->species.size() : 0);
    }
};
// Calls visit(field, number of the species) for the species of the fields that this view draws by a feature.
template <class F>
void eachSpecies(const DrawContext& ctx, Feature f, F&& visit) {
    for (Field* field : fieldsWith(ctx, f))
        for (size_t i = 0; i < field->species.size(); ++i) visit(*field, i);
}

// Row of the effect "grass/field" (techniques.cpp): runs in scenes with Grass and Terrain.
const EffectRow& fieldEffect();
// Says why far grass is darker; the programs that draw it make it so.
const EffectRow& farDarkeningEffect();

// Whether at density 1 every cell of each of its species has all blades of the patch (numerics/sowing.h).
bool isSownWhole(const Field& field);

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
// What shaders of this field know at compile time beside features.
std::string fieldConstants(const FieldEntity& field);
std::string fieldConstants(const GrassDrawing& drawing, const GrassSlices& slices);
// One of these texts for each value of each constant, and all ways to light slices (ProgramRow::variants).
std::vector<std::string> fieldVariants();

}  // namespace sward
