#include "scene/population.h"

#include <numeric>

#include "core/hash.h"
#include "core/numerics.h"

namespace sward {
namespace {

// Independent numbers of one blade: the stream's n-th is hashUnit(hash3(seed, blade, n)).
struct Draw {
    uint32_t seed, blade, next = 0;
    float unit() { return f32::hashUnit(f32::hash3(seed, blade, next++)); }
    float signedUnit() { return 2 * unit() - 1; }
    // Standard normal cut at three deviations, by the sum of four uniforms: bounded, smooth, enough for leans.
    float bell() { return (unit() + unit() + unit() + unit() - 2) * 1.7320508f; }
};

// Each blade a stratum: rows of nearly square strata whose counts add up to n exactly.
std::vector<glm::vec2> stratifiedRoots(int n, float cellSize, uint32_t seed) {
    std::vector<glm::vec2> roots;
    roots.reserve(static_cast<size_t>(n));
    const int rows = std::max(1, static_cast<int>(std::lround(std::sqrt(static_cast<double>(n)))));
    const float below = std::nextafter(cellSize, 0.0f);
    for (int r = 0; r < rows; ++r) {
        const int first = static_cast<int>(int64_t(r) * n / rows), last = static_cast<int>(int64_t(r + 1) * n / rows);
        for (int i = first; i < last; ++i) {
            Draw d{seed, static_cast<uint32_t>(i), 0};
            const float x = (static_cast<float>(i - first) + d.unit()) / static_cast<float>(last - first);
            const float z = (static_cast<float>(r) + d.unit()) / static_cast<float>(rows);
            roots.push_back(glm::min(glm::vec2(x, z) * cellSize, glm::vec2(below)));
        }
    }
    return roots;
}

// Rank of each blade in a random order: thresholds are uniform, and independent of place.
std::vector<uint32_t> shuffledRanks(int n, uint32_t seed) {
    std::vector<uint32_t> rank(static_cast<size_t>(n));
    std::iota(rank.begin(), rank.end(), 0u);
    for (int i = n - 1; i > 0; --i) {
        const uint64_t h = f32::hash3(seed, static_cast<uint32_t>(i), 77u);
        std::swap(rank[static_cast<size_t>(i)], rank[static_cast<size_t>((h * static_cast<uint64_t>(i + 1)) >> 32)]);
    }
    return rank;
}

Blade makeBlade(const Species& s, const glm::vec2& root, uint32_t seed, uint32_t index, int k) {
    Draw d{seed ^ 0x5eedu, index, 0};
    const float height = s.height * (1 + s.heightVariation * d.signedUnit());
    const float azimuth = 6.2831853f * d.unit();
    const float lean = glm::radians(s.leanVariationDeg) * d.bell();
    const float bend = s.bend * (0.5f + d.unit());
    const f32::BladeShape shape = f32::bladeShape(height, std::abs(lean), std::min(bend, 1.0f), azimuth);
    Blade b{};
    b.root = root;
    b.width = s.width * (0.75f + 0.5f * d.unit());
    b.threshold = f32::thresholdOf(k);
    b.control = shape.control;
    b.tip = shape.tip;
    b.hue = glm::radians(s.hueVariationDeg) * d.signedUnit();
    b.lightness = 1 + s.lightnessVariation * d.signedUnit();
    b.facing = {std::cos(azimuth), std::sin(azimuth)};
    b.dither = 1 - d.unit();
    return b;
}

// What a cell has where the density is 1, in the mean.
double bladesOfCell(const Species& s, float cellSize) {
    return std::min<double>(double(s.bladesPerM2) * double(cellSize) * double(cellSize), kMaxPatchBlades);
}
f32::Sown sownIn(double expected) {
    const f64::Sown s = f64::sownOf(expected);
    return {static_cast<float>(s.spread), static_cast<float>(s.step), static_cast<float>(s.share)};
}
// Of the blade of a rank, 1 to 255.
int thresholdNumberOf(uint32_t rank, double expected) {
    const int n = f64::sownBlades(expected);
    if (f64::isSownEvenly(expected)) return 1 + static_cast<int>(int64_t(rank) * 255 / n);
    return f64::thresholdStep(n) * (1 + static_cast<int>(int64_t(rank) * f64::thresholdClasses(n) / n));
}

}  // namespace

Patch makePatch(const Species& species, float cellSize, uint32_t seed) {
    const double expected = bladesOfCell(species, cellSize);
    const int n = f64::sownBlades(expected);
    const auto roots = stratifiedRoots(n, cellSize, seed);
    const auto ranks = shuffledRanks(n, seed);
    Patch patch;
    patch.sown = sownIn(expected);
    patch.blades.resize(static_cast<size_t>(n));
    for (int i = 0; i < n; ++i) {
        const uint32_t rank = ranks[static_cast<size_t>(i)];
        const int k = thresholdNumberOf(rank, expected);
        patch.blades[rank] = makeBlade(species, roots[static_cast<size_t>(i)], seed, static_cast<uint32_t>(i), k);
        ++patch.upTo[static_cast<size_t>(k)];
    }
    std::partial_sum(patch.upTo.begin(), patch.upTo.end(), patch.upTo.begin());
    return patch;
}

std::vector<Blade> cellBlades(const Species& species, float cellSize, uint32_t seed, int n) {
    const auto roots = stratifiedRoots(n, cellSize, seed);
    const auto ranks = shuffledRanks(n, seed);
    std::vector<Blade> blades(static_cast<size_t>(n));
    for (int i = 0; i < n; ++i) {
        const uint32_t rank = ranks[static_cast<size_t>(i)];
        blades[rank] = makeBlade(species, roots[static_cast<size_t>(i)], seed, static_cast<uint32_t>(i), 255);
        blades[rank].threshold =
            (static_cast<float>(rank + 1) - f32::hashUnit(f32::hash3(seed, rank, 5))) / static_cast<float>(n);
    }
    return blades;
}

float leanAtFull(const Species& s) { return std::tan(glm::radians(std::min(s.leanDeg, 80.0f))); }

glm::vec3 clumpStrengths(const Species& s) {
    const float clumps = s.clumpSize > 0 ? s.clumpStrength : 0;
    return {0.8f * clumps * std::tan(glm::radians(std::min(s.leanVariationDeg + s.leanDeg, 80.0f))),
            0.8f * clumps * s.heightVariation, 0.2f * clumps};
}

uint32_t sowingSeed(const Species& species, uint32_t seed) {
    return seed ^ static_cast<uint32_t>(hashBytes(species.name.data(), species.name.size()));
}

uint64_t patchKey(const Species& s, float cellSize, uint32_t seed) {
    const float read[] = {static_cast<float>(seed),
                          s.bladesPerM2,
                          s.height,
                          s.heightVariation,
                          s.width,
                          s.bend,
                          s.leanVariationDeg,
                          s.hueVariationDeg,
                          s.lightnessVariation,
                          cellSize,
                          static_cast<float>(s.segments),
                          sownIn(bladesOfCell(s, cellSize)).step};
    return hashBytes(read, sizeof(read));
}

}  // namespace sward
