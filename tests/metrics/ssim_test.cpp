// SSIM against its formula, written out over one window.
#include "metrics/ssim.h"

#include <algorithm>
#include <cmath>

#include "metrics/pictures.h"

namespace sward::test {
namespace {

// Wang's formula over one window, straight.
TEST(Ssim, IsWhatTheFormulaGivesForAWindow) {
    const Picture a = noise(11, 11, 1), b = noise(11, 11, 2);
    double weights = 0, ma = 0, mb = 0, aa = 0, bb = 0, ab = 0;
    for (int i = 0; i < 121; ++i) {
        const double w = std::exp(-((i % 11 - 5) * (i % 11 - 5) + (i / 11 - 5) * (i / 11 - 5)) / (2 * 1.5 * 1.5));
        const glm::dvec3 luma(0.2126, 0.7152, 0.0722);
        const double x = glm::dot(glm::dvec3(a.pixels[static_cast<size_t>(i)]), luma),
                     y = glm::dot(glm::dvec3(b.pixels[static_cast<size_t>(i)]), luma);
        weights += w, ma += w * x, mb += w * y, aa += w * x * x, bb += w * y * y, ab += w * x * y;
    }
    ma /= weights, mb /= weights;
    const double va = aa / weights - ma * ma, vb = bb / weights - mb * mb, cov = ab / weights - ma * mb;
    const double expected = (2 * ma * mb + 1e-4) * (2 * cov + 9e-4) / ((ma * ma + mb * mb + 1e-4) * (va + vb + 9e-4));
    const ErrorMap map = ssimMap(pairOf(a, b));
    EXPECT_NEAR(map[60], expected, 1e-6);
    EXPECT_EQ(std::count_if(map.begin(), map.end(), [](float v) { return std::isfinite(v); }), 1);
}

// Even grey has no variance at all: what rounding makes of it must not add to the likeness.
TEST(Ssim, IsNeverAboveOne) {
    for (int grey = 0; grey < 255; ++grey) {
        const auto even = [](int level) { return plain(16, 16, glm::vec3(static_cast<float>(level) / 255)); };
        const ErrorMap map = ssimMap(pairOf(even(grey), even(grey + 1)));
        for (const float v : map)
            if (std::isfinite(v)) ASSERT_TRUE(v <= 1 && v > 0.3f) << grey << ": " << v;
    }
}

}  // namespace
}  // namespace sward::test
