// The fit's held-out cameras; fitting itself: cost_gl_test.cpp.
#include "cost/fit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sward::test {
namespace {

TEST(FitCameras, HeldOutOnesStandAsideAndLookElsewhere) {
    const ViewCamera c{{2, 1.7, 3}, {10, 0, 9}, 55, 0};
    const ViewCamera m = heldOutCamera(c);
    const double length = glm::length(c.target - c.eye);
    EXPECT_NEAR(glm::length(m.eye - c.eye), length / 8, 1e-9);
    EXPECT_NEAR(glm::length(m.target - m.eye), length, 1e-9);
    const glm::dvec2 a(c.target.x - c.eye.x, c.target.z - c.eye.z), b(m.target.x - m.eye.x, m.target.z - m.eye.z);
    EXPECT_NEAR(glm::dot(a, b) / (glm::length(a) * glm::length(b)), std::cos(glm::radians(20.0)), 1e-9);
    EXPECT_EQ(m.eye.y, c.eye.y);
}

}  // namespace
}  // namespace sward::test
