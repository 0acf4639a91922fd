// The table of brushes, what they refuse, and the stamps of a stroke.
#include "brushes/brush.h"

#include <limits>

#include <gtest/gtest.h>

#include "editor/brushes/stamped.h"

namespace sward {
namespace {

using namespace test;

TEST(Brush, TheTableNamesTheModesAndWhatTheyPaint) {
    std::vector<std::string> names;
    for (const BrushRow& row : brushRows()) names.push_back(row.name);
    EXPECT_EQ(names, (std::vector<std::string>{"add", "subtract", "set", "smooth", "noise", "comb", "direction",
                                               "press", "raise", "lower", "flatten", "ramp", "erode", "imprint"}));
    for (const BrushRow& row : brushRows()) {
        const std::string name = row.name;
        const bool any = name == "smooth" || name == "subtract", lays = name == "comb" || name == "direction";
        const bool sculpts = name == "raise" || name == "lower" || name == "flatten" || name == "ramp" ||
                             name == "erode" || name == "imprint";
        const bool amounts = !lays && name != "press" && !sculpts;
        EXPECT_EQ(paints(row, MapKind::Heights), sculpts || name == "smooth" || name == "noise") << name;
        EXPECT_NE(row.apply == nullptr, row.applyWhole == nullptr) << name;
        EXPECT_EQ(paints(row, MapKind::Amounts), amounts) << name;
        EXPECT_EQ(paints(row, MapKind::Directions), lays || any) << name;
        EXPECT_EQ(paints(row, MapKind::Forces), name == "press" || any) << name;
        EXPECT_EQ(paints(row, MapKind::Colours), amounts) << name;
    }
    EXPECT_EQ(findBrush("spray"), nullptr);
    EXPECT_EQ(findBrush("spray", MapKind::Heights), nullptr);
    EXPECT_STREQ(findBrush("add", MapKind::Heights)->name, "raise");
    EXPECT_STREQ(findBrush("subtract", MapKind::Heights)->name, "lower");
    EXPECT_STREQ(findBrush("set", MapKind::Heights)->name, "flatten");
    EXPECT_STREQ(findBrush("set", MapKind::Amounts)->name, "set");
    EXPECT_EQ(brushesFor(MapKind::Heights), "smooth, noise, raise, lower, flatten, ramp, erode or imprint");
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
