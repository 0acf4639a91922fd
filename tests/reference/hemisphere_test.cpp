#include "reference/hemisphere.h"

#include <gtest/gtest.h>

namespace sward::test {
namespace {

TEST(Hemisphere, DirectionsAreUnitAndAsLikelyAsTheirCosine) {
    constexpr int kSteps = 200;
    for (const glm::vec3& n : {glm::vec3(0, 1, 0), glm::vec3(1, 0, 0), glm::normalize(glm::vec3(1, -2, 0.5f))}) {
        glm::dvec3 sum(0);
        for (int i = 0; i < kSteps; ++i)
            for (int k = 0; k < kSteps; ++k) {
                const glm::vec3 way = cosineAround(n, (float(i) + 0.5f) / kSteps, (float(k) + 0.5f) / kSteps);
                ASSERT_NEAR(glm::length(way), 1, 1e-5f);
                ASSERT_GT(glm::dot(way, n), 0);
                sum += glm::dvec3(way) / double(kSteps * kSteps);
            }
        EXPECT_NEAR(glm::length(sum - glm::dvec3(n) * (2.0 / 3)), 0, 1e-3) << "the mean of the cosine's square";
    }
}

}  // namespace
}  // namespace sward::test
