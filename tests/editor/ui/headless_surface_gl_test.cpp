// A dense screen: panels keep their places and sizes in points, pictures and letters get more pixels.
#include "editor/editor_fixture.h"

namespace sward {
namespace {

using test::EditorUi;

TEST_F(EditorUi, OnADenseScreenAllKeepsItsSizeAndIsDrawnFiner) {
    const auto show = [&](float density) {
        app = std::make_unique<EditorApp>(doc, *gpu, ui::makeHeadlessSurface(800, 600, density), false);
        ui = makeUiDriver(*app);
        ok(ui->wait(3));
    };
    const auto button = [&] { return *ui->rect("Tabs/History"); };
    show(1);
    const std::array<double, 4> usual = button();
    const Rect view = app->hand.rect;
    EXPECT_EQ(app->picture.width, static_cast<int>(view.w));
    show(2);
    EXPECT_EQ(app->surface->pixelWidth(), 1600);
    EXPECT_EQ(ui::readSurface(*app->surface).size(), 1600u * 1200 * 4);
    for (size_t i = 0; i < 4; ++i) EXPECT_NEAR(button()[i], usual[i], 3) << i;
    EXPECT_NEAR(app->hand.rect.w, view.w, 3);
    EXPECT_EQ(app->picture.width, static_cast<int>(app->hand.rect.w * 2));
    ok(ui->click("Tabs/History"));
    EXPECT_EQ(app->layout.tab, "History");
}

}  // namespace
}  // namespace sward
