#include "world/height_layers.h"

#include <algorithm>
#include <functional>
#include <set>

#include "scene/ground_path.h"
#include "scene/map_fields.h"
#include "scene/tiling.h"
#include "world/ground.h"

namespace sward {
namespace {

struct Over {
    std::string path;  // PATH of the layer
    const MapLayer* layer = nullptr;
};

// A layer over the ground below it, from call to call.
struct LaidLayer {
    Terrain ground;  // as those below leave it
    LayerScene scene;
    Coverage cover;
    std::string of;  // how it combines
    Map after;
};

// Layers over the heights that count, the lowest first.
std::vector<Over> layersOverHeights(const Project& p, const std::string& heights) {
    std::vector<Over> out;
    const std::string entity = heights.substr(0, heights.find('.'));
    const MapLayers* of = p.registry.get<MapLayers>(findEntity(p, entity));
    if (!of) return out;
    const std::vector<std::string> paths = layerPaths(entity, *of);
    for (size_t i = 0; i < paths.size(); ++i)
        if (const MapLayer& l = of->layers[i]; !l.muted && l.opacity > 0 && layeredPath(entity, l) == heights)
            out.push_back({paths[i], &l});
    return out;
}

// Why a layer cannot lie over heights; nothing if it can.
Status fits(const MapLayer& layer) {
    if (layer.kind != LayerKind::Path) return {};
    if (layer.invert) return unsound("a path levels the ground beside it alone", "switch invert off");
    if (layer.operation == LayerOperation::Replace || layer.operation == LayerOperation::Minimum ||
        layer.operation == LayerOperation::Maximum)
        return {};
    return unsound("a path levels by replace, minimum (it only cuts) or maximum (it only fills)", "choose one of them");
}

// Metres that a layer brings to a texel, by its amount and the place in shares of the terrain's sides.
using Brings = std::function<float(float amount, double u, double v)>;
Brings broughtBy(const LaidLayer& s, const MapLayer& layer) {
    const float low = layer.low, high = layer.high;
    if (layer.kind == LayerKind::Rule) return [high](float, double, double) { return high; };
    if (layer.kind != LayerKind::Path)
        return [low, high](float amount, double, double) { return low + (high - low) * amount; };
    const GroundPath& path = **pathNamed(s.scene.masks, layer.path);
    return [&t = s.ground, curve = groundCurve(path), reach = reachOf(path), low](float, double u, double v) {
        const glm::dvec2 at = nearestOn(curve, glm::dvec2(u, v) * t.size, reach).at;
        return static_cast<float>(terrainHeight(t, at.x, at.y)) + low;
    };
}
// Share of its effect by its amount: images and painted layers count everywhere.
float shareOf(const MapLayer& layer, float amount) {
    return layer.opacity * (layer.kind == LayerKind::Rule || layer.kind == LayerKind::Path ? amount : 1);
}

void combineTile(const LaidLayer& s, const MapLayer& layer, const Brings& brings, TilePlace at, Numbers& out) {
    const MapInfo& info = s.after.info();
    Numbers amounts(kTileTexels);
    readTile(s.ground.height.map, at.x, at.y, out);
    readTile(s.cover.map, at.x, at.y, amounts);
    for (size_t i = 0; i < kTileTexels; ++i) {
        const float share = shareOf(layer, amounts[i]);
        if (share == 0) continue;
        const double x = at.x * kTileSize + static_cast<int>(i % kTileSize) + 0.5,
                     y = at.y * kTileSize + static_cast<int>(i / kTileSize) + 0.5;
        const float metres = brings(amounts[i], x / info.width, y / info.height);
        out[i] += share * (combined(layer.operation, out[i], metres) - out[i]);
    }
}

// Boxes wider by metres, on a terrain of this size.
std::vector<MapBox> wider(std::vector<MapBox> boxes, double metres, const glm::dvec2& size) {
    for (MapBox& b : boxes)
        b = {b.x0 - metres / size.x, b.z0 - metres / size.y, b.x1 + metres / size.x, b.z1 + metres / size.y};
    return boxes;
}

// Where the ground below has changed what comes out: there, and for a path as far as it carries heights aside.
std::vector<MapBox> changedBelow(const LaidLayer& s, const MapLayer& layer) {
    if (layer.kind != LayerKind::Path) return s.scene.changed;
    return wider(s.scene.changed, reachOf(**pathNamed(s.scene.masks, layer.path)), s.ground.size);
}

// Brings a layer up to date with the ground below.
Status updateLaid(LaidLayer& s, const Project& p, const Ground& ground, const MapLayer& layer, const Map& below) {
    if (Status can = fits(layer); !can) return can;
    s.ground = *ground.terrain;
    s.ground.height = {"maps/layered", below};
    lookAt(s.scene, p, {&s.ground, ground.origin});
    const Map before = s.cover.map;
    const MapInfo& info = below.info();
    if (Status done = updateCoverage(s.cover, s.scene, layer, info); !done) return done;
    std::string of = fmt::format("{} {} {} {} {}", static_cast<int>(layer.kind), static_cast<int>(layer.operation),
                                 layer.opacity, layer.low, layer.high);
    const bool fresh = s.after.info() != info || s.of != of || before.info() != info;
    if (s.after.info() != info) s.after = Map(info);
    s.of = std::move(of);
    std::vector<TilePlace> tiles = tilesIn(s.after, fresh ? std::vector{kEverywhere} : changedBelow(s, layer));
    if (!fresh)
        for (const TilePlace& t : tilesThatDiffer(before, s.cover.map))
            if (std::find(tiles.begin(), tiles.end(), t) == tiles.end()) tiles.push_back(t);
    const Brings brings = broughtBy(s, layer);
    evaluateTiles(s.after, tiles, NumberRange::Any,
                  [&](TilePlace at, Numbers& out) { combineTile(s, layer, brings, at, out); });
    s.scene.evaluated += tiles.size();
    return {};
}

}  // namespace

std::string heightsPath(const Project& p) {
    const Terrain* terrain = findGround(p).terrain;
    return terrain ? entityOf(p, *terrain) + ".Terrain.height" : std::string();
}

void setLayeredHeights(Project& to, const Map& metres) {
    const Terrain* found = findGround(to).terrain;
    CHECK(found);
    Terrain* terrain = to.registry.get<Terrain>(findEntity(to, entityOf(to, *found)));
    terrain->height = {terrain->height.file.empty() ? "maps/layered" : terrain->height.file, metres};
}

struct HeightLayers::Impl {
    std::map<std::string, LaidLayer> laid;  // by the layer's PATH
    Map painted, metres;                    // as painted, and that in metres
    std::string scale;                      // what its texels meant
    Map final;
    std::vector<LayerNote> notes;
    size_t evaluated = 0;

