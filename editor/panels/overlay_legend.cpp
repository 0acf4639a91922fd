#include "panels/overlay_legend.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "tools/brush_target.h"
#include "ui/theme.h"
#include "ui/words.h"

namespace sward {
namespace {

constexpr float kPad = 8;
// As in shaders/post/map_overlay.frag.glsl.
constexpr ImU32 kNone = IM_COL32(61, 13, 107, 255), kHalf = IM_COL32(222, 77, 92, 255),
                kFull = IM_COL32(255, 235, 64, 255), kPressed = IM_COL32(153, 153, 153, 255);

ImVec2 box(const Rect& r, float width, float height) {
    const ImVec2 low{r.x + r.w - width - 10, r.y + 10};
    ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + width, low.y + height}, IM_COL32(18, 20, 18, 205), 4);
    return {low.x + kPad, low.y + kPad};
}

void text(ImVec2 at, const std::string& words, ImU32 color = IM_COL32_WHITE) {
    ImGui::GetWindowDrawList()->AddText(at, color, words.c_str());
}

void amounts(const Rect& r, const std::string& title, const MapRow& row) {
    const float line = ImGui::GetTextLineHeight(), bar = 150;
    const float width = std::max(bar, ImGui::CalcTextSize(title.c_str()).x) + 2 * kPad;
    ImVec2 at = box(r, width, 2 * kPad + 2 * line + 16);
    text(at, title);
    at.y += line + 4;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float half = at.x + bar / 2;
    list.AddRectFilledMultiColor(at, {half, at.y + 10}, kNone, kHalf, kHalf, kNone);
    list.AddRectFilledMultiColor({half, at.y}, {at.x + bar, at.y + 10}, kHalf, kFull, kFull, kHalf);
    text({at.x, at.y + 12}, row.least, ui::kDimText.dark);
    text({at.x + bar - ImGui::CalcTextSize(row.most).x, at.y + 12}, row.most, ui::kDimText.dark);
}

ImU32 hueOf(float turn) {
    const auto part = [&](float shift) {
        const float f = turn + shift - std::floor(turn + shift);
        return std::clamp(std::abs(f * 6 - 3) - 1, 0.f, 1.f);
    };
    return ImGui::GetColorU32({part(0), part(2.f / 3), part(1.f / 3), 1});
}

// The wheel turns with the view: up on it is away from the viewer. Returns where what is beside it begins.
ImVec2 wheel(const Rect& r, const std::string& title, double yaw, float rest, float lines) {
    constexpr float kWheel = 30;
    constexpr int kParts = 36;
    const float line = ImGui::GetTextLineHeight();
    const float beside = 2 * kWheel + 18 + rest;
    const float width = std::max(beside, ImGui::CalcTextSize(title.c_str()).x) + 2 * kPad;
    const ImVec2 at = box(r, width, 2 * kPad + line + 2 * kWheel + 14);
    text(at, title);
    const ImVec2 c{at.x + kWheel + 6, at.y + line + kWheel + 8};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto place = [&](float turn, float radius) {
        const float a = turn * 6.2831853f - static_cast<float>(yaw);
        return ImVec2{c.x + std::sin(a) * radius, c.y - std::cos(a) * radius};
    };
    for (int i = 0; i < kParts; ++i) {
        const float from = static_cast<float>(i) / kParts, to = static_cast<float>(i + 1) / kParts;
        list.AddTriangleFilled(c, place(from, kWheel), place(to, kWheel), hueOf((from + to) / 2));
    }
    list.AddCircleFilled(c, kWheel * 0.3f, IM_COL32_WHITE);
    const ImVec2 north = place(0, kWheel * 0.75f), half = ImGui::CalcTextSize("N");
    text({north.x - half.x / 2, north.y - half.y / 2}, "N", IM_COL32_BLACK);
    return {c.x + kWheel + 12, c.y - lines * (line + 4) / 2};
}

void directions(const Rect& r, const std::string& title, double yaw) {
    constexpr const char* kHelp = "hue: where it leans";
    const ImVec2 at = wheel(r, title, yaw, ImGui::CalcTextSize(kHelp).x, 2);
    text(at, kHelp, ui::kDimText.dark);
    text({at.x, at.y + ImGui::GetTextLineHeight() + 4}, "white: upright", ui::kDimText.dark);
}

void forces(const Rect& r, const std::string& title, double yaw) {
    constexpr const char* kHelp = "hue: where it is pushed";
    const float rest = ImGui::CalcTextSize(kHelp).x, line = ImGui::GetTextLineHeight() + 4;
    const ImVec2 at = wheel(r, title, yaw, rest, 3);
    text(at, kHelp, ui::kDimText.dark);
    const ImVec2 low{at.x, at.y + line + 2}, high{at.x + rest, at.y + line + 12};
    ImGui::GetWindowDrawList()->AddRectFilledMultiColor(low, high, IM_COL32_WHITE, kPressed, kPressed, IM_COL32_WHITE);
    text({at.x, at.y + 2 * line}, "0 stands", ui::kDimText.dark);
    constexpr const char* kFlat = "1 flat";
    text({at.x + rest - ImGui::CalcTextSize(kFlat).x, at.y + 2 * line}, kFlat, ui::kDimText.dark);
}

// Each place has its own colour: the bar says with the brush's how opacity shows.
void colours(const Rect& r, const std::string& title, const MapRow& row, const glm::vec3& color) {
    constexpr const char* kHelp = "the map's colours, by opacity";
    const float line = ImGui::GetTextLineHeight(),
                wide = std::max(ImGui::CalcTextSize(title.c_str()).x, ImGui::CalcTextSize(kHelp).x);
    ImVec2 at = box(r, wide + 2 * kPad, 2 * kPad + 3 * line + 20);
    text(at, title);
    text({at.x, at.y + line + 2}, kHelp, ui::kDimText.dark);
    at.y += 2 * line + 6;
    const ImU32 full = ImGui::GetColorU32({color.x, color.y, color.z, 1}), clear = full & ~IM_COL32_A_MASK;
    ImGui::GetWindowDrawList()->AddRectFilledMultiColor(at, {at.x + wide, at.y + 10}, clear, full, full, clear);
    text({at.x, at.y + 12}, row.least, ui::kDimText.dark);
    text({at.x + wide - ImGui::CalcTextSize(row.most).x, at.y + 12}, row.most, ui::kDimText.dark);
}

}  // namespace

void drawOverlayLegend(const Document& document, BrushBook& brushes, double yaw, const Rect& view) {
    const std::string shown = overlayOf(document, brushes).map;
    if (shown.empty()) return;
    const Result<ConstFieldRef> map = findField(document.project(), document.tables().components, shown);
    if (!map) return;
    const std::string title = ui::inWords(map->path);
    const MapKind kind = map->row->map->kind;
    if (kind == MapKind::Amounts || kind == MapKind::Heights) amounts(view, title, *map->row->map);
    if (kind == MapKind::Forces) forces(view, title, yaw);
    if (kind == MapKind::Colours) colours(view, title, *map->row->map, currentColor(brushes));
    if (kind == MapKind::Directions) directions(view, title, yaw);
}

}  // namespace sward
