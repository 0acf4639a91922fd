#include "brushes/shape.h"

#include <algorithm>
#include <cmath>

#include "maps/map_io.h"

namespace sward {
namespace {

constexpr int kRim = 3;            // texels of it along a row: one before, two behind
constexpr int kFinestSide = 2048;  // texels

ShapeLevel levelOf(int width, int height) {
    return {width, height, std::vector<float>(size_t(width + kRim) * size_t(height + kRim))};
}
float& texelAt(ShapeLevel& level, int x, int y) {
    return level.texels[size_t(y + 1) * size_t(level.width + kRim) + size_t(x + 1)];
}

ShapeLevel halved(ShapeLevel& fine) {
    ShapeLevel out = levelOf(std::max(1, fine.width / 2), std::max(1, fine.height / 2));
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const int x1 = std::min(2 * x + 1, fine.width - 1), y1 = std::min(2 * y + 1, fine.height - 1);
            const int x0 = std::min(2 * x, x1), y0 = std::min(2 * y, y1);
            texelAt(out, x, y) =
                (texelAt(fine, x0, y0) + texelAt(fine, x1, y0) + texelAt(fine, x0, y1) + texelAt(fine, x1, y1)) / 4;
        }
    return out;
}

// At a place in the level, its rim included.
float lightAt(const ShapeLevel& level, float px, float py) {
    const float x = std::min(std::max(px, 0.0f), static_cast<float>(level.width + 1)),
                y = std::min(std::max(py, 0.0f), static_cast<float>(level.height + 1));
    const int ix = static_cast<int>(x), iy = static_cast<int>(y);
    const float fx = x - static_cast<float>(ix), fy = y - static_cast<float>(iy);
    const float* at = &level.texels[size_t(iy) * size_t(level.width + kRim) + size_t(ix)];
    const float* below = at + level.width + kRim;
    const float upper = at[0] + (at[1] - at[0]) * fx, lower = below[0] + (below[1] - below[0]) * fx;
    return upper + (lower - upper) * fy;
}

// Level texels that half the ring's square is, so that the picture keeps its proportions.
float halfSide(const ShapeLevel& level) { return 0.5f * static_cast<float>(std::max(level.width, level.height)); }

std::vector<float> greyOf(const Map& map) {
    const MapInfo& info = map.info();
    std::vector<float> grey;
    grey.reserve(size_t(info.width) * size_t(info.height));
    for (int y = 0; y < info.height; ++y)
        for (int x = 0; x < info.width; ++x) {
            const float light = info.channels >= 3
                                    ? 0.2126f * map.at(x, y) + 0.7152f * map.at(x, y, 1) + 0.0722f * map.at(x, y, 2)
                                    : map.at(x, y);
            grey.push_back(info.channels % 2 == 0 ? light * map.at(x, y, info.channels - 1) : light);
        }
    return grey;
}

void spread(std::vector<float>& grey) {
    const auto [low, high] = std::minmax_element(grey.begin(), grey.end());
    const float from = *low, span = *high - *low;
    if ((from >= 0 && *high <= 1) || !(span > 0)) return;
    for (float& g : grey) g = (g - from) / span;
}

// --- shapes that are made here

float hash(int x, int y, int salt) {
    uint32_t h = static_cast<uint32_t>(x) * 0x8DA6B343u ^ static_cast<uint32_t>(y) * 0xD8163841u ^
                 static_cast<uint32_t>(salt) * 0xCB1AB31Fu;
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    h = (h ^ (h >> 12)) * 0x297A2D39u;
    return static_cast<float>((h ^ (h >> 15)) >> 8) * 0x1p-24f;
}
float smooth(float t) {
    t = std::clamp(t, 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}
// 1 in the middle, 0 on the ring; x and y in [-1, 1], as for all of these.
float dome(float x, float y) { return smooth(1 - std::hypot(x, y)); }

float square(float, float) { return 1; }

// Drops, the smaller the farther out.
float splatter(float x, float y) {
    float light = 0;
    for (int i = 0; i < 40; ++i) {
        const float far = 0.95f * std::sqrt(hash(i, 0, 1)), way = 6.2831853f * hash(i, 0, 2);
        const float radius = (0.05f + 0.17f * hash(i, 0, 3)) * (1.1f - far);
        light = std::max(light, smooth(2 - 2 * std::hypot(x - far * std::cos(way), y - far * std::sin(way)) / radius));
    }
    return light;
}

// The borders between the cells of scattered points (S. Worley 1996: the second distance less the first).
float cracks(float x, float y) {
    const float px = 4 * x, py = 4 * y;
    const int cx = static_cast<int>(std::floor(px)), cy = static_cast<int>(std::floor(py));
    float first = 9, second = 9;
    for (int j = cy - 1; j <= cy + 1; ++j)
        for (int i = cx - 1; i <= cx + 1; ++i) {
            const float d =
                std::hypot(static_cast<float>(i) + hash(i, j, 4) - px, static_cast<float>(j) + hash(i, j, 5) - py);
            second = std::min(second, std::max(first, d));
            first = std::min(first, d);
        }
    return smooth(1 - (second - first) / 0.22f) * smooth(2 * (1 - std::hypot(x, y)));
}

float valueNoise(float x, float y, int salt) {
    const int ix = static_cast<int>(std::floor(x)), iy = static_cast<int>(std::floor(y));
    const float fx = smooth(x - static_cast<float>(ix)), fy = smooth(y - static_cast<float>(iy));
    const float upper = std::lerp(hash(ix, iy, salt), hash(ix + 1, iy, salt), fx),
                lower = std::lerp(hash(ix, iy + 1, salt), hash(ix + 1, iy + 1, salt), fx);
    return std::lerp(upper, lower, fy);
}

// Ridges on a dome: octaves of folded noise (F. K. Musgrave's ridged multifractal).
float mountain(float x, float y) {
    float sum = 0, gain = 0.5f, size = 3;
    for (int octave = 0; octave < 5; ++octave, gain /= 2, size *= 2) {
        const float fold = 1 - std::abs(2 * valueNoise(size * (x + 3), size * (y + 3), 6 + octave) - 1);
        sum += gain * fold * fold;
    }
    return std::min(1.0f, dome(x, y) * (0.35f + 0.9f * sum));
}

constexpr const char* kNames[] = {"square", "splatter", "cracks", "mountain"};
constexpr float (*kMakers[])(float, float) = {square, splatter, cracks, mountain};
constexpr int kMadeSide = 256;

}  // namespace

ShapePtr makeShape(const std::string& name, int width, int height, std::vector<float> texels) {
    auto shape = std::make_shared<BrushShape>();
    shape->name = name;
    ShapeLevel level = levelOf(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float light = texels[size_t(y) * size_t(width) + size_t(x)];
            texelAt(level, x, y) = light > 0 ? std::min(light, 1.0f) : 0.0f;
        }
    while (std::max(level.width, level.height) > kFinestSide) level = halved(level);
    for (;;) {
        shape->levels.push_back(level);
        if (level.width == 1 && level.height == 1) return shape;
        level = halved(level);
    }
}

Result<ShapePtr> loadShape(const std::filesystem::path& file) {
    MapWish any;
    any.channels = 0;
    const Result<Map> image = readMap(file, any);
    if (!image) return image.error();
    std::vector<float> grey = greyOf(*image);
    spread(grey);
    return makeShape(file.string(), image->info().width, image->info().height, std::move(grey));
}

std::span<const char* const> builtInShapes() { return kNames; }

ShapePtr builtInShape(const std::string& name) {
    for (size_t i = 0; i < std::size(kNames); ++i) {
        if (name != kNames[i]) continue;
        std::vector<float> texels(size_t(kMadeSide) * kMadeSide);
        for (int y = 0; y < kMadeSide; ++y)
            for (int x = 0; x < kMadeSide; ++x)
                texels[size_t(y) * kMadeSide + size_t(x)] =
                    kMakers[i]((static_cast<float>(x) + 0.5f) / (kMadeSide / 2) - 1,
                               (static_cast<float>(y) + 0.5f) / (kMadeSide / 2) - 1);
        return makeShape(name, kMadeSide, kMadeSide, std::move(texels));
    }
    return nullptr;
}

ShapeRows::ShapeRows(const Stamp& stamp, const BrushSettings& brush, int tx, int ty) {
    if (!brush.shape || stamp.acrossX != 0 || stamp.acrossY != 0 || !std::isfinite(stamp.angle)) return;
    const double rx = std::max(stamp.radiusX, 1.0), ry = std::max(stamp.radiusY, 1.0);
    const std::vector<ShapeLevel>& levels = brush.shape->levels;
    const double finest = static_cast<double>(halfSide(levels[0])) / std::min(rx, ry);  // of its texels in the map's
    const double n = std::isfinite(finest) ? std::floor(std::log2(std::max(finest, 1.0))) : 0;
    level_ = &levels[std::min(static_cast<size_t>(n), levels.size() - 1)];
    const double half = static_cast<double>(halfSide(*level_)), c = std::cos(stamp.angle), s = std::sin(stamp.angle);
    const double right = (stamp.flipX ? -half : half) / rx, down = (stamp.flipZ ? -half : half) / ry;
    xx_ = static_cast<float>(c * right), yx_ = static_cast<float>(s * down);
    xy_ = static_cast<float>(-s * right), yy_ = static_cast<float>(c * down);
    const double x = tx * kTileSize + 0.5 - stamp.x, y = ty * kTileSize + 0.5 - stamp.y;
    x0_ = static_cast<float>(0.5 * level_->width + 0.5 + c * right * x + s * down * y);
    y0_ = static_cast<float>(0.5 * level_->height + 0.5 - s * right * x + c * down * y);
}

namespace {
// Narrows [from, to] to the columns i at which low < start + i * step < high.
void narrow(float start, float step, float low, float high, float& from, float& to) {
    if (std::abs(step) < 1e-12f) {
        if (!(start > low && start < high)) to = from - 1;
        return;
    }
    const float a = (low - start) / step, b = (high - start) / step;
    from = std::max(from, std::min(a, b)), to = std::min(to, std::max(a, b));
}
}  // namespace

std::pair<int, int> ShapeRows::columns(int y) const {
    float from = 0, to = kTileSize - 1;
    narrow(x0_ + yx_ * static_cast<float>(y), xx_, 0, static_cast<float>(level_->width + 1), from, to);
    narrow(y0_ + yy_ * static_cast<float>(y), xy_, 0, static_cast<float>(level_->height + 1), from, to);
    if (!(from <= to)) return {0, 0};
    return {static_cast<int>(from), std::min(kTileSize, static_cast<int>(to) + 2)};
}

bool ShapeRows::reachesTile() const {
    for (int y = 0; y < kTileSize && level_; ++y)
        if (columns(y).second > 0) return true;
    return !level_;
}

bool ShapeRows::row(int y, float* light) const {
    const float x0 = x0_ + yx_ * static_cast<float>(y), y0 = y0_ + yy_ * static_cast<float>(y);
    const auto [from, to] = columns(y);
    std::fill(light, light + kTileSize, 0.0f);
    for (int i = from; i < to; ++i)
        light[i] = lightAt(*level_, x0 + xx_ * static_cast<float>(i), y0 + xy_ * static_cast<float>(i));
    return to > 0;
}

float shapeLight(const BrushShape& shape, float x, float y) {
    constexpr int kSide = 64;  // texels enough for a picture of it; those of a small shape are all shown
    size_t coarse = 0;
    while (coarse + 1 < shape.levels.size() &&
           std::max(shape.levels[coarse + 1].width, shape.levels[coarse + 1].height) >= kSide)
        ++coarse;
    const ShapeLevel& level = shape.levels[coarse];
    const float half = halfSide(level);
    return lightAt(level, 0.5f * static_cast<float>(level.width) + 0.5f + half * x,
                   0.5f * static_cast<float>(level.height) + 0.5f + half * y);
}

}  // namespace sward
