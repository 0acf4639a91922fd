#include "scene/moved_fields.h"

namespace sward {

std::span<const MovedField> movedFields() {
    static constexpr MovedField kRows[] = {{"GrassField", "minGeom", "HybridTiers"},
                                           {"GrassField", "maxGeom", "HybridTiers"},
                                           {"GrassField", "minBTF", "HybridTiers"},
                                           {"GrassField", "maxBTF", "HybridTiers"},
                                           {"GrassField", "slices", "GrassSlices"},
                                           {"GrassField", "sliceWidth", "GrassSlices"},
                                           {"GrassField", "sliceHeight", "GrassSlices"},
                                           {"GrassField", "farSize", "GrassSlices"},
                                           {"GrassField", "farHeight", "GrassSlices"},
                                           {"GrassField", "storage", "GrassSlices"},
                                           {"GrassField", "sliceCover", "GrassSlices"},
                                           {"GrassField", "lightWeights", "GrassSlices"},
                                           {"GrassField", "weightsAt", "GrassSlices"},
                                           {"GrassField", "filtering", "GrassSlices"},
                                           {"GrassField", "sharpness", "GrassSlices"},
                                           {"GrassField", "transparency", "GrassDrawing"},
                                           {"GrassField", "culling", "GrassDrawing"},
                                           {"GrassField", "fade", "GrassDrawing"},
                                           {"GrassField", "shadowMask", "GrassDrawing"},
                                           {"GrassField", "groundShadows", "GrassDrawing"},
                                           {"GrassField", "maxDistance", "TessellatedBlades"},
                                           {"GrassField", "levelBy", "TessellatedBlades"},
                                           {"GrassField", "pixelsPerQuad", "TessellatedBlades"},
                                           {"GrassField", "thinning", "TessellatedBlades"},
                                           {"GrassField", "widening", "TessellatedBlades"},
                                           {"GrassField", "lowerFrom", "TessellatedBlades"},
                                           {"GrassField", "beyond", "TessellatedBlades"},
                                           {"GrassField", "tessellation", "TessellatedBlades"},
                                           {"GrassField", "farBlur", "FarLook"},
                                           {"GrassField", "farBlurDistance", "FarLook"},
                                           {"GrassField", "farDarkening", "FarLook"},
                                           {"GrassField", "farDarkeningDistance", "FarLook"}};
    return kRows;
}

const char* movedTo(std::string_view component, std::string_view field) {
    for (const MovedField& m : movedFields())
        if (component == m.component && field == m.field) return m.to;
    return nullptr;
}

}  // namespace sward
