#include "forest/tree_light.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/jobs.h"
#include "forest/stretch.h"

namespace sward {
namespace {

// Ways over all directions, the same at all vertices of a mesh: the most, and fewer of many vertices.
constexpr size_t kMostWays = 96, kFewestWays = 8, kWaysInAll = 8'000'000;
constexpr double kOpaqueDepth = 7;  // hides all
constexpr float kLeafPart = 0.25f;  // share of a part's area that is leaves, from which on it is air
constexpr double kAround = 1.5;     // heights of the tallest tree, as far as others count
constexpr double kNearest = 0.5;    // metres, to which trees are taken to keep away

struct LeafyWay {
    glm::dvec3 stands, baked;  // unit: as the tree stands, and through what is baked
    double seen;               // how much of leaves is seen along it, against leaves in all directions
};
std::vector<LeafyWay> waysThrough(const TreeAir& air, double verticalScale, size_t count) {
    std::vector<LeafyWay> out;
    for (size_t k = 0; k < count; ++k) {
        const double i = static_cast<double>(k), y = 1 - (2 * i + 1) / static_cast<double>(count);
        const double turn = i * 2.399963229728653, r = std::sqrt(1 - y * y);
        const glm::dvec3 way(r * std::cos(turn), y, r * std::sin(turn)), baked = bakedWay(way, verticalScale);
        out.push_back({way, baked, static_cast<double>(seenFrom(air.facing, static_cast<float>(baked.y)))});
    }
    return out;
}

// Optical depth through a tree's own air; `out`: where the way leaves that air or meets the ground.
double ownDepth(const TreeAir& air, const glm::dvec3& from, const LeafyWay& way, glm::dvec3& out) {
    const double half = 0.5 * air.side * air.part;
    const auto side = static_cast<size_t>(air.side);
    double depth = 0;
    out = from;
    for (double t = 0.5 * air.part; depth < kOpaqueDepth; t += air.part) {
        const glm::dvec3 at = from + t * way.baked;
        if (at.y < 0 || at.y >= air.height || std::abs(at.x) >= half || std::abs(at.z) >= half) break;
        out = at;
        const size_t layer = static_cast<size_t>(std::min(at.y / air.part, air.layers - 1.0));
        depth +=
            way.seen * air.part *
            static_cast<double>(air.extinction[(layer * side + static_cast<size_t>((at.z + half) / air.part)) * side +
                                               static_cast<size_t>((at.x + half) / air.part)]);
    }
    return depth;
}

struct LeftAlong {
    double alone, among;
};
LeftAlong leftAlong(const TreeAir& air, const TreeShade& shade, const WoodAir& wood, const glm::dvec3& from,
                    const LeafyWay& way) {
    glm::dvec3 at;
    const double own = ownDepth(air, from, way, at), rise = std::abs(way.baked.y);
    const bool up = way.baked.y >= 0;
    const double others = (up ? wood.between(at.y, 1e9) : wood.between(0, at.y)) / std::max(rise, 1e-3);
    const glm::dvec3 ground = at - way.baked * (at.y / way.baked.y);
    const double shaded = up ? 0 : static_cast<double>(shade.at({ground.x, ground.z}));
    return {std::exp(-own - shaded), std::exp(-own - others)};
}

uint8_t byteOf(double sum, double of) {
    return static_cast<uint8_t>(std::lround(255 * (of > 0 ? std::clamp(sum / of, 0.0, 1.0) : 1)));
}

double treesPerM2(const ForestTiles& tiles, double perHectare) {
    return tiles.asked > 0 ? perHectare / 10000 * tiles.placed / tiles.asked : 0;
}

// m² of leaves that are seen in the mean of all directions, in each layer of a tree's air.
std::vector<double> leavesOfLayers(const TreeAir& air) {
    std::vector<double> out(static_cast<size_t>(air.layers));
    const ptrdiff_t count = static_cast<ptrdiff_t>(air.side) * air.side;
    auto from = air.extinction.begin();
    for (double& area : out)
        area = std::accumulate(from, from + count, 0.0) * air.part * air.part * air.part, from += count;
    return out;
}

// Trees by squares of the ground.
struct TreeSquares {
    double side;
    std::map<std::pair<int, int>, std::vector<const StandingTree*>> squares;
    TreeSquares(const std::vector<StandingTree>& trees, double s) : side(s) {
        for (const StandingTree& t : trees) squares[of(t)].push_back(&t);
    }
    std::pair<int, int> of(const StandingTree& t) const {
        return {static_cast<int>(std::floor(t.at.x / side)), static_cast<int>(std::floor(t.at.z / side))};
    }
    // Calls body(tree) for all within `side` of this one, and for some beyond.
    template <class F>
    void eachNear(const StandingTree& tree, F body) const {
        const auto [x, z] = of(tree);
        for (int k = z - 1; k <= z + 1; ++k)
            for (int i = x - 1; i <= x + 1; ++i)
                if (const auto s = squares.find({i, k}); s != squares.end())
                    for (const StandingTree* t : s->second) body(*t);
    }
};

}  // namespace

std::vector<glm::vec3> woodAround(const StandingForest& forest, double perHectare) {
    std::vector<glm::vec3> out(forest.trees.size(), glm::vec3(0));
    const double reach = kAround * static_cast<double>(forest.tiles.highest),
                 full = treesPerM2(forest.tiles, perHectare) * 2 * M_PI * reach;
    if (!(full > 0)) return out;
    const TreeSquares squares(forest.trees, reach);
    parallelFor(out.size(), [&](size_t i) {
        const StandingTree& tree = forest.trees[i];
        glm::dvec3 sum(0);
        squares.eachNear(tree, [&](const StandingTree& other) {
            const glm::dvec2 way = glm::dvec2(other.at.x, other.at.z) - glm::dvec2(tree.at.x, tree.at.z);
            const double distance = std::max(glm::length(way), kNearest);
            // Where all of one side is full, the mean of its cosines is 2 / pi.
            if (&other != &tree && distance < reach) sum += glm::dvec3(1, 0.5 * M_PI * way / distance) / distance;
        });
        out[i] = glm::vec3(sum / full);
    });
    return out;
}

double WoodAir::between(double low, double high) const {
    if (below.empty()) return 0;
    const auto upTo = [&](double height) {
        const double at = std::clamp(height / layer, 0.0, static_cast<double>(below.size() - 1));
        const auto i = static_cast<size_t>(at), next = std::min(i + 1, below.size() - 1);
        return below[i] + (at - static_cast<double>(i)) * (below[next] - below[i]);
    };
    return std::max(upTo(high) - upTo(low), 0.0);
}

WoodAir woodAir(const ForestTiles& tiles, double perHectare, std::span<const TreeAir> airs) {
    WoodAir out;
    std::vector<double> leaves(static_cast<size_t>(std::ceil(static_cast<double>(tiles.highest) / out.layer)) + 1);
    std::vector<std::vector<double>> ofSpecies;
    for (const TreeAir& air : airs) ofSpecies.push_back(leavesOfLayers(air));
    double trees = 0;
    const auto add = [&](const std::vector<TileTree>& list) {
        for (const TileTree& t : list) {
            const std::vector<double>& own = ofSpecies[t.species];
            const double size = static_cast<double>(t.size), part = airs[t.species].part * size;
            trees += 1;
            for (size_t l = 0; l < own.size(); ++l) {
                const auto at = static_cast<size_t>((static_cast<double>(l) + 0.5) * part / out.layer);
                leaves[std::min(at, leaves.size() - 1)] += own[l] * size * size;
            }
        }
    };
    for (const auto& family : tiles.onEdge)
        for (const auto& color : family) add(color);
    for (const auto& cell : tiles.inside)
        for (const auto& tile : cell) add(tile);
    const double all = std::accumulate(leaves.begin(), leaves.end(), 0.0);
    if (!(all > 0)) return out;
    const double perM2 = treesPerM2(tiles, perHectare) / trees;
    out.below.push_back(0);
    for (const double area : leaves) out.below.push_back(out.below.back() + area * perM2);
    return out;
}

TreeAir leafAir(const Mesh& mesh) {
    const std::vector<float> leaves = leafParts(mesh);
    Mesh flat = mesh;
    flat.parts.clear();
    for (size_t i = 0; i < mesh.parts.size(); ++i)
        if (leaves[i] > kLeafPart) flat.parts.push_back(mesh.parts[i]);
    return treeAir(flat);
}

std::vector<VertexShares> lightOnTree(const Mesh& mesh, const TreeAir& air, const WoodAir& wood, double verticalScale) {
    std::vector<VertexShares> out(mesh.vertices.size());
    if (air.side == 0) return out;
    const std::vector<LeafyWay> ways = waysThrough(
        air, verticalScale, std::clamp(kWaysInAll / std::max(out.size(), size_t{1}), kFewestWays, kMostWays));
    const TreeShade shade = shadeOfSky(air, verticalScale);
    parallelFor(out.size(), [&](size_t i) {
        const MeshVertex& v = mesh.vertices[i];
        const glm::dvec3 from(v.position), n = glm::normalize(glm::dvec3(v.normal) / glm::dvec3(1, verticalScale, 1));
        glm::dvec4 all(0), alone(0), among(0);
        glm::dvec3 open(0);
        for (const LeafyWay& w : ways) {
            const double facing = glm::dot(n, w.stands);
            const int side = (facing > 0 ? 0 : 2) + (w.stands.y > 0 ? 0 : 1);
            const LeftAlong r = leftAlong(air, shade, wood, from, w);
            all[side] += std::abs(facing), alone[side] += std::abs(facing) * r.alone;
            among[side] += std::abs(facing) * r.among;
            // The best fit: over half a sphere x and z have a mean square of a third.
            if (w.stands.y > 0)
                open +=
                    r.alone * glm::dvec3(1, 3 * w.stands.x, 3 * w.stands.z) / (0.5 * static_cast<double>(ways.size()));
        }
        for (int k = 0; k < 3; ++k)
            out[i].open[k] = static_cast<int8_t>(std::lround(127 * std::clamp(open[k], -1.0, 1.0)));
        for (int k = 0; k < 4; ++k)
            out[i].alone[k] = byteOf(alone[k], all[k]), out[i].among[k] = byteOf(among[k], all[k]);
    });
    return out;
}

}  // namespace sward
