#include "panels/picture_strip.h"

#include <imgui.h>

#include <algorithm>

#include "gpu/resources.h"
#include "ui/imgui_compat.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {

void drawStrip(const std::vector<StripPicture>& all) {
    std::vector<StripPicture> there;
    for (const StripPicture& p : all)
        if (p.picture->id() != 0) there.push_back(p);
    if (there.empty()) return;
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float line = ImGui::GetTextLineHeightWithSpacing(), gap = ImGui::GetStyle().ItemSpacing.x;
    const auto count = static_cast<float>(there.size());
    for (const StripPicture& p : there) {
        const float w = static_cast<float>(p.picture->width), h = static_cast<float>(p.picture->height);
        const float scale =
            std::max(0.01f, std::min((room.x - gap * (count - 1)) / count / w, (room.y - line - 2) / h));
        ImGui::BeginGroup();
        ui::coloredText(ui::kDimText, p.name);
        ImGui::Image(ui::textureId(p.picture->id()), {w * scale, h * scale});
        ui::record(p.name, ui::Kind::Area);
        ImGui::EndGroup();
        ImGui::SameLine();
    }
    ImGui::NewLine();
}

}  // namespace sward
