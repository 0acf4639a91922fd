#include "brushes/brush.h"

#include <gtest/gtest.h>

#include <random>

namespace sward {
namespace {

Map mapOf(int width, int height, PixelType type, float value) {
    Map map({width, height, 1, type});
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) map.set(x, y, 0, value);
    return map;
}
Map randomMap(int width, int height, PixelType type, unsigned seed) {
    Map map({width, height, 1, type});
    std::mt19937 random(seed);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) map.set(x, y, 0, static_cast<float>(random() % 65536) / 65535.0f);
    return map;
}
BrushSettings brushOf(float strength, float falloff = 0.5f, float value = 1) {
    BrushSettings b;
    b.strength = strength;
    b.falloff = falloff;
    b.value = value;
    return b;
}
void paint(Map& map, const char* mode, const Stamp& stamp, const BrushSettings& brush) {
    const BrushRow* row = findBrush(mode);
    ASSERT_NE(row, nullptr) << mode;
    applyStamp(map, *row, stamp, brush);
}
constexpr PixelType kTypes[] = {PixelType::U8, PixelType::U16, PixelType::F32};

TEST(Brush, TheTableNamesTheModesAndWhatTheyPaint) {
    std::vector<std::string> names;
    for (const BrushRow& row : brushRows()) names.push_back(row.name);
    EXPECT_EQ(names,
              (std::vector<std::string>{"add", "subtract", "set", "smooth", "noise", "comb", "direction", "press"}));
    for (const BrushRow& row : brushRows()) {
        const std::string name = row.name;
        const bool any = name == "smooth" || name == "subtract", lays = name == "comb" || name == "direction";
        const bool amounts = !lays && name != "press";
        EXPECT_EQ(paints(row, MapKind::Amounts), amounts) << name;
        EXPECT_EQ(paints(row, MapKind::Directions), lays || any) << name;
        EXPECT_EQ(paints(row, MapKind::Forces), name == "press" || any) << name;
        EXPECT_EQ(paints(row, MapKind::Colours), amounts) << name;
    }
    EXPECT_EQ(findBrush("spray"), nullptr);
    EXPECT_EQ(brushesFor(MapKind::Forces), "subtract, smooth or press");
    EXPECT_EQ(brushesFor(MapKind::Colours), "add, subtract, set, smooth or noise");
}

TEST(Brush, ZeroRadiusZeroStrengthAndBrokenNumbersPaintNothing) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    for (const PixelType type : kTypes)
        for (const BrushRow& row : brushRows()) {
            const Map before = randomMap(150, 140, type, 1);
            Map map = before;
            applyStamp(map, row, {70, 70, 0, 0}, brushOf(1));
            applyStamp(map, row, {70, 70, 10, 0}, brushOf(1));
            applyStamp(map, row, {70, 70, -5, -5}, brushOf(1));
            applyStamp(map, row, {70, 70, 30, 30, 3}, brushOf(0));
            applyStamp(map, row, {70, 70, 30, 30}, brushOf(nan));
            applyStamp(map, row, {70, 70, 30, 30}, brushOf(1, nan));
            applyStamp(map, row, {70, 70, 30, 30}, brushOf(1, 0.5f, inf));
            applyStamp(map, row, {nan, 70, 30, 30}, brushOf(1));
            applyStamp(map, row, {70, 70, inf, 30}, brushOf(1));
            applyStamp(map, row, {-200, 70, 30, 30}, brushOf(1));
            EXPECT_TRUE(map.sameTiles(before)) << row.name;
        }
}

TEST(Brush, MapsOfSeveralChannelsAreLeftAlone) {
    for (const int channels : {3, 4})
        for (const BrushRow& row : brushRows()) {
            if (channels == 4 && paints(row, MapKind::Forces)) continue;
            const Map before({64, 64, channels, PixelType::U8});
            Map map = before;
            applyStamp(map, row, {32, 32, 20, 20}, brushOf(1));
            EXPECT_TRUE(map.sameTiles(before)) << row.name;
        }
}

TEST(Brush, AddAndSubtractChangeTheCoreByTheirStrength) {
    for (const PixelType type : kTypes) {
        Map map = mapOf(300, 300, type, 0.4f);
        const float was = map.at(150, 150);
        paint(map, "add", {150, 150, 60, 60}, brushOf(0.2f));
        EXPECT_NEAR(map.at(150, 150), was + 0.2f, 0.51f / 255);
        EXPECT_NEAR(map.at(150 + 29, 150), was + 0.2f, 0.51f / 255);
        EXPECT_EQ(map.at(150 + 60, 150), was);
        paint(map, "subtract", {150, 150, 60, 60}, brushOf(0.2f));
        EXPECT_NEAR(map.at(150, 150), was, 1.1f / 255);
    }
}

