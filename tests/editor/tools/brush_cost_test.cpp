// Blades under a brush, and those that a stroke brought.
#include "editor/tools/brush_cost.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "model/document.h"
#include "support.h"
#include "techniques.h"
#include "tools/brush_book.h"

namespace sward {
namespace {

TEST(BrushCost, BladesUnderABrushAreThoseOfTheTexelsInItsDisc) {
    Map density({200, 160, 1, PixelType::U8});
    std::mt19937 random(9);
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x < 200; ++x) density.set(x, y, 0, static_cast<float>(random() % 256) / 255.0f);
    const MapScale scale{50, 40, false};  // texels of a quarter metre
    for (const auto& [cx, cz, radius] :
         {std::tuple{20.0, 15.0, 3.0}, {0.5, 39.0, 2.5}, {-1.0, 5.0, 0.5}, {25.1, 20.2, 0.05}}) {
        double hand = 0;
        for (int y = 0; y < 160; ++y)
            for (int x = 0; x < 200; ++x)
                if (std::hypot((x + 0.5) / 4 - cx, (y + 0.5) / 4 - cz) <= radius)
                    hand += static_cast<double>(density.at(x, y)) * 3000 / 16;
        EXPECT_NEAR(bladesInDisc(density, 3000, scale, cx, cz, radius), hand, 1e-6 * hand + 1e-9);
    }
    Map full({2000, 2000, 1, PixelType::U8});
    for (int y = 0; y < 2000; ++y)
        for (int x = 0; x < 2000; ++x) full.set(x, y, 0, 1);
    const double disc = 3.14159265 * 40 * 40;
    EXPECT_NEAR(bladesInDisc(full, 10, {100, 100, false}, 50, 50, 40), disc * 10, disc * 10 * 0.01) << "sampled";
    EXPECT_NEAR(bladesInDisc(full, 10, {10, 10, true}, 0, 0, 1), 10 * 3.14159265, 0.1) << "across the repeat's edge";
    EXPECT_NEAR(bladesInDisc({}, 10, {100, 100, false}, 50, 50, 40), disc * 10, 1e-3);
}

TEST(BrushCost, AStrokesBladesAreTheDifferenceOfTheMaps) {
    Map before({300, 200, 1, PixelType::U8});
    before.set(5, 5, 0, 1);
    Map now = before;
    now.set(290, 190, 0, 1), now.set(5, 5, 0, 0), now.set(6, 6, 0, 1), now.set(140, 7, 0, 0.6f);
    const MapScale scale{30, 20, false};
    const BladeChange there = bladesChanged(before, now, 1000, scale), back = bladesChanged(now, before, 1000, scale);
    EXPECT_NEAR(there.added, 1000 * 0.01 * 2.6, 1e-4);
    EXPECT_NEAR(there.removed, 1000 * 0.01 * 1, 1e-4);
    EXPECT_NEAR(there.sum(), 1000 * 0.01 * 1.6, 1e-4);
    EXPECT_NEAR(back.added, there.removed, 1e-9);
    EXPECT_NEAR(back.removed, there.added, 1e-9);
    EXPECT_EQ(bladesChanged(now, now, 1000, scale).added, 0);
    EXPECT_EQ(bladesChanged(now, now, 1000, scale).removed, 0);
    EXPECT_NEAR(bladesChanged({}, before, 1, {300, 200, false}).sum(), 1 - 60000, 1e-6) << "no map is density 1";
}

// What a frame does: the hand, then the pump, then the count.
TEST(BrushCost, AStrokeIsCountedOverAllSpeciesThatItPaintsEvenIfItIsDoneWithinAFrame) {
    test::TempDir dir;
    Document doc(tables());
    ASSERT_TRUE(doc.create(dir / "p"));
    ASSERT_TRUE(doc.addListElement("lawn.GrassField.species"));
    BrushSettings like;
    like.map = "lawn.GrassField.species[lawn].density";
    like.mode = "subtract", like.radius = 2, like.falloff = 0;
    const std::vector<BrushSettings> both = speciesBrushes(doc.project(), doc.tables().components, like);
    ASSERT_EQ(both.size(), 2u);
    // By the means of the maps: blades per m2 times the 40 x 40 m of the terrain.
    const auto blades = [&] {
        double sum = 0;
        for (const Species& s : doc.project().registry.get<GrassField>(findEntity(doc.project(), "lawn"))->species)
            sum += 1600 * static_cast<double>(s.bladesPerM2) * (s.density.present() ? s.density.map.mean() : 1);
        return sum;
    };
    BrushBook book;
    BrushCost cost;
    const auto frame = [&] {
        doc.pumpStroke(0);
        followBrushCost(cost, doc, book, std::nullopt, nullptr);
    };
    frame();
    EXPECT_FALSE(cost.stroke);
    const double all = blades();
    ASSERT_TRUE(doc.beginStrokes(both, 20, 20, true));
    doc.endStroke();
    frame();
    ASSERT_TRUE(cost.stroke) << "begun, painted and ended between two counts";
    EXPECT_EQ(cost.stroke->added, 0);
    EXPECT_GT(cost.stroke->removed, 10000);
    EXPECT_NEAR(cost.stroke->removed, all - blades(), 1e-3 * cost.stroke->removed);
    const double removed = cost.stroke->removed;
    frame();
    EXPECT_EQ(cost.stroke->removed, removed) << "it stays on the status line";
    like.mode = "add", like.strength = 0.5f;
    ASSERT_TRUE(doc.beginStroke(like, 20, 20));
    frame();  // painted before it has ended
    ASSERT_TRUE(cost.stroke);
    EXPECT_GT(cost.stroke->added, 0);
    EXPECT_EQ(cost.stroke->removed, 0);
    doc.endStroke();
    frame();
    EXPECT_GT(cost.stroke->added, 0);
    ASSERT_TRUE(doc.undo());
    frame();
    EXPECT_FALSE(cost.stroke) << "undone";
    ASSERT_TRUE(doc.setField("ground.Terrain.mapSize", "20"));
    like.mode = "subtract", like.strength = 1;
    ASSERT_TRUE(doc.beginStroke(like, 10, 10));
    doc.endStroke();
    frame();
    ASSERT_TRUE(cost.stroke);
    const double four = cost.stroke->removed;  // in four repeats
    ASSERT_TRUE(doc.undo() && doc.setField("ground.Terrain.mapSize", "0"));
    like.radius = 4;
    ASSERT_TRUE(doc.beginStroke(like, 20, 20));  // the same texels, once and twice as wide
    doc.endStroke();
    frame();
    EXPECT_NEAR(cost.stroke->removed, four, 1e-3 * four);
}

TEST(BrushCost, AStrokesTimeIsTheGrasssTimesTheShareThatItAdds) {
    BrushCost cost;
    EXPECT_FALSE(strokeMs(cost, 1000)) << "there was no stroke";
    cost.stroke = BladeChange{700, 200};
    EXPECT_FALSE(strokeMs(cost, 1000)) << "nothing was measured";
    cost.grassMs = 8;
    EXPECT_EQ(strokeMs(cost, 1000), 4);
    EXPECT_FALSE(strokeMs(cost, 0)) << "no blade is in view";
    cost.stroke = BladeChange{0, 5000};
    EXPECT_EQ(strokeMs(cost, 1000), -8) << "no more than all of it goes";
}

}  // namespace
}  // namespace sward
