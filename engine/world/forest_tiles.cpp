#include "world/forest_tiles.h"

#include <algorithm>
#include <cmath>

#include "core/numerics.h"

namespace sward {
namespace {

constexpr double kSlope = 0.8660254037844386;  // sine of 60 degrees
constexpr int kDarts = 2000;                   // until a tree is given up

struct Dice {
    uint32_t seed, at = 0;
    double unit() { return f32::hash2(seed, at++) * (1.0 / 4294967296.0); }
    double in(double low, double high) { return low + (high - low) * unit(); }
};

glm::dvec2 metres(const glm::dvec2& uv, double edge) { return {edge * (uv.x + 0.5 * uv.y), edge * kSlope * uv.y}; }

// Distances of a place to the three edges of its triangle of cell (0, 0), by family; inside they are positive.
std::array<double, 3> edgeDistances(const glm::dvec2& uv, bool up, double edge) {
    const double height = edge * kSlope;
    return up ? std::array{uv.y * height, uv.x * height, (1 - uv.x - uv.y) * height}
              : std::array{(1 - uv.y) * height, (1 - uv.x) * height, (uv.x + uv.y - 1) * height};
}

// The triangles beside an edge that belongs to cell (0, 0): their cells, and whether they point up.
struct Beside {
    glm::ivec2 cell;
    bool up;
};
std::array<Beside, 2> besideOf(EdgeFamily f) {
    if (f == EdgeFamily::Row) return {{{{0, 0}, true}, {{0, -1}, false}}};
    if (f == EdgeFamily::Slant) return {{{{0, 0}, true}, {{-1, 0}, false}}};
    return {{{{0, 0}, true}, {{0, 0}, false}}};
}
// The edges of a triangle of cell (0, 0), as the cells that they belong to.
glm::ivec2 ownerOf(bool up, EdgeFamily f) {
    if (up || f == EdgeFamily::Across) return {0, 0};
    return f == EdgeFamily::Row ? glm::ivec2(0, 1) : glm::ivec2(1, 0);
}
constexpr EdgeFamily kFamilies[] = {EdgeFamily::Row, EdgeFamily::Slant, EdgeFamily::Across};

int colorOf(int cell, bool up, EdgeFamily f, int colors) {
    return storedTile(cell, up, colors).colors[static_cast<size_t>(f)];
}

struct Placer {
    const Forest& forest;
    ForestTiles tiles{};
    Dice dice;
    double apart;
    int missing = 0;  // trees of all tiles together

    bool free(const std::vector<TileTree>& among, const glm::dvec2& at, const glm::dvec2& shift) const {
        return std::all_of(among.begin(), among.end(),
                           [&](const TileTree& t) { return glm::length(t.at + shift - at) >= apart; });
    }
    glm::dvec2 offset(const glm::ivec2& cell) const { return metres(glm::dvec2(cell), tiles.edge); }

    // Whether a tree across an edge of a colour keeps its distance from all that may stand in the triangles beside it.
    bool freeOnEdge(EdgeFamily f, int color, const glm::dvec2& at) const {
        if (!free(tiles.across(f, color), at, {})) return false;
        for (const Beside& b : besideOf(f)) {
            for (const EdgeFamily other : kFamilies) {
                if (other == f) continue;
                const glm::dvec2 shift = offset(b.cell + ownerOf(b.up, other));
                for (int c = 0; c < tiles.colors; ++c)
                    if (!free(tiles.across(other, c), at, shift)) return false;
            }
            for (int cell = 0; cell < tiles.cells(); ++cell)
                if (colorOf(cell, b.up, f, tiles.colors) == color &&
                    !free(tiles.within(cell, b.up), at, offset(b.cell)))
                    return false;
        }
        return true;
    }
    bool freeInside(int cell, bool up, const glm::dvec2& at) const {
        if (!free(tiles.within(cell, up), at, {})) return false;
        return std::all_of(std::begin(kFamilies), std::end(kFamilies), [&](EdgeFamily f) {
            return free(tiles.across(f, colorOf(cell, up, f, tiles.colors)), at, offset(ownerOf(up, f)));
        });
    }
    TileTree tree(const glm::dvec2& at) {
        TileTree t{at, 0, 1, static_cast<float>(dice.in(-180, 180))};
        double all = 0, left;
        for (const TreeSpecies& s : forest.species) all += stands(s) ? static_cast<double>(s.share) : 0;
        left = dice.unit() * all;
        for (uint32_t i = 0; i < forest.species.size(); ++i) {
            if (!stands(forest.species[i])) continue;
            t.species = i;
            left -= static_cast<double>(forest.species[i].share);
            if (left < 0) break;
        }
        const TreeSpecies& s = forest.species[t.species];
        t.size = static_cast<float>(dice.in(s.size.x, s.size.y));
        tiles.highest = std::max(tiles.highest, t.size * s.height);
        return t;
    }
    // Edges that a circle around the place crosses; `which`: the last of them.
    int crossed(const glm::dvec2& uv, bool up, EdgeFamily& which) const {
        const std::array<double, 3> d = edgeDistances(uv, up, tiles.edge);
        int count = 0;
        for (size_t i = 0; i < 3; ++i)
            if (d[i] < tiles.circle) ++count, which = kFamilies[i];
        return count;
    }
    // One more tree across an edge, or within a tile; none where it finds no room.
    bool addAcross(EdgeFamily f, int color) {
        std::vector<TileTree>& out = tiles.onEdge[static_cast<size_t>(f)][static_cast<size_t>(color)];
        if (out.size() == kMostOnEdge) return false;
        for (int k = 0; k < kDarts; ++k) {
            const Beside b = besideOf(f)[dice.unit() < 0.5 ? 0 : 1];
            const glm::dvec2 uv = inTriangle(b.up);
            EdgeFamily met{};
            if (crossed(uv, b.up, met) != 1 || met != f) continue;
            const glm::dvec2 at = metres(uv + glm::dvec2(b.cell), tiles.edge);
            if (freeOnEdge(f, color, at)) return out.push_back(tree(at)), true;
        }
        return false;
    }
    void addWithin(int cell, bool up) {
        std::vector<TileTree>& out = tiles.inside[static_cast<size_t>(cell)][up ? 1 : 0];
        if (out.size() == kMostInside) return;
        for (int k = 0; k < kDarts; ++k) {
            const glm::dvec2 uv = inTriangle(up), at = metres(uv, tiles.edge);
            EdgeFamily met{};
            if (crossed(uv, up, met) == 0 && freeInside(cell, up, at)) return out.push_back(tree(at));
        }
    }
    int edges() const { return 3 * tiles.colors; }
    // The edges, then the tiles.
    void add(int place) {
        if (place >= edges()) return addWithin((place - edges()) / 2, (place - edges()) % 2 != 0);
        // What finds no room across an edge, since trees of all colours of the two others may stand there, stands
        // within tiles instead.
        if (!addAcross(kFamilies[place % 3], place / 3)) missing += tiles.colors;
    }
    void addMissing() {
        for (; missing > 0; --missing) addWithin(static_cast<int>(dice.unit() * tiles.cells()), dice.unit() < 0.5);
    }
    glm::dvec2 inTriangle(bool up) {
        glm::dvec2 uv(dice.unit(), dice.unit());
        if ((uv.x + uv.y > 1) == up) uv = 1.0 - uv;
        return uv;
    }
    // Shares of a tile's area whose circles cross no edge, and one.
    glm::dvec2 areas() {
        constexpr int kSide = 256;
        glm::dvec2 share(0);
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide - y; ++x) {
                EdgeFamily met{};
                const int n = crossed((glm::dvec2(x, y) + 1.0 / 3) / double(kSide), true, met);
                if (n < 2) share[n] += 1;
            }
        return share / (0.5 * kSide * (kSide + 1));
    }
};

double circleOf(const Forest& f) {
    double widest = static_cast<double>(f.distance) / 2;
    for (const TreeSpecies& s : f.species)
        if (stands(s) && s.file.empty())
            widest = std::max(widest, static_cast<double>(s.crown * s.height) * s.size.y / 2);
    return std::min(widest, 0.2 * static_cast<double>(f.tileSize));  // what a triangle has room for
}

}  // namespace

