// What the images of slices send on average: of the horizontal slice all of it, of vertical slices what a view shows of
// their rows. Gains are taken over these means (grass/appearance.h), so that they hold for what is drawn, not for what
// blades would have stored. Pure. Does not: make images (grass/slice_bake.h), nor know what blades send.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "grass/field_light.h"
#include "grass/slice_bake.h"
#include "shared/slices.h"

namespace sward {

// What the horizontal slice's images hold of blades seen from above, a texel of some level.
struct FarTexel {
    glm::vec3 color;     // reflectance
    float open, shown;   // share of ambient light that reaches it; how much of it shows
    glm::vec4 sides;     // light from x+, x-, z+, z-
    float above, below;  // light from above, on the side that is seen and on the other
};
using FarImage = std::array<std::vector<FarTexel>, FAR_LEVELS>;

// A texel of vertical slices, from either side: light that faces it, from the sides, and from above.
struct SliceTexel {
    glm::vec3 color;
    float open, opacity;
    struct Side {
        float facing, plus, minus, above;
    } front, back;
};
// Texels at about one height, of all slices across one axis.
struct SliceRow {
    std::vector<SliceTexel> texels;  // some of them
    float opacity = 0, covered = 0;  // mean over all of them; over those that cover anything, by how much they do
};
inline constexpr int kSliceRows = 8;  // from the ground up
// Across x, and across z.
using SliceRows = std::array<std::array<SliceRow, kSliceRows>, 2>;
struct StandingImage {
    std::array<SliceRows, SLICE_LEVELS> levels;  // none where vertical slices are not shown
    int width = 1, height = 1;                   // texels of the finest level
    float top = 0;                               // metres
};

// How vertical slices stand, and are looked at: drawn one by one, or by rays (lib/slice_rays.glsl), which go so many
// steps, have one slice more for the rest, and show the two that send most for all that they meet.
struct SliceStand {
    float apart = 0;     // metres from slice to slice
    float across = 1;    // metres that an image covers along the slice: a cell
    float steepest = 1;  // as SliceGlobals has it
    float density = 1;   // share of the blades for which slices stand
    bool traced = false;
    int steps = 0;           // of rays, at most
    float footprint = 0;     // as RaytracedGrass has it
    float sharpness = 0;     // levels by which slices are sampled finer than a pixel
    bool restShown = false;  // whether the rest is its mean
};
// Rows come in sets: of slices across x and across z, and of both what stands for the rest of a ray, at this level.
inline constexpr size_t kRowSets = 4, kRestLevel = 4;
// Of what is seen along a direction, by set and row: shares that sum to 1, or to 0 where nothing is.
using RowShares = std::array<std::array<float, kSliceRows>, kRowSets>;
// What rows send, by set, by side of the eye (behind its axis, before it), by row.
using RowsSend = std::array<std::array<std::array<glm::vec3, kSliceRows>, 2>, kRowSets>;

// Where the gains of vertical slices hold: the level of what is lit.
inline constexpr size_t kShownLevel = 1;
// The i-th of the tabulated views (appearance.h, Gains), towards the eye, unit.
glm::vec3 lookView(size_t i);
// A direction of this azimuth (radians from x towards z) and height as lookHeight has it, in [0, 1].
glm::vec3 lookDirection(float azimuth, float height);
// A view of this elevation that lies along neither axis.
inline glm::vec3 usualView(size_t elevation) {
    return lookDirection(0.4f, static_cast<float>(elevation) / (LOOK_ELEVATIONS - 1));
}
// Factors of vertical slices by elevation of the view and by level of what is lit.
using LevelFactors = std::array<std::array<float, SLICE_LEVELS>, LOOK_ELEVATIONS>;
// All of them 1.
LevelFactors evenLevels();

// What vertical slices show: to the tabulated views; by elevation and level; and by elevation, where they stand for all
// of the blades and for one in THIN_DENSITY.
struct ShownShares {
    std::array<RowShares, LOOK_VIEWS> views{};
    std::array<std::array<RowShares, SLICE_LEVELS>, LOOK_ELEVATIONS> levels{};
    std::array<RowShares, LOOK_ELEVATIONS> full{}, thin{};
};
// All of them for images that stand so.
ShownShares shownShares(const StandingImage& image, const SliceStand& stand);

// All that gains are told from, in a few hundred kilobytes.
struct DrawnImages {
    FarImage far;
    StandingImage standing;
    SliceStand stand;
    ShownShares shown;
    uint64_t key = 0;  // hash of all of it
};
// vertical: whether those are shown; sets: which of them slices across z show.
DrawnImages drawnImagesOf(const SliceImages& images, bool vertical, SliceSets sets, const SliceStand& stand);

// The finest level of the horizontal slice, this one of vertical slices and that of the rest, all of one reflectance.
DrawnImages colored(const DrawnImages& images, size_t level, const glm::vec3& color);

// e: towards the eye, unit, above the horizon; level: of detail of what is lit.
RowShares sharesSeen(const StandingImage& image, size_t level, const glm::vec3& e, const SliceStand& stand);
// At most so many texels of a row are read.
RowsSend rowsSend(const StandingImage& image, size_t level, const FieldLight& light, const glm::vec3& ambient,
                  size_t texels);
// The mean of what rows send by their shares; e: towards the eye, which side of the slices is seen.
glm::vec3 sentAlong(const RowShares& shares, const RowsSend& sends, const glm::vec3& e);
// What an image of the horizontal slice sends, over cells that are mirrored all ways.
glm::vec3 imageSends(const std::vector<FarTexel>& image, const FieldLight& light, const glm::vec3& ambient);
// Five weights (x+, y, z+, x-; z- is what is left to 1) by a form of equations 8-13; Cosine: by the exact one, and
// so is the published one where it has no value (B-1, B-4).
glm::vec4 imageWeights(const glm::vec3& towardsLight, LightWeighting weighting);

}  // namespace sward
