// Small pictures: what is in them, that they are kept, and what cannot be shown.
#include "model/portrait.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "core/file.h"
#include "maps/map_io.h"
#include "mesh/mesh_io.h"
#include "mesh/mesh_shapes.h"
#include "model/species_presets.h"
#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

namespace fs = std::filesystem;

class Portraits : public testing::Test {
  protected:
    std::vector<fs::path> kept() {
        std::vector<fs::path> files;
        if (fs::exists(cacheDir() / "portraits"))
            for (const auto& file : fs::directory_iterator(cacheDir() / "portraits")) files.push_back(file.path());
        return files;
    }
    void putBall(const std::string& file, const glm::vec3& color, float radius) {
        Solid ball;
        ball.kind = SolidKind::Ball;
        ball.size = glm::vec3(radius);
        ball.at = {0, radius, 0};
        ball.color = color;
        test::writeText(dir / file, *encodeGlb(makeMesh({&ball, 1})));
    }
    test::TempDir dir;
    test::EmptyCache cache;
    JobControl control;
};

glm::dvec3 meanOf(const Rgba8& image, int x0, int y0, int x1, int y1) {
    glm::dvec3 sum(0);
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x)
            for (int c = 0; c < 3; ++c) sum[c] += image.pixels[static_cast<size_t>((y * image.width + x) * 4 + c)];
    return sum / static_cast<double>((x1 - x0) * (y1 - y0));
}

TEST_F(Portraits, AnObjectFillsTheMiddleWhateverItsSizeAndIsTracedOnce) {
    const int mid = kPortraitSide / 2;
    for (const float radius : {0.02f, 40.f}) {
        putBall("ball.glb", {0.5f, 0.02f, 0.02f}, radius);
        const Result<Rgba8> picture = portraitOfModel(dir.path, "ball.glb", tables(), control);
        ASSERT_TRUE(picture) << picture.error().text();
        ASSERT_EQ(picture->width, kPortraitSide);
        const glm::dvec3 middle = meanOf(*picture, mid - 8, mid - 8, mid + 8, mid + 8);
        EXPECT_GT(middle.x, 2 * middle.y) << radius;
        const glm::dvec3 corner = meanOf(*picture, 0, 0, 8, 8);
        EXPECT_LT(std::abs(corner.x - corner.y), 40) << "plain ground around it";
    }
    ASSERT_EQ(kept().size(), 2u);
    // What lies in the cache is what is shown from then on.
    putBall("other.glb", {0.5f, 0.02f, 0.02f}, 40.f);
    for (const fs::path& file : kept())
        ASSERT_TRUE(writeImagePng(file, kPortraitSide, kPortraitSide, 4,
                                  std::vector<uint8_t>(kPortraitSide * kPortraitSide * 4, 7)));
    const Result<Rgba8> again = portraitOfModel(dir.path, "other.glb", tables(), control);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->pixels[0], 7) << "the same triangles under another name";
}

TEST_F(Portraits, WhatIsNoObjectSaysWhyAndIsNotKept) {
    test::writeText(dir / "bad.glb", "no glTF");
    const Result<Rgba8> picture = portraitOfModel(dir.path, "bad.glb", tables(), control);
    ASSERT_FALSE(picture);
    EXPECT_NE(picture.error().text().find("bad.glb"), std::string::npos) << picture.error().text();
    EXPECT_TRUE(kept().empty());
}

TEST_F(Portraits, EveryPresetHasALookOfItsOwn) {
    std::vector<glm::dvec3> means;
    for (const SpeciesPreset& preset : speciesPresets()) {
        const Species s = speciesOf(preset);
        const Result<Rgba8> picture = portraitOfSpecies(s, presetFolder(), tables(), control);
        ASSERT_TRUE(picture) << preset.name << ": " << picture.error().text();
        means.push_back(meanOf(*picture, 16, 48, 112, 112));
    }
    const auto mean = [&](const std::string& name) {
        for (size_t i = 0; i < means.size(); ++i)
            if (name == speciesPresets()[i].name) return means[i];
        return glm::dvec3(0);
    };
    for (const char* green : {"pitch", "lawn", "meadow", "reed"}) EXPECT_GT(mean(green).y, mean(green).x) << green;
    for (const char* dry : {"wheat", "straw"}) EXPECT_GT(mean(dry).x, mean(dry).y) << dry;
    EXPECT_GT(mean("heather").z + mean("heather").x, 1.7 * mean("heather").y);
}

TEST_F(Portraits, AnImageIsShrunkInItsOwnShape) {
    std::vector<uint8_t> pixels(512 * 256 * 3);
    for (size_t i = 0; i < pixels.size(); i += 3) pixels[i] = (i / 3) % 512 < 256 ? 200 : 40;
    ASSERT_TRUE(writeImagePng(dir / "wide.png", 512, 256, 3, pixels));
    const Result<Rgba8> picture = portraitOfImage(dir / "wide.png", control);
    ASSERT_TRUE(picture) << picture.error().text();
    EXPECT_EQ(picture->width, 128);
    EXPECT_EQ(picture->height, 64);
    EXPECT_NEAR(meanOf(*picture, 4, 4, 60, 60).x, 200, 1);
    EXPECT_NEAR(meanOf(*picture, 68, 4, 124, 60).x, 40, 1);
}

TEST_F(Portraits, MapsShowAmountsInGreyAndHeightsFromLowToHigh) {
    Map heights({8, 8, 1, PixelType::F32});
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) heights.set(x, y, 0, x < 4 ? 100.f : 103.f);
    const Rgba8 relief = portraitOfMap(heights, MapKind::Heights);
    EXPECT_EQ(relief.width, 8) << "small maps stay small";
    EXPECT_EQ(relief.pixels[0], 0);
    EXPECT_EQ(relief.pixels[7 * 4], 255);
    Map half({300, 300, 1, PixelType::U16});
    for (int y = 0; y < 300; ++y)
        for (int x = 0; x < 300; ++x) half.set(x, y, 0, y < 150 ? 0.5f : 0.f);
    const Rgba8 amounts = portraitOfMap(half, MapKind::Amounts);
    EXPECT_EQ(amounts.width, kPortraitSide);
    EXPECT_NEAR(meanOf(amounts, 0, 0, 128, 60).y, 128, 1);
    EXPECT_NEAR(meanOf(amounts, 0, 68, 128, 128).y, 0, 1);
}

}  // namespace
}  // namespace sward