TEST(Brush, SetAtFullStrengthReachesItsValueExactlyFromAnywhere) {
    for (const PixelType type : kTypes)
        for (const float value : {0.0f, 0.3f, 1.0f}) {
            const Map wanted = mapOf(1, 1, type, value);
            Map map = randomMap(200, 200, type, 5);
            paint(map, "set", {100, 100, 50, 50, 77}, brushOf(1, 0, value));
            for (int y = 70; y < 130; ++y)
                for (int x = 70; x < 130; ++x) ASSERT_EQ(map.at(x, y), wanted.at(0, 0)) << x << "," << y;
        }
}

// Weak strokes must neither stall nor run away: the change of n stamps is n times the wish, to a step of the map.
TEST(Brush, WeakStampsAddUpToWhatTheyWouldWithoutRounding) {
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

TEST(Brush, WeakSetConvergesToItsValue) {
    for (const PixelType type : {PixelType::U8, PixelType::U16}) {
        Map map({32, 32, 1, type});
        for (int i = 0; i < 4000; ++i) paint(map, "set", {16, 16, 12, 12, uint32_t(i)}, brushOf(0.01f, 0.5f, 0.6f));
        EXPECT_NEAR(map.at(16, 16), 0.6f, type == PixelType::U8 ? 1.01f / 255 : 1.01f / 65535);
    }
}

TEST(Brush, NothingIsPaintedOutsideTheRadiusNorBeyondTheEdgeOfTheMap) {
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
        const auto* texels = reinterpret_cast<const uint16_t*>(map.tile(2, 1)->bytes.data());
        EXPECT_EQ(texels[300 % kTileSize], 0) << row.name;
        EXPECT_EQ(texels[(200 % kTileSize) * kTileSize], 0) << row.name;
    }
}

