#include "terrain/shade.h"

#include <utility>

#include "core/error.h"
#include "core/jobs.h"
#include "core/numerics.h"
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
    HeightGrid hidden;
    glm::vec3 sun{0};  // that it and the texture were made for
    Texture texture;
};

}  // namespace

namespace {

// The two texels that a cell of the grid lies between along one side of the map, and how far from the first.
struct Tap {
    int low, high;
    float share;
};
// Of each cell along a side of `size` metres, on a map that covers `metres` of it with so many texels.
std::vector<Tap> tapsOf(int cells, double size, double metres, bool repeats, int texels) {
    std::vector<Tap> taps;
    for (int i = 0; i < cells; ++i) {
        const double u = (i + 0.5) / cells * size / metres;
        const f64::BilinearTap tap =
            f64::bilinearTap(repeats ? f64::mirrorUnit(u) : std::clamp(u, 0.0, 1.0), 0, texels, 1);
        taps.push_back({tap.x0, tap.x1, static_cast<float>(tap.fx)});
    }
    return taps;
}

// Heights of the grid's cells as terrainHeight has them, without finding their texels anew for each.
class CellHeights {
  public:
    CellHeights(const HeightGrid& g, const Terrain& t) : map_(t.height.map), scale_(heightScale(t)) {
        const Tiling tiling = tilingOf(t, t.heightTiling);
        columns = tapsOf(g.width, t.size.x, tiling.metres.x, tiling.repeats, map_.info().width);
        rows = tapsOf(g.height, t.size.y, tiling.metres.y, tiling.repeats, map_.info().height);
    }
    float at(int x, int y) const {
        const Tap &c = columns[size_t(x)], &r = rows[size_t(y)];
        return static_cast<float>(scale_.first +
                                  scale_.second * f32::bilinearMix(texel(c.low, r.low), texel(c.high, r.low),
                                                                   texel(c.low, r.high), texel(c.high, r.high), c.share,
                                                                   r.share));
    }
    std::vector<Tap> columns, rows;

