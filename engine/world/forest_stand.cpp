#include "world/forest_stand.h"

#include <algorithm>
#include <cmath>

#include "core/hash.h"
#include "core/jobs.h"
#include "core/numerics.h"
#include "mesh/mesh_io.h"
#include "scene/tiling.h"
#include "world/placement.h"

namespace sward {
namespace {

constexpr double kStagger = 0.1;
constexpr uint32_t kInsideKey = 3;  // beside the three families, for hashes

struct Stander {
    const Forest& forest;
    const Terrain& terrain;
    const ForestTiles& tiles;
    Tiling tiling;
    glm::dvec3 origin;
    uint32_t seed;

    bool stands(const glm::dvec2& at, uint32_t hash) const {
        if (!(at.x >= 0 && at.y >= 0 && at.x <= terrain.size.x && at.y <= terrain.size.y)) return false;
        if (forest.density.present() &&
            !(tiledSample(forest.density.map, tiling, at.x, at.y) > f32::hashUnit(f32::hash2(hash, 1))))
            return false;
        const double slope = glm::degrees(std::acos(std::min(terrainNormal(terrain, at.x, at.y).y, 1.0)));
        return slope >= forest.slopeDeg.x && slope <= forest.slopeDeg.y;
    }
    glm::dvec2 placeOf(const glm::ivec2& cell, const TileTree& t) const {
        const f64::vec2 corner = f64::fromLattice({cell.x, cell.y}, tiles.edge);
        return glm::dvec2(corner.x, corner.y) + t.at;
    }
    uint32_t hashOf(const glm::ivec2& cell, uint32_t key, size_t k) const {
        return f32::hash2(f32::cellHash(cell.x, cell.y, seed), key * 64 + static_cast<uint32_t>(k));
    }
    StandingTree tree(const ForestTile& tile, const TileTree& t, const glm::dvec2& at, uint32_t hash) const {
        const f64::vec2 within = f64::toLattice({t.at.x, t.at.y}, tiles.edge);
        const glm::vec2 stored(static_cast<float>(tile.cell % tiles.colors + within.x),
                               static_cast<float>(tile.cell / tiles.colors + within.y));
        return {origin + glm::dvec3(at.x, terrainHeight(terrain, at.x, at.y), at.y),
                t.species,
                t.size,
                t.headingDeg,
                stored,
                f32::hashUnit(f32::hash2(hash, 2)),
                false,
                forest.verticalScale};
    }
    // Adds those of a list that stand; `numbers` takes their place among the trees, -1 for the others.
    void add(const glm::ivec2& cell, const ForestTile& tile, uint32_t key, const std::vector<TileTree>& list,
             std::vector<StandingTree>& out, int32_t* numbers) const {
        for (size_t k = 0; k < list.size(); ++k) {
            const glm::dvec2 at = placeOf(cell, list[k]);
            const uint32_t h = hashOf(cell, key, k);
            numbers[k] = -1;
            if (!stands(at, h)) continue;
            numbers[k] = static_cast<int32_t>(out.size());
            out.push_back(tree(tile, list[k], at, h));
        }
    }
    // `use`(tile, key, list) of each list of trees that a cell of the lattice owns.
    template <class Use>
    void lists(const glm::ivec2& cell, const Use& use) const {
        const ForestTile up = tileAt(cell.x, cell.y, true, seed, tiles.colors),
                         down = tileAt(cell.x, cell.y, false, seed, tiles.colors);
        for (uint32_t f = 0; f < 3; ++f) use(up, f, tiles.onEdge[f][static_cast<size_t>(up.colors[f])]);
        use(down, kInsideKey, tiles.within(down.cell, false));
        use(up, kInsideKey + 1, tiles.within(up.cell, true));
    }
};

uint32_t latticeSeed(const Forest& forest) { return f32::hash2(static_cast<uint32_t>(forest.seed), 0x7115u); }
double riseOf(const ForestTiles& tiles) { return tiles.edge * 0.8660254037844386; }
Stander standerOf(const Forest& forest, const Ground& ground, const ForestTiles& tiles) {
    const Terrain& t = *ground.terrain;
    return {forest, t, tiles, tilingOf(t, forest.densityTiling), ground.origin, latticeSeed(forest)};
}
// Whether any tree may stand: there is a terrain, and not more are asked for than may be.
bool mayStand(const Forest& forest, const Ground& ground) {
    if (!ground.terrain || !grows(forest)) return false;
    const glm::dvec2 size = ground.terrain->size;
    return static_cast<double>(forest.perHectare) / 1e4 * size.x * size.y <= kMostForestTrees;
}

// What belongs to one cell of the lattice: its three edges' trees, and those of its two triangles.
struct CellTrees {
    std::array<std::array<int32_t, kMostOnEdge>, 3> onEdge;
    std::array<std::array<int32_t, kMostInside>, 2> inside;
};
// The cells from (i, j) on that may reach the terrain.
struct Row {
    int first = 0;
    std::vector<CellTrees> cells;
    std::vector<StandingTree> trees;
};

Row standRow(const Stander& s, int j, int first, int count) {
    Row row{first, std::vector<CellTrees>(static_cast<size_t>(count)), {}};
    for (int c = 0; c < count; ++c) {
        CellTrees& cell = row.cells[static_cast<size_t>(c)];
        for (auto& e : cell.onEdge) e.fill(-1);
        for (auto& e : cell.inside) e.fill(-1);
        const glm::ivec2 at(first + c, j);
        s.lists(at, [&](const ForestTile& tile, uint32_t key, const std::vector<TileTree>& list) {
            int32_t* numbers = key < kInsideKey ? cell.onEdge[key].data() : cell.inside[key - kInsideKey].data();
            s.add(at, tile, key, list, row.trees, numbers);
        });
    }
    return row;
}

void shift(CellTrees& cell, int32_t by) {
    const auto each = [&](auto& numbers) {
        for (int32_t& n : numbers)
            if (n >= 0) n += by;
    };
    for (auto& e : cell.onEdge) each(e);
    for (auto& e : cell.inside) each(e);
}

uint64_t hashOf(const std::vector<StandingTree>& trees) {
    Hasher h;
    const auto add = [&](const auto& v) { h.add(&v, sizeof(v)); };
    for (const StandingTree& t : trees) add(t.at), add(t.species), add(t.size), add(t.headingDeg), add(t.upright);
    return h.value();
}

bool standsByHand(const PlacedTree& p, const Forest& forest) {
    const size_t species = static_cast<size_t>(std::max(p.species, 0));
    return species < forest.species.size() && stands(forest.species[species]);
}
StandingTree handTree(const PlacedTree& p, const Forest& forest, const Ground& ground) {
    const double height = terrainHeight(*ground.terrain, p.at.x, p.at.y);
    return {ground.origin + glm::dvec3(p.at.x, height, p.at.y),
            static_cast<uint32_t>(std::max(p.species, 0)),
            p.size,
            p.headingDeg,
            {},
            0,
            true,
            forest.verticalScale};
}

}  // namespace

glm::dmat3 leaning(const glm::dvec2& lean) {
    glm::dmat3 m(1);
    m[1] = {lean.x, 1, lean.y};
    return m;
}
double trunkRadius(const TreeSpecies& s) {
    constexpr double kOf[] = {0.014, 0.026, 0.012};  // of the height, as trees are grown (mesh/tree_shapes.cpp)
    return static_cast<double>(s.height) * (s.file.empty() ? kOf[static_cast<size_t>(s.kind)] : 0.02);
}

StandingForest standingForest(const Forest& forest, const Ground& ground) {
    StandingForest out;
    if (!mayStand(forest, ground)) return out;
    const Terrain& t = *ground.terrain;
    out.tiles = forestTiles(forest);
    out.origin = ground.origin;
    const Stander s = standerOf(forest, ground, out.tiles);
    const uint32_t seed = out.seed = s.seed;
    // From one row and one cell beyond the terrain on each side, whose edges' trees may stand on it.
    const double rise = riseOf(out.tiles);
    const int rows = static_cast<int>(std::ceil(t.size.y / rise)) + 2;
    const int cells = static_cast<int>(std::ceil(t.size.x / out.tiles.edge)) + 3;
    const auto firstOf = [&](int j) { return static_cast<int>(std::floor(-0.5 * (j + 1))) - 1; };
    std::vector<Row> all(static_cast<size_t>(rows));
    parallelFor(all.size(), [&](size_t r) {
        const int j = static_cast<int>(r) - 1;
        all[r] = standRow(s, j, firstOf(j), cells + 1);
    });
    for (Row& r : all) {
        const int32_t by = static_cast<int32_t>(out.trees.size());
        for (CellTrees& c : r.cells) shift(c, by);
        out.trees.insert(out.trees.end(), r.trees.begin(), r.trees.end());
    }
    const auto cellAt = [&](const glm::ivec2& at) -> const CellTrees* {
        if (at.y < -1 || at.y >= rows - 1) return nullptr;
        const Row& r = all[static_cast<size_t>(at.y + 1)];
        const int c = at.x - r.first;
        return c < 0 || c >= static_cast<int>(r.cells.size()) ? nullptr : &r.cells[static_cast<size_t>(c)];
    };
    for (int j = -1; j < rows - 1; ++j)
        for (int c = 0; c <= cells; ++c)
            for (const bool up : {false, true}) {
                ForestTriangle tri{{firstOf(j) + c, j}, tileAt(firstOf(j) + c, j, up, seed, out.tiles.colors), {}};
                tri.trees.fill(-1);
                if (const CellTrees* own = cellAt(tri.cell))
                    std::copy(own->inside[up].begin(), own->inside[up].end(), tri.trees.begin());
                for (const EdgeFamily f : {EdgeFamily::Row, EdgeFamily::Slant, EdgeFamily::Across})
                    if (const CellTrees* owner = cellAt(edgeOwner(tri.cell.x, tri.cell.y, up, f))) {
                        const auto& list = owner->onEdge[static_cast<size_t>(f)];
                        std::copy(list.begin(), list.end(), tri.trees.begin() + firstSlot(f));
                    }
                if (std::any_of(tri.trees.begin(), tri.trees.end(), [](int32_t n) { return n >= 0; }))
                    out.triangles.push_back(tri);
            }
    for (const PlacedTree& p : forest.placed)  // behind all others, in no triangle, so that no volume has them
        if (standsByHand(p, forest)) out.trees.push_back(handTree(p, forest, ground));
    out.hash = hashOf(out.trees);
    return out;
}

ForestPlaces forestPlaces(const Forest& forest, const Ground& ground) {
    ForestPlaces out;
    if (!mayStand(forest, ground)) return out;
    out.rule = forest;
    out.tiles = forestTiles(forest);
    for (uint32_t i = 0; i < forest.placed.size(); ++i)
        if (standsByHand(forest.placed[i], forest)) out.byHand.emplace_back(forest.placed[i].at.x, i);
    std::sort(out.byHand.begin(), out.byHand.end());
    return out;
}

size_t treesNear(const ForestPlaces& places, const Ground& ground, const glm::dvec2& at, double reach,
                 std::vector<StandingTree>& out) {
    out.clear();
    if (!ground.terrain || places.tiles.inside.empty()) return 0;
    const Stander s = standerOf(places.rule, ground, places.tiles);
    const glm::dvec2 here = at - glm::dvec2(ground.origin.x, ground.origin.z);
    const auto isNear = [&](const glm::dvec2& foot) { return glm::dot(foot - here, foot - here) <= reach * reach; };
    size_t looked = 0;
    // A cell's trees lie within it or, on edges, within their circles beside it.
    const f64::vec2 middle = f64::toLattice({here.x, here.y}, places.tiles.edge);
    const double span = (reach + places.tiles.circle) / riseOf(places.tiles);
    const auto cellOf = [](double v) { return static_cast<int>(std::floor(v)); };
    for (int j = cellOf(middle.y - span); j <= cellOf(middle.y + span); ++j)
        for (int i = cellOf(middle.x - span); i <= cellOf(middle.x + span); ++i)
            s.lists({i, j}, [&](const ForestTile& tile, uint32_t key, const std::vector<TileTree>& list) {
                looked += list.size();
                for (size_t k = 0; k < list.size(); ++k) {
                    const glm::dvec2 foot = s.placeOf({i, j}, list[k]);
                    if (!isNear(foot)) continue;
                    if (const uint32_t h = s.hashOf({i, j}, key, k); s.stands(foot, h))
                        out.push_back(s.tree(tile, list[k], foot, h));
                }
            });
    const auto from = std::lower_bound(places.byHand.begin(), places.byHand.end(), std::pair(here.x - reach, 0u));
    for (auto it = from; it != places.byHand.end() && it->first <= here.x + reach; ++it, ++looked)
        if (const PlacedTree& p = places.rule.placed[it->second]; isNear(p.at))
            out.push_back(handTree(p, places.rule, ground));
    return looked;
}

bool isMesh(const Forest& forest, const StandingTree& tree, double distance) {
    if (tree.byHand) return true;
    return distance <
           static_cast<double>(meshesTo(forest)) * (1 + kStagger * (2 * static_cast<double>(tree.chance) - 1));
}
double meshesEnd(const Forest& forest) { return static_cast<double>(meshesTo(forest)) * (1 + kStagger); }
double volumesBegin(const Forest& forest) { return static_cast<double>(meshesTo(forest)) * (1 - kStagger); }

Result<Mesh> treeMesh(const std::filesystem::path& dir, const TreeSpecies& s) {
    if (s.file.empty())
        return growTree({s.kind, s.height, s.crown, s.leaves, s.leafColor, s.barkColor, static_cast<uint32_t>(s.seed)});
    Result<Mesh> mesh = readMesh(dir, s.file);
    if (!mesh) return mesh;
    const float scale = s.height / std::max(mesh->high.y, 1e-6f);
    for (MeshVertex& v : mesh->vertices) v.position *= scale;
    updateBounds(*mesh);
    return mesh;
}

glm::dmat3 turnOf(const StandingTree& t) {
    glm::dmat3 m = rotationOf({0, static_cast<double>(t.headingDeg), 0}) * static_cast<double>(t.size);
    m[1] *= static_cast<double>(t.upright);
    return m;
}
float heightOf(const StandingTree& t, const TreeSpecies& s) { return s.height * t.size * t.upright; }

std::vector<std::pair<std::string, const Forest*>> forestsOf(const Project& p) {
    std::vector<std::pair<std::string, const Forest*>> out;
    for (const auto& [name, e] : p.entities)
        if (const Forest* f = p.registry.get<Forest>(e); f && grows(*f)) out.emplace_back(name, f);
    return out;
}

bool sameTiles(const Forest& a, const Forest& b) {
    const auto sameSpecies = [](const TreeSpecies& x, const TreeSpecies& y) {
        return x.kind == y.kind && x.file == y.file && x.share == y.share && x.height == y.height &&
               x.crown == y.crown && x.leaves == y.leaves && x.leafColor == y.leafColor && x.barkColor == y.barkColor &&
               x.size == y.size && x.seed == y.seed;
    };
    return std::equal(a.species.begin(), a.species.end(), b.species.begin(), b.species.end(), sameSpecies) &&
           a.perHectare == b.perHectare && a.distance == b.distance && a.tileSize == b.tileSize &&
           a.variety == b.variety && a.seed == b.seed;
}

bool sameForest(const Forest& a, const Forest& b) {
    const auto samePlace = [](const PlacedTree& x, const PlacedTree& y) {
        return x.species == y.species && x.at == y.at && x.size == y.size && x.headingDeg == y.headingDeg;
    };
    return sameTiles(a, b) && a.density.map.sameTiles(b.density.map) && a.densityTiling == b.densityTiling &&
           a.slopeDeg == b.slopeDeg && a.verticalScale == b.verticalScale &&
           std::equal(a.placed.begin(), a.placed.end(), b.placed.begin(), b.placed.end(), samePlace);
}

}  // namespace sward
