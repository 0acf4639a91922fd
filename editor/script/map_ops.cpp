#include "script/map_ops.h"

#include <cmath>

#include "script/texel_edit.h"

namespace sward {
namespace {

// --- noise -------------------------------------------------------------------------------------------------------

uint32_t latticeHash(int32_t x, int32_t y, uint32_t seed) {
    uint32_t h = static_cast<uint32_t>(x) * 0x9E3779B1u ^ static_cast<uint32_t>(y) * 0x85EBCA77u ^ seed * 0xC2B2AE3Du;
    h = (h ^ (h >> 16)) * 0x7FEB352Du;
    h = (h ^ (h >> 15)) * 0x846CA68Bu;
    return h ^ (h >> 16);
}

// 256 directions all around, for the slopes at lattice points.
struct Directions {
    std::array<float, 256> x, y;
    Directions() {
        for (size_t i = 0; i < 256; ++i) {
            const double angle = 2 * 3.14159265358979323846 * (double(i) + 0.5) / 256;
            x[i] = static_cast<float>(std::cos(angle));
            y[i] = static_cast<float>(std::sin(angle));
        }
    }
};

float ramp(const Directions& to, uint32_t h, float dx, float dy) { return to.x[h >> 24] * dx + to.y[h >> 24] * dy; }

float fade(float t) { return t * t * t * (t * (t * 6 - 15) + 10); }

// Gradient noise, -0.71 to 0.71. (x, y) in lattice steps; after `period` of them it repeats, 0: never.
struct Period {
    int x = 0, y = 0;
};
int32_t wrapped(int32_t i, int period) { return period > 0 ? (i % period + period) % period : i; }
float gradientNoise(const Directions& to, double x, double y, uint32_t seed, const Period& period = {}) {
    const double x0 = std::floor(x), y0 = std::floor(y);
    const auto ix = static_cast<int32_t>(x0), iy = static_cast<int32_t>(y0);
    const auto dx = static_cast<float>(x - x0), dy = static_cast<float>(y - y0);
    const auto corner = [&](int i, int j) {
        return ramp(to, latticeHash(wrapped(ix + i, period.x), wrapped(iy + j, period.y), seed), dx - float(i),
                    dy - float(j));
    };
    const float u = fade(dx), v = fade(dy);
    const float near = corner(0, 0) * (1 - u) + corner(1, 0) * u;
    const float far = corner(0, 1) * (1 - u) + corner(1, 1) * u;
    return near * (1 - v) + far * v;
}

// In [0,1], mean 1/2. Each octave has its own seed, and is turned against the one before, so that no lattice shows.
float fractalNoise(const Directions& to, double x, double z, const NoiseSettings& s) {
    constexpr double turnCos = 0.8, turnSin = 0.6;
    float sum = 0, total = 0, strength = 1;
    x /= s.scale;
    z /= s.scale;
    for (int octave = 0; octave < s.octaves; ++octave) {
        const double turned = turnCos * x - turnSin * z;
        z = turnSin * x + turnCos * z;
        x = turned;
        sum += strength * gradientNoise(to, x, z, static_cast<uint32_t>(s.seed * 16 + octave));
        total += strength;
        strength *= 0.5f;
        x *= 2;
        z *= 2;
    }
    return std::clamp(0.5f + 0.95f * sum / total, 0.0f, 1.0f);
}

// The same over a map that repeats; (u, v) in [0,1]. Octaves are moved against each other instead of turned.
float seamlessNoise(const Directions& to, double u, double v, double width, double depth, const NoiseSettings& s) {
    float sum = 0, total = 0, strength = 1;
    for (int octave = 0; octave < s.octaves; ++octave) {
        const auto steps = [&](double metres) {
            return static_cast<int>(std::clamp(std::round(std::ldexp(metres / s.scale, octave)), 1.0, 1e9));
        };
        const Period period{steps(width), steps(depth)};
        const double shift = 0.381966 * octave;
        sum += strength * gradientNoise(to, (u + shift) * period.x, (v + 0.5 * shift) * period.y,
                                        static_cast<uint32_t>(s.seed * 16 + octave), period);
        total += strength;
        strength *= 0.5f;
    }
    return std::clamp(0.5f + 0.95f * sum / total, 0.0f, 1.0f);
}

float combine(NoiseMode mode, float value, float noise, float amount) {
    switch (mode) {
        case NoiseMode::Add:
            return value + amount * (2 * noise - 1);
        case NoiseMode::Multiply:
            return value * (1 + amount * (2 * noise - 1));
        case NoiseMode::Set:
            return amount * noise;
    }
    return value;
}

// --- blur --------------------------------------------------------------------------------------------------------

// Three odd box widths whose variances add up to about sigma^2.
std::array<int, 3> boxWidths(double sigma) {
    const double ideal = std::sqrt(12 * sigma * sigma / 3 + 1);
    int low = static_cast<int>(ideal);
    if (low % 2 == 0) --low;
    const double m = (12 * sigma * sigma - 3.0 * low * low - 12.0 * low - 9) / (-4.0 * low - 4);
    const int lows = static_cast<int>(std::lround(m));
    return {lows > 0 ? low : low + 2, lows > 1 ? low : low + 2, lows > 2 ? low : low + 2};
}

// Mean over `width` values around each of n, stride apart; the ends go on, or around. `line` is scratch of n.
void boxLine(float* values, size_t stride, int n, int width, bool around, std::vector<float>& line) {
    if (width <= 1) return;
    line.resize(static_cast<size_t>(n));
    for (int i = 0; i < n; ++i) line[size_t(i)] = values[size_t(i) * stride];
    const int reach = width / 2;
    const auto at = [&](int i) { return double(line[size_t(around ? (i % n + n) % n : std::clamp(i, 0, n - 1))]); };
    double sum = 0;
    for (int i = -reach; i <= reach; ++i) sum += at(i);
    for (int i = 0; i < n; ++i) {
        values[size_t(i) * stride] = static_cast<float>(sum / width);
        sum += at(i + reach + 1) - at(i - reach);
    }
}

// The plane is cut into strips, one a piece of work, so that columns share cache lines.
void blurPlane(std::vector<float>& plane, int width, int height, const std::array<int, 3>& across,
               const std::array<int, 3>& down, bool around) {
    parallelFor(size_t(height), [&](size_t y) {
        std::vector<float> line;
        for (const int w : across) boxLine(&plane[y * size_t(width)], 1, width, w, around, line);
    });
    constexpr int kStrip = 16;
    parallelFor(size_t((width + kStrip - 1) / kStrip), [&](size_t strip) {
        std::vector<float> line;
        for (int x = int(strip) * kStrip; x < std::min(width, (int(strip) + 1) * kStrip); ++x)
            for (const int w : down) boxLine(&plane[size_t(x)], size_t(width), height, w, around, line);
    });
}

// --- curve -------------------------------------------------------------------------------------------------------

float curveAt(const std::vector<std::pair<double, double>>& points, float value) {
    const auto above = std::upper_bound(points.begin(), points.end(), double(value),
                                        [](double v, const auto& p) { return v < p.first; });
    if (above == points.begin()) return static_cast<float>(points.front().second);
    if (above == points.end()) return static_cast<float>(points.back().second);
    const auto below = above - 1;
    const double t = (value - below->first) / std::max(above->first - below->first, 1e-30);
    return static_cast<float>(below->second + t * (above->second - below->second));
}

template <class F>
void editChannels(Map& map, const Channels& channels, F&& f) {
    const int n = map.info().channels;
    editTexels(map, [&](int x, int y, float* texel) {
        for (int c = 0; c < n; ++c)
            if (channels[size_t(c)]) texel[c] = f(x, y, texel[c]);
    });
}

}  // namespace

void fillMap(Map& map, const std::array<float, 4>& value) {
    editTexels(map, [&](int, int, float* texel) { std::copy(value.begin(), value.end(), texel); });
}

void noiseMap(Map& map, double width, double depth, const NoiseSettings& settings, const Channels& channels) {
    const double dx = width / map.info().width, dz = depth / map.info().height;
    const auto amount = static_cast<float>(settings.amount);
    const int n = map.info().channels;
    const Directions directions;
    editTexels(map, [&](int x, int y, float* texel) {
        const double px = (x + 0.5) * dx, pz = (y + 0.5) * dz;
        const float noise = settings.seamless
                                ? seamlessNoise(directions, px / width, pz / depth, width, depth, settings)
                                : fractalNoise(directions, px, pz, settings);
        for (int c = 0; c < n; ++c)
            if (channels[size_t(c)]) texel[c] = combine(settings.mode, texel[c], noise, amount);
    });
}

void blurMap(Map& map, double radiusX, double radiusY, const Channels& channels, bool repeats) {
    const MapInfo info = map.info();
    const auto across = boxWidths(radiusX / 2), down = boxWidths(radiusY / 2);
    if (std::max(across[2], down[2]) <= 1) return;
    std::vector<float> plane(size_t(info.width) * size_t(info.height));
    for (int c = 0; c < info.channels; ++c) {
        if (!channels[size_t(c)]) continue;
        const auto at = [&](int x, int y) -> float& { return plane[size_t(y) * size_t(info.width) + size_t(x)]; };
        editTexels(map, [&](int x, int y, float* texel) { at(x, y) = texel[c]; });
        blurPlane(plane, info.width, info.height, across, down, repeats);
        editTexels(map, [&](int x, int y, float* texel) { texel[c] = at(x, y); });
    }
}

void curveMap(Map& map, const std::vector<std::pair<double, double>>& points, const Channels& channels) {
    editChannels(map, channels, [&](int, int, float v) { return curveAt(points, v); });
}

}  // namespace sward
