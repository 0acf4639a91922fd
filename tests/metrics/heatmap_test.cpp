// The colours of a map of errors.
#include "metrics/heatmap.h"

#include <algorithm>
#include <cmath>

#include "metrics/pictures.h"

namespace sward::test {
namespace {

double luminance(const glm::vec3& c) {
    const auto f = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
    return 0.2126 * f(c.x) + 0.7152 * f(c.y) + 0.0722 * f(c.z);
}

TEST(Heatmap, IsEvenlyLighterAsSeen) {
    for (int i = 1; i <= 100; ++i) {
        const double here = 116 * std::cbrt(luminance(heatColor(i / 100.0))) - 16, expected = 2 + 95 * i / 100.0;
        if (expected > 10) EXPECT_NEAR(here, expected, 1) << i;
    }
    const std::vector<uint8_t> pixels = heatmap({0, 0.5f, 2, kNoValue}, 0.5);
    EXPECT_TRUE(std::equal(&pixels[3], &pixels[6], &pixels[6])) << "beyond the scale's end is its end";
    EXPECT_EQ(pixels[9], 0);
    EXPECT_EQ(pixels[10], 255);
}

}  // namespace
}  // namespace sward::test
