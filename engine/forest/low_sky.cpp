#include "forest/low_sky.h"

#include <algorithm>
#include <cmath>

#include "core/jobs.h"
#include "world/ground.h"

namespace sward {
namespace {

constexpr double kColumnWidth = 4;     // metres at least: trees stand nearer to each other
constexpr int kMostColumns = 96;       // cells
constexpr int kAirLayers = 24;         // up to the top of the tallest tree
constexpr int kSkyTurns = 12;          // directions around
constexpr int kSkyRises = 16;          // of each, from the horizon to the zenith, each of as much of the sky
constexpr float kSidewaysSine = 0.2f;  // rise of the ways on which leaves are met (sine)
constexpr double kMostSkyDepth = 8;

// Columns of leaves: extinction (1/m) by layer, then cell.
struct LeafColumns {
    glm::ivec2 size{0};
    glm::dvec2 cell{0};
    double layer = 1, top = 0, reach = 0;  // m: of a layer; of all over the sea; how far a tree's own shade goes, mean
    std::vector<float> air, ground;

    size_t at(int x, int z) const { return static_cast<size_t>(z * size.x + x); }
    size_t cells() const { return static_cast<size_t>(size.x) * static_cast<size_t>(size.y); }
};

// m² of leaves that are seen from the side, in each layer of a species' own air.
std::vector<double> leavesOf(const TreeAir& air) {
    const size_t perLayer = static_cast<size_t>(air.side) * static_cast<size_t>(air.side);
    const double seen = static_cast<double>(seenFrom(air.facing, kSidewaysSine)) * air.part * air.part * air.part;
    std::vector<double> out(static_cast<size_t>(air.layers));
    for (size_t l = 0; l < out.size(); ++l)
        for (size_t i = 0; i < perLayer; ++i) out[l] += seen * static_cast<double>(air.extinction[l * perLayer + i]);
    return out;
}

double tallestOf(std::span<const AiryForest> forests) {
    double tallest = 0;
    for (const AiryForest& f : forests)
        for (const StandingTree& t : f.forest->trees)
            tallest = std::max(tallest, (*f.airs)[t.species].height * static_cast<double>(t.size) * f.verticalScale);
    return tallest;
}

void addTrees(LeafColumns& c, const AiryForest& f, const glm::dvec3& origin) {
    std::vector<std::vector<double>> leaves;
    for (const TreeAir& a : *f.airs) leaves.push_back(leavesOf(a));
    const double volume = c.cell.x * c.cell.y * c.layer;
    for (const StandingTree& t : f.forest->trees) {
        const glm::dvec2 foot = (glm::dvec2(t.at.x, t.at.z) - glm::dvec2(origin.x, origin.z)) / c.cell;
        if (!(foot.x >= 0 && foot.y >= 0 && foot.x < c.size.x && foot.y < c.size.y)) continue;
        const size_t cell = c.at(static_cast<int>(foot.x), static_cast<int>(foot.y));
        const double size = static_cast<double>(t.size), up = size * f.verticalScale;
        const std::vector<double>& own = leaves[t.species];
        for (size_t l = 0; l < own.size(); ++l) {
            const double height = (static_cast<double>(l) + 0.5) * (*f.airs)[t.species].part * up;
            const size_t layer = static_cast<size_t>(std::min(height / c.layer, kAirLayers - 1.0));
            c.air[layer * c.cells() + cell] += static_cast<float>(own[l] * size * up / volume);
        }
    }
}

// As far as shadeOfSky looks, in the mean of all trees.
double reachOf(std::span<const AiryForest> forests) {
    double sum = 0, count = 0;
    for (const AiryForest& f : forests)
        for (const StandingTree& t : f.forest->trees) {
            const TreeAir& a = (*f.airs)[t.species];
            sum += (0.5 * a.side * a.part + a.height * f.verticalScale) * static_cast<double>(t.size), count += 1;
        }
    return count > 0 ? sum / count : 0;
}

LeafColumns leafColumnsOf(const Terrain& terrain, const glm::dvec3& origin, std::span<const AiryForest> forests) {
    LeafColumns c;
    const auto cellsOf = [](double metres) {
        return std::clamp(static_cast<int>(std::ceil(metres / kColumnWidth)), 1, kMostColumns);
    };
    c.size = {cellsOf(terrain.size.x), cellsOf(terrain.size.y)};
    c.cell = terrain.size / glm::dvec2(c.size);
    const double tallest = tallestOf(forests);
    c.layer = std::max(tallest, 1e-3) / kAirLayers, c.reach = reachOf(forests);
    c.air.assign(c.cells() * kAirLayers, 0), c.ground.resize(c.cells());
    for (int z = 0; z < c.size.y; ++z)
        for (int x = 0; x < c.size.x; ++x)
            c.ground[c.at(x, z)] =
                static_cast<float>(terrainHeight(terrain, (x + 0.5) * c.cell.x, (z + 0.5) * c.cell.y));
    c.top = tallest + static_cast<double>(*std::max_element(c.ground.begin(), c.ground.end()));
    for (const AiryForest& f : forests) addTrees(c, f, origin);
    return c;
}

// Optical depths of what is nearer than trees' own shade goes, and of what is farther.
struct NearAndFar {
    double near = 0, far = 0;
};
NearAndFar depthAlong(const LeafColumns& c, int x, int z, const glm::dvec2& turn, double sine) {
    NearAndFar out;
    const double cosine = std::sqrt(1 - sine * sine), step = std::min(c.cell.x, c.cell.y), rise = sine / cosine,
                 ground = static_cast<double>(c.ground[c.at(x, z)]);
    for (double r = 0.5 * step;; r += step) {
        const glm::dvec2 at = (glm::dvec2(x, z) + 0.5) + turn * r / c.cell;
        const double height = ground + r * rise;
        if (!(at.x >= 0 && at.y >= 0 && at.x < c.size.x && at.y < c.size.y) || height > c.top) return out;
        const size_t cell = c.at(static_cast<int>(at.x), static_cast<int>(at.y));
        const double above = height - static_cast<double>(c.ground[cell]);
        if (above < 0 || out.far > kMostSkyDepth || out.near > kMostSkyDepth) return out;
        const size_t layer = static_cast<size_t>(above / c.layer);
        if (layer < kAirLayers)
            (r < c.reach ? out.near : out.far) += static_cast<double>(c.air[layer * c.cells() + cell]) * step / cosine;
    }
}

// Shares that far trees leave of the light that near ones leave, on level ground and on what stands upright.
glm::vec2 leftAt(const LeafColumns& c, int x, int z) {
    glm::dvec2 with(0), without(0);
    for (int k = 0; k < kSkyTurns; ++k) {
        const double angle = (k + 0.5) * 2 * M_PI / kSkyTurns;
        for (int j = 0; j < kSkyRises; ++j) {
            const NearAndFar depth = depthAlong(c, x, z, {std::cos(angle), std::sin(angle)}, (j + 0.5) / kSkyRises);
            // Level ground takes light by its sine, leaves that hang in all directions take all alike.
            const glm::dvec2 light((2 * j + 1.0) / kSkyRises, 1);
            without += light * std::exp(-depth.near), with += light * std::exp(-depth.near - depth.far);
        }
    }
    return with / glm::max(without, 1e-12);  // among trees without a gap neither has any
}

}  // namespace

LowSky lowSkyOf(const Terrain& terrain, const glm::dvec3& origin, std::span<const AiryForest> forests) {
    const LeafColumns c = leafColumnsOf(terrain, origin, forests);
    LowSky out{c.size, std::vector<glm::vec2>(c.cells())};
    parallelFor(static_cast<size_t>(c.size.y), [&](size_t z) {
        for (int x = 0; x < c.size.x; ++x) out.left[c.at(x, static_cast<int>(z))] = leftAt(c, x, static_cast<int>(z));
    });
    return out;
}

}  // namespace sward
