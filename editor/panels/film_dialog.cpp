// The dialog of File > Screenshot and File > Film: size, place, and for a film its way and time.
#include "app/film_dialog.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "panels/bar_rows.h"
#include "panels/panels.h"
#include "ui/imgui_compat.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

using bar::em;

constexpr const char* kView = "the view, which stands";

// The names stand in a column of their own.
void columnCaption(const char* text) {
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, text);
    ImGui::SameLine(em(6.5f));
}

void numberLine(const char* label, double& value, ui::NumberSpec spec, const char* help) {
    ImGui::SetNextItemWidth(em(8));
    const ui::NumberEdit edit = ui::number(label, value, spec);
    std::string error;
    if (edit.typed) {
        if (const auto typed = ui::parseNumber(*edit.typed, spec, error)) value = *typed;
        ui::setError(label, error);
    }
    const std::string* wrong = ui::errorAt(label);
    ui::tooltip(wrong ? *wrong : help);
    if (wrong) {
        ImGui::SameLine(0, 8);
        ui::coloredText(ui::kErrorText, wrong->c_str());
    }
}

void side(const char* label, int& pixels) {
    double value = pixels;
    const ui::NumberSpec spec{.softMin = 64,
                              .softMax = 4096,
                              .hardMin = 1,
                              .hardMax = static_cast<double>(kLargestPicture),
                              .unit = "px",
                              .integer = true};
    numberLine(label, value, spec, "Of each picture. Type it for a size beyond the slider's.");
    pixels = static_cast<int>(std::lround(value));
}

struct FilmSize {
    const char* label;
    int width, height;
};
constexpr FilmSize kFilmSizes[] = {{"1280 x 720", 1280, 720}, {"1920 x 1080", 1920, 1080}, {"3840 x 2160", 3840, 2160}};

void size(FilmPlan& plan) {
    columnCaption("Size");
    side("Width", plan.width);
    ImGui::SameLine(0, 6);
    side("Height", plan.height);
    ImGui::SetCursorPosX(em(6.5f));
    for (const FilmSize& p : kFilmSizes) {
        if (ui::button(p.label, 0, plan.width == p.width && plan.height == p.height))
            plan.width = p.width, plan.height = p.height;
        ImGui::SameLine(0, 4);
    }
    ImGui::NewLine();
}

void way(FilmPlan& plan, const Project& project) {
    std::vector<std::string> names = filmPaths(project);
    names.insert(names.begin(), kView);
    const auto at = std::find(names.begin() + 1, names.end(), plan.path);
    int chosen = plan.path.empty() || at == names.end() ? 0 : static_cast<int>(at - names.begin());
    columnCaption("Along");
    ImGui::SetNextItemWidth(em(16.5f));
    if (ui::combo("Along", names, chosen)) plan.path = chosen == 0 ? "" : names[static_cast<size_t>(chosen)];
    ui::tooltip("A camera's path of the project; or the view, while wind and lights go on.");
    columnCaption("From");
    numberLine("From", plan.from, {.softMax = 60, .hardMin = 0, .hardMax = 1e6, .unit = "s"},
               "The scene's second at which it begins; of a path also the place.");
    columnCaption("Length");
    numberLine("Length", plan.seconds, {.softMax = 60, .hardMin = 0, .hardMax = 1e6, .unit = "s"},
               "How long it is; 0: to the path's end.");
    columnCaption("Rate");
    numberLine("Rate", plan.fps, {.softMin = 1, .softMax = 60, .hardMin = 0.01, .hardMax = 1000, .unit = "/s"},
               "Pictures a second.");
    const std::vector<std::string> formats{"png", "exr"};
    int format = plan.format == "exr" ? 1 : 0;
    columnCaption("Pictures");
    ImGui::SetNextItemWidth(em(8));
    if (ui::combo("Pictures", formats, format)) plan.format = formats[static_cast<size_t>(format)];
    ui::tooltip("png: as on the screen.  exr: linear, before tone mapping.");
    ImGui::SameLine(0, 8);
    const std::string count = fmt::format("{} pictures", framesOf(plan, project));
    ui::coloredText(ui::kDimText, count.c_str());
    ui::record("Count", ui::Kind::Label, count);
}

void place(FilmDialog& d) {
    bar::caption(d.plan.film ? "Folder" : "File");
    ImGui::SetNextItemWidth(-1);
    ui::input("Path", d.out, d.plan.film ? "folder of the film" : "file, ending in .png or .exr");
}

void refusal(const FilmDialog& d) {
    if (d.error.empty()) return;
    ImGui::PushTextWrapPos(0);
    ui::coloredText(ui::kErrorText, d.error.c_str());
    ImGui::PopTextWrapPos();
    ui::record("Error", ui::Kind::Label, d.error);
}

}  // namespace

bool drawFilmDialog(FilmDialog& d, const Document& doc) {
    if (!d.open) return false;
    const bool opening = std::exchange(d.opening, false);
    if (opening) ImGui::OpenPopup("###film");
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(em(40), screen.x - 16), 0});
    const int flags = ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                      ImGuiWindowFlags_AlwaysAutoResize;
    if (!ImGui::BeginPopupModal(d.plan.film ? "Film###film" : "Screenshot###film", nullptr, flags)) return false;
    if (!doc.isOpen()) d.open = false;
    if (d.open) {
        place(d);
        size(d.plan);
        if (d.plan.film) way(d.plan, doc.project());
        refusal(d);
    }
    const float width = em(7);
    ImGui::SetCursorPosX(std::max(ImGui::GetWindowContentRegionMax().x - 2 * width - 8, 0.f));
    if (ui::button("Cancel", width) || (ui::escapePressed() && !opening && !ImGui::IsAnyItemActive())) d.open = false;
    ImGui::SameLine(0, 8);
    const bool start = ui::button(d.plan.film ? "Film" : "Take", width, true);
    if (start) d.plan.out = d.out;
    if (!d.open) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return start;
}

}  // namespace sward
