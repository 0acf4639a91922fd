#include "model/path_ground.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/ground_path.h"
#include "scene/tiling.h"
#include "world/ground.h"

namespace sward {
namespace {

// The heights with the path's in them. `t` has a map that lies on it once.
Map flattened(const Terrain& t, const GroundPath& path) {
    Map map = t.height.map;
    const MapInfo& info = map.info();
    const auto [offset, scale] = heightScale(t);
    const GroundCurve curve = groundCurve(path);
    const GroundBox box = boxOf(curve, reachOf(path));
    const glm::dvec2 texel = t.size / glm::dvec2(info.width, info.height);
    const auto within = [](double at, int most) {
        return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(most)));
    };
    for (int y = within(box.low.y / texel.y - 1, info.height); y < within(box.high.y / texel.y + 1, info.height); ++y)
        for (int x = within(box.low.x / texel.x - 1, info.width); x < within(box.high.x / texel.x + 1, info.width);
             ++x) {
            const glm::dvec2 at = (glm::dvec2(x, y) + 0.5) * texel;
            const NearestOnCurve nearest = nearestOn(curve, at, reachOf(path));
            const double weight = weightAt(path, nearest.distance);
            if (!(weight > 0)) continue;
            const double level = scale != 0 ? (terrainHeight(t, nearest.at.x, nearest.at.y) - offset) / scale : 0;
            const double before = static_cast<double>(map.at(x, y));
            map.set(x, y, 0, static_cast<float>(before + (level - before) * weight));
        }
    return map;
}

}  // namespace

Status flattenAlong(Document& document, const std::string& entity) {
    const Entity e = findEntity(document.project(), entity);
    const GroundPath* path = e == kNoEntity ? nullptr : document.project().registry.get<GroundPath>(e);
    if (!path || groundCurve(*path).pieces.empty())
        return usage(fmt::format("\"{}\" has no GroundPath with points", entity), "draw one with the path tool (P)");
    const Terrain* t = findGround(document.project()).terrain;
    if (!t || !t->height.present()) return usage("there is no map of heights: the ground is level already");
    if (tilingOf(*t, t->heightTiling).repeats)
        return usage("the heights are mirrored, and the path would lie in every repeat",
                     "set Terrain.heightTiling to 1 and Terrain.mapSize to 0");
    return document.setMap(entityOf(document.project(), *t) + ".Terrain.height", flattened(*t, *path),
                           "flatten along " + entity);
}

}  // namespace sward
