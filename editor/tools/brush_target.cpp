#include "tools/brush_target.h"

#include "tools/stroke.h"
#include "world/ground.h"

namespace sward {
namespace {

bool present(const ConstFieldRef& map) { return static_cast<const MapField*>(map.value)->present(); }

// The map that a tool goes to: of those that it paints the last one chosen, else a density, else the first.
std::string mapFor(EditorApp& app, const BrushRow& row) {
    std::vector<std::string> fitting;
    for (const ConstFieldRef& map : paintableMaps(app))
        if (paints(row, kindOf(*map.row))) fitting.push_back(map.path);
    for (const std::string& map : app.brushes.recentMaps)
        if (std::find(fitting.begin(), fitting.end(), map) != fitting.end()) return map;
    for (const std::string& map : fitting)
        if (map.ends_with(".density")) return map;
    return fitting.empty() ? "" : fitting.front();
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
    }
    return kLookTool;
}

void remember(BrushBook& book, MapKind kind) {
    std::erase(book.recentMaps, book.map);
    book.recentMaps.insert(book.recentMaps.begin(), book.map);
    if (book.tool != kLookTool) book.lastTool[kind] = book.tool;
}

}  // namespace

std::vector<ConstFieldRef> paintableMaps(EditorApp& app) {
    if (!app.doc.isOpen()) return {};
    std::vector<ConstFieldRef> maps = allMaps(app.doc.project(), app.doc.tables().components, true);
    std::erase_if(maps, [](const ConstFieldRef& f) { return f.row->isHeight; });
    return maps;
}

std::optional<ConstFieldRef> chosenMap(EditorApp& app) {
    if (!app.doc.isOpen() || app.brushes.map.empty()) return std::nullopt;
    const Result<ConstFieldRef> map = findField(app.doc.project(), app.doc.tables().components, app.brushes.map);
    return map && map->row->type == FieldType::Map ? std::optional(*map) : std::nullopt;
}

void selectMap(EditorApp& app, const std::string& path) {
    app.brushes.map = path;
    keepTargetValid(app);
}

void selectTool(EditorApp& app, const std::string& tool) {
    const BrushRow* row = findBrush(tool);
    if (!row && tool != kLookTool) return;
    const std::optional<ConstFieldRef> map = chosenMap(app);
    if (row && (!map || !paints(*row, kindOf(*map->row)))) {
        const std::string other = mapFor(app, *row);
        if (other.empty()) return say(app, fmt::format("{}: the project has no map that it paints", row->label));
        app.brushes.map = other;
    }
    app.brushes.tool = tool;
    keepTargetValid(app);
}

void toggleLook(EditorApp& app) {
    const std::optional<ConstFieldRef> map = chosenMap(app);
    selectTool(app, app.brushes.tool != kLookTool ? kLookTool
                                                  : toolFor(app.brushes, map ? kindOf(*map->row) : MapKind::Amounts));
}

void pickColor(EditorApp& app) {
    const std::optional<ConstFieldRef> map = chosenMap(app);
    if (!map || kindOf(*map->row) != MapKind::Colours)
        return say(app, "Pick Colour: the brush is on no map of colours");
    const Map& texels = static_cast<const MapField*>(map->value)->map;
    const Result<MapScale> scale = mapScale(app.doc.project(), *map);
    if (!app.viewport.ground || texels.empty() || !scale)
        return say(app, "Pick Colour: there is nothing under the pointer");
    const glm::dvec3 at = *app.viewport.ground - findGround(app.doc.project()).origin;
    const glm::dvec2 place(at.x / scale->width, at.z / scale->depth),
        inside = scale->repeats ? place - glm::floor(place) : place;
    if (!(texels.sample(inside.x, inside.y, 3) > 0.5f / 255)) return say(app, "Pick Colour: nothing is painted there");
    for (int c = 0; c < 3; ++c)
        currentColor(app.brushes)[c] = std::clamp(texels.sample(inside.x, inside.y, c), 0.f, 1.f);
    say(app, "the brush's colour is " + colorText(currentColor(app.brushes)));
}

void keepTargetValid(EditorApp& app) {
    const std::vector<ConstFieldRef> maps = paintableMaps(app);
    const auto named = [&](const ConstFieldRef& f) { return f.path == app.brushes.map; };
    if (std::none_of(maps.begin(), maps.end(), named)) {
        const BrushRow* row = findBrush("add");
        app.brushes.map = mapFor(app, *row);
    }
    const std::optional<ConstFieldRef> map = chosenMap(app);
    if (!map) return;
    const MapKind kind = kindOf(*map->row);
    const BrushRow* row = findBrush(app.brushes.tool);
    if (row && !paints(*row, kind)) app.brushes.tool = toolFor(app.brushes, kind);
    remember(app.brushes, kind);
}

std::vector<BrushSettings> strokeBrushes(EditorApp& app, bool ctrl, bool shift) {
    const BrushSettings brush = strokeBrush(app.brushes, ctrl, shift);
    if (!(ctrl && shift)) return {brush};
    return speciesBrushes(app.doc.project(), app.doc.tables().components, brush);
}

namespace {
// Forces that nobody painted are shown with those of the map, and where there is none.
bool showsSources(EditorApp& app, const ConstFieldRef& map) {
    return map.row->isForce &&
           has(sceneFeatures(app.doc.project().registry, app.doc.tables().components), Feature::Forces);
}
}  // namespace

bool overlayShown(EditorApp& app) {
    const std::optional<ConstFieldRef> map = chosenMap(app);
    if (!map) return false;
    const auto chosen = app.brushes.overlays.find(map->path);
    return chosen != app.brushes.overlays.end() ? chosen->second : std::string_view(map->row->name) != "density";
}

void toggleOverlay(EditorApp& app) { app.brushes.overlays[app.brushes.map] = !overlayShown(app); }

MapOverlay overlayOf(EditorApp& app) {
    const std::optional<ConstFieldRef> map = chosenMap(app);
    if (!map || !overlayShown(app) || !(present(*map) || showsSources(app, *map))) return {};
    const Result<MapScale> scale = mapScale(app.doc.project(), *map);
    if (!scale || !findGround(app.doc.project()).terrain) return {};
    return {map->path, scale->tiling};
}

}  // namespace sward