ForestTiles forestTiles(const Forest& forest) {
    Placer p{
        forest, {}, {f32::hash2(static_cast<uint32_t>(forest.seed), 0xF0E57u)}, static_cast<double>(forest.distance)};
    p.tiles.edge = static_cast<double>(forest.tileSize);
    p.tiles.circle = circleOf(forest);
    p.tiles.colors = forest.variety == TileVariety::Eight ? 2 : 4;
    for (auto& family : p.tiles.onEdge) family.resize(static_cast<size_t>(p.tiles.colors));
    p.tiles.inside.resize(static_cast<size_t>(p.tiles.cells()));
    if (!grows(forest)) return p.tiles;
    const double area = p.tiles.edge * p.tiles.edge * kSlope / 2;              // of a tile
    const double trees = static_cast<double>(forest.perHectare) / 1e4 * area;  // in a tile; half of each edge's counts
    const glm::dvec2 share = p.areas();
    const double inside = trees * share.x / (share.x + share.y), onEdge = (trees - inside) * 2 / 3;
    // One tree after the other in random order, so that neither edges nor tiles find the ground taken; what is owed
    // goes on to the next.
    std::vector<int> order;
    double owedEdge = p.dice.unit(), owedInside = p.dice.unit();
    for (int place = 0; place < p.edges() + 2 * p.tiles.cells(); ++place) {
        double& owed = place < p.edges() ? owedEdge : owedInside;
        owed += place < p.edges() ? onEdge : inside;
        order.insert(order.end(), static_cast<size_t>(owed), place);
        owed -= std::floor(owed);
    }
    for (size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1], order[std::min(static_cast<size_t>(p.dice.unit() * static_cast<double>(i)), i - 1)]);
    for (const int place : order) p.add(place);
    p.addMissing();
    p.tiles.asked = 2 * p.tiles.cells() * trees;
    for (const auto& family : p.tiles.onEdge)
        for (const auto& color : family) p.tiles.placed += p.tiles.colors * static_cast<double>(color.size());
    for (const auto& cell : p.tiles.inside)
        for (const auto& tile : cell) p.tiles.placed += static_cast<double>(tile.size());
    return p.tiles;
}

ForestTile tileAt(int i, int j, bool up, uint32_t seed, int colors) {
    const f32::EdgeColors c = f32::edgeColors(i, j, up, seed, colors);
    const f32::vec2 cell = f32::tileCell(c);
    return {static_cast<int>(cell.x) + colors * static_cast<int>(cell.y), up, {c.row, c.slant, c.across}};
}

ForestTile storedTile(int cell, bool up, int colors) {
    const int x = cell % colors, y = cell / colors;
    return {cell, up, {x ^ (y & 1) ^ (up ? 0 : 1), y, x ^ (y & ~1)}};
}

glm::ivec2 edgeOwner(int i, int j, bool up, EdgeFamily family) { return glm::ivec2(i, j) + ownerOf(up, family); }

}  // namespace sward
