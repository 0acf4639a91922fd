// The brush bar's widgets for shapes, imprint, several species and mirrors: what they choose is what a stroke paints.
#include "panels/brush_shape.h"

#include "app/image_tasks.h"
#include "editor/panels/panel_stage.h"
#include "maps/map_io.h"
#include "panels/panels.h"
#include "tools/brush_cost.h"
#include "tools/brush_target.h"
#include "tools/object_tool.h"

namespace sward {
namespace {

constexpr const char* kLawn = "lawn.GrassField.species[lawn].density";
constexpr const char* kOther = "lawn.GrassField.species[grass].density";

class BrushShapeBar : public test::PanelStage {
  protected:
    void SetUp() override {
        PanelStage::SetUp();
        name = "Brush";
        draw = [this] { drawBrushBar({0, 0, 800, 60}, 0, doc, brushes, objects, edits, messages, images, waiting); };
        selectMap(doc, brushes, kLawn);
        frames(2);
    }
    void choose(const std::string& combo, const std::string& item) {
        click("Brush/" + combo);
        click("Brush/" + combo + "/" + item);
    }
    Status take(const std::filesystem::path& file) {
        Status ended;
        takeShape(waiting, brushes, file.string(), [&](const Status& s) { ended = s; });
        return ended;
    }
    BrushBook brushes;
    ObjectTool objects;
    ImageDialog images;
};

TEST_F(BrushShapeBar, AShapeTakesTheFalloffsPlaceAndStaysWithItsTool) {
    EXPECT_TRUE(shown("Brush/Falloff"));
    EXPECT_FALSE(shown("Brush/Turn"));
    choose("Shape", "splatter");
    EXPECT_EQ(value("Brush/Shape"), "splatter");
    EXPECT_FALSE(shown("Brush/Falloff"));
    choose("Turn", "along");
    EXPECT_EQ(currentBrush(brushes).shapeTurn, ShapeTurn::Along);
    selectTool(doc, brushes, messages, "subtract");
    frames(2);
    EXPECT_EQ(value("Brush/Shape"), "round");
    selectTool(doc, brushes, messages, "add");
    frames(2);
    EXPECT_EQ(value("Brush/Shape"), "splatter");
    choose("Shape", "round");
    EXPECT_EQ(currentBrush(brushes).shape, nullptr);
}

TEST_F(BrushShapeBar, AFileBecomesAShapeAndIsOfferedToOtherTools) {
    choose("Shape", "From file...");
    EXPECT_EQ(images.task, ImageTask::Shape);
    Map map({8, 8, 1, PixelType::U8});
    map.set(3, 3, 0, 1);
    ASSERT_TRUE(writeMap(dir / "leaf.png", map));
    ASSERT_TRUE(take(dir / "leaf.png"));
    frames(2);
    EXPECT_EQ(value("Brush/Shape"), "leaf.png");
    selectTool(doc, brushes, messages, "subtract");
    choose("Shape", "leaf.png");
    ASSERT_TRUE(currentBrush(brushes).shape);
    EXPECT_EQ(currentBrush(brushes).shape->name, (dir / "leaf.png").string());
    EXPECT_FALSE(take(dir / "none.png"));
    std::filesystem::remove(dir / "leaf.png");
    selectTool(doc, brushes, messages, "smooth");
    choose("Shape", "leaf.png");
    EXPECT_NE(messages.notice.find("leaf.png"), std::string::npos) << "it is gone, and that is said";
}

TEST_F(BrushShapeBar, ImprintHasAHeightABlendAndABase) {
    selectTool(doc, brushes, messages, "imprint");
    frames(2);
    EXPECT_EQ(value("Brush/Shape"), "mountain");
    EXPECT_FALSE(shown("Brush/Base"));
    choose("Blend", "maximum");
    EXPECT_EQ(currentBrush(brushes).blend, HeightBlend::Maximum);
    EXPECT_TRUE(shown("Brush/Base"));
    EXPECT_TRUE(shown("Brush/Falloff"));
    const BrushSettings dug = strokeBrush(brushes, true, false);
    EXPECT_EQ(dug.blend, HeightBlend::Minimum);
    EXPECT_EQ(dug.value, -currentBrush(brushes).value);
}

TEST_F(BrushShapeBar, TickedSpeciesArePaintedInOneStrokeAndCounted) {
    EXPECT_FALSE(shown("Brush/Species")) << "the field has one species";
    ASSERT_TRUE(doc.addListElement("lawn.GrassField.species"));
    ASSERT_TRUE(doc.createMap(kOther));
    frames(2);
    EXPECT_EQ(strokeBrushes(doc, brushes, false, false).size(), 1u);
    click("Brush/Species");
    click("Brush/Species/grass");
    EXPECT_EQ(paintedMaps(doc, brushes), (std::vector<std::string>{kLawn, kOther}));
    selectTool(doc, brushes, messages, "subtract");
    currentBrush(brushes).radius = 3;
    const std::vector<BrushSettings> both = strokeBrushes(doc, brushes, false, false);
    ASSERT_EQ(both.size(), 2u);
    const size_t steps = doc.stepsDone();
    BrushCost cost;
    const glm::dvec3 middle(20, 0, 20);
    followBrushCost(cost, doc, brushes, middle, nullptr);
    ASSERT_TRUE(cost.under);
    double perM2 = 0;
    for (const Species& s : doc.project().registry.get<GrassField>(findEntity(doc.project(), "lawn"))->species)
        perM2 += static_cast<double>(s.bladesPerM2);
    EXPECT_NEAR(*cost.under, perM2 * 3.14159265 * 9, 0.03 * *cost.under) << "blades of both";
    ASSERT_TRUE(doc.beginStrokes(both, 20, 20, true));
    doc.endStroke();
    doc.pumpStroke(0);
    followBrushCost(cost, doc, brushes, middle, nullptr);
    ASSERT_TRUE(cost.stroke);
    for (const char* path : {kLawn, kOther})
        EXPECT_LT(static_cast<const MapField*>(findField(doc.project(), tables().components, path)->value)
                      ->map.sample(0.5, 0.5),
                  0.6f)
            << path;
    EXPECT_GT(cost.stroke->removed, 0.3 * perM2 * 3.14159265 * 2);
    EXPECT_EQ(doc.stepsDone(), steps + 1);
    ASSERT_TRUE(doc.undo());
    selectMap(doc, brushes, "ground.Terrain.height");
    EXPECT_EQ(strokeBrushes(doc, brushes, false, false).size(), 1u) << "ticks are of densities";
}

TEST_F(BrushShapeBar, TheMirrorHoldsForEveryTool) {
    choose("Mirror", "x and z");
    selectTool(doc, brushes, messages, "subtract");
    const BrushSettings b = strokeBrush(brushes, false, false);
    EXPECT_TRUE(b.mirrorX && b.mirrorZ);
    choose("Mirror", "z");
    EXPECT_FALSE(strokeBrush(brushes, false, false).mirrorX);
    EXPECT_TRUE(strokeBrush(brushes, false, false).mirrorZ);
}

}  // namespace
}  // namespace sward
