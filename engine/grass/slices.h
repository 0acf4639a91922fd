// Grass as slices: vertical ones through the cells at middle distance, one horizontal over the ground as far as it
// reaches. Source: Boulanger, Pattanaik and Bouatouch 2006, sections 3.3, 3.4, 4.1 and appendix; B-1 to B-18, B-26. The
// horizontal slice lies on the terrain's own quadtree nodes (macro-cells), lifted; cells repeat in it by integer id.
// Ours, where GrassSlices.sliceCover is "conserving" (the paper's form stays selectable):
//   - a blade is in a slice of either family. Seen from between both would cover up to 1.4 times what the blade does,
//   so each
//     family shows the share |cos| of its blades by which it is turned to the eye: cos^2 + sin^2 = 1.
//   - the horizontal slice is opaque by Beer's law along the slanted ray, less what vertical slices already cover.
//   - from steeply above, where one would look between them, vertical slices give way to the horizontal one.
//   - each end of a vertical slice is moved a little along the cells' edge that it lies on.
//   - where grass is pressed, vertical slices sink, and the horizontal one covers what they leave, as blades that lie
//   do.
//   - every tier is scaled to the mean radiance of the blades it stands for (appearance.h).
// Does not: bake (slice_bake.h).
#pragma once
#include "grass/slice_bake.h"
#include "scene/project.h"
#include "scene/technique.h"
#include "shared/slices.h"
#include "shared/terrain.h"

namespace sward {

struct Field;       // grass/field.h
struct GrownField;  // grass/grown.h

const EffectRow& slicesEffect();  // vertical
const EffectRow& farEffect();     // horizontal; makes and holds the slices of both

// How images are read between two levels of detail: blended, or by the nearer one, for who chooses that at random.
enum class SliceLevels { Blended, One };
// Binds the images of the vertical slices of a field's species, filtered for this view, and its density map.
void bindVerticalSlices(const DrawContext& ctx, const Field& field, size_t species, SliceLevels levels);
// Brings images and gains up to date of all species of fields that are drawn by a feature.
void makeSlices(DrawContext& ctx, Feature feature);
// What shaders know of a species' slices over level ground, seen from this view.
SliceGlobals sliceGlobalsOf(const DrawContext& ctx, const Field& field, size_t species);
// Whether a field's vertical slices are drawn or traced, so that their images are there.
bool showsVertical(const GrownField& field);

// A species of a field whose horizontal slice is drawn, or shades what is below it, over these nodes of the ground.
struct FarSpecies {
    const Field* field;
    size_t species;
    std::span<const TerrainNode> nodes;
};
// The nodes of the ground under a field's horizontal slices: where not all of it is drawn blade by blade, to so far
// from the eye (m).
std::vector<TerrainNode> farNodes(const DrawContext& ctx, const Field& field, float far);
// Draws these nodes by the program in use, with the species' images; its field is bound. room: holds NODES_PER_DRAW
// nodes.
void drawFarSpecies(DrawContext& ctx, const FarSpecies& far, const Buffer& room);

// What the slices of a field's species (by its number) are made from. shaded: with the blades' shadows on each other;
// draft: an eighth of the resolution, made while one waits.
SliceSpec sliceSpec(const FieldEntity& field, size_t species, const Rgba8& blade, bool shaded, bool draft = false);
// The slices of a spec: from a cache folder, or made and put there. Failed only if cancelled. `cached`, if given: they
// were there.
Result<SliceImages> slicesOf(const std::filesystem::path& folder, const SliceSpec& spec, JobControl& control,
                             bool* cached = nullptr);
// Of every species of every field; none where no tier wants them.
std::vector<SliceSpec> projectSlices(const Project& project, const Tables& tables);

}  // namespace sward
