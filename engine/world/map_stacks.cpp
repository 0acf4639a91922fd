// Index: tiles as numbers · what changed · coverage of a layer · stacks · the project as it is shown.
#include "world/map_stacks.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "core/jobs.h"
#include "scene/map_fields.h"
#include "scene/tiling.h"
#include "world/layer_masks.h"

namespace sward {
namespace {

// --- tiles as numbers ----------------------------------------------------------------------------------------------
constexpr size_t kTileTexels = size_t(kTileSize) * kTileSize;
using Numbers = std::vector<float>;  // of a tile, rows first

template <class T>
void readTexels(const Tile& tile, float most, Numbers& out) {
    const T* in = reinterpret_cast<const T*>(tile.bytes.data());
    for (size_t i = 0; i < kTileTexels; ++i) out[i] = static_cast<float>(in[i]) / most;
}

// Of a map of one channel, as Map::at gives them.
void readTile(const Map& map, int tx, int ty, Numbers& out) {
    const Tile& tile = *map.tile(tx, ty);
    switch (map.info().type) {
        case PixelType::U8:
            return readTexels<uint8_t>(tile, 255, out);
        case PixelType::U16:
            return readTexels<uint16_t>(tile, 65535, out);
        case PixelType::F32:
            return readTexels<float>(tile, 1, out);
    }
}

template <class T>
void writeTexels(const Numbers& in, int width, int height, float most, Tile& tile) {
    T* out = reinterpret_cast<T*>(tile.bytes.data());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const size_t i = static_cast<size_t>(y) * kTileSize + static_cast<size_t>(x);
            const float unit = in[i] > 0 ? std::min(in[i], 1.0f) : 0.0f;
            out[i] = static_cast<T>(std::is_floating_point_v<T> ? unit : std::round(unit * most));
        }
}

// A tile of numbers from 0 to 1; texels beyond the map's edge are zero. The one that stood there if it is the same.
std::shared_ptr<const Tile> makeTile(const Map& map, int tx, int ty, const Numbers& numbers) {
    const MapInfo& info = map.info();
    auto made = std::make_shared<Tile>(Tile{std::vector<std::byte>(map.tileBytes())});
    const int w = std::min(kTileSize, info.width - tx * kTileSize),
              h = std::min(kTileSize, info.height - ty * kTileSize);
    switch (info.type) {
        case PixelType::U8:
            writeTexels<uint8_t>(numbers, w, h, 255, *made);
            break;
        case PixelType::U16:
            writeTexels<uint16_t>(numbers, w, h, 65535, *made);
            break;
        case PixelType::F32:
            writeTexels<float>(numbers, w, h, 1, *made);
            break;
    }
    const std::shared_ptr<const Tile>& before = map.tile(tx, ty);
    return made->bytes == before->bytes ? before : std::shared_ptr<const Tile>(std::move(made));
}

// --- what changed --------------------------------------------------------------------------------------------------
// A part of the terrain, as shares of its sides.
struct Box {
    double x0, z0, x1, z1;
};
constexpr Box kEverywhere{-1e9, -1e9, 1e9, 1e9};

bool meet(const Box& a, const Box& b) { return a.x0 <= b.x1 && b.x0 <= a.x1 && a.z0 <= b.z1 && b.z0 <= a.z1; }

// Texels of a map: from x0, y0 to before x1, y1.
struct Texels {
    int x0, y0, x1, y1;
};
Texels tileTexels(int tx, int ty) {
    return {tx * kTileSize, ty * kTileSize, (tx + 1) * kTileSize, (ty + 1) * kTileSize};
}

// Texels of a map that lies on the terrain once, and `margin` of them around.
Box boxOf(const MapInfo& info, const Texels& t, double margin) {
    return {(t.x0 - margin) / info.width, (t.y0 - margin) / info.height, (t.x1 + margin) / info.width,
            (t.y1 + margin) / info.height};
}

// The smallest rectangle in which two tiles of a map differ; empty (x0 = x1) if they do not.
Texels differing(const Map& map, int tx, int ty, const Tile& a, const Tile& b) {
    const size_t texel = map.texelBytes(), row = texel * kTileSize;
    const auto at = [&](const Tile& t, int y) { return t.bytes.data() + static_cast<size_t>(y) * row; };
    Texels out{kTileSize, kTileSize, 0, 0};
    for (int y = 0; y < kTileSize; ++y) {
        if (std::equal(at(a, y), at(a, y) + row, at(b, y))) continue;
        out.y0 = std::min(out.y0, y), out.y1 = y + 1;
        const auto first = std::mismatch(at(a, y), at(a, y) + row, at(b, y)).first - at(a, y);
        const auto last =
            std::mismatch(std::make_reverse_iterator(at(a, y) + row), std::make_reverse_iterator(at(a, y)),
                          std::make_reverse_iterator(at(b, y) + row))
                .first.base() -
            at(a, y);
        out.x0 = std::min(out.x0, static_cast<int>(static_cast<size_t>(first) / texel));
        out.x1 = std::max(out.x1, static_cast<int>((static_cast<size_t>(last) + texel - 1) / texel));
    }
    if (out.x0 >= out.x1) return {0, 0, 0, 0};
    const Texels whole = tileTexels(tx, ty);
    return {whole.x0 + out.x0, whole.y0 + out.y0, whole.x0 + out.x1, whole.y0 + out.y1};
}

// Where maps differ, and as far around as a texel's neighbours read.
std::vector<Box> changedBoxes(const Map& before, const Map& now) {
    if (before.info() != now.info()) return {kEverywhere};
    std::vector<Box> out;
    for (int ty = 0; ty < now.tilesY(); ++ty)
        for (int tx = 0; tx < now.tilesX(); ++tx)
            if (before.tile(tx, ty) != now.tile(tx, ty))
                if (const Texels t = differing(now, tx, ty, *before.tile(tx, ty), *now.tile(tx, ty)); t.x0 < t.x1)
                    out.push_back(boxOf(now.info(), t, 2));
    return out;
}

bool isIn(const std::vector<Box>& boxes, double u, double v) {
    return std::any_of(boxes.begin(), boxes.end(), [&](const Box& b) { return meet(b, {u, v, u, v}); });
}

struct TilePlace {
    int x, y;
};
std::vector<TilePlace> tilesIn(const Map& map, const std::vector<Box>& boxes) {
    std::vector<TilePlace> out;
    for (int ty = 0; ty < map.tilesY(); ++ty)
        for (int tx = 0; tx < map.tilesX(); ++tx)
            if (std::any_of(boxes.begin(), boxes.end(),
                            [&](const Box& b) { return meet(b, boxOf(map.info(), tileTexels(tx, ty), 0)); }))
                out.push_back({tx, ty});
    return out;
}

// Calls numbers(tile, out) for each tile, and puts what it wrote into the map.
template <class F>
void evaluate(Map& map, const std::vector<TilePlace>& tiles, const F& numbers) {
    std::vector<std::shared_ptr<const Tile>> made(tiles.size());
    parallelFor(tiles.size(), [&](size_t i) {
        Numbers out(kTileTexels);
        numbers(tiles[i], out);
        made[i] = makeTile(map, tiles[i].x, tiles[i].y, out);
    });
    for (size_t i = 0; i < tiles.size(); ++i) map.setTile(tiles[i].x, tiles[i].y, std::move(made[i]));
}

bool isZero(const Map& map) {
    Numbers numbers(kTileTexels);
    for (int ty = 0; ty < map.tilesY(); ++ty)
        for (int tx = 0; tx < map.tilesX(); ++tx) {
            readTile(map, tx, ty, numbers);
            if (std::any_of(numbers.begin(), numbers.end(), [](float v) { return v != 0; })) return false;
        }
    return true;
}

// --- coverage of a layer -------------------------------------------------------------------------------------------
// A layer's amounts on the texels of the map that it lies over, kept from call to call.
struct Coverage {
    Map map;
    std::string of;  // its settings and what its masks go by
    Map source;      // of an image or painted layer
    bool zero = false;
};

// What the evaluation of all layers shares.
struct Scene {
    MaskScene masks;
    std::string of;            // the terrain's size and what its heights mean
    Map heights;               // as they were at the last call
    std::vector<Box> changed;  // where they have changed since
    size_t evaluated = 0;
};

std::string settingsOf(Scene& scene, const MapLayer& layer) {
    std::string text = fmt::format("{} {} {}", static_cast<int>(layer.kind), layer.invert, scene.of);
    for (const MapMask& m : layer.masks) {
        const MaskRow& row = maskRows()[static_cast<size_t>(m.by)];
        text += fmt::format("|{} {} {} {} {} {} {} {} {}", static_cast<int>(m.by), m.from, m.to, m.falloff, m.invert,
                            m.size, m.seed, m.object, row.inputs ? row.inputs(scene.masks, m) : "");
    }
    return text;
}

bool followsHeights(const MapLayer& layer) {
    return std::any_of(layer.masks.begin(), layer.masks.end(),
                       [](const MapMask& m) { return maskRows()[static_cast<size_t>(m.by)].followsHeights; });
}

using Places = std::function<float(double u, double v)>;  // an amount by shares of the terrain's sides

// Fails where a mask goes by something that is not there.
Result<Places> rulePlaces(Scene& scene, const MapLayer& layer) {
    std::vector<std::pair<const MapMask*, Measure>> masks;
    for (const MapMask& m : layer.masks) {
        Result<Measure> measure = maskRows()[static_cast<size_t>(m.by)].measure(scene.masks, m);
        if (!measure) {
            Error e = measure.error();
            e.message = fmt::format("mask \"{}\": {}", m.name, e.message);
            return e;
        }
        masks.emplace_back(&m, std::move(*measure));
    }
    const glm::dvec2 size = scene.masks.ground.terrain->size;
    return Places([masks = std::move(masks), size, invert = layer.invert](double u, double v) {
        float share = 1;
        for (const auto& [mask, measure] : masks)
            if (share > 0) share *= maskShare(*mask, measure(u * size.x, v * size.y));
        return invert ? 1 - share : share;
    });
}

Result<Places> mapPlaces(Scene&, const MapLayer& layer) {
    if (!layer.amounts.present()) {
        const bool lost = !layer.amounts.file.empty();
        return unsound(lost ? fmt::format("its file {} is not there", layer.amounts.file) : "it has no amounts yet",
                       lost ? "put the file back, or import it again" : "import an image into it, or paint on it");
    }
    return Places([map = layer.amounts.map, invert = layer.invert](double u, double v) {
        const float amount = map.sample(u, v);
        return invert ? 1 - amount : amount;
    });
}

struct KindRow {
    LayerKindRow shown;
    Result<Places> (*places)(Scene&, const MapLayer&);
};
constexpr KindRow kKinds[] = {
    {{"where masks let it: by slope, height, noise, water or an object", false}, rulePlaces},
    {{"an imported map", true}, mapPlaces},
    {{"a further painted map", true}, mapPlaces},
};
static_assert(std::size(kKinds) == kLayerKinds.size());

// Evaluates what is not up to date.
Status updateCoverage(Coverage& c, Scene& scene, const MapLayer& layer, const MapInfo& info) {
    const Result<Places> places = kKinds[static_cast<size_t>(layer.kind)].places(scene, layer);
    if (!places) return places.error();
    std::string of = settingsOf(scene, layer);
    const MapInfo wanted{info.width, info.height, 1, PixelType::U16};
    const bool fresh = c.map.info() != wanted || c.of != of;
    std::vector<Box> changed{kEverywhere};
    if (!fresh) {
        changed = followsHeights(layer) ? scene.changed : std::vector<Box>();
        const std::vector<Box> painted = changedBoxes(c.source, layer.amounts.map);
        changed.insert(changed.end(), painted.begin(), painted.end());
    }
    c.of = std::move(of);
    c.source = layer.amounts.map;
    if (c.map.info() != wanted) c.map = Map(wanted);
    const std::vector<TilePlace> tiles = tilesIn(c.map, changed);
    if (tiles.empty()) return {};
    evaluate(c.map, tiles, [&](TilePlace at, Numbers& out) {
        const int w = std::min(kTileSize, info.width - at.x * kTileSize),
                  h = std::min(kTileSize, info.height - at.y * kTileSize);
        readTile(c.map, at.x, at.y, out);
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x) {
                const double u = (at.x * kTileSize + x + 0.5) / info.width,
                             v = (at.y * kTileSize + y + 0.5) / info.height;
                if (isIn(changed, u, v))
                    out[static_cast<size_t>(y) * kTileSize + static_cast<size_t>(x)] = (*places)(u, v);
            }
    });
    scene.evaluated += tiles.size();
    c.zero = isZero(c.map);
    return {};
}

