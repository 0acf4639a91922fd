#include "model/document.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "model/field_walk.h"
#include "model/history.h"
#include "playtest/playtest.h"
#include "support.h"
#include "techniques.h"
#include "tools/stroke.h"

namespace sward {
namespace {

namespace fs = std::filesystem;
using test::TempDir;

constexpr const char* kDensityOfLawn = "lawn.GrassField.species[lawn].density";

// A document on a new project in a folder of its own.
struct Fixture {
    TempDir dir;
    Document doc{tables()};
    explicit Fixture(size_t undoBytes = size_t(512) << 20) : doc(tables(), undoBytes) {
        EXPECT_TRUE(doc.create(dir / "p"));
    }
    Map density() {
        return static_cast<const MapField*>(findMap(doc.project(), tables().components, kDensityOfLawn)->value)->map;
    }
    std::string text(const std::string& path) {
        const auto field = findField(doc.project(), tables().components, path);
        return field ? fieldText(*field) : field.error().message;
    }
    Project copy() { return snapshot(doc.project(), tables().components); }
    bool same(const Project& p) { return sameProject(doc.project(), p, tables().components); }
};
BrushSettings subtract(float radius, float strength = 0.5f) {
    BrushSettings b;
    b.mode = "subtract";
    b.radius = radius;
    b.strength = strength;
    return b;
}
void stroke(Document& doc, const BrushSettings& b, std::vector<std::pair<double, double>> points) {
    ASSERT_TRUE(doc.beginStroke(b, points[0].first, points[0].second));
    for (const auto& [x, z] : points) doc.strokeTo(x, z);
    doc.endStroke();
    doc.pumpStroke(0);
    ASSERT_FALSE(doc.stroking());
}

TEST(Document, ItsProjectCanOnlyBeChangedThroughIt) {
    static_assert(std::is_same_v<decltype(std::declval<Document&>().project()), const Project&>);
    static_assert(std::is_same_v<decltype(std::declval<Playtest&>().project()), const Project&>);
    Fixture f;
    const auto terrain = findField(f.doc.project(), tables().components, "ground.Terrain.size");
    ASSERT_TRUE(terrain);
    static_assert(std::is_same_v<decltype(terrain->value), const void*>, "what is found in it may only be read");
    const std::string before = fieldText(*terrain);
    ASSERT_TRUE(f.doc.setField("ground.Terrain.size", "[7, 9]"));
    EXPECT_EQ(fieldText(*terrain), "[7, 9]") << "the field that was found is the document's own";
    EXPECT_NE(before, "[7, 9]");
}

TEST(Document, UndoOfAStrokeRestoresTheTilesThemselvesAndRedoTheStroke) {
    Fixture f;
    const Map before = f.density();
    stroke(f.doc, subtract(3), {{10, 10}, {30, 25}, {12, 31}});
    const Map after = f.density();
    EXPECT_NE(after.hash(), before.hash());
    EXPECT_TRUE(f.doc.dirty());
    EXPECT_TRUE(f.doc.undoLabel().starts_with("Subtract lawn.GrassField.species[lawn].density, ")) << f.doc.undoLabel();
    ASSERT_TRUE(f.doc.undo());
    EXPECT_TRUE(f.density().sameTiles(before));
    EXPECT_FALSE(f.doc.dirty());
    ASSERT_TRUE(f.doc.redo());
    EXPECT_TRUE(f.density().sameTiles(after));
    EXPECT_TRUE(f.doc.dirty());
    EXPECT_FALSE(f.doc.redo());
}

TEST(Document, TheSameStrokeAfterUndoPaintsTheSameBits) {
    Fixture f;
    stroke(f.doc, subtract(4, 0.013f), {{20, 20}, {25, 20}});
    const uint64_t hash = f.density().hash();
    ASSERT_TRUE(f.doc.undo());
    stroke(f.doc, subtract(4, 0.013f), {{20, 20}, {25, 20}});
    EXPECT_EQ(f.density().hash(), hash);
}

TEST(Document, AStrokeSpreadOverFramesPaintsTheSameBitsAsOneAtOnce) {
    Fixture a, b;
    stroke(a.doc, subtract(15, 0.21f), {{5, 5}, {35, 35}});
    ASSERT_TRUE(b.doc.beginStroke(subtract(15, 0.21f), 5, 5));
    b.doc.strokeTo(5, 5);
    b.doc.strokeTo(35, 35);
    b.doc.endStroke();
    int frames = 1;
    while (b.doc.pumpStroke(1e-6)) ++frames;
    EXPECT_GT(frames, 3);
    EXPECT_FALSE(b.doc.stroking());
    EXPECT_EQ(a.density().hash(), b.density().hash());
    EXPECT_TRUE(b.doc.undo());
    EXPECT_FALSE(b.doc.canUndo());
}

TEST(Document, TheEndOfAStrokeAsksForNoOtherPicture) {
    Fixture f;
    ASSERT_TRUE(f.doc.beginStroke(subtract(4), 20, 20));
    while (f.doc.pumpStroke(1)) {
    }
    const uint64_t painted = f.doc.revision(), hash = f.density().hash();
    f.doc.endStroke();
    EXPECT_FALSE(f.doc.stroking());
    EXPECT_EQ(f.doc.revision(), painted);
    EXPECT_EQ(f.density().hash(), hash);
    EXPECT_TRUE(f.doc.dirty());
    ASSERT_TRUE(f.doc.undo());
    EXPECT_GT(f.doc.revision(), painted);
    EXPECT_FALSE(f.doc.dirty());
}

TEST(Document, UndoDuringAStrokeTakesAllOfItBack) {
    Fixture f;
    const Map before = f.density();
    ASSERT_TRUE(f.doc.beginStroke(subtract(10), 5, 5));
    f.doc.strokeTo(30, 30);
    f.doc.pumpStroke(1e-6);
    EXPECT_TRUE(f.doc.stroking());
    EXPECT_TRUE(f.doc.canUndo());
    ASSERT_TRUE(f.doc.undo());
    EXPECT_FALSE(f.doc.stroking());
    EXPECT_TRUE(f.density().sameTiles(before));
    EXPECT_TRUE(f.doc.canRedo());
}

TEST(Document, StrokesThatPaintNothingLeaveNoStep) {
    Fixture f;
    EXPECT_FALSE(f.doc.beginStroke(subtract(0), 10, 10));
    stroke(f.doc, subtract(5, 0), {{10, 10}, {20, 20}});
    stroke(f.doc, subtract(2), {{-30, -30}});
    EXPECT_FALSE(f.doc.canUndo());
    EXPECT_FALSE(f.doc.dirty());
    stroke(f.doc, subtract(2), {{10, 10}});  // no length, but a stamp
    EXPECT_TRUE(f.doc.canUndo());
}

TEST(Document, StrokesOnWhatCannotBePaintedAreRefusedAndSayWhy) {
    Fixture f;
    const auto refusal = [&](const BrushSettings& b) {
        const Status s = f.doc.beginStroke(b, 1, 1);
        return s ? std::string("accepted") : s.error().text();
    };
    BrushSettings b = subtract(1);
    b.map = "vegetation";
    EXPECT_NE(refusal(b).find("no map to paint on"), std::string::npos) << refusal(b);
    ASSERT_TRUE(f.doc.setMap("vegetation", Map({64, 64, 4, PixelType::U8}), "fill"));
    b.mode = "comb";
    EXPECT_NE(refusal(b).find("does not paint colours"), std::string::npos) << refusal(b);
    EXPECT_NE(refusal(b).find("use add, subtract, set, smooth or noise"), std::string::npos) << refusal(b);
    b.mode = "add", b.color.y = 1.5f;
    EXPECT_NE(refusal(b).find("colour is not between 0 and 1"), std::string::npos) << refusal(b);
    b.color.y = 1;
    ASSERT_TRUE(f.doc.createMap("lawn.GrassField.forces"));
    b.map = "forces", b.mode = "add";
    EXPECT_NE(refusal(b).find("use subtract, smooth or press"), std::string::npos) << refusal(b);
    b.map = "nonsense", b.mode = "subtract";
    EXPECT_NE(refusal(b).find("nonsense"), std::string::npos);
    b = subtract(1);
    b.mode = "spray";
    EXPECT_NE(refusal(b).find("add, subtract, set, smooth, noise"), std::string::npos);
    b = subtract(std::numeric_limits<float>::quiet_NaN());
    EXPECT_NE(refusal(b).find("radius"), std::string::npos);
    b = subtract(1, 1.5f);
    EXPECT_NE(refusal(b).find("strength"), std::string::npos);
    EXPECT_FALSE(f.doc.stroking());
}

TEST(Document, PointsThatAreNotFiniteOrFarAwayDoNoHarm) {
    Fixture f;
    ASSERT_TRUE(f.doc.beginStroke(subtract(1), 20, 20));
    f.doc.strokeTo(std::numeric_limits<double>::quiet_NaN(), 3);
    f.doc.strokeTo(1e30, 20);
    f.doc.endStroke();
    f.doc.pumpStroke(0);
    EXPECT_LT(f.density().sample(39.0 / 40, 0.5), 0.6f);  // the line left the terrain to the right
    EXPECT_EQ(f.density().sample(0.5, 0.9), 1);
}

TEST(Document, DirtyMeansDifferentFromDiskHoweverItCameBack) {
    Fixture f;
    EXPECT_FALSE(f.doc.dirty());
    ASSERT_TRUE(f.doc.setField("camera.Camera.fovDeg", "70"));
    EXPECT_TRUE(f.doc.dirty());
    ASSERT_TRUE(f.doc.setField("camera.Camera.fovDeg", "55"));
    EXPECT_FALSE(f.doc.dirty());
    ASSERT_TRUE(f.doc.setField("camera.Camera.fovDeg", "60"));
    ASSERT_TRUE(f.doc.save());
    EXPECT_FALSE(f.doc.dirty());
    ASSERT_TRUE(f.doc.undo());
    EXPECT_TRUE(f.doc.dirty());
    ASSERT_TRUE(f.doc.redo());
    EXPECT_FALSE(f.doc.dirty());
}

TEST(Document, AFailedEditChangesNothing) {
    Fixture f;
    const Project before = f.copy();
    const uint64_t revision = f.doc.revision();
    EXPECT_FALSE(f.doc.setField("camera.Camera.fovDeg", "wide"));
    EXPECT_FALSE(f.doc.setField("camera.Camera.fovDeg", "100000"));
    EXPECT_FALSE(f.doc.setField("camera.Camera.zoom", "1"));
    EXPECT_FALSE(f.doc.addEntity("camera"));
    EXPECT_FALSE(f.doc.addEntity("not a name"));
    EXPECT_FALSE(f.doc.removeEntity("nobody"));
    EXPECT_FALSE(f.doc.addComponent("camera", "Camera"));
    EXPECT_FALSE(f.doc.addComponent("camera", "Rocket"));
    EXPECT_FALSE(f.doc.removeComponent("camera", "Terrain"));
    EXPECT_FALSE(f.doc.addListElement("camera.Camera.fovDeg"));
    EXPECT_FALSE(f.doc.removeListElement("lawn.GrassField.species[nobody]"));
    EXPECT_FALSE(f.doc.setMap(kDensityOfLawn, Map({8, 8, 3, PixelType::U8}), "wrong channels"));
    EXPECT_FALSE(f.doc.setMap("ground.Terrain.height", Map({8, 8, 1, PixelType::U8}), "8-bit heights"));
    EXPECT_FALSE(f.doc.setMap(kDensityOfLawn, Map(), "no map"));
    EXPECT_TRUE(f.same(before));
    EXPECT_FALSE(f.doc.canUndo());
    EXPECT_EQ(f.doc.revision(), revision);
}

TEST(Document, AStrokeOnSeveralMapsIsOneStepAndMakesWhatIsMissing) {
    Fixture f;
    ASSERT_TRUE(f.doc.addListElement("lawn.GrassField.species"));
    const Project before = f.copy();
    BrushSettings like = subtract(3);
    like.map = kDensityOfLawn;
    std::vector<BrushSettings> brushes = speciesBrushes(f.doc.project(), tables().components, like);
    ASSERT_EQ(brushes.size(), 2u);
    EXPECT_FALSE(f.doc.beginStrokes(brushes, 10, 10, false));  // one of them is not there
    EXPECT_TRUE(f.same(before));
    ASSERT_TRUE(f.doc.beginStrokes(brushes, 10, 10, true));
    f.doc.strokeTo(20, 10);
    f.doc.endStroke();
    f.doc.pumpStroke(0);
    for (const char* name : {"lawn", "grass"}) {
        const auto field =
            findField(f.doc.project(), tables().components, fmt::format("lawn.GrassField.species[{}].density", name));
        ASSERT_TRUE(field);
        EXPECT_LT(static_cast<const MapField*>(field->value)->map.sample(15.0 / 40, 10.0 / 40), 0.6f) << name;
    }
    const Project after = f.copy();
    ASSERT_TRUE(f.doc.undo());
    EXPECT_TRUE(f.same(before));
    ASSERT_TRUE(f.doc.redo());
    EXPECT_TRUE(f.same(after));
    brushes[1].mode = "spray";
    EXPECT_FALSE(f.doc.beginStrokes(brushes, 10, 10, true));
    EXPECT_TRUE(f.same(after));
}

TEST(Document, ANewMapChangesNothingThatIsSeenAndIsOneStep) {
    Fixture f;
    const auto value = [&](const char* name, int c) {
        const auto field = findField(f.doc.project(), tables().components, std::string("lawn.GrassField.") + name);
        return static_cast<const MapField*>(field->value)->map.at(3, 3, c);
    };
    for (const char* name : {"orientation", "ambientOcclusion", "vegetation", "forces"}) {
        const Project before = f.copy();
        ASSERT_TRUE(f.doc.createMap(std::string("lawn.GrassField.") + name));
        EXPECT_FALSE(f.same(before)) << name;
        ASSERT_TRUE(f.doc.createMap(std::string("lawn.GrassField.") + name));  // it is there: nothing
        ASSERT_TRUE(f.doc.undo());
        EXPECT_TRUE(f.same(before)) << name;
        ASSERT_TRUE(f.doc.redo());
    }
    EXPECT_EQ(value("ambientOcclusion", 0), 1);
    EXPECT_NEAR(value("orientation", 0), 0.5, 1e-4);
    EXPECT_EQ(value("vegetation", 3), 0);
    EXPECT_NEAR(value("forces", 0), 0.5, 3e-3);
    EXPECT_EQ(value("forces", 3), 0);
    EXPECT_FALSE(f.doc.createMap("lawn.HybridTiers.maxGeom"));
    EXPECT_FALSE(f.doc.createMap("nobody.GrassField.orientation"));
}

TEST(Document, AStrokeOfColourMakesTheMapAndUndoRestoresTheTilesThemselves) {
    Fixture f;
    const auto map = [&](const char* name) {
        return static_cast<const MapField*>(findMap(f.doc.project(), tables().components, name)->value)->map;
    };
    for (const char* name : {"terrainMap", "vegetation"}) {
        const Project before = f.copy();
        BrushSettings b;
        b.map = name, b.radius = 3, b.color = {0.9f, 0.8f, 0.1f}, b.strength = 0.6f;
        ASSERT_TRUE(f.doc.beginStrokes({&b, 1}, 10, 10, true)) << name;
        f.doc.strokeTo(20, 10);
        f.doc.endStroke();
        f.doc.pumpStroke(0);
        const Map first = map(name);
        EXPECT_EQ(first.info().channels, 4);
        EXPECT_NEAR(first.sample(15.0 / 40, 10.0 / 40, 0), 0.9f, 0.01f);
        EXPECT_GT(first.sample(15.0 / 40, 10.0 / 40, 3), 0.9f) << "stamps add up";
        EXPECT_EQ(first.sample(15.0 / 40, 30.0 / 40, 3), 0) << "the rest is transparent";
        b.mode = "subtract";
        stroke(f.doc, b, {{12, 5}, {18, 15}});
        EXPECT_NE(map(name).hash(), first.hash());
        ASSERT_TRUE(f.doc.undo());
        EXPECT_TRUE(map(name).sameTiles(first));
        ASSERT_TRUE(f.doc.undo());
        EXPECT_TRUE(f.same(before));
        ASSERT_TRUE(f.doc.redo());
        EXPECT_TRUE(map(name).sameTiles(first));
    }
}

TEST(Document, AGroupIsOneStepAndMayNest) {
    Fixture f;
    const Project before = f.copy();
    f.doc.beginGroup("drag");
    for (int i = 0; i < 10; ++i) ASSERT_TRUE(f.doc.setField("camera.Camera.fovDeg", std::to_string(50 + i)));
    f.doc.beginGroup("inner");
    ASSERT_TRUE(f.doc.addEntity("sheep"));
    ASSERT_TRUE(f.doc.addComponent("sheep", "Transform"));
    f.doc.endGroup();
    EXPECT_FALSE(f.doc.undo());  // not while the group is open
    stroke(f.doc, subtract(2), {{10, 10}});
    f.doc.endGroup();
    EXPECT_EQ(f.doc.undoLabel(), "drag");
    const Project after = f.copy();
    ASSERT_TRUE(f.doc.undo());
    EXPECT_TRUE(f.same(before));
    EXPECT_FALSE(f.doc.canUndo());
    ASSERT_TRUE(f.doc.redo());
    EXPECT_TRUE(f.same(after));
}

TEST(Document, ACancelledGroupLeavesNothing) {
    Fixture f;
    const Project before = f.copy();
    f.doc.beginGroup("half");
    ASSERT_TRUE(f.doc.removeEntity("lawn"));
    ASSERT_TRUE(f.doc.addEntity("other"));
    f.doc.cancelGroup();
    EXPECT_TRUE(f.same(before));
    EXPECT_FALSE(f.doc.canUndo());
    f.doc.beginGroup("empty");
    f.doc.endGroup();
    EXPECT_FALSE(f.doc.canUndo());
}

TEST(Document, UndoFindsEntitiesByNameAfterTheyWereMadeAnew) {
    Fixture f;
    ASSERT_TRUE(f.doc.setField("camera.Camera.fovDeg", "70"));
    ASSERT_TRUE(f.doc.removeEntity("camera"));
    ASSERT_TRUE(f.doc.addEntity("decoy"));  // takes the freed slot
    ASSERT_TRUE(f.doc.undo());
    ASSERT_TRUE(f.doc.undo());
    EXPECT_EQ(f.text("camera.Camera.fovDeg"), "70");
    ASSERT_TRUE(f.doc.undo());
    EXPECT_EQ(f.text("camera.Camera.fovDeg"), "55");
    ASSERT_TRUE(f.doc.redo());
    ASSERT_TRUE(f.doc.redo());
    EXPECT_FALSE(f.doc.project().entities.contains("camera"));
}

TEST(Document, ListElementsComeWithNewNamesAndGoByName) {
    Fixture f;
    const std::string list = "lawn.GrassField.species";
    ASSERT_TRUE(f.doc.addListElement(list));
    ASSERT_TRUE(f.doc.addListElement(list));
    EXPECT_EQ(f.text(list + "[grass].height"), "0.08");
    EXPECT_EQ(f.text(list + "[grass2].height"), "0.08");
    ASSERT_TRUE(f.doc.setField(list + "[grass2].height", "0.5"));
    ASSERT_TRUE(f.doc.removeListElement(list + "[grass]"));
    EXPECT_EQ(f.text(list + "[1].height"), "0.5");
    EXPECT_TRUE(f.density().info().width > 0);
    ASSERT_TRUE(f.doc.removeListElement(list + "[0]"));  // the maps move along
    EXPECT_EQ(f.text(list + "[0].name"), "grass2");
    for (int i = 0; i < 5; ++i) ASSERT_TRUE(f.doc.undo());
    EXPECT_FALSE(f.doc.dirty());
    EXPECT_EQ(f.text(list + "[0].name"), "lawn");
}

TEST(Document, HistoryForgetsTheOldestStepsWhenItOutgrowsItsBytes) {
    Fixture f(size_t(400) << 10);  // a stroke over the 256 x 256 map replaces at most four tiles of 32 KiB
    for (int i = 0; i < 12; ++i) stroke(f.doc, subtract(30, 0.05f), {{20, 20}});
    int undone = 0;
    while (f.doc.undo()) ++undone;
    EXPECT_GE(undone, 2);
    EXPECT_LT(undone, 4);
}

TEST(Document, TheNewestStepStaysHoweverLargeItIs) {
    Fixture f(1);
    stroke(f.doc, subtract(30), {{20, 20}});
    stroke(f.doc, subtract(30), {{20, 20}});
    EXPECT_TRUE(f.doc.undo());
    EXPECT_FALSE(f.doc.undo());
}

TEST(History, AStepIsChargedOnlyForTilesThatItAloneKeeps) {
    Fixture f;
    ASSERT_TRUE(f.doc.setMap(
        kDensityOfLawn,
        [] {
            Map m({2048, 2048, 1, PixelType::U16});
            for (int y = 0; y < 2048; y += 128)
                for (int x = 0; x < 2048; x += 128) m.set(x, y, 0, float(x + y) / 4096);  // 256 tiles, all their own
            return m;
        }(),
        "big"));
    const GrassField before = *f.doc.project().registry.get<GrassField>(findEntity(f.doc.project(), "lawn"));
    stroke(f.doc, subtract(0.5f), {{20.1, 20.1}});  // within one tile of 2.5 m
    const GrassField after = *f.doc.project().registry.get<GrassField>(findEntity(f.doc.project(), "lawn"));
    const ComponentRow* row = findComponent(tables().components, "GrassField");
    const UndoStep step{"", {{"lawn", row, row->clone(&before), row->clone(&after)}}};
    const size_t tile = 128 * 128 * 2;
    EXPECT_GE(stepBytes(step), tile);
    EXPECT_LT(stepBytes(step), tile + 16384);
}

TEST(Document, AfterOneStrokeSavingRewritesOneMapFile) {
    Fixture f;
    ASSERT_TRUE(f.doc.setMap("vegetation", Map({64, 64, 4, PixelType::U8}), "fill"));
    ASSERT_TRUE(f.doc.setMap("ground.Terrain.height", Map({64, 64, 1, PixelType::F32}), "fill"));
    ASSERT_TRUE(f.doc.save());
    stroke(f.doc, subtract(3), {{10, 10}});
    const auto written = f.doc.save();
    ASSERT_TRUE(written) << written.error().text();
    std::vector<std::string> maps;
    for (const std::string& file : *written)
        if (file.starts_with("maps/")) maps.push_back(file);
    EXPECT_EQ(maps, std::vector<std::string>{"maps/lawn.lawn.density.png"});
    const auto again = f.doc.save();
    ASSERT_TRUE(again);
    EXPECT_TRUE(again->empty());
}

TEST(Document, WhatIsSavedIsFoundAgain) {
    Fixture f;
    stroke(f.doc, subtract(3, 0.37f), {{10, 10}, {15, 20}});
    ASSERT_TRUE(f.doc.setField("camera.Camera.eye", "[1, 2, 3]"));
    ASSERT_TRUE(f.doc.save());
    const uint64_t hash = f.density().hash();
    Document other(tables());
    ASSERT_TRUE(other.open(f.dir / "p"));
    EXPECT_FALSE(other.dirty());
    EXPECT_TRUE(sameProject(other.project(), f.doc.project(), tables().components));
    EXPECT_EQ(
        static_cast<const MapField*>(findMap(other.project(), tables().components, kDensityOfLawn)->value)->map.hash(),
        hash);
}

TEST(Document, SaveAsGoesOnInTheNewFolderAndLeavesTheOldOne) {
    Fixture f;
    stroke(f.doc, subtract(3), {{10, 10}});
    ASSERT_TRUE(f.doc.saveAs(f.dir / "deeper"));
    EXPECT_EQ(f.doc.project().name, "deeper");
    EXPECT_FALSE(f.doc.dirty());
    Document old(tables());
    ASSERT_TRUE(old.open(f.dir / "p"));
    EXPECT_EQ(old.project().name, "p");
    EXPECT_FALSE(sameProject(old.project(), f.doc.project(), tables().components));
}

TEST(Document, AFailedOpenOrSaveAsLeavesTheDocumentAsItWas) {
    Fixture f;
    stroke(f.doc, subtract(3), {{10, 10}});
    const Project before = f.copy();
    test::writeText(f.dir / "broken/project.json", "{ \"format\": 1, ");
    test::writeText(f.dir / "file", "in the way");
    EXPECT_FALSE(f.doc.open(f.dir / "broken"));
    EXPECT_FALSE(f.doc.open(f.dir / "nowhere"));
    EXPECT_FALSE(f.doc.create(f.dir / "p"));
    EXPECT_FALSE(f.doc.saveAs(f.dir / "file"));
    EXPECT_TRUE(f.same(before));
    EXPECT_EQ(f.doc.project().dir.filename(), "p");
    EXPECT_TRUE(f.doc.canUndo());
    EXPECT_TRUE(f.doc.dirty());
}

TEST(Document, ClosedDocumentRefusesEverythingAndCrashesAtNothing) {
    Document doc(tables());
    EXPECT_FALSE(doc.isOpen());
    EXPECT_FALSE(doc.dirty());
    EXPECT_FALSE(doc.save());
    EXPECT_FALSE(doc.saveAs("/nonexistent/x"));
    EXPECT_FALSE(doc.setField("a.b.c", "1"));
    EXPECT_FALSE(doc.beginStroke({}, 0, 0));
    EXPECT_FALSE(doc.undo());
    EXPECT_FALSE(doc.pumpStroke(0));
    doc.beginGroup("g");
    doc.cancelGroup();
    doc.endGroup();
}

// --- a random program of edits, undo and redo, against a list of whole projects ------------------------------------

class RandomProgram {
  public:
    explicit RandomProgram(unsigned seed) : random_(seed) { states_.push_back(f_.copy()); }
    void run(int steps) {
        for (int i = 0; i < steps; ++i) {
            const unsigned kind = random_() % 10;
            if (kind < 2 && at_ > 0)
                move(f_.doc.undo(), -1);
            else if (kind < 4 && at_ + 1 < states_.size())
                move(f_.doc.redo(), 1);
            else
                edit();
            ASSERT_TRUE(f_.same(states_[at_])) << "step " << i;
            ASSERT_EQ(f_.doc.canUndo(), at_ > 0);
            ASSERT_EQ(f_.doc.canRedo(), at_ + 1 < states_.size());
        }
    }

