#include "world/tile_numbers.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>

namespace sward {
namespace {

template <class T>
void readTexels(const Tile& tile, float most, Numbers& out) {
    const TileTexels texels = tile.texels();
    const T* in = reinterpret_cast<const T*>(texels.data());
    for (size_t i = 0; i < texels.size() / sizeof(T); ++i) out[i] = static_cast<float>(in[i]) / most;
}

template <class T>
void writeTexels(const Numbers& in, size_t width, int height, float most, Tile& tile) {
    T* out = reinterpret_cast<T*>(tile.write());
    const size_t row = tile.heldBytes() / sizeof(T) / kTileSize;
    for (size_t y = 0; y < static_cast<size_t>(height); ++y)
        for (size_t i = y * row; i < y * row + width; ++i) {
            const float unit = in[i] > 0 ? std::min(in[i], 1.0f) : 0.0f;
            out[i] = static_cast<T>(std::is_floating_point_v<T> ? unit : std::round(unit * most));
        }
}

void copyTexels(const Numbers& in, size_t width, int height, Tile& tile) {
    const size_t row = tile.heldBytes() / sizeof(float) / kTileSize;
    for (size_t y = 0; y < static_cast<size_t>(height); ++y)
        std::memcpy(tile.write() + y * row * sizeof(float), &in[y * row], width * sizeof(float));
}

bool meet(const MapBox& a, const MapBox& b) { return a.x0 <= b.x1 && b.x0 <= a.x1 && a.z0 <= b.z1 && b.z0 <= a.z1; }

// Texels of a map: from x0, y0 to before x1, y1.
struct Texels {
    int x0, y0, x1, y1;
};
Texels tileTexels(int tx, int ty) {
    return {tx * kTileSize, ty * kTileSize, (tx + 1) * kTileSize, (ty + 1) * kTileSize};
}

// Texels of a map that lies on the terrain once, and `margin` of them around.
MapBox boxOf(const MapInfo& info, const Texels& t, double margin) {
    return {(t.x0 - margin) / info.width, (t.y0 - margin) / info.height, (t.x1 + margin) / info.width,
            (t.y1 + margin) / info.height};
}

// The smallest rectangle in which two tiles of a map differ; empty (x0 = x1) if they do not.
Texels differing(const Map& map, int tx, int ty, const Tile& a, const Tile& b) {
    const size_t texel = map.texelBytes(), row = texel * kTileSize;
    const TileTexels ofA = a.texels(), ofB = b.texels();
    const auto at = [&](const TileTexels& t, int y) { return t.data() + static_cast<size_t>(y) * row; };
    Texels out{kTileSize, kTileSize, 0, 0};
    for (int y = 0; y < kTileSize; ++y) {
        if (std::equal(at(ofA, y), at(ofA, y) + row, at(ofB, y))) continue;
        out.y0 = std::min(out.y0, y), out.y1 = y + 1;
        const auto first = std::mismatch(at(ofA, y), at(ofA, y) + row, at(ofB, y)).first - at(ofA, y);
        const auto last =
            std::mismatch(std::make_reverse_iterator(at(ofA, y) + row), std::make_reverse_iterator(at(ofA, y)),
                          std::make_reverse_iterator(at(ofB, y) + row))
                .first.base() -
            at(ofA, y);
        out.x0 = std::min(out.x0, static_cast<int>(static_cast<size_t>(first) / texel));
        out.x1 = std::max(out.x1, static_cast<int>((static_cast<size_t>(last) + texel - 1) / texel));
    }
    if (out.x0 >= out.x1) return {0, 0, 0, 0};
    const Texels whole = tileTexels(tx, ty);
    return {whole.x0 + out.x0, whole.y0 + out.y0, whole.x0 + out.x1, whole.y0 + out.y1};
}

}  // namespace

void readTile(const Map& map, int tx, int ty, Numbers& out) {
    const Tile& tile = *map.tile(tx, ty);
    switch (map.info().type) {
        case PixelType::U8:
            return readTexels<uint8_t>(tile, 255, out);
        case PixelType::U16:
            return readTexels<uint16_t>(tile, 65535, out);
        case PixelType::F32:
            return readTexels<float>(tile, 1, out);
    }
}

std::shared_ptr<const Tile> makeTile(const Map& map, int tx, int ty, const Numbers& numbers, NumberRange range) {
    const MapInfo& info = map.info();
    auto made = std::make_shared<Tile>(std::vector<std::byte>(map.tileBytes()));
    const int h = std::min(kTileSize, info.height - ty * kTileSize);
    const size_t w = static_cast<size_t>(std::min(kTileSize, info.width - tx * kTileSize) * info.channels);  // numbers
    switch (info.type) {
        case PixelType::U8:
            writeTexels<uint8_t>(numbers, w, h, 255, *made);
            break;
        case PixelType::U16:
            writeTexels<uint16_t>(numbers, w, h, 65535, *made);
            break;
        case PixelType::F32:
            if (range == NumberRange::Any)
                copyTexels(numbers, w, h, *made);
            else
                writeTexels<float>(numbers, w, h, 1, *made);
            break;
    }
    const std::shared_ptr<const Tile>& before = map.tile(tx, ty);
    return sameTexels(*made, *before) ? before : std::shared_ptr<const Tile>(std::move(made));
}

std::vector<MapBox> changedBoxes(const Map& before, const Map& now) {
    if (before.info() != now.info()) return {kEverywhere};
    std::vector<MapBox> out;
    for (int ty = 0; ty < now.tilesY(); ++ty)
        for (int tx = 0; tx < now.tilesX(); ++tx)
            if (before.tile(tx, ty) != now.tile(tx, ty))
                if (const Texels t = differing(now, tx, ty, *before.tile(tx, ty), *now.tile(tx, ty)); t.x0 < t.x1)
                    out.push_back(boxOf(now.info(), t, 2));
    return out;
}

bool isIn(const std::vector<MapBox>& boxes, double u, double v) {
    return std::any_of(boxes.begin(), boxes.end(), [&](const MapBox& b) { return meet(b, {u, v, u, v}); });
}

std::vector<TilePlace> tilesIn(const Map& map, const std::vector<MapBox>& boxes) {
    std::vector<TilePlace> out;
    for (int ty = 0; ty < map.tilesY(); ++ty)
        for (int tx = 0; tx < map.tilesX(); ++tx)
            if (std::any_of(boxes.begin(), boxes.end(),
                            [&](const MapBox& b) { return meet(b, boxOf(map.info(), tileTexels(tx, ty), 0)); }))
                out.push_back({tx, ty});
    return out;
}

std::vector<TilePlace> tilesThatDiffer(const Map& a, const Map& b) {
    std::vector<TilePlace> out;
    for (int ty = 0; ty < a.tilesY(); ++ty)
        for (int tx = 0; tx < a.tilesX(); ++tx)
            if (a.tile(tx, ty) != b.tile(tx, ty)) out.push_back({tx, ty});
    return out;
}

bool isZero(const Map& map) {
    Numbers numbers(kTileTexels * static_cast<size_t>(map.info().channels));
    for (int ty = 0; ty < map.tilesY(); ++ty)
        for (int tx = 0; tx < map.tilesX(); ++tx) {
            readTile(map, tx, ty, numbers);
            if (std::any_of(numbers.begin(), numbers.end(), [](float v) { return v != 0; })) return false;
        }
    return true;
}

}  // namespace sward