  private:
    float texel(int x, int y) const {
        const std::byte* tile = map_.tile(x / kTileSize, y / kTileSize)->look();
        const size_t i = size_t(y % kTileSize) * kTileSize + size_t(x % kTileSize);
        switch (map_.info().type) {
            case PixelType::U8:
                return static_cast<float>(reinterpret_cast<const uint8_t*>(tile)[i]) / 255.0f;
            case PixelType::U16:
                return static_cast<float>(reinterpret_cast<const uint16_t*>(tile)[i]) / 65535.0f;
            case PixelType::F32:
                break;
        }
        return reinterpret_cast<const float*>(tile)[i];
    }
    const Map& map_;
    std::pair<double, double> scale_;
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
    const CellHeights cells(g, t);
    parallelFor(static_cast<size_t>(g.height), [&](size_t y) {
        for (int x = 0; x < g.width; ++x)
            g.metres[y * static_cast<size_t>(g.width) + size_t(x)] = cells.at(x, static_cast<int>(y));
    });
    return g;
}

GridPart updateShadeHeights(HeightGrid& g, const Map& before, const Terrain& t) {
    const Map& now = t.height.map;
    CHECK(before.info() == now.info());
    const CellHeights cells(g, t);
    // Of two rows of tiles, which columns have a tile that is another one.
    const auto changedOf = [&](int top, int low, std::vector<char>& changed) {
        bool any = false;
        for (int tx = 0; tx < now.tilesX(); ++tx) {
            changed[size_t(tx)] =
                before.tile(tx, top) != now.tile(tx, top) || before.tile(tx, low) != now.tile(tx, low);
            any = any || changed[size_t(tx)];
        }
        return any;
    };
    std::vector<std::pair<int, int>> part(size_t(g.height), {g.width, 0});  // of each row
    parallelFor(part.size(), [&](size_t y) {
        std::vector<char> changed(size_t(now.tilesX()));
        if (!changedOf(cells.rows[y].low / kTileSize, cells.rows[y].high / kTileSize, changed)) return;
        for (int x = 0; x < g.width; ++x) {
            const Tap& tap = cells.columns[size_t(x)];
            if (!changed[size_t(tap.low / kTileSize)] && !changed[size_t(tap.high / kTileSize)]) continue;
            g.metres[y * static_cast<size_t>(g.width) + size_t(x)] = cells.at(x, static_cast<int>(y));
            part[y] = {std::min(part[y].first, x), x + 1};
        }
    });
    GridPart all{g.width, g.height, 0, 0};
    for (int y = 0; y < g.height; ++y) {
        if (part[size_t(y)].second == 0) continue;
        all = {std::min(all.x0, part[size_t(y)].first), std::min(all.y0, y), std::max(all.x1, part[size_t(y)].second),
               y + 1};
    }
    return all;
}

namespace {

// The grid as lines across the sun's way, the nearest to the sun first, whichever way that is.
struct Lines {
    int count, length;
    double shift;        // texels along a line that the ray moves towards the sun from line to line
    float fall;          // metres that the ray comes down on the way
    bool rows, flipped;  // lines are rows of the grid, else columns; the last one comes first
    int width;           // of the grid
    // Of a line's first texel in the grid, and from one to the next.
    size_t begin(int line) const {
        const size_t l = static_cast<size_t>(flipped ? count - 1 - line : line);
        return rows ? l * static_cast<size_t>(width) : l;
    }
    size_t step() const { return rows ? 1 : static_cast<size_t>(width); }
};
std::optional<Lines> linesOf(const HeightGrid& g, const glm::dvec2& size, const glm::vec3& sun) {
    const glm::dvec2 way(sun.x * g.width / size.x, sun.z * g.height / size.y);  // towards the sun, in texels
    const bool rows = std::abs(way.y) >= std::abs(way.x);
    const double main = rows ? way.y : way.x, side = rows ? way.x : way.y;
    if (std::abs(main) < 1e-9) return {};  // the sun stands in the zenith
    const int count = rows ? g.height : g.width;
    return Lines{count,
                 rows ? g.width : g.height,
                 side / std::abs(main),
                 static_cast<float>(sun.y / std::abs(main)),
                 rows,
                 main > 0,
                 g.width};
}

// Lifts rays by the heights of a line where they cross it: the ray j at j - whole - share, each of its two texels by
// its share. Beyond the line's ends its last texel counts.
void liftRays(const float* heights, size_t step, int length, int begin, int end, int whole, float share, float* top) {
    const auto height = [&](int i) { return heights[static_cast<size_t>(std::clamp(i, 0, length - 1)) * step]; };
    float before = height(begin - whole - 1);
    for (int j = begin; j <= end; ++j) {
        const float here = height(j - whole), crossed = here + (before - here) * share;
        top[j - begin] = std::max(top[j - begin], crossed);
        before = here;
    }
}

}  // namespace

namespace {

// Rays `from` to `to` run side by side over the lines, one texel apart, each with the height of the highest that it
// passed: heights are interpolated once onto a ray and once back, so that a peak's shadow does not wash out with
// distance. Fills in what lies between two of these rays.
void sweepBand(const HeightGrid& heights, const Lines& l, int from, int to, HeightGrid& out) {
    std::vector<float> top(static_cast<size_t>(to - from + 1), kNothing);
    const size_t step = l.step();
    for (int line = 0; line < l.count; ++line) {
        const double offset = -l.shift * line;  // ray j crosses this line at j + offset
        const int whole = static_cast<int>(std::floor(-offset)), begin = std::max(whole, from),
                  end = std::min(whole + l.length, to);
        const float share = static_cast<float>(-offset - whole);
        if (begin > end) continue;
        float* first = &top[static_cast<size_t>(begin - from)];
        float* filled = &out.metres[l.begin(line) + static_cast<size_t>(begin - whole) * step];
        for (int j = begin; j <= end; ++j) first[j - begin] -= l.fall;
        for (int j = begin; j < end; ++j, filled += step) {
            const float* two = first + (j - begin);
            *filled = two[0] + (two[1] - two[0]) * share;
        }
        liftRays(&heights.metres[l.begin(line)], step, l.length, begin, end, whole, share, first);
    }
}

// The same, on all cores: bands of rays know nothing of each other.
void sweep(const HeightGrid& heights, const Lines& l, int from, int to, HeightGrid& out) {
    const int bands = std::clamp((to - from) / 32, 1, workerCount());
    parallelFor(static_cast<size_t>(bands), [&](size_t i) {
        const auto begin = [&](size_t band) {
            return from + static_cast<int>((to - from) * static_cast<int>(band) / bands);
        };
        sweepBand(heights, l, begin(i), begin(i + 1), out);
    });
}

// The first and last ray that cross any line at all.
std::pair<int, int> raysOf(const Lines& l) {
    const double drift = l.shift * (l.count - 1);  // of the last line's texels, in rays
    return {static_cast<int>(std::floor(std::min(0.0, drift))) - 1,
            l.length + static_cast<int>(std::ceil(std::max(0.0, drift))) + 1};
}

}  // namespace

HeightGrid hiddenHeights(const HeightGrid& heights, const glm::dvec2& size, const glm::vec3& sun) {
    HeightGrid out{heights.width, heights.height, std::vector<float>(heights.metres.size(), kNothing)};
    if (const std::optional<Lines> lines = linesOf(heights, size, sun)) {
        const auto [first, last] = raysOf(*lines);
        sweep(heights, *lines, first, last, out);
    }
    return out;
}

void updateHiddenHeights(HeightGrid& hidden, const HeightGrid& heights, const glm::dvec2& size, const glm::vec3& sun,
                         const GridPart& changed) {
    const std::optional<Lines> lines = linesOf(heights, size, sun);
    if (!lines || changed.x1 <= changed.x0) return;
    const auto [first, last] = raysOf(*lines);
    const auto [i0, i1] = lines->rows ? std::pair{changed.x0, changed.x1} : std::pair{changed.y0, changed.y1};
    const auto [a, b] = lines->rows ? std::pair{changed.y0, changed.y1} : std::pair{changed.x0, changed.x1};
    const int line0 = lines->flipped ? lines->count - b : a, line1 = lines->flipped ? lines->count - a : b;
    const double drift0 = lines->shift * line0, drift1 = lines->shift * (line1 - 1);
    const int from = static_cast<int>(std::floor(i0 + std::min(drift0, drift1))) - 3,
              to = static_cast<int>(std::ceil(i1 + std::max(drift0, drift1))) + 3;
    sweep(heights, *lines, std::max(from, first), std::min(to, last), hidden);
}

namespace {

// What changed of the heights since the last time; everything at first.
GridPart updateHeights(ShadeState& s, const Terrain& t) {
    const glm::dvec2 repeat = tilingOf(t, t.heightTiling).metres;
    const bool same = !s.heights.metres.empty() && s.of.info() == t.height.map.info() && s.range == t.heightRange &&
                      s.size == t.size && s.repeat == repeat;
    if (same && s.of.sameTiles(t.height.map)) return {};
    const Map before = std::exchange(s.of, t.height.map);
    if (same) return updateShadeHeights(s.heights, before, t);
    s.range = t.heightRange, s.size = t.size, s.repeat = repeat;
    s.heights = shadeHeights(t);
    s.sun = glm::vec3(0);
    return {};
}

void drawShade(DrawContext& ctx) {
    ShadeState& s = ctx.own<ShadeState>();
    const glm::vec3 sun = ctx.globals.sunDirection;
    if (ctx.globals.sunIsUp <= 0) return;
    const Terrain& t = *ctx.shared.ground.terrain;
    const GridPart changed = updateHeights(s, t);
    const bool moved = s.sun != sun;
    if (moved) {
        s.sun = sun;
        s.hidden = hiddenHeights(s.heights, t.size, sun);
    } else {
        updateHiddenHeights(s.hidden, s.heights, t.size, sun, changed);
    }
    if (moved || changed.x1 > changed.x0) {
        if (s.texture.width != s.hidden.width || s.texture.height != s.hidden.height)
            s.texture = makeTexture2D(ctx.gpu, kOwner, GL_R32F, s.hidden.width, s.hidden.height);
        glTextureSubImage2D(s.texture.id(), 0, 0, 0, s.hidden.width, s.hidden.height, GL_RED, GL_FLOAT,
                            s.hidden.metres.data());
    }
    glBindTextureUnit(TEX_SHADE, s.texture.id());
}

const System kSystems[] = {{"terrain/shade", {.reads = {Slot::Sun}, .appends = {Slot::Shadows}}, drawShade, true}};

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