  private:
    void move(bool done, int by) {
        ASSERT_TRUE(done);
        at_ = static_cast<size_t>(static_cast<int>(at_) + by);
    }
    void edit() {
        const Project before = f_.copy();
        const bool group = random_() % 4 == 0;
        if (group) f_.doc.beginGroup("several");
        for (int n = group ? 3 : 1; n > 0; --n) editOnce();
        if (group) f_.doc.endGroup();
        if (f_.same(before)) return;  // it changed nothing, so it must not be a step
        states_.resize(++at_);
        states_.push_back(f_.copy());
    }
    std::string anyEntity() {
        auto it = f_.doc.project().entities.begin();
        std::advance(it, random_() % f_.doc.project().entities.size());
        return it->first;
    }
    // Some of these fail, as edits do: they then change nothing.
    void editOnce() {
        Document& d = f_.doc;
        Status done;
        switch (random_() % 9) {
            case 0:
                done = d.setField("camera.Camera.fovDeg", std::to_string(40 + random_() % 4));
                break;
            case 1:
                done = d.addEntity("e" + std::to_string(random_() % 6));
                break;
            case 2:
                done = d.removeEntity("e" + std::to_string(random_() % 6));
                break;
            case 3:
                done = d.addComponent(anyEntity(), "Fog");
                break;
            case 4:
                done = d.removeComponent(anyEntity(), "Fog");
                break;
            case 5:
                done = d.addListElement("lawn.GrassField.species");
                break;
            case 6:
                done = d.removeListElement("lawn.GrassField.species[1]");
                break;
            case 7:
                done = d.setMap("orientation", Map({int(1 + random_() % 3), 2, 2, PixelType::U16}), "fill");
                break;
            default:
                stroke(d, subtract(float(1 + random_() % 10), 0.3f),
                       {{double(random_() % 40), 20}, {20, double(random_() % 40)}});
        }
    }
    Fixture f_;
    std::mt19937 random_;
    std::vector<Project> states_;
    size_t at_ = 0;
};

TEST(Document, RandomProgramsOfEditsUndoAndRedoMatchAModel) {
    for (unsigned seed = 1; seed <= 4; ++seed) RandomProgram(seed).run(150);
}

}  // namespace
}  // namespace sward
