#include "grass/cells.h"

#include <gtest/gtest.h>

#include <set>

#include "core/numerics.h"
#include "fields.h"

namespace sward {
namespace {

using namespace test;

Frustum everywhere() {
    Frustum f;
    f.planes.fill(glm::vec4(0, 0, 0, 1));
    return f;
}

struct CellField {
    Terrain terrain;
    FlatField grass;
    Patch patch;
    HeightBounds bounds;
    Frustum frustum = everywhere();
    glm::dvec3 eye{10, 1.7, 10};

    explicit CellField(double size = 20, float bladesPerM2 = 400) {
        terrain.size = {size, size};
        grass.species[0].bladesPerM2 = bladesPerM2;
        grass.technique = nameOf(Technique::Geometry);
        patch = makePatch(grass.species[0], grass.cellSize, 1);
    }
    CellQuery query() { return cellQuery(queryOf(terrain, bounds, grass, patch), {eye, frustum, 200}); }
    void density(const std::function<float(int, int)>& f, int side = 40) {
        Map m({side, side, 1, PixelType::U16});
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) m.set(x, y, 0, f(x, y));
        grass.species[0].density = {"maps/d.png", m};
    }
};

TEST(Cells, AllGeometryIsExactlyDensityTimesArea) {
    CellField f;
    EXPECT_EQ(countVisible(f.query()), 400u * 20 * 20);
}

TEST(Cells, BladesFollowTheDensityOfTheirRoot) {
    CellField f;
    f.grass.fade = 0;
    f.density([](int x, int) { return x < 20 ? 0.0f : 0.5f; });
    const uint64_t n = countVisible(f.query());
    // Half of the right half; the ramp between texels 19 and 20 adds and takes the same.
    EXPECT_NEAR(static_cast<double>(n), 400 * 20 * 10 * 0.5, 3 * std::sqrt(400 * 20 * 10 * 0.5));
    f.density([](int, int) { return 0.0f; });
    EXPECT_EQ(countVisible(f.query()), 0u);
    EXPECT_TRUE(selectCells(f.query()).empty()) << "bare ground submits nothing";
}

TEST(Cells, TheRangeOfACellHoldsEveryBladeThatHasAnyOpacity) {
    CellField f;
    f.grass.technique = nameOf(Technique::Hybrid);
    f.grass.minGeom = 2, f.grass.maxGeom = 7;
    f.density([](int x, int y) { return static_cast<float>((x * 7 + y * 13) % 40) / 39.0f; });
    const CellQuery q = f.query();
    std::map<std::pair<int, int>, CellDraw> drawn;
    for (const CellDraw& c : selectCells(q)) drawn[{c.cellX, c.cellZ}] = c;
    uint64_t missing = 0, seen = 0, spare = 0;
    for (int cz = 0; cz < 40; ++cz)
        for (int cx = 0; cx < 40; ++cx) {
            const f32::CellVersion v = f32::cellVersion(cx, cz, q.seed);
            const auto cell = drawn.find({cx, cz});
            for (uint32_t i = 0; i < f.patch.blades.size(); ++i) {
                const Blade& b = f.patch.blades[i];
                const glm::vec2 in = f32::rootInCell(b.root, v.mirror, v.shift, 0.5f);
                const double x = cx * 0.5 + in.x, z = cz * 0.5 + in.y;
                const float d = static_cast<float>(glm::length(glm::dvec3(x, 0, z) - f.eye));
                const float threshold = f32::thresholdIn(b.threshold, f.patch.sown, chanceOf(q, cx, cz));
                const float opacity = f32::geometryOpacity(
                    q.density->sample(x / 20, z / 20), f32::lodRamp(d, q.range.min, q.range.inv), threshold, q.fade);
                const bool inRange = cell != drawn.end() && i >= cell->second.first && i < cell->second.last;
                seen += opacity > 0;
                missing += opacity > 0 && !inRange;
                spare += opacity == 0 && inRange;
            }
        }
    EXPECT_EQ(missing, 0u);
    EXPECT_GT(seen, 1000u);
    EXPECT_LT(spare, 2 * seen) << "the range is not much wider than needed";
}

TEST(Cells, NothingBeyondMaxGeomIsSubmittedAndFlatSubmitsNothing) {
    CellField f;
    f.grass.technique = nameOf(Technique::Hybrid);
    f.grass.minGeom = 2, f.grass.maxGeom = 4;
    for (const CellDraw& c : selectCells(f.query()))
        EXPECT_LT(std::hypot(c.cellX * 0.5 + 0.25 - 10, c.cellZ * 0.5 + 0.25 - 10), 4.4);
    f.grass.technique = nameOf(Technique::Flat);
    EXPECT_TRUE(selectCells(f.query()).empty());
}

TEST(Cells, EqualTierDistancesAreAStepAndInfinityNeverFades) {
    CellField f;
    f.grass.technique = nameOf(Technique::Hybrid);
    f.grass.minGeom = f.grass.maxGeom = 5;
    const uint64_t step = countVisible(f.query());
    EXPECT_NEAR(static_cast<double>(step), 400 * 3.14159 * (25 - 1.7 * 1.7), 300);
    f.grass.minGeom = f.grass.maxGeom = std::numeric_limits<float>::infinity();
    EXPECT_EQ(countVisible(f.query()), 400u * 20 * 20);
}

TEST(Cells, NodesThatAreLookedAtDoNotGrowWithTheField) {
    uint64_t nodes[2];
    for (int i = 0; i < 2; ++i) {
        CellField f(i == 0 ? 100 : 100 * 32, 40);
        f.grass.technique = nameOf(Technique::Hybrid);
        f.eye = {20, 1.7, 20};
        (void)selectCells(f.query(), &nodes[i]);
    }
    EXPECT_LE(nodes[1], nodes[0] + 5 * 4) << "one level of the tree a doubling";
}

TEST(Cells, TheFrustumCullsWhatIsBehindTheEye) {
    CellField f;
    f.frustum = frustumOf(viewProjection({f.eye, f.eye + glm::dvec3(0, -0.2, 1), 55, 0}, 320, 240));
    for (const CellDraw& c : selectCells(f.query())) EXPECT_GT(c.cellZ * 0.5 + 0.5 + 0.2, f.eye.z - 1);
    EXPECT_LT(countVisible(f.query()), 400u * 20 * 20 / 4);
    EXPECT_GT(countVisible(f.query()), 400u * 20);
}

TEST(Cells, OfCellsThatOnlyShadeWhatIsSeenNoBladesAreSeen) {
    CellField f;
    f.frustum = frustumOf(viewProjection({f.eye, f.eye + glm::dvec3(0, -0.2, 1), 55, 0}, 320, 240));
    CellQuery query = f.query();
    const std::vector<CellDraw> blades = selectCells(query);
    query.shadow = 1;
    const std::vector<CellDraw> all = selectCells(query);
    std::set<std::pair<int, int>> seen;
    for (const CellDraw& c : all)
        if (c.seen) seen.emplace(c.cellX, c.cellZ);
    EXPECT_EQ(seen.size(), blades.size());
    for (const CellDraw& c : blades)
        EXPECT_TRUE(c.seen && seen.contains({c.cellX, c.cellZ})) << c.cellX << " " << c.cellZ;
    EXPECT_GT(all.size(), blades.size());
}

TEST(Cells, DensityRangesContainEveryBilinearSample) {
    Map m({13, 9, 1, PixelType::U16});
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 13; ++x)
            m.set(x, y, 0, f32::hashUnit(f32::hash2(static_cast<uint32_t>(x), static_cast<uint32_t>(y))));
    for (double x = 0; x < 10; x += 0.5)
        for (double z = 0; z < 8; z += 0.5) {
            const auto [least, most] = densityRange(m, {{10, 8}, false}, x, z, x + 0.5, z + 0.5);
            for (int i = 0; i <= 4; ++i)
                for (int j = 0; j <= 4; ++j) {
                    const float d = m.sample((x + i * 0.125) / 10, (z + j * 0.125) / 8);
                    ASSERT_GE(d, least - 1e-6f);
                    ASSERT_LE(d, most + 1e-6f);
                }
        }
}

TEST(Cells, SegmentsFollowTheSizeOnTheScreen) {
    CellField f;
    f.grass.species[0].segments = 6;
    f.grass.species[0].bend = 1;
    f.grass.species[0].height = 0.6f;
    f.patch = makePatch(f.grass.species[0], f.grass.cellSize, 1);
    int near = 0, far = 100;
    for (const CellDraw& c : selectCells(f.query())) {
        EXPECT_GE(c.segments, 1);
        EXPECT_LE(c.segments, 6);
        near = std::max(near, c.segments);
        far = std::min(far, c.segments);
    }
    EXPECT_EQ(near, 6);
    EXPECT_LT(far, near);
}

}  // namespace
}  // namespace sward
