// Erodes ground. Rain: drops run downhill, take ground along while they can carry more and leave it where they slow
// down (H. T. Beyer, Implementation of a Method for Hydraulic Erosion, Technische Universitaet Muenchen 2015, chapter
// 4; heights are counted in texels, so that slopes and not metres decide). Slopes: what is steeper than the talus angle
// slides to its neighbours (F. K. Musgrave, C. E. Kolb, R. S. Mace, The Synthesis and Rendering of Eroded Fractal
// Terrains, SIGGRAPH 1989, section 4.2; between each two neighbours as much goes as comes, so that no ground is lost).
// Both act by the weight of the stamp and move ground only within it. Drops start where the stamp's number and the seed
// say, and those of a batch see the ground as it was before the batch: the same on any number of threads.
// Does not: keep water from stamp to stamp.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "brushes/heights.h"
#include "core/jobs.h"

namespace sward {
namespace {

// The tiles under the stamp as one piece, as far as the map goes; heights in metres above that of one texel.
struct Land {
    TileRange tiles;
    int x0 = 0, y0 = 0, width = 0, height = 0;  // texels of the map
    double texelX = 1, texelY = 1;              // metres
    std::vector<float> before, now, weight;
    size_t at(int x, int y) const { return size_t(y) * size_t(width) + size_t(x); }
};

template <class T>
void readTile(const Map& map, int tx, int ty, double base, double scale, Land& land) {
    const T* in = reinterpret_cast<const T*>(map.tile(tx, ty)->bytes.data());
    const double unit = scale / static_cast<double>(PixelTraits<T>::scale);
    for (int y = 0; y < kTileSize; ++y) {
        const int row = ty * kTileSize + y - land.y0, column = tx * kTileSize - land.x0;
        if (row >= land.height) return;
        float* out = &land.before[land.at(column, row)];
        for (int x = 0; x < std::min(kTileSize, land.width - column); ++x)
            out[x] = static_cast<float>(static_cast<double>(in[y * kTileSize + x]) * unit - base);
    }
}

Land readLand(const Map& map, const Stamp& stamp, const BrushSettings& brush) {
    Land land;
    land.tiles = stampTiles(map.info(), stamp);
    const TileRange& t = land.tiles;
    land.x0 = t.x0 * kTileSize, land.y0 = t.y0 * kTileSize;
    land.width = std::min(t.x1 * kTileSize, map.info().width) - land.x0;
    land.height = std::min(t.y1 * kTileSize, map.info().height) - land.y0;
    land.texelX = static_cast<double>(brush.radius) / stamp.radiusX;
    land.texelY = static_cast<double>(brush.radius) / stamp.radiusY;
    const size_t texels = size_t(land.width) * size_t(land.height);
    land.before.resize(texels), land.weight.assign(texels, 0.0f);
    const int cx = static_cast<int>(std::clamp(stamp.x, 0.0, map.info().width - 1.0)),
              cy = static_cast<int>(std::clamp(stamp.y, 0.0, map.info().height - 1.0));
    const double base = static_cast<double>(map.at(cx, cy)) * brush.metres.y;
    parallelFor(t.count(), [&](size_t i) {
        const int tx = t.x0 + static_cast<int>(i) % (t.x1 - t.x0), ty = t.y0 + static_cast<int>(i) / (t.x1 - t.x0);
        if (map.info().type == PixelType::U8) readTile<uint8_t>(map, tx, ty, base, brush.metres.y, land);
        if (map.info().type == PixelType::U16) readTile<uint16_t>(map, tx, ty, base, brush.metres.y, land);
        if (map.info().type == PixelType::F32) readTile<float>(map, tx, ty, base, brush.metres.y, land);
        const StampWeights weights(map.info(), stamp, brush, tx, ty);
        float weight[kTileSize];
        const int column = tx * kTileSize - land.x0, count = std::min(kTileSize, land.width - column);
        for (int y = 0; y < kTileSize; ++y)
            if (weights.row(y, weight))
                std::copy_n(weight, count, &land.weight[land.at(column, ty * kTileSize + y - land.y0)]);
    });
    land.now = land.before;
    return land;
}

// --- rain --------------------------------------------------------------------------------------------------------

constexpr double kTexelsPerDrop = 60;  // that a stamp of full water has, one drop to so many
constexpr int kMostDrops = 1200;       // a stamp, whatever its size
constexpr size_t kBatch = 100;
constexpr int kSteps = 48;  // texels that a drop runs at most
constexpr float kInertia = 0.05f, kCapacity = 4, kLeastSlope = 0.01f, kTake = 0.3f, kLeave = 0.3f, kDry = 0.02f,
                kGravity = 1;
constexpr int kReach = 2;  // texels around a drop from which it takes

struct Move {
    uint32_t texel;
    float metres;
};
struct Drop {
    float x, y;  // texels of the land; texel centres at whole numbers
};

uint32_t mixed(uint32_t h) {
    h = (h ^ (h >> 16)) * 0x7FEB352Du;
    h = (h ^ (h >> 15)) * 0x846CA68Bu;
    return h ^ (h >> 16);
}
float unitOf(uint32_t h) { return static_cast<float>(mixed(h) >> 8) * 0x1p-24f; }

// Where the drops of a stamp fall; those beyond its ring do not.
std::vector<Drop> dropsOf(const Land& land, const Stamp& stamp, const BrushSettings& brush) {
    const double area = 4 * stamp.radiusX * stamp.radiusY;  // of the square around the stamp
    const double water = std::clamp<double>(brush.water, 0, 1);
    const int count = static_cast<int>(std::ceil(water * std::min(area / kTexelsPerDrop, kMostDrops * 1.27)));
    const uint32_t seed = mixed(static_cast<uint32_t>(brush.seed) + 1) ^ (stamp.turn * 0x9E3779B9u);
    std::vector<Drop> drops;
    for (int i = 0; i < count; ++i) {
        const uint32_t h = seed + static_cast<uint32_t>(i) * 0x85EBCA6Bu;
        const double right = 2.0 * static_cast<double>(unitOf(h)) - 1,
                     down = 2.0 * static_cast<double>(unitOf(h ^ 0x68E31DA4u)) - 1;
        if (right * right + down * down >= 1) continue;
        drops.push_back({static_cast<float>(stamp.x + right * stamp.radiusX - 0.5 - land.x0),
                         static_cast<float>(stamp.y + down * stamp.radiusY - 0.5 - land.y0)});
    }
    return drops;
}

// The ground at a place: its height and slope, in texels, and the stamp's weight; bilinear.
struct Place {
    float height, slopeX, slopeY, weight;
    size_t corner;  // of the four texels around
    float fx, fy;
};
bool placeAt(const Land& land, float toTexels, float x, float y, Place& out) {
    if (!(x >= 0 && y >= 0 && x < static_cast<float>(land.width - 1) && y < static_cast<float>(land.height - 1)))
        return false;
    const int ix = static_cast<int>(x), iy = static_cast<int>(y);
    const float fx = x - static_cast<float>(ix), fy = y - static_cast<float>(iy);
    const size_t c = land.at(ix, iy), d = c + size_t(land.width);
    const float a = land.now[c], b = land.now[c + 1], e = land.now[d], f = land.now[d + 1];
    const float top = a + (b - a) * fx, low = e + (f - e) * fx;
    const auto mix = [&](const std::vector<float>& v) {
        const float up = v[c] + (v[c + 1] - v[c]) * fx, down = v[d] + (v[d + 1] - v[d]) * fx;
        return up + (down - up) * fy;
    };
    out = {(top + (low - top) * fy) * toTexels, ((b - a) * (1 - fy) + (f - e) * fy) * toTexels, (low - top) * toTexels,
           mix(land.weight), c, fx, fy};
    return out.weight > 0;
}

// Lays `amount` metres of one texel's ground on the four texels around a place, as far as the stamp reaches them.
void leave(const Land& land, const Place& p, float amount, std::vector<Move>& moves) {
    const size_t texels[] = {p.corner, p.corner + 1, p.corner + size_t(land.width), p.corner + size_t(land.width) + 1};
    float share[] = {(1 - p.fx) * (1 - p.fy), p.fx * (1 - p.fy), (1 - p.fx) * p.fy, p.fx * p.fy}, sum = 0;
    for (int i = 0; i < 4; ++i) sum += share[i] = land.weight[texels[i]] > 0 ? share[i] : 0;
    if (!(sum > 0)) return;
    for (int i = 0; i < 4; ++i)
        if (share[i] > 0) moves.push_back({static_cast<uint32_t>(texels[i]), amount * share[i] / sum});
}

// Takes up to `amount` from around a place, the more the nearer, by the stamp's weight. Returns what came.
float take(const Land& land, float x, float y, float amount, std::vector<Move>& moves) {
    const int cx = static_cast<int>(std::lround(x)), cy = static_cast<int>(std::lround(y));
    std::array<float, (2 * kReach + 1) * (2 * kReach + 1)> share{};
    float sum = 0, taken = 0;
    size_t i = 0;
    for (int dy = -kReach; dy <= kReach; ++dy)
        for (int dx = -kReach; dx <= kReach; ++dx, ++i) {
            const float ox = static_cast<float>(cx + dx) - x, oy = static_cast<float>(cy + dy) - y;
            sum += share[i] = std::max(0.0f, static_cast<float>(kReach) - std::sqrt(ox * ox + oy * oy));
        }
    i = 0;
    for (int ty = cy - kReach; ty <= cy + kReach; ++ty)
        for (int tx = cx - kReach; tx <= cx + kReach; ++tx, ++i) {
            if (share[i] <= 0 || tx < 0 || ty < 0 || tx >= land.width || ty >= land.height) continue;
            const float metres = amount * share[i] / sum * land.weight[land.at(tx, ty)];
            if (metres <= 0) continue;
            moves.push_back({static_cast<uint32_t>(land.at(tx, ty)), -metres});
            taken += metres;
        }
    return taken;
}

// What one drop moves, from where it falls to where it ends: on level ground, at the stamp's edge, or dry. In sum
// nothing.
void runDrop(const Land& land, Drop d, std::vector<Move>& moves) {
    const float texel = static_cast<float>(std::sqrt(land.texelX * land.texelY)), toTexels = 1 / texel;
    float wayX = 0, wayY = 0, speed = 1, water = 1, carried = 0;  // metres
    Place p;
    if (!placeAt(land, toTexels, d.x, d.y, p)) return;
    for (int step = 0; step < kSteps; ++step) {
        wayX = wayX * kInertia - p.slopeX * (1 - kInertia), wayY = wayY * kInertia - p.slopeY * (1 - kInertia);
        const float length = std::sqrt(wayX * wayX + wayY * wayY);
        if (length < 1e-7f) break;
        wayX /= length, wayY /= length;
        Place next;
        if (!placeAt(land, toTexels, d.x + wayX, d.y + wayY, next)) break;
        const float rise = next.height - p.height;
        const float most = std::max(-rise, kLeastSlope) * speed * water * kCapacity * p.weight * texel;
        if (rise > 0 || carried > most) {
            const float left = rise > 0 ? std::min(rise * texel, carried) : (carried - most) * kLeave;
            if (left > 0) leave(land, p, left, moves);
            carried -= std::max(left, 0.0f);
        } else {
            carried += take(land, d.x, d.y, std::min((most - carried) * kTake, -rise * texel), moves);
        }
        d = {d.x + wayX, d.y + wayY};
        p = next;
        speed = std::sqrt(std::max(0.0f, speed * speed - rise * kGravity));
        water *= 1 - kDry;
    }
    if (carried > 0) leave(land, p, carried, moves);
}

void rain(Land& land, const Stamp& stamp, const BrushSettings& brush) {
    const std::vector<Drop> drops = dropsOf(land, stamp, brush);
    std::vector<std::vector<Move>> moves(std::min(kBatch, drops.size()));
    for (size_t first = 0; first < drops.size(); first += kBatch) {
        const size_t count = std::min(kBatch, drops.size() - first);
        parallelFor(count, [&](size_t i) {
            moves[i].clear();
            runDrop(land, drops[first + i], moves[i]);
        });
        for (size_t i = 0; i < count; ++i)
            for (const Move& m : moves[i]) land.now[m.texel] += m.metres;
    }
}

// --- slopes ------------------------------------------------------------------------------------------------------

constexpr int kSlides = 2;      // rounds a stamp
constexpr float kSlide = 0.1f;  // of what is too steep between two texels, that goes over in a round; 8 of them: below 1

// What a texel gets from its neighbours in a row that lies `rows` away.
void slideRow(const Land& land, int y, int rows, int columns, float steepest, float* __restrict gain) {
    const int begin = std::max(0, -columns), end = land.width - std::max(0, columns);
    const float *h = &land.now[land.at(0, y)], *w = &land.weight[land.at(0, y)];
    const float *other = &land.now[land.at(0, y + rows)] + columns, *otherWeight = &land.weight[land.at(0, y + rows)] +
                                                                                   columns;
    for (int x = begin; x < end; ++x) {
        const float over = other[x] - h[x];
        gain[x] += std::min(w[x], otherWeight[x]) * (positivePart(over - steepest) - positivePart(-over - steepest));
    }
}

void slide(Land& land, const BrushSettings& brush) {
    const double tangent = std::tan(std::clamp<double>(brush.talusDeg, 0, 89.9) * 3.14159265358979323846 / 180);
    std::vector<float> after(land.now.size());
    for (int round = 0; round < kSlides; ++round) {
        parallelFor(static_cast<size_t>(land.height), [&](size_t row) {
            const int y = static_cast<int>(row);
            std::vector<float> gain(static_cast<size_t>(land.width));
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    if ((dx != 0 || dy != 0) && y + dy >= 0 && y + dy < land.height)
                        slideRow(land, y, dy, dx,
                                 static_cast<float>(tangent * std::hypot(dx * land.texelX, dy * land.texelY)),
                                 gain.data());
            const float* h = &land.now[land.at(0, y)];
            float* out = &after[land.at(0, y)];
            for (size_t x = 0; x < gain.size(); ++x) out[x] = h[x] + kSlide * gain[x];
        });
        std::swap(land.now, after);
    }
}

}  // namespace

void applyErode(Map& map, const Stamp& stamp, const BrushSettings& brush) {
    const bool sound = usableBrush(stamp, brush) && map.info().channels == 1 && brush.radius > 0 &&
                       std::isfinite(brush.radius) && std::isfinite(brush.talusDeg) && std::isfinite(brush.water) &&
                       stampTiles(map.info(), stamp).count() > 0;
    if (!sound) return;
    Land land = readLand(map, stamp, brush);
    rain(land, stamp, brush);
    slide(land, brush);
    const TileRange& t = land.tiles;
    std::vector<std::shared_ptr<const Tile>> painted(t.count());
    parallelFor(t.count(), [&](size_t i) {
        const int tx = t.x0 + static_cast<int>(i) % (t.x1 - t.x0), ty = t.y0 + static_cast<int>(i) / (t.x1 - t.x0);
        painted[i] = paintTile(map, tx, ty, stamp, brush, [&](const auto& row) {
            using Real = std::remove_cvref_t<decltype(row.scale)>;
            const Real steps = static_cast<Real>(stepsPerMetre(static_cast<double>(row.scale), brush));
            const size_t from = land.at(row.x0 - land.x0, row.y - land.y0),
                         count = static_cast<size_t>(std::min(kTileSize, land.width - (row.x0 - land.x0)));
            std::fill(row.change, row.change + kTileSize, Real(0));
            for (size_t x = from; x < from + count; ++x)
                row.change[x - from] = (static_cast<Real>(land.now[x]) - static_cast<Real>(land.before[x])) * steps;
        });
    });
    for (size_t i = 0; i < painted.size(); ++i)
        map.setTile(t.x0 + static_cast<int>(i) % (t.x1 - t.x0), t.y0 + static_cast<int>(i) / (t.x1 - t.x0),
                    std::move(painted[i]));
}

}  // namespace sward
