#include "panels/bar_rows.h"

#include "editor/panels/panel_stage.h"

namespace sward {
namespace {

class BarRows : public test::PanelStage {
  protected:
    BarRows() {
        draw = [this] {
            bar::Rows rows{right};
            ImGui::Button("first");
            for (const char* label : {"Radius", "Strength", "Falloff", "Spacing"})
                bar::number(rows, label, values[label], bar::em(7), bar::range(0, 1, 0, 2, "m"), "help");
            count = rows.count;
        };
    }
    std::map<std::string, float> values;
    float right = 790;
    int count = 0;
};

TEST_F(BarRows, WhatDoesNotFitBeginsAnotherRowAndNothingIsCut) {
    for (const float end : {790.f, 500.f, 300.f, 180.f}) {
        right = end;
        frames(2);
        float low = 1e9f, high = 0;
        for (const auto& [path, w] : book.widgets) {
            EXPECT_LE(w.x1, end) << path << " of a bar that ends at " << end;
            low = std::min(low, w.y0), high = std::max(high, w.y0);
        }
        EXPECT_EQ(count == 1, high - low < 1) << end;
    }
    EXPECT_EQ(count, 5) << "one a row, below the first";
}

TEST_F(BarRows, ANumberBeyondItsRangeIsRefusedAndSaid) {
    frames(2);
    queue.push({InputKind::Key, 0, 0, GLFW_KEY_LEFT_CONTROL, true});
    click("Panel/Radius");
    queue.push({InputKind::Key, 0, 0, GLFW_KEY_LEFT_CONTROL, false});
    frames(2);
    queue.push({InputKind::Char, 0, 0, '9', false});
    frames(2);
    queue.push({InputKind::Key, 0, 0, GLFW_KEY_ENTER, true});
    queue.push({InputKind::Key, 0, 0, GLFW_KEY_ENTER, false});
    frames(4);
    EXPECT_EQ(values["Radius"], 0);
    EXPECT_TRUE(book.errors.contains("Panel/Radius"));
}

}  // namespace
}  // namespace sward
