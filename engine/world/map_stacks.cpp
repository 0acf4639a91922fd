// Index: stacks · the project as it is shown.
#include "world/map_stacks.h"

#include <algorithm>
#include <map>
#include <set>

#include "scene/map_fields.h"
#include "scene/tiling.h"
#include "world/height_layers.h"
#include "world/layered_tiles.h"

namespace sward {
namespace {

// --- stacks --------------------------------------------------------------------------------------------------------
// What a map with layers came to at the last call, and of what.
struct Stack {
    Map final, painted;
    std::vector<Map> coverages;
    std::string of;  // how the layers combine
};

// Tiles of the stack where the painted map or a layer is another than at the last call.
std::vector<TilePlace> changedTiles(const Stack& s, const Map& painted, const std::vector<LayerOver>& layers) {
    std::vector<TilePlace> out = painted.empty() ? std::vector<TilePlace>() : tilesThatDiffer(painted, s.painted);
    for (size_t i = 0; i < layers.size(); ++i)
        for (const TilePlace& t : tilesThatDiffer(*layers[i].coverage, s.coverages[i]))
            if (std::find(out.begin(), out.end(), t) == out.end()) out.push_back(t);
    return out;
}

std::string howItCombines(const MapLayer& layer) {
    return fmt::format("{} {} {} {} {}|", static_cast<int>(layer.operation), layer.opacity, layer.color.x,
                       layer.color.y, layer.color.z);
}

void updateStack(Stack& s, LayerScene& scene, const LayeredKind& kind, const Map& painted, const MapInfo& info,
                 const std::vector<LayerOver>& layers) {
    std::string of;
    for (const LayerOver& o : layers) of += howItCombines(*o.layer);
    const bool fresh = s.final.info() != info || s.painted.info() != painted.info() || s.of != of;
    if (s.final.info() != info) s.final = Map(info);
    const std::vector<TilePlace> tiles = fresh ? tilesIn(s.final, {kEverywhere}) : changedTiles(s, painted, layers);
    evaluateTiles(s.final, tiles, NumberRange::Unit,
                  [&](TilePlace at, Numbers& out) { kind.combine(painted, layers, at, out); });
    scene.evaluated += tiles.size();
    s.of = std::move(of);
    s.painted = painted;
    s.coverages.clear();
    for (const LayerOver& o : layers) s.coverages.push_back(*o.coverage);
}

// The field of the map that layers lie over, or why they cannot.
Result<FieldRef> layeredMap(Project& p, std::span<const ComponentRow> rows, const Terrain& terrain,
                            const std::string& path) {
    Result<FieldRef> field = findField(p, rows, path);
    if (!field || field->row->type != FieldType::Map)
        return unsound(fmt::format("there is no map {}", path), "name another, or bring it back");
    const MapRow& row = *field->row->map;
    if (isRowOf<MapLayers>(*field->component) || !layeredKind(row.kind) || row.onMesh)
        return unsound(fmt::format("{} holds no amounts or colours on the terrain", path),
                       "layers lie over densities, colours and the like");
    if (const Map& map = mapOf(ConstFieldRef(*field)).map; !map.empty() && map.info().channels != row.channels)
        return unsound(fmt::format("{} has {} channels, not {}", path, map.info().channels, row.channels),
                       "import it again");
    if (tilingOf(terrain, mapTiling(*field)).repeats)
        return unsound(fmt::format("{} repeats, and layers lie on the whole terrain", path),
                       "set its tiling to 1 and Terrain.mapSize to 0");
    return field;
}

}  // namespace

// --- the project as it is shown ------------------------------------------------------------------------------------

struct MapStacks::Impl {
    std::span<const ComponentRow> rows;
    LayerScene scene;
    HeightLayers heights;
    std::map<std::string, Coverage> coverages;  // by the layer's PATH
    std::map<std::string, Stack> stacks;        // by the map's PATH
    std::optional<Project> made;
    std::vector<LayerNote> notes;

