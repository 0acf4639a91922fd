// Passes of the reference and what they add up to.
#include "editor/accuracy/accuracy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "app/frame_clock.h"
#include "app/viewport.h"

namespace sward {
namespace {

Truth passOf(std::mt19937& random) {
    Truth t{3, 2, std::vector<float>(18), std::vector<float>(18), std::vector<float>(6)};
    for (float& v : t.color) v = std::uniform_real_distribution<float>(0, 4)(random);
    for (float& v : t.grass) v = random() % 2 ? 1.0f : 0.0f;
    return t;
}

TEST(Accuracy, PassesSummedAreTheirMeanAndItsStandardError) {
    std::mt19937 random(3);
    PassSum sum;
    std::vector<Truth> passes;
    for (int i = 0; i < 24; ++i) passes.push_back(passOf(random)), addPass(sum, passes.back());
    const Truth mean = meanOf(sum);
    ASSERT_EQ(mean.color.size(), 18u);
    double errors = 0;
    for (size_t p = 0; p < 18; ++p) {
        double m = 0, squares = 0;
        for (const Truth& t : passes) m += static_cast<double>(t.color[p]) / 24;
        for (const Truth& t : passes)
            squares += (static_cast<double>(t.color[p]) - m) * (static_cast<double>(t.color[p]) - m);
        EXPECT_NEAR(mean.color[p], m, 1e-5);
        EXPECT_NEAR(mean.error[p], std::sqrt(squares / 23 / 24), 1e-5);
        errors += std::sqrt(squares / 23 / 24) / 18;
    }
    EXPECT_NEAR(meanError(mean), errors, 1e-5);
    double grass = 0;
    for (const Truth& t : passes) grass += static_cast<double>(t.grass[4]) / 24;
    EXPECT_NEAR(mean.grass[4], grass, 1e-6);
}

TEST(Accuracy, OnePassHasNoKnownError) {
    std::mt19937 random(4);
    PassSum sum;
    addPass(sum, passOf(random));
    EXPECT_TRUE(std::isinf(meanOf(sum).error[0]));
    EXPECT_TRUE(std::isfinite(meanOf(sum).color[0]));
}

TEST(Accuracy, TheReferenceIsNoWiderThanItMayBe) {
    EXPECT_EQ(comparisonSize(480, 300), glm::ivec2(480, 300));
    EXPECT_EQ(comparisonSize(482, 300), glm::ivec2(241, 150));
    EXPECT_EQ(comparisonSize(1900, 3), glm::ivec2(475, 1));
    EXPECT_EQ(comparisonSize(1, 1), glm::ivec2(1, 1));
}

TEST(ComparedView, RestsOnceTheWholePictureIsThereAndNothingMoves) {
    FlyCamera camera;
    ViewportPicture picture;
    ViewportHand hand;
    FrameClock clock;
    picture.width = 80, picture.height = 60;
    const auto rests = [&](bool making = false) { return comparedView(camera, picture, hand, clock, making).rests; };
    EXPECT_FALSE(rests()) << "there is no picture";
    picture.hasImage = true;
    EXPECT_FALSE(rests()) << "it is coarse";
    picture.resolution.drawnScale = 1;
    EXPECT_TRUE(rests());
    EXPECT_FALSE(rests(true)) << "a draft is shown";
    hand.gesture = Gesture::Orbit;
    EXPECT_FALSE(rests());
    hand.gesture = Gesture::None, hand.flying = true;
    EXPECT_FALSE(rests());
    clock.fixed = true;
    EXPECT_FALSE(rests()) << "without a window it waits for a screenshot";
    clock.refineNow = true;
    EXPECT_TRUE(rests());
    EXPECT_EQ(comparedView(camera, picture, hand, clock, false).width, 80);
}

}  // namespace
}  // namespace sward
