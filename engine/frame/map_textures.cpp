#include "frame/map_textures.h"

#include <algorithm>
#include <cstring>

#include "core/jobs.h"
#include "core/numerics.h"

namespace sward {
namespace {

struct Format {
    GLenum internal, layout, type;
};
Format formatOf(const MapInfo& info, bool srgb) {
    static constexpr GLenum kLayout[] = {GL_RED, GL_RG, GL_RGB, GL_RGBA};
    static constexpr GLenum k8[] = {GL_R8, GL_RG8, GL_RGB8, GL_RGBA8}, k16[] = {GL_R16, GL_RG16, GL_RGB16, GL_RGBA16},
                            k32[] = {GL_R32F, GL_RG32F, GL_RGB32F, GL_RGBA32F};
    const size_t c = static_cast<size_t>(info.channels - 1);
    switch (info.type) {
        case PixelType::U8:
            return {srgb && info.channels == 4 ? GLenum(GL_SRGB8_ALPHA8) : k8[c], kLayout[c], GL_UNSIGNED_BYTE};
        case PixelType::U16:
            return {k16[c], kLayout[c], GL_UNSIGNED_SHORT};
        default:
            return {k32[c], kLayout[c], GL_FLOAT};
    }
}

template <class T>
T meanOf(T a, T b, T c, T d) {
    if constexpr (std::is_floating_point_v<T>)
        return (a + b + c + d) * 0.25f;
    else
        return static_cast<T>((uint32_t(a) + b + c + d + 2) / 4);
}

// Two rows of one channel to one of n texels: a loop that compilers take several texels at a time of.
template <class T>
void halveRows(const T* upper, const T* lower, int n, T* out) {
    for (int x = 0; x < n; ++x) out[x] = meanOf(upper[2 * x], upper[2 * x + 1], lower[2 * x], lower[2 * x + 1]);
}

// Halves an image; odd edges repeat their last texel. `stride` in texels.
template <class T>
std::vector<T> halve(const T* in, int width, int height, int stride, int channels) {
    const int w = std::max(width / 2, 1), h = std::max(height / 2, 1);
    std::vector<T> out(static_cast<size_t>(w) * h * channels);
    if (channels == 1 && width > 1 && height > 1) {
        for (int y = 0; y < h; ++y)
            halveRows(in + size_t(2 * y) * size_t(stride), in + size_t(2 * y + 1) * size_t(stride), w,
                      out.data() + size_t(y) * size_t(w));
        return out;
    }
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            const int x1 = std::min(2 * x + 1, width - 1), y1 = std::min(2 * y + 1, height - 1);
            for (int c = 0; c < channels; ++c) {
                const auto at = [&](int i, int j) { return in[(static_cast<size_t>(j) * stride + i) * channels + c]; };
                out[(static_cast<size_t>(y) * w + x) * channels + c] =
                    meanOf(at(2 * x, 2 * y), at(x1, 2 * y), at(2 * x, y1), at(x1, y1));
            }
        }
    return out;
}

// A tile's part of a texture's levels: its own texels, and what is filtered from them.
template <class T>
struct LevelChain {
    TileTexels texels{nullptr, 0};  // of the tile
    std::vector<T> linear;          // the same decoded, where level 0 is that
    struct Level {
        const T* pixels;
        int stride, width, height;  // in texels
    };
    std::vector<Level> levels;
    std::vector<std::vector<T>> filtered;  // of levels from 1 on
};

uint16_t decoded(uint16_t v) {
    static const std::vector<uint16_t> table = [] {
        std::vector<uint16_t> t(65536);
        for (size_t i = 0; i < t.size(); ++i)
            t[i] = static_cast<uint16_t>(std::lround(65535 * f32::srgbDecode(static_cast<float>(i) / 65535)));
        return t;
    }();
    return table[v];
}
float decoded(float v) { return f32::srgbDecode(v); }

// A tile of colours as linear light; opacities as they are. For types that the GPU has no sRGB format of.
template <class T>
std::vector<T> decodedTile(const T* texels) {
    std::vector<T> out(texels, texels + size_t(kTileSize) * kTileSize * 4);
    for (size_t i = 0; i < out.size(); ++i)
        if (i % 4 != 3) out[i] = decoded(out[i]);
    return out;
}

constexpr int kTileLevels = 7;  // 128 = 2^7

// Of a tile of which width x height texels lie in the map.
template <class T>
LevelChain<T> chainOf(const Tile& tile, int width, int height, int channels, bool srgb) {
    LevelChain<T> chain;
    chain.texels = tile.texels();
    const T* pixels = reinterpret_cast<const T*>(chain.texels.data());
    if constexpr (!std::is_same_v<T, uint8_t>)
        if (srgb && channels == 4) chain.linear = decodedTile(pixels), pixels = chain.linear.data();
    chain.levels.push_back({pixels, kTileSize, width, height});
    for (int l = 1; l <= kTileLevels; ++l) {
        const auto& [in, stride, w, h] = chain.levels.back();
        chain.filtered.push_back(halve(in, w, h, stride, channels));
        const int halfWidth = std::max(w / 2, 1), halfHeight = std::max(h / 2, 1);
        chain.levels.push_back({chain.filtered.back().data(), halfWidth, halfWidth, halfHeight});
    }
    return chain;
}

// Uploads it to where the tile lies: x, y of level 0. Returns the bytes filtered and sent.
template <class T>
uint64_t uploadChain(const Texture& t, const Format& f, const LevelChain<T>& chain, int x, int y, int channels) {
    uint64_t bytes = 0;
    for (int l = 0; l <= kTileLevels; ++l, x /= 2, y /= 2) {
        const auto& [pixels, stride, width, height] = chain.levels[static_cast<size_t>(l)];
        const bool inside = x + width <= std::max(t.width >> l, 1) && y + height <= std::max(t.height >> l, 1);
        glPixelStorei(GL_UNPACK_ROW_LENGTH, stride);
        if (inside && l < t.levels) glTextureSubImage2D(t.id(), l, x, y, width, height, f.layout, f.type, pixels);
        bytes += static_cast<uint64_t>(width) * height * channels * sizeof(T);
    }
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    return bytes;
}

template <class F>
void withPixelType(PixelType type, F&& f) {
    switch (type) {
        case PixelType::U8:
            return f(uint8_t{});
        case PixelType::U16:
            return f(uint16_t{});
        case PixelType::F32:
            return f(float{});
    }
}

}  // namespace

