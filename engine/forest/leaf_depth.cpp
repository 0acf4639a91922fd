#include "forest/leaf_depth.h"

#include <numeric>

#include "core/numerics.h"

namespace sward {
namespace {

constexpr int kDirections = 6;
constexpr double kReach = 2;                  // parts
constexpr float kDeepest = 3, kHighest = -1;  // optical depths that are told

size_t wrapped(double share, int side) {
    const int i = static_cast<int>(std::floor(share * side)) % side;
    return static_cast<size_t>(i < 0 ? i + side : i);
}
double partHeight(const ForestAir& a) { return a.height / a.layers; }
double partAcross(const ForestAir& a) { return a.cells * a.edge / a.side; }
glm::dvec2 middleOf(const ForestAir& a, int x, int y) { return (glm::dvec2(x, y) + 0.5) * (1.0 * a.cells / a.side); }

// A way through the air: rise, lattice coordinates a metre, and the factor of what is seen of leaves.
struct Way {
    double rise, seen;
    f64::vec2 perMetre;
    Way(const glm::dvec3& way, const ForestAir& air)
        : rise(way.y),
          seen(static_cast<double>(seenFrom(air.facing, static_cast<float>(way.y)))),
          perMetre(f64::toLattice({way.x, way.z}, air.edge)) {}
};
glm::dvec3 directionAbove(int k) {
    const double y = (k + 0.5) / kDirections, turn = k * 2.399963229728653, r = std::sqrt(1 - y * y);
    return {r * std::cos(turn), y, r * std::sin(turn)};
}
std::vector<Way> waysAbove(const ForestAir& air) {
    std::vector<Way> out;
    for (int k = 0; k < kDirections; ++k) out.emplace_back(directionAbove(k), air);
    return out;
}

double depthOn(const Way& way, const ForestAir& air, const glm::dvec2& uv, double height, double reach) {
    const double step = 0.5 * std::min(partHeight(air), partAcross(air));
    const size_t side = static_cast<size_t>(air.side);
    double depth = 0;
    for (double t = 0.5 * step; t < reach && depth < kMostLeafDepth; t += step) {
        const int layer = static_cast<int>(std::floor((height + way.rise * t) / partHeight(air)));
        if (layer < 0 || layer >= air.layers) break;
        const size_t column = wrapped((uv.y + way.perMetre.y * t) / air.cells, air.side) * side +
                              wrapped((uv.x + way.perMetre.x * t) / air.cells, air.side);
        depth +=
            way.seen * step * static_cast<double>(air.extinction[static_cast<size_t>(layer) * side * side + column]);
    }
    return std::min(depth, kMostLeafDepth);
}

// Share of the light from these ways that comes through the air around a place.
double lightAround(const std::vector<Way>& ways, const ForestAir& air, const glm::dvec2& uv, double height,
                   double reach) {
    double sum = 0;
    for (const Way& way : ways) sum += std::exp(-depthOn(way, air, uv, height, reach));
    return sum / static_cast<double>(ways.size());
}

// A part's leaves (as extinctions of its texels added up), how much deeper they lie, and the logarithm of how much more
// of those that are seen from a side are lit from there.
struct Depth {
    double leaves = 0, deeper = 0, litSeen = 0;
};
// Sums over the leaves of a part.
struct DepthSums {
    double leaves = 0;
    std::array<double, kDirections> light{}, squares{};
    void add(const std::vector<Way>& ways, const ForestAir& fine, const glm::dvec2& uv, double height, double reach,
             double amount) {
        leaves += amount;
        for (size_t k = 0; k < ways.size(); ++k) {
            const double left = std::exp(-depthOn(ways[k], fine, uv, height, reach));
            light[k] += amount * left, squares[k] += amount * left * left;
        }
    }
    double lightOfAll() const { return std::accumulate(light.begin(), light.end(), 0.0) / kDirections; }
    double litSeen() const {
        double sum = 0;
        for (size_t k = 0; k < kDirections; ++k) sum += std::log(squares[k] * leaves / (light[k] * light[k]));
        return sum / kDirections;
    }
};
Depth depthOf(const std::vector<Way>& ways, const ForestAir& fine, const ForestAir& air, int x, int y, int layer) {
    const int across = fine.side / air.side, up = fine.layers / air.layers;
    const size_t side = static_cast<size_t>(fine.side);
    const double reach = kReach * std::max(partHeight(air), partAcross(air));
    DepthSums sums;
    for (int l = layer * up; l < (layer + 1) * up; ++l)
        for (int k = y * across; k < (y + 1) * across; ++k)
            for (int i = x * across; i < (x + 1) * across; ++i) {
                const float leaves = fine.extinction[(static_cast<size_t>(l) * side + static_cast<size_t>(k)) * side +
                                                     static_cast<size_t>(i)];
                if (leaves > 0)
                    sums.add(ways, fine, middleOf(fine, i, k), (l + 0.5) * partHeight(fine), reach,
                             static_cast<double>(leaves));
            }
    if (!(sums.leaves > 0)) return {};
    const double middle = lightAround(ways, air, middleOf(air, x, y), (layer + 0.5) * partHeight(air), reach);
    return {sums.leaves, std::log(middle * sums.leaves / sums.lightOfAll()), sums.litSeen()};
}

// Optical depth through a tree's air from a place in it, of leaves in all directions.
double treeDepth(const TreeAir& air, const glm::dvec3& from, const glm::dvec3& way) {
    const double half = 0.5 * air.side * air.part, step = 0.5 * air.part;
    const size_t side = static_cast<size_t>(air.side);
    double depth = 0;
    for (double t = 0.5 * step; depth < kMostLeafDepth; t += step) {
        const glm::dvec3 at = (from + way * t + glm::dvec3(half, 0, half)) / air.part;
        if (!(at.x >= 0 && at.z >= 0 && at.x < air.side && at.z < air.side && at.y < air.layers)) break;
        const size_t layer = static_cast<size_t>(std::max(at.y, 0.0));
        depth +=
            step * static_cast<double>(
                       air.extinction[(layer * side + static_cast<size_t>(at.z)) * side + static_cast<size_t>(at.x)]);
    }
    return depth;
}

// Of the parts around one that has no leaves.
float aroundOf(const std::vector<Depth>& all, const ForestAir& a, int x, int y, int layer) {
    double leaves = 0, sum = 0;
    for (int l = std::max(layer - 1, 0); l <= std::min(layer + 1, a.layers - 1); ++l)
        for (int k = y - 1; k <= y + 1; ++k)
            for (int i = x - 1; i <= x + 1; ++i) {
                const size_t side = static_cast<size_t>(a.side), row = static_cast<size_t>((k + a.side) % a.side),
                             column = static_cast<size_t>((i + a.side) % a.side);
                const Depth& d = all[(static_cast<size_t>(l) * side + row) * side + column];
                leaves += d.leaves, sum += d.leaves * d.deeper;
            }
    return leaves > 0 ? static_cast<float>(sum / leaves) : 0;
}

}  // namespace

double depthAlong(const ForestAir& air, const glm::dvec2& uv, double height, const glm::dvec3& way, double reach) {
    return depthOn(Way(way, air), air, uv, height, reach);
}

LeafDepths leafDepths(const ForestAir& fine, const ForestAir& air) {
    const std::vector<Way> ways = waysAbove(air);
    std::vector<Depth> all(air.extinction.size());
    const size_t slab = static_cast<size_t>(air.side) * static_cast<size_t>(air.side);
    const auto each = [&](auto body) {
        parallelFor(static_cast<size_t>(air.layers), [&](size_t layer) {
            size_t i = layer * slab;
            for (int y = 0; y < air.side; ++y)
                for (int x = 0; x < air.side; ++x, ++i) body(i, x, y, static_cast<int>(layer));
        });
    };
    each([&](size_t i, int x, int y, int layer) { all[i] = depthOf(ways, fine, air, x, y, layer); });
    LeafDepths out{std::vector<float>(all.size()), 0};
    each([&](size_t i, int x, int y, int layer) {
        const float depth = all[i].leaves > 0 ? static_cast<float>(all[i].deeper) : aroundOf(all, air, x, y, layer);
        out.deeper[i] = std::clamp(depth, kHighest, kDeepest);
    });
    double seen = 0, sum = 0;
    for (size_t i = 0; i < all.size(); ++i) {
        const double visible = all[i].leaves * std::exp(-all[i].deeper);
        seen += visible, sum += visible * all[i].litSeen;
    }
    if (seen > 0) out.litSeen = static_cast<float>(sum / seen);
    return out;
}

float litFacing(const Mesh& mesh, const TreeAir& air) {
    if (air.side == 0) return 1;
    const std::vector<float> shares = leafShares(mesh);
    double lit = 0, facingLit = 0, all = 0, facing = 0;
    for (int k = 0; k < kDirections; ++k) {
        const glm::dvec3 way = directionAbove(k);
        const double seen = static_cast<double>(seenFrom(air.facing, static_cast<float>(way.y)));
        for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const auto at = [&](size_t n) { return glm::dvec3(mesh.vertices[mesh.indices[i + n]].position); };
            const glm::dvec3 across = glm::cross(at(1) - at(0), at(2) - at(0));
            const double area = glm::length(across) * static_cast<double>(shares[i / 3]);
            if (!(area > 0)) continue;
            const double towards = std::abs(glm::dot(across, way)) * static_cast<double>(shares[i / 3]),
                         light = std::exp(-seen * treeDepth(air, (at(0) + at(1) + at(2)) / 3.0, way));
            all += area, facing += towards, lit += area * light, facingLit += towards * light;
        }
    }
    return lit > 0 && facing > 0 ? static_cast<float>(facingLit / lit * all / facing) : 1;
}

}  // namespace sward