    bool standOn(const Project& p, Project& to);
    void putCoverage(Project& to, const std::string& layer, const Map& coverage) const;
    bool stackEntity(const std::string& entity, const MapLayers& of, Project& to, std::set<std::string>& asked);
    bool stackMap(const std::string& path, const std::vector<std::pair<std::string, const MapLayer*>>& layers,
                  Project& to, std::set<std::string>& asked);
};

// Puts the ground as its layers leave it into `to`, and looks at it; whether a layer counts.
bool MapStacks::Impl::standOn(const Project& p, Project& to) {
    const Map* shaped = heights.shown(p);
    notes = heights.notes();
    if (shaped) {
        setLayeredHeights(to, *shaped);
        for (const auto& [layer, coverage] : heights.coverages()) putCoverage(to, layer, coverage);
    }
    lookAt(scene, to, findGround(to));
    return shaped != nullptr;
}

void MapStacks::Impl::putCoverage(Project& to, const std::string& layer, const Map& coverage) const {
    if (const Result<FieldRef> own = findField(to, rows, layer + ".amounts"))
        *static_cast<MapField*>(own->value) = {"maps/coverage", coverage};
}

// Puts what one map comes to into `to`, if a layer counts.
bool MapStacks::Impl::stackMap(const std::string& path,
                               const std::vector<std::pair<std::string, const MapLayer*>>& layers, Project& to,
                               std::set<std::string>& asked) {
    const auto skip = [&](const std::string& layer, const Error& e) { notes.push_back({layer, e.text(), true}); };
    const Terrain* terrain = scene.masks.ground.terrain;
    const Result<FieldRef> field =
        terrain ? layeredMap(to, rows, *terrain, path) : unsound("the scene has no Terrain", "add one");
    if (!field) {
        for (const auto& [layer, of] : layers) skip(layer, field.error());
        return false;
    }
    auto& target = *static_cast<MapField*>(field->value);
    const MapInfo info =
        target.present() ? target.map.info() : newMapInfo(*field->row->map, std::max(terrain->size.x, terrain->size.y));
    const LayeredKind& kind = *layeredKind(field->row->map->kind);
    std::vector<LayerOver> over;
    for (const auto& [layer, of] : layers) {
        if (const Status can = kind.fits(*of); !can) {
            skip(layer, can.error());
            continue;
        }
        Coverage& c = coverages[layer];
        asked.insert(layer);
        if (const Status done = updateCoverage(c, scene, *of, {info.width, info.height, 1, PixelType::U16}); !done) {
            c = {};  // what changes meanwhile would be missed
            skip(layer, done.error());
            continue;
        }
        if (const std::string says = c.zero ? kind.zeroSays(*of) : ""; !says.empty())
            notes.push_back({layer, says, false});
        over.push_back({of, &c.map});
        putCoverage(to, layer, c.map);
    }
    if (over.empty()) return false;
    asked.insert(path);
    Stack& stack = stacks[path];
    updateStack(stack, scene, kind, target.map, info, over);
    target = {target.file.empty() ? "maps/layered" : target.file, stack.final};
    return true;
}

bool MapStacks::Impl::stackEntity(const std::string& entity, const MapLayers& of, Project& to,
                                  std::set<std::string>& asked) {
    const std::vector<std::string> paths = layerPaths(entity, of);
    std::map<std::string, std::vector<std::pair<std::string, const MapLayer*>>> over;  // by the map's PATH
    for (size_t i = 0; i < paths.size(); ++i)
        if (const MapLayer& layer = of.layers[i]; !layer.muted && layer.opacity > 0)
            over[layeredPath(entity, layer)].emplace_back(paths[i], &layer);
    bool any = false;
    for (const auto& [map, layers] : over)
        if (map != heightsPath(to)) any |= stackMap(map, layers, to, asked);
    return any;
}

MapStacks::MapStacks() : impl_(std::make_unique<Impl>()) {}
MapStacks::~MapStacks() = default;
MapStacks::MapStacks(MapStacks&&) noexcept = default;
MapStacks& MapStacks::operator=(MapStacks&&) noexcept = default;

const Project& MapStacks::shown(const Project& p, std::span<const ComponentRow> rows) {
    Impl& m = *impl_;
    m.rows = rows;
    m.notes.clear();
    if (!hasLayers(p)) {
        if (m.made) *this = MapStacks();
        return p;
    }
    m.made = snapshot(p, m.rows);
    std::set<std::string> asked;
    bool any = m.standOn(p, *m.made);
    for (const auto& [name, e] : p.entities)
        if (const MapLayers* layers = p.registry.get<MapLayers>(e)) any |= m.stackEntity(name, *layers, *m.made, asked);
    std::erase_if(m.coverages, [&](const auto& held) { return !asked.contains(held.first); });
    std::erase_if(m.stacks, [&](const auto& held) { return !asked.contains(held.first); });
    return any ? *m.made : p;
}

const std::vector<LayerNote>& MapStacks::notes() const { return impl_->notes; }
size_t MapStacks::evaluatedTiles() const { return impl_->scene.evaluated + impl_->heights.evaluatedTiles(); }

}  // namespace sward
