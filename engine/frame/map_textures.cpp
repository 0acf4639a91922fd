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

// A colour's number as light, and back: 8 bits are encoded as sRGB, others are light already (decodedTile).
float linearOf(uint8_t v) {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> t{};
        for (size_t i = 0; i < t.size(); ++i) t[i] = f32::srgbDecode(static_cast<float>(i) / 255);
        return t;
    }();
    return table[v];
}
float linearOf(uint16_t v) { return v; }
float linearOf(float v) { return v; }
template <class T>
T storedAs(float light) {
    if constexpr (std::is_same_v<T, uint8_t>) {
        static const std::vector<uint8_t> table = [] {  // finer than the darkest steps of sRGB's 8 bits
            std::vector<uint8_t> t(16384);
            for (size_t i = 0; i < t.size(); ++i)
                t[i] = static_cast<uint8_t>(
                    std::lround(255 * f32::srgbEncode(static_cast<float>(i) / static_cast<float>(t.size() - 1))));
            return t;
        }();
        return table[static_cast<size_t>(std::clamp(light, 0.0f, 1.0f) * static_cast<float>(table.size() - 1) + 0.5f)];
    } else if constexpr (std::is_same_v<T, uint16_t>) {
        return static_cast<T>(std::lround(std::clamp(light, 0.0f, 65535.0f)));
    } else {
        return light;
    }
}

// A weighted mean of texels; of colours also by their opacity.
template <class T>
struct TexelMean {
    float sums[4] = {}, plain[3] = {}, weight = 0;
    void add(const T* t, int channels, float by, bool colour) {
        weight += by;
        if (!colour) {
            for (int c = 0; c < channels; ++c) sums[c] += by * static_cast<float>(t[c]);
            return;
        }
        const float opaque = by * static_cast<float>(t[3]);
        for (int c = 0; c < 3; ++c) sums[c] += opaque * linearOf(t[c]), plain[c] += by * linearOf(t[c]);
        sums[3] += opaque;
    }
    void store(std::vector<T>& out, int channels, bool colour) const {
        const auto rounded = [](float v) {
            if constexpr (std::is_floating_point_v<T>)
                return v;
            else
                return static_cast<T>(v + 0.5f);
        };
        for (int c = 0; c < (colour ? 3 : channels); ++c)
            out.push_back(colour ? storedAs<T>(sums[3] > 0 ? sums[c] / sums[3] : plain[c] / weight)
                                 : rounded(sums[c] / weight));
        if (colour) out.push_back(rounded(sums[3] / weight));
    }
};

// Two rows of one channel to one of n texels: a loop that compilers take several texels at a time of.
template <class T>
void halveRows(const T* upper, const T* lower, int n, T* out) {
    for (int x = 0; x < n; ++x) out[x] = meanOf(upper[2 * x], upper[2 * x + 1], lower[2 * x], lower[2 * x + 1]);
}

// Halves an image; odd edges repeat their last texel. `stride` in texels. Colours count by their opacity: what is
// transparent has none that may show.
template <class T>
std::vector<T> halve(const T* in, int width, int height, int stride, int channels, bool colour) {
    const int w = (width + 1) / 2, h = (height + 1) / 2;
    std::vector<T> out;
    out.reserve(static_cast<size_t>(w) * h * channels);
    for (int y = 0; y < h; ++y) {
        const int paired = channels == 1 && 2 * y + 1 < height ? width / 2 : 0;
        out.resize(out.size() + static_cast<size_t>(paired));
        if (paired > 0)
            halveRows(in + size_t(2 * y) * size_t(stride), in + size_t(2 * y + 1) * size_t(stride), paired,
                      out.data() + size_t(y) * size_t(w));
        for (int x = paired; x < w; ++x) {
            const int x1 = std::min(2 * x + 1, width - 1), y1 = std::min(2 * y + 1, height - 1);
            const auto at = [&](int i, int j) { return in + (static_cast<size_t>(j) * stride + i) * channels; };
            const T* four[] = {at(2 * x, 2 * y), at(x1, 2 * y), at(2 * x, y1), at(x1, y1)};
            if (colour) {
                TexelMean<T> mean;
                for (const T* t : four) mean.add(t, channels, 0.25f, true);
                mean.store(out, channels, true);
            } else {
                for (int c = 0; c < channels; ++c)
                    out.push_back(meanOf(four[0][c], four[1][c], four[2][c], four[3][c]));
            }
        }
    }
    return out;
}

