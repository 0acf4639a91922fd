// What far trees hide of the low sky: a ring of them as much as a wall of that height does, and nothing where they are
// near enough for their own shade or where none stand.
#include "forest/low_sky.h"

#include <gtest/gtest.h>

namespace sward {
namespace {

// An even block of air 4 m wide and 10 m high.
std::vector<TreeAir> airsOf(float extinction) {
    TreeAir a{8, 20, 0.5, 10, {}};
    a.extinction.assign(8 * 8 * 20, extinction);
    return {a};
}
struct Glade {
    Terrain terrain;
    StandingForest forest;
    // Trees all around from a distance on, three deep.
    explicit Glade(double radius) {
        terrain.size = {200, 200};
        for (double r = radius; r < radius + 12; r += 4)
            for (double a = 0; a < 2 * M_PI; a += 3 / r)
                forest.trees.push_back({{100 + r * std::cos(a), 0, 100 + r * std::sin(a)}});
    }
    LowSky sky(float extinction, double verticalScale = 1) const {
        const std::vector<TreeAir> airs = airsOf(extinction);
        const AiryForest one{&forest, &airs, verticalScale};
        return lowSkyOf(terrain, {0, 0, 0}, {&one, 1});
    }
};

TEST(LowSky, ARingOfTreesHidesWhatAWallOfTheirHeightDoes) {
    for (const double radius : {40.0, 60.0}) {
        const glm::vec2 left = Glade(radius).sky(3).at({0.5, 0.5});
        const double sine = 10 / std::hypot(10, radius);
        EXPECT_NEAR(1 - static_cast<double>(left.x), sine * sine, 0.35 * sine * sine) << radius << " m, level ground";
        EXPECT_NEAR(1 - static_cast<double>(left.y), sine, 0.35 * sine) << radius << " m, what stands upright";
    }
}

TEST(LowSky, TallerTreesHideMoreAndThinOnesLess) {
    const Glade glade(40);
    const float plain = glade.sky(0.1f).at({0.5, 0.5}).y;
    EXPECT_LT(glade.sky(0.1f, 2).at({0.5, 0.5}).y, plain - 0.05f);
    EXPECT_GT(glade.sky(0.01f).at({0.5, 0.5}).y, plain + 0.03f);
}

TEST(LowSky, TreesThatShadeByThemselvesAreNotCountedTwice) {
    Glade glade(40);
    glade.forest.trees = {{{100, 0, 100}}, {{104, 0, 100}}};
    const LowSky sky = glade.sky(1);
    EXPECT_EQ(sky.at({0.5, 0.5}), glm::vec2(1)) << "between them";
    EXPECT_LT(sky.at({0.62, 0.5}).y, 0.999f) << "24 m off";
    glade.forest.trees.clear();
    EXPECT_EQ(glade.sky(1).at({0.5, 0.5}), glm::vec2(1)) << "no trees";
    EXPECT_EQ(LowSky().at({0.5, 0.5}), glm::vec2(1));
}

}  // namespace
}  // namespace sward
