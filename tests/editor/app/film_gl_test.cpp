// Screenshots and films: strips come to the whole picture, the editor goes on meanwhile, Cancel ends it.
#include "app/film.h"

#include "editor/editor_fixture.h"
#include "maps/map_io.h"

namespace sward {
namespace {

using test::EditorUi;

TEST_F(EditorUi, StripsOfAScreenshotAreThePictureThatIsDrawnAtOnce) {
    const ViewCamera view = viewOf(app->view.camera);
    const FilmPlan plan{.out = dir / "shot.png", .width = 96, .height = 80};
    auto film = startFilm(doc, *gpu, plan, view, ViewMode::Final);
    ASSERT_TRUE(film) << film.error().text();
    int calls = 1;
    std::optional<Status> end;
    while (!(end = pumpFilm(**film, 0))) ++calls, (*film)->rows = 16;
    ASSERT_TRUE(*end) << end->error().text();
    EXPECT_EQ(calls, 5) << "16 rows at a time";
    Renderer renderer(*gpu, doc.tables());
    ViewSettings s;
    s.width = 96, s.height = 80;
    ASSERT_TRUE(renderer.draw(doc.project(), view, s));
    const std::vector<uint8_t> whole = renderer.readImage();
    ASSERT_EQ((*film)->pixels.size(), whole.size());
    double difference = 0;
    for (size_t i = 0; i < whole.size(); ++i) difference += std::abs(int((*film)->pixels[i]) - int(whole[i]));
    EXPECT_LT(difference / static_cast<double>(whole.size()), 0.3);  // edges that round to another sample
    EXPECT_TRUE(std::filesystem::exists(plan.out));
}

TEST_F(EditorUi, AFilmFromTheDialogGoesOnBesideTheEditor) {
    ok(ui->click("Menu/File/Film..."));
    app->film.plan.width = 32, app->film.plan.height = 24;
    ok(ui->set("Film/Length", "0.1"));
    EXPECT_EQ(get("Film/Count"), "3 pictures");
    app->film.out = (dir / "none" / "film").string();
    ok(ui->click("Film/Film"));
    EXPECT_NE(get("Film/Error").find("no such folder"), std::string::npos) << "it is said in the dialog";
    app->film.out = (dir / "film").string();
    ok(ui->click("Film/Film"));
    for (int i = 0; i < 200 && app->background.film; ++i) ok(ui->wait(1));
    EXPECT_FALSE(ui->exists("Film/Path"));
    for (const char* name : {"frame_0000.png", "frame_0001.png", "frame_0002.png"})
        EXPECT_TRUE(std::filesystem::exists(dir / "film" / name)) << name;
    EXPECT_FALSE(std::filesystem::exists(dir / "film" / "frame_0003.png"));
    EXPECT_NE(app->messages.status.find("3 pictures"), std::string::npos);
    EXPECT_FALSE(doc.dirty());
}

TEST_F(EditorUi, ACancelledFilmLeavesWhatWasWritten) {
    const FilmPlan plan{.film = true, .out = dir / "long", .width = 64, .height = 640, .seconds = 4000};
    auto film = startFilm(doc, *gpu, plan, viewOf(app->view.camera), ViewMode::Final);
    ASSERT_TRUE(film);
    app->background.film = std::move(*film);
    ok(ui->wait(2));
    EXPECT_TRUE(ui->exists("Status/Filming"));
    ok(ui->click("Status/Cancel Film"));
    EXPECT_FALSE(app->background.film);
}

}  // namespace
}  // namespace sward
