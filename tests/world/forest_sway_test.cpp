// How wind leans trees: by what blows at the foot over the stiffness, wherever the eye is; in a calm not at all.
#include "world/forest_sway.h"

#include <gtest/gtest.h>

namespace sward {
namespace {

Wind blowing() {
    Wind w;
    w.strength = 3;
    return w;
}

TEST(ForestSway, InACalmNothingMoves) {
    TreeSway sway;
    EXPECT_EQ(sway.at({}, {5, 7}), glm::dmat3(1));
    const Wind wind = blowing();
    sway.follow(&wind, {0, 0}, 2);
    EXPECT_NE(sway.at({}, {5, 7}), glm::dmat3(1));
    sway.follow(nullptr, {0, 0}, 2);
    EXPECT_EQ(sway.at({}, {5, 7}), glm::dmat3(1));
    EXPECT_FALSE(sway.blows());
}

TEST(ForestSway, LeansByWhatBlowsAtTheFootOverTheStiffness) {
    const Wind wind = blowing();
    Map made;
    TreeSway sway;
    for (const double time : {0.0, 1.5, 1e5}) {
        sway.follow(&wind, {0, 0}, time);
        const WindGlobals g = windGlobals(wind, {0, 0}, time);
        const glm::dvec2 lean = glm::dvec2(windLeanAt(g, gustsOf(wind, made), {40, 30}, -1)) / 15.0;
        const glm::dmat3 m = sway.at({.stiffness = 15}, {40, 30});
        EXPECT_EQ(m * glm::dvec3(0, 10, 0), glm::dvec3(10 * lean.x, 10, 10 * lean.y));
        EXPECT_EQ(m * glm::dvec3(3, 0, 2), glm::dvec3(3, 0, 2)) << "the foot stays";
        const double half = sway.at({.stiffness = 30}, {40, 30})[1].x;
        EXPECT_NEAR(half, 0.5 * lean.x, 1e-9);
    }
}

TEST(ForestSway, IsTheSameFromEveryEye) {
    const Wind wind = blowing();
    TreeSway here, there;
    here.follow(&wind, {0, 0}, 4);
    there.follow(&wind, {310, -95}, 4);
    for (const glm::dvec2 foot : {glm::dvec2(3, 4), glm::dvec2(250, 80)})
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(here.at({}, foot)[1][i], there.at({}, foot - glm::dvec2(310, -95))[1][i], 1e-4);
}

}  // namespace
}  // namespace sward
