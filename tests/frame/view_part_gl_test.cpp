// Pictures drawn in parts, and with a share of the blades: what the editor's viewport does on a slow renderer.
#include <gtest/gtest.h>

#include "frame/renderer.h"
#include "project/project_files.h"
#include "scenes.h"
#include "support.h"
#include "techniques.h"
#include "world/view_camera.h"

namespace sward {
namespace {

class ViewParts : public testing::Test {
  protected:
    void SetUp() override {
        auto opened = newProject(dir / "lawn", tables().components);
        ASSERT_TRUE(opened) << opened.error().text();
        project = std::make_unique<Project>(std::move(*opened));
        renderer = std::make_unique<Renderer>(test::gpu(), tables());
    }
    std::vector<uint8_t> draw(const ViewSettings& settings) {
        const Status drawn = renderer->draw(*project, viewOf(*findCamera(*project, "")), settings);
        EXPECT_TRUE(drawn) << drawn.error().text();
        return renderer->readImage();
    }

    test::TempDir dir;
    test::NoGlErrors errors;
    std::unique_ptr<Project> project;
    std::unique_ptr<Renderer> renderer;
};

TEST_F(ViewParts, PartsSideBySideEqualTheWhole) {
    ViewSettings whole;
    whole.width = 160, whole.height = 96;
    const std::vector<uint8_t> expected = draw(whole);
    double difference = 0;
    for (int part = 0; part < 4; ++part) {
        ViewSettings s = whole;
        s.width = 80, s.height = 48;
        s.part = {part % 2 * 80, part / 2 * 48, 160, 96};
        const std::vector<uint8_t> pixels = draw(s);
        for (int y = 0; y < 48; ++y)
            for (int i = 0; i < 80 * 3; ++i) {
                const int row = 96 - s.part.y - 48 + y;  // images have their first row on top
                const size_t at = static_cast<size_t>((row * 160 + s.part.x) * 3 + i);
                difference += std::abs(int(pixels[static_cast<size_t>(y * 80 * 3 + i)]) - int(expected[at]));
            }
    }
    EXPECT_LT(difference / static_cast<double>(expected.size()), 0.3);  // edges that round to another sample
}

// A multisample texture of one sample may be one of four.
TEST_F(ViewParts, OneSampleTakesTheMemoryOfOneAndShowsTheSameDepthsAndBrush) {
    const auto distance = [](const std::vector<uint8_t>& a, const std::vector<uint8_t>& b) {
        double sum = 0;
        for (size_t i = 0; i < a.size(); ++i) sum += std::abs(int(a[i]) - int(b[i]));
        return sum / static_cast<double>(a.size());
    };
    ViewSettings s;
    s.width = 160, s.height = 96, s.mode = ViewMode::Depth;
    const std::vector<uint8_t> four = draw(s);
    s.msaa = 1;
    EXPECT_LT(distance(draw(s), four), 6);
    EXPECT_LE(test::gpu().ledger["frame/targets"], 160 * 96 * (8 + 8 + 4));
    s.mode = ViewMode::Final;
    const std::vector<uint8_t> plain = draw(s);
    const Camera& c = *findCamera(*project, "");
    s.decal = {c.target.x, c.target.z, 3, 0.5f};
    EXPECT_GT(distance(draw(s), plain), 1) << "the brush is seen on the ground";
}

TEST_F(ViewParts, AShareOfTheBladesIsDrawnAndCoversAboutAsMuch) {
    ViewSettings s;
    s.width = 120, s.height = 80, s.counted = true;
    const auto meanOf = [](const std::vector<uint8_t>& pixels) {
        double sum = 0;
        for (const uint8_t p : pixels) sum += p;
        return sum / static_cast<double>(pixels.size());
    };
    const double full = meanOf(draw(s));
    const uint64_t blades = renderer->stats().bladesGeometry;
    s.detail = 0.25f;
    const double thin = meanOf(draw(s));
    const double share = static_cast<double>(renderer->stats().bladesGeometry) / static_cast<double>(blades);
    EXPECT_LT(share, 0.27);
    EXPECT_GT(share, 0.05) << "a quarter of each cell's; those of them that are left to slices are not even listed";
    EXPECT_NEAR(thin, full, 6);
}

}  // namespace
}  // namespace sward
