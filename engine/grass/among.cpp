#include "grass/among.h"

#include <cmath>

#include "core/hash.h"
#include "core/numerics.h"
#include "scene/tiling.h"

namespace sward {
namespace {

constexpr size_t kPlaces = 32;  // that are looked at, along either side of the terrain

// A species' density at these places, row by row.
std::vector<float> densitiesOf(const Species& s, const Terrain& t) {
    std::vector<float> out(kPlaces * kPlaces, 1.0f);
    if (!s.density.present()) return out;
    const Tiling tiling = tilingOf(t, s.densityTiling);
    for (size_t i = 0; i < out.size(); ++i) {
        const glm::dvec2 at = (glm::dvec2(i % kPlaces, i / kPlaces) + 0.5) / double(kPlaces) * t.size;
        out[i] = tiledSample(s.density.map, tiling, at.x, at.y);
    }
    return out;
}

uint64_t keyOf(const GrassField& field, const Terrain& t) {
    std::vector<double> read{t.size.x, t.size.y, mapExtent(t).x, mapExtent(t).y};
    for (const Species& s : field.species) read.push_back(static_cast<double>(s.densityTiling));
    return hashBytes(read.data(), read.size() * sizeof(double));
}
bool isOf(const DensitiesAmong& among, const GrassField& field, uint64_t key) {
    if (among.key != key || among.madeFrom.size() != field.species.size()) return false;
    for (size_t i = 0; i < field.species.size(); ++i)
        if (!among.madeFrom[i].sameTiles(field.species[i].density.map)) return false;
    return true;
}

}  // namespace

float amongLeave(const std::vector<Among>& among, float high, const glm::vec3& towards) {
    float depth = 0;
    for (const Among& a : among) {
        const float share = f32::shareAbove(a.height, high);
        depth += a.density * (towards == glm::vec3(0) ? f32::skyDepthAbove(a.skyLeft, share)
                                                      : f32::depthAbove(a.area, share, towards, towards.y));
    }
    return std::exp(-depth);
}

void updateDensitiesAmong(DensitiesAmong& among, const GrassField& field, const Terrain& t) {
    const size_t n = field.species.size();
    if (n < 2) {
        among = {};
        return;
    }
    const uint64_t key = keyOf(field, t);
    if (isOf(among, field, key)) return;
    among = {std::vector<float>(n * n, 1.0f), {}, key};
    std::vector<std::vector<float>> densities;
    for (const Species& s : field.species) {
        among.madeFrom.push_back(s.density.map);
        densities.push_back(densitiesOf(s, t));
    }
    for (size_t i = 0; i < n; ++i)
        for (size_t k = 0; k < n; ++k) {
            double own = 1e-9, both = 0;
            for (size_t p = 0; p < kPlaces * kPlaces; ++p)
                own += double(densities[i][p]), both += double(densities[i][p] * densities[k][p]);
            among.means[i * n + k] = static_cast<float>(both / own);
        }
}

}  // namespace sward
