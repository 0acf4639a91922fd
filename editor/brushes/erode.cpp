// Erodes ground. Rain: drops run downhill, take ground along while they can carry more and leave it where they slow
// down (H. T. Beyer, Implementation of a Method for Hydraulic Erosion, Technische Universitaet Muenchen
// 2015; heights are counted in texels, so that slopes and not metres decide, and drops dry evenly, so that the end of
// the way finds them empty). Slopes: what is steeper than the talus angle slides to its neighbours (F. K. Musgrave, C.
// E. Kolb, R. S. Mace, The Synthesis and Rendering of Eroded Fractal Terrains, SIGGRAPH 1989; between each two
// neighbours as much goes as comes, so that no ground is lost). Both act by the weight of the stamp and move ground
// only within it. Drops start where the stamp's number and the seed say, and those of a batch see the ground as it was
// before the batch: the same on any number of threads. Does not: keep water from stamp to stamp.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "brushes/heights.h"
#include "core/jobs.h"

namespace sward {
namespace {

// The tiles under the stamp as one piece with a rim of one texel, heights in metres above that of one texel. What lies
// beyond the map is as high as its edge, and has no weight, like the rim.
struct Land {
    TileRange tiles;
    int x0 = 0, y0 = 0, width = 0, height = 0;  // texels of the map; width and height whole tiles
    double texelX = 1, texelY = 1;              // metres
    float base = 0, unit = 1;                   // metres: subtracted of all; of one step of the map
    std::unique_ptr<float[]> large;             // their memory, where it is more than is kept from stamp to stamp
    std::span<float> now, weight;               // texels() each
    size_t texels() const { return stride() * size_t(height + 2); }
    size_t stride() const { return size_t(width) + 2; }
    // x from -1 to width, y from -1 to height.
    size_t at(int x, int y) const { return size_t(y + 1) * stride() + size_t(x + 1); }
};

// A height of the map in metres of the land.
float metresOf(const Land& land, float steps) { return steps * land.unit - land.base; }

template <class T>
void readTile(const Map& map, int tx, int ty, Land& land) {
    const TileTexels texels = map.tile(tx, ty)->texels();
    const T* in = reinterpret_cast<const T*>(texels.data());
    const int columns = std::min(kTileSize, map.info().width - tx * kTileSize),
              rows = std::min(kTileSize, map.info().height - ty * kTileSize);
    for (int y = 0; y < kTileSize; ++y) {
        const T* row = in + std::min(y, rows - 1) * kTileSize;
        float* out = &land.now[land.at(tx * kTileSize - land.x0, ty * kTileSize - land.y0 + y)];
        for (int x = 0; x < kTileSize; ++x) out[x] = metresOf(land, static_cast<float>(row[x]));
        std::fill(out + columns, out + kTileSize, out[columns - 1]);
    }
}

void readTile(const Map& map, int tx, int ty, Land& land) {
    switch (map.info().type) {
        case PixelType::U8:
            return readTile<uint8_t>(map, tx, ty, land);
        case PixelType::U16:
            return readTile<uint16_t>(map, tx, ty, land);
        case PixelType::F32:
            return readTile<float>(map, tx, ty, land);
    }
}

double stepsInOne(PixelType type) { return type == PixelType::U8 ? 255 : type == PixelType::U16 ? 65535 : 1; }

// Calls body(tx, ty) for each tile, on all cores.
template <class Body>
void eachTile(const TileRange& t, const Body& body) {
    parallelFor(t.count(), [&](size_t i) {
        body(t.x0 + static_cast<int>(i) % (t.x1 - t.x0), t.y0 + static_cast<int>(i) / (t.x1 - t.x0));
    });
}

// Memory that a thread keeps from stamp to stamp: new pages cost the system more than the stamp's own work on them.
constexpr size_t kMostKept = 8 << 20;  // floats
float* keptMemory(size_t floats) {
    thread_local std::vector<float> kept;
    if (kept.size() < floats) kept.resize(floats);
    return kept.data();
}

// Memory for all texels; those of the rim are 0.
void takeMemory(Land& land) {
    const size_t texels = land.texels(), stride = land.stride();
    if (2 * texels > kMostKept) land.large = std::make_unique_for_overwrite<float[]>(2 * texels);
    float* memory = land.large ? land.large.get() : keptMemory(2 * texels);
    land.now = {memory, texels}, land.weight = {memory + texels, texels};
    for (const std::span<float> part : {land.now, land.weight}) {
        std::fill_n(part.begin(), stride, 0.0f), std::fill_n(part.end() - static_cast<ptrdiff_t>(stride), stride, 0.0f);
        for (size_t at = 0; at < texels; at += stride) part[at] = part[at + stride - 1] = 0;
    }
}

Land readLand(const Map& map, const Stamp& stamp, const BrushSettings& brush) {
    Land land;
    land.tiles = stampTiles(map.info(), stamp);
    const TileRange& t = land.tiles;
    land.x0 = t.x0 * kTileSize, land.y0 = t.y0 * kTileSize;
    land.width = (t.x1 - t.x0) * kTileSize, land.height = (t.y1 - t.y0) * kTileSize;
    land.texelX = static_cast<double>(brush.radius) / stamp.radiusX;
    land.texelY = static_cast<double>(brush.radius) / stamp.radiusY;
    takeMemory(land);
    const int cx = static_cast<int>(std::clamp(stamp.x, 0.0, map.info().width - 1.0)),
              cy = static_cast<int>(std::clamp(stamp.y, 0.0, map.info().height - 1.0));
    land.base = static_cast<float>(static_cast<double>(map.at(cx, cy)) * brush.metres.y);
    land.unit = static_cast<float>(brush.metres.y / stepsInOne(map.info().type));
    eachTile(t, [&](int tx, int ty) {
        readTile(map, tx, ty, land);
        const StampWeights weights(map.info(), stamp, brush, tx, ty);
        for (int y = 0; y < kTileSize; ++y) {
            const size_t at = land.at(tx * kTileSize - land.x0, ty * kTileSize + y - land.y0);
            if (!weights.row(y, &land.weight[at])) std::fill_n(&land.weight[at], kTileSize, 0.0f);
        }
    });
    return land;
}

// --- rain --------------------------------------------------------------------------------------------------------

constexpr double kTexelsPerDrop = 60;  // that a stamp of full water has, one drop to so many
constexpr int kMostDrops = 1000;       // a stamp, whatever its size
constexpr size_t kBatch = 100;
constexpr int kSteps = 48;  // texels that a drop runs at most
constexpr float kInertia = 0.05f, kCapacity = 4, kLeastSlope = 0.01f, kTake = 0.3f, kLeave = 0.3f, kGravity = 1;
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
    const size_t c = land.at(ix, iy), d = c + land.stride();
    const float a = land.now[c], b = land.now[c + 1], e = land.now[d], f = land.now[d + 1];
    const float top = a + (b - a) * fx, low = e + (f - e) * fx;
    const auto mix = [&](const std::span<float>& v) {
        const float up = v[c] + (v[c + 1] - v[c]) * fx, down = v[d] + (v[d + 1] - v[d]) * fx;
        return up + (down - up) * fy;
    };
    out = {(top + (low - top) * fy) * toTexels,
           ((b - a) * (1 - fy) + (f - e) * fy) * toTexels,
           (low - top) * toTexels,
           mix(land.weight),
           c,
           fx,
           fy};
    return out.weight > 0;
}

// Lays `amount` metres of one texel's ground on the four texels around a place, as far as the stamp reaches them.
void leave(const Land& land, const Place& p, float amount, std::vector<Move>& moves) {
    const size_t texels[] = {p.corner, p.corner + 1, p.corner + land.stride(), p.corner + land.stride() + 1};
    float share[] = {(1 - p.fx) * (1 - p.fy), p.fx * (1 - p.fy), (1 - p.fx) * p.fy, p.fx * p.fy}, sum = 0;
    for (int i = 0; i < 4; ++i) sum += share[i] = land.weight[texels[i]] > 0 ? share[i] : 0;
    if (!(sum > 0)) return;
    for (int i = 0; i < 4; ++i)
        if (share[i] > 0) moves.push_back({static_cast<uint32_t>(texels[i]), amount * share[i] / sum});
}

// Takes up to `amount` from around a place, the more the nearer, by the stamp's weight. Returns what came.
float take(const Land& land, float x, float y, float amount, std::vector<Move>& moves) {
    const int cx = static_cast<int>(x + 0.5f), cy = static_cast<int>(y + 0.5f);
    constexpr int kSide = 2 * kReach + 1, kRow = 8;  // rows of whole vectors
    float across[kRow], share[kSide][kRow], sum = 0, taken = 0;
    for (int i = 0; i < kRow; ++i) {
        const float ox = static_cast<float>(cx + i - kReach) - x;
        across[i] = ox * ox;
    }
    for (int j = 0; j < kSide; ++j) {
        const float oy = static_cast<float>(cy + j - kReach) - y, down = oy * oy;
        for (int i = 0; i < kRow; ++i) share[j][i] = static_cast<float>(kReach) - std::sqrt(across[i] + down);
    }
    for (const auto& row : share)
        for (int i = 0; i < kSide; ++i) sum += std::max(0.0f, row[i]);
    const float each = amount / sum;
    for (int j = 0; j < kSide; ++j)
        for (int i = 0; i < kSide; ++i) {
            const int tx = cx + i - kReach, ty = cy + j - kReach;
            if (share[j][i] <= 0 || tx < -1 || ty < -1 || tx > land.width || ty > land.height) continue;
            const float metres = each * share[j][i] * land.weight[land.at(tx, ty)];
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
        water = 1 - static_cast<float>(step + 1) / kSteps;
    }
    if (carried > 0) leave(land, p, carried, moves);
}

// Adds what drops moved to the texels of [first, last), in the order of the drops.
void settle(Land& land, std::span<const std::vector<Move>> moves, size_t first, size_t last) {
    for (const std::vector<Move>& drop : moves)
        for (const Move& m : drop)
            if (m.texel >= first && m.texel < last) land.now[m.texel] += m.metres;
}

void rain(Land& land, const Stamp& stamp, const BrushSettings& brush) {
    const std::vector<Drop> drops = dropsOf(land, stamp, brush);
    thread_local std::vector<std::vector<Move>> kept(kBatch);
    for (size_t first = 0; first < drops.size(); first += kBatch) {
        const std::span<std::vector<Move>> moves(kept.data(), std::min(kBatch, drops.size() - first));
        parallelFor(moves.size(), [&](size_t i) {
            moves[i].clear();
            runDrop(land, drops[first + i], moves[i]);
        });
        const size_t parts = static_cast<size_t>(workerCount()), texels = land.texels();
        parallelFor(parts, [&](size_t i) { settle(land, moves, texels * i / parts, texels * (i + 1) / parts); });
    }
}

// --- slopes ------------------------------------------------------------------------------------------------------

constexpr float kSlide = 0.12f;  // of what is too steep between two texels, that goes over; 8 of them: below 1

// A texel beside another, and how much higher it may be, in metres, before it slides.
struct Neighbour {
    ptrdiff_t to;
    float steepest;
};
using Neighbours = std::array<Neighbour, 8>;
Neighbours neighboursIn(const Land& land, const BrushSettings& brush) {
    const double tangent = std::tan(std::clamp<double>(brush.talusDeg, 0, 89.9) * 3.14159265358979323846 / 180);
    Neighbours around;
    size_t n = 0;
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
            if (dx != 0 || dy != 0)
                around[n++] = {dy * static_cast<ptrdiff_t>(land.stride()) + dx,
                               static_cast<float>(tangent * std::hypot(dx * land.texelX, dy * land.texelY))};
    return around;
}

// What a block of texels gets from its neighbours: what lies over the talus, less what they lie over it themselves. All
// eight in one turn, so that a texel's own height is read once.
void slideBlock(const Land& land, size_t at, const Neighbours& around, float* __restrict gain) {
    const float *h = &land.now[at], *w = &land.weight[at];
    for (int x = 0; x < kPaintBlock; ++x) {
        const auto from = [&](const Neighbour& n) {
            const float over = h[x + n.to] - h[x], other = w[x + n.to], less = w[x] < other ? w[x] : other;
            const float notBelow = over > -n.steepest ? over : -n.steepest;
            return less * (over - (notBelow < n.steepest ? notBelow : n.steepest));
        };
        gain[x] = from(around[0]) + from(around[1]) + from(around[2]) + from(around[3]) + from(around[4]) +
                  from(around[5]) + from(around[6]) + from(around[7]);
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
    const Neighbours around = neighboursIn(land, brush);
    const TileRange& t = land.tiles;
    std::vector<std::shared_ptr<const Tile>> painted(t.count());
    const auto slot = [&](int tx, int ty) { return size_t(ty - t.y0) * size_t(t.x1 - t.x0) + size_t(tx - t.x0); };
    eachTile(t, [&](int tx, int ty) {
        painted[slot(tx, ty)] = paintTile(map, tx, ty, stamp, brush, [&](const auto& row) {
            using Real = std::remove_cvref_t<decltype(row.scale)>;
            const Real steps = static_cast<Real>(stepsPerMetre(static_cast<double>(row.scale), brush));
            const size_t from = land.at(row.x0 - land.x0, row.y - land.y0);
            eachBlock(row, [&](int x) {  // what has no weight neither gives nor takes
                const size_t at = from + static_cast<size_t>(x);
                alignas(64) float gain[kPaintBlock];
                slideBlock(land, at, around, gain);
                const float* now = &land.now[at];
                for (int i = 0; i < kPaintBlock; ++i) {
                    const float before = metresOf(land, static_cast<float>(row.value[x + i]));
                    row.change[x + i] =
                        (static_cast<Real>(now[i] + kSlide * gain[i]) - static_cast<Real>(before)) * steps;
                }
            });
        });
    });
    for (int ty = t.y0; ty < t.y1; ++ty)
        for (int tx = t.x0; tx < t.x1; ++tx) map.setTile(tx, ty, std::move(painted[slot(tx, ty)]));
}

}  // namespace sward
