// The menu Add: each whole thing is one undo step, where one looks, and chosen.
#include "app/add_actions.h"

#include <gtest/gtest.h>

#include "app/object_actions.h"
#include "model/field_walk.h"
#include "model/hollow.h"
#include "model/layer_edits.h"
#include "scene/forest.h"
#include "support.h"
#include "techniques.h"
#include "world/ground.h"

namespace sward {
namespace {

class AddMenu : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(doc.create(dir / "p"));
        before = snapshot(doc.project(), tables().components);
    }
    template <class C>
    const C& get(const std::string& name) {
        return *doc.project().registry.get<C>(findEntity(doc.project(), name));
    }
    // One step back, all is as it was.
    void expectOneStep() {
        EXPECT_EQ(messages.notice, "");
        ASSERT_TRUE(doc.undo());
        EXPECT_TRUE(sameProject(doc.project(), before, tables().components));
        EXPECT_FALSE(doc.canUndo());
    }
    test::TempDir dir;
    Document doc{tables()};
    Project before;
    Selection selection;
    Messages messages;
    Waiting waiting;
    ViewCamera view{{20, 5, 30}, {20, 0, 20}, 55, 0};
};

TEST_F(AddMenu, ALampShinesTwoMetresOverWhereOneLooks) {
    addLamp(doc, view, selection, messages);
    EXPECT_EQ(shownEntity(selection), "lamp");
    EXPECT_EQ(get<Light>("lamp").type, LightType::Point);
    const glm::dvec3 at = get<Transform>("lamp").position;
    EXPECT_NEAR(at.x, 20, 0.01);
    EXPECT_NEAR(at.y, 2, 0.01);
    EXPECT_NEAR(at.z, 20, 0.01);
    expectOneStep();
}

TEST_F(AddMenu, ACameraSeesWhatIsSeen) {
    addCamera(doc, view, selection, messages);
    EXPECT_EQ(shownEntity(selection), "camera-2");
    EXPECT_EQ(get<Camera>("camera-2").eye, view.eye);
    expectOneStep();
}

TEST_F(AddMenu, AForestIsWhatTheBrushPaintsNext) {
    BrushBook brushes;
    addForest(doc, selection, brushes, messages);
    EXPECT_EQ(shownEntity(selection), "forest");
    EXPECT_EQ(brushes.map, "forest.Forest.density");
    EXPECT_TRUE(get<Forest>("forest").density.present()) << "nothing stands before it is painted";
    EXPECT_EQ(get<Forest>("forest").density.map.at(3, 3), 0);
    expectOneStep();
}

TEST_F(AddMenu, FlowersAreWhatTheBrushPaintsNext) {
    BrushBook brushes;
    brushes.map = "lawn.GrassField.species[lawn].density";
    addFlowers(doc, selection, brushes, messages);
    EXPECT_EQ(brushes.map, "flowers.Flowers.density");
    EXPECT_EQ(get<Flowers>("flowers").density.map.mean(), 0);
    expectOneStep();
}

TEST_F(AddMenu, APondIsAHollowWithWaterBelowItsRim) {
    addPond(doc, waiting, view, selection, messages);
    const Water& water = get<Water>("pond");
    const Terrain& ground = get<Terrain>("ground");
    EXPECT_LT(water.level, 0);
    EXPECT_LT(terrainHeight(ground, 20, 20), water.level - 0.8);
    EXPECT_EQ(terrainHeight(ground, 20, 30), 0) << "dry";
    expectOneStep();
}

TEST_F(AddMenu, APondBelowLayersOfHeightsSaysSo) {
    ASSERT_TRUE(addLayer(doc, "ground.Terrain.height", LayerKind::Painted));
    addPond(doc, waiting, view, selection, messages);
    EXPECT_EQ(messages.status, "new: pond, dug below 1 layer");
}

// A plane that rises by so many metres along x.
void raiseAlongX(Document& doc, float metres) {
    ASSERT_TRUE(doc.createMap("ground.Terrain.height"));
    Map heights =
        static_cast<const MapField*>(findField(doc.project(), doc.tables().components, "ground.Terrain.height")->value)
            ->map;
    for (int j = 0; j < heights.info().height; ++j)
        for (int i = 0; i < heights.info().width; ++i)
            heights.set(i, j, 0, metres * (static_cast<float>(i) + 0.5f) / static_cast<float>(heights.info().width));
    ASSERT_TRUE(doc.setMap("ground.Terrain.height", std::move(heights), "raise"));
}

