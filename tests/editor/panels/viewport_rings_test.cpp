// Whose distances the rings show, and what a hand without a ring does.
#include "panels/viewport_rings.h"

#include "editor/panels/panel_stage.h"
#include "techniques.h"

namespace sward {
namespace {

class TierRings : public test::PanelStage {
  protected:
    RingParts parts() { return {doc, tiers, camera, view, 500, tierEntity(doc, tiers.field, ""), false}; }
    TierView tiers;
    FlyCamera camera;
    Rect view{0, 0, 400, 300};
};

TEST_F(TierRings, TheChosenFieldComesBeforeTheSelectedAndThatBeforeTheFirst) {
    for (const char* entity : {"a", "z"}) {
        ASSERT_TRUE(doc.addEntity(entity));
        ASSERT_TRUE(doc.addComponent(entity, "GrassField"));
    }
    EXPECT_EQ(tierEntity(doc, "", ""), "a");
    EXPECT_EQ(tierEntity(doc, "", "z"), "z");
    EXPECT_EQ(tierEntity(doc, "lawn", "z"), "lawn");
    EXPECT_EQ(tierEntity(doc, "gone", "camera"), "a") << "neither has a field";
    EXPECT_EQ(tierPath("z", 1), "z.HybridTiers.maxGeom");
    Document none(tables());
    EXPECT_EQ(tierEntity(none, "", ""), "");
    EXPECT_FALSE(tierField(none, ""));
}

TEST_F(TierRings, AHandWithoutARingChangesNothing) {
    EXPECT_FALSE(grabRing(parts(), {}, edits));
    dragRing(parts(), messages, 10, 10);
    cancelRing(tiers, doc, edits, messages);
    EXPECT_FALSE(doc.canUndo());
    EXPECT_EQ(messages.status, "");
}

TEST_F(TierRings, WhatWasDraggedIsOneStepAndEscapeTakesItBack) {
    tiers.hover = RingHit{{1}, {200, 150}, 0, 0};
    const std::string before = field("lawn.HybridTiers.maxGeom");
    ASSERT_TRUE(grabRing(parts(), {}, edits));
    EXPECT_EQ(edits.holding, "lawn.HybridTiers.maxGeom");
    ASSERT_TRUE(doc.setField("lawn.HybridTiers.maxGeom", "20"));
    cancelRing(tiers, doc, edits, messages);
    EXPECT_EQ(field("lawn.HybridTiers.maxGeom"), before);
    EXPECT_FALSE(tiers.drag);
    EXPECT_EQ(edits.holding, "");
    EXPECT_FALSE(doc.canUndo());
}

}  // namespace
}  // namespace sward
