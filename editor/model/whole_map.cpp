#include "model/whole_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <unordered_map>

#include "core/jobs.h"
#include "model/new_map.h"
#include "model/one_step.h"
#include "scene/map_fields.h"

namespace sward {
namespace {

template <class T>
float readStep(const std::byte* at) {
    T v;
    std::memcpy(&v, at, sizeof v);
    return std::is_same_v<T, float> ? static_cast<float>(v)
                                    : static_cast<float>(v) / static_cast<float>(std::numeric_limits<T>::max());
}
template <class T>
void writeStep(std::byte* at, float value) {
    T v;
    if constexpr (std::is_same_v<T, float>)
        v = value;
    else
        v = static_cast<T>(
            std::round(std::clamp(value, 0.0f, 1.0f) * static_cast<float>(std::numeric_limits<T>::max())));
    std::memcpy(at, &v, sizeof v);
}

// A tile of which `width` x `height` texels lie in the map.
template <class T>
std::shared_ptr<const Tile> changedTile(const Tile& tile, int channels, int width, int height, TexelChange change) {
    auto out = std::make_shared<Tile>(tile);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            std::byte* at = out->write() + size_t(y * kTileSize + x) * size_t(channels) * sizeof(T);
            float texel[4] = {};
            for (int c = 0; c < channels; ++c) texel[c] = readStep<T>(at + size_t(c) * sizeof(T));
            change(texel);
            for (int c = 0; c < channels; ++c) writeStep<T>(at + size_t(c) * sizeof(T), texel[c]);
        }
    return out;
}

std::shared_ptr<const Tile> changedTile(const MapInfo& info, const Tile& tile, int width, int height,
                                        TexelChange change) {
    switch (info.type) {
        case PixelType::U8:
            return changedTile<uint8_t>(tile, info.channels, width, height, change);
        case PixelType::U16:
            return changedTile<uint16_t>(tile, info.channels, width, height, change);
        default:
            return changedTile<float>(tile, info.channels, width, height, change);
    }
}

// A tile and how much of it lies in the map: what decides what becomes of it.
struct Piece {
    const Tile* tile;
    int width, height;
    bool operator==(const Piece&) const = default;
};
struct PieceHash {
    size_t operator()(const Piece& p) const {
        return std::hash<const Tile*>()(p.tile) * 31 + static_cast<size_t>(p.width * 129 + p.height);
    }
};
Piece pieceAt(const Map& map, int tx, int ty) {
    return {map.tile(tx, ty).get(), std::min(kTileSize, map.info().width - tx * kTileSize),
            std::min(kTileSize, map.info().height - ty * kTileSize)};
}

void invertAmount(float* texel) { texel[0] = 1 - texel[0]; }
void invertOpacity(float* texel) { texel[3] = 1 - texel[3]; }
void turnRound(float* texel) { texel[0] = 1 - texel[0], texel[1] = 1 - texel[1]; }

bool isHeights(const MapRow& row) { return row.kind == MapKind::Heights; }

// What a map of heights holds at 0 m, or as near to it as it can.
float levelOf(const ConstFieldRef& heights, const Map& map) {
    if (map.info().type == PixelType::F32) return 0;
    const auto range = *static_cast<const glm::dvec2*>(fieldBeside(heights, *heights.row->map->heightRange).value);
    const double share = -range.x / (range.y - range.x);
    return std::isfinite(share) ? static_cast<float>(std::clamp(share, 0.0, 1.0)) : 0.0f;
}

// The map that a path names, made first if it is not there, and `now` in its place; one undo step.
Status replaceMap(Document& doc, const std::string& path, const std::string& verb,
                  const std::function<Result<Map>(const ConstFieldRef&, const Map&)>& now) {
    if (!doc.isOpen()) return failed("no project is open", "open one first");
    const Result<ConstFieldRef> field = findField(doc.project(), doc.tables().components, path);
    if (!field) return field.error();
    if (field->row->type != FieldType::Map) return usage(path + " is no map");
    const auto& had = *static_cast<const MapField*>(field->value);
    const Map before = had.present() ? had.map : newMap(doc.project(), *field);
    Result<Map> after = now(*field, before);
    if (!after) return after.error();
    const std::string label = fmt::format("{} {}", verb, field->path);
    return inOneStep(doc, label, [&] {
        if (verb != "fill") doc.describe(fmt::format("map.{}(\"{}\")", verb, field->path));
        return doc.setMap(field->path, std::move(*after), label);
    });
}

}  // namespace

Map uniformMap(const MapInfo& info, const glm::vec4& value) {
    Map blank(info);
    // Through one texel: what a map can hold of the value. Beyond the edge texels stay zero.
    Map one({1, 1, info.channels, info.type});
    for (int c = 0; c < info.channels; ++c) one.set(0, 0, c, value[c]);
    std::vector<std::byte> texel(one.texelBytes());
    one.readRows(0, 1, texel.data());
    std::unordered_map<Piece, std::shared_ptr<const Tile>, PieceHash> made;
    for (int ty = 0; ty < blank.tilesY(); ++ty)
        for (int tx = 0; tx < blank.tilesX(); ++tx) {
            const Piece piece = pieceAt(blank, tx, ty);
            std::shared_ptr<const Tile>& tile = made[piece];
            if (!tile) {
                auto fresh = std::make_shared<Tile>(*piece.tile);
                for (int y = 0; y < piece.height; ++y)
                    for (int x = 0; x < piece.width; ++x)
                        std::memcpy(fresh->write() + size_t(y * kTileSize + x) * texel.size(), texel.data(),
                                    texel.size());
                tile = std::move(fresh);
            }
            blank.setTile(tx, ty, tile);
        }
    return blank;
}

