#include "grass/cells.h"

#include <atomic>

#include "core/jobs.h"
#include "core/numerics.h"

namespace sward {
namespace {

struct CellSelection {
    const CellQuery& q;
    int cellsX, cellsZ;
    uint64_t nodes = 0;
    std::vector<CellDraw> out;

    struct Box {
        double x0, z0, x1, z1;
        float low, high;
    };
    Box boxOf(int x, int z, int size) const {
        Box b{x * q.cellSize, z * q.cellSize, std::min((x + size) * q.cellSize, q.terrain.size.x), std::min((z + size) * q.cellSize, q.terrain.size.y), 0, 0};
        std::tie(b.low, b.high) = q.bounds.over(q.terrain.size, b.x0, b.z0, b.x1, b.z1);
        return b;
    }
    // 0 inside the box: never negative, never a logarithm of one (B-23).
    double nearest(const Box& b) const {
        const double dx = std::max({b.x0 - q.eye.x, 0.0, q.eye.x - b.x1}), dz = std::max({b.z0 - q.eye.z, 0.0, q.eye.z - b.z1});
        const double dy = std::max({b.low - q.eye.y, 0.0, q.eye.y - b.high});
        return std::sqrt(dx * dx + dy * dy + dz * dz);
    }
    double farthest(const Box& b) const {
        const double dx = std::max(std::abs(b.x0 - q.eye.x), std::abs(b.x1 - q.eye.x)), dz = std::max(std::abs(b.z0 - q.eye.z), std::abs(b.z1 - q.eye.z));
        const double dy = std::max(std::abs(b.low - q.eye.y), std::abs(b.high - q.eye.y));
        return std::sqrt(dx * dx + dy * dy + dz * dz);
    }
    bool visible(const Box& b, float reach) const {
        const double r = reach;
        return q.frustum.touches(glm::vec3(b.x0 - r - q.eye.x, b.low - q.eye.y, b.z0 - r - q.eye.z),
                                 glm::vec3(b.x1 + r - q.eye.x, b.high + r - q.eye.y, b.z1 + r - q.eye.z));
    }

    bool within(const Box& b, float reach) const {
        const double r = reach;
        return q.frustum.holds(glm::vec3(b.x0 - r - q.eye.x, b.low - q.eye.y, b.z0 - r - q.eye.z),
                               glm::vec3(b.x1 + r - q.eye.x, b.high + r - q.eye.y, b.z1 + r - q.eye.z));
    }

    // A quadratic curve cut into n chords leaves them by its sagitta / n^2.
    int segmentsAt(double distance) const {
        if (q.levels.smoothness > 0) return mostLevel(q.levels, static_cast<float>(distance));
        const double pixels = q.sagitta * q.pixelsPerMetre / std::max(distance, 0.05);
        return std::clamp(static_cast<int>(std::ceil(std::sqrt(pixels / kChordPixels))), 1, q.segments);
    }

    void leaf(int x, int z, const Box& b) {
        const float nearWs = f32::lodRamp(static_cast<float>(nearest(b)), q.range.min, q.range.inv);
        const auto [least, most] = q.density ? densityRange(*q.density, q.densityTiling, b.x0, b.z0, b.x1, b.z1) : std::pair{1.0f, 1.0f};
        const float high = f32::highestThresholdDrawn(f32::densityKept(most, static_cast<float>(nearest(b)), q.thinning), q.fade), low = f32::lowestThresholdDrawn(f32::sliceDensity(least, nearWs), q.fade);
        const auto level = [](float t) { return static_cast<size_t>(std::clamp(std::floor(t * 255.0f), 0.0f, 255.0f)); };
        const auto [first, last] = q.unique ? q.unique->range(x, z, low - 1e-5f, high + 1e-5f) : std::pair{q.patch.upTo[level(low - 1e-5f)], q.patch.upTo[level(high + 1e-5f)]};
        if (most <= 0 || first >= last) return;
        const f32::CellVersion v = q.unique ? f32::CellVersion{glm::vec2(1), glm::vec2(0)} : f32::cellVersion(x, z, q.seed);
        out.push_back({x, z, static_cast<float>(b.x0 - q.eye.x), static_cast<float>(b.z0 - q.eye.z), v.mirror, v.shift, first, last, segmentsAt(nearest(b)), q.shadow > 0 ? visible(b, q.reach) : 1, static_cast<float>(nearest(b)), within(b, q.reach)});
    }

