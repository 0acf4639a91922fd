// Index: what a coverage is of · amounts by places · kinds · coverage.
#include "world/layer_coverage.h"

#include <algorithm>
#include <functional>

#include "scene/tiling.h"

namespace sward {
namespace {

std::string settingsOf(LayerScene& scene, const MapLayer& layer) {
    std::string text = fmt::format("{} {} {}", static_cast<int>(layer.kind), layer.invert, scene.of);
    if (layer.kind == LayerKind::Path) text += pathText(scene.masks, layer.path);
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

using AmountAt = std::function<float(double u, double v)>;  // an amount by shares of the terrain's sides

// Fails where a mask goes by something that is not there.
Result<AmountAt> rulePlaces(LayerScene& scene, const MapLayer& layer) {
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
    return AmountAt([masks = std::move(masks), size, invert = layer.invert](double u, double v) {
        float share = 1;
        for (const auto& [mask, measure] : masks)
            if (share > 0) share *= maskShare(*mask, measure(u * size.x, v * size.y));
        return invert ? 1 - share : share;
    });
}

Result<AmountAt> mapPlaces(LayerScene&, const MapLayer& layer) {
    if (!layer.amounts.present()) {
        const bool lost = !layer.amounts.file.empty();
        return unsound(lost ? fmt::format("its file {} is not there", layer.amounts.file) : "it has no amounts yet",
                       lost ? "put the file back, or import it again" : "import an image into it, or paint on it");
    }
    return AmountAt([map = layer.amounts.map, invert = layer.invert](double u, double v) {
        const float amount = map.sample(u, v);
        return invert ? 1 - amount : amount;
    });
}

// The weight of a path (scene/ground_path.h).
Result<AmountAt> pathPlaces(LayerScene& scene, const MapLayer& layer) {
    const Result<const GroundPath*> path = pathNamed(scene.masks, layer.path);
    if (!path) return path.error();
    const glm::dvec2 size = scene.masks.ground.terrain->size;
    return AmountAt([path = **path, curve = groundCurve(**path), size, invert = layer.invert](double u, double v) {
        const auto weight = static_cast<float>(weightAt(path, curve, glm::dvec2(u, v) * size));
        return invert ? 1 - weight : weight;
    });
}

struct KindRow {
    LayerKindRow shown;
    Result<AmountAt> (*places)(LayerScene&, const MapLayer&);
};
constexpr KindRow kKinds[] = {
    {{"where masks let it: by slope, height, noise, water or an object", false}, rulePlaces},
    {{"an imported map", true}, mapPlaces},
    {{"a further painted map", true}, mapPlaces},
    {{"along a path; over heights it levels the ground there", false}, pathPlaces},
};
static_assert(std::size(kKinds) == kLayerKinds.size());

}  // namespace

std::span<const LayerKindRow> layerKindRows() {
    static const std::vector<LayerKindRow> rows = [] {
        std::vector<LayerKindRow> out;
        for (const KindRow& row : kKinds) out.push_back(row.shown);
        return out;
    }();
    return rows;
}

void lookAt(LayerScene& scene, const Project& p, const Ground& ground) {
    scene.evaluated = 0;
    scene.masks.project = &p;
    scene.masks.ground = ground;
    const Terrain* t = ground.terrain;
    if (!t) return;
    const auto [offset, scale] = heightScale(*t);
    scene.of = fmt::format("{} {} {} {} {} {}", t->size.x, t->size.y, offset, scale, t->heightTiling, t->mapSize);
    scene.changed = changedBoxes(scene.heights, t->height.map);
    if (!scene.changed.empty() && tilingOf(*t, t->heightTiling).repeats) scene.changed = {kEverywhere};
    scene.heights = t->height.map;
}

Status updateCoverage(Coverage& c, LayerScene& scene, const MapLayer& layer, const MapInfo& wanted) {
    const Result<AmountAt> places = kKinds[static_cast<size_t>(layer.kind)].places(scene, layer);
    if (!places) return places.error();
    std::string of = settingsOf(scene, layer);
    const bool fresh = c.map.info() != wanted || c.of != of;
    std::vector<MapBox> changed{kEverywhere};
    if (!fresh) {
        changed = followsHeights(layer) ? scene.changed : std::vector<MapBox>();
        const std::vector<MapBox> painted = changedBoxes(c.source, layer.amounts.map);
        changed.insert(changed.end(), painted.begin(), painted.end());
    }
    c.of = std::move(of);
    c.source = layer.amounts.map;
    if (c.map.info() != wanted) c.map = Map(wanted);
    const std::vector<TilePlace> tiles = tilesIn(c.map, changed);
    if (tiles.empty()) return {};
    evaluateTiles(c.map, tiles, NumberRange::Unit, [&](TilePlace at, Numbers& out) {
        const int w = std::min(kTileSize, wanted.width - at.x * kTileSize),
                  h = std::min(kTileSize, wanted.height - at.y * kTileSize);
        readTile(c.map, at.x, at.y, out);
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x) {
                const double u = (at.x * kTileSize + x + 0.5) / wanted.width,
                             v = (at.y * kTileSize + y + 0.5) / wanted.height;
                if (isIn(changed, u, v))
                    out[static_cast<size_t>(y) * kTileSize + static_cast<size_t>(x)] = (*places)(u, v);
            }
    });
    scene.evaluated += tiles.size();
    c.zero = isZero(c.map);
    return {};
}

float combined(LayerOperation operation, float below, float amount) {
    switch (operation) {
        case LayerOperation::Multiply:
            return below * amount;
        case LayerOperation::Add:
            return below + amount;
        case LayerOperation::Subtract:
            return below - amount;
        case LayerOperation::Replace:
            return amount;
        case LayerOperation::Minimum:
            return std::min(below, amount);
        case LayerOperation::Maximum:
            return std::max(below, amount);
    }
    return below;
}

}  // namespace sward
