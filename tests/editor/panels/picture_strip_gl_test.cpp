// Pictures side by side: which are shown, and how large.
#include "panels/picture_strip.h"

#include "editor/panels/panel_stage.h"
#include "gpu/gpu.h"
#include "gpu/resources.h"

namespace sward {
namespace {

class PictureStrip : public test::PanelStage {
  protected:
    void SetUp() override {
        auto made = makeHeadlessGpu();
        ASSERT_TRUE(made) << made.error().text();
        gpu = std::move(*made);
        PanelStage::SetUp();
    }
    void TearDown() override {
        draw = [] {};
    }
    Texture texture(int width, int height) { return makeTexture2D(*gpu, "test/strip", GL_RGBA8, width, height); }
    ui::Widget at(const std::string& picture) {
        const auto found = book.widgets.find("Panel/" + picture);
        EXPECT_NE(found, book.widgets.end()) << picture;
        return found == book.widgets.end() ? ui::Widget{} : found->second;
    }
    std::unique_ptr<Gpu> gpu;
};

TEST_F(PictureStrip, WhatIsNotMadeYetIsLeftOut) {
    const Texture now = texture(64, 48), none;
    draw = [&] { drawStrip({{"now", &now}, {"accepted", &none}}); };
    frames(2);
    EXPECT_TRUE(shown("Panel/now"));
    EXPECT_FALSE(shown("Panel/accepted"));
    draw = [&] { drawStrip({{"now", &none}}); };
    frames(2);
    EXPECT_FALSE(shown("Panel/now"));
}

TEST_F(PictureStrip, PicturesKeepTheirShapeStandSideBySideAndFitTheWindow) {
    const Texture a = texture(320, 240), b = texture(320, 240), c = texture(320, 240);
    draw = [&] { drawStrip({{"now", &a}, {"accepted", &b}, {"difference", &c}}); };
    frames(2);
    const ui::Widget first = at("now"), second = at("accepted"), third = at("difference");
    for (const ui::Widget& w : {first, second, third}) {
        EXPECT_NEAR((w.x1 - w.x0) / (w.y1 - w.y0), 4.0f / 3, 0.02f);
        EXPECT_TRUE(w.visible);
        EXPECT_GE(w.x0, 0);
        EXPECT_LE(w.x1, 800);
        EXPECT_LE(w.y1, 600);
    }
    EXPECT_LT(first.x1, second.x0);
    EXPECT_LT(second.x1, third.x0);
    EXPECT_EQ(first.y0, third.y0);
    EXPECT_GT(third.x1 - first.x0, 0.9f * 800) << "as large as all of them fit";
}

TEST_F(PictureStrip, ATallPictureIsBoundedByTheWindowsHeight) {
    const Texture tall = texture(16, 256);
    draw = [&] { drawStrip({{"tall", &tall}}); };
    frames(2);
    const ui::Widget w = at("tall");
    EXPECT_LE(w.y1, 600);
    EXPECT_GT(w.y1 - w.y0, 450) << "all that is left";
    EXPECT_NEAR((w.x1 - w.x0) / (w.y1 - w.y0), 1.0f / 16, 0.01f);
}

}  // namespace
}  // namespace sward
