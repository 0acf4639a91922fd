#include "grass/cells.h"

#include <atomic>

#include "core/jobs.h"
#include "core/numerics.h"

namespace sward {
namespace {

using Box = f32::CellBox;

struct CellSelection {
    const CellQuery& q;
    f32::CellGrid grid;
    f32::CellRule rule;
    glm::ivec2 cells;
    double far;  // metres
    uint64_t looked = 0;
    std::vector<std::pair<float, CellNode>> nodes;

    CellSelection(const CellQuery& query, double upTo)
        : q(query), grid(cellGrid(query)), rule(cellRule(query)), cells(fieldCells(query)), far(upTo) {}

    bool visible(const Box& b, float reach) const {
        return std::all_of(q.frustum.planes.begin(), q.frustum.planes.end(),
                           [&](const glm::vec4& p) { return f32::boxTouches(p, b, reach); });
    }
    bool within(const Box& b, float reach) const {
        return std::all_of(q.frustum.planes.begin(), q.frustum.planes.end(),
                           [&](const glm::vec4& p) { return f32::boxWithin(p, b, reach); });
    }
    bool counts(const Box& b) const { return !(f32::boxNearest2(b) >= far * far) && visible(b, q.reach + q.shadow); }

    CellNode nodeAt(int x, int z, int size) const {
        const double x0 = x * q.cellSize, z0 = z * q.cellSize;
        const auto [low, high] =
            q.bounds.over(q.terrain.size, x0, z0, std::min((x + size) * q.cellSize, q.terrain.size.x),
                          std::min((z + size) * q.cellSize, q.terrain.size.y));
        return {x, z, static_cast<float>(low - q.eye.y), static_cast<float>(high - q.eye.y)};
    }
    void node(int x, int z, int size) {
        if (x >= cells.x || z >= cells.y) return;
        ++looked;
        const CellNode n = nodeAt(x, z, size);
        const Box b = f32::cellBox(grid, x, z, size, n.low, n.high);
        if (!counts(b)) return;
        if (size == f32::kNodeSide) return nodes.emplace_back(f32::boxNearest2(b), n), void();
        const int part = size / 2;
        for (int i = 0; i < 4; ++i) node(x + (i & 1) * part, z + (i >> 1) * part, part);
    }
    void walk() {
        int root = f32::kNodeSide;
        while (root < std::max(cells.x, cells.y)) root *= 2;
        node(0, 0, root);
        std::stable_sort(nodes.begin(), nodes.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    }
    // Calls at(x, z, box) for the cells in view that begin before `far`.
    template <class F>
    void eachCell(const F& at) {
        walk();
        for (const auto& [distance, n] : nodes)
            for (int i = 0; i < f32::kNodeSide * f32::kNodeSide; ++i) {
                const glm::ivec2 c = f32::nodeCell(grid, n.x, n.z, i);
                if (c.x >= cells.x || c.y >= cells.y) continue;
                const Box b = f32::cellBox(grid, c.x, c.y, 1, n.low, n.high);
                if (counts(b)) at(c.x, c.y, b);
            }
    }

    std::pair<float, float> density(int x, int z) const {
        if (!q.density) return {1.0f, 1.0f};
        return q.ranges ? rangeOf(*q.ranges, x, z, [&] { return readDensity(x, z); }) : readDensity(x, z);
    }
    std::pair<float, float> readDensity(int x, int z) const {
        if (q.densityTiling.repeats)
            return densityRange(*q.density, q.densityTiling, x * q.cellSize, z * q.cellSize, (x + 1) * q.cellSize,
                                (z + 1) * q.cellSize);
        const MapInfo& info = q.density->info();
        const glm::vec2 texels = texelsPerCell(q);
        const f32::CellTexels across = f32::cellTexels(x, texels.x, info.width),
                              down = f32::cellTexels(z, texels.y, info.height);
        return texelRange(*q.density, across.first, across.last, down.first, down.last);
    }
    // Whether the cell has any of the patch's blades.
    bool grows(int x, int z) const {
        const float most = density(x, z).second;
        const float t = f32::highestThresholdDrawn(most, rule.fade) + 1e-5f;
        return most > 0 && q.patch.upTo[static_cast<size_t>(
                               f32::thresholdNumber(f32::patchThreshold(rule, t, chanceOf(q, x, z))))] > 0;
    }
    int quadsAt(float distance) const {
        if (q.levels.smoothness > 0)
            return f32::tessMost(static_cast<float>(q.levels.smoothness), distance, q.levels.maxDistance,
                                 q.levels.quadsAtOneMetre, q.levels.reach);
        return f32::chordQuads(q.sagitta * q.pixelsPerMetre, distance, q.segments);
    }
    std::pair<uint32_t, uint32_t> share(int x, int z, float nearest, float least, float most) const {
        if (!q.unique) {
            const f32::CellShare s = f32::cellShare(rule, nearest, least, most, chanceOf(q, x, z));
            return {q.patch.upTo[static_cast<size_t>(s.low)], q.patch.upTo[static_cast<size_t>(s.high)]};
        }
        const float slices = f32::sliceDensity(least, f32::lodRamp(nearest, rule.rangeMin, rule.rangeInv));
        return q.unique->range(
            x, z, f32::lowestThresholdDrawn(slices, rule.fade) - 1e-5f,
            f32::highestThresholdDrawn(f32::densityKept(most, nearest, rule.thinning), rule.fade) + 1e-5f);
    }
    void leaf(int x, int z, const Box& b, std::vector<CellDraw>& out) const {
        const float nearest = std::sqrt(f32::boxNearest2(b));
        const auto [least, most] = density(x, z);
        const auto [first, last] = share(x, z, nearest, least, most);
        if (most <= 0 || first >= last) return;
        const f32::CellVersion v =
            q.unique ? f32::CellVersion{glm::vec2(1), glm::vec2(0)} : f32::cellVersion(x, z, q.seed);
        out.push_back({x, z, b.low.x, b.low.z, v.mirror, v.shift, first, last, quadsAt(nearest),
                       q.shadow > 0 ? visible(b, q.reach) : 1, nearest, within(b, q.reach)});
    }
    static std::pair<float, float> texelRange(const Map& density, int left, int right, int top, int bottom);
};

std::pair<float, float> CellSelection::texelRange(const Map& density, int left, int right, int top, int bottom) {
    float least = density.at(left, top), most = least;
    for (int y = top; y <= bottom && (least > 0 || most < 1); ++y)
        for (int x = left; x <= right; ++x) {
            const float d = density.at(x, y);
            least = std::min(least, d);
            most = std::max(most, d);
        }
    return {least, most};
}

}  // namespace

f32::CellGrid cellGrid(const CellQuery& q) {
    const auto cellOf = [&](double v) { return std::clamp(std::floor(v / q.cellSize), -8388608.0, 8388608.0); };
    const glm::dvec2 cell(cellOf(q.eye.x), cellOf(q.eye.z)), eye(q.eye.x, q.eye.z);
    return {glm::vec2(cell), glm::vec2(eye - cell * q.cellSize), glm::vec2(q.terrain.size - eye),
            static_cast<float>(q.cellSize)};
}
f32::CellRule cellRule(const CellQuery& q) {
    const float unspread = 1 / q.patch.sown.spread;
    return {q.fade, q.thinning, q.range.min, q.range.inv, unspread, q.patch.sown.step * unspread};
}
float chanceOf(const CellQuery& q, int x, int z) {
    return q.patch.sown.step > 0 ? f32::cellChance(x, z, q.sowSeed) : 0.5f;
}
float thresholdIn(const CellQuery& q, const CellDraw& c, const Blade& b) {
    return f32::thresholdIn(b.threshold, q.patch.sown, chanceOf(q, c.cellX, c.cellZ));
}
glm::vec2 texelsPerCell(const CellQuery& q) {
    return glm::vec2(q.cellSize / q.densityTiling.metres *
                     glm::dvec2(q.density->info().width, q.density->info().height));
}
bool gpuMayChoose(const CellQuery& q) { return !q.unique && !(q.density && q.densityTiling.repeats); }
glm::ivec2 fieldCells(const CellQuery& q) { return glm::ivec2(glm::ceil(q.terrain.size / q.cellSize)); }

float bladeSagitta(const Patch& patch) {
    float most = 0;
    for (const Blade& b : patch.blades) most = std::max(most, glm::length(b.tip - 2.0f * b.control) / 4);
    return most;
}

float bladeReach(const Species& species, const Patch& patch) {
    float reach = 0;
    for (const Blade& b : patch.blades) reach = std::max(reach, glm::length(b.tip) + b.width);
    const float clumps = species.clumpSize > 0 ? 0.8f * species.clumpStrength * species.heightVariation : 0;
    return reach * (1 + clumps);
}

CellQuery cellQuery(const QueryOf& of, const QueryFrom& from) {
    const Species& s = of.species;
    return {of.terrain,
            of.bounds,
            s.density.present() ? &s.density.map : nullptr,
            tilingOf(of.terrain, s.densityTiling),
            of.patch,
            of.field.cellSize,
            bladeReach(s, of.patch),
            bladeSagitta(of.patch),
            of.blades,
            isUnique(of.field) ? 0 : of.fade,
            static_cast<uint32_t>(of.field.seed),
            sowingSeed(s, static_cast<uint32_t>(of.field.seed)),
            s.segments,
            from.pixelsPerMetre,
            from.eye,
            from.frustum};
}

namespace {

constexpr double kRounding = 0.01;  // texels that shaders may be off by where a map repeats often

// First and last texel, counted on from the map's first over all repeats, that sampling between a and b may read: at
// most all of them.
std::pair<int64_t, int64_t> texelsBetween(double a, double b, double metres, int n, bool repeats) {
    const double slack = repeats ? kRounding : 0;
    const auto first = static_cast<int64_t>(std::floor(a / metres * n - 0.5 - slack)),
               last = static_cast<int64_t>(std::floor(b / metres * n - 0.5 + slack)) + 1;
    if (repeats) return {first, std::min(last, first + n - 1)};
    return {std::clamp<int64_t>(first, 0, n - 1), std::clamp<int64_t>(last, 0, n - 1)};
}

}  // namespace

std::pair<float, float> densityRange(const Map& density, const Tiling& tiling, double x0, double z0, double x1,
                                     double z1) {
    const MapInfo& info = density.info();
    const auto [left, right] = texelsBetween(x0, x1, tiling.metres.x, info.width, tiling.repeats);
    const auto [top, bottom] = texelsBetween(z0, z1, tiling.metres.y, info.height, tiling.repeats);
    const auto inside = [](int64_t i, int n) { return static_cast<int>((i % n + n) % n); };
    float least = 1, most = 0;
    for (int64_t y = top; y <= bottom && (least > 0 || most < 1); ++y)
        for (int64_t x = left; x <= right; ++x) {
            const float d = density.at(inside(x, info.width), inside(y, info.height));
            least = std::min(least, d);
            most = std::max(most, d);
        }
    return {least, most};
}

std::vector<CellNode> selectNodes(const CellQuery& q, uint64_t* looked) {
    CellSelection s(q, q.range.max);
    s.walk();
    if (looked) *looked = s.looked;
    std::vector<CellNode> out;
    for (const auto& [distance, n] : s.nodes) out.push_back(n);
    return out;
}

NodeBounds nodeBounds(const CellQuery& q, const CellNode& n) {
    const CellSelection s(q, 0);
    const float nearest = std::sqrt(f32::boxNearest2(f32::cellBox(s.grid, n.x, n.z, f32::kNodeSide, n.low, n.high)));
    const int low = f32::cellShare(s.rule, nearest, 0, 1, 0).low, high = f32::cellShare(s.rule, nearest, 0, 1, 1).high;
    return {q.patch.upTo[static_cast<size_t>(high)] - q.patch.upTo[static_cast<size_t>(low)], s.quadsAt(nearest),
            nearest};
}

std::vector<CellDraw> selectCells(const CellQuery& q, uint64_t* looked) {
    CellSelection s(q, q.range.max);
    std::vector<CellDraw> out;
    s.eachCell([&](int x, int z, const Box& b) { s.leaf(x, z, b, out); });
    if (looked) *looked = s.looked;
    return out;
}

std::vector<SliceCell> selectSliceCells(const CellQuery& q, float near, float far) {
    CellSelection s(q, far);
    std::vector<std::pair<float, SliceCell>> found;
    s.eachCell([&](int x, int z, const Box& b) {
        if (std::sqrt(f32::boxFarthest2(b)) <= near || !s.grows(x, z)) return;
        const f32::CellVersion v = f32::cellVersion(x, z, q.seed);
        found.push_back({f32::boxNearest2(b), {x, z, b.low.x, b.low.z, v.mirror, v.shift}});
    });
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<SliceCell> out;
    out.reserve(found.size());
    for (const auto& [distance, cell] : found) out.push_back(cell);
    return out;
}

namespace {

uint64_t visibleInCell(const CellQuery& q, const CellDraw& c) {
    const float sizeX = static_cast<float>(q.terrain.size.x), sizeZ = static_cast<float>(q.terrain.size.y);
    const float cell = static_cast<float>(q.cellSize);
    uint64_t n = 0;
    for (uint32_t i = c.first; i < c.last; ++i) {
        const Blade& b = q.patch.blades[i];
        const glm::vec2 root = f32::rootInCell(b.root, c.mirror, c.shift, cell);
        const float u = (static_cast<float>(c.cellX) * cell + root.x) / sizeX,
                    v = (static_cast<float>(c.cellZ) * cell + root.y) / sizeZ;
        if (u > 1 || v > 1) continue;
        const glm::vec3 at(
            c.x + root.x,
            static_cast<float>(terrainHeight(q.terrain, u * q.terrain.size.x, v * q.terrain.size.y) - q.eye.y),
            c.z + root.y);
        const float density =
            q.density ? tiledSample(*q.density, q.densityTiling, u * q.terrain.size.x, v * q.terrain.size.y) : 1.0f;
        const float weight = f32::lodRamp(glm::length(at), q.range.min, q.range.inv);
        n += f32::geometryOpacity(density, weight, thresholdIn(q, c, b), q.fade) > 0 && q.frustum.touches(at, at);
    }
    return n;
}

}  // namespace

uint64_t countVisible(const CellQuery& q) {
    const std::vector<CellDraw> cells = selectCells(q);
    std::atomic<uint64_t> sum = 0;
    parallelFor(cells.size(), [&](size_t i) { sum += visibleInCell(q, cells[i]); });
    return sum;
}

uint32_t firstStrip(int n) { return static_cast<uint32_t>(n * (n - 1) / 2 * 6); }

uint32_t bladesDrawn(const CellDraw& c, float detail) {
    return static_cast<uint32_t>(
        std::ceil(static_cast<float>(c.last - c.first) * std::clamp(detail, kLeastDetail, 1.0f)));
}

DrawCommand drawCommand(const CellDraw& c, int quads, uint32_t strips, float detail, uint32_t instance,
                        uint32_t verticesABlade) {
    const uint32_t each = static_cast<uint32_t>(quads) * 6, begin = firstStrip(quads) * strips,
                   count = bladesDrawn(c, detail) * each;
    if (verticesABlade > 0) return {count, 1, begin, static_cast<int32_t>(c.first * verticesABlade), instance};
    return {count, 1, begin + c.first * each, 0, instance};
}

}  // namespace sward
