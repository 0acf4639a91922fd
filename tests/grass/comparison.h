// The hybrid field held against all its blades drawn as geometry: three fields as a designer would set them up, and
// measures of pictures. Shared by tests (counts, pictures) and bench (times).
#pragma once
#include <array>
#include <cmath>
#include <numeric>

#include "frame/renderer.h"
#include "scene/project.h"
#include "tests/fields.h"
#include "world/view_camera.h"

namespace sward::test {

// A field and where its tiers meet, metres.
struct Design {
    const char* name;
    float bladesPerM2, height, width;
    double side;
    float minGeom, maxGeom, minBTF, maxBTF;
};
inline constexpr Design kMeadow{"1,000 blades/m2 of 25 cm on 40 m", 1000, 0.25f, 0.006f, 40, 3, 6, 9, 13};
inline constexpr Design kLawn{"10,000 blades/m2 of 8 cm on 20 m", 10000, 0.08f, 0.004f, 20, 2, 4, 7, 11};
inline constexpr Design kTurf{"88,000 blades/m2 of 3 cm on 10 m", 88000, 0.03f, 0.0015f, 10, 1.5f, 3, 6, 9};

template <class C>
void give(Project& p, const std::string& entity, C value) {
    p.registry.add<C>(*addEntity(p, entity), std::move(value));
}
inline FlatField grassIn(Project& p) { return flatField(p, "grass"); }
inline Light& sunIn(Project& p) { return *p.registry.get<Light>(findEntity(p, "sun")); }

inline Project designed(const Design& d, double side) {
    Project p;
    Terrain ground;
    ground.size = {side, side};
    give(p, "ground", ground);
    FlatField f;
    f.species[0].bladesPerM2 = d.bladesPerM2;
    f.species[0].height = d.height;
    f.species[0].width = d.width;
    f.minGeom = d.minGeom, f.maxGeom = d.maxGeom, f.minBTF = d.minBTF, f.maxBTF = d.maxBTF;
    put(p, "grass", f);
    give(p, "sun", Light{});
    give(p, "sky", Sky{});
    give(p, "haze", Fog{});
    return p;
}
// From a corner over the field, at the height of a person's eyes.
inline ViewCamera person(double side) {
    const double from = 0.05 * side, to = 0.5 * side;
    return {{from, 1.7, from}, {to, 0, to}, 55, 0};
}
inline ViewSettings sized(int width, int height, int msaa = 4) {
    ViewSettings s;
    s.width = width, s.height = height, s.msaa = msaa;
    return s;
}

// Pixels of a view of tiers of blades alone that mostly show blades.
inline std::vector<bool> bladePixels(const std::vector<uint8_t>& tiers) {
    std::vector<bool> out(tiers.size() / 3);
    for (size_t i = 0; i < out.size(); ++i) out[i] = tiers[3 * i] > 40 && 2 * tiers[3 * i] > 3 * tiers[3 * i + 1];
    return out;
}

// The chosen pixels of a square block of a picture, by channel (sRGB, 0 to 1).
struct Block {
    int pixels = 0;
    std::array<double, 3> mean{};
    double deviation = 0;  // RMS over channels
};
inline Block blockAt(const std::vector<uint8_t>& rgb, int width, const std::vector<bool>& chosen, int x0, int y0,
                     int side) {
    Block b;
    std::array<double, 3> squares{};
    for (int y = y0; y < y0 + side; ++y)
        for (int x = x0; x < x0 + side; ++x) {
            const size_t i = static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
            if (!chosen[i]) continue;
            ++b.pixels;
            for (size_t c = 0; c < 3; ++c) {
                const double v = rgb[3 * i + c] / 255.0;
                b.mean[c] += v, squares[c] += v * v;
            }
        }
    if (b.pixels == 0) return b;
    double variance = 0;
    for (size_t c = 0; c < 3; ++c) {
        b.mean[c] /= b.pixels;
        variance += std::max(squares[c] / b.pixels - b.mean[c] * b.mean[c], 0.0) / 3;
    }
    b.deviation = std::sqrt(variance);
    return b;
}
// 8 x 8 blocks of which at least half is chosen; the same ones for every picture of the same size.
inline std::vector<Block> blocksOf(const std::vector<uint8_t>& rgb, int width, const std::vector<bool>& chosen) {
    std::vector<Block> out;
    const int height = static_cast<int>(chosen.size()) / width;
    for (int y = 0; y + 8 <= height; y += 8)
        for (int x = 0; x + 8 <= width; x += 8)
            if (const Block b = blockAt(rgb, width, chosen, x, y, 8); b.pixels >= 32) out.push_back(b);
    return out;
}
// RMS over blocks and channels of the difference of their means.
inline double blockDistance(const std::vector<Block>& a, const std::vector<Block>& b) {
    double sum = 0;
    for (size_t i = 0; i < a.size(); ++i)
        for (size_t c = 0; c < 3; ++c) sum += (a[i].mean[c] - b[i].mean[c]) * (a[i].mean[c] - b[i].mean[c]);
    return std::sqrt(sum / (3 * static_cast<double>(std::max<size_t>(a.size(), 1))));
}
inline double blockContrast(const std::vector<Block>& a) {
    double sum = 0;
    for (const Block& b : a) sum += b.deviation;
    return sum / static_cast<double>(std::max<size_t>(a.size(), 1));
}

// By tile of 16 x 16 pixels (sRGB, 0 to 1): the mean over its pixels of how much they change from one picture to the
// next; and how much its own mean colour does, which sees a tile that fades or pops where thin blades flicker anyway.
struct TileChanges {
    std::vector<double> pixels, means;
};
inline TileChanges tileChanges(const std::vector<uint8_t>& a, const std::vector<uint8_t>& b, int width) {
    const int height = static_cast<int>(a.size()) / 3 / width, across = width / 16, down = height / 16;
    TileChanges out{std::vector<double>(static_cast<size_t>(across * down)),
                    std::vector<double>(static_cast<size_t>(across * down))};
    std::vector<std::array<int, 3>> sums(out.means.size());
    for (int y = 0; y < 16 * down; ++y)
        for (int x = 0; x < 16 * across; ++x) {
            const size_t i = 3 * (static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)),
                         tile = static_cast<size_t>(y / 16 * across + x / 16);
            for (size_t c = 0; c < 3; ++c) {
                out.pixels[tile] += std::abs(a[i + c] - b[i + c]) / (3.0 * 255 * 256);
                sums[tile][c] += b[i + c] - a[i + c];
            }
        }
    for (size_t t = 0; t < sums.size(); ++t)
        out.means[t] = (std::abs(sums[t][0]) + std::abs(sums[t][1]) + std::abs(sums[t][2])) / (3.0 * 255 * 256);
    return out;
}
// The value that a share of the values does not exceed.
inline double quantile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values[std::min(values.size() - 1, static_cast<size_t>(share * static_cast<double>(values.size())))];
}

