#include "scene/map_fields.h"

#include <algorithm>
#include <cmath>

namespace sward {
namespace {

// "lawn.GrassField.species[a].density" -> "lawn.GrassField.species[a].densityTiling"
std::string pathBeside(const std::string& path, const FieldRow& row) {
    return path.substr(0, path.rfind('.') + 1) + row.name;
}

template <class Byte, class Ref>
Ref beside(const Ref& map, const FieldRow& row) {
    CHECK(map.row->type == FieldType::Map);
    return {static_cast<Byte*>(map.value) - map.row->offset + row.offset, &row, map.component, map.entity,
            pathBeside(map.path, row)};
}

}  // namespace

FieldRef fieldBeside(const FieldRef& map, const FieldRow& row) { return beside<std::byte>(map, row); }
ConstFieldRef fieldBeside(const ConstFieldRef& map, const FieldRow& row) { return beside<const std::byte>(map, row); }

float mapTiling(const ConstFieldRef& map) {
    const FieldRow* tiling = map.row->map->tiling;
    return tiling ? *static_cast<const float*>(fieldBeside(map, *tiling).value) : 1;
}

MapInfo newMapInfo(const MapRow& row, double metres) {
    const double texels = std::clamp(metres * row.texelsPerMetre, 256.0, 4096.0);
    const int side = static_cast<int>(std::exp2(std::ceil(std::log2(texels))));
    return {side, side, row.channels, row.type};
}

MapWish mapWish(const FieldRow& map) {
    MapWish wish;
    wish.channels = map.map->channels;
    wish.isHeight = map.map->kind == MapKind::Heights;
    return wish;
}

}  // namespace sward
