#include "ui/theme.h"

#include <cmath>
#include <filesystem>

namespace sward::ui {
namespace {

constexpr const char* kFonts[] = {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                  "/usr/share/fonts/TTF/DejaVuSans.ttf"};

void loadFont(float density) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    static const ImWchar ranges[] = {0x20, 0x17F, 0x370, 0x3FF, 0x400, 0x45F, 0x2010, 0x203A, 0x25CF, 0x25CF, 0};
    for (const char* file : kFonts) {
        std::error_code error;
        if (std::filesystem::exists(file, error) &&
            atlas.AddFontFromFileTTF(file, std::round(14 * density), nullptr, ranges))
            return;
    }
    ImFontConfig config;
    config.SizePixels = std::round(13 * density);
    atlas.AddFontDefault(&config);
}

ImVec4 grey(float v, float alpha = 1) { return {v, v * 1.01f, v, alpha}; }
ImVec4 green(float v, float alpha = 1) { return {0.64f * v, v, 0.45f * v, alpha}; }

void setColors(ImVec4* c) {
    c[ImGuiCol_Text] = grey(0.88f);
    c[ImGuiCol_TextDisabled] = grey(0.50f);
    c[ImGuiCol_WindowBg] = grey(0.145f);
    c[ImGuiCol_ChildBg] = grey(0, 0);
    c[ImGuiCol_PopupBg] = grey(0.115f, 0.99f);
    c[ImGuiCol_Border] = grey(0.30f, 0.8f);
    c[ImGuiCol_FrameBg] = grey(0.22f);
    c[ImGuiCol_FrameBgHovered] = grey(0.27f);
    c[ImGuiCol_FrameBgActive] = grey(0.30f);
    c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = grey(0.10f);
    c[ImGuiCol_MenuBarBg] = grey(0.115f);
    c[ImGuiCol_ScrollbarBg] = grey(0.13f);
    c[ImGuiCol_ScrollbarGrab] = grey(0.33f);
    c[ImGuiCol_ScrollbarGrabHovered] = grey(0.42f);
    c[ImGuiCol_ScrollbarGrabActive] = grey(0.5f);
    c[ImGuiCol_CheckMark] = green(0.80f);
    c[ImGuiCol_SliderGrab] = green(0.58f);
    c[ImGuiCol_SliderGrabActive] = green(0.72f);
    c[ImGuiCol_Button] = grey(0.25f);
    c[ImGuiCol_ButtonHovered] = grey(0.32f);
    c[ImGuiCol_ButtonActive] = grey(0.38f);
    c[ImGuiCol_Header] = grey(0.235f);
    c[ImGuiCol_HeaderHovered] = grey(0.29f);
    c[ImGuiCol_HeaderActive] = grey(0.34f);
    c[ImGuiCol_Separator] = grey(0.26f);
    c[ImGuiCol_SeparatorHovered] = c[ImGuiCol_SeparatorActive] = green(0.6f);
    c[ImGuiCol_Tab] = grey(0.15f);
    c[ImGuiCol_TabHovered] = grey(0.30f);
    c[ImGuiCol_TabActive] = grey(0.26f);
    c[ImGuiCol_TableHeaderBg] = grey(0.18f);
    c[ImGuiCol_TableRowBgAlt] = grey(1, 0.025f);
    c[ImGuiCol_TextSelectedBg] = green(0.55f, 0.7f);
    c[ImGuiCol_ModalWindowDimBg] = grey(0, 0.5f);
    c[ImGuiCol_NavHighlight] = green(0.6f);
}

}  // namespace

void applyTheme(float density) {
    loadFont(density);
    ImGui::GetIO().FontGlobalScale = 1 / density;
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle{};
    setColors(style.Colors);
    style.WindowPadding = {8, 6};
    style.FramePadding = {7, 3};
    style.ItemSpacing = {7, 4};
    style.ItemInnerSpacing = {5, 4};
    style.CellPadding = {4, 2};
    style.FrameRounding = 3;
    style.GrabRounding = 2;
    style.PopupRounding = 3;
    style.ScrollbarSize = 12;
    style.ScrollbarRounding = 3;
    style.GrabMinSize = 9;
    style.WindowBorderSize = 0;
    style.WindowMinSize = {16, 16};
}

void pushAccent() {
    ImGui::PushStyleColor(ImGuiCol_Button, green(0.46f));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, green(0.54f));
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, green(0.60f));
}

void popAccent() { ImGui::PopStyleColor(3); }

void coloredText(ImU32 color, const char* text) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
}

}  // namespace sward::ui