Map changedTexels(const Map& map, TexelChange change) {
    std::unordered_map<Piece, size_t, PieceHash> numbers;
    std::vector<Piece> pieces;
    for (int ty = 0; ty < map.tilesY(); ++ty)
        for (int tx = 0; tx < map.tilesX(); ++tx)
            if (const Piece piece = pieceAt(map, tx, ty); numbers.try_emplace(piece, pieces.size()).second)
                pieces.push_back(piece);
    std::vector<std::shared_ptr<const Tile>> made(pieces.size());
    parallelFor(pieces.size(), [&](size_t i) {
        made[i] = changedTile(map.info(), *pieces[i].tile, pieces[i].width, pieces[i].height, change);
    });
    Map out = map;
    for (int ty = 0; ty < map.tilesY(); ++ty)
        for (int tx = 0; tx < map.tilesX(); ++tx) out.setTile(tx, ty, made[numbers.at(pieceAt(map, tx, ty))]);
    return out;
}

Status fillMap(Document& doc, const BrushSettings& brush) {
    return replaceMap(doc, brush.map, "fill", [&](const ConstFieldRef& field, const Map& map) -> Result<Map> {
        const MapRow& row = *field.row->map;
        if (isHeights(row)) return usage("heights are not filled", "clear them, or flatten with a brush");
        const double angle = glm::radians(static_cast<double>(brush.angleDeg));
        switch (row.kind) {
            case MapKind::Amounts:
                return uniformMap(map.info(), glm::vec4(brush.value));
            case MapKind::Colours:
                return uniformMap(map.info(), glm::vec4(brush.color, brush.value));
            case MapKind::Directions:
                return uniformMap(map.info(), {0.5 + 0.5 * std::sin(angle), 0.5 - 0.5 * std::cos(angle), 0, 0});
            default:
                return usage("forces are not filled", "press them with a brush");
        }
    });
}

Status clearMap(Document& doc, const std::string& path) {
    return replaceMap(doc, path, "clear", [](const ConstFieldRef& field, const Map& map) -> Result<Map> {
        switch (field.row->map->kind) {
            case MapKind::Heights:
                return uniformMap(map.info(), glm::vec4(levelOf(field, map)));
            case MapKind::Colours:
                return changedTexels(map, [](float* texel) { texel[3] = 0; });
            case MapKind::Directions:
            case MapKind::Forces:
                return uniformMap(map.info(), {0.5f, 0.5f, 0, 0});
            default:
                return Map(map.info());
        }
    });
}

Status invertMap(Document& doc, const std::string& path) {
    return replaceMap(doc, path, "invert", [](const ConstFieldRef& field, const Map& map) -> Result<Map> {
        const MapRow& row = *field.row->map;
        if (isHeights(row)) return usage("heights are not inverted", "lower them with a brush");
        switch (row.kind) {
            case MapKind::Amounts:
                return changedTexels(map, invertAmount);
            case MapKind::Colours:
                return changedTexels(map, invertOpacity);
            default:
                return changedTexels(map, turnRound);
        }
    });
}

namespace {

// Maps of zeros for the densities among an owner's fields ("lawn.GrassField.species[clover]").
Status bareDensities(Document& doc, const std::string& owner, std::span<const FieldRow> fields) {
    for (const FieldRow& f : fields) {
        const Result<ConstFieldRef> field = findField(doc.project(), doc.tables().components, owner + "." + f.name);
        if (!field) return field.error();
        if (f.type == FieldType::List)
            for (const std::string& name : elementSelectors(*f.list, field->value))
                if (Status s = bareDensities(doc, field->path + "[" + name + "]", f.list->fields); !s) return s;
        if (f.type != FieldType::Map || f.map->role != MapRole::Density) continue;
        const MapInfo info = newMapInfo(doc.project(), *field);
        if (Status s = doc.setMap(field->path, Map(info), "new map " + field->path); !s) return s;
    }
    return {};
}

}  // namespace

Status addUnpainted(Document& doc, const std::string& listPath) {
    return inOneStep(doc, "add to " + listPath, [&]() -> Status {
        if (Status s = doc.addListElement(listPath); !s) return s;
        const Result<ConstFieldRef> field = findField(doc.project(), doc.tables().components, listPath);
        const ListRow& list = *field->row->list;
        const std::string name = elementSelectors(list, field->value).back();
        return bareDensities(doc, field->path + "[" + name + "]", list.fields);
    });
}

Status addComponentUnpainted(Document& doc, const std::string& entity, const std::string& component) {
    return inOneStep(doc, "add " + component + " to " + entity, [&]() -> Status {
        if (Status s = doc.addComponent(entity, component); !s) return s;
        return bareDensities(doc, entity + "." + component, findComponent(doc.tables().components, component)->fields);
    });
}

bool unpainted(const Map& map) {
    return !map.empty() && map.sameTiles(Map(map.info()));  // zero tiles share one
}

}  // namespace sward