// Exact halves that cover a map's width or height: of its last ones a part may lie outside of it.
int halvesOf(int texels, int level) { return (texels + (1 << level) - 1) >> level; }

// Of a map's width or height: the texels of a level as the GPU counts them, each over as much of the map as the others.
struct Fitted {
    int count;     // of the level
    double reach;  // exact halves that one of them covers: 1, or a little more
};
Fitted fitted(int texels, int level) {
    const int count = std::max(texels >> level, 1);
    return {count, static_cast<double>(texels) / static_cast<double>(1 << level) / count};
}

// Which of so many exact halves a level's texel lies over, by what share.
struct Overlaps {
    int first, count = 0;
    float weights[3];  // their sum is 1
    Overlaps(int texel, double reach, int halves) {
        const double from = texel * reach, to = from + reach;
        first = std::min(static_cast<int>(from), halves - 1);
        for (int k = first; k < std::min(halves, first + 3) && k < to; ++k)
            weights[count++] = static_cast<float>((std::min(to, k + 1.0) - std::max(from, double(k))) / reach);
    }
};

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
        chain.filtered.push_back(halve(in, w, h, stride, channels, srgb && channels == 4));
        const int halfWidth = (w + 1) / 2, halfHeight = (h + 1) / 2;
        chain.levels.push_back({chain.filtered.back().data(), halfWidth, halfWidth, halfHeight});
    }
    return chain;
}

struct Rect {
    int x0, y0, x1, y1;
};
// A rectangle of a level's texels, each the mean of the exact halves that it lies over.
template <class T>
std::vector<T> refit(const std::vector<T>& halves, int width, int height, const Fitted (&to)[2], const Rect& r,
                     int channels, bool colour) {
    std::vector<T> out;
    out.reserve(static_cast<size_t>(r.x1 - r.x0) * (r.y1 - r.y0) * channels);
    for (int y = r.y0; y < r.y1; ++y)
        for (int x = r.x0; x < r.x1; ++x) {
            const Overlaps across(x, to[0].reach, width), along(y, to[1].reach, height);
            TexelMean<T> mean;
            for (int j = 0; j < along.count; ++j)
                for (int i = 0; i < across.count; ++i)
                    mean.add(&halves[(size_t(along.first + j) * width + across.first + i) * channels], channels,
                             across.weights[i] * along.weights[j], colour);
            mean.store(out, channels, colour);
        }
    return out;
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
        e.halves.assign(kTileLevels + 1, {});
        for (int l = 1; l <= kTileLevels; ++l)
            if (l == kTileLevels || fitted(info.width, l).reach > 1 || fitted(info.height, l).reach > 1)
                e.halves[static_cast<size_t>(l)].resize(static_cast<size_t>(halvesOf(info.width, l)) *
                                                        halvesOf(info.height, l) * map.texelBytes());
    } else if (e.last.sameTiles(map)) {
        return e.texture.id();
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    std::vector<int> row;
    Changed changed{map.tilesX(), map.tilesY(), 0, 0};
    for (int ty = 0; ty < map.tilesY(); ++ty, row.clear()) {
        for (int tx = 0; tx < map.tilesX(); ++tx)
            if (fresh || e.last.tile(tx, ty) != map.tile(tx, ty)) row.push_back(tx);
        if (row.empty()) continue;
        uploadTiles(e, srgb, map, row, ty);
        changed = {std::min(changed.x0, row.front()), std::min(changed.y0, ty), std::max(changed.x1, row.back()), ty};
    }
    uploadRest(e, srgb, map, changed);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    e.last = map;
    return e.texture.id();
}

