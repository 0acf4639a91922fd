#include "scene/unique.h"

#include <gtest/gtest.h>

#include <cstring>

#include "fields.h"
#include "scenes.h"

namespace sward {
namespace {

using namespace test;

struct Field {
    Terrain terrain;
    FlatField grass;
    Field(double side, float bladesPerM2) {
        terrain.size = {side, side};
        grass.species[0].bladesPerM2 = bladesPerM2;
        grass.population = Population::Unique;
    }
    UniqueBlades made() const { return makeUnique(grass.species[0], grass.grows, terrain); }
};

// J-9: texels of less than one expected blade have their share.
TEST(Unique, TheNumberOfBladesIsTheIntegralOfTheDensity) {
    for (const float perM2 : {0.9f, 3.6f, 40.0f, 400.0f})
        for (const float density : {0.1f, 0.5f, 1.0f}) {
            Field f(60, perM2);
            Map m({120, 120, 1, PixelType::U16});
            for (int y = 0; y < 120; ++y)
                for (int x = 0; x < 120; ++x) m.set(x, y, 0, (x / 3 + y / 5) % 2 ? density : 0.3f * density);
            f.grass.species[0].density = field(m);
            const double expected = 60.0 * 60 * static_cast<double>(perM2) * m.mean();
            EXPECT_NEAR(static_cast<double>(f.made().patch.blades.size()), expected,
                        3 * std::sqrt(expected) + 0.004 * expected)
                << perM2 << ' ' << density;
        }
}

TEST(Unique, NoTwoCellsAreEqual) {
    Field f(20, 100);
    const UniqueBlades u = f.made();
    ASSERT_EQ(u.patch.blades.size(), 40000u);
    std::set<std::pair<float, float>> roots;
    for (const Blade& b : u.patch.blades) roots.insert({b.root.x, b.root.y});
    EXPECT_GT(roots.size(), 39900u) << "a patch has 25 places, or a hundred versions of them";
    const UniqueBlades again = f.made();
    EXPECT_EQ(std::memcmp(u.patch.blades.data(), again.patch.blades.data(), u.patch.blades.size() * sizeof(Blade)), 0)
        << "the same each time";
}

TEST(Unique, CellsAreSortedSoThatAnyRangeOfThresholdsIsOnePiece) {
    Field f(10, 300);
    const UniqueBlades u = f.made();
    ASSERT_EQ(u.first.size(), 401u);
    uint32_t most = 0;
    for (int z = 0; z < 20; ++z)
        for (int x = 0; x < 20; ++x) {
            const auto [first, last] = u.range(x, z, 0, 1);
            EXPECT_EQ(last - first, 75u);
            most = std::max(most, last - first);
            const auto [a, b] = u.range(x, z, 0.25f, 0.5f);
            for (uint32_t i = first; i < last; ++i) {
                const float t = u.patch.blades[i].threshold;
                ASSERT_EQ(t >= 0.25f && t <= 0.5f, i >= a && i < b);
                ASSERT_TRUE(i == first || u.patch.blades[i - 1].threshold <= t);
            }
        }
    EXPECT_EQ(u.mostInCell, most);
}

// The first quarter of each cell's blades, which a coarse view draws, is spread over the field as all of them are.
TEST(Unique, TheCoarseQuarterIsEven) {
    Field f(40, 64);
    const UniqueBlades u = f.made();
    std::array<double, 16> parts{};
    for (int z = 0; z < 80; ++z)
        for (int x = 0; x < 80; ++x) {
            const auto [first, last] = u.range(x, z, 0, 1);
            for (uint32_t i = first; i < first + (last - first + 3) / 4; ++i) {
                const Blade& b = u.patch.blades[i];
                ++parts[static_cast<size_t>(4 * static_cast<int>(b.root.y * 8) + static_cast<int>(b.root.x * 8))];
            }
        }
    const double expected = 80 * 80 * 4 / 16.0;
    for (const double n : parts) EXPECT_NEAR(n, expected, 4 * std::sqrt(expected));
}

TEST(Unique, BladesEndWhereTheTerrainDoes) {
    Field f(10.3, 200);
    for (const UniqueBlades u = f.made(); const Blade& b : u.patch.blades) ASSERT_LT(b.root.x, 0.5f);
    EXPECT_NEAR(static_cast<double>(f.made().patch.blades.size()), 10.3 * 10.3 * 200, 3 * std::sqrt(10.3 * 10.3 * 200));
}

TEST(Unique, ItsKeyFollowsWhatItIsMadeFrom) {
    Field f(20, 100);
    const auto key = [&] { return uniqueKey(f.grass.species[0], f.grass.grows, f.terrain); };
    const uint64_t before = key();
    f.terrain.size.x = 21;
    const uint64_t larger = key();
    EXPECT_NE(before, larger);
    f.grass.species[0].densityTiling = 3;
    EXPECT_NE(larger, key());
    f.grass.seed = 2;
    EXPECT_NE(before, key());
}

TEST(Unique, MoreThanMemoryHoldsIsRefusedWithTheLimitAndTheRemedy) {
    Project p = lawn();
    EXPECT_TRUE(checkUnique(p, 1e12)) << "a patch costs the same however often it is repeated";
    flatField(p, "grass").population = Population::Unique;
    EXPECT_TRUE(checkUnique(p, virtualBlades(p)));
    p.registry.get<Terrain>(findEntity(p, "ground"))->size = {2000, 2000};
    const Status refused = checkUnique(p, virtualBlades(p));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ExitCode::Unsound);
    EXPECT_NE(refused.error().text().find("2000000"), std::string::npos) << refused.error().text();
    EXPECT_NE(refused.error().remedy.find("patch"), std::string::npos);
    EXPECT_EQ(refused.error().message.substr(0, 28), "grass.GrassField.population:");
    ASSERT_FALSE(checkUnique(p));
    EXPECT_EQ(checkUnique(p).error().text(), refused.error().text());
}

}  // namespace
}  // namespace sward
