// Moves each texel towards a random number between 0 and the brush's value, the same for every stamp with the same
// seed, so that painting longer brings the pattern out and never drifts. On maps of colours the number is the opacity
// of the brush's colour. Heights are roughened instead, by the value in metres: four octaves of gradient noise (K.
// Perlin, An Image Synthesizer, 1985; interpolation of Improving Noise, 2002), the widest as wide as the brush's bumps,
// fixed to the map and of mean 0, so that painting longer makes bumps higher and never drifts.
#include <array>

#include "brushes/colours.h"
#include "brushes/heights.h"

namespace sward {
namespace {
// Integer mixing of a texel's place and the seed; uniform over 32 bits.
uint32_t texelHash(uint32_t x, uint32_t y, uint32_t seed) {
    uint32_t h = x * 0x8DA6B343u ^ y * 0xD8163841u ^ seed * 0xCB1AB31Fu;
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    h = (h ^ (h >> 12)) * 0x297A2D39u;
    return h ^ (h >> 15);
}

constexpr int kOctaves = 4;
constexpr double kLeastBump = 2;  // texels; finer octaves would be noise of single texels

double fade(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

// One octave along a row: at each column of its lattice, height and slope of what the gradients beside the row add up
// to there. Between two columns the noise is their mix.
struct LatticeRow {
    double cell;              // texels
    int first;                // column of the lattice, left of the tile
    std::vector<float> a, b;  // slope, height

    LatticeRow(double cellX, double cellY, int x0, int y, uint32_t seed) : cell(cellX) {
        const double place = (y + 0.5) / cellY, down = std::floor(place), fy = place - down, mix = fade(fy);
        first = static_cast<int>(std::floor((x0 + 0.5) / cell));
        const int count = static_cast<int>(std::floor((x0 + kTileSize - 0.5) / cell)) - first + 2;
        for (int i = 0; i < count; ++i) {
            const glm::dvec2 up = gradient(first + i, static_cast<int>(down), seed),
                             low = gradient(first + i, static_cast<int>(down) + 1, seed);
            a.push_back(static_cast<float>(up.x + (low.x - up.x) * mix));
            b.push_back(static_cast<float>(up.y * fy + (low.y * (fy - 1) - up.y * fy) * mix));
        }
    }
    // A unit vector at a point of the lattice.
    static glm::dvec2 gradient(int x, int y, uint32_t seed) {
        static const std::array<glm::dvec2, 64> ways = [] {
            std::array<glm::dvec2, 64> w;
            for (size_t i = 0; i < w.size(); ++i) {
                const double turn = 2 * 3.14159265358979323846 * static_cast<double>(i) / static_cast<double>(w.size());
                w[i] = {std::cos(turn), std::sin(turn)};
            }
            return w;
        }();
        return ways[texelHash(static_cast<uint32_t>(x), static_cast<uint32_t>(y), seed) >> 26];
    }
    // Adds `gain` times the noise of the row's texels. What the two columns around each say is laid out first, so that
    // the loop over the texels has no look-up.
    void add(int x0, float gain, float* __restrict sum) const {
        const double begin = (x0 + 0.5) / cell - first;
        alignas(64) float place[kTileSize], a0[kTileSize], b0[kTileSize], a1[kTileSize], b1[kTileSize];
        int from = 0;
        for (size_t c = 0; c + 1 < a.size(); ++c) {
            const int to = c + 2 < a.size() ? std::clamp(static_cast<int>(std::ceil((double(c + 1) - begin) * cell)),
                                                         from, kTileSize)
                                            : kTileSize;
            std::fill(place + from, place + to, static_cast<float>(begin - static_cast<double>(c)));
            std::fill(a0 + from, a0 + to, a[c]), std::fill(b0 + from, b0 + to, b[c]);
            std::fill(a1 + from, a1 + to, a[c + 1]), std::fill(b1 + from, b1 + to, b[c + 1]);
            from = to;
        }
        const float inv = static_cast<float>(1 / cell);
        for (int i = 0; i < kTileSize; ++i) {
            const float f = place[i] + static_cast<float>(i) * inv, t = f * f * f * (f * (f * 6 - 15) + 10);
            const float left = a0[i] * f + b0[i], right = a1[i] * (f - 1) + b1[i];
            sum[i] += gain * (left + (right - left) * t);
        }
    }
};

// The bumps of a row of texels, within [-1, 1].
void bumps(const Stamp& stamp, const BrushSettings& brush, int x0, int y, float* sum) {
    std::fill(sum, sum + kTileSize, 0.0f);
    const double share = brush.bumpSize > 0 ? static_cast<double>(brush.bumpSize / brush.radius) : 1;
    double wide = std::max(share * stamp.radiusX, kLeastBump), deep = std::max(share * stamp.radiusY, kLeastBump);
    float gain = 0.7f;  // with a gain halved from octave to octave all gradients together reach 1 at most
    for (int octave = 0; octave < kOctaves && std::min(wide, deep) >= kLeastBump; ++octave) {
        LatticeRow(wide, deep, x0, y, static_cast<uint32_t>(brush.seed + 7919 * octave)).add(x0, gain, sum);
        wide /= 2, deep /= 2, gain /= 2;
    }
}

std::shared_ptr<const Tile> roughen(const Map& map, int tx, int ty, const Stamp& stamp, const BrushSettings& brush) {
    if (!(brush.radius > 0) || !std::isfinite(brush.bumpSize)) return map.tile(tx, ty);
    return paintTile(map, tx, ty, stamp, brush, [&](const auto& row) {
        using Real = std::remove_cvref_t<decltype(row.scale)>;
        const Real steps =
            static_cast<Real>(static_cast<double>(brush.value) * stepsPerMetre(static_cast<double>(row.scale), brush));
        float sum[kTileSize];
        bumps(stamp, brush, row.x0, row.y, sum);
        for (int i = 0; i < kTileSize; ++i) row.change[i] = steps * static_cast<Real>(row.weight[i] * sum[i]);
    });
}

}  // namespace

std::shared_ptr<const Tile> applyNoise(const Map& map, int tx, int ty, const Stamp& stamp, const BrushSettings& brush) {
    const uint32_t seed = static_cast<uint32_t>(brush.seed);
    if (brush.heights) return roughen(map, tx, ty, stamp, brush);
    if (brush.colours)
        return layColour(map, tx, ty, stamp, brush, [&](int x, int y, double) {
            const uint32_t h = texelHash(static_cast<uint32_t>(x), static_cast<uint32_t>(y), seed);
            return static_cast<double>(brush.value) * (h >> 8) * 0x1p-24;
        });
    return paintTile(map, tx, ty, stamp, brush, [&](const auto& row) {
        using Real = std::remove_cvref_t<decltype(row.scale)>;
        const Real amount = row.scale * static_cast<Real>(brush.value) * static_cast<Real>(0x1p-24);
        changeTowards(row, [&](int i) {
            const uint32_t h = texelHash(static_cast<uint32_t>(row.x0 + i), static_cast<uint32_t>(row.y), seed);
            return amount * static_cast<Real>(h >> 8);
        });
    });
}

}  // namespace sward
