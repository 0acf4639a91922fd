// What a field's other species leave of the light.
#include "grass/among.h"

#include <gtest/gtest.h>

#include "core/numerics.h"

namespace sward::test {
namespace {

const glm::vec3 kUp(0, 1, 0), kWhole(0);

TEST(Among, OverTheOthersAllLightComesAndAtTheGroundBeersLawSaysHowMuch) {
    const std::vector<Among> tall{{.height = 0.5f, .area = {3, 1.5f}, .skyLeft = 0.2f, .density = 0.5f}};
    EXPECT_EQ(amongLeave(tall, 0.5f, kUp), 1);
    EXPECT_EQ(amongLeave(tall, 2, kWhole), 1);
    EXPECT_FLOAT_EQ(amongLeave(tall, 0, kUp), std::exp(-0.5f * 1.5f));
    EXPECT_FLOAT_EQ(amongLeave(tall, 0.25f, kUp), std::exp(-0.25f * 1.5f));
    EXPECT_FLOAT_EQ(amongLeave(tall, 0, kWhole), std::sqrt(0.2f)) << "half as many leaves: the root of what all leave";
    const glm::vec3 slant(std::sqrt(0.75f), 0.5f, 0);
    EXPECT_FLOAT_EQ(amongLeave(tall, 0, slant), std::exp(-0.5f * std::sqrt(0.75f * 9 + 0.25f * 2.25f) / 0.5f));
    EXPECT_EQ(amongLeave({}, 0, slant), 1);
}

TEST(Among, LightFromTheHorizonAndSpeciesOfNoHeightAreFinite) {
    const std::vector<Among> bare{{.height = 0, .area = {3, 1}, .skyLeft = 0, .density = 1}};
    EXPECT_TRUE(std::isfinite(amongLeave(bare, 0, {1, 0, 0})));
    EXPECT_TRUE(std::isfinite(amongLeave({{.height = 1, .area = {1e6f, 1}, .skyLeft = 0}}, 0, {1, 0, 0})));
    EXPECT_GT(amongLeave({{.height = 1, .area = {1, 1}, .skyLeft = 0}}, 0, kWhole), 0);
}

// Density 1 on one half of the terrain, along x.
MapField half(bool right) {
    Map m({8, 8, 1, PixelType::F32});
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) m.set(x, y, 0, (x >= 4) == right ? 1.0f : 0.0f);
    return {"maps/half.png", std::move(m)};
}

TEST(Among, DensitiesAreMeansOverWhereTheOneGrows) {
    Terrain t;
    t.size = {16, 16};
    GrassField f;
    f.species.resize(3);
    f.species[0].density = half(false), f.species[1].density = half(true);
    DensitiesAmong among;
    updateDensitiesAmong(among, f, t);
    EXPECT_LT(among.of(1, 0), 0.1f) << "but for the bilinear edge";
    EXPECT_GT(among.of(0, 0), 0.9f);
    EXPECT_EQ(among.of(2, 0), 1);
    EXPECT_NEAR(among.of(0, 2), 0.5f, 0.01f);
    const DensitiesAmong before = among;
    f.species[1].density = half(false);
    updateDensitiesAmong(among, f, t);
    EXPECT_GT(among.of(1, 0), 0.9f) << "painted anew";
    EXPECT_FALSE(before.madeFrom[1].sameTiles(among.madeFrom[1]));
    f.species.resize(1);
    updateDensitiesAmong(among, f, t);
    EXPECT_TRUE(among.means.empty()) << "alone";
}

}  // namespace
}  // namespace sward::test
