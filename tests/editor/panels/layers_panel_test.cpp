// The panel Layers, clicked: what it changes is what the project has, one undo step each.
#include <algorithm>

#include "app/viewport.h"
#include "model/layer_edits.h"
#include "panel_stage.h"
#include "panels/panels.h"
#include "tools/brush_target.h"
#include "tools/layer_view.h"
#include "world/map_stacks.h"

namespace sward {
namespace {

constexpr const char* kDensity = "lawn.GrassField.species[lawn].density";
const std::string kRule = "lawn.MapLayers.layers[rule]";

class LayersPanel : public test::PanelStage {
  protected:
    void SetUp() override {
        PanelStage::SetUp();
        name = "Layers";
        brushes.map = kDensity;
        draw = [this] {
            stacks.shown(doc.project(), tables().components);
            drawLayers(fieldParts(), brushes, view, stacks.notes());
        };
        frames(2);
    }
    std::vector<std::string> names() {
        std::vector<std::string> out;
        for (const LayerOf& l : layersOver(doc.project(), kDensity)) out.push_back(l.layer->name);
        return out;
    }
    MapStacks stacks;
    BrushBook brushes;
    LayerView view;
};
using Names = std::vector<std::string>;

TEST_F(LayersPanel, AddsOrdersMutesAndDeletes) {
    click("Layers/Add rule");
    click("Layers/Add painted");
    EXPECT_EQ(names(), (Names{"rule", "painted"}));
    click("Layers/" + kRule + "/Up");
    EXPECT_EQ(names(), (Names{"painted", "rule"}));
    click("Layers/" + kRule + "/On");
    EXPECT_EQ(field(kRule + ".muted"), "true");
    click("Layers/" + kRule + "/Delete");
    EXPECT_EQ(names(), Names{"painted"});
    EXPECT_EQ(doc.stepsDone(), 5u);
    EXPECT_TRUE(doc.undo());
    EXPECT_EQ(field(kRule + ".muted"), "true");
}

TEST_F(LayersPanel, ChangesMasksAndSaysWhatIsWrong) {
    click("Layers/Add rule");
    type("Layers/" + kRule + ".name", "not steep");
    const std::string layer = "lawn.MapLayers.layers[not steep]";
    EXPECT_EQ(field(layer + ".operation"), "multiply");
    click("Layers/" + layer + "/Add mask");
    EXPECT_EQ(doc.project().registry.get<MapLayers>(findEntity(doc.project(), "lawn"))->layers[0].masks.size(), 2u);
    ASSERT_TRUE(doc.setField(layer + ".masks[0].by", "water"));
    frames(2);
    EXPECT_EQ(value("Layers/" + layer + "/Note"),
              "Skipped: mask \"mask\": the scene has no water (add an entity with Water)");
    ASSERT_TRUE(doc.setField(layer + ".masks[0].by", "height"));
    ASSERT_TRUE(doc.setField(layer + ".masks[0].from", "30"));
    frames(2);
    EXPECT_NE(value("Layers/" + layer + "/Note").find("hides all of the map"), std::string::npos);
    click("Layers/" + layer + ".masks[mask]/x");
    EXPECT_FALSE(shown("Layers/" + layer + "/Note"));
}

TEST_F(LayersPanel, PutsTheBrushOnALayerAndBack) {
    click("Layers/Add painted");
    const std::string painted = "lawn.MapLayers.layers[painted]";
    click("Layers/" + painted + "/Paint");
    EXPECT_EQ(brushes.map, painted + ".amounts");
    EXPECT_EQ(names(), Names{"painted"});
    click("Layers/Paint the map itself");
    EXPECT_EQ(brushes.map, kDensity);
}

TEST_F(LayersPanel, PreviewsALayerOverTheScene) {
    click("Layers/Add rule");
    click("Layers/" + kRule + "/Preview");
    EXPECT_EQ(overlayOf(doc, brushes).map, kRule + ".amounts");
    click("Layers/" + kRule + "/On");
    EXPECT_NE(overlayOf(doc, brushes).map, kRule + ".amounts") << "muted, it counts nowhere";
    click("Layers/" + kRule + "/On");
    click("Layers/" + kRule + "/Preview");
    EXPECT_NE(overlayOf(doc, brushes).map, kRule + ".amounts");
}

TEST_F(LayersPanel, SaysInWordsOverWhichMapsNoLayersLie) {
    selectMap(doc, brushes, "lawn.GrassField.orientation");
    frames(2);
    EXPECT_EQ(value("Layers/Note"),
              "Lawn \u203a orientation holds directions or pushes: layers lie over amounts, colours and heights.");
    EXPECT_FALSE(shown("Layers/Add rule"));
    selectMap(doc, brushes, kDensity);
    frames(2);
    EXPECT_FALSE(shown("Layers/Note"));
    EXPECT_TRUE(shown("Layers/Add rule"));
}

TEST_F(LayersPanel, TheInspectorShowsMasksWithinLayersToo) {
    click("Layers/Add rule");
    ViewState looking;
    name = "Inspector";
    draw = [&] { drawInspector(fieldParts(), "lawn", looking); };
    frames(2);
    const std::string mask = kRule + ".masks[mask]";
    EXPECT_EQ(value("Inspector/" + mask + ".to"), "35");
    EXPECT_TRUE(shown("Inspector/" + kRule + ".masks/Add mask"));
    ASSERT_TRUE(shown("Inspector/" + mask + "/Remove"));
    ASSERT_TRUE(doc.removeListElement(mask));
    frames(2);
    EXPECT_FALSE(shown("Inspector/" + mask + ".to"));
}

TEST_F(LayersPanel, RulesHaveNoMapToPaintOn) {
    click("Layers/Add rule");
    click("Layers/Add image");
    for (const ConstFieldRef& map : paintableMaps(doc)) EXPECT_NE(map.path, kRule + ".amounts");
    selectMap(doc, brushes, "lawn.MapLayers.layers[image].amounts");
    EXPECT_EQ(brushes.map, "lawn.MapLayers.layers[image].amounts");
}

TEST_F(LayersPanel, ARowBreaksWhereThePanelEnds) {
    click("Layers/Add rule");
    click("Layers/Add image");
    const auto inner = draw;
    float width = 780;
    draw = [&] {
        ImGui::BeginChild("narrow", {width, 500});
        inner();
        ImGui::EndChild();
    };
    for (const float wide : {780.f, 560.f, 380.f}) {
        width = wide;
        frames(3);
        for (const auto& [path, w] : book.widgets) EXPECT_LE(w.x1, wide + 9) << path << " of " << wide;
    }
}

TEST_F(LayersPanel, OverHeightsItSaysThatBrushesSculptBelow) {
    const std::string heights = "ground.Terrain.height";
    brushes.map = heights, brushes.tool = "raise";
    frames(2);
    EXPECT_FALSE(shown("Layers/Below")) << "there is no layer yet";
    click("Layers/Add painted");
    EXPECT_TRUE(shown("Layers/Below"));
    click("Layers/ground.MapLayers.layers[painted]/Paint");
    EXPECT_FALSE(shown("Layers/Below")) << "the brush is on the layer";
    click("Layers/Paint the map itself");
    EXPECT_TRUE(shown("Layers/Below"));
}

TEST_F(LayersPanel, OverColoursALayerHasTheColourThatItLays) {
    click("Layers/Add rule");
    EXPECT_FALSE(shown("Layers/" + kRule + ".color")) << "a density has none";
    selectMap(doc, brushes, "ground.Terrain.terrainMap");
    frames(2);
    click("Layers/Add rule");
    const std::string sand = "ground.MapLayers.layers[rule]";
    ASSERT_TRUE(shown("Layers/" + sand + ".color"));
    EXPECT_EQ(field(sand + ".operation"), "replace");
    EXPECT_FALSE(shown("Layers/" + sand + ".low")) << "metres are for heights";
    EXPECT_NE(value("Layers/" + sand + "/Note").find("changes nothing"), std::string::npos) << "nothing is steep yet";
    ASSERT_TRUE(doc.setField(sand + ".operation", "multiply"));
    frames(2);
    EXPECT_FALSE(shown("Layers/" + sand + ".color")) << "it takes away";
}

TEST_F(LayersPanel, OfManyLayersOnlyThoseInSightAreBuilt) {
    for (int i = 0; i < 30; ++i) ASSERT_TRUE(addLayer(doc, kDensity, LayerKind::Rule));
    frames(4);
    const auto built = std::count_if(book.widgets.begin(), book.widgets.end(), [](const auto& w) {
        return w.first.starts_with("Layers/") && w.first.ends_with("/On");
    });
    EXPECT_GT(built, 3);
    EXPECT_LT(built, 20);
    EXPECT_TRUE(shown("Layers/Paint the map itself")) << "what follows them is there";
}

}  // namespace
}  // namespace sward
