// Plots of the engine in a window of the editor.
#include "ui/plot_view.h"

#include "editor/panels/panel_stage.h"

namespace sward::test {
namespace {

struct PlotView : PanelStage {
    // How many vertices the plot becomes.
    int verticesOf(const Plot& plot) {
        int drawn = 0;
        draw = [&] {
            const int before = ImGui::GetWindowDrawList()->VtxBuffer.Size;
            ui::drawPlot(plot, ImGui::GetCursorScreenPos());
            drawn = ImGui::GetWindowDrawList()->VtxBuffer.Size - before;
        };
        frames(2);
        return drawn;
    }
};

TEST_F(PlotView, LinesDotsAndTextsAreDrawnAndNothingElse) {
    Plot plot;
    EXPECT_EQ(verticesOf(plot), 0);
    plot.lines.push_back({{{10, 10}, {110, 10}}, "#ff0000"});
    const int line = verticesOf(plot);
    EXPECT_GT(line, 0);
    plot.lines[0].dash = 10;
    EXPECT_EQ(verticesOf(plot), 5 * line) << "five dashes and five gaps";
    plot.dots.push_back({{50, 50}, 3, "#00ff00", true, ""});
    const int dotted = verticesOf(plot);
    EXPECT_GT(dotted, 5 * line);
    plot.bars.push_back({{10, 10}, {20, 40}, "#0000ff"});
    EXPECT_EQ(verticesOf(plot), dotted + 4);
    plot.bars.clear();
    plot.texts.push_back({{50, 80}, "abc", "#ffffff"});
    EXPECT_EQ(verticesOf(plot), dotted + 3 * 4) << "a rectangle a letter";
}

TEST_F(PlotView, ColoursGoThereAndBackAndSeeThroughOnesMeetTheWindow) {
    EXPECT_EQ(ui::hexOf(IM_COL32(18, 52, 86, 255)), "#123456");
    EXPECT_EQ(ui::colorOf("#123456"), IM_COL32(18, 52, 86, 255));
    EXPECT_EQ(ui::colorOf("green"), IM_COL32(0, 0, 0, 255));
    const ImVec4 back = ImGui::GetStyle().Colors[ImGuiCol_WindowBg];
    EXPECT_EQ(ui::hexOf(IM_COL32(255, 255, 255, 0)), ui::hexOf(ImGui::ColorConvertFloat4ToU32(back)));
}

}  // namespace
}  // namespace sward::test