// Of a row of tiles: read and filtered on all cores, sent by this thread.
void MapTextures::uploadTiles(Entry& e, bool srgb, const Map& map, const std::vector<int>& columns, int ty) {
    const MapInfo& info = map.info();
    const int h = std::min(kTileSize, info.height - ty * kTileSize);
    const Format f = formatOf(info, srgb);
    withPixelType(info.type, [&](auto zero) {
        using T = decltype(zero);
        std::vector<LevelChain<T>> chains(columns.size());
        parallelFor(columns.size(), [&](size_t i) {
            const int w = std::min(kTileSize, info.width - columns[i] * kTileSize);
            chains[i] = chainOf<T>(*map.tile(columns[i], ty), w, h, info.channels, srgb);
        });
        for (size_t i = 0; i < columns.size(); ++i)
            for (int l = 0; l <= kTileLevels; ++l) {
                const auto& [pixels, stride, width, height] = chains[i].levels[static_cast<size_t>(l)];
                const int x = columns[i] * kTileSize >> l, y = ty * kTileSize >> l;
                uploaded_ += static_cast<uint64_t>(width) * height * map.texelBytes();
                std::vector<std::byte>& kept = e.halves[static_cast<size_t>(l)];
                if (kept.empty()) {
                    glPixelStorei(GL_UNPACK_ROW_LENGTH, stride);
                    if (l < e.texture.levels)
                        glTextureSubImage2D(e.texture.id(), l, x, y, width, height, f.layout, f.type, pixels);
                    continue;
                }
                const size_t all = static_cast<size_t>(halvesOf(info.width, l)), bytes = map.texelBytes();
                for (int row = 0; row < height; ++row)
                    std::memcpy(&kept[((static_cast<size_t>(y) + row) * all + x) * bytes],
                                pixels + static_cast<size_t>(row) * stride * info.channels, width * bytes);
            }
    });
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

// The levels that are no exact halves of the map, where tiles have changed; and those beyond the tiles' own.
void MapTextures::uploadRest(Entry& e, bool srgb, const Map& map, const Changed& changed) {
    const MapInfo& info = map.info();
    const Format f = formatOf(info, srgb);
    const bool colour = srgb && info.channels == 4;
    withPixelType(info.type, [&](auto zero) {
        using T = decltype(zero);
        std::vector<T> halves;
        for (int l = 1; l < e.texture.levels; ++l) {
            const int w = halvesOf(info.width, l), h = halvesOf(info.height, l);
            if (l <= kTileLevels) {
                const std::vector<std::byte>& kept = e.halves[static_cast<size_t>(l)];
                if (kept.empty()) continue;
                halves.resize(kept.size() / sizeof(T));
                std::memcpy(halves.data(), kept.data(), kept.size());
            } else {
                const int before = halvesOf(info.width, l - 1);
                halves = halve(halves.data(), before, halvesOf(info.height, l - 1), before, info.channels, colour);
            }
            const Fitted to[2] = {fitted(info.width, l), fitted(info.height, l)};
            const auto low = [&](int tile, const Fitted& axis) {
                return std::max(static_cast<int>(std::ldexp(tile * kTileSize, -l) / axis.reach) - 1, 0);
            };
            const auto high = [&](int tile, const Fitted& axis) {
                return std::min(static_cast<int>(std::ldexp((tile + 1) * kTileSize, -l) / axis.reach) + 2, axis.count);
            };
            const Rect r{low(changed.x0, to[0]), low(changed.y0, to[1]), high(changed.x1, to[0]),
                         high(changed.y1, to[1])};
            const std::vector<T> texels = refit(halves, w, h, to, r, info.channels, colour);
            glTextureSubImage2D(e.texture.id(), l, r.x0, r.y0, r.x1 - r.x0, r.y1 - r.y0, f.layout, f.type,
                                texels.data());
        }
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