// --- stacks --------------------------------------------------------------------------------------------------------
float combined(LayerOperation operation, float below, float amount) {
    switch (operation) {
        case LayerOperation::Multiply:
            return below * amount;
        case LayerOperation::Add:
            return std::min(below + amount, 1.0f);
        case LayerOperation::Subtract:
            return std::max(below - amount, 0.0f);
        case LayerOperation::Replace:
            return amount;
        case LayerOperation::Minimum:
            return std::min(below, amount);
        case LayerOperation::Maximum:
            return std::max(below, amount);
    }
    return below;
}

// A layer that counts, over the map of its stack.
struct Over {
    const MapLayer* layer;
    const Map* coverage;
};

// What a map with layers came to at the last call, and of what.
struct Stack {
    Map final, painted;
    std::vector<Map> coverages;
    std::string of;  // operations and opacities
};

void combine(const Map& painted, const std::vector<Over>& layers, TilePlace at, Numbers& out) {
    if (painted.empty())
        std::fill(out.begin(), out.end(), 1.0f);
    else
        readTile(painted, at.x, at.y, out);
    Numbers amounts(kTileTexels);
    for (const Over& over : layers) {
        readTile(*over.coverage, at.x, at.y, amounts);
        const float opacity = over.layer->opacity;
        for (size_t i = 0; i < kTileTexels; ++i)
            out[i] += opacity * (combined(over.layer->operation, out[i], amounts[i]) - out[i]);
    }
}

