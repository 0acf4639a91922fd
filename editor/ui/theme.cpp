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

void setDark(ImVec4* c) {
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

void setLight(ImVec4* c) {
    const auto paleGreen = [](float v, float alpha = 1) { return ImVec4{0.80f * v, v, 0.70f * v, alpha}; };
    c[ImGuiCol_Text] = grey(0.10f);
    c[ImGuiCol_TextDisabled] = grey(0.44f);
    c[ImGuiCol_WindowBg] = grey(0.91f);
    c[ImGuiCol_ChildBg] = grey(1, 0);
    c[ImGuiCol_PopupBg] = grey(0.965f, 0.99f);
    c[ImGuiCol_Border] = grey(0.62f, 0.9f);
    c[ImGuiCol_FrameBg] = grey(0.985f);
    c[ImGuiCol_FrameBgHovered] = grey(0.955f);
    c[ImGuiCol_FrameBgActive] = grey(0.92f);
    c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = grey(0.84f);
    c[ImGuiCol_MenuBarBg] = grey(0.95f);
    c[ImGuiCol_ScrollbarBg] = grey(0.87f);
    c[ImGuiCol_ScrollbarGrab] = grey(0.68f);
    c[ImGuiCol_ScrollbarGrabHovered] = grey(0.60f);
    c[ImGuiCol_ScrollbarGrabActive] = grey(0.52f);
    c[ImGuiCol_CheckMark] = green(0.50f);
    c[ImGuiCol_SliderGrab] = green(0.62f);
    c[ImGuiCol_SliderGrabActive] = green(0.50f);
    c[ImGuiCol_Button] = grey(0.82f);
    c[ImGuiCol_ButtonHovered] = grey(0.76f);
    c[ImGuiCol_ButtonActive] = grey(0.70f);
    c[ImGuiCol_Header] = grey(0.84f);
    c[ImGuiCol_HeaderHovered] = grey(0.79f);
    c[ImGuiCol_HeaderActive] = grey(0.74f);
    c[ImGuiCol_Separator] = grey(0.76f);
    c[ImGuiCol_SeparatorHovered] = c[ImGuiCol_SeparatorActive] = green(0.6f);
    c[ImGuiCol_Tab] = grey(0.86f);
    c[ImGuiCol_TabHovered] = grey(0.78f);
    c[ImGuiCol_TabActive] = grey(0.80f);
    c[ImGuiCol_TableHeaderBg] = grey(0.86f);
    c[ImGuiCol_TableBorderStrong] = grey(0.72f);
    c[ImGuiCol_TableBorderLight] = grey(0.80f);
    c[ImGuiCol_TableRowBgAlt] = grey(0, 0.03f);
    c[ImGuiCol_TextSelectedBg] = paleGreen(0.85f, 0.9f);
    c[ImGuiCol_ModalWindowDimBg] = grey(0, 0.35f);
    c[ImGuiCol_NavHighlight] = green(0.6f);
}

void setColors(ImVec4* c, Theme theme) {
    if (theme == Theme::Light)
        setLight(c);
    else
        setDark(c);
}

}  // namespace

Theme theme() { return ImGui::GetStyle().Colors[ImGuiCol_WindowBg].x > 0.5f ? Theme::Light : Theme::Dark; }

void setTheme(Theme wanted) {
    if (theme() == wanted) return;
    if (wanted == Theme::Light)
        ImGui::StyleColorsLight();
    else
        ImGui::StyleColorsDark();
    setColors(ImGui::GetStyle().Colors, wanted);
}

void applyTheme(float density, Theme wanted) {
    loadFont(density);
    ImGui::GetIO().FontGlobalScale = 1 / density;
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle{};
    if (wanted == Theme::Light) ImGui::StyleColorsLight();
    setColors(style.Colors, wanted);
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
    const bool light = theme() == Theme::Light;
    ImGui::PushStyleColor(ImGuiCol_Button, ImU32(light ? kFillHot : kFill));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, ImU32(light ? kFillHeld : kFillHot));
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, ImU32(kFillHeld));
}

void popAccent() { ImGui::PopStyleColor(3); }

void coloredText(ImU32 color, const char* text) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
}

}  // namespace sward::ui
