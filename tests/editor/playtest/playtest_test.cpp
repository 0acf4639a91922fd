// A playtest of a project: what the copy shows, and that the project is left alone.
#include "playtest/playtest.h"

#include <cmath>

#include <gtest/gtest.h>

#include "editor/playtest/played_project.h"
#include "model/field_walk.h"
#include "techniques.h"
#include "world/forces.h"
#include "world/placement.h"
#include "world/view_camera.h"

namespace sward {
namespace {

using namespace test;

TEST(Playtest, StoppingLeavesTheProjectItsUndoAndItsUnsavedWorkAsTheyWere) {
    Fixture f;
    const uint64_t hash = f.hash(), revision = f.doc.revision();
    const std::string undo = f.doc.undoLabel(), redo = f.doc.redoLabel();
    const Project before = snapshot(f.doc.project(), tables().components);
    f.ok(f.doc.startPlay(f.start()));
    f.doc.play()->hold(walkEast());
    f.doc.play()->step(600);
    EXPECT_NE(projectHash(f.doc.play()->project(), tables().components), hash) << "the copy's ball was pushed";
    EXPECT_EQ(f.hash(), hash) << "the project stays as it is meanwhile";
    f.doc.stopPlay();
    EXPECT_EQ(f.doc.play(), nullptr);
    EXPECT_EQ(f.hash(), hash);
    EXPECT_TRUE(sameProject(f.doc.project(), before, tables().components));
    EXPECT_EQ(f.doc.revision(), revision);
    EXPECT_TRUE(f.doc.dirty());
    EXPECT_EQ(f.doc.undoLabel(), undo);
    EXPECT_EQ(f.doc.redoLabel(), redo);
    EXPECT_TRUE(f.doc.redo());
    EXPECT_TRUE(f.doc.undo());
    EXPECT_EQ(f.hash(), hash);
}

TEST(Playtest, WhileItIsPlayedNothingIsSavedEditedOrTakenBack) {
    Fixture f;
    const uint64_t hash = f.hash(), revision = f.doc.revision();
    const std::string file = test::readText(f.dir / "p/project.json");
    f.ok(f.doc.startPlay(f.start()));
    BrushSettings brush;
    brush.map = "density";
    const std::vector<Status> refused = {f.doc.startPlay(f.start()),
                                         f.doc.open(f.dir / "p"),
                                         f.doc.create(f.dir / "q"),
                                         f.doc.setField("sun.Light.elevationDeg", "10"),
                                         f.doc.addEntity("more"),
                                         f.doc.removeEntity("ball"),
                                         f.doc.addComponent("ball", "Light"),
                                         f.doc.removeComponent("ball", "Rolling"),
                                         f.doc.createMap("density"),
                                         f.doc.setMap("density", Map({4, 4, 1, PixelType::U16}), "x"),
                                         f.doc.beginStroke(brush, 5, 5),
                                         f.doc.takeOver(f.dir / "p", "x")};
    for (size_t i = 0; i < refused.size(); ++i) {
        ASSERT_FALSE(refused[i]) << i;
        EXPECT_NE(refused[i].error().text().find("play.stop()"), std::string::npos) << refused[i].error().text();
    }
    EXPECT_FALSE(f.doc.save());
    EXPECT_FALSE(f.doc.saveAs(f.dir / "r"));
    EXPECT_FALSE(std::filesystem::exists(f.dir / "r"));
    EXPECT_FALSE(f.doc.undo() || f.doc.redo() || f.doc.canUndo() || f.doc.canRedo() || f.doc.stroking());
    EXPECT_EQ(f.hash(), hash);
    EXPECT_EQ(f.doc.revision(), revision);
    f.doc.stopPlay();
    EXPECT_EQ(test::readText(f.dir / "p/project.json"), file);
    f.ok(f.doc.setField("sun.Light.elevationDeg", "10"));
    EXPECT_TRUE(f.doc.save());
}

TEST(Playtest, AStrokeUnderWayIsFinishedFirstAndADragIsLeftAlone) {
    Fixture f;
    BrushSettings brush;
    brush.map = "density";
    brush.mode = "subtract";
    brush.radius = 5;
    f.ok(f.doc.beginStroke(brush, 5, 5));
    f.doc.strokeTo(30, 30);
    f.ok(f.doc.startPlay(f.start()));
    EXPECT_FALSE(f.doc.stroking());
    const uint64_t painted = f.hash();
    f.doc.stopPlay();
    EXPECT_TRUE(f.doc.undoLabel().starts_with("Subtract lawn.GrassField.species[lawn].density, ")) << f.doc.undoLabel();
    EXPECT_TRUE(f.doc.undo());
    EXPECT_TRUE(f.doc.redo());
    EXPECT_EQ(f.hash(), painted) << "the whole stroke is one step";

    f.doc.beginGroup("drag");
    f.ok(f.doc.setField("sun.Light.elevationDeg", "33"));
    EXPECT_FALSE(f.doc.startPlay(f.start()));
    f.doc.endGroup();
    EXPECT_EQ(f.doc.undoLabel(), "drag");
    f.ok(f.doc.startPlay(f.start()));
}

TEST(Playtest, TheSnapshotSharesTheMapsTiles) {
    Fixture f;
    f.ok(f.doc.startPlay(f.start()));
    const auto density = [](const Project& p) {
        return static_cast<const MapField*>(findMap(p, tables().components, "density")->value)->map;
    };
    EXPECT_TRUE(density(f.doc.project()).sameTiles(density(f.doc.play()->project())));
}

TEST(Playtest, BeginsUnderTheViewAndLooksWhereItLooked) {
    Fixture f;
    f.ok(f.doc.startPlay(f.start()));
    const ViewCamera v = f.doc.play()->view();
    const double ground = groundHeight(f.doc.play()->world(), {17, 20});
    EXPECT_EQ(v.eye, glm::dvec3(17, ground + kEyeHeight, 20));
    EXPECT_LT(glm::length(glm::normalize(v.target - v.eye) - glm::dvec3(1, 0, 0)), 1e-9);
    EXPECT_EQ(v.fovDeg, 60);
    EXPECT_EQ(v.exposure, 0.5f);
}

TEST(Playtest, ThePushedBallIsDrawnWhereItRolledAndTurned) {
    Fixture f;
    const std::vector<PlacedMesh> still = placedMeshes(f.doc.project());
    f.ok(f.doc.startPlay(f.start()));
    Playtest& play = *f.doc.play();
    ASSERT_EQ(placedMeshes(play.project()).size(), 1u);
    EXPECT_LT(glm::distance(placedMeshes(play.project())[0].at, still[0].at), 1e-9) << "it lies as it did";
    play.hold(walkEast());
    play.step(300);
    const Roller& r = play.state().rollers.at(0);
    const PlacedMesh drawn = placedMeshes(play.project())[0];
    EXPECT_GT(r.position.x, 20.5);
    EXPECT_LT(glm::distance(drawn.at, r.position), 1e-9);
    const glm::dmat3 turn = glm::mat3_cast(r.turn);
    for (int c = 0; c < 3; ++c) EXPECT_LT(glm::distance(drawn.turn[c], turn[c]), 1e-6) << "degrees give the same turn";
    const double angle = std::fmod((r.position.x - 20) / 0.5, 2 * 3.14159265358979);
    EXPECT_NEAR(std::cos(angle), turn[1][1], 0.1) << "it rolled, not slid";
    EXPECT_EQ(play.contacts().size(), play.state().contacts.size());
}

TEST(Playtest, EveryTurnIsWrittenInDegreesThatGiveItBack) {
    TempDir dir;
    for (const glm::dvec3 degrees :
         {glm::dvec3(0), {10, 20, 30}, {-170, 200, 80}, {40, 50, 90}, {40, 50, -90}, {180, 0, 0}}) {
        Project p;
        const Entity ground = *addEntity(p, "ground"), e = *addEntity(p, "e");
        p.registry.add<Terrain>(ground);
        p.registry.add<Rolling>(e);
        StaticMesh mesh;
        mesh.file = "a.glb";
        mesh.rotationDeg = degrees;
        p.registry.add<StaticMesh>(e, mesh);
        p.registry.add<Transform>(e, {{5, 0.25, 5}});
        auto play = Playtest::start(p, tables().components, {});
        ASSERT_TRUE(play);
        const glm::dmat3 want = placedMeshes(p)[0].turn, got = placedMeshes((*play)->project())[0].turn;
        for (int c = 0; c < 3; ++c) EXPECT_LT(glm::distance(got[c], want[c]), 1e-6) << degrees.x << " " << degrees.z;
    }
}

TEST(Playtest, TheClockTakesWholeStepsAndThePictureLiesBetweenTheLastTwo) {
    Fixture f;
    PlayStart start = f.start();
    start.byClock = true;
    start.time = 10;
    f.ok(f.doc.startPlay(start));
    Playtest& play = *f.doc.play();
    play.hold(walkEast());
    for (int i = 0; i < 60; ++i) EXPECT_TRUE(play.advance(kTickSeconds));
    EXPECT_EQ(play.state().tick, 660) << "at 60 pictures a second one step each";
    EXPECT_TRUE(play.advance(kTickSeconds * 2.5));
    EXPECT_EQ(play.state().tick, 662);
    EXPECT_NEAR(play.time(), 661.5 / 60, 1e-6);
    const double half = play.view().eye.x, whole = play.state().walker.position.x;
    EXPECT_NEAR(whole - half, kWalkSpeed * kTickSeconds / 2, 1e-6);
    EXPECT_TRUE(play.advance(1e9));
    EXPECT_EQ(play.state().tick, 677) << "a quarter of a second at most";
    play.pause(true);
    EXPECT_FALSE(play.advance(1));
    play.step();
    EXPECT_EQ(play.state().tick, 678);
    EXPECT_EQ(play.time(), 678 / 60.0) << "a step shows itself";
}

TEST(Playtest, FramesOfAnyRateGiveTheSameSteps) {
    Fixture f;
    PlayStart start = f.start();
    start.byClock = true;
    std::vector<uint64_t> hashes;
    for (const double rate : {15.0, 60.0, 144.0, 1000.0}) {
        f.ok(f.doc.startPlay(start));
        f.doc.play()->hold(walkEast());
        for (int i = 0; i < static_cast<int>(rate) * 8; ++i) f.doc.play()->advance(1 / rate);
        EXPECT_NEAR(static_cast<double>(f.doc.play()->state().tick), 480, 1) << rate;
        while (f.doc.play()->state().tick < 490) f.doc.play()->step();
        hashes.push_back(hashPlay(f.doc.play()->state()));
        f.doc.stopPlay();
    }
    for (const uint64_t h : hashes) EXPECT_EQ(h, hashes[0]);
}

TEST(Playtest, NeedsGroundToWalkOn) {
    Fixture f;
    PlayStart start = f.start();
    start.time = 1e300;
    EXPECT_FALSE(f.doc.startPlay(start));
    start = f.start();
    start.view.eye.x = std::nan("");
    EXPECT_FALSE(f.doc.startPlay(start));
    f.ok(f.doc.removeComponent("ground", "Terrain"));
    const Status refused = f.doc.startPlay(f.start());
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().text().find("Terrain"), std::string::npos);
    EXPECT_EQ(f.doc.play(), nullptr);
}

}  // namespace
}  // namespace sward
