#include "maps/map.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <map>
#include <mutex>

#include "core/error.h"
#include "core/hash.h"
#include "core/numerics.h"

namespace sward {
namespace {

// One zero tile for each size a tile can have, so that new maps cost nothing and equal zero tiles are seen as equal.
std::shared_ptr<const Tile> zeroTile(size_t bytes) {
    static std::mutex mutex;
    static std::map<size_t, std::shared_ptr<const Tile>> tiles;
    std::lock_guard lock(mutex);
    auto& tile = tiles[bytes];
    if (!tile) tile = std::make_shared<Tile>(std::vector<std::byte>(bytes));
    return tile;
}

float readTexel(const std::byte* p, PixelType type) {
    if (type == PixelType::U8) return static_cast<float>(std::to_integer<int>(*p)) / 255.0f;
    if (type == PixelType::U16) {
        uint16_t v;
        std::memcpy(&v, p, sizeof v);
        return static_cast<float>(v) / 65535.0f;
    }
    float v;
    std::memcpy(&v, p, sizeof v);
    return v;
}

void writeTexel(std::byte* p, PixelType type, float value) {
    if (type == PixelType::F32) {
        std::memcpy(p, &value, sizeof value);
        return;
    }
    const float unit = value > 0 ? std::min(value, 1.0f) : 0.0f;  // NaN becomes 0
    if (type == PixelType::U8) {
        *p = static_cast<std::byte>(std::lround(unit * 255.0f));
        return;
    }
    const auto v = static_cast<uint16_t>(std::lround(unit * 65535.0f));
    std::memcpy(p, &v, sizeof v);
}

// Calls f(tx, byte offset in the row of texels, byte count) for each tile that a row of `width` texels crosses.
template <class F>
void eachRun(int width, size_t texel, F&& f) {
    for (int x = 0; x < width; x += kTileSize)
        f(x / kTileSize, size_t(x) * texel, size_t(std::min(kTileSize, width - x)) * texel);
}

template <class T>
double sumOf(const Tile& tile, int channels, int c, int width, int height) {
    double total = 0;
    const TileTexels texels = tile.texels();
    for (int y = 0; y < height; ++y) {
        std::conditional_t<std::is_floating_point_v<T>, double, uint64_t> row = 0;
        const std::byte* p = texels.data() + size_t(y) * kTileSize * size_t(channels) * sizeof(T);
        for (int x = 0; x < width; ++x) {
            T v;
            std::memcpy(&v, p + (size_t(x) * size_t(channels) + size_t(c)) * sizeof(T), sizeof v);
            row += v;
        }
        total += static_cast<double>(row);
    }
    return total;
}

double sumOf(const Tile& tile, const MapInfo& info, int c, int width, int height) {
    switch (info.type) {
        case PixelType::U8:
            return sumOf<uint8_t>(tile, info.channels, c, width, height) / 255.0;
        case PixelType::U16:
            return sumOf<uint16_t>(tile, info.channels, c, width, height) / 65535.0;
        case PixelType::F32:
            return sumOf<float>(tile, info.channels, c, width, height);
    }
    return 0;
}

}  // namespace

Map::Map(const MapInfo& info) : info_(info) {
    CHECK(info.width >= 1 && info.width <= kMaxMapSide && info.height >= 1 && info.height <= kMaxMapSide);
    CHECK(info.channels >= 1 && info.channels <= 4);
    tiles_.assign(size_t(tilesX()) * size_t(tilesY()), zeroTile(tileBytes()));
}

std::byte* Map::writeTile(int tx, int ty) {
    std::shared_ptr<const Tile>& slot = tiles_[index(tx, ty)];
    if (slot.use_count() != 1 || slot->source()) slot = std::make_shared<Tile>(*slot);
    std::atomic_thread_fence(std::memory_order_acquire);  // another thread may just have let go of the tile
    return const_cast<Tile&>(*slot).write();              // tiles are made non-const; this one is ours alone
}

float Map::at(int x, int y, int c) const {
    x = std::clamp(x, 0, info_.width - 1);
    y = std::clamp(y, 0, info_.height - 1);
    const size_t texel = size_t(y % kTileSize) * kTileSize + size_t(x % kTileSize);
    const Tile& t = *tiles_[index(x / kTileSize, y / kTileSize)];
    return readTexel(t.look() + (texel * size_t(info_.channels) + size_t(c)) * pixelBytes(info_.type), info_.type);
}

void Map::set(int x, int y, int c, float value) {
    CHECK(x >= 0 && y >= 0 && x < info_.width && y < info_.height && c >= 0 && c < info_.channels);
    const size_t texel = size_t(y % kTileSize) * kTileSize + size_t(x % kTileSize);
    std::byte* tile = writeTile(x / kTileSize, y / kTileSize);
    writeTexel(tile + (texel * size_t(info_.channels) + size_t(c)) * pixelBytes(info_.type), info_.type, value);
}

float Map::sample(double u, double v, int c) const {
    const auto inside = [](double t) { return t > 0 ? std::min(t, 1.0) : 0.0; };  // NaN becomes 0
    const f64::BilinearTap t = f64::bilinearTap(inside(u), inside(v), info_.width, info_.height);
    return f32::bilinearMix(at(t.x0, t.y0, c), at(t.x1, t.y0, c), at(t.x0, t.y1, c), at(t.x1, t.y1, c),
                            static_cast<float>(t.fx), static_cast<float>(t.fy));
}

void Map::readRows(int y0, int rows, void* out) const {
    CHECK(y0 >= 0 && rows >= 0 && y0 + rows <= info_.height);
    const size_t rowBytes = size_t(info_.width) * texelBytes(), tileRow = size_t(kTileSize) * texelBytes();
    for (int y = y0; y < y0 + rows; ++y) {
        std::byte* row = static_cast<std::byte*>(out) + size_t(y - y0) * rowBytes;
        eachRun(info_.width, texelBytes(), [&](int tx, size_t offset, size_t bytes) {
            const std::byte* in = tiles_[index(tx, y / kTileSize)]->look() + size_t(y % kTileSize) * tileRow;
            std::memcpy(row + offset, in, bytes);
        });
    }
}

void Map::writeRows(int y0, int rows, const void* in) {
    CHECK(y0 >= 0 && rows >= 0 && y0 + rows <= info_.height);
    const size_t rowBytes = size_t(info_.width) * texelBytes(), tileRow = size_t(kTileSize) * texelBytes();
    for (int y = y0; y < y0 + rows; ++y) {
        const std::byte* row = static_cast<const std::byte*>(in) + size_t(y - y0) * rowBytes;
        eachRun(info_.width, texelBytes(), [&](int tx, size_t offset, size_t bytes) {
            std::memcpy(writeTile(tx, y / kTileSize) + size_t(y % kTileSize) * tileRow, row + offset, bytes);
        });
    }
}

uint64_t Map::hash() const {
    Hasher hasher;
    const int32_t head[3] = {info_.width, info_.height, info_.channels};
    hasher.add(head, sizeof head);
    const size_t tileRow = size_t(kTileSize) * texelBytes();
    for (int y = 0; y < info_.height; ++y)
        eachRun(info_.width, texelBytes(), [&](int tx, size_t, size_t bytes) {
            hasher.add(tiles_[index(tx, y / kTileSize)]->look() + size_t(y % kTileSize) * tileRow, bytes);
        });
    return hasher.value();
}

double Map::mean(int c) const {
    if (empty()) return 0;
    CHECK(c >= 0 && c < info_.channels);
    double total = 0;
    for (int ty = 0; ty < tilesY(); ++ty)
        for (int tx = 0; tx < tilesX(); ++tx)
            total += sumOf(*tile(tx, ty), info_, c, std::min(kTileSize, info_.width - tx * kTileSize),
                           std::min(kTileSize, info_.height - ty * kTileSize));
    return total / (double(info_.width) * info_.height);
}

}  // namespace sward
