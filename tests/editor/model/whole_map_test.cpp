// Whole maps filled, cleared and inverted; and what is added so that nothing of it grows yet.
#include "model/whole_map.h"

#include <gtest/gtest.h>

#include <chrono>

#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

using test::TempDir;
constexpr const char* kWholeMap = "lawn.GrassField.species[lawn].density";
constexpr const char* kPaint = "lawn.GrassField.vegetation";
constexpr const char* kLean = "lawn.GrassField.orientation";

struct Fixture {
    TempDir dir;
    Document doc{tables()};
    Fixture() { EXPECT_TRUE(doc.create(dir / "p")); }
    Map map(const std::string& path) {
        const auto field = findField(doc.project(), doc.tables().components, path);
        EXPECT_TRUE(field) << path;
        return static_cast<const MapField*>(field->value)->map;
    }
    BrushSettings brush(const std::string& path, float value) { return {.map = path, .value = value}; }
};
Map gradient(PixelType type, int channels, int side = 200) {
    Map m({side, side, channels, type});
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            for (int c = 0; c < channels; ++c)
                m.set(x, y, c, static_cast<float>((x * 7 + y * 3 + c * 50) % 256) / 255.0f);
    return m;
}

TEST(WholeMap, FillsWithWhatTheBrushLaysAndUndoBringsAllBack) {
    Fixture f;
    ASSERT_TRUE(f.doc.setMap(kWholeMap, gradient(PixelType::U16, 1), "test"));
    const uint64_t before = f.map(kWholeMap).hash();
    ASSERT_TRUE(fillMap(f.doc, f.brush(kWholeMap, 0.25f)));
    const Map full = f.map(kWholeMap);
    EXPECT_NEAR(full.mean(), 0.25, 1e-5);
    for (const auto& [x, y] : {std::pair{0, 0}, {127, 127}, {128, 0}, {199, 199}, {5, 150}})
        EXPECT_NEAR(full.at(x, y), 0.25, 1e-5) << x << " " << y;
    EXPECT_EQ(f.doc.undoLabel(), std::string("fill ") + kWholeMap);
    ASSERT_TRUE(f.doc.undo());
    EXPECT_EQ(f.map(kWholeMap).hash(), before);
    // Equal to the same map made texel by texel, beyond whose edge nothing lies.
    Map same({200, 200, 1, PixelType::U16});
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x) same.set(x, y, 0, 0.25f);
    EXPECT_EQ(full.hash(), same.hash());
    for (int ty = 0; ty < 2; ++ty)
        for (int tx = 0; tx < 2; ++tx)
            EXPECT_TRUE(sameTexels(*full.tile(tx, ty), *same.tile(tx, ty))) << tx << " " << ty;
}

TEST(WholeMap, MakesAMapThatIsNotThere) {
    Fixture f;
    ASSERT_TRUE(f.map(kPaint).empty());
    BrushSettings brush = f.brush(kPaint, 0.5f);
    brush.color = {1, 0, 0};
    ASSERT_TRUE(fillMap(f.doc, brush));
    const Map paint = f.map(kPaint);
    ASSERT_FALSE(paint.empty());
    EXPECT_NEAR(paint.mean(0), 1, 1e-6);
    EXPECT_NEAR(paint.mean(1), 0, 1e-6);
    EXPECT_NEAR(paint.mean(3), 0.5, 0.003);
    ASSERT_TRUE(f.doc.undo());
    EXPECT_TRUE(f.map(kPaint).empty());
}

TEST(WholeMap, DirectionsAreFilledByTheAngleAndTurnedRound) {
    Fixture f;
    BrushSettings brush = f.brush(kLean, 1);
    brush.angleDeg = 90;  // east, +x
    ASSERT_TRUE(fillMap(f.doc, brush));
    EXPECT_NEAR(f.map(kLean).at(3, 3, 0), 1, 1e-4);
    EXPECT_NEAR(f.map(kLean).at(3, 3, 1), 0.5, 1e-4);
    ASSERT_TRUE(invertMap(f.doc, kLean));
    EXPECT_NEAR(f.map(kLean).at(3, 3, 0), 0, 1e-4);
    ASSERT_TRUE(clearMap(f.doc, kLean));
    EXPECT_NEAR(f.map(kLean).at(3, 3, 0), 0.5, 1e-4);
}

TEST(WholeMap, InvertingTwiceIsTheMapAgainForEveryTypeOfTexel) {
    for (const PixelType type : {PixelType::U8, PixelType::U16}) {
        Fixture f;
        ASSERT_TRUE(f.doc.setMap(kWholeMap, gradient(type, 1), "test"));
        const Map before = f.map(kWholeMap);
        ASSERT_TRUE(invertMap(f.doc, kWholeMap));
        EXPECT_NEAR(f.map(kWholeMap).mean(), 1 - before.mean(), 1e-5);
        EXPECT_NE(f.map(kWholeMap).hash(), before.hash());
        ASSERT_TRUE(invertMap(f.doc, kWholeMap));
        EXPECT_EQ(f.map(kWholeMap).hash(), before.hash());
    }
}

