// A session is recorded while it is made, then its script runs on a copy of the project as it was: equal hashes.
#include "model/recorder.h"

#include "brushes/shape.h"
#include "model/entity_edits.h"
#include "model/layer_edits.h"
#include "model/step_script.h"
#include "model/whole_map.h"
#include "project/project_files.h"
#include "scenes.h"
#include "script/script.h"
#include "support.h"

namespace sward::test {
namespace {

namespace fs = std::filesystem;

class Recording : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(doc.create(dir / "meadow"));
        BrushSettings before;  // steps of before the start move the rounding of later strokes
        before.radius = 3, before.strength = 0.013f;
        stroke(before, {{5, 5}, {9, 6}});
        ok(doc.setField("lawn.GrassField.seed", "7"));
        ASSERT_TRUE(doc.save());
        fs::copy(doc.project().dir, dir / "copy", fs::copy_options::recursive);
        ok(recorder.start(doc));
    }
    void ok(const Status& s) { EXPECT_TRUE(s) << s.error().text(); }
    void stroke(const BrushSettings& b, const std::vector<glm::dvec2>& points) { strokes({b}, points, true); }
    void strokes(const std::vector<BrushSettings>& b, const std::vector<glm::dvec2>& points, bool create) {
        ok(doc.beginStrokes(b, points[0].x, points[0].y, create));
        for (const glm::dvec2& p : points) {
            doc.strokeTo(p.x, p.y);
            doc.pumpStroke(0.01);
        }
        doc.endStroke();
        while (doc.pumpStroke(0.01)) {
        }
    }
    BrushSettings brush(const char* map, const char* mode, float strength = 0.013f) {
        BrushSettings b;
        b.map = map, b.mode = mode, b.radius = 2.3f, b.strength = strength, b.seed = 5;
        return b;
    }
    static std::string hashOf(const Document& d) {
        return std::to_string(projectHash(d.project(), d.tables().components));
    }
    // The script on the copy; its error, or "".
    std::string replay() {
        writeText(dir / "session.lua", recorder.script());
        EXPECT_TRUE(other.open(dir / "copy"));
        ScriptHost host{other};
        const Status ran = runScript(dir / "session.lua", host);
        return ran ? "" : ran.error().text() + "\n" + recorder.script();
    }
    void expectRepeats() {
        EXPECT_TRUE(recorder.left().empty()) << recorder.script();
        EXPECT_EQ(replay(), "");
        EXPECT_EQ(hashOf(other), hashOf(doc)) << recorder.script();
    }

    TempDir dir;
    Document doc{tables()}, other{tables()};
    Recorder recorder;
};

TEST_F(Recording, StrokesEditsAndUndoAreRepeatedToTheLastTexel) {
    stroke(brush("density", "subtract"), {{6, 6}, {11.25, 7.125}, {13, 9}});
    ok(doc.setField("lawn.GrassField.species[0].height", "0.123"));
    stroke(brush("density", "noise", 0.4f), {{8, 4}, {9, 12}});
    stroke(brush("density", "add", 0.0077f), {{4, 4}});
    EXPECT_TRUE(doc.undo());
    EXPECT_TRUE(doc.undo());
    EXPECT_TRUE(doc.redo());
    stroke(brush("orientation", "comb", 0.7f), {{3, 3}, {9, 4}, {10, 9}});
    BrushSettings flatten = brush("height", "flatten", 0.5f);
    stroke(brush("height", "raise", 0.5f), {{7, 7}, {9, 9}});
    stroke(flatten, {{7, 7}, {11, 9}});
    stroke(brush("height", "erode", 0.5f), {{7, 8}, {9, 9}});
    expectRepeats();
}

TEST_F(Recording, EntitiesComponentsAndListsAreRepeated) {
    ok(doc.addEntity("bench"));
    ok(doc.addComponent("bench", "Transform"));
    ok(doc.setField("bench.Transform.position", "[1.1, 0, 2.7]"));
    doc.beginGroup("place a lamp");
    ok(doc.addEntity("lamp"));
    ok(doc.addComponent("lamp", "Light"));
    ok(doc.setField("lamp.Light.type", "point"));
    ok(doc.setField("lamp.Light.color", "[0.1, 0.7, 0.3]"));
    doc.endGroup();
    ok(renameEntity(doc, "bench", "seat"));
    EXPECT_TRUE(duplicateEntities(doc, std::vector<std::string>{"lamp", "lawn"}));
    ok(hideEntities(doc, std::vector<std::string>{"seat"}, true));
    ok(hideEntities(doc, std::vector<std::string>{"seat"}, false));
    ok(addUnpainted(doc, "lawn.GrassField.species"));
    ok(doc.addListElement("lawn.GrassField.species"));
    ok(doc.setField("lawn.GrassField.species[1].name", "clo\"ver"));
    ok(doc.moveListElement("lawn.GrassField.species[0]", 2));
    ok(doc.removeListElement("lawn.GrassField.species[0]"));
    ok(doc.removeEntity("seat"));
    EXPECT_TRUE(doc.undo());
    ok(doc.setField("lawn.HybridTiers.minGeom", "inf"));
    expectRepeats();
}

