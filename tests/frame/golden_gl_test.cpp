// Pictures of the test scenes against stored ones: mean error 0.1/255, at most 1% of pixels off by more than 8.
// On failure the actual picture, the stored one and their difference lie in the build folder, under golden/.
// To store new ones after a wanted change: SWARD_WRITE_GOLDEN=1 build/release/sward_gl_tests --gtest_filter=Golden*
#include "metrics/heatmap.h"
#include "metrics/metrics.h"
#include "project/project_files.h"
#include "scenes.h"
#include "techniques.h"
#include "world/view_camera.h"

namespace sward::test {
namespace {
namespace fs = std::filesystem;

constexpr int kWidth = 240, kHeight = 135;

struct Closeness {
    double mean = 0;  // of 255
    double far = 0;   // share of pixels off by more than 8
};
Closeness compare(const std::vector<uint8_t>& image, const Image& golden) {
    Closeness c;
    for (size_t i = 0; i < image.size(); i += 3) {
        int worst = 0;
        for (size_t k = 0; k < 3; ++k) {
            const int d = std::abs(image[i + k] - static_cast<int>(std::lround(255 * golden.pixels[i + k])));
            c.mean += d;
            worst = std::max(worst, d);
        }
        c.far += worst > 8;
    }
    c.mean /= static_cast<double>(image.size());
    c.far /= static_cast<double>(image.size() / 3);
    return c;
}

std::vector<uint8_t> difference(const Image& actual, const Image& golden) {
    auto pair = pairPictures(pictureOf(actual, false), pictureOf(golden, false));
    EXPECT_TRUE(pair);
    return heatmap(errorMap(*pair, ErrorMetric::Rmse), heatScale(ErrorMetric::Rmse));
}

void keepEvidence(const std::string& name, const std::vector<uint8_t>& image, const Image& golden) {
    const fs::path folder = fs::path(SWARD_BINARY_DIR) / "golden";
    fs::create_directories(folder);
    Image actual{kWidth, kHeight, 3, false, {}};
    for (uint8_t v : image) actual.pixels.push_back(v / 255.0f);
    std::vector<uint8_t> stored;
    for (float v : golden.pixels) stored.push_back(static_cast<uint8_t>(std::lround(255 * v)));
    EXPECT_TRUE(writeImagePng(folder / (name + "-actual.png"), kWidth, kHeight, 3, image));
    EXPECT_TRUE(writeImagePng(folder / (name + "-expected.png"), kWidth, kHeight, 3, stored));
    EXPECT_TRUE(writeImagePng(folder / (name + "-difference.png"), kWidth, kHeight, 3, difference(actual, golden)));
}

TEST(Golden, Field40LooksAsItDid) {
    NoGlErrors errors;
    const fs::path source(SWARD_SOURCE_DIR), file = source / "tests/golden/field40-eye.png";
    auto project = loadProject(source / "tests/scenes/field40", tables().components);
    ASSERT_TRUE(project) << project.error().text();
    Renderer r(gpu(), tables());
    ViewSettings s;
    s.width = kWidth, s.height = kHeight;
    ASSERT_TRUE(r.draw(*project, viewOf(*findCamera(*project, "eye")), s));
    const auto image = r.readImage();
    if (std::getenv("SWARD_WRITE_GOLDEN")) {
        ASSERT_TRUE(writeImagePng(file, kWidth, kHeight, 3, image));
    }
    auto golden = readImage(file);
    ASSERT_TRUE(golden) << golden.error().text();
    ASSERT_EQ(golden->width, kWidth);
    ASSERT_EQ(golden->channels, 3);
    const Closeness c = compare(image, *golden);
    EXPECT_LE(c.mean, 0.1);
    EXPECT_LE(c.far, 0.01);
    if (c.mean > 0.1 || c.far > 0.01) keepEvidence("field40-eye", image, *golden);
    // The check can fail: the same field with another seed is not the stored one.
    project->registry.get<GrassField>(findEntity(*project, "lawn"))->seed += 1;
    ASSERT_TRUE(r.draw(*project, viewOf(*findCamera(*project, "eye")), s));
    EXPECT_GT(compare(r.readImage(), *golden).far, 0.01);
}

}  // namespace
}  // namespace sward::test