TEST(WholeMap, ClearedPaintKeepsItsColourForWhatIsPaintedBeside) {
    Fixture f;
    ASSERT_TRUE(f.doc.setMap(kPaint, gradient(PixelType::U8, 4), "test"));
    const Map before = f.map(kPaint);
    ASSERT_TRUE(clearMap(f.doc, kPaint));
    EXPECT_EQ(f.map(kPaint).at(10, 20, 0), before.at(10, 20, 0));
    EXPECT_EQ(f.map(kPaint).mean(3), 0);
}

TEST(WholeMap, HeightsAreClearedButNeitherFilledNorInverted) {
    Fixture f;
    const char* height = "ground.Terrain.height";
    ASSERT_TRUE(f.doc.setMap(height, gradient(PixelType::F32, 1), "test"));
    EXPECT_FALSE(fillMap(f.doc, f.brush(height, 1)));
    EXPECT_FALSE(invertMap(f.doc, height));
    ASSERT_TRUE(clearMap(f.doc, height));
    EXPECT_EQ(f.map(height).mean(), 0);
    EXPECT_FALSE(clearMap(f.doc, "lawn.GrassField.technique"));
    EXPECT_FALSE(clearMap(f.doc, "nobody.GrassField.vegetation"));
}

// A count instead of a time: equal tiles stay one, so that size costs nothing.
TEST(WholeMap, AFilledMapOfAnySizeHoldsAFewTiles) {
    const Map m = uniformMap({4000, 4000, 1, PixelType::U16}, glm::vec4(0.5f));
    std::set<const Tile*> tiles;
    for (int ty = 0; ty < m.tilesY(); ++ty)
        for (int tx = 0; tx < m.tilesX(); ++tx) tiles.insert(m.tile(tx, ty).get());
    EXPECT_EQ(tiles.size(), 4u);  // inside, both edges, the corner
    const Map inverted = changedTexels(m, [](float* t) { t[0] = 1 - t[0]; });
    tiles.clear();
    for (int ty = 0; ty < m.tilesY(); ++ty)
        for (int tx = 0; tx < m.tilesX(); ++tx) tiles.insert(inverted.tile(tx, ty).get());
    EXPECT_EQ(tiles.size(), 4u);
}

TEST(Unpainted, ANewSpeciesGrowsNowhereAndIsOneStep) {
    Fixture f;
    ASSERT_TRUE(addUnpainted(f.doc, "lawn.GrassField.species"));
    const auto list = findField(f.doc.project(), f.doc.tables().components, "lawn.GrassField.species");
    const std::vector<std::string> names = elementSelectors(*list->row->list, list->value);
    ASSERT_EQ(names.size(), 2u);
    const std::string density = "lawn.GrassField.species[" + names.back() + "].density";
    EXPECT_TRUE(unpainted(f.map(density)));
    // Painting takes it.
    BrushSettings add = f.brush(density, 1);
    add.mode = "add", add.radius = 5;
    ASSERT_TRUE(f.doc.beginStroke(add, 20, 20));
    f.doc.endStroke();
    while (f.doc.pumpStroke(0)) {
    }
    EXPECT_FALSE(unpainted(f.map(density)));
    EXPECT_GT(f.map(density).mean(), 0);
    ASSERT_TRUE(f.doc.undo());
    EXPECT_TRUE(unpainted(f.map(density)));
    ASSERT_TRUE(f.doc.undo());
    EXPECT_FALSE(findField(f.doc.project(), f.doc.tables().components, density));
    EXPECT_FALSE(f.doc.canUndo());
}

TEST(Unpainted, NewFlowersAndANewFieldGrowNowhere) {
    Fixture f;
    ASSERT_TRUE(f.doc.addEntity("patch"));
    ASSERT_TRUE(addComponentUnpainted(f.doc, "patch", "Flowers"));
    EXPECT_TRUE(unpainted(f.map("patch.Flowers.density")));
    ASSERT_TRUE(f.doc.addEntity("field"));
    ASSERT_TRUE(addComponentUnpainted(f.doc, "field", "GrassField"));
    const auto list = findField(f.doc.project(), f.doc.tables().components, "field.GrassField.species");
    for (const std::string& name : elementSelectors(*list->row->list, list->value))
        EXPECT_TRUE(unpainted(f.map("field.GrassField.species[" + name + "].density"))) << name;
    const size_t steps = f.doc.stepsDone();
    EXPECT_FALSE(addComponentUnpainted(f.doc, "field", "GrassField")) << "it has one";
    EXPECT_EQ(f.doc.stepsDone(), steps);
}

}  // namespace
}  // namespace sward