    // Calls atLeaf(x, z, box) for the visible cells of a node that begin before `far`.
    template <class F>
    void node(int x, int z, int size, float far, const F& atLeaf) {
        if (x >= cellsX || z >= cellsZ) return;
        ++nodes;
        const Box b = boxOf(x, z, size);
        if (nearest(b) >= far || !visible(b, q.reach + q.shadow)) return;
        if (size == 1) return atLeaf(x, z, b);
        const int half = size / 2;
        for (int i = 0; i < 4; ++i) node(x + (i & 1) * half, z + (i >> 1) * half, half, far, atLeaf);
    }
    template <class F>
    void eachCell(float far, const F& atLeaf) {
        int root = 1;
        while (root < std::max(cellsX, cellsZ)) root *= 2;
        node(0, 0, root, far, atLeaf);
    }
};

CellSelection selection(const CellQuery& q) {
    return {q, static_cast<int>(std::ceil(q.terrain.size.x / q.cellSize)), static_cast<int>(std::ceil(q.terrain.size.y / q.cellSize)), 0, {}};
}

}  // namespace

GeometryRange geometryRange(const GrassField& f) {
    const float inf = std::numeric_limits<float>::infinity();
    switch (static_cast<Technique>(f.technique)) {
        case Technique::Geometry: return {0, 0, inf};
        case Technique::Slices:
        case Technique::Flat: return {0, -1, 0};
        case Technique::Tessellated: return {f.maxDistance, -1, f.maxDistance};
        default: return {f.minGeom, f32::lodInverse(f.minGeom, f.maxGeom), std::max(f.minGeom, f.maxGeom)};
    }
}

int mostLevel(const BladeLevels& l, float distance) {
    const auto smoothness = static_cast<float>(l.smoothness);
    if (l.quadsAtOneMetre <= 0) return std::max(f32::tessLevel(smoothness, distance, l.maxDistance), 1);
    const float nearest = distance - l.reach;  // of the blade's tip
    return nearest > 0.05f ? static_cast<int>(std::clamp(std::ceil(l.quadsAtOneMetre / nearest), 1.0f, smoothness)) : l.smoothness;
}

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

CellQuery cellQuery(const Terrain& terrain, const HeightBounds& bounds, const GrassField& field, const Species& species, const Patch& patch,
                    const glm::dvec3& eye, const Frustum& frustum, float pixelsPerMetre) {
    return {terrain, bounds, species.density.present() ? &species.density.map : nullptr, tilingOf(terrain, species.densityTiling), patch, field.cellSize, bladeReach(species, patch),
            bladeSagitta(patch), geometryRange(field), isUnique(field) ? 0 : field.fade, static_cast<uint32_t>(field.seed), species.segments, pixelsPerMetre, eye, frustum};
}

namespace {

constexpr double kRounding = 0.01;  // texels that shaders may be off by where a map repeats often

// First and last texel, counted on from the map's first over all repeats, that sampling between a and b may read: at most all of them.
std::pair<int64_t, int64_t> texelsBetween(double a, double b, double metres, int n, bool repeats) {
    const double slack = repeats ? kRounding : 0;
    const auto first = static_cast<int64_t>(std::floor(a / metres * n - 0.5 - slack)), last = static_cast<int64_t>(std::floor(b / metres * n - 0.5 + slack)) + 1;
    if (repeats) return {first, std::min(last, first + n - 1)};
    return {std::clamp<int64_t>(first, 0, n - 1), std::clamp<int64_t>(last, 0, n - 1)};
}

}  // namespace

std::pair<float, float> densityRange(const Map& density, const Tiling& tiling, double x0, double z0, double x1, double z1) {
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

std::vector<CellDraw> selectCells(const CellQuery& q, uint64_t* nodes) {
    CellSelection s = selection(q);
    s.eachCell(q.range.max, [&](int x, int z, const CellSelection::Box& b) { s.leaf(x, z, b); });
    if (nodes) *nodes = s.nodes;
    return std::move(s.out);
}

std::vector<SliceCell> selectSliceCells(const CellQuery& q, float near, float far) {
    CellSelection s = selection(q);
    std::vector<std::pair<double, SliceCell>> found;
    s.eachCell(far, [&](int x, int z, const CellSelection::Box& b) {
        if (s.farthest(b) <= near) return;
        if (q.density && densityRange(*q.density, q.densityTiling, b.x0, b.z0, b.x1, b.z1).second <= 0) return;
        const f32::CellVersion v = f32::cellVersion(x, z, q.seed);
        found.push_back({s.nearest(b), {x, z, static_cast<float>(b.x0 - q.eye.x), static_cast<float>(b.z0 - q.eye.z), v.mirror, v.shift}});
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
        const float u = (static_cast<float>(c.cellX) * cell + root.x) / sizeX, v = (static_cast<float>(c.cellZ) * cell + root.y) / sizeZ;
        if (u > 1 || v > 1) continue;
        const glm::vec3 at(c.x + root.x, static_cast<float>(terrainHeight(q.terrain, u * q.terrain.size.x, v * q.terrain.size.y) - q.eye.y), c.z + root.y);
        const float density = q.density ? tiledSample(*q.density, q.densityTiling, u * q.terrain.size.x, v * q.terrain.size.y) : 1.0f;
        const float weight = f32::lodRamp(glm::length(at), q.range.min, q.range.inv);
        n += f32::geometryOpacity(density, weight, b.threshold, q.fade) > 0 && q.frustum.touches(at, at);
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

uint32_t bladesDrawn(const CellDraw& c, float detail) { return static_cast<uint32_t>(std::ceil(static_cast<float>(c.last - c.first) * std::clamp(detail, 0.01f, 1.0f))); }

DrawCommand drawCommand(const CellDraw& c, int quads, uint32_t strips, float detail, uint32_t instance, uint32_t verticesABlade) {
    const uint32_t each = static_cast<uint32_t>(quads) * 6, begin = firstStrip(quads) * strips, count = bladesDrawn(c, detail) * each;
    if (verticesABlade > 0) return {count, 1, begin, static_cast<int32_t>(c.first * verticesABlade), instance};
    return {count, 1, begin + c.first * each, 0, instance};
}

}  // namespace sward
