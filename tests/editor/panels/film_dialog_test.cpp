// The dialog of screenshots and films: what it asks for each.
#include "app/film_dialog.h"

#include "editor/panels/panel_stage.h"
#include "panels/panels.h"

namespace sward {
namespace {

class FilmPanel : public test::PanelStage {
  protected:
    FilmPanel() {
        name = "Film";
        draw = [this] { started |= drawFilmDialog(dialog, doc); };
    }
    void open(bool film) {
        askFilm(dialog, doc, film);
        frames(4);
    }
    FilmDialog dialog;
    bool started = false;
};

TEST_F(FilmPanel, AScreenshotNeedsAFileAndASize) {
    open(false);
    EXPECT_EQ(value("Film/Path"), (dir / "meadow.png").string());
    EXPECT_FALSE(shown("Film/Length"));
    click("Film/3840 x 2160");
    EXPECT_EQ(dialog.plan.width, 3840);
    EXPECT_EQ(value("Film/Height"), "2160");
    click("Film/Take");
    EXPECT_TRUE(started);
    EXPECT_EQ(dialog.plan.out, dir / "meadow.png");
    click("Film/Cancel");
    EXPECT_FALSE(dialog.open);
    EXPECT_FALSE(shown("Film/Path"));
}

TEST_F(FilmPanel, AFilmSaysHowManyPicturesItHas) {
    open(true);
    EXPECT_EQ(value("Film/Along"), "the view, which stands");
    EXPECT_EQ(value("Film/Count"), "251 pictures") << "10 s at 25 a second";
    dialog.plan.seconds = 2, dialog.plan.fps = 10;
    frames(2);
    EXPECT_EQ(value("Film/Count"), "21 pictures");
}

}  // namespace
}  // namespace sward