// Tiles of the stack where the painted map or a layer is another than at the last call.
std::vector<TilePlace> changedTiles(const Stack& s, const Map& painted, const std::vector<Over>& layers) {
    std::vector<TilePlace> out;
    for (int ty = 0; ty < s.final.tilesY(); ++ty)
        for (int tx = 0; tx < s.final.tilesX(); ++tx) {
            bool differs = !painted.empty() && painted.tile(tx, ty) != s.painted.tile(tx, ty);
            for (size_t i = 0; i < layers.size() && !differs; ++i)
                differs = layers[i].coverage->tile(tx, ty) != s.coverages[i].tile(tx, ty);
            if (differs) out.push_back({tx, ty});
        }
    return out;
}

void updateStack(Stack& s, Scene& scene, const Map& painted, const MapInfo& info, const std::vector<Over>& layers) {
    std::string of;
    for (const Over& o : layers) of += fmt::format("{} {}|", static_cast<int>(o.layer->operation), o.layer->opacity);
    const bool fresh = s.final.info() != info || s.painted.info() != painted.info() || s.of != of;
    if (s.final.info() != info) s.final = Map(info);
    const std::vector<TilePlace> tiles = fresh ? tilesIn(s.final, {kEverywhere}) : changedTiles(s, painted, layers);
    evaluate(s.final, tiles, [&](TilePlace at, Numbers& out) { combine(painted, layers, at, out); });
    scene.evaluated += tiles.size();
    s.of = std::move(of);
    s.painted = painted;
    s.coverages.clear();
    for (const Over& o : layers) s.coverages.push_back(*o.coverage);
}

