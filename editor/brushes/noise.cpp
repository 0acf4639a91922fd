// Moves each texel towards a random number between 0 and the brush's value, the same for every stamp with the same
// seed, so that painting longer brings the pattern out and never drifts. On maps of colours the number is the opacity
// of the brush's colour. Heights are roughened instead, by the value in metres: four octaves of gradient noise (K.
// Perlin, An Image Synthesizer, 1985; interpolation of Improving Noise, 2002), the widest as wide as the brush's bumps,
// fixed to the map and of mean 0, so that painting longer makes bumps higher and never drifts.
#include <array>
#include <limits>
#include <vector>

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

// A unit vector at a point of the lattice.
glm::dvec2 gradient(int x, int y, uint32_t seed) {
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

// One octave over a tile. What the gradients of one line of the lattice say along a row of texels is the same for all
// rows between two lines, but for how far a row lies from each; so it is laid out once for them all.
class Octave {
  public:
    // A lattice of cellX by cellY texels; x0: of the tile's first texel.
    Octave(double cellX, double cellY, int x0, uint32_t seed, float gain)
        : cellX_(cellX), cellY_(cellY), x0_(x0), seed_(seed), gain_(gain) {}

    // To the row y of the map, before add.
    void take(int y) {
        const double place = (y + 0.5) / cellY_, above = std::floor(place), fy = place - above, mix = fade(fy);
        const double up = gain_ * (1 - mix), low = gain_ * mix;
        part_ = {static_cast<float>(up), static_cast<float>(up * fy), static_cast<float>(low),
                 static_cast<float>(low * (fy - 1))};
        const int line = static_cast<int>(above);
        if (line == line_) return;
        layOut(line, across_[0], down_[0]);
        layOut(line + 1, across_[1], down_[1]);
        line_ = line;
    }
    // Adds its bumps to kPaintBlock texels from `from` on.
    void add(int from, float* __restrict sum) const {
        const float *a = across_[0] + from, *b = down_[0] + from, *c = across_[1] + from, *d = down_[1] + from;
        const auto [pa, pb, pc, pd] = part_;
        for (int i = 0; i < kPaintBlock; ++i) sum[i] += pa * a[i] + pb * b[i] + pc * c[i] + pd * d[i];
    }

  private:
    // Height on the line itself, and what a row gains for each line that it lies below.
    void layOut(int line, float* across, float* down) const {
        int column = 0;
        glm::dvec2 left{0}, right{0};
        for (int i = 0; i < kTileSize; ++i) {
            const double place = (x0_ + i + 0.5) / cellX_, first = std::floor(place), f = place - first, t = fade(f);
            if (const int at = static_cast<int>(first); i == 0 || at != column) {
                column = at;
                left = gradient(at, line, seed_), right = gradient(at + 1, line, seed_);
            }
            const double from = left.x * f, to = right.x * (f - 1);
            across[i] = static_cast<float>(from + (to - from) * t);
            down[i] = static_cast<float>(left.y + (right.y - left.y) * t);
        }
    }

    double cellX_, cellY_;
    int x0_, line_ = std::numeric_limits<int>::min();
    uint32_t seed_;
    float gain_;
    std::array<float, 4> part_ = {};
    alignas(64) float across_[2][kTileSize], down_[2][kTileSize];  // of the line above a row, and of that below
};

// Whose sum lies within [-1, 1].
std::vector<Octave> octavesOf(const Stamp& stamp, const BrushSettings& brush, int x0) {
    std::vector<Octave> out;
    const double share = brush.bumpSize > 0 ? static_cast<double>(brush.bumpSize / brush.radius) : 1;
    double wide = std::max(share * stamp.radiusX, kLeastBump), deep = std::max(share * stamp.radiusY, kLeastBump);
    float gain = 0.7f;  // with a gain halved from octave to octave all gradients together reach 1 at most
    for (int i = 0; i < kOctaves && std::min(wide, deep) >= kLeastBump; ++i) {
        out.emplace_back(wide, deep, x0, static_cast<uint32_t>(brush.seed + 7919 * i), gain);
        wide /= 2, deep /= 2, gain /= 2;
    }
    return out;
}

std::shared_ptr<const Tile> roughen(const Map& map, int tx, int ty, const Stamp& stamp, const BrushSettings& brush) {
    if (!(brush.radius > 0) || !std::isfinite(brush.bumpSize)) return map.tile(tx, ty);
    std::vector<Octave> octaves = octavesOf(stamp, brush, tx * kTileSize);
    return paintTile(map, tx, ty, stamp, brush, [&](const auto& row) {
        using Real = std::remove_cvref_t<decltype(row.scale)>;
        const Real steps =
            static_cast<Real>(static_cast<double>(brush.value) * stepsPerMetre(static_cast<double>(row.scale), brush));
        for (Octave& octave : octaves) octave.take(row.y);
        eachBlock(row, [&](int from) {
            float sum[kPaintBlock] = {};
            for (const Octave& octave : octaves) octave.add(from, sum);
            for (int i = 0; i < kPaintBlock; ++i)
                row.change[from + i] = steps * static_cast<Real>(row.weight[from + i] * sum[i]);
        });
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
