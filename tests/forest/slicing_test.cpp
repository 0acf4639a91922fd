// How tiles are cut: as many slices as what they are seen as asks, without a step over angles, in the order in which
// they hide each other.
#include "forest/slicing.h"

#include <gtest/gtest.h>

#include <numbers>

namespace sward {
namespace {

Prism level() {
    Prism p;
    p.corner = {glm::dvec3(0, 0, 0), {16, 0, 0}, {8, 0, 13.86}};
    p.centre = {8, 0, 4.62};
    return p;
}
constexpr Reach kReach{0, 12};
glm::dvec3 towardsEye(double degrees) {
    const double a = degrees * std::numbers::pi / 180;
    return {std::cos(a), -std::sin(a), 0};
}

TEST(Slicing, SharesOfWaysAddUpAndMoveEvenly) {
    SliceShares before{};
    for (double degrees = -90; degrees <= 90; degrees += 0.25) {
        const SliceShares s = sliceShares(24, {0, 1, 0}, towardsEye(degrees));
        EXPECT_NEAR(s.regular + s.fromAbove + s.fromBelow, 1, 1e-12);
        if (degrees > -90) {
            EXPECT_LT(std::abs(s.regular - before.regular), 0.06) << degrees;
            EXPECT_LT(std::abs(s.fromAbove - before.fromAbove), 0.15) << degrees;
        }
        before = s;
    }
    EXPECT_EQ(sliceShares(24, {0, 1, 0}, towardsEye(90)).regular, 1);
    EXPECT_EQ(sliceShares(24, {0, 1, 0}, towardsEye(10)).fromAbove, 1);
    EXPECT_NEAR(sliceShares(24, {0, 1, 0}, towardsEye(0)).fromBelow, 0.5, 1e-9) << "both, where the eye looks level";
    EXPECT_EQ(sliceShares(24, {0, 1, 0}, towardsEye(-10)).fromBelow, 1);
}

TEST(Slicing, SilhouetteSlicesAreFiniteEverywhereAndLieWithinTheSlant) {
    for (double degrees = -90; degrees <= 90; degrees += 0.5) {
        const Slicing s = tiltedSlices(level(), kReach, towardsEye(degrees), 2, 0.5);
        EXPECT_GE(s.count, 2);
        EXPECT_LE(s.count, kMostSlices);
        for (const double b : s.begin) EXPECT_TRUE(b >= -24 - 1e-9 && b <= 1e-9) << degrees;
        EXPECT_LE(s.reach, 36 + 1e-9);
    }
}

TEST(Slicing, AtTheSwitchingAngleSilhouetteSlicesAreSomeTimesAsMany) {
    const Slicing regular = regularSlices(level(), kReach, {-100, 50, 0}, 0.5),
                  silhouette = tiltedSlices(level(), kReach, towardsEye(24), 2, 0.5);
    std::printf("slices of a cell at 24 degrees: regular %d, silhouette %d\n", regular.count, silhouette.count);
    EXPECT_EQ(regular.count, 24);
    EXPECT_GT(silhouette.count, regular.count);
    EXPECT_LT(silhouette.count, 4 * regular.count) << "the paper's cost four times as much";
}

TEST(Slicing, ThoseBelowTheEyeAreTold) {
    EXPECT_EQ(regularSlices(level(), kReach, {8, 100, 4}, 0.5).below, 24);
    EXPECT_EQ(regularSlices(level(), kReach, {8, -5, 4}, 0.5).below, 0);
    EXPECT_EQ(regularSlices(level(), kReach, {8, 3, 4}, 0.5).below, 6);
    EXPECT_EQ(flatSlice(level(), kReach, {8, 100, 4}).below, 1);
    EXPECT_EQ(flatSlice(level(), kReach, {8, 100, 4}).count, 1);
}

TEST(Slicing, FewerSlabsFarAwayAndFromAbove) {
    EXPECT_EQ(levelAt(0.25, 6, 0, 0.003, 0), 0) << "at the eye (D-8)";
    EXPECT_LT(levelAt(0.25, 6, 1e9, 0.003, 0), 6) << "and a next level is there";
    const double side = levelAt(0.25, 6, 400, 0.003, 0.1), above = levelAt(0.25, 6, 400, 0.003, 1);
    EXPECT_GT(above, side + 1);
    EXPECT_NEAR(levelAt(0.25, 6, 800, 0.003, 0.1) - side, 1, 1e-9);
}

TEST(Slicing, CliffsAndWhatHasNoAreaAreNotUsable) {
    ForestHere here;
    here.terrain = Terrain{};
    here.terrain->size = {64, 64};
    Map m({64, 64, 1, PixelType::F32});
    for (int z = 0; z < 64; ++z)
        for (int x = 0; x < 64; ++x) m.set(x, z, 0, x < 32 ? 0.0f : 20000.0f);
    here.terrain->height = {"h", m};
    auto stand = std::make_shared<StandingForest>();
    stand->tiles.edge = 16;
    stand->triangles = {{{0, 0}, {}, {}}, {{1, 1}, {}, {}}};
    here.stand = stand;
    const std::vector<Prism> prisms = prismsOf(here);
    EXPECT_TRUE(prisms[0].usable);
    EXPECT_FALSE(prisms[1].usable) << "20 km over 16 m";
    for (const Prism& p : prisms) EXPECT_TRUE(std::isfinite(p.normal.y) && std::isfinite(p.slope));
}

}  // namespace
}  // namespace sward