TEST_F(Recording, WholeMapsAndLayersAreRepeated) {
    ok(invertMap(doc, "lawn.GrassField.species[0].density"));
    BrushSettings fill = brush("lawn.GrassField.species[0].density", "set");
    fill.value = 0.3f;
    stroke(brush("density", "add", 0.5f), {{3, 3}, {9, 4}});
    ok(fillMap(doc, fill));
    ok(doc.createMap("lawn.GrassField.bladeHeight"));
    ok(clearMap(doc, "lawn.GrassField.bladeHeight"));
    ok(doc.setField("lawn.GrassField.bladeHeight", ""));
    ok(addLayer(doc, "lawn.GrassField.species[0].density", LayerKind::Rule));
    expectRepeats();
}

TEST_F(Recording, SeveralMapsAtOnceAreOneStroke) {
    ok(addUnpainted(doc, "lawn.GrassField.species"));
    const std::vector<BrushSettings> both{brush("lawn.GrassField.species[0].density", "subtract", 0.4f),
                                          brush("lawn.GrassField.species[1].density", "subtract", 0.4f)};
    strokes(both, {{3, 3}, {7, 5}}, true);
    expectRepeats();
}

TEST_F(Recording, ShapesMirrorsAndImprintsAreRepeated) {
    BrushSettings shaped = brush("density", "subtract", 0.8f);
    shaped.shape = builtInShape("splatter");
    shaped.shapeTurn = ShapeTurn::Random, shaped.shapeAngleDeg = 20;
    shaped.mirrorZ = true;
    stroke(shaped, {{3, 3}, {9, 4}});
    shaped.mirrorX = true, shaped.shapeTurn = ShapeTurn::Along;
    stroke(shaped, {{5, 3}, {5, 9}});
    BrushSettings imprint = brush("height", "imprint");
    imprint.shape = builtInShape("mountain");
    imprint.value = 2, imprint.blend = HeightBlend::Maximum, imprint.fromStart = false, imprint.base = 0.25f;
    stroke(imprint, {{8, 8}});
    imprint.blend = HeightBlend::Replace, imprint.fromStart = true;
    stroke(imprint, {{20, 12}});
    expectRepeats();
}

TEST_F(Recording, WhatHasNoCallIsNamedAndTheLastHashLeftOut) {
    Map map(MapInfo{64, 64, 1, PixelType::U8});
    map.set(3, 3, 0, 1);
    ok(doc.setMap("lawn.GrassField.bladeHeight", map, "height from density"));
    ASSERT_EQ(recorder.left().size(), 1u);
    EXPECT_EQ(recorder.left()[0], "the texels of lawn.GrassField.bladeHeight (height from density)");
    EXPECT_TRUE(doc.undo());
    EXPECT_EQ(recorder.left().size(), 2u);
    stroke(brush("density", "subtract"), {{6, 6}, {11, 7}});
    EXPECT_EQ(replay(), "");
    EXPECT_NE(recorder.script().find("-- Not recorded"), std::string::npos);
}

TEST_F(Recording, UndoBeyondTheStartIsNamedAndWhatFollowsStaysInStep) {
    EXPECT_TRUE(doc.undo());  // the seed, from before
    EXPECT_TRUE(doc.redo());
    EXPECT_EQ(recorder.left().size(), 2u);
    ok(doc.setField("lawn.GrassField.seed", "9"));
    EXPECT_TRUE(doc.undo());
    EXPECT_EQ(replay(), "");
    EXPECT_EQ(hashOf(other), hashOf(doc)) << recorder.script();
}

TEST_F(Recording, ALineOfTheConsoleStandsAsItWasTyped) {
    ScriptHost host{doc};
    ScriptConsole console(host);
    for (const char* line :
         {"much = 0.4", "map.mean(\"density\")", "map.noise(\"density\", { scale = 2, seed = 3, amount = much })"}) {
        recorder.beginLine();
        const Status ran = console.run(line);
        recorder.endLine(line, static_cast<bool>(ran));
        ok(ran);
    }
    EXPECT_TRUE(doc.undo());
    EXPECT_TRUE(doc.redo());
    expectRepeats();
    EXPECT_EQ(recorder.calls(), 4u) << recorder.script();
}

TEST_F(Recording, AScriptOnAnotherProjectSaysSo) {
    ok(doc.setField("lawn.GrassField.seed", "9"));
    ASSERT_TRUE(other.open(dir / "copy"));
    ASSERT_TRUE(other.setField("lawn.GrassField.seed", "8"));
    ASSERT_TRUE(other.save());
    EXPECT_NE(replay().find("session.lua:2"), std::string::npos);
}

TEST_F(Recording, UnsavedWorkIsNoBeginning) {
    recorder.stop();
    ok(doc.setField("lawn.GrassField.seed", "9"));
    const Status s = recorder.start(doc);
    ASSERT_FALSE(s);
    EXPECT_NE(s.error().text().find("save first"), std::string::npos);
}

TEST_F(Recording, AnotherProjectEndsIt) {
    ok(doc.setField("lawn.GrassField.seed", "9"));
    ASSERT_TRUE(doc.open(dir / "copy"));
    ok(doc.setField("lawn.GrassField.seed", "10"));
    EXPECT_EQ(recorder.script().find("10)"), std::string::npos) << recorder.script();
    EXPECT_EQ(recorder.left().size(), 1u);
}

TEST(LuaText, IsWhatLuaReads) {
    EXPECT_EQ(luaText("a \"b\" \\ c\n"), "\"a \\\"b\\\" \\\\ c\\010\"");
    const float never = std::numeric_limits<float>::infinity();
    const FieldRow row{"f", FieldType::Float, 0, "", 0, 0, 0, 0, ""};
    EXPECT_EQ(luaValue(row, &never), "math.huge");
}

}  // namespace
}  // namespace sward::test