GLuint MapTextures::shared(const std::string& path) const {
    const auto found = entries_.find(path);
    return found != entries_.end() && found->second.used ? found->second.texture.id() : 0;
}

GLuint MapTextures::get(const std::string& owner, const std::string& key, const Map& map, bool srgb, bool repeat) {
    Entry& e = entries_[key];
    e.used = true;
    const MapInfo& info = map.info();
    const Format f = formatOf(info, srgb);
    const bool fresh = !(e.last.info() == info) || e.texture.format != f.internal || e.repeat != repeat;
    if (fresh) {
        e.repeat = repeat;
        e.texture = makeTexture2D(gpu_, owner, f.internal, info.width, info.height, 0, repeat);
        e.coarse.assign(static_cast<size_t>(map.tilesX()) * map.tilesY() * map.texelBytes(), std::byte{});
    } else if (e.last.sameTiles(map)) {
        return e.texture.id();
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    std::vector<int> row;
    for (int ty = 0; ty < map.tilesY(); ++ty, row.clear()) {
        for (int tx = 0; tx < map.tilesX(); ++tx)
            if (fresh || e.last.tile(tx, ty) != map.tile(tx, ty)) row.push_back(tx);
        uploadTiles(e, srgb, map, row, ty);
    }
    uploadCoarse(e, srgb, map);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    e.last = map;
    return e.texture.id();
}

// Of a row of tiles: read and filtered on all cores, sent by this thread.
void MapTextures::uploadTiles(Entry& e, bool srgb, const Map& map, const std::vector<int>& columns, int ty) {
    const MapInfo& info = map.info();
    const int y = ty * kTileSize, h = std::min(kTileSize, info.height - y);
    withPixelType(info.type, [&](auto zero) {
        using T = decltype(zero);
        std::vector<LevelChain<T>> chains(columns.size());
        parallelFor(columns.size(), [&](size_t i) {
            const int w = std::min(kTileSize, info.width - columns[i] * kTileSize);
            chains[i] = chainOf<T>(*map.tile(columns[i], ty), w, h, info.channels, srgb);
        });
        for (size_t i = 0; i < columns.size(); ++i) {
            uploaded_ +=
                uploadChain(e.texture, formatOf(info, srgb), chains[i], columns[i] * kTileSize, y, info.channels);
            std::memcpy(&e.coarse[(static_cast<size_t>(ty) * map.tilesX() + columns[i]) * map.texelBytes()],
                        chains[i].levels.back().pixels, map.texelBytes());
        }
    });
}

void MapTextures::uploadCoarse(Entry& e, bool srgb, const Map& map) {
    const MapInfo& info = map.info();
    withPixelType(info.type, [&](auto zero) {
        using T = decltype(zero);
        std::vector<T> level(e.coarse.size() / sizeof(T));
        std::memcpy(level.data(), e.coarse.data(), e.coarse.size());
        const Format f = formatOf(info, srgb);
        int w = map.tilesX(), h = map.tilesY();
        for (int l = kTileLevels; l < e.texture.levels; ++l) {
            const int lw = std::max(info.width >> l, 1), lh = std::max(info.height >> l, 1);
            glPixelStorei(GL_UNPACK_ROW_LENGTH, w);
            glTextureSubImage2D(e.texture.id(), l, 0, 0, std::min(lw, w), std::min(lh, h), f.layout, f.type,
                                level.data());
            level = halve(level.data(), w, h, w, info.channels);
            w = std::max(w / 2, 1), h = std::max(h / 2, 1);
        }
        glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    });
}

void MapTextures::beginFrame() {
    uploaded_ = 0;
    for (auto& [key, e] : entries_) e.used = false;
}
void MapTextures::endFrame() {
    std::erase_if(entries_, [](const auto& p) { return !p.second.used; });
}

}  // namespace sward
