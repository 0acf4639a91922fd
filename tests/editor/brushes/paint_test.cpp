// What all brushes share: the stamp's shape, its edge, rounding that loses nothing, tiles in any order.
#include "brushes/paint.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "editor/brushes/stamped.h"

namespace sward {
namespace {

using namespace test;

// Weak strokes must neither stall nor run away: the change of n stamps is n times the wish, to a step of the map.
TEST(Paint, WeakStampsAddUpToWhatTheyWouldWithoutRounding) {
    struct Case {
        float strength;
        int stamps;
    };
    for (const PixelType type : {PixelType::U8, PixelType::U16})
        for (const Case c : {Case{0.01f, 100}, Case{0.001f, 500}, Case{1e-5f, 2000}, Case{1e-6f, 50000}}) {
            const float step = type == PixelType::U8 ? 1.0f / 255 : 1.0f / 65535;
            Map map({32, 32, 1, type});
            for (int i = 0; i < c.stamps; ++i) paint(map, "add", {16, 16, 12, 12, uint32_t(i)}, brushOf(c.strength));
            const float wish = c.strength * static_cast<float>(c.stamps);
            EXPECT_NEAR(map.at(16, 16), std::min(wish, 1.0f), 2.5f * step) << c.strength << " x " << c.stamps;
            const float half = map.at(16 + 8, 16);  // in the falloff: the same share of a weaker wish
            EXPECT_GT(half, 0.1f * wish - step);
            for (int i = 0; i < c.stamps; ++i)
                paint(map, "subtract", {16, 16, 12, 12, uint32_t(i)}, brushOf(c.strength));
            EXPECT_NEAR(map.at(16, 16), std::min(wish, 1.0f) - wish, 5 * step);
        }
}

TEST(Paint, NothingIsPaintedOutsideTheRadiusNorBeyondTheEdgeOfTheMap) {
    for (const BrushRow& row : brushRows()) {
        if (!paints(row, MapKind::Amounts)) continue;
        const Map before = randomMap(300, 200, PixelType::U16, 3);
        Map map = before;
        applyStamp(map, row, {290, 190, 40, 25}, brushOf(0.7f, 0.3f, 0.9f));
        int changed = 0;
        for (int y = 0; y < 200; ++y)
            for (int x = 0; x < 300; ++x) {
                const double dx = (x + 0.5 - 290) / 40, dy = (y + 0.5 - 190) / 25;
                if (map.at(x, y) == before.at(x, y)) continue;
                ++changed;
                EXPECT_LT(dx * dx + dy * dy, 1.0) << row.name;
            }
        EXPECT_GT(changed, 500) << row.name;
        const auto* texels = reinterpret_cast<const uint16_t*>(map.tile(2, 1)->look());
        EXPECT_EQ(texels[300 % kTileSize], 0) << row.name;
        EXPECT_EQ(texels[(200 % kTileSize) * kTileSize], 0) << row.name;
    }
}

TEST(Paint, DensityStaysFiniteAndBetweenZeroAndOneWhateverIsPainted) {
    std::mt19937 random(11);
    const auto any = [&](double from, double to) { return std::uniform_real_distribution<>(from, to)(random); };
    for (const PixelType type : kTypes) {
        Map map = randomMap(200, 180, type, 2);
        for (int i = 0; i < 300; ++i) {
            const BrushRow& row = brushRows()[random() % brushRows().size()];
            BrushSettings b = brushOf(float(any(0, 2)), float(any(-1, 2)), float(any(-3, 3)));
            b.seed = int(random() % 100);
            const double r = any(0, 1) < 0.2 ? any(0, 1e-3) : any(0, 150);
            applyStamp(map, row, {any(-50, 250), any(-50, 250), r, r * any(0.5, 2), uint32_t(i)}, b);
        }
        for (int y = 0; y < 180; ++y)
            for (int x = 0; x < 200; ++x) ASSERT_TRUE(map.at(x, y) >= 0 && map.at(x, y) <= 1) << map.at(x, y);
    }
}

// A large brush leaves a slope, not a staircase: between neighbours never more than the curve's steepest slope.
TEST(Paint, LargeStampHasNoStairSteps) {
    const int n = 2048;
    for (const float falloff : {0.25f, 0.5f, 1.0f}) {
        Map map({n, 8, 1, PixelType::U16});
        paint(map, "add", {n / 2.0, 4, 1000, 1000}, brushOf(1, falloff));
        const float c = 1 - falloff, steepest = 1.5f * 2 / (1 - c * c) / 1000, step = 1.0f / 65535;
        float last = map.at(n / 2, 4);
        EXPECT_EQ(last, 1);
        for (int x = n / 2 + 1; x < n; ++x) {
            const float now = map.at(x, 4);
            ASSERT_LE(now, last);
            ASSERT_LE(last - now, steepest + step);
            last = now;
        }
        EXPECT_EQ(last, 0);
    }
}

TEST(Paint, HardEdgeIsSoftenedOverAboutATexel) {
    Map map({128, 128, 1, PixelType::U16});
    paint(map, "add", {64, 64, 40, 40}, brushOf(1, 0));
    int between = 0;
    for (int x = 0; x < 128; ++x) between += map.at(x, 64) > 0 && map.at(x, 64) < 1;
    EXPECT_GE(between, 1);
    EXPECT_LE(between, 4);
    EXPECT_EQ(map.at(64 + 38, 64), 1);
}

TEST(Paint, StampSmallerThanATexelPaintsItsShareOfIt) {
    Map map({16, 16, 1, PixelType::F32});
    paint(map, "add", {8.5, 8.5, 0.5, 0.5}, brushOf(1));
    EXPECT_FLOAT_EQ(map.at(8, 8), 0.25f);
    EXPECT_EQ(map.at(10, 8), 0);
}

TEST(Paint, OneStampEqualsItsTilesAppliedOneByOneInAnyOrder) {
    for (const BrushRow& row : brushRows()) {
        if (!paints(row, MapKind::Amounts)) continue;
        const Map before = randomMap(500, 400, PixelType::U16, 6);
        const Stamp stamp{260, 200, 170, 150, 5};
        Map whole = before, single = before;
        applyStamp(whole, row, stamp, brushOf(0.6f));
        const TileRange r = stampTiles(before.info(), stamp);
        EXPECT_EQ(r.count(), 12u);
        for (int ty = r.y1 - 1; ty >= r.y0; --ty)
            for (int tx = r.x1 - 1; tx >= r.x0; --tx)
                single.setTile(tx, ty, row.apply(before, tx, ty, stamp, brushOf(0.6f)));
        EXPECT_EQ(whole.hash(), single.hash()) << row.name;
        EXPECT_NE(whole.hash(), before.hash()) << row.name;
    }
}

}  // namespace
}  // namespace sward
