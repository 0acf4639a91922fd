// How the images that stand for distant blades are made, kept, lit and sampled: settings of every technique that draws
// slices. Source: Boulanger, Pattanaik and Bouatouch 2006, sections 3.3 and 4.1. Does not: make or draw them
// (grass/slice_bake.h, grass/slices.h).
#pragma once
#include "core/enum_names.h"
#include "scene/rows.h"

namespace sward {

// How slices are stored: reflectance once and a number a light direction; that compressed; the paper's, an image a
// light.
enum class Storage { Factored, Compressed, Full };
inline constexpr auto kStorages = enumNames<Storage>("factored", "compressed", "full");
// How much of slices shows: as much as blades would cover in this view; or all of every slice, as published.
enum class SliceCover { Conserving, Published };
inline constexpr auto kSliceCovers = enumNames<SliceCover>("conserving", "published");
// How a slice's images are weighted by a directional light: by the cosine that their differences give (exact where a
// texel shows one blade), or interpolated as published, by a form of equations 8-13 (docs/numerics.md has what each
// costs). What is stored in full has no cosine (weightingOf).
enum class LightWeighting { Cosine, Atan, Poly9, Poly7, Poly5, Poly3, Linear, Squares, Published };
inline constexpr auto kLightWeights =
    enumNames<LightWeighting>("cosine", "atan", "poly9", "poly7", "poly5", "poly3", "linear", "squares", "published");
// Whether slices across z have images of their own, or show those of the slices across x (Habel, Wimmer and Jeschke
// 2007, section 3: one set or two), which takes half the memory, but shows blades where they do not stand.
enum class SliceSets { Each, Shared };
inline constexpr auto kSliceSets = enumNames<SliceSets>("each", "shared");
// Where the weights of point lights are computed.
enum class WeightsAt { Vertex, Pixel };
inline constexpr auto kWeightsAt = enumNames<WeightsAt>("vertex", "pixel");
// How the horizontal slice is filtered.
enum class Filtering { Trilinear, Anisotropic };
inline constexpr auto kFilterings = enumNames<Filtering>("trilinear", "anisotropic");

inline constexpr int kMaxSlices = 256;  // through a cell along an axis
struct GrassSlices {
    int slices = 10;                         // vertical slices through a cell along x, and as many along z
    int sliceWidth = 256, sliceHeight = 64;  // texels of a vertical slice
    int farSize = 256;                       // texels of the horizontal slice, each way
    float farHeight = 0.3f;  // where the horizontal slice lies, as a share of the tallest blade's height
    Storage storage = Storage::Factored;
    SliceSets sets = SliceSets::Each;
    SliceCover sliceCover = SliceCover::Conserving;
    LightWeighting lightWeights = LightWeighting::Cosine;
    WeightsAt weightsAt = WeightsAt::Vertex;
    Filtering filtering = Filtering::Trilinear;
    float sharpness = 2;  // levels of detail by which slices are sampled finer than a pixel
};

// How the slices are weighted: as they say, but for images stored in full, which hold colours and no normals to take
// a cosine of: these are interpolated, by the exact form of equations 8-13.
LightWeighting weightingOf(const GrassSlices& slices);
// The field table of GrassSlices.
ComponentRow grassSlicesRow();

}  // namespace sward
