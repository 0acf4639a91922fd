// The tools of a hybrid field, through the real widgets: tiers, rings, combing, overlays, erasing.
#include <epoxy/gl.h>

#include "editor_fixture.h"
#include "tools/brush_target.h"
#include "world/ground.h"
#include "world/view_camera.h"

namespace sward {
namespace {

constexpr const char* kOrientation = "lawn.GrassField.orientation";
constexpr const char* kVegetation = "lawn.GrassField.vegetation";
constexpr const char* kForces = "lawn.GrassField.forces";

class EditorTools : public test::EditorFixture {
  protected:
    TierDistances tiers() {
        return tiersOf(*doc.project().registry.get<GrassField>(findEntity(doc.project(), "lawn")));
    }
    std::array<double, 2> grip(const std::string& tier) {
        const auto r = ui->rect("Viewport/Ring " + tier);
        EXPECT_TRUE(r) << (r ? "" : r.error().text());
        return r ? std::array{((*r)[0] + (*r)[2]) / 2, ((*r)[1] + (*r)[3]) / 2} : std::array{0.0, 0.0};
    }
    const MapField& mapOf(const std::string& path) {
        return *static_cast<const MapField*>(findField(doc.project(), tables().components, path)->value);
    }
    // Left button down at a place; frames run.
    void press(double x, double y) {
        app->queue.push({InputKind::Move, x, y, 0, false});
        ok(ui->wait(2));
        app->queue.push({InputKind::Button, 0, 0, 0, true});
        ok(ui->wait(1));
    }
    void moveTo(double x, double y) {
        app->queue.push({InputKind::Move, x, y, 0, false});
        ok(ui->wait(1));
    }
    void release() {
        app->queue.push({InputKind::Button, 0, 0, 0, false});
        ok(ui->wait(2));
    }
    std::vector<uint8_t> picture() {
        app->refineNow = true;
        app->viewport.drawnRevision = ~uint64_t(0);
        ok(ui->wait(2));
        app->refineNow = false;
        std::vector<uint8_t> pixels(static_cast<size_t>(app->viewport.pictureWidth) * app->viewport.pictureHeight * 4);
        glGetTextureImage(app->viewport.picture, 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(pixels.size()),
                          pixels.data());
        return pixels;
    }
};

TEST_F(EditorTools, ATypedDistancePushesTheOthersInOneStep) {
    const TierDistances before = tiers();
    ok(ui->set("Tiers/maxGeom", "50"));
    EXPECT_EQ(tiers()[1], 50);
    EXPECT_TRUE(tiersInOrder(tiers()));
    EXPECT_EQ(get("Tiers/minBTF"), "50");
    ok(ui->key("ctrl+z"));
    EXPECT_EQ(tiers(), before);
    EXPECT_FALSE(doc.canUndo());
    EXPECT_FALSE(ui->set("Tiers/maxGeom", "-2"));
    EXPECT_FALSE(ui->set("Tiers/maxGeom", "far"));
    EXPECT_EQ(tiers(), before);
    ok(ui->set("Tiers/maxGeom", "inf"));
    EXPECT_EQ(get("Tiers/maxBTF"), "inf");
}

TEST_F(EditorTools, ADraggedDistanceStopsAtItsNeighboursInOneStep) {
    const TierDistances before = tiers();
    ASSERT_TRUE(ui->get("Tiers/maxGeom"));
    const auto r = ui->rect("Tiers/maxGeom");
    ASSERT_TRUE(r);
    const double y = ((*r)[1] + (*r)[3]) / 2, x = ((*r)[0] + (*r)[2]) / 2;
    ok(ui->drag(x, y, (*r)[2] + 40, y));
    EXPECT_EQ(tiers()[1], before[2]);
    EXPECT_EQ(tiers()[2], before[2]);
    ok(ui->drag(x, y, (*r)[0] - 40, y));
    EXPECT_NEAR(tiers()[1], before[0] + kTierGap, 1e-6);
    ok(ui->key("ctrl+z"));
    ok(ui->key("ctrl+z"));
    EXPECT_EQ(tiers(), before);
    EXPECT_FALSE(doc.canUndo());
}

TEST_F(EditorTools, ThePanelSetsTechniqueFadeSlicesAndTheView) {
    ok(ui->set("Tiers/technique", "geometry"));
    EXPECT_EQ(field("lawn.GrassField.technique"), "geometry");
    ok(ui->set("Tiers/fade", "0.25"));
    EXPECT_EQ(field("lawn.GrassField.fade"), "0.25");
    ok(ui->set("Tiers/slices", "6"));
    EXPECT_EQ(field("lawn.GrassField.slices"), "6");
    ok(ui->set("Tiers/False colours", "true"));
    EXPECT_EQ(app->viewport.mode, ViewMode::Tiers);
    ok(ui->set("Tiers/False colours", "false"));
    EXPECT_EQ(app->viewport.mode, ViewMode::Final);
    EXPECT_TRUE(ui->exists("Tiers/Blades"));
    ok(ui->set("Tiers/Measure", "true"));
    ok(ui->wait(3));
    EXPECT_NE(get("Tiers/Passes").find(" ms"), std::string::npos);
}

TEST_F(EditorTools, DistancesOutOfOrderAreOfferedToBePutInOrder) {
    EXPECT_FALSE(ui->exists("Tiers/Put in order"));
    ASSERT_TRUE(doc.setField("lawn.GrassField.minGeom", "30"));
    ok(ui->click("Tiers/Put in order"));
    EXPECT_TRUE(tiersInOrder(tiers()));
    EXPECT_EQ(tiers()[0], 12);
}

TEST_F(EditorTools, RingsAreDrawnOnlyWhileThePanelIsInSight) {
    EXPECT_FALSE(ui->exists("Viewport/Ring maxGeom"));
    ASSERT_TRUE(ui->get("Tiers/maxGeom"));
    EXPECT_TRUE(ui->exists("Viewport/Ring maxGeom"));
    ok(ui->set("Tiers/Rings", "false"));
    EXPECT_FALSE(app->book.widgets.count("Viewport/Ring maxGeom"));
    ok(ui->set("Tiers/Rings", "true"));
    ok(ui->click("Tabs/Console"));
    EXPECT_FALSE(app->book.widgets.count("Viewport/Ring maxGeom"));
}

TEST_F(EditorTools, ARingIsDraggedInOneStepAndPaintsNothing) {
    ok(ui->set("Tiers/maxGeom", "8"));
    const TierDistances before = tiers();
    const uint64_t grass = density();
    const auto [x, y] = grip("maxGeom");
    ok(ui->drag(x, y, x, y - 30));  // up on the screen is farther
    EXPECT_GT(tiers()[1], before[1] + 0.5);
    EXPECT_LE(tiers()[1], before[2]);
    EXPECT_EQ(tiers()[0], before[0]);
    EXPECT_EQ(density(), grass);
    const auto [x2, y2] = grip("maxGeom");
    EXPECT_NEAR(y2, y - 30, 25);  // it followed the hand, unless a neighbour stopped it
    ok(ui->key("ctrl+z"));
    EXPECT_EQ(tiers(), before);
    ok(ui->key("ctrl+y"));
    EXPECT_GT(tiers()[1], before[1] + 0.5);
}

TEST_F(EditorTools, AClickOnARingChangesNothingAndEscapeLetsItGo) {
    ok(ui->set("Tiers/maxGeom", "8"));
    const TierDistances before = tiers();
    const auto [x, y] = grip("maxGeom");
    ok(ui->drag(x, y, x, y));
    EXPECT_EQ(tiers(), before);
    press(x, y);
    for (int i = 1; i <= 6; ++i) moveTo(x, y - 5 * i);
    EXPECT_GT(tiers()[1], before[1]);
    ok(ui->key("escape"));
    EXPECT_EQ(tiers(), before);
    moveTo(x, y - 50);
    release();
    EXPECT_EQ(tiers(), before);
    EXPECT_EQ(doc.undoLabel(), "set tiers of lawn");  // of the typed distance
    EXPECT_TRUE(app->holding.empty());
}

TEST_F(EditorTools, RingsThatMeetPartTheWayTheHandGoes) {
    ok(ui->set("Tiers/minBTF", "8"));
    ok(ui->set("Tiers/maxGeom", "8"));
    const auto [x, y] = grip("maxGeom");
    ok(ui->drag(x, y, x, y - 20));
    EXPECT_EQ(tiers()[1], 8);
    EXPECT_GT(tiers()[2], 8.3);
    ok(ui->key("ctrl+z"));
    ok(ui->drag(x, y, x, y + 20));
    EXPECT_LT(tiers()[1], 7.9);
    EXPECT_EQ(tiers()[2], 8);
}

TEST_F(EditorTools, PinnedRingsStayWhereTheEyeWas) {
    ASSERT_TRUE(ui->get("Tiers/maxGeom"));
    ok(ui->set("Tiers/Pin rings", "true"));
    const glm::dvec3 eye = app->viewport.camera.eye;
    ASSERT_TRUE(app->tierView.pin);
    app->viewport.camera.pitch = -0.6;
    focus(app->viewport.camera, eye, 25);
    ok(ui->wait(2));
    EXPECT_EQ(*app->tierView.pin, eye);
    const auto [x, y] = grip("maxGeom");
    const auto ground =
        pickGround(doc.project(), viewOf(app->viewport.camera), static_cast<int>(app->viewport.rect.w),
                   static_cast<int>(app->viewport.rect.h), x - static_cast<double>(app->viewport.rect.x),
                   y - static_cast<double>(app->viewport.rect.y));
    ASSERT_TRUE(ground);
    EXPECT_NEAR(glm::length(*ground - eye), tiers()[1], 0.5);
    ok(ui->set("Tiers/Pin rings", "false"));
    EXPECT_FALSE(app->tierView.pin);
}

TEST_F(EditorTools, TheCombGoesToTheOrientationMapAndOffersToCreateIt) {
    ok(ui->click("Tools/Comb"));
    EXPECT_EQ(app->brushes.map, kOrientation);
    EXPECT_NE(get("Brush/New map").find(" x "), std::string::npos);
    ok(ui->click("Brush/Create map"));
    ASSERT_TRUE(mapOf(kOrientation).present());
    EXPECT_EQ(mapOf(kOrientation).map.info().channels, 2);
    EXPECT_FALSE(ui->exists("Brush/Create map"));
    ok(ui->key("ctrl+z"));
    EXPECT_FALSE(mapOf(kOrientation).present());
    ok(ui->click("Tools/Add"));
    EXPECT_TRUE(app->brushes.map.ends_with(".density"));
    ok(ui->set("Brush/Map", kOrientation));
    EXPECT_EQ(app->brushes.tool, "comb");  // the tool last used on directions
}

TEST_F(EditorTools, CombingInTheViewportLaysTheGrassTheWayTheHandGoes) {
    ok(ui->click("Tools/Comb"));
    ok(ui->set("Brush/Strength", "1"));
    paint();                                     // to the right on the screen
    ASSERT_TRUE(mapOf(kOrientation).present());  // made with the stroke
    const Rect& r = app->viewport.rect;
    const auto at = pickGround(doc.project(), viewOf(app->viewport.camera), static_cast<int>(r.w),
                               static_cast<int>(r.h), static_cast<double>(r.w) * 0.45, static_cast<double>(r.h) * 0.8);
    ASSERT_TRUE(at);
    const glm::dvec2 size = findGround(doc.project()).terrain->size;
    const Map& map = mapOf(kOrientation).map;
    const double yaw = app->viewport.camera.yaw;
    EXPECT_NEAR(map.sample(at->x / size.x, at->z / size.y, 0) * 2 - 1, std::cos(yaw), 0.1);
    EXPECT_NEAR(map.sample(at->x / size.x, at->z / size.y, 1) * 2 - 1, std::sin(yaw), 0.1);
    ok(ui->key("ctrl+z"));
    EXPECT_FALSE(mapOf(kOrientation).present());
    EXPECT_FALSE(doc.canUndo());
}

TEST_F(EditorTools, PressingInTheViewportMakesTheMapAndPushesTheWayTheHandGoes) {
    ok(ui->click("Tools/Press"));
    EXPECT_EQ(app->brushes.map, kForces);
    EXPECT_NE(get("Brush/New map").find(" x "), std::string::npos);
    ok(ui->set("Brush/Strength", "1"));
    const std::vector<uint8_t> before = picture();
    paint();  // to the right on the screen
    ASSERT_TRUE(mapOf(kForces).present());
    EXPECT_EQ(overlayOf(*app).map, kForces);
    const Rect& r = app->viewport.rect;
    const auto at = pickGround(doc.project(), viewOf(app->viewport.camera), static_cast<int>(r.w),
                               static_cast<int>(r.h), static_cast<double>(r.w) * 0.45, static_cast<double>(r.h) * 0.8);
    ASSERT_TRUE(at);
    const glm::dvec2 size = findGround(doc.project()).terrain->size;
    const Map& map = mapOf(kForces).map;
    const auto channel = [&](int c) { return static_cast<double>(map.sample(at->x / size.x, at->z / size.y, c)); };
    const double yaw = app->viewport.camera.yaw;
    EXPECT_NEAR(channel(0) * 2 - 1, std::cos(yaw), 0.1);
    EXPECT_NEAR(channel(1) * 2 - 1, std::sin(yaw), 0.1);
    EXPECT_NEAR(channel(2), 1, 0.02);
    EXPECT_NEAR(channel(3), 1, 0.02);
    const std::vector<uint8_t> shown = picture();
    ok(ui->key("o"));
    const std::vector<uint8_t> pressed = picture();
    EXPECT_NE(pressed, shown) << "the overlay shows nothing";
    EXPECT_NE(pressed, before) << "the grass stands as before";
    ok(ui->key("ctrl+z"));
    EXPECT_FALSE(mapOf(kForces).present());
    EXPECT_FALSE(doc.canUndo());
    EXPECT_EQ(picture(), before);
    ok(ui->key("ctrl+y"));
    EXPECT_EQ(picture(), pressed);
}

TEST_F(EditorTools, TheOverlayOfForcesShowsWhatStandsThereToo) {
    ok(ui->set("Brush/Map", kForces));
    EXPECT_EQ(app->brushes.tool, "press");
    EXPECT_EQ(overlayOf(*app).map, "") << "nothing presses";
    const Rect& r = app->viewport.rect;
    const auto at = pickGround(doc.project(), viewOf(app->viewport.camera), static_cast<int>(r.w),
                               static_cast<int>(r.h), static_cast<double>(r.w) * 0.5, static_cast<double>(r.h) * 0.8);
    ASSERT_TRUE(at);
    ASSERT_TRUE(doc.addEntity("stone"));
    ASSERT_TRUE(doc.addComponent("stone", "ForceSource"));
    ASSERT_TRUE(doc.addComponent("stone", "Transform"));
    ASSERT_TRUE(doc.setField("stone.Transform.position", fmt::format("[{}, {}, {}]", at->x, at->y, at->z)));
    EXPECT_EQ(overlayOf(*app).map, kForces);
    const std::vector<uint8_t> shown = picture();
    ok(ui->key("o"));
    EXPECT_NE(picture(), shown);
}

TEST_F(EditorTools, TheDialAndTheNumberSetTheAngle) {
    ok(ui->click("Tools/Direction"));
    ok(ui->set("Brush/Angle", "135"));
    EXPECT_EQ(currentBrush(app->brushes).angleDeg, 135);
    ok(ui->click("Tools/Comb"));
    EXPECT_FALSE(ui->exists("Brush/Angle"));
}

TEST_F(EditorTools, TheOverlayShowsDirectionsUnaskedAndDensitiesOnDemand) {
    EXPECT_FALSE(overlayShown(*app));
    const std::vector<uint8_t> plain = picture();
    ok(ui->click("Brush/Overlay"));
    EXPECT_NE(picture(), plain);
    ok(ui->key("o"));
    EXPECT_EQ(picture(), plain);
    ok(ui->click("Tools/Comb"));
    EXPECT_EQ(picture(), plain);  // there is no such map yet
    ok(ui->click("Brush/Create map"));
    EXPECT_TRUE(overlayShown(*app));
    EXPECT_NE(picture(), plain);
    for (const char* map : {"ambientOcclusion", "vegetation", "forces"}) {
        ok(ui->set("Brush/Map", map));
        ok(ui->click("Brush/Create map"));
        EXPECT_TRUE(overlayShown(*app)) << map;
        EXPECT_EQ(overlayOf(*app).map, std::string("lawn.GrassField.") + map);
    }
}

TEST_F(EditorTools, TheSwatchShowsForMapsOfColoursOnly) {
    for (const ConstFieldRef& map : paintableMaps(*app)) {
        ok(ui->set("Brush/Map", map.path));
        const std::string name = map.row->name;
        const bool colours = name == "terrainMap" || name == "vegetation";
        EXPECT_EQ(ui->exists("Brush/Colour"), colours) << name;
        EXPECT_EQ(ui->exists("Brush/Colour/Swatch"), colours) << name;
        EXPECT_EQ(ui->exists("Brush/Opacity"), colours) << name;
    }
    ok(ui->set("Brush/Map", kVegetation));
    EXPECT_EQ(app->brushes.tool, "add");
    ok(ui->click("Tools/Subtract"));
    EXPECT_FALSE(ui->exists("Brush/Opacity"));
    ok(ui->click("Tools/Comb"));
    EXPECT_EQ(app->brushes.map, kOrientation);
    ok(ui->click("Tools/Add"));
    EXPECT_EQ(app->brushes.map, kVegetation) << "the last map that it paints";
    ok(ui->set("Brush/Colour", "#8020a0"));
    EXPECT_EQ(get("Brush/Colour"), "#8020a0");
    EXPECT_FALSE(ui->set("Brush/Colour", "purple"));
    EXPECT_EQ(get("Brush/Colour"), "#8020a0");
    ok(ui->set("Brush/Map", "terrainMap"));
    EXPECT_EQ(get("Brush/Colour"), "#ffffff");
    ok(ui->click("Brush/Colour/Swatch"));
    EXPECT_TRUE(app->book.widgets.at("Brush/Colour/Swatch").open);
    ok(ui->key("escape"));
}

TEST_F(EditorTools, PaintingAColourMakesTheMapAndPickingFindsItAgain) {
    ok(ui->set("Brush/Map", kVegetation));
    ok(ui->set("Brush/Colour", "#8020a0"));
    ok(ui->set("Brush/Strength", "1"));
    const std::vector<uint8_t> before = picture();
    paint();
    ASSERT_TRUE(mapOf(kVegetation).present());
    EXPECT_EQ(mapOf(kVegetation).map.info().channels, 4);
    const std::vector<uint8_t> shown = picture();
    ok(ui->key("o"));
    const std::vector<uint8_t> tinted = picture();
    EXPECT_NE(tinted, shown) << "the overlay shows nothing";
    EXPECT_NE(tinted, before) << "the grass has its own colour still";
    ok(ui->set("Brush/Colour", "#000000"));
    const Rect& r = app->viewport.rect;
    const auto pickAt = [&](float across) {
        moveTo(static_cast<double>(r.x + r.w * across), static_cast<double>(r.y) + static_cast<double>(r.h) * 0.8);
        ok(ui->wait(2));
        ok(ui->key("i"));
    };
    pickAt(0.45f);
    EXPECT_EQ(get("Brush/Colour"), "#8020a0");
    ok(ui->set("Brush/Colour", "#000000"));
    pickAt(0.95f);
    EXPECT_EQ(get("Brush/Colour"), "#000000") << "nothing is painted there";
    ok(ui->key("ctrl+z"));
    EXPECT_FALSE(mapOf(kVegetation).present());
    EXPECT_FALSE(doc.canUndo());
    EXPECT_EQ(picture(), before);
    ok(ui->key("ctrl+y"));
    EXPECT_EQ(picture(), tinted);
}

TEST_F(EditorTools, CtrlShiftErasesEverySpeciesInOneStep) {
    ok(ui->click("Inspector/lawn.GrassField.species/Add species"));
    const std::string second = "lawn.GrassField.species[grass].density";
    const uint64_t before = density();
    ok(ui->set("Brush/Map", "species[lawn].density"));
    const Rect& r = app->viewport.rect;
    const double y = static_cast<double>(r.y) + static_cast<double>(r.h) * 0.8;
    ok(ui->drag(static_cast<double>(r.x + r.w * 0.3f), y, static_cast<double>(r.x + r.w * 0.6f), y, "ctrl+shift"));
    EXPECT_NE(mapOf("lawn.GrassField.species[lawn].density").map.hash(), before);
    ASSERT_TRUE(mapOf(second).present());
    EXPECT_LT(mapOf(second).map.mean(), 0.99999);
    ok(ui->key("ctrl+z"));
    EXPECT_EQ(mapOf("lawn.GrassField.species[lawn].density").map.hash(), before);
    EXPECT_FALSE(mapOf(second).present());
}

TEST_F(EditorTools, ShiftErasesWithThePreset) {
    const uint64_t before = density();
    ok(ui->click("Menu/Brush/Shift Erases"));
    EXPECT_TRUE(app->brushes.shiftErases);
    const Rect& r = app->viewport.rect;
    const double y = static_cast<double>(r.y) + static_cast<double>(r.h) * 0.8;
    const double mean = mapOf("lawn.GrassField.species[lawn].density").map.mean();
    ok(ui->drag(static_cast<double>(r.x + r.w * 0.3f), y, static_cast<double>(r.x + r.w * 0.6f), y, "shift"));
    EXPECT_NE(density(), before);
    EXPECT_LT(mapOf("lawn.GrassField.species[lawn].density").map.mean(), mean);
}

// --- autosave, with the clock in the test's hand

TEST_F(EditorTools, UnsavedWorkIsCopiedAndOfferedToTheNextRun) {
    setenv("XDG_STATE_HOME", (dir / "state").c_str(), 1);
    app->autosave.on = true;
    const auto copies = [&] { return autosavesOf(dir / "meadow"); };
    const auto tickUntilIdle = [&](double now) {
        tickAutosave(*app, now);
        while (app->autosave.job.active()) tickAutosave(*app, now);
    };
    tickUntilIdle(0);
    ok(ui->set("Inspector/sun.Light.elevationDeg", "20"));
    tickUntilIdle(kAutosaveSeconds - 1);
    EXPECT_TRUE(copies().empty());
    tickUntilIdle(kAutosaveSeconds + 1);
    EXPECT_EQ(copies().size(), 1u);
    tickUntilIdle(3 * kAutosaveSeconds);  // nothing new
    EXPECT_EQ(copies().size(), 1u);
    app->autosave.mine = false;  // as if the program had been killed, and another run began
    ASSERT_TRUE(doc.open(dir / "meadow"));
    app->autosave.of.clear();
    tickUntilIdle(0);
    ok(ui->wait(2));
    ASSERT_TRUE(ui->exists("Recovery/Recover"));
    ok(ui->click("Recovery/Recover"));
    EXPECT_EQ(field("sun.Light.elevationDeg"), "20");
    EXPECT_EQ(get("Status/Saved"), "false");
    EXPECT_EQ(copies().size(), 1u);
    ok(ui->key("ctrl+s"));
    tickUntilIdle(1);
    EXPECT_TRUE(copies().empty());
    app->autosave.on = false;
    unsetenv("XDG_STATE_HOME");
}

}  // namespace
}  // namespace sward
