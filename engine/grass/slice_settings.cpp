#include "grass/slice_settings.h"

#include "scene/field_rows.h"

namespace sward {
namespace {

// Stored in full a slice has ten images along each axis, and OpenGL 4.5 promises 2048 layers.
constexpr int kMostInFull = 100;
std::vector<std::string> repairSlices(void* component) {
    auto& s = *static_cast<GrassSlices*>(component);
    if (s.storage != Storage::Full || s.slices <= kMostInFull) return {};
    s.slices = kMostInFull;
    return {fmt::format("stored in full there are at most {} slices; slices is now {}", kMostInFull, kMostInFull)};
}

}  // namespace

LightWeighting weightingOf(const GrassSlices& s) {
    const bool none = s.storage == Storage::Full && s.lightWeights == LightWeighting::Cosine;
    return none ? LightWeighting::Atan : s.lightWeights;
}

ComponentRow grassSlicesRow() {
    static constexpr Range kTexels{8, 2048, 32, 512};
    static constexpr FieldRow kFields[] = {
        whole("slices", offsetof(GrassSlices, slices), "", {1, kMaxSlices, 4, 20},
              "vertical slices through a cell along x, and as many along z"),
        whole("sliceWidth", offsetof(GrassSlices, sliceWidth), "texels", kTexels,
              "width of a vertical slice's images, made a power of two"),
        whole("sliceHeight", offsetof(GrassSlices, sliceHeight), "texels", kTexels,
              "height of a vertical slice's images, made a power of two"),
        titled("Flat image size", whole("farSize", offsetof(GrassSlices, farSize), "texels", kTexels,
                                        "side of the horizontal slice's images, made a power of two")),
        titled("Height of the flat slice",
               real("farHeight", offsetof(GrassSlices, farHeight), "", kShare,
                    "where the horizontal slice lies, as a share of the tallest blade's height")),
        choice("storage", &GrassSlices::storage, offsetof(GrassSlices, storage), kStorages,
               "how slices are stored: factored, compressed, or an image a light as published"),
        titled(
            "Image sets",
            choice("sets", &GrassSlices::sets, offsetof(GrassSlices, sets), kSliceSets,
                   "images of slices across each axis, or of those across x for both: half the memory, other blades")),
        titled("Coverage of slices",
               choice("sliceCover", &GrassSlices::sliceCover, offsetof(GrassSlices, sliceCover), kSliceCovers,
                      "slices cover what the blades would in this view, or all that they hold, as published")),
        choice("lightWeights", &GrassSlices::lightWeights, offsetof(GrassSlices, lightWeights), kLightWeights,
               "how a slice's images are weighted by the light: by its cosine, or interpolated by a form of equations "
               "8-13"),
        choice("weightsAt", &GrassSlices::weightsAt, offsetof(GrassSlices, weightsAt), kWeightsAt,
               "where point lights' weights are computed"),
        choice("filtering", &GrassSlices::filtering, offsetof(GrassSlices, filtering), kFilterings,
               "how the horizontal slice is filtered"),
        real("sharpness", offsetof(GrassSlices, sharpness), "levels", {-2, 8, 0, 4},
             "how much finer than a pixel slices are sampled: 0 smooth, more as grainy as blades"),
    };
    ComponentRow row = settingsRow<GrassSlices>("GrassSlices", "How the images of distant blades are made and shown.",
                                                kFields, "GrassField");
    row.repair = repairSlices;
    return row;
}

}  // namespace sward
