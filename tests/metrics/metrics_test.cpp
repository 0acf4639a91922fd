// The table of metrics of a pair of pictures.
#include "metrics/metrics.h"

#include <cmath>
#include <limits>

#include "metrics/pictures.h"

namespace sward::test {
namespace {

TEST(Metrics, OfEqualPicturesAreTheirBest) {
    const PicturePair p = pairOf(noise(48, 32, 1), noise(48, 32, 1));
    const Metrics m = metricsOf(p);
    EXPECT_EQ(m.rmse, 0);
    EXPECT_TRUE(std::isinf(m.psnr));
    EXPECT_NEAR(m.ssim, 1, 1e-6);
    EXPECT_EQ(m.flip, 0);
    const Json j = metricsJson(m, p, 67);
    EXPECT_EQ(j.find("psnr")->text, "inf");
    EXPECT_EQ(j.find("rmse")->number, 0);
    auto read = parseJson(writeJson(j), "metrics");
    EXPECT_TRUE(read) << read.error().text();
}
TEST(Metrics, RmseAndPsnrOfAKnownDifference) {
    const Metrics m = metricsOf(pairOf(plain(16, 16, {0.6f, 0.5f, 0.5f}), plain(16, 16, glm::vec3(0.5f))));
    EXPECT_NEAR(m.rmse, std::sqrt(0.01 / 3), 1e-7);
    EXPECT_NEAR(m.psnr, 10 * std::log10(300), 1e-5);
}
TEST(Metrics, CountAndLocateWhatIsNotFiniteAndLeaveItOut) {
    Picture image = plain(40, 40, glm::vec3(0.5f)), truth = plain(40, 40, glm::vec3(0.4f));
    image.pixels[static_cast<size_t>(7 * 40 + 3)].x = std::numeric_limits<float>::infinity();
    truth.pixels[static_cast<size_t>(30 * 40 + 20)] = glm::vec3(kNoValue);
    const PicturePair p = pairOf(image, truth);
    EXPECT_EQ(p.nonFinite, 2u);
    EXPECT_EQ(p.nonFiniteX, 3);
    EXPECT_EQ(p.nonFiniteY, 7);
    const Metrics m = metricsOf(p);
    EXPECT_NEAR(m.rmse, 0.1, 1e-6);
    EXPECT_NEAR(m.appearance.distance, 0.1, 1e-6);
    EXPECT_NEAR(m.ssim, (2 * 0.2 + 1e-4) / (0.25 + 0.16 + 1e-4), 1e-5);
    for (const ErrorMetric metric : {ErrorMetric::Appearance, ErrorMetric::Flip, ErrorMetric::Rmse, ErrorMetric::Ssim})
        EXPECT_TRUE(std::isnan(errorMap(p, metric)[static_cast<size_t>(30 * 40 + 20)])) << kErrorMetrics[metric];
    EXPECT_EQ(metricsJson(m, p, 67).find("non_finite")->number, 2);
}
TEST(Metrics, SaySoWhereNoWindowIsWhole) {
    Picture image = plain(24, 24, glm::vec3(0.5f));
    for (int y = 4; y < 24; y += 8)
        for (int x = 4; x < 24; x += 8) image.pixels[static_cast<size_t>(y * 24 + x)].z = kNoValue;
    const PicturePair p = pairOf(image, plain(24, 24, glm::vec3(0.4f)));
    const Metrics m = metricsOf(p);
    EXPECT_TRUE(std::isnan(m.flip));
    EXPECT_TRUE(std::isnan(m.ssim));
    EXPECT_NEAR(m.rmse, std::sqrt(0.01), 1e-6);
    EXPECT_TRUE(metricsJson(m, p, 67).find("flip")->isNull());
    EXPECT_NE(metricsText(m, p, 67).find("9 pixels"), std::string::npos);
}

}  // namespace
}  // namespace sward::test
