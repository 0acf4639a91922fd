#include "ui/tiles.h"

#include <imgui.h>

#include <algorithm>

#include "ui/imgui_compat.h"
#include "ui/theme.h"

namespace sward::ui {
namespace {

constexpr ImU32 kField = IM_COL32(44, 46, 44, 255);
constexpr float kRounding = 3;

// The picture in its own shape, in the middle of the field.
void drawPicture(const Shown& p, const ImVec2& at, const TileSize& size) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(at, {at.x + size.width, at.y + size.height}, kField, kRounding);
    if (p.texture == 0) return;
    const float by = std::min(size.width / static_cast<float>(p.width), size.height / static_cast<float>(p.height));
    const ImVec2 shown{static_cast<float>(p.width) * by, static_cast<float>(p.height) * by};
    const ImVec2 low{at.x + (size.width - shown.x) / 2, at.y + (size.height - shown.y) / 2};
    draw.AddImageRounded(textureId(p.texture), low, {low.x + shown.x, low.y + shown.y}, {0, 0}, {1, 1}, IM_COL32_WHITE,
                         kRounding);
}

// As much of a name as fits, with dots where something is left out.
std::string fitting(const std::string& text, float width) {
    if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
    std::string out = text;
    do {
        out.pop_back();
        while (!out.empty() && (static_cast<unsigned char>(out.back()) & 0xC0) == 0x80) out.pop_back();
        if (!out.empty() && static_cast<unsigned char>(out.back()) >= 0xC0) out.pop_back();
    } while (!out.empty() && ImGui::CalcTextSize((out + "...").c_str()).x > width);
    return out + "...";
}

}  // namespace

bool tile(const std::string& label, const std::string& title, const Shown& shown, const TileSize& size, bool chosen,
          bool* twice) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float line = ImGui::GetTextLineHeight() + 4;
    const bool pressed = ImGui::InvisibleButton(("##tile" + label).c_str(), {size.width, size.height + line});
    const bool hot = ImGui::IsItemHovered();
    if (twice) *twice = hot && ImGui::IsMouseDoubleClicked(0);
    record(label, Kind::Button, chosen ? "true" : "false");
    drawPicture(shown, at, size);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    if (chosen || hot)
        draw.AddRect(at, {at.x + size.width, at.y + size.height}, chosen ? kAccent : kDimText, kRounding, 0,
                     chosen ? 2.5f : 1.f);
    const std::string name = fitting(title, size.width);
    const float x = at.x + (size.width - ImGui::CalcTextSize(name.c_str()).x) / 2;
    draw.AddText({x, at.y + size.height + 2}, ImGui::GetColorU32(ImGuiCol_Text), name.c_str());
    return pressed;
}

void nextTile(const TileSize& size, bool first) {
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (!first && ImGui::GetItemRectMax().x + 6 + size.width <= right) ImGui::SameLine(0, 6);
}

void picture(const std::string& label, const Shown& shown, const TileSize& size) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::Dummy({size.width, size.height});
    record(label, Kind::Area, shown.texture ? "true" : "false");
    drawPicture(shown, at, size);
}

}  // namespace sward::ui
