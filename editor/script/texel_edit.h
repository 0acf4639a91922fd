// A loop over the texels of a part of a map, on all cores: how scripts' map operations read and write.
// Does not: know metres, undo or Lua.
#pragma once
#include "core/jobs.h"
#include "maps/map.h"

namespace sward {

// Texels [x0, x1[ by [y0, y1[.
struct TexelRect {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    // No texel lies in it.
    bool empty() const { return x0 >= x1 || y0 >= y1; }
    size_t count() const { return empty() ? 0 : size_t(x1 - x0) * size_t(y1 - y0); }
};

namespace detail {
template <class T>
constexpr float kFullScale = std::is_same_v<T, float> ? 1.0f : static_cast<float>(std::numeric_limits<T>::max());

// Integers are clamped to [0,1] and rounded to nearest; NaN becomes 0.
template <class T>
T storedTexel(float v) {
    if constexpr (std::is_same_v<T, float>)
        return v;
    else
        return static_cast<T>((v > 0 ? std::min(v, 1.0f) : 0.0f) * kFullScale<T> + 0.5f);
}

// f(x, y, texel) over [x0, x1[ of a row that begins at column `left`; what it leaves in `texel` is stored.
template <class T, class F>
void editTileRow(T* row, int x0, int x1, int left, int y, int channels, const F& f) {
    float texel[4] = {};
    for (int x = x0; x < x1; ++x) {
        T* at = row + size_t(x - left) * size_t(channels);
        for (int c = 0; c < channels; ++c) texel[c] = static_cast<float>(at[c]) / kFullScale<T>;
        f(x, y, texel);
        for (int c = 0; c < channels; ++c) at[c] = storedTexel<T>(texel[c]);
    }
}

// The same over pieces that lie in a tile each, on all cores: f(piece, x, y, texel).
template <class T, class F>
void editPiecesAs(Map& map, const std::vector<TexelRect>& pieces, const F& f) {
    const int channels = map.info().channels;
    parallelFor(pieces.size(), [&](size_t i) {
        const TexelRect& r = pieces[i];
        const int tx = r.x0 / kTileSize, ty = r.y0 / kTileSize;
        T* tile = reinterpret_cast<T*>(map.writeTile(tx, ty));  // each piece has a tile of its own
        const auto edit = [&](int x, int y, float* texel) { f(i, x, y, texel); };
        for (int y = r.y0; y < r.y1; ++y)
            editTileRow(tile + size_t(y - ty * kTileSize) * size_t(kTileSize * channels), r.x0, r.x1, tx * kTileSize, y,
                        channels, edit);
    });
}
}  // namespace detail

// The rectangle cut along the edges of the tiles.
inline std::vector<TexelRect> tilePieces(const TexelRect& rect) {
    std::vector<TexelRect> pieces;
    if (rect.empty()) return pieces;
    const auto next = [](int at, int end) { return std::min(end, (at / kTileSize + 1) * kTileSize); };
    for (int y = rect.y0; y < rect.y1; y = next(y, rect.y1))
        for (int x = rect.x0; x < rect.x1; x = next(x, rect.x1))
            pieces.push_back({x, y, next(x, rect.x1), next(y, rect.y1)});
    return pieces;
}

// Calls f(i, x, y, texel) for every texel of each piece i; a piece lies within one tile, and no two in the same. texel
// holds the channels as numbers (integers as [0,1]) and is stored back. f is called from several threads.
template <class F>
void editPieces(Map& map, const std::vector<TexelRect>& pieces, const F& f) {
    switch (map.info().type) {
        case PixelType::U8:
            return detail::editPiecesAs<uint8_t>(map, pieces, f);
        case PixelType::U16:
            return detail::editPiecesAs<uint16_t>(map, pieces, f);
        case PixelType::F32:
            return detail::editPiecesAs<float>(map, pieces, f);
    }
}
// The same for a whole map: f(x, y, texel).
template <class F>
void editTexels(Map& map, const F& f) {
    editPieces(map, tilePieces({0, 0, map.info().width, map.info().height}),
               [&](size_t, int x, int y, float* texel) { f(x, y, texel); });
}

}  // namespace sward
