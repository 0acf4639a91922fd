#include "forest/stretch.h"

#include <algorithm>
#include <cmath>

namespace sward {

glm::dvec3 bakedWay(const glm::dvec3& way, double scale) {
    return scale == 1 ? way : glm::normalize(way / glm::dvec3(1, scale, 1));
}

Facing stretched(const Facing& facing, float scale) {
    if (scale == 1) return facing;
    constexpr int kParts = 8;  // of a bin
    Facing out{};
    float all = 0;
    for (int i = 0; i < kFacingBins * kParts; ++i) {
        const float y = (static_cast<float>(i) + 0.5f) / (kFacingBins * kParts);
        // Normals follow the inverse's columns; areas grow as the cofactors' lengths do, but for a factor of all.
        const float rise = y / scale, grown = std::sqrt(1 - y * y + rise * rise);
        const float area = facing[static_cast<size_t>(i / kParts)] * grown;
        out[static_cast<size_t>(std::min(static_cast<int>(rise / grown * kFacingBins), kFacingBins - 1))] += area;
        all += area;
    }
    for (float& share : out) share /= all;
    return out;
}

}  // namespace sward
