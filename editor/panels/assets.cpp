// The objects in the project's folder, as pictures: one that is chosen is placed by clicks in the viewport.
#include <imgui.h>

#include "app/thumbnails.h"
#include "model/assets.h"
#include "panels/panels.h"
#include "tools/brush_target.h"
#include "tools/object_tool.h"
#include "ui/theme.h"
#include "ui/tiles.h"

namespace sward {

void drawAssets(const Document& doc, BrushBook& brushes, ObjectTool& objects, Thumbnails& thumbnails,
                Messages& messages) {
    if (!doc.isOpen()) return ImGui::TextDisabled("No project is open.");
    ui::checkbox("Random turn", objects.randomTurn);
    ui::tooltip("Each object that is placed is turned about the vertical by an angle of its own.");
    ImGui::SameLine(0, 18);
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText,
                    objects.placing.empty()
                        ? "Choose one, then click on the ground. A .glb or .gltf dropped onto the window comes in here."
                        : "Each click on the ground places one. Escape ends.");
    const std::filesystem::path& dir = doc.project().dir;
    const std::vector<std::string> files = projectAssets(dir);
    if (files.empty()) ImGui::TextDisabled("There is none in models/ yet.");
    ImGui::BeginChild("assets");
    const float side = ImGui::GetFontSize() * 5.5f;
    const ui::TileSize size{side, side};
    for (const std::string& file : files) {
        const std::string label = file.substr(std::string(kAssetFolder).size() + 1);
        ui::nextTile(size, &file == &files.front());
        const bool chosen = objects.placing == file;
        const Thumbnail& picture = fileThumbnail(thumbnails, dir, file);
        if (ui::tile(label, std::filesystem::path(label).stem().string(), shownOf(picture), size, chosen)) {
            objects.placing = chosen ? "" : file;
            if (!chosen) selectTool(doc, brushes, messages, kViewTool);
        }
        ui::tooltip(picture.error.empty() ? file : file + "\n" + picture.error);
    }
    ImGui::EndChild();
}

}  // namespace sward