TEST_F(AddMenu, EachPondHasALevelOfItsOwnBelowTheLowestOfItsRim) {
    raiseAlongX(doc, 2);
    addPond(doc, waiting, view, selection, messages);
    view = {{32, 6, 20}, {32, 1.6, 10}, 55, 0};
    addPond(doc, waiting, view, selection, messages);
    const Ground ground = findGround(doc.project());
    for (const char* name : {"pond", "pond-2"}) {
        const Water& water = get<Water>(name);
        const glm::dvec3 at = get<Transform>(name).position;
        EXPECT_NEAR(at.y, double(water.level), 1e-3) << name;
        const double rim = lowestAlongRim(*ground.terrain, {}, {at.x, at.z}, double(water.radius)).height;
        EXPECT_GT(rim, double(water.level)) << name << " runs over";
        EXPECT_LT(rim, double(water.level) + 0.3) << name;
        EXPECT_LT(terrainHeight(*ground.terrain, at.x, at.z), double(water.level) - 0.8) << name;
    }
    EXPECT_GT(get<Water>("pond-2").level, get<Water>("pond").level + 0.3f);
}

TEST_F(AddMenu, AHollowWhereWaterStandsCloseBelowLetsItIn) {
    ASSERT_TRUE(doc.addEntity("lake"));
    ASSERT_TRUE(doc.addComponent("lake", "Water"));
    ASSERT_TRUE(doc.setField("lake.Water.level", "-1"));
    addPond(doc, waiting, view, selection, messages);
    EXPECT_FALSE(doc.project().entities.contains("pond"));
    EXPECT_EQ(shownEntity(selection), "lake");
    EXPECT_LT(terrainHeight(get<Terrain>("ground"), 20, 20), -1.8);
    ASSERT_TRUE(doc.undo());
    ASSERT_TRUE(doc.setField("lake.Water.level", "-30"));
    addPond(doc, waiting, view, selection, messages);
    EXPECT_TRUE(doc.project().entities.contains("pond")) << "not thirty metres deep";
}

// The rim of the second lies in the first, whose floor is no ground that water would run down to.
TEST_F(AddMenu, APondBesideAPondStandsAsHighAndIsNoDeeper) {
    addPond(doc, waiting, view, selection, messages);
    view = {{28, 5, 30}, {28, 0, 20}, 55, 0};
    addPond(doc, waiting, view, selection, messages);
    ASSERT_TRUE(doc.project().entities.contains("pond-2"));
    EXPECT_EQ(get<Water>("pond-2").level, get<Water>("pond").level);
    const Terrain& ground = get<Terrain>("ground");
    EXPECT_NEAR(terrainHeight(ground, 28, 20), terrainHeight(ground, 20, 20), 0.05);
    EXPECT_LT(terrainHeight(ground, 24, 20), get<Water>("pond").level) << "one water";
}

// The ground in its middle lies three metres over the lake, but the rim reaches it.
TEST_F(AddMenu, AHollowInASteepBankLetsTheLakeIn) {
    raiseAlongX(doc, 20);
    ASSERT_TRUE(doc.addEntity("lake"));
    ASSERT_TRUE(doc.addComponent("lake", "Water"));
    ASSERT_TRUE(doc.setField("lake.Water.level", "7.5"));
    view = {{20, 15, 30}, {20, 10, 20}, 55, 0};
    addPond(doc, waiting, view, selection, messages);
    EXPECT_FALSE(doc.project().entities.contains("pond")) << "two waters of one level";
    EXPECT_LT(terrainHeight(get<Terrain>("ground"), 20, 20), 6.5);
}

TEST_F(AddMenu, APondInTheSkyIsRefused) {
    view.target = {20, 50, 20};
    addPond(doc, waiting, view, selection, messages);
    EXPECT_NE(messages.notice.find("no ground"), std::string::npos) << messages.notice;
    EXPECT_FALSE(doc.canUndo());
}

TEST_F(AddMenu, ACopyStandsAsideOfItsOriginalAndTheGroundStays) {
    addLamp(doc, view, selection, messages);
    choose(selection, std::vector<std::string>{"lamp", "camera", "ground"}, Choose::Only);
    const glm::dvec3 lamp = get<Transform>("lamp").position, eye = get<Camera>("camera").eye;
    const size_t steps = doc.stepsDone();
    duplicateChosen(doc, selection, messages, {0.5, 0, 0});
    EXPECT_EQ(selection.entities, (std::vector<std::string>{"lamp-2", "camera-2", "ground-2"}));
    EXPECT_NEAR(get<Transform>("lamp-2").position.x, lamp.x + 0.5, 1e-6);
    EXPECT_NEAR(get<Camera>("camera-2").eye.x, eye.x + 0.5, 1e-6);
    EXPECT_EQ(doc.project().registry.get<Transform>(findEntity(doc.project(), "ground-2")), nullptr);
    EXPECT_EQ(doc.stepsDone(), steps + 1);
}

}  // namespace
}  // namespace sward
