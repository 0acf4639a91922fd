// The objects in the project's folder: one that is chosen is placed by clicks in the viewport.
#include <imgui.h>

#include "model/assets.h"
#include "panels/panels.h"
#include "tools/brush_target.h"
#include "tools/object_tool.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

// Beside the last button, or on a new line if this one does not fit.
void next(const std::string& label) {
    const float needed = ImGui::CalcTextSize(label.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x + 6;
    if (ImGui::GetItemRectMax().x + needed < ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x)
        ImGui::SameLine(0, 6);
}

}  // namespace

void drawAssets(const Document& doc, BrushBook& brushes, ObjectTool& objects, Messages& messages) {
    if (!doc.isOpen()) return ImGui::TextDisabled("No project is open.");
    ui::checkbox("Random turn", objects.randomTurn);
    ui::tooltip("Each object that is placed is turned about the vertical by an angle of its own.");
    ImGui::SameLine(0, 18);
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText,
                    objects.placing.empty()
                        ? "Choose one, then click on the ground. A .glb or .gltf dropped onto the window comes in here."
                        : "Each click on the ground places one. Escape ends.");
    const std::vector<std::string> files = projectAssets(doc.project().dir);
    if (files.empty()) ImGui::TextDisabled("There is none in models/ yet.");
    ImGui::BeginChild("assets");
    bool first = true;
    for (const std::string& file : files) {
        const std::string label = file.substr(std::string(kAssetFolder).size() + 1);
        if (!std::exchange(first, false)) next(label);
        const bool chosen = objects.placing == file;
        if (ui::button(label, 0, chosen)) {
            objects.placing = chosen ? "" : file;
            if (!chosen) selectTool(doc, brushes, messages, kViewTool);
        }
        ui::tooltip(file);
    }
    ImGui::EndChild();
}

}  // namespace sward