TEST(Brush, DensityStaysFiniteAndBetweenZeroAndOneWhateverIsPainted) {
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

TEST(Brush, HeightsMayLeaveZeroToOne) {
    Map map = mapOf(64, 64, PixelType::F32, 2);
    BrushSettings b = brushOf(1, 0);
    b.low = -100;
    b.high = 100;
    paint(map, "subtract", {32, 32, 10, 10}, b);
    EXPECT_FLOAT_EQ(map.at(32, 32), 1);
    b.value = -7;
    paint(map, "set", {32, 32, 10, 10}, b);
    EXPECT_FLOAT_EQ(map.at(32, 32), -7);
    EXPECT_EQ(map.at(60, 60), 2);
}

// A large brush leaves a slope, not a staircase: between neighbours never more than the curve's steepest slope.
TEST(Brush, LargeStampHasNoStairSteps) {
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

TEST(Brush, HardEdgeIsSoftenedOverAboutATexel) {
    Map map({128, 128, 1, PixelType::U16});
    paint(map, "add", {64, 64, 40, 40}, brushOf(1, 0));
    int between = 0;
    for (int x = 0; x < 128; ++x) between += map.at(x, 64) > 0 && map.at(x, 64) < 1;
    EXPECT_GE(between, 1);
    EXPECT_LE(between, 4);
    EXPECT_EQ(map.at(64 + 38, 64), 1);
}

TEST(Brush, StampSmallerThanATexelPaintsItsShareOfIt) {
    Map map({16, 16, 1, PixelType::F32});
    paint(map, "add", {8.5, 8.5, 0.5, 0.5}, brushOf(1));
    EXPECT_FLOAT_EQ(map.at(8, 8), 0.25f);
    EXPECT_EQ(map.at(10, 8), 0);
}

// Direct mean over the square, from the map as it was: what smooth must paint towards in every tile.
float meanAround(const Map& map, int x, int y, int reach) {
    double sum = 0;
    for (int j = -reach; j <= reach; ++j)
        for (int i = -reach; i <= reach; ++i) sum += map.at(x + i, y + j);
    return float(sum / ((2 * reach + 1) * (2 * reach + 1)));
}

TEST(Brush, SmoothReadsTheStateBeforeTheStampAcrossTilesAndEdges) {
    for (const PixelType type : kTypes) {
        const Map before = randomMap(270, 260, type, 9);
        Map map = before;
        paint(map, "smooth", {250, 130, 60, 60}, brushOf(1, 0));
        const float step = type == PixelType::U8 ? 0.51f / 255 : 0.51f / 65535;
        const int reach = 8;  // 60 / 8, rounded
        for (const auto& [x, y] : {std::pair{250, 130}, {255, 127}, {256, 128}, {269, 130}, {215, 110}, {230, 170}})
            EXPECT_NEAR(map.at(x, y), meanAround(before, x, y, reach), step + 1e-6f) << x << "," << y;
    }
}

TEST(Brush, SmoothLeavesAFlatMapExactlyAsItIs) {
    for (const PixelType type : kTypes) {
        const Map before = mapOf(300, 300, type, 0.7f);
        Map map = before;
        for (uint32_t i = 0; i < 20; ++i) paint(map, "smooth", {150, 20, 250, 250, i}, brushOf(0.37f));
        EXPECT_EQ(map.hash(), before.hash());
    }
}

TEST(Brush, SmoothEvensOutAndKeepsTheMean) {
    Map map = randomMap(256, 256, PixelType::U16, 4);
    const double mean = map.mean();
    const auto roughness = [&] {
        double sum = 0;
        for (int x = 100; x < 150; ++x) sum += std::abs(map.at(x, 128) - map.at(x + 1, 128));
        return sum;
    };
    const double rough = roughness();
    for (uint32_t i = 0; i < 10; ++i) paint(map, "smooth", {128, 128, 100, 100, i}, brushOf(0.5f));
    EXPECT_LT(roughness(), rough / 20);
    EXPECT_NEAR(map.mean(), mean, 0.003);
}

TEST(Brush, NoiseIsTheSameForASeedAndUniform) {
    Map a({256, 256, 1, PixelType::U16}), b = a, c = a;
    BrushSettings brush = brushOf(1, 0, 0.8f);
    paint(a, "noise", {128, 128, 400, 400}, brush);
    paint(b, "noise", {128, 128, 400, 400, 9}, brush);
    paint(b, "noise", {128, 128, 400, 400, 10}, brush);
    brush.seed = 1;
    paint(c, "noise", {128, 128, 400, 400}, brush);
    for (int x = 0; x < 256; ++x) EXPECT_NEAR(a.at(x, 99), b.at(x, 99), 2.1f / 65535);
    EXPECT_NE(a.hash(), c.hash());
    EXPECT_NEAR(a.mean(), 0.4, 0.005);
}

TEST(Brush, OneStampEqualsItsTilesAppliedOneByOneInAnyOrder) {
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

TEST(Stamps, ZeroLengthStrokeIsOneStamp) {
    const std::pair<double, double> twice[] = {{3, 4}, {3, 4}};
    double carry = 0;
    const auto stamps = stampsAlong(twice, 0.5, carry);
    ASSERT_EQ(stamps.size(), 1u);
    EXPECT_EQ(stamps[0], (std::pair{3.0, 4.0}));
    EXPECT_TRUE(stampsAlong({}, 0.5, carry).empty());
}

TEST(Stamps, StepsThatAreNoStepsGiveTheFirstPointOnly) {
    const std::pair<double, double> line[] = {{0, 0}, {10, 0}};
    for (const double step : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
        double carry = 0;
        EXPECT_EQ(stampsAlong(line, step, carry).size(), 1u);
    }
}

TEST(Stamps, StampsLieAStepApartAlongTheLine) {
    const std::pair<double, double> line[] = {{0, 0}, {3, 0}, {3, 4}};
    double carry = 0;
    const auto stamps = stampsAlong(line, 2, carry);
    ASSERT_EQ(stamps.size(), 4u);
    EXPECT_NEAR(stamps[2].first, 3, 1e-12);
    EXPECT_NEAR(stamps[2].second, 1, 1e-12);
    EXPECT_NEAR(stamps[3].second, 3, 1e-12);
    EXPECT_NEAR(carry, 1, 1e-12);
}

TEST(Stamps, StrokeCutIntoPiecesGivesTheSameStamps) {
    std::mt19937 random(3);
    std::vector<std::pair<double, double>> line;
    for (int i = 0; i < 50; ++i) line.emplace_back(random() % 1000 * 0.01, random() % 1000 * 0.01);
    double carry = 0;
    const auto whole = stampsAlong(line, 0.37, carry);
    std::vector<std::pair<double, double>> pieces;
    double left = 0;
    for (size_t i = 0; i + 1 < line.size(); ++i)
        for (const auto& s : stampsAlong(std::span(line).subspan(i, 2), 0.37, left)) pieces.push_back(s);
    ASSERT_EQ(whole.size(), pieces.size());
    EXPECT_EQ(whole, pieces);
    EXPECT_EQ(carry, left);
}

}  // namespace
}  // namespace sward