    void takePainted(const Terrain& t);
};

// Brings `metres` up to date with what is painted.
void HeightLayers::Impl::takePainted(const Terrain& t) {
    if (!t.height.present()) {
        MapInfo info = newMapInfo(MapRow{.texelsPerMetre = 4}, std::max(t.size.x, t.size.y));
        info.type = PixelType::F32;
        if (metres.info() != info || !painted.empty()) metres = Map(info);
        painted = {};
        return;
    }
    const Map& now = t.height.map;
    if (now.info().type == PixelType::F32) {
        painted = metres = now;
        return;
    }
    const auto [offset, factor] = heightScale(t);
    const std::string meaning = fmt::format("{} {}", offset, factor);
    const MapInfo info{now.info().width, now.info().height, 1, PixelType::F32};
    const bool fresh = metres.info() != info || painted.info() != now.info() || scale != meaning;
    if (fresh) metres = Map(info);
    scale = meaning;
    const auto low = static_cast<float>(offset), by = static_cast<float>(factor);
    evaluateTiles(metres, fresh ? tilesIn(metres, {kEverywhere}) : tilesThatDiffer(painted, now), NumberRange::Any,
                  [&](TilePlace at, Numbers& out) {
                      readTile(now, at.x, at.y, out);
                      for (float& v : out) v = low + by * v;
                  });
    painted = now;
}

HeightLayers::HeightLayers() : impl_(std::make_unique<Impl>()) {}
HeightLayers::~HeightLayers() = default;
HeightLayers::HeightLayers(HeightLayers&&) noexcept = default;
HeightLayers& HeightLayers::operator=(HeightLayers&&) noexcept = default;

const Map* HeightLayers::shown(const Project& p) {
    Impl& m = *impl_;
    m.notes.clear();
    m.evaluated = 0;
    const std::string heights = heightsPath(p);
    const std::vector<Over> layers = heights.empty() ? std::vector<Over>() : layersOverHeights(p, heights);
    const Ground ground = findGround(p);
    if (layers.empty()) {
        *this = HeightLayers();
        return nullptr;
    }
    if (tilingOf(*ground.terrain, ground.terrain->heightTiling).repeats) {
        for (const Over& over : layers)
            m.notes.push_back({over.path,
                               unsound(fmt::format("{} is mirrored, and layers lie on the whole terrain", heights),
                                       "set Terrain.heightTiling to 1 and Terrain.mapSize to 0")
                                   .text(),
                               true});
        return nullptr;
    }
    m.takePainted(*ground.terrain);
    std::set<std::string> asked;
    m.final = m.metres;
    for (const Over& over : layers) {
        LaidLayer& s = m.laid[over.path];
        if (const Status done = updateLaid(s, p, ground, *over.layer, m.final); !done) {
            m.notes.push_back({over.path, done.error().text(), true});
            continue;  // it is forgotten below: what changes meanwhile would be missed
        }
        asked.insert(over.path);
        m.evaluated += s.scene.evaluated;
        if (s.cover.zero && !layerKindRows()[static_cast<size_t>(over.layer->kind)].ownMap)
            m.notes.push_back({over.path, "it is 0 everywhere and changes nothing: widen or invert it", false});
        m.final = s.after;
    }
    std::erase_if(m.laid, [&](const auto& held) { return !asked.contains(held.first); });
    return asked.empty() ? nullptr : &m.final;
}

const std::vector<LayerNote>& HeightLayers::notes() const { return impl_->notes; }
size_t HeightLayers::evaluatedTiles() const { return impl_->evaluated; }

bool hasHeightLayers(const Project& p) {
    const std::string heights = heightsPath(p);
    return !heights.empty() && !layersOverHeights(p, heights).empty();
}

std::optional<Project> standingOnLayers(HeightLayers& layers, const Project& p, std::span<const ComponentRow> rows) {
    const Map* heights = layers.shown(p);
    return heights ? std::optional(standingOn(p, *heights, rows)) : std::nullopt;
}

Project standingOn(const Project& p, const Map& heights, std::span<const ComponentRow> rows) {
    Project out = snapshot(p, rows);
    setLayeredHeights(out, heights);
    const std::string path = heightsPath(out), entity = path.substr(0, path.find('.'));
    if (MapLayers* of = out.registry.get<MapLayers>(findEntity(out, entity)))
        std::erase_if(of->layers, [&](const MapLayer& l) { return layeredPath(entity, l) == path; });
    return out;
}

std::map<std::string, Map> HeightLayers::coverages() const {
    std::map<std::string, Map> out;
    for (const auto& [path, layer] : impl_->laid) out[path] = layer.cover.map;
    return out;
}

}  // namespace sward
