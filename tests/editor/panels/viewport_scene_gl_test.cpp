// When the viewport's picture is drawn, and what is said when it cannot be.
#include "editor/editor_fixture.h"
#include "panels/viewport_scene.h"

namespace sward {
namespace {

using test::EditorUi;

TEST_F(EditorUi, WhatKeepsTheSceneFromBeingDrawnIsSaidUntilItIsMended) {
    ok(doc.setField("lawn.GrassField.species[lawn].bladesPerM2", "4000"));
    ok(doc.setField("lawn.GrassField.population", "unique"));
    ok(ui->wait(3));
    EXPECT_NE(get("Viewport/Error").find("lawn.GrassField.population: 6400000 blades"), std::string::npos)
        << get("Viewport/Error");
    ok(doc.setField("lawn.GrassField.species[lawn].bladesPerM2", "1500"));
    ok(ui->wait(3));
    EXPECT_NE(get("Viewport/Error").find("2400000 blades"), std::string::npos) << get("Viewport/Error");
    ok(doc.setField("lawn.GrassField.population", "patch"));
    ok(ui->wait(3));
    EXPECT_FALSE(ui->exists("Viewport/Error"));
    showError(app->messages, failed("the disk is full"));
    ok(doc.setField("lawn.GrassField.seed", "7"));
    ok(ui->wait(3));
    EXPECT_TRUE(ui->exists("Viewport/Error")) << "another error is not drawing's to take away";
    ok(ui->click("Viewport/Dismiss"));
}

TEST_F(EditorUi, TheViewportIsNotDrawnAgainWhenNothingChanged) {
    ok(ui->wait(3));
    app->counts.lastMs = -1;
    ok(ui->wait(5));
    EXPECT_EQ(app->counts.lastMs, -1);
    ASSERT_TRUE(doc.setField("sun.Light.elevationDeg", "30"));
    ok(ui->wait(2));
    EXPECT_GT(app->counts.lastMs, 0);
}

// Of a slow renderer's picture: a menu that was just opened must not wait for the rest of it.
TEST_F(EditorUi, WhatWasPressedShowsBeforeAnotherPieceOfThePicture) {
    ViewportPicture picture;
    ViewCounts counts;
    FrameClock clock;
    const SceneParts parts{doc, *app->renderer, picture, counts, clock, app->messages};
    const ViewCamera camera = viewOf(app->view.camera);
    ViewSettings settings;
    settings.width = 64, settings.height = 48;
    clock.wanted = 0, picture.resolution.movingScale = 0.25;
    drawScene(parts, camera, settings, false);  // it moves: coarse
    ASSERT_TRUE(picture.hasImage);
    ASSERT_LT(picture.resolution.drawnScale, 1);
    picture.resolution.fullMs = 10'000;
    clock.now = 1;  // it rests
    drawScene(parts, camera, settings, false);
    const PicturePiece first = picture.resolution.row;
    ASSERT_GT(first.to, 0) << "pieces of the full picture";
    ASSERT_LT(picture.resolution.drawnScale, 1) << "and not all of them";
    const auto same = [&] {
        const PicturePiece& now = picture.resolution.row;
        return now.left == first.left && now.from == first.from;
    };
    clock.wanted = 3;  // as after a click
    drawScene(parts, camera, settings, false);
    EXPECT_TRUE(same()) << "the widgets of that frame come first";
    clock.wanted = 0;
    drawScene(parts, camera, settings, true);
    EXPECT_TRUE(same()) << "input that waits for the next frame does, too";
    drawScene(parts, camera, settings, false);
    EXPECT_FALSE(same());
    freePicture(picture);
}

}  // namespace
}  // namespace sward
