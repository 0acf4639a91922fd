// The blur of what is far: weights that sum to 1, whatever the distance (J-10), and light that falls evenly.
#include <gtest/gtest.h>

#include "core/numerics.h"

namespace sward {
namespace {

TEST(NumericsBlur, WeightsSumToOneAndTheCentreKeepsAShare) {
    for (const bool gaussian : {false, true}) {
        float before = 2;
        for (int i = 0; i <= 100; ++i) {
            const glm::vec3 w = f32::blurWeights(static_cast<float>(i) / 100, gaussian);
            EXPECT_NEAR(w.x + 2 * w.y + 2 * w.z, 1, 1e-6f);
            EXPECT_GT(w.x, 0);
            EXPECT_LT(w.x, before) << "the farther, the more of its neighbours";
            before = w.x;
        }
        EXPECT_EQ(f32::blurWeights(0, gaussian), glm::vec3(1, 0, 0)) << "what is at the eye is as it was";
    }
    EXPECT_NEAR(f32::blurWeights(1, false).x, 1.0f / 7, 1e-6f) << "seven pixels alike";
}

TEST(NumericsBlur, FarLightFallsEvenlyAndNoFartherThanItsShare) {
    EXPECT_EQ(f32::farLight(0, 0.6f, 50), 1);
    EXPECT_NEAR(f32::farLight(25, 0.6f, 50), 0.7f, 1e-6f);
    EXPECT_NEAR(f32::farLight(5000, 0.6f, 50), 0.4f, 1e-6f);
    EXPECT_EQ(f32::farShare(1, 0), 1) << "no division by a reach of nothing";
}

}  // namespace
}  // namespace sward
