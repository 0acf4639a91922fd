// The surface without a window: what it shows is read back whole.
#include "editor/editor_fixture.h"
#include "maps/map_io.h"

namespace sward {
namespace {

using test::EditorUi;

TEST_F(EditorUi, AScreenshotShowsTheWholeWindow) {
    ok(ui->screenshot(dir / "editor.png"));
    const Result<Image> image = readImage(dir / "editor.png");
    ASSERT_TRUE(image);
    EXPECT_EQ(image->width, 800);
    EXPECT_EQ(image->height, 600);
    const auto at = [&](int x, int y) {
        return image
            ->pixels[(static_cast<size_t>(y) * 800 + static_cast<size_t>(x)) * static_cast<size_t>(image->channels)];
    };
    const Rect& r = app->hand.rect;
    EXPECT_GT(at(static_cast<int>(r.x + r.w / 2), static_cast<int>(r.y + 10)), 0.4f);  // sky
    EXPECT_LT(at(790, 300), 0.35f);                                                    // a dark panel
}

}  // namespace
}  // namespace sward
