#include "model/layer_edits.h"
#include "model/one_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "core/json.h"
#include "maps/map_io.h"
#include "model/new_map.h"
#include "scene/ground_path.h"

namespace sward {
namespace {

std::string entityOfPath(const std::string& path) { return path.substr(0, path.find('.')); }

const MapLayers* layersOf(const Project& p, const std::string& path) {
    return p.registry.get<MapLayers>(findEntity(p, entityOfPath(path)));
}

// The number of a layer among all of its entity, by its PATH; as many as there are if it is none.
size_t placeOf(const Project& p, const std::string& layerPath) {
    const MapLayers* of = layersOf(p, layerPath);
    if (!of) return 0;
    const std::vector<std::string> paths = layerPaths(entityOfPath(layerPath), *of);
    return static_cast<size_t>(std::find(paths.begin(), paths.end(), layerPath) - paths.begin());
}

Status noLayer(const std::string& path) { return usage(fmt::format("there is no layer {}", path)); }

// A name that no layer of the entity has.
std::string freeLayerName(const MapLayers& of, const std::string& stem) {
    const auto taken = [&](const std::string& name) {
        return std::any_of(of.layers.begin(), of.layers.end(), [&](const MapLayer& l) { return l.name == name; });
    };
    std::string name = stem;
    for (int i = 2; taken(name); ++i) name = fmt::format("{} {}", stem, i);
    return name;
}

Status setAll(Document& doc, const std::string& path,
              std::initializer_list<std::pair<const char*, std::string>> texts) {
    for (const auto& [field, text] : texts)
        if (Status done = doc.setField(path + "." + field, text); !done) return done;
    return {};
}

// The first entity by name that has a path; empty if none does.
std::string firstPath(const Project& p) {
    for (const auto& [name, e] : p.entities)
        if (p.registry.get<GroundPath>(e)) return name;
    return {};
}

// What a new layer over heights or colours begins with.
Status beginOver(Document& doc, MapKind under, const std::string& path, LayerKind kind) {
    const bool heights = under == MapKind::Heights, adds = heights && kind != LayerKind::Path;
    if (Status done = doc.setField(path + ".operation", adds ? "add" : "replace"); !done) return done;
    if (kind == LayerKind::Rule) {
        if (Status done = doc.addListElement(path + ".masks"); !done) return done;
        const std::string mask = path + ".masks[mask]";
        return heights
                   ? setAll(doc, mask, {{"by", "noise"}, {"to", "1"}, {"from", "1"}, {"falloff", "1"}, {"size", "12"}})
                   : setAll(doc, mask, {{"to", "90"}, {"from", "35"}, {"falloff", "4"}});
    }
    if (kind != LayerKind::Painted) return {};
    const Result<ConstFieldRef> amounts = findField(doc.project(), doc.tables().components, path + ".amounts");
    if (!amounts) return amounts.error();
    return doc.setMap(amounts->path, Map(newMapInfo(doc.project(), *amounts)), "new map " + amounts->path);
}

// Floats as shares from their least to their greatest, which it gives.
std::pair<float, float> toShares(Map& map) {
    const MapInfo& info = map.info();
    float low = map.at(0, 0), high = low;
    for (int y = 0; y < info.height; ++y)
        for (int x = 0; x < info.width; ++x) low = std::min(low, map.at(x, y)), high = std::max(high, map.at(x, y));
    for (int y = 0; y < info.height; ++y)
        for (int x = 0; x < info.width; ++x) map.set(x, y, 0, high > low ? (map.at(x, y) - low) / (high - low) : 0);
    return {low, high};
}

// A picture of heights: shares as texels, and in `low`, `high` what they stand for where the file says it.
Status importHeights(Document& doc, const std::string& layerPath, const std::filesystem::path& file,
                     const ImportOptions& options) {
    MapWish wish;
    wish.isHeight = true;
    wish.flip = options.flip.value_or(false);
    Result<Map> texels = readMap(file, wish);
    if (!texels) return texels.error();
    std::optional<std::pair<double, double>> range = options.range ? options.range : sidecarRange(file);
    if (texels->info().type == PixelType::F32) range = toShares(*texels);
    const std::string path = layerPath + ".amounts", label = "import " + path;
    return inOneStep(doc, label, [&]() -> Status {
        if (range)
            if (Status done = setAll(doc, layerPath,
                                     {{"low", shortestText(static_cast<float>(range->first))},
                                      {"high", shortestText(static_cast<float>(range->second))}});
                !done)
                return done;
        return doc.setMap(path, std::move(*texels), label);
    });
}

}  // namespace

std::string stackedMap(const Project& p, const std::string& mapPath) {
    constexpr const char* kAmounts = ".amounts";
    if (!mapPath.ends_with(kAmounts)) return mapPath;
    const std::string layer = mapPath.substr(0, mapPath.size() - std::string(kAmounts).size());
    const MapLayers* of = layersOf(p, layer);
    const size_t place = placeOf(p, layer);
    return of && place < of->layers.size() ? layeredPath(entityOfPath(layer), of->layers[place]) : mapPath;
}

MapKind kindUnder(const Document& doc, const std::string& mapPath) {
    const Result<ConstFieldRef> under =
        findField(doc.project(), doc.tables().components, stackedMap(doc.project(), mapPath));
    return under && under->row->type == FieldType::Map ? under->row->map->kind : MapKind::Amounts;
}

std::vector<LayerOf> layersOver(const Project& p, const std::string& mapPath) {
    std::vector<LayerOf> out;
    const MapLayers* of = layersOf(p, mapPath);
    if (!of) return out;
    const std::string entity = entityOfPath(mapPath);
    const std::vector<std::string> paths = layerPaths(entity, *of);
    for (size_t i = 0; i < paths.size(); ++i)
        if (layeredPath(entity, of->layers[i]) == mapPath) out.push_back({paths[i], &of->layers[i]});
    return out;
}

std::string sculptsBelow(const Document& doc, const std::string& mapPath) {
    if (stackedMap(doc.project(), mapPath) != mapPath || kindUnder(doc, mapPath) != MapKind::Heights) return {};
    const std::vector<LayerOf> layers = layersOver(doc.project(), mapPath);
    const auto acting = std::count_if(layers.begin(), layers.end(),
                                      [](const LayerOf& l) { return !l.layer->muted && l.layer->opacity > 0; });
    return acting == 0 ? "" : fmt::format("below {} layer{}", acting, acting == 1 ? "" : "s");
}

Status addLayer(Document& doc, const std::string& mapPath, LayerKind kind) {
    const Result<ConstFieldRef> map = findMap(doc.project(), doc.tables().components, mapPath);
    if (!map) return map.error();
    const std::string entity = map->entity, list = entity + ".MapLayers.layers";
    const char* name = kLayerKinds[kind];
    return inOneStep(doc, fmt::format("add {} layer over {}", name, map->path), [&]() -> Status {
        const MapLayers* before = layersOf(doc.project(), entity + ".");
        const std::string called = freeLayerName(before ? *before : MapLayers{}, name);
        if (!before)
            if (Status done = doc.addComponent(entity, "MapLayers"); !done) return done;
        if (Status done = doc.addListElement(list); !done) return done;
        const std::string made = layerPaths(entity, *layersOf(doc.project(), list)).back();
        const std::string path = fmt::format("{}[{}]", list, called), within = map->path.substr(entity.size() + 1);
        if (Status done = setAll(doc, made, {{"map", within}, {"kind", name}, {"name", called}}); !done) return done;
        if (kind == LayerKind::Path)
            if (Status done = doc.setField(path + ".path", firstPath(doc.project())); !done) return done;
        const MapKind under = map->row->map->kind;
        if (under == MapKind::Heights || under == MapKind::Colours) return beginOver(doc, under, path, kind);
        if (kind == LayerKind::Rule) return doc.addListElement(path + ".masks");
        return kind == LayerKind::Painted ? doc.createMap(path + ".amounts") : Status();
    });
}

Status removeLayer(Document& doc, const std::string& layerPath) {
    const MapLayers* of = layersOf(doc.project(), layerPath);
    if (!of || placeOf(doc.project(), layerPath) >= of->layers.size()) return noLayer(layerPath);
    if (of->layers.size() == 1) return doc.removeComponent(entityOfPath(layerPath), "MapLayers");
    return doc.removeListElement(layerPath);
}

Status moveLayer(Document& doc, const std::string& layerPath, bool up) {
    const Project& p = doc.project();
    const MapLayers* of = layersOf(p, layerPath);
    const size_t place = placeOf(p, layerPath);
    if (!of || place >= of->layers.size()) return noLayer(layerPath);
    const int count = static_cast<int>(of->layers.size()), step = up ? 1 : -1;
    for (int to = static_cast<int>(place) + step; to >= 0 && to < count; to += step)
        if (of->layers[static_cast<size_t>(to)].map == of->layers[place].map)
            return doc.moveListElement(layerPath, static_cast<size_t>(to));
    return {};
}

Status importLayer(Document& doc, const std::string& layerPath, const std::filesystem::path& file,
                   const ImportOptions& options) {
    const Result<ConstFieldRef> map = findField(doc.project(), doc.tables().components, layerPath + ".amounts");
    if (!map) return map.error();
    if (kindUnder(doc, map->path) == MapKind::Heights) return importHeights(doc, layerPath, file, options);
    MapImport used;
    Result<Map> texels = readImport(doc.project(), *map, file, options, &used);
    if (!texels) return texels.error();
    if (Status done = doc.setMap(map->path, std::move(*texels), "import " + map->path); !done) return done;
    doc.rememberImport(map->path, used);
    return {};
}

}  // namespace sward