// What to say of a layer that counts and is 0 everywhere; empty if nothing.
std::string zeroSays(const MapLayer& layer) {
    switch (layer.operation) {
        case LayerOperation::Multiply:
        case LayerOperation::Replace:
        case LayerOperation::Minimum:
            return layer.opacity < 1 ? "" : "it is 0 everywhere and hides all of the map: widen or invert it";
        default:
            return layer.operation == LayerOperation::Subtract && layer.invert
                       ? ""
                       : "it is 0 everywhere and changes nothing: widen or invert it";
    }
}

// The field of the map that layers lie over, or why they cannot.
Result<FieldRef> layeredMap(Project& p, std::span<const ComponentRow> rows, const Terrain& terrain,
                            const std::string& path) {
    Result<FieldRef> field = findField(p, rows, path);
    if (!field || field->row->type != FieldType::Map)
        return unsound(fmt::format("there is no map {}", path), "name another, or bring it back");
    if (isRowOf<MapLayers>(*field->component) || field->row->map->kind != MapKind::Amounts || field->row->map->onMesh)
        return unsound(fmt::format("{} holds no amounts on the terrain", path),
                       "layers lie over densities and the like");
    if (tilingOf(terrain, mapTiling(*field)).repeats)
        return unsound(fmt::format("{} repeats, and layers lie on the whole terrain", path),
                       "set its tiling to 1 and Terrain.mapSize to 0");
    return field;
}

}  // namespace

