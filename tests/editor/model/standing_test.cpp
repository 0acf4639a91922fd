// The ground that hands meet, from revision to revision: at once where somebody waits, else as it was until it is made.
#include "model/standing.h"

#include <gtest/gtest.h>

#include <thread>

#include "model/document.h"
#include "model/layer_edits.h"
#include "support.h"
#include "techniques.h"
#include "world/ground.h"

namespace sward {
namespace {

class StandingGround : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(doc.create(dir / "p"));
        ASSERT_TRUE(doc.setMap("ground.Terrain.height", Map({4096, 4096, 1, PixelType::F32}), "heights"));
    }
    double height() { return terrainHeight(*findGround(doc.standing()).terrain, 20, 20); }
    void addRelief() {
        ASSERT_TRUE(addLayer(doc, "ground.Terrain.height", LayerKind::Painted));
        ASSERT_TRUE(doc.setField("ground.MapLayers.layers[painted].low", "3"));
        ASSERT_TRUE(doc.setField("ground.MapLayers.layers[painted].operation", "replace"));
    }
    test::TempDir dir;
    Document doc{tables()};
};

TEST_F(StandingGround, WhoWaitsStandsOnTheLayers) {
    EXPECT_EQ(&doc.standing(), &doc.project());
    addRelief();
    EXPECT_NEAR(height(), 3, 0.01);
    EXPECT_FALSE(doc.followStanding());
    ASSERT_TRUE(doc.undo() && doc.undo() && doc.undo());
    EXPECT_EQ(&doc.standing(), &doc.project());
}

TEST_F(StandingGround, WhoDoesNotStandsOnThemLater) {
    doc.standBeside();
    addRelief();
    height();
    const Project* first = &doc.standing();
    EXPECT_EQ(first, &doc.standing()) << "it stays, within a frame";
    for (int i = 0; i < 5000 && std::abs(height() - 3) > 0.01; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        doc.followStanding();
    }
    EXPECT_NEAR(height(), 3, 0.01);
    EXPECT_EQ(doc.standing().registry.get<MapLayers>(findEntity(doc.standing(), "ground"))->layers.size(), 0u)
        << "layers over heights are taken off";
    ASSERT_TRUE(doc.addEntity("later"));
    EXPECT_NE(findEntity(doc.standing(), "later"), kNoEntity) << "the rest is as it is now, even on older ground";
}

}  // namespace
}  // namespace sward
