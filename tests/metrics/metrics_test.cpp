#include "metrics/metrics.h"

#include "metrics/heatmap.h"
#include "metrics/pictures.h"
#include "metrics/popping.h"
#include "metrics/ssim.h"

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
        EXPECT_TRUE(std::isnan(errorMap(p, metric)[static_cast<size_t>(30 * 40 + 20)]))
            << kErrorMetrics[metric];
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
TEST(Metrics, RefuseWhatCannotBeCompared) {
    auto sizes = pairPictures(plain(8, 6, glm::vec3(0)), plain(9, 6, glm::vec3(0)));
    ASSERT_FALSE(sizes);
    EXPECT_EQ(sizes.error().code, ExitCode::Failed);
    EXPECT_NE(sizes.error().message.find("8x6 and 9x6"), std::string::npos);
    auto none = pairPictures(plain(8, 6, glm::vec3(kNoValue)), plain(8, 6, glm::vec3(0)));
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ExitCode::Failed);
    Picture linear = plain(8, 6, glm::vec3(0));
    linear.linear = true;
    EXPECT_EQ(pairPictures(linear, plain(8, 6, glm::vec3(0))).error().code, ExitCode::Unsound);
    EXPECT_FALSE(pairPictures(plain(8, 6, glm::vec3(0)), plain(8, 6, glm::vec3(0)), std::vector<float>(48, 0)));
}
TEST(Metrics, ToneMapLinearImagesFirst) {
    const Image exr{1, 1, 3, true, {4, 4, 4}};
    EXPECT_LE(pictureOf(exr, false).pixels[0].x, 1);
    EXPECT_GT(pictureOf(exr, false).pixels[0].x, 0.9);
    EXPECT_EQ(pictureOf(exr, true).pixels[0].x, 4);
    EXPECT_TRUE(std::isnan(pictureOf({1, 1, 3, true, {1, kNoValue, 1}}, false).pixels[0].x))
        << "not black by tone mapping";
}

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
    EXPECT_NEAR(map[60], expected, 1e-4);
    EXPECT_EQ(std::count_if(map.begin(), map.end(), [](float v) { return std::isfinite(v); }), 1);
}

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

// --- popping

Result<Popping> film(size_t pictures, const std::function<Picture(int)>& image,
                     const std::function<Picture(int)>& truth) {
    return popping(pictures, [&](size_t i) -> Result<PicturePair> {
        return pairOf(image(static_cast<int>(i)), truth(static_cast<int>(i)));
    });
}
TEST(Popping, OfWhatChangesAsTheTruthDoesIsZero) {
    const auto truth = [](int i) { return noise(32, 32, static_cast<unsigned>(i)); };
    const auto brighter = [](int i) { return noise(32, 32, static_cast<unsigned>(i), 0.4f, 0.05f); };
    EXPECT_NEAR(film(4, truth, truth)->mean, 0, 1e-9);
    EXPECT_NEAR(film(4, brighter, truth)->mean, 0, 1e-6) << "a constant error does not pop";
}
TEST(Popping, OfAStepIsFoundWhereItIsAndAsLargeAsItIs) {
    const auto still = [](int) { return noise(32, 32, 1, 0.2f); };
    const auto pops = [](int i) { return noise(32, 32, 1, 0.2f, i >= 3 ? 0.1f : 0); };
    const Popping p = *film(6, pops, still);
    EXPECT_EQ(p.worstStep, 2);
    EXPECT_NEAR(p.worst, 0.1, 1e-6);
    EXPECT_NEAR(p.mean, 0.02, 1e-6);
}
TEST(Popping, OfContrastThatSnapsIsSeenToo) {
    const auto still = [](int) { return noise(32, 32, 1, 0.3f); };
    const auto snaps = [](int i) { return noise(32, 32, 1, i == 0 ? 0.3f : 0.1f); };
    EXPECT_GT(film(2, snaps, still)->mean, 0.05);
}
TEST(Popping, RefusesAPathOfOnePictureOrOfSeveralSizes) {
    EXPECT_FALSE(film(
        1, [](int) { return noise(8, 8, 1); }, [](int) { return noise(8, 8, 1); }));
    const auto grows = [](int i) { return plain(8 + i, 8, glm::vec3(0)); };
    EXPECT_FALSE(film(2, grows, grows));
}

}  // namespace
}  // namespace sward::test