std::span<const LayerKindRow> layerKindRows() {
    static const std::vector<LayerKindRow> rows = [] {
        std::vector<LayerKindRow> out;
        for (const KindRow& row : kKinds) out.push_back(row.shown);
        return out;
    }();
    return rows;
}

// --- the project as it is shown ------------------------------------------------------------------------------------

struct MapStacks::Impl {
    std::span<const ComponentRow> rows;
    Scene scene;
    std::map<std::string, Coverage> coverages;  // by the layer's PATH
    std::map<std::string, Stack> stacks;        // by the map's PATH
    std::optional<Project> made;
    std::vector<LayerNote> notes;

    void look(const Project& p);
    bool stackEntity(const std::string& entity, const MapLayers& of, Project& to, std::set<std::string>& asked);
    bool stackMap(const std::string& path, const std::vector<std::pair<std::string, const MapLayer*>>& layers,
                  Project& to, std::set<std::string>& asked);
};

// Takes the scene's terrain, and where its heights have changed.
void MapStacks::Impl::look(const Project& p) {
    scene.evaluated = 0;
    scene.masks.project = &p;
    scene.masks.ground = findGround(p);
    const Terrain* t = scene.masks.ground.terrain;
    if (!t) return;
    const auto [offset, scale] = heightScale(*t);
    scene.of = fmt::format("{} {} {} {} {} {}", t->size.x, t->size.y, offset, scale, t->heightTiling, t->mapSize);
    scene.changed = changedBoxes(scene.heights, t->height.map);
    if (!scene.changed.empty() && tilingOf(*t, t->heightTiling).repeats) scene.changed = {kEverywhere};
    scene.heights = t->height.map;
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
    std::vector<Over> over;
    for (const auto& [layer, of] : layers) {
        Coverage& c = coverages[layer];
        asked.insert(layer);
        if (const Status done = updateCoverage(c, scene, *of, info); !done) {
            c = {};  // what changes meanwhile would be missed
            skip(layer, done.error());
            continue;
        }
        if (const std::string says = c.zero ? zeroSays(*of) : ""; !says.empty()) notes.push_back({layer, says, false});
        over.push_back({of, &c.map});
        if (const Result<FieldRef> own = findField(to, rows, layer + ".amounts"))
            *static_cast<MapField*>(own->value) = {"maps/coverage", c.map};
    }
    if (over.empty()) return false;
    asked.insert(path);
    Stack& stack = stacks[path];
    updateStack(stack, scene, target.map, info, over);
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
    for (const auto& [map, layers] : over) any |= stackMap(map, layers, to, asked);
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
    m.look(p);
    m.made = snapshot(p, m.rows);
    std::set<std::string> asked;
    bool any = false;
    for (const auto& [name, e] : p.entities)
        if (const MapLayers* layers = p.registry.get<MapLayers>(e)) any |= m.stackEntity(name, *layers, *m.made, asked);
    std::erase_if(m.coverages, [&](const auto& held) { return !asked.contains(held.first); });
    std::erase_if(m.stacks, [&](const auto& held) { return !asked.contains(held.first); });
    return any ? *m.made : p;
}

const std::vector<LayerNote>& MapStacks::notes() const { return impl_->notes; }
size_t MapStacks::evaluatedTiles() const { return impl_->scene.evaluated; }

}  // namespace sward
