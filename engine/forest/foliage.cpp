#include "forest/foliage.h"

#include <algorithm>
#include <cmath>

#include "core/numerics.h"
#include "forest/stretch.h"
#include "forest/volume_bake.h"

namespace sward {
namespace {

constexpr float kHalfTurn = 3.1415927f;

// Where x in [0, 1] lies among n places: the lower one, and the share of the next.
struct Between {
    size_t low;
    float share;
    Between(float x, int n) {
        const float at = std::clamp(x, 0.0f, 1.0f) * static_cast<float>(n - 1);
        low = static_cast<size_t>(std::min(static_cast<int>(at), n - 2));
        share = at - static_cast<float>(low);
    }
    template <class Row>
    float in(const Row& row) const {
        return glm::mix(row[low], row[low + 1], share);
    }
};

// What leaves that are seen from a rise take of light that comes at another, from all around, on both sides.
float taken(const Facing& facing, float light, float eye) {
    constexpr int kAround = 8;  // half a turn
    const float across = std::sqrt(std::max((1 - light * light) * (1 - eye * eye), 0.0f));
    float sum = 0;
    for (int k = 0; k < kAround; ++k) {
        const float cosine = light * eye + across * std::cos(kHalfTurn * (static_cast<float>(k) + 0.5f) / kAround);
        sum += sentTo(facing, light, eye, cosine) + passedTo(facing, light, eye, cosine);
    }
    return sum / kAround;
}

}  // namespace

glm::vec3 leafColor(const Mesh& mesh) {
    const std::vector<float> leaves = leafParts(mesh);
    Mesh part = mesh;
    glm::dvec3 sum(0);
    double all = 0;
    for (size_t i = 0; i < mesh.parts.size(); ++i) {
        part.parts = {mesh.parts[i]};
        spreadPoints(part, glm::dmat3(1), 1e9, [&](const glm::dvec3&, const glm::vec3& color, double area) {
            // A trace of all else stands for trees without leaves.
            const double counts = area * (leaves[i] > 0.5f ? static_cast<double>(leaves[i]) : 1e-6);
            sum += counts * glm::dvec3(color), all += counts;
        });
    }
    return all > 0 ? glm::vec3(sum / all) : glm::vec3(0);
}

glm::vec3 scatterOf(const glm::vec3& color, float translucency) {
    return glm::min(color + translucency * f32::leafThrough(color), glm::vec3(0.98f));
}

FoliageTable::FoliageTable(const Facing& baked, const glm::vec3& sun, float verticalScale)
    : verticalScale_(verticalScale) {
    const Facing facing = stretched(baked, verticalScale);
    const float across = glm::length(glm::vec2(sun.x, sun.z));
    if (across > 1e-6f) sunSide_ = glm::vec2(sun.x, sun.z) / across;
    for (size_t i = 0; i < kRises; ++i) {
        const float y = 2 * static_cast<float>(i) / (kRises - 1) - 1, level = std::sqrt(std::max(1 - y * y, 0.0f));
        seen_[i] = seenFrom(baked, y);
        level_[i] = upright_[i] = 1;
        if (verticalScale != 1)
            level_[i] = taken(facing, 0, y) / taken(baked, 0, y),
            upright_[i] = taken(facing, 1, y) / taken(baked, 1, y);
        sky_[i] = 0.5f + 0.5f * seenRise(facing, y);
        for (size_t k = 0; k < kTurns; ++k) {
            const float turn = kHalfTurn * static_cast<float>(k) / (kTurns - 1);
            const float cosine = y * sun.y + level * across * std::cos(turn);
            sun_[i][k] = sentTo(facing, sun.y, y, cosine), passed_[i][k] = passedTo(facing, sun.y, y, cosine);
        }
    }
}

FoliageLook FoliageTable::from(const glm::vec3& way) const {
    const float level = glm::length(glm::vec2(way.x, way.z));
    const float cosine = level > 1e-6f ? glm::dot(glm::vec2(way.x, way.z), sunSide_) / level : 1;
    const glm::vec3 baked(bakedWay(glm::dvec3(way), static_cast<double>(verticalScale_)));
    const Between rise(0.5f + 0.5f * way.y, kRises), bakedRise(0.5f + 0.5f * baked.y, kRises),
        turn(std::acos(std::clamp(cosine, -1.0f, 1.0f)) / kHalfTurn, kTurns);
    const auto both = [&](const auto& table) {
        return glm::mix(turn.in(table[rise.low]), turn.in(table[rise.low + 1]), rise.share);
    };
    // Of means of ones not all are 1 to the last bit.
    const auto stretch = [&](const auto& table) { return verticalScale_ == 1 ? 1 : rise.in(table); };
    return {bakedRise.in(seen_), both(sun_), both(passed_), rise.in(sky_), stretch(level_), stretch(upright_)};
}

}  // namespace sward
