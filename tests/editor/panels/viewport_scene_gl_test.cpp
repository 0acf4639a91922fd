// When the viewport's picture is drawn, and what is said when it cannot be.
#include "editor/editor_fixture.h"

namespace sward {
namespace {

using test::EditorUi;

TEST_F(EditorUi, WhatKeepsTheSceneFromBeingDrawnIsSaidUntilItIsMended) {
    ok(doc.setField("lawn.GrassField.population", "unique"));
    ok(ui->wait(3));
    EXPECT_NE(get("Viewport/Error").find("lawn.GrassField.population: 3200000 blades"), std::string::npos)
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

}  // namespace
}  // namespace sward
