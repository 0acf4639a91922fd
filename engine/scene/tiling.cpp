#include "scene/tiling.h"

#include "core/numerics.h"

namespace sward {

glm::dvec2 mapExtent(const Terrain& t) { return t.mapSize > 0 ? glm::dvec2(static_cast<double>(t.mapSize)) : t.size; }

Tiling tilingOf(const Terrain& t, float tiling) {
    if (tiling == 1 && !(t.mapSize > 0)) return {t.size, false};
    return {mapExtent(t) / static_cast<double>(tiling), true};
}

float shaderTiling(const Terrain& t, float tiling) { return tilingOf(t, tiling).repeats ? tiling : 0; }

float tiledSample(const Map& map, const Tiling& tiling, double x, double z, int c) {
    const double u = x / tiling.metres.x, v = z / tiling.metres.y;
    if (!tiling.repeats) return map.sample(u, v, c);
    const f64::BilinearTap t = f64::bilinearTapRepeat(u, v, map.info().width, map.info().height);
    return f32::bilinearMix(map.at(t.x0, t.y0, c), map.at(t.x1, t.y0, c), map.at(t.x0, t.y1, c), map.at(t.x1, t.y1, c),
                            static_cast<float>(t.fx), static_cast<float>(t.fy));
}

float mirroredSample(const Map& map, const Tiling& tiling, double x, double z) {
    const double u = x / tiling.metres.x, v = z / tiling.metres.y;
    return tiling.repeats ? map.sample(f64::mirrorUnit(u), f64::mirrorUnit(v)) : map.sample(u, v);
}

}  // namespace sward