// The changes of all tiles, picture by picture, while the camera moves so many steps of its own.
inline TileChanges flight(Renderer& r, Project& p, ViewCamera c, const glm::dvec3& step, int steps,
                          const ViewSettings& s) {
    TileChanges out;
    std::vector<uint8_t> before;
    for (int i = 0; i <= steps; ++i, c.eye += step, c.target += step) {
        if (!r.draw(p, c, s)) return {};
        std::vector<uint8_t> now = r.readImage();
        if (i > 0) {
            const TileChanges t = tileChanges(before, now, s.width);
            out.pixels.insert(out.pixels.end(), t.pixels.begin(), t.pixels.end());
            out.means.insert(out.means.end(), t.means.begin(), t.means.end());
        }
        before = std::move(now);
    }
    return out;
}
// Over a walk of 1 cm steps along +x +z.
inline TileChanges walk(Renderer& r, Project& p, const ViewCamera& c, int steps, const ViewSettings& s) {
    return flight(r, p, c, 0.01 * glm::normalize(glm::dvec3(1, 0, 1)), steps, s);
}
// How differently tiers change from blades; of a walk that stands still the shares are 1 and the times infinite.
struct Restless {
    double pixels, means;            // 99.9th percentiles of the difference, as shares of those of blades' changes
    double pixelsTimes, meansTimes;  // how many times as much, or as little, tiles change in all
    // Neither pops nor stands still.
    bool isLikeBlades() const { return std::max({pixels, means, pixelsTimes, meansTimes}) <= 1.25; }
};
inline double restlessness(const std::vector<double>& hybrid, const std::vector<double>& blades) {
    std::vector<double> difference(std::min(hybrid.size(), blades.size()));
    for (size_t i = 0; i < difference.size(); ++i) difference[i] = std::abs(hybrid[i] - blades[i]);
    return quantile(difference, 0.999) / quantile(blades, 0.999);
}
inline double timesAsMuch(const std::vector<double>& hybrid, const std::vector<double>& blades) {
    const double h = std::accumulate(hybrid.begin(), hybrid.end(), 0.0),
                 b = std::accumulate(blades.begin(), blades.end(), 0.0);
    return std::max(h / b, b / h);
}
inline Restless restless(const TileChanges& hybrid, const TileChanges& blades) {
    return {restlessness(hybrid.pixels, blades.pixels), restlessness(hybrid.means, blades.means),
            timesAsMuch(hybrid.pixels, blades.pixels), timesAsMuch(hybrid.means, blades.means)};
}
inline TileChanges bladesWalk(Renderer& r, Project& p, const ViewCamera& c, int steps, const ViewSettings& s) {
    const std::string own = std::exchange(grassIn(p).technique, nameOf(Technique::Geometry));
    TileChanges blades = walk(r, p, c, steps, s);
    grassIn(p).technique = own;
    return blades;
}
inline Restless restless(Renderer& r, Project& p, const ViewCamera& c, int steps, const ViewSettings& s) {
    return restless(walk(r, p, c, steps, s), bladesWalk(r, p, c, steps, s));
}
// From the eyes of a person who looks at the ground at a distance, the whole picture of which is about there.
inline ViewCamera lookingAt(double distance, double from = 4) {
    const double along = std::sqrt(distance * distance - 1.7 * 1.7) / std::sqrt(2.0);
    return {{from, 1.7, from}, {from + along, 0, from + along}, 20, 0};
}

}  // namespace sward::test
