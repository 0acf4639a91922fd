// Texels that are not finite, and maps of one texel: what takes their place, and what is said.
#include "maps/map_repair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "maps/map_io.h"
#include "tests/maps/images.h"
#include "tests/support.h"

namespace sward::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

MapWish heightWish() {
    MapWish w;
    w.isHeight = true;
    return w;
}

TEST(MapRepair, TexelsThatAreNotFiniteTakeTheNearestFiniteOneAndAreCounted) {
    TempDir dir;
    Map map = patternMap({40, 30, 1, PixelType::F32});
    map.set(7, 3, 0, kNan);
    map.set(8, 3, 0, kInf);
    map.set(39, 29, 0, -kInf);
    ASSERT_TRUE(writeMap(dir / "m.exr", map));
    std::vector<std::string> said;
    const Result<Map> back = readMap(dir / "m.exr", heightWish(), &said);
    ASSERT_TRUE(back);
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(said[0], "texel (7, 3) and 2 more are not finite; replaced by the nearest finite texel");
    EXPECT_EQ(back->at(7, 3), map.at(6, 3));
    EXPECT_TRUE(back->at(8, 3) == map.at(9, 3) || back->at(8, 3) == map.at(8, 2) || back->at(8, 3) == map.at(8, 4));
    EXPECT_TRUE(back->at(39, 29) == map.at(38, 29) || back->at(39, 29) == map.at(39, 28));
}

TEST(MapRepair, TheNearestFiniteTexelIsTheNearestByBruteForceToo) {
    Map map = patternMap({37, 29, 2, PixelType::F32});
    std::vector<std::pair<int, int>> finite;
    for (int y = 0; y < 29; ++y)
        for (int x = 0; x < 37; ++x) {
            if (pattern(x + 100, y, 7) > 0.06f)
                map.set(x, y, 1, kNan);
            else
                finite.push_back({x, y});
        }
    ASSERT_GT(finite.size(), 20u);
    const Map old = map;
    const TexelRepair repair = repairTexels(map);
    EXPECT_EQ(repair.count, 37u * 29u - finite.size());
    for (int y = 0; y < 29; ++y)
        for (int x = 0; x < 37; ++x) {
            EXPECT_EQ(map.at(x, y, 0), old.at(x, y, 0)) << "the sound channel is untouched";
            int best = 1 << 20;
            std::set<float> values;
            for (const auto& [fx, fy] : finite) {
                const int d = (fx - x) * (fx - x) + (fy - y) * (fy - y);
                if (d < best) values.clear();
                if (d <= best) values.insert(old.at(fx, fy, 1));
                best = std::min(best, d);
            }
            EXPECT_TRUE(values.contains(map.at(x, y, 1))) << x << "," << y;
        }
}

TEST(MapRepair, AMapWithoutAnyFiniteTexelBecomesZero) {
    TempDir dir;
    Map map({3, 2, 1, PixelType::F32});
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x) map.set(x, y, 0, kNan);
    ASSERT_TRUE(writeMap(dir / "m.exr", map));
    std::vector<std::string> said;
    const Result<Map> back = readMap(dir / "m.exr", heightWish(), &said);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->at(2, 1), 0.0f);
    ASSERT_EQ(said.size(), 1u);
    EXPECT_NE(said[0].find("no finite texel"), std::string::npos);
}

TEST(MapRepair, AMapOfOneTexelIsConstantAndSaysSo) {
    TempDir dir;
    Map map({1, 1, 1, PixelType::U16});
    map.set(0, 0, 0, 0.5f);
    ASSERT_TRUE(writeMap(dir / "m.png", map));
    std::vector<std::string> said;
    const Result<Map> back = readMap(dir / "m.png", heightWish(), &said);
    ASSERT_TRUE(back);
    EXPECT_EQ(said, std::vector<std::string>{"texel (0, 0) is the only one; the map is constant"});
    for (const double u : {0.0, 0.3, 1.0}) EXPECT_EQ(back->sample(u, 1 - u), back->at(0, 0));
}

}  // namespace
}  // namespace sward::test
