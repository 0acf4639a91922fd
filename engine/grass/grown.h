// What of the fields is the same in every view of a frame, field by field: patches, blade textures, maps, and what is
// made of them. Does not: know where a view draws them (grass/field.h).
#pragma once
#include "frame/color_image.h"
#include "frame/draw_context.h"
#include "grass/among.h"
#include "grass/appearance.h"
#include "grass/blade_cover.h"
#include "grass/cells.h"
#include "grass/slice_settings.h"
#include "grass/slice_textures.h"
#include "scene/technique.h"
#include "scene/unique.h"

namespace sward {

struct GrownSpecies {
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
    uint64_t globalsHash = 0;
    Rgba8 bladeImage;
    AlphaMoments cover{};    // of the image
    glm::vec3 imageColor{};  // mean of the image (linear)
    uint64_t bladeHash = 0;  // of the image: hashed when it is loaded, not each frame
    Texture bladeTexture;
    std::string textureOf = "?";
    Look look;  // of the patch, for appearances
    uint64_t lookKey = 0;
    mutable DensityRanges ranges;  // of its density map; whoever asks for cells adds to them
    GLuint density = 0;  // the texture of its density map; 0: it grows everywhere, and so do its field's other species
    BladeShade shade;    // by grass/mask
    // Slices, kept by grass/slices.cpp while a tier wants them.
    uint64_t sliceKey = 0;    // of what the textures were made from; 0: none
    uint64_t sliceAsked = 0;  // the same without a look at the blade's image, once they are there
    SliceTextures slices;
    Job<SliceImages> bake;
    uint64_t bakeOf = 0;  // what it makes
    uint64_t gainKey = 0;
    Gains gains;
    uint64_t lampGainKey = 0;
    Texture lampGains;  // of lampGainsOf, while there are lamps
    // While it grows on objects: gains of the sky's light alone, and the texture of sunGainsOf.
    uint64_t skyGainKey = 0, sunGainKey = 0;
    Gains skyGains;
    Texture sunGains;
};
struct GrownField {
    std::string name;               // its entity's
    size_t number = 0;              // in GrownFields::all
    std::optional<FieldEntity> of;  // of the frame that is drawn
    FeatureSet own;                 // what this field asks for; a coarser view asks for no more
    FeatureSet features;            // the scene's without other fields'
    std::vector<std::unique_ptr<GrownSpecies>> species;
    Texture everywhere;  // the density of species without a map, where others of the field have one: 1
    GLuint orientation = 0, vegetation = 0, occlusion = 0, forces = 0,
           bladeHeights = 0;  // textures of its maps; 0: none
    DensitiesAmong among;
    const GrassField& grows() const { return of->grows; }
    bool draws(Feature f) const { return has(own, f); }
};
struct GrownFields : EffectState {
    std::vector<std::unique_ptr<GrownField>> all;  // in the order of their names
    void jobs(std::vector<JobNews>& out) const override;
};

// The scene's features, but of fields only one's own.
FeatureSet featuresFor(const DrawContext& ctx, const FeatureSet& own);
// Calls visit(field, number of the species) for the species of the fields that are drawn by a feature.
template <class F>
void eachGrown(const DrawContext& ctx, Feature f, F&& visit) {
    if (!ctx.shared.grown) return;
    for (const std::unique_ptr<GrownField>& field : ctx.shared.grown->all)
        for (size_t i = 0; field->draws(f) && i < field->species.size(); ++i) visit(*field, i);
}
// Brings all fields up to what the project says: what the system "grass/field/grown" does.
void growFields(DrawContext& ctx);

// Shape and veins of a species' blades: its texture, or one that is made.
Rgba8 bladeImage(const Project& project, const Species& species);
// Refuses a population of blades of their own that is too large to be made.
const EffectRow& uniqueEffect();

}  // namespace sward
