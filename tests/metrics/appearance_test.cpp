#include "metrics/appearance.h"

#include "metrics/pictures.h"

namespace sward::test {
namespace {

// Rows of black and white; the mean of any even block is a half and its deviation a half.
Picture stripes(int width, int height, int phase) {
    return made(width, height, [&](int, int y) { return glm::vec3(static_cast<float>((y + phase) % 2)); });
}

TEST(Appearance, OfEqualPicturesIsZero) {
    const Appearance a = appearance(pairOf(noise(64, 48, 1), noise(64, 48, 1)));
    EXPECT_EQ(a.distance, 0);
    EXPECT_EQ(a.sigma, 0);
}
TEST(Appearance, OfAnotherGrayIsItsBias) {
    const Appearance a = appearance(pairOf(plain(32, 32, glm::vec3(0.75f)), plain(32, 32, glm::vec3(0.5f))));
    EXPECT_NEAR(a.distance, 0.25, 1e-7);
    EXPECT_NEAR(a.bias, 0.25, 1e-7);
    EXPECT_NEAR(a.contrast, 0, 1e-7);
    EXPECT_NEAR(a.sigma, 0, 1e-7);
}
TEST(Appearance, OfOneChannelOfThreeIsAThird) {
    EXPECT_NEAR(appearance(pairOf(plain(16, 16, {0.5f, 0.8f, 0.5f}), plain(16, 16, glm::vec3(0.5f)))).distance, 0.1,
                1e-7);
}
TEST(Appearance, OfGrayForStripesIsTheirContrast) {
    const Appearance a = appearance(pairOf(plain(32, 32, glm::vec3(0.5f)), stripes(32, 32, 0)));
    EXPECT_NEAR(a.distance, 0.5, 1e-7);
    EXPECT_NEAR(a.bias, 0, 1e-7);
    EXPECT_NEAR(a.contrast, 0.5, 1e-7);
}
TEST(Appearance, OfStripesThatLieElsewhereIsZero) {
    EXPECT_NEAR(appearance(pairOf(stripes(32, 32, 0), stripes(32, 32, 1))).distance, 0, 1e-7);
}
TEST(Appearance, PartsBoundIt) {
    const Appearance a = appearance(pairOf(noise(67, 45, 1, 0.4f), noise(67, 45, 2, 0.2f, 0.1f)));
    EXPECT_GE(a.distance, std::max(a.bias, a.contrast));
    EXPECT_LE(a.distance, a.bias + a.contrast);
    EXPECT_GT(std::min(a.bias, a.contrast), 0.05);
}

// One block of 16 by hand, with weights.
TEST(Appearance, WeighsPixelsByTheMask) {
    std::vector<float> mask(16 * 16, 0);
    mask[0] = 1, mask[1] = 0.5f;  // of image and truth: 1 and 0.4; 0.2 and 0.2
    Picture image = plain(16, 16, glm::vec3(0.9f)), truth = plain(16, 16, glm::vec3(0));
    image.pixels[0] = glm::vec3(1), image.pixels[1] = glm::vec3(0.4f);
    truth.pixels[0] = truth.pixels[1] = glm::vec3(0.2f);
    const Appearance a = appearance(pairOf(image, truth, mask));
    const double mean = (1 + 0.5 * 0.4) / 1.5,
                 deviation = std::sqrt(((1 - mean) * (1 - mean) + 0.5 * (0.4 - mean) * (0.4 - mean)) / 1.5);
    EXPECT_NEAR(a.bias, mean - 0.2, 1e-6);
    EXPECT_NEAR(a.contrast, deviation, 1e-6);
    EXPECT_NEAR(a.distance, std::hypot(mean - 0.2, deviation), 1e-6);
    EXPECT_TRUE(std::isnan(a.sigma)) << "one block tells nothing of the spread";
}

// The jackknife of a mean is the standard error that textbooks have for it.
TEST(Appearance, SigmaIsTheStandardErrorOfTheBlocksMean) {
    constexpr int kBlocks = 12;
    std::vector<double> values;
    for (int i = 0; i < kBlocks; ++i) values.push_back(0.01 * (i * i % 7));
    const Picture image = made(16 * kBlocks, 16, [&](int x, int) {
        return glm::vec3(static_cast<float>(0.5 + values[static_cast<size_t>(x / 16)]));
    });
    const Appearance a = appearance(pairOf(image, plain(16 * kBlocks, 16, glm::vec3(0.5f))));
    double mean = 0, squares = 0;
    for (const double v : values) mean += v / kBlocks;
    for (const double v : values) squares += (v - mean) * (v - mean);
    EXPECT_NEAR(a.distance, mean, 1e-6);
    EXPECT_NEAR(a.sigma, std::sqrt(squares / (kBlocks - 1) / kBlocks), 1e-6);
}
// Fields of other noise differ by about as much as sigma says.
TEST(Appearance, SigmaTellsHowFarOtherGroundOfTheKindLies) {
    std::vector<double> distances;
    double sigma = 0;
    constexpr int kFields = 40;
    for (unsigned i = 0; i < kFields; ++i) {
        const Appearance a = appearance(pairOf(noise(64, 64, 2 * i), noise(64, 64, 2 * i + 1)));
        distances.push_back(a.distance);
        sigma += a.sigma / kFields;
    }
    double mean = 0, squares = 0;
    for (const double d : distances) mean += d / kFields;
    for (const double d : distances) squares += (d - mean) * (d - mean) / (kFields - 1);
    EXPECT_NEAR(sigma / std::sqrt(squares), 1, 0.35);
}
TEST(Appearance, MapHasTheMetricForItsMean) {
    const PicturePair p = pairOf(noise(50, 37, 1), noise(50, 37, 2, 0.3f));
    EXPECT_NEAR(weightedMean(appearanceMap(p), p.weight), appearance(p).distance, 1e-6);
}
// A truth of few rays has the contrast of their scatter, which none of its blades has: who draws grain gains by it.
// Truths of 16, 64 and 256 rays, each the mean of rays that scatter by 0.15 of full light.
TEST(Appearance, IsTheSameHoweverManyRaysTheTruthHas) {
    const Picture image = noise(128, 128, 1, 0.15f), blades = noise(128, 128, 2, 0.1f);
    std::vector<Appearance> known, unknown;
    for (const int rays : {16, 64, 256}) {
        std::mt19937 random(static_cast<unsigned>(rays));
        std::normal_distribution<float> scatter(0, 0.15f / std::sqrt(static_cast<float>(rays)));
        Picture truth = blades;
        for (glm::vec3& c : truth.pixels)
            for (int k = 0; k < 3; ++k) c[k] += scatter(random);
        unknown.push_back(appearance(pairOf(image, truth)));
        truth.noise.assign(truth.pixels.size(), glm::vec3(scatter.stddev() * scatter.stddev()));
        known.push_back(appearance(pairOf(image, truth)));
    }
    EXPECT_NEAR(known[0].distance, known[2].distance, 0.02 * known[2].distance);
    EXPECT_NEAR(known[1].distance, known[2].distance, 0.02 * known[2].distance);
    EXPECT_GT(std::abs(unknown[0].distance - unknown[2].distance), 0.1 * unknown[2].distance);
}
TEST(Appearance, BlocksWithoutContrastButThatOfRaysHaveNone) {
    Picture scattered = noise(64, 64, 1, 0.1f);
    scattered.noise.assign(scattered.pixels.size(), glm::vec3(2 * 0.01f / 3));
    const BlockMoments b = blockMoments(scattered, std::vector<float>(64 * 64, 1), 0, 0, 16);
    EXPECT_GE(b.deviation.x, 0) << "not the root of less than nothing";
    EXPECT_LE(b.deviation.x, std::sqrt(b.meanNoise.x)) << "no more than what cannot be told from scatter";
    EXPECT_NEAR(b.meanNoise.x, 2 * 0.01 / 3 / 256, 1e-9);
}
TEST(Appearance, RanksOtherNoiseAheadOfFlatGrayWhereRmseDoesNot) {
    const Picture truth = noise(64, 64, 1), other = noise(64, 64, 2), flat = plain(64, 64, glm::vec3(0.5f));
    EXPECT_LT(3 * appearance(pairOf(other, truth)).distance, appearance(pairOf(flat, truth)).distance);
}

}  // namespace
}  // namespace sward::test
