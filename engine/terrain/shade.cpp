#include "terrain/shade.h"

#include "core/jobs.h"
#include "frame/draw_context.h"
#include "scene/tiling.h"

namespace sward {
namespace {

constexpr const char* kOwner = "terrain/shade";
constexpr int kMaxSide = 1024;
constexpr float kNothing = -1e6f;  // metres: no ground lies so low

struct ShadeState : EffectState {
    Map of;  // the heights below were taken from
    glm::dvec2 range{0}, size{0}, repeat{0};
    HeightGrid heights;
    glm::vec3 sun{0};  // that the texture was made for
    Texture texture;
};

}  // namespace

HeightGrid shadeHeights(const Terrain& t) {
    if (!t.height.present()) return {1, 1, {0}};
    const MapInfo& info = t.height.map.info();
    const glm::dvec2 repeats = t.size / tilingOf(t, t.heightTiling).metres;
    const auto side = [](double texels) {
        return static_cast<int>(std::clamp(std::ceil(texels), 1.0, static_cast<double>(kMaxSide)));
    };
    HeightGrid g{side(info.width * repeats.x), side(info.height * repeats.y), {}};
    g.metres.resize(static_cast<size_t>(g.width) * static_cast<size_t>(g.height));
    parallelFor(static_cast<size_t>(g.height), [&](size_t y) {
        for (int x = 0; x < g.width; ++x)
            g.metres[y * static_cast<size_t>(g.width) + static_cast<size_t>(x)] = static_cast<float>(
                terrainHeight(t, (x + 0.5) / g.width * t.size.x, (static_cast<double>(y) + 0.5) / g.height * t.size.y));
    });
    return g;
}

namespace {

// The grid as lines across the sun's way, the nearest to the sun first, whichever way that is.
struct Lines {
    int count, length;
    double shift;  // texels along a line that the ray moves towards the sun from line to line
    float fall;    // metres that the ray comes down on the way
    std::function<size_t(int line, int i)> at;
};
std::optional<Lines> linesOf(const HeightGrid& g, const glm::dvec2& size, const glm::vec3& sun) {
    const glm::dvec2 way(sun.x * g.width / size.x, sun.z * g.height / size.y);  // towards the sun, in texels
    const bool rows = std::abs(way.y) >= std::abs(way.x);
    const double main = rows ? way.y : way.x, side = rows ? way.x : way.y;
    if (std::abs(main) < 1e-9) return {};  // the sun stands in the zenith
    const int count = rows ? g.height : g.width;
    const auto at = [=, width = static_cast<size_t>(g.width)](int line, int i) {
        const size_t l = static_cast<size_t>(main > 0 ? count - 1 - line : line), k = static_cast<size_t>(i);
        return rows ? l * width + k : k * width + l;
    };
    return Lines{count, rows ? g.width : g.height, side / std::abs(main), static_cast<float>(sun.y / std::abs(main)),
                 at};
}

float along(const std::vector<float>& values, const Lines& l, int line, double x) {
    x = std::clamp(x, 0.0, l.length - 1.0);
    const int a = static_cast<int>(x), b = std::min(a + 1, l.length - 1);
    const float low = values[l.at(line, a)];
    return low + (values[l.at(line, b)] - low) * static_cast<float>(x - a);
}

}  // namespace

// Rays run side by side over the lines, one texel apart, each with the height of the highest that it passed: heights
// are interpolated once onto a ray and once back, so that a peak's shadow does not wash out with distance.
HeightGrid hiddenHeights(const HeightGrid& heights, const glm::dvec2& size, const glm::vec3& sun) {
    HeightGrid out{heights.width, heights.height, std::vector<float>(heights.metres.size(), kNothing)};
    const std::optional<Lines> lines = linesOf(heights, size, sun);
    if (!lines) return out;
    const Lines& l = *lines;
    const double drift = -l.shift * (l.count - 1);  // of a ray from the first line to the last
    const int first = static_cast<int>(std::floor(std::min(0.0, -drift))) - 1,
              last = l.length + static_cast<int>(std::ceil(std::max(0.0, -drift))) + 1;
    std::vector<float> top(static_cast<size_t>(last - first + 1), kNothing);
    for (int line = 0; line < l.count; ++line) {
        const double offset = -l.shift * line;  // ray j crosses this line at j + offset
        const int begin = static_cast<int>(std::floor(-offset)), end = begin + l.length;
        const float share = static_cast<float>(-offset - begin);
        for (int j = begin; j <= end; ++j) top[static_cast<size_t>(j - first)] -= l.fall;
        for (int i = 0; i < l.length; ++i) {
            const float* two = &top[static_cast<size_t>(begin + i - first)];
            out.metres[l.at(line, i)] = two[0] + (two[1] - two[0]) * share;
        }
        for (int j = begin; j <= end; ++j) {
            float& t = top[static_cast<size_t>(j - first)];
            t = std::max(t, along(heights.metres, l, line, j + offset));
        }
    }
    return out;
}

namespace {

void updateHeights(ShadeState& s, const Terrain& t) {
    const glm::dvec2 repeat = tilingOf(t, t.heightTiling).metres;
    if (!s.heights.metres.empty() && s.of.sameTiles(t.height.map) && s.range == t.heightRange && s.size == t.size &&
        s.repeat == repeat)
        return;
    s.of = t.height.map, s.range = t.heightRange, s.size = t.size, s.repeat = repeat;
    s.heights = shadeHeights(t);
    s.sun = glm::vec3(0);
}

void shade(DrawContext& ctx) {
    ShadeState& s = ctx.own<ShadeState>();
    const glm::vec3 sun = ctx.globals.sunDirection;
    if (ctx.globals.sunIsUp <= 0) return;
    const Terrain& t = *ctx.shared.ground.terrain;
    updateHeights(s, t);
    if (s.sun != sun) {
        s.sun = sun;
        const HeightGrid hidden = hiddenHeights(s.heights, t.size, sun);
        if (s.texture.width != hidden.width || s.texture.height != hidden.height)
            s.texture = makeTexture2D(ctx.gpu, kOwner, GL_R32F, hidden.width, hidden.height);
        glTextureSubImage2D(s.texture.id(), 0, 0, 0, hidden.width, hidden.height, GL_RED, GL_FLOAT,
                            hidden.metres.data());
    }
    glBindTextureUnit(TEX_SHADE, s.texture.id());
}

const System kSystems[] = {{"terrain/shade", shade}};

}  // namespace

const EffectRow& shadeEffect() {
    static const EffectRow row{
        "terrain/shade",
        featureSet(Feature::TerrainShadows, Feature::Terrain),
        kSystems,
        {},
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<ShadeState>(); },
        "hills shade what lies behind them"};
    return row;
}

}  // namespace sward
