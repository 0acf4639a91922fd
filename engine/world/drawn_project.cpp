#include "world/drawn_project.h"

#include <algorithm>
#include <cmath>

#include "core/jobs.h"
#include "core/numerics.h"
#include "scene/map_fields.h"
#include "scene/tiling.h"
#include "world/layered_tiles.h"

namespace sward {
namespace {

constexpr int kMostTexels = 4096;  // a side of a map that is made here

// --- what a path does to a map: a row each -----------------------------------------------------------------------

struct PathEffect {
    bool (*takes)(const ConstFieldRef& map);
    float (*amount)(const GroundPath&);  // 0: it does nothing
    float absent;                        // value of a map that is not there
    // `share`: the amount times the path's weight there.
    void (*blend)(Map&, int x, int y, const GroundPath&, float share);
};

template <class C>
bool densityOf(const ConstFieldRef& map) {
    return isRowOf<C>(*map.component) && map.row->map->role == MapRole::Density;
}
bool groundColours(const ConstFieldRef& map) {
    return isRowOf<Terrain>(*map.component) && map.row->map->kind == MapKind::Colours;
}

// Towards none below 0, towards all above.
void thin(Map& m, int x, int y, const GroundPath&, float share) {
    const float value = m.at(x, y);
    m.set(x, y, 0, value + ((share > 0 ? 1.0f : 0.0f) - value) * std::abs(share));
}
// The path's colour over the map's.
void tint(Map& m, int x, int y, const GroundPath& path, float share) {
    const glm::vec4 now = laidOver({m.at(x, y, 0), m.at(x, y, 1), m.at(x, y, 2), m.at(x, y, 3)}, path.color, share);
    for (int c = 0; c < 4; ++c) m.set(x, y, c, now[c]);
}

constexpr PathEffect kEffects[] = {
    {densityOf<GrassField>, [](const GroundPath& p) { return p.grass; }, 1, thin},
    {densityOf<Flowers>, [](const GroundPath& p) { return p.flowers; }, 1, thin},
    {groundColours, [](const GroundPath& p) { return p.tint; }, 0, tint},
};

const PathEffect* effectOn(const ConstFieldRef& map) {
    const auto found =
        std::find_if(std::begin(kEffects), std::end(kEffects), [&](const PathEffect& e) { return e.takes(map); });
    return found == std::end(kEffects) ? nullptr : found;
}

// --- the map below the paths -------------------------------------------------------------------------------------

Map filledWith(const MapInfo& info, float value) {
    Map out(info);
    if (value == 0) return out;
    for (int y = 0; y < std::min(info.height, kTileSize); ++y)
        for (int x = 0; x < std::min(info.width, kTileSize); ++x) out.set(x, y, 0, value);
    for (int ty = 0; ty < out.tilesY(); ++ty)
        for (int tx = 0; tx < out.tilesX(); ++tx) out.setTile(tx, ty, out.tile(0, 0));
    return out;
}

// Texels that all repeats of a map have over an extent in metres.
glm::dvec2 texelsOver(const Map& map, const Tiling& tiling, const glm::dvec2& extent) {
    return glm::ceil(glm::dvec2(map.info().width, map.info().height) * extent / tiling.metres);
}
bool tooLarge(const Map& map, const Tiling& tiling, const glm::dvec2& extent) {
    const glm::dvec2 texels = texelsOver(map, tiling, extent);
    return !map.empty() && tiling.repeats && std::max(texels.x, texels.y) > kMostTexels;
}
// A map that repeats, as one that does not.
Map unrolled(const Map& map, const Tiling& tiling, const glm::dvec2& extent) {
    const glm::ivec2 texels = glm::max(texelsOver(map, tiling, extent), 1.0);
    MapInfo info = map.info();
    info.width = texels.x, info.height = texels.y;
    Map out(info);
    for (int y = 0; y < info.height; ++y)
        for (int x = 0; x < info.width; ++x)
            for (int c = 0; c < info.channels; ++c)
                out.set(
                    x, y, c,
                    tiledSample(map, tiling, (x + 0.5) / info.width * extent.x, (y + 0.5) / info.height * extent.y, c));
    return out;
}

// Metres that a map covers which lies on the terrain once, and the tiling that says so.
glm::dvec2 wholeExtent(const Terrain& t) { return t.mapSize > 0 ? glm::dvec2(std::max(t.size.x, t.size.y)) : t.size; }
float wholeTiling(const Terrain& t) {
    return t.mapSize > 0 ? static_cast<float>(static_cast<double>(t.mapSize) / wholeExtent(t).x) : 1;
}

// --- tiles -------------------------------------------------------------------------------------------------------

bool meet(const GroundBox& a, const GroundBox& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}
GroundBox tileBox(const Map& m, const glm::dvec2& extent, int tx, int ty) {
    const glm::dvec2 texel = extent / glm::dvec2(m.info().width, m.info().height),
                     low = glm::dvec2(tx, ty) * static_cast<double>(kTileSize) * texel;
    return {low, low + static_cast<double>(kTileSize) * texel};
}
// Adds the parts of a piece, halved so many times, that reach into a box: short ones lie close in their own boxes, so
// that most of the others' texels are passed over.
void addParts(const CurvePiece& piece, const GroundBox& box, double reach, int halvings, GroundCurve& out) {
    if (!meet(boxOf({{piece}}, reach), box)) return;
    if (halvings == 0) return out.pieces.push_back(piece);
    const auto& [a, b, c, d] = piece.bezier;
    const glm::dvec2 ab = 0.5 * (a + b), bc = 0.5 * (b + c), cd = 0.5 * (c + d), abc = 0.5 * (ab + bc),
                     bcd = 0.5 * (bc + cd), middle = 0.5 * (abc + bcd);
    addParts({{a, ab, abc, middle}, piece.from}, box, reach, halvings - 1, out);
    addParts({{middle, bcd, cd, d}, piece.from}, box, reach, halvings - 1, out);
}
GroundCurve partsIn(const PathOver& over, const GroundBox& box, double reach) {
    GroundCurve out;
    for (const CurvePiece& piece : over.curve.pieces) addParts(piece, box, reach, 3, out);
    return out;
}

// The mean of the weight over a texel across the path, so that one narrower than texels is an even line.
float meanWeight(const GroundPath& path, double distance, double texel) {
    constexpr int kSamples = 4;
    double sum = 0;
    for (int i = 0; i < kSamples; ++i) sum += weightAt(path, std::abs(distance + ((i + 0.5) / kSamples - 0.5) * texel));
    return static_cast<float>(sum / kSamples);
}

void layOver(Map& m, const glm::dvec2& extent, int tx, int ty, const PathOver& over, const PathEffect& effect) {
    const MapInfo& info = m.info();
    const glm::dvec2 size = extent / glm::dvec2(info.width, info.height);
    const double texel = std::max(size.x, size.y);
    const double reach = reachOf(over.path) + texel;  // a texel more, for what is filtered
    const GroundCurve curve = partsIn(over, tileBox(m, extent, tx, ty), reach);
    for (int y = ty * kTileSize; y < std::min((ty + 1) * kTileSize, info.height) && !curve.pieces.empty(); ++y)
        for (int x = tx * kTileSize; x < std::min((tx + 1) * kTileSize, info.width); ++x) {
            const double distance = nearestOn(curve, (glm::dvec2(x, y) + 0.5) * size, reach).distance;
            if (!std::isfinite(distance)) continue;
            const float share = effect.amount(over.path) * meanWeight(over.path, distance, texel);
            if (share != 0) effect.blend(m, x, y, over.path, share);
        }
}

// Where a path acts that is not the same in both: around the pieces that only one of them has.
void addChanges(const PathOver& a, const PathOver& b, double texel, std::vector<GroundBox>& out) {
    GroundPath like = a.path;
    like.points = b.path.points;
    const bool same = like == b.path;  // but for its points
    const auto has = [&](const PathOver& in, const CurvePiece& piece) {
        return same && std::any_of(in.curve.pieces.begin(), in.curve.pieces.end(),
                                   [&](const CurvePiece& p) { return p.bezier == piece.bezier; });
    };
    for (const auto& [from, other] : {std::pair(&a, &b), std::pair(&b, &a)})
        for (const CurvePiece& piece : from->curve.pieces)
            if (!has(*other, piece)) out.push_back(boxOf({{piece}}, reachOf(from->path) + texel));
}
std::vector<GroundBox> changedAlong(const std::vector<PathOver>& a, const std::vector<PathOver>& b, double texel) {
    const PathOver none;
    std::vector<GroundBox> out;
    for (size_t i = 0; i < std::max(a.size(), b.size()); ++i)
        addChanges(i < a.size() ? a[i] : none, i < b.size() ? b[i] : none, texel, out);
    return out;
}

std::vector<PathOver> pathsOf(const Project& p) {
    std::vector<PathOver> out;
    for (const auto& [name, entity] : p.entities)
        if (const GroundPath* path = p.registry.get<GroundPath>(entity))
            if (GroundCurve curve = groundCurve(*path); !curve.pieces.empty()) out.push_back({*path, std::move(curve)});
    return out;
}
std::vector<PathOver> actingOn(const std::vector<PathOver>& paths, const PathEffect& effect) {
    std::vector<PathOver> out;
    for (const PathOver& over : paths)
        if (effect.amount(over.path) != 0) out.push_back(over);
    return out;
}

bool tooLarge(const Terrain& t, const ConstFieldRef& map) {
    return tooLarge(mapOf(map).map, tilingOf(t, mapTiling(map)), wholeExtent(t));
}

// Brings `base` up to date with what is painted.
void followPainted(LaidMap& laid, const Terrain& t, const ConstFieldRef& map, float absent) {
    const Map& painted = mapOf(map).map;
    const Tiling tiling = tilingOf(t, mapTiling(map));
    const glm::dvec2 extent = wholeExtent(t);
    const bool same = laid.painted.sameTiles(painted) && laid.extent == extent && laid.tiling == tiling;
    if (!painted.empty() && !tiling.repeats)
        laid.base = painted;
    else if (!same || laid.base.empty())
        laid.base = painted.empty() ? filledWith(newMapInfo(*map.row->map, std::max(extent.x, extent.y)), absent)
                                    : unrolled(painted, tiling, extent);
    laid.painted = painted, laid.tiling = tiling, laid.extent = extent;
}

// Brings `drawn` up to date with what was `base`, and with the paths; where neither has changed its tiles stay.
void layPaths(LaidMap& laid, const Map& was, bool fresh, const PathEffect& effect, std::vector<PathOver> paths) {
    const MapInfo& info = laid.base.info();
    const double texel = std::max(laid.extent.x / info.width, laid.extent.y / info.height);
    const std::vector<GroundBox> changed = changedAlong(laid.paths, paths, texel);
    laid.paths = std::move(paths);
    if (fresh) laid.drawn = laid.base;
    std::vector<glm::ivec2> tiles;
    for (int ty = 0; ty < laid.base.tilesY(); ++ty)
        for (int tx = 0; tx < laid.base.tilesX(); ++tx) {
            const GroundBox box = tileBox(laid.base, laid.extent, tx, ty);
            const bool moved =
                std::any_of(changed.begin(), changed.end(), [&](const GroundBox& b) { return meet(b, box); });
            if (fresh || moved || laid.base.tile(tx, ty) != was.tile(tx, ty)) tiles.push_back({tx, ty});
        }
    parallelFor(tiles.size(), [&](size_t i) {
        const glm::ivec2 at = tiles[i];
        laid.drawn.setTile(at.x, at.y, laid.base.tile(at.x, at.y));
        for (const PathOver& over : laid.paths) layOver(laid.drawn, laid.extent, at.x, at.y, over, effect);
    });
}

// Puts what is drawn in the place of what is painted.
void putDrawn(const LaidMap& laid, const Terrain& t, const FieldRef& map) {
    MapField& field = *static_cast<MapField*>(map.value);
    if (field.file.empty()) field.file = mapFileFor(map, laid.drawn.info());
    field.map = laid.drawn;
    *static_cast<float*>(fieldBeside(map, *map.row->map->tiling).value) = wholeTiling(t);
}

}  // namespace

const Project& DrawnProject::of(const Project& painted, std::span<const ComponentRow> rows) {
    const Project& p = stacks_.shown(painted, rows);
    const std::vector<PathOver> paths = pathsOf(p);
    const Terrain* terrain = firstOf<Terrain>(p);
    if (paths.empty() || !terrain) {
        maps_.clear();
        drawn_ = {};
        return p;
    }
    drawn_ = snapshot(p, rows);
    std::map<std::string, LaidMap> kept;
    for (const FieldRef& map : allMaps(drawn_, rows, true)) {
        const PathEffect* effect = effectOn(map);
        std::vector<PathOver> acting = effect ? actingOn(paths, *effect) : std::vector<PathOver>();
        if (acting.empty() || tooLarge(*terrain, map)) continue;
        LaidMap& laid = kept[map.path] = std::move(maps_[map.path]);
        const Map was = laid.base;
        const glm::dvec2 extent = laid.extent;
        followPainted(laid, *terrain, map, effect->absent);
        const bool fresh = !(was.info() == laid.base.info()) || extent != laid.extent;
        layPaths(laid, was, fresh, *effect, std::move(acting));
        putDrawn(laid, *terrain, map);
    }
    maps_ = std::move(kept);
    return drawn_;
}

std::vector<std::string> mapsBeyondPaths(const Project& p, std::span<const ComponentRow> rows) {
    const std::vector<PathOver> paths = pathsOf(p);
    const Terrain* terrain = firstOf<Terrain>(p);
    std::vector<std::string> out;
    if (paths.empty() || !terrain) return out;
    for (const ConstFieldRef& map : allMaps(p, rows))
        if (const PathEffect* effect = effectOn(map); effect && !actingOn(paths, *effect).empty())
            if (tooLarge(*terrain, map)) out.push_back(map.path);
    return out;
}
std::string beyondPaths(const std::string& map) {
    return fmt::format(
        "{} repeats so often that its texels over the whole terrain are more than {} a side: paths leave it "
        "alone; lower its tiling, or make the map coarser",
        map, kMostTexels);
}

}  // namespace sward
