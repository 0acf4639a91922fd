// The tool strip: a tool brings a map that it paints.
#include "editor/panels/panel_stage.h"
#include "panels/panels.h"
#include "tools/brush_target.h"
#include "tools/gizmo.h"

namespace sward {
namespace {

class ToolStrip : public test::PanelStage {
  protected:
    ToolStrip() {
        draw = [this] {
            ImGui::BeginChild("strip", {36, 0});  // buttons are as wide as the strip
            drawToolStrip(doc, brushes, mode, messages);
            ImGui::EndChild();
        };
    }
    BrushBook brushes;
    GizmoMode mode = GizmoMode::Move;
};

TEST_F(ToolStrip, HasAButtonForObjectsAndOneForEachBrush) {
    keepTargetValid(doc, brushes);
    frames(2);
    EXPECT_TRUE(shown("Panel/Select"));
    for (const BrushRow& row : brushRows())
        EXPECT_EQ(value(std::string("Panel/") + row.label), row.name == brushes.tool ? "true" : "false") << row.label;
}

TEST_F(ToolStrip, AToolBringsAMapThatItPaints) {
    keepTargetValid(doc, brushes);
    EXPECT_TRUE(brushes.map.ends_with(".density"));
    click("Panel/Comb");
    EXPECT_EQ(brushes.tool, "comb");
    EXPECT_EQ(brushes.map, "lawn.GrassField.orientation");
    click("Panel/Select");
    EXPECT_EQ(brushes.tool, kViewTool);
    EXPECT_EQ(brushes.map, "lawn.GrassField.orientation");
}

TEST_F(ToolStrip, WithoutAMapAToolSaysSoAndStays) {
    ASSERT_TRUE(doc.removeEntity("lawn"));
    ASSERT_TRUE(doc.removeEntity("ground"));
    brushes.tool = kViewTool;
    click("Panel/Comb");
    EXPECT_EQ(brushes.tool, kViewTool);
    EXPECT_NE(messages.status.find("the project has no map that it paints"), std::string::npos) << messages.status;
}

}  // namespace
}  // namespace sward
