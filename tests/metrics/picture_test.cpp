// Pictures that are compared: how files become such, and which pairs are refused.
#include "metrics/picture.h"

#include <cmath>

#include "metrics/pictures.h"

namespace sward::test {
namespace {

TEST(Pictures, RefuseWhatCannotBeCompared) {
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

// Rays that scatter, many times: the picture's noise is how much its values do, and their mean is the value without.
TEST(Pictures, OfRaysKnowTheScatterOfTheirValuesAndMeanWhatTheyWouldWithoutIt) {
    constexpr int kTimes = 20000;
    const glm::vec3 light(0.10f, 0.16f, 0.06f);
    const float error = 0.012f;
    std::mt19937 random(1);
    std::normal_distribution<float> scatter(0, error);
    std::vector<float> rgb, errors(3 * kTimes, error);
    for (int i = 0; i < kTimes; ++i) {
        const float by = scatter(random);
        for (int k = 0; k < 3; ++k) rgb.push_back(light[k] + by);
    }
    const Picture still = pictureOfLinear(1, 1, {light.x, light.y, light.z}), bent = pictureOfLinear(kTimes, 1, rgb),
                  known = tracedPicture(kTimes, 1, rgb, errors);
    glm::dvec3 mean(0), bentMean(0), squares(0), noise(0);
    for (size_t i = 0; i < kTimes; ++i)
        mean += glm::dvec3(known.pixels[i]) / double(kTimes), bentMean += glm::dvec3(bent.pixels[i]) / double(kTimes),
            noise += glm::dvec3(known.noise[i]) / double(kTimes);
    for (size_t i = 0; i < kTimes; ++i)
        squares += (glm::dvec3(bent.pixels[i]) - bentMean) * (glm::dvec3(bent.pixels[i]) - bentMean) / double(kTimes);
    for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(noise[k] / squares[k], 1, 0.12) << k;
        EXPECT_LT(std::abs(mean[k] - static_cast<double>(still.pixels[0][k])),
                  0.35 * std::abs(bentMean[k] - static_cast<double>(still.pixels[0][k])) + 6e-4)
            << k << ": to a sixth of a level of 255, where the bend is none or tone mapping has a kink";
    }
}
TEST(Pictures, OfOneRayOrWithoutValueHaveNoNoise) {
    const float inf = std::numeric_limits<float>::infinity();
    const Picture p = tracedPicture(3, 1, {0.1f, 0.1f, 0.1f, kNoValue, 0.1f, 0.1f, 0, 0, 0},
                                    {inf, inf, inf, 0.1f, 0.1f, 0.1f, 0, 0, 0});
    for (const glm::vec3& n : p.noise) EXPECT_EQ(n, glm::vec3(0));
    EXPECT_EQ(p.pixels[0], pictureOfLinear(1, 1, {0.1f, 0.1f, 0.1f}).pixels[0]);
    EXPECT_EQ(p.pixels[2], glm::vec3(0));
}
TEST(Pictures, OfRaysAsTheyAreHaveTheVarianceOfTheirError) {
    const Picture p = tracedPicture({1, 1, 3, true, {1, 2, 3}}, {1, 1, 3, true, {0.1f, 0.2f, 0.3f}}, true);
    EXPECT_NEAR(p.noise[0].z, 0.09f, 1e-6f);
    EXPECT_EQ(p.pixels[0], glm::vec3(1, 2, 3));
}

TEST(Pictures, ToneMapLinearImagesFirst) {
    const Image exr{1, 1, 3, true, {4, 4, 4}};
    EXPECT_LE(pictureOf(exr, false).pixels[0].x, 1);
    EXPECT_GT(pictureOf(exr, false).pixels[0].x, 0.9);
    EXPECT_EQ(pictureOf(exr, true).pixels[0].x, 4);
    EXPECT_TRUE(std::isnan(pictureOf({1, 1, 3, true, {1, kNoValue, 1}}, false).pixels[0].x))
        << "not black by tone mapping";
}

}  // namespace
}  // namespace sward::test
