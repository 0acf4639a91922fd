#include "model/float_heights.h"

#include <cstring>

#include "world/ground.h"

namespace sward {
namespace {

Map metresOf(const Terrain& t) {
    const Map& heights = t.height.map;
    const auto [offset, scale] = heightScale(t);
    MapInfo info = heights.info();
    info.type = PixelType::F32;
    Map metres(info);
    std::vector<float> row(static_cast<size_t>(info.width));
    for (int y = 0; y < info.height; ++y) {
        for (int x = 0; x < info.width; ++x)
            row[static_cast<size_t>(x)] = static_cast<float>(offset + scale * static_cast<double>(heights.at(x, y)));
        metres.writeRows(y, 1, row.data());
    }
    return metres;
}

}  // namespace

Status heightsAsFloats(Document& document) {
    const Ground ground = findGround(document.project());
    if (!ground.terrain || !ground.terrain->height.present())
        return usage("there is no map of heights", "the first stroke on Terrain.height makes one, of floats");
    if (ground.terrain->height.map.info().type == PixelType::F32) return usage("the heights are floats already");
    const std::string path = entityOf(document.project(), *ground.terrain) + ".Terrain.height";
    return document.setMap(path, metresOf(*ground.terrain), "heights as floats");
}

}  // namespace sward
