#include "forest/shade_map.h"

#include <algorithm>
#include <cmath>

#include "core/jobs.h"
#include "core/numerics.h"
#include "forest/stretch.h"
#include "forest/volume_bake.h"
#include "world/ground.h"

namespace sward {
namespace {

constexpr double kPart = 0.25;          // metres of a tree's air: of a leaf's width, so that clumps are told from gaps
constexpr double kMostParts = 256;      // along a tree: those of an enormous one are larger
constexpr int kSkyCoarser = 2;          // the sky's shade is smooth
constexpr double kLeastTexel = 0.5;     // metres of the map
constexpr double kLowestSine = 0.1045;  // of 6 degrees
constexpr float kMostDepth = 8;
constexpr int kSkyDirections = 24;
constexpr double kMostSkyTexels = 128;  // along an image of the sky's shade: those of an enormous tree are larger

glm::dvec3 raised(const glm::dvec3& light) {
    if (light.y >= kLowestSine) return light;
    const double across = std::hypot(light.x, light.z), keep = std::sqrt(1 - kLowestSine * kLowestSine);
    return across > 1e-9 ? glm::dvec3(light.x / across * keep, kLowestSine, light.z / across * keep)
                         : glm::dvec3(0, 1, 0);
}

// Optical depth from a place on level ground through a tree's air, in steps (m).
double depthFrom(const TreeAir& air, const glm::dvec2& at, const glm::dvec3& way, double step) {
    const double half = 0.5 * air.side * air.part, end = air.height / way.y;
    double depth = 0;
    for (double t = 0.5 * step; t < end; t += step) {
        const double x = (at.x + way.x * t + half) / air.part, z = (at.y + way.z * t + half) / air.part;
        if (x < 0 || z < 0 || x >= air.side || z >= air.side) continue;
        const size_t layer = static_cast<size_t>(std::min(way.y * t / air.part, air.layers - 1.0)),
                     side = static_cast<size_t>(air.side);
        depth += step * static_cast<double>(
                            air.extinction[(layer * side + static_cast<size_t>(z)) * side + static_cast<size_t>(x)]);
    }
    return depth;
}
double seenAlong(const TreeAir& air, const glm::dvec3& way) {
    return static_cast<double>(seenFrom(air.facing, static_cast<float>(way.y)));
}

// An image that holds the rectangle from low to high.
TreeShade imageOver(const glm::dvec2& low, const glm::dvec2& high, double texel) {
    TreeShade s;
    s.texel = texel;  // as fine as the tree's air: those of enormous trees would take minutes
    s.first = low;
    s.size = glm::ivec2(glm::ceil((high - low) / s.texel));
    s.depth.resize(static_cast<size_t>(s.size.x) * static_cast<size_t>(s.size.y));
    return s;
}
template <class F>
void fill(TreeShade& s, F depth) {
    for (int z = 0; z < s.size.y; ++z)
        for (int x = 0; x < s.size.x; ++x)
            s.depth[static_cast<size_t>(z * s.size.x + x)] =
                static_cast<float>(depth(s.first + (glm::dvec2(x, z) + 0.5) * s.texel));
}

}  // namespace

TreeAir treeAir(const Mesh& mesh) {
    TreeAir air;
    if (mesh.parts.empty()) return air;
    const double reach = static_cast<double>(
        std::max({std::abs(mesh.low.x), std::abs(mesh.high.x), std::abs(mesh.low.z), std::abs(mesh.high.z)}));
    air.part = std::max(kPart, std::max(2 * reach, static_cast<double>(mesh.high.y)) / kMostParts);
    air.height = std::max(static_cast<double>(mesh.high.y), air.part);
    air.side = 2 * std::max(static_cast<int>(std::ceil(reach / air.part)), 1);
    air.layers = std::max(static_cast<int>(std::ceil(air.height / air.part)), 1);
    air.facing = facingOf(mesh);
    const size_t side = static_cast<size_t>(air.side);
    air.extinction.assign(side * side * static_cast<size_t>(air.layers), 0);
    const float volume = static_cast<float>(air.part * air.part * air.part);
    const auto index = [&](double x, int most) {
        return static_cast<size_t>(std::clamp(static_cast<int>(std::floor(x / air.part)), 0, most - 1));
    };
    spreadPoints(mesh, glm::dmat3(1), 0.5 * air.part, [&](const glm::dvec3& p, const glm::vec3&, double area) {
        const double half = 0.5 * air.side * air.part;
        // Half of a leaf's area is what is seen of it in the mean of all directions.
        air.extinction[(index(p.y, air.layers) * side + index(p.z + half, air.side)) * side +
                       index(p.x + half, air.side)] += static_cast<float>(0.5 * area) / volume;
    });
    return air;
}

float TreeShade::at(const glm::dvec2& place) const {
    const glm::dvec2 t = (place - first) / texel - 0.5;
    const glm::dvec2 low = glm::floor(t), part = t - low;
    const int x = static_cast<int>(low.x), z = static_cast<int>(low.y);
    if (x < -1 || z < -1 || x >= size.x || z >= size.y) return 0;
    const auto texelAt = [&](int i, int k) {
        const bool there = i >= 0 && k >= 0 && i < size.x && k < size.y;
        return there ? static_cast<double>(depth[static_cast<size_t>(k * size.x + i)]) : 0.0;
    };
    return static_cast<float>(glm::mix(glm::mix(texelAt(x, z), texelAt(x + 1, z), part.x),
                                       glm::mix(texelAt(x, z + 1), texelAt(x + 1, z + 1), part.x), part.y));
}

TreeShade shadeTowards(const TreeAir& air, const glm::dvec3& light, double verticalScale) {
    if (air.side == 0) return {};
    const glm::dvec3 way = bakedWay(raised(light), verticalScale);
    const double half = 0.5 * air.side * air.part;
    const glm::dvec2 thrown = -glm::dvec2(way.x, way.z) * (air.height / way.y);
    TreeShade s = imageOver(glm::min(glm::dvec2(0), thrown) - half, glm::max(glm::dvec2(0), thrown) + half, air.part);
    const double seen = seenAlong(air, way);
    fill(s, [&](const glm::dvec2& at) { return seen * depthFrom(air, at, way, 0.5 * air.part); });
    return s;
}

TreeShade shadeOfSky(const TreeAir& air, double verticalScale) {
    if (air.side == 0) return {};
    const double reach = 0.5 * air.side * air.part + air.height * verticalScale;
    const double texel = std::max(kSkyCoarser * air.part, 2 * reach / kMostSkyTexels);
    TreeShade s = imageOver(glm::dvec2(-reach), glm::dvec2(reach), texel);
    struct Direction {
        glm::dvec3 way;
        double seen;
    };
    std::vector<Direction> directions;
    for (int k = 0; k < kSkyDirections; ++k) {
        // Level ground takes light by its sine: directions are spread so that each counts as much.
        const double y = std::sqrt((k + 0.5) / kSkyDirections), turn = k * 2.399963229728653, r = std::sqrt(1 - y * y);
        const glm::dvec3 way = bakedWay({r * std::cos(turn), y, r * std::sin(turn)}, verticalScale);
        directions.push_back({way, seenAlong(air, way)});
    }
    fill(s, [&](const glm::dvec2& at) {
        double light = 0;
        for (const Direction& d : directions) light += std::exp(-d.seen * depthFrom(air, at, d.way, 0.5 * texel));
        return -std::log(std::max(light / kSkyDirections, 1e-4));
    });
    return s;
}

ShadeSum::ShadeSum(const Terrain& terrain, const glm::dvec3& origin, const glm::dvec3& sun)
    : terrain_(terrain), origin_(origin), sun_(raised(sun)) {
    const auto texels = [](double metres) {
        return std::clamp(static_cast<int>(std::ceil(metres / kLeastTexel)), 1, kMostShadeSide);
    };
    size_ = {texels(terrain.size.x), texels(terrain.size.y)};
    texel_ = terrain.size / glm::dvec2(size_);
    const size_t count = static_cast<size_t>(size_.x) * static_cast<size_t>(size_.y);
    heights_.resize(count), sunDepth_.resize(count), skyDepth_.resize(count);
    parallelFor(static_cast<size_t>(size_.y), [&](size_t z) {
        for (int x = 0; x < size_.x; ++x)
            heights_[z * static_cast<size_t>(size_.x) + static_cast<size_t>(x)] = static_cast<float>(
                terrainHeight(terrain, (x + 0.5) * texel_.x, (static_cast<double>(z) + 0.5) * texel_.y));
    });
}

void ShadeSum::add(const StandingForest& forest, const std::vector<TreeAir>& airs, double verticalScale) {
    std::vector<TreeShade> suns, skies;
    for (const TreeAir& a : airs)
        suns.push_back(shadeTowards(a, sun_, verticalScale)), skies.push_back(shadeOfSky(a, verticalScale));
    const glm::dvec2 perHeight = glm::dvec2(sun_.x, sun_.z) / sun_.y;
    constexpr int kBands = 16;
    parallelFor(kBands, [&](size_t band) {
        const int from = static_cast<int>(band) * size_.y / kBands,
                  to = (static_cast<int>(band) + 1) * size_.y / kBands;
        for (const StandingTree& t : forest.trees) {
            if (airs[t.species].side == 0) continue;
            const glm::dvec3 foot = t.at - origin_;
            const double size = static_cast<double>(t.size);
            const auto splat = [&](const TreeShade& s, std::vector<float>& sum, double reachUp, bool tilted) {
                // Ground beside the foot lies higher or lower, by which the shade is shifted.
                const glm::dvec2 room(tilted ? glm::dvec2(reachUp) * glm::abs(perHeight) : glm::dvec2(0));
                const glm::dvec2 low = glm::dvec2(foot.x, foot.z) + s.first * size - room,
                                 high = low + 2.0 * room + glm::dvec2(s.size) * s.texel * size;
                const glm::ivec2 first = glm::max(glm::ivec2(glm::floor(low / texel_)), glm::ivec2(0, from)),
                                 last =
                                     glm::min(glm::ivec2(glm::floor(high / texel_)), glm::ivec2(size_.x - 1, to - 1));
                for (int z = first.y; z <= last.y; ++z)
                    for (int x = first.x; x <= last.x; ++x) {
                        const size_t i = static_cast<size_t>(z * size_.x + x);
                        glm::dvec2 at = (glm::dvec2(x, z) + 0.5) * texel_ - glm::dvec2(foot.x, foot.z);
                        if (tilted) at -= perHeight * (static_cast<double>(heights_[i]) - foot.y);
                        sum[i] += s.at(at / size);
                    }
            };
            splat(suns[t.species], sunDepth_, 2, true);
            splat(skies[t.species], skyDepth_, 0, false);
        }
    });
}

glm::vec2 LowSky::at(const glm::dvec2& place) const {
    if (left.empty()) return glm::vec2(1);
    const glm::dvec2 t = glm::clamp(place * glm::dvec2(size) - 0.5, glm::dvec2(0), glm::dvec2(size - 1));
    const glm::ivec2 low(t), high = glm::min(low + 1, size - 1);
    const glm::vec2 part(t - glm::dvec2(low));
    const auto cell = [&](int x, int z) { return left[static_cast<size_t>(z * size.x + x)]; };
    return glm::mix(glm::mix(cell(low.x, low.y), cell(high.x, low.y), part.x),
                    glm::mix(cell(low.x, high.y), cell(high.x, high.y), part.x), part.y);
}

ShadeMap ShadeSum::map(const LowSky& low) const {
    ShadeMap m{size_, std::vector<uint8_t>(3 * sunDepth_.size())};
    const auto byte = [](float share) { return static_cast<uint8_t>(std::lround(255 * share)); };
    const auto left = [](float depth) { return std::exp(-std::min(depth, kMostDepth)); };
    for (int z = 0; z < size_.y; ++z)
        for (int x = 0; x < size_.x; ++x) {
            const size_t i = static_cast<size_t>(z * size_.x + x);
            const glm::vec2 sky = left(skyDepth_[i]) * low.at((glm::dvec2(x, z) + 0.5) / glm::dvec2(size_));
            m.shares[3 * i] = byte(left(sunDepth_[i]));
            m.shares[3 * i + 1] = byte(sky.x), m.shares[3 * i + 2] = byte(sky.y);
        }
    return m;
}

}  // namespace sward
