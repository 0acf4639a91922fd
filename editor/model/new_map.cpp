#include "model/new_map.h"

#include <fmt/format.h>

#include "scene/map_fields.h"
#include "tools/stroke.h"

namespace sward {
namespace {

// Metres that the map covers along its longer side; a scene without ground gets a modest map.
double extentOf(const Project& p, const ConstFieldRef& map) {
    const Result<MapScale> scale = mapScale(p, map);
    return scale ? std::max(scale->width, scale->depth) : 100;
}

// Rows of texels with these values, as they lie in memory.
std::vector<std::byte> rowOf(const MapInfo& info, const glm::vec4& value) {
    Map row({info.width, 1, info.channels, info.type});
    for (int x = 0; x < info.width; ++x)
        for (int c = 0; c < info.channels; ++c) row.set(x, 0, c, value[c]);
    std::vector<std::byte> bytes(size_t(info.width) * row.texelBytes());
    row.readRows(0, 1, bytes.data());
    return bytes;
}

}  // namespace

MapInfo newMapInfo(const Project& p, const ConstFieldRef& map) { return newMapInfo(*map.row->map, extentOf(p, map)); }

Map newMap(const Project& p, const ConstFieldRef& map) {
    const MapInfo info = newMapInfo(p, map);
    Map made(info);
    const MapKind kind = map.row->map->kind;
    if (kind == MapKind::Colours || kind == MapKind::Heights) return made;
    const std::vector<std::byte> row =
        rowOf(info, kind == MapKind::Amounts ? glm::vec4(1) : glm::vec4(0.5f, 0.5f, 0, 0));
    for (int y = 0; y < info.height; ++y) made.writeRows(y, 1, row.data());
    return made;
}

std::string describeNewMap(const Project& p, const ConstFieldRef& map) {
    const MapInfo info = newMapInfo(p, map);
    const double bytes = double(info.width) * info.height * info.channels * static_cast<double>(pixelBytes(info.type));
    return fmt::format("{} x {} texels, {:.3g} a metre, {:.2g} MB", info.width, info.height,
                       info.width / extentOf(p, map), bytes / 1e6);
}

}  // namespace sward
