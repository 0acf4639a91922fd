#include "tools/brush_target.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "scene/map_layers.h"
#include "tools/stroke.h"
#include "world/ground.h"
#include "world/map_stacks.h"

namespace sward {
namespace {

bool present(const ConstFieldRef& map) { return static_cast<const MapField*>(map.value)->present(); }

// The map that a tool goes to: of those that it paints the last one chosen, else a density, else the first.
std::string mapFor(const Document& doc, const BrushBook& book, const BrushRow& row) {
    std::vector<ConstFieldRef> fitting = paintableMaps(doc);
    std::erase_if(fitting, [&](const ConstFieldRef& map) { return !paints(row, map.row->map->kind); });
    for (const std::string& recent : book.recentMaps)
        for (const ConstFieldRef& map : fitting)
            if (map.path == recent) return recent;
    for (const ConstFieldRef& map : fitting)
        if (map.row->map->role == MapRole::Density) return map.path;
    return fitting.empty() ? "" : fitting.front().path;
}

std::string toolFor(const BrushBook& book, MapKind kind) {
    const auto last = book.lastTool.find(kind);
    if (last != book.lastTool.end()) return last->second;
    switch (kind) {
        case MapKind::Amounts:
            return "add";
        case MapKind::Directions:
            return "comb";
        case MapKind::Forces:
            return "press";
        case MapKind::Colours:
            return "add";
        case MapKind::Heights:
            return "raise";
    }
    return kViewTool;
}

void remember(BrushBook& book, MapKind kind) {
    std::erase(book.recentMaps, book.map);
    book.recentMaps.insert(book.recentMaps.begin(), book.map);
    if (book.tool != kViewTool) book.lastTool[kind] = book.tool;
}

// Whether the map is a layer's that takes its amounts from elsewhere.
bool isOfRule(const Project& p, const ConstFieldRef& map) {
    const MapLayers* of =
        isRowOf<MapLayers>(*map.component) ? p.registry.get<MapLayers>(findEntity(p, map.entity)) : nullptr;
    return of && std::any_of(of->layers.begin(), of->layers.end(), [&](const MapLayer& layer) {
               return &layer.amounts == map.value && !layerKindRows()[static_cast<size_t>(layer.kind)].ownMap;
           });
}

}  // namespace

std::vector<ConstFieldRef> paintableMaps(const Document& doc) {
    if (!doc.isOpen()) return {};
    std::vector<ConstFieldRef> maps = allMaps(doc.project(), doc.tables().components, true);
    const Project& p = doc.project();
    std::erase_if(maps, [&p](const ConstFieldRef& f) {
        const GrassField* grass = p.registry.get<GrassField>(findEntity(p, f.entity));
        const bool unread = grass && !grass->onTerrain && isRowOf<GrassField>(*f.component);
        return f.row->map->onMesh || unread || isOfRule(p, f);
    });
    return maps;
}

std::optional<ConstFieldRef> chosenMap(const Document& doc, const BrushBook& book) {
    if (!doc.isOpen() || book.map.empty()) return std::nullopt;
    const Result<ConstFieldRef> map = findField(doc.project(), doc.tables().components, book.map);
    return map && map->row->type == FieldType::Map ? std::optional(*map) : std::nullopt;
}

void selectMap(const Document& doc, BrushBook& book, const std::string& path) {
    book.map = path;
    keepTargetValid(doc, book);
}

void selectTool(const Document& doc, BrushBook& book, Messages& messages, const std::string& tool) {
    const BrushRow* row = findBrush(tool);
    if (!row && tool != kViewTool) return;
    const std::optional<ConstFieldRef> map = chosenMap(doc, book);
    if (row && (!map || !paints(*row, map->row->map->kind))) {
        const std::string other = mapFor(doc, book, *row);
        if (other.empty()) return say(messages, fmt::format("{}: the project has no map that it paints", row->label));
        book.map = other;
    }
    book.tool = tool;
    keepTargetValid(doc, book);
}

void toggleLook(const Document& doc, BrushBook& book, Messages& messages) {
    const std::optional<ConstFieldRef> map = chosenMap(doc, book);
    selectTool(doc, book, messages,
               book.tool != kViewTool ? kViewTool : toolFor(book, map ? map->row->map->kind : MapKind::Amounts));
}

namespace {

void pickColor(const Document& doc, BrushBook& book, Messages& messages, const ConstFieldRef& map,
               const std::optional<glm::dvec3>& ground) {
    const Map& texels = static_cast<const MapField*>(map.value)->map;
    const Result<MapScale> scale = mapScale(doc.project(), map);
    if (!ground || texels.empty() || !scale) return say(messages, "Pick: there is nothing under the pointer");
    const glm::dvec3 at = *ground - findGround(doc.project()).origin;
    const glm::dvec2 place(at.x / scale->width, at.z / scale->depth),
        inside = scale->repeats ? place - glm::floor(place) : place;
    if (!(texels.sample(inside.x, inside.y, 3) > 0.5f / 255)) return say(messages, "Pick: nothing is painted there");
    for (int c = 0; c < 3; ++c) currentColor(book)[c] = std::clamp(texels.sample(inside.x, inside.y, c), 0.f, 1.f);
    say(messages, "the brush's colour is " + colorText(currentColor(book)));
}

// Flatten takes the height, whatever tool is in the hand.
void pickHeight(const Document& doc, BrushBook& book, Messages& messages, const std::optional<glm::dvec3>& ground) {
    if (!ground) return say(messages, "Pick: there is no ground under the pointer");
    const std::string tool = std::exchange(book.tool, "flatten");
    BrushSettings& flatten = currentBrush(book);
    book.tool = tool;
    flatten.value = static_cast<float>(ground->y - findGround(doc.project()).origin.y);
    flatten.fromStart = false;
    say(messages, fmt::format("Flatten goes to {:.4g} m", flatten.value));
}

}  // namespace

void pickFromGround(const Document& doc, BrushBook& book, Messages& messages, const std::optional<glm::dvec3>& ground) {
    const std::optional<ConstFieldRef> map = chosenMap(doc, book);
    const MapKind kind = map ? map->row->map->kind : MapKind::Amounts;
    if (kind == MapKind::Colours) return pickColor(doc, book, messages, *map, ground);
    if (kind == MapKind::Heights) return pickHeight(doc, book, messages, ground);
    say(messages, "Pick: the brush is on no map of colours or heights");
}

void keepTargetValid(const Document& doc, BrushBook& book) {
    const std::vector<ConstFieldRef> maps = paintableMaps(doc);
    const auto named = [&](const ConstFieldRef& f) { return f.path == book.map; };
    if (std::none_of(maps.begin(), maps.end(), named)) {
        const BrushRow* row = findBrush("add");
        book.map = mapFor(doc, book, *row);
    }
    const std::optional<ConstFieldRef> map = chosenMap(doc, book);
    if (!map) return;
    const MapKind kind = book.kind = map->row->map->kind;
    const BrushRow* row = findBrush(book.tool);
    if (row && !paints(*row, kind)) book.tool = toolFor(book, kind);
    remember(book, kind);
}

std::vector<std::string> speciesOfField(const Document& doc, const BrushBook& book) {
    const std::optional<ConstFieldRef> map = chosenMap(doc, book);
    if (!map || map->row->map->role != MapRole::Density) return {};
    std::vector<std::string> paths;
    BrushSettings like;
    like.map = book.map;
    for (const BrushSettings& b : speciesBrushes(doc.project(), doc.tables().components, like))
        if (b.map.starts_with(map->entity + ".")) paths.push_back(b.map);
    return paths;
}

std::vector<std::string> paintedMaps(const Document& doc, const BrushBook& book) {
    std::vector<std::string> paths{book.map};
    for (const std::string& path : speciesOfField(doc, book))
        if (path != book.map && book.species.contains(path)) paths.push_back(path);
    return paths;
}

std::vector<BrushSettings> strokeBrushes(const Document& doc, BrushBook& book, bool ctrl, bool shift) {
    const BrushSettings brush = strokeBrush(book, ctrl, shift);
    if (ctrl && shift) return speciesBrushes(doc.project(), doc.tables().components, brush);
    std::vector<BrushSettings> brushes;
    for (const std::string& path : paintedMaps(doc, book)) {
        brushes.push_back(brush);
        brushes.back().map = path;
    }
    return brushes;
}

namespace {
// Forces that nobody painted are shown with those of the map, and where there is none.
bool showsSources(const Document& doc, const ConstFieldRef& map) {
    return map.row->map->kind == MapKind::Forces &&
           has(sceneFeatures(doc.project().registry, doc.tables()), Feature::Forces);
}
}  // namespace

bool overlayShown(const Document& doc, const BrushBook& book) {
    const std::optional<ConstFieldRef> map = chosenMap(doc, book);
    if (!map) return false;
    const auto chosen = book.overlays.find(map->path);
    return chosen != book.overlays.end() ? chosen->second
                                         : map->row->map->role != MapRole::Density && book.kind != MapKind::Heights;
}

void toggleOverlay(const Document& doc, BrushBook& book) { book.overlays[book.map] = !overlayShown(doc, book); }

namespace {
// The layer that the person looks at, while it is there and counts.
MapOverlay previewOf(const Document& doc, const BrushBook& book) {
    if (book.preview.empty() || !doc.isOpen() || !findGround(doc.project()).terrain) return {};
    const Result<ConstFieldRef> muted = findField(doc.project(), doc.tables().components, book.preview + ".muted");
    return muted && !*static_cast<const bool*>(muted->value) ? MapOverlay{book.preview + ".amounts", 0} : MapOverlay{};
}
}  // namespace

MapOverlay overlayOf(const Document& doc, const BrushBook& book) {
    if (const MapOverlay preview = previewOf(doc, book); !preview.map.empty()) return preview;
    const std::optional<ConstFieldRef> map = chosenMap(doc, book);
    if (!map || !overlayShown(doc, book) || !(present(*map) || showsSources(doc, *map))) return {};
    const Result<MapScale> scale = mapScale(doc.project(), *map);
    if (!scale || !findGround(doc.project()).terrain) return {};
    return {map->path, scale->tiling};
}

}  // namespace sward
