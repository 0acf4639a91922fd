#include "panels/image_dialog.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "app/edits.h"
#include "core/error.h"
#include "core/log.h"
#include "ui/imgui_compat.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

namespace fs = std::filesystem;

struct ImageWords {
    const char *title, *action;
};
const ImageWords& wordsOf(ImageTask task) {
    static constexpr ImageWords kWords[] = {{"", ""},
                                            {"A brush's shape from an image", "Take"},
                                            {"Import an image into a map", "Import"},
                                            {"Heights into a part of the ground", "Place"}};
    return kWords[static_cast<size_t>(task)];
}

std::optional<double> numberOf(const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != 0 || !std::isfinite(value)) return {};
    return value;
}

void list(ImageDialog& d, Edits& edits) {
    ImGui::BeginChild("entries", {ImGui::GetContentRegionAvail().x * 0.55f, -ImGui::GetFrameHeightWithSpacing() * 3},
                      true);
    for (const auto& [name, folder] : d.entries) {
        bool twice = false;
        const std::string whole = (d.folder / name).string();
        const bool pressed = ui::selectable(folder ? name + "/" : name, d.path == whole, &twice);
        if (pressed && !folder) d.path = whole;
        if (twice && folder) edits.deferred.push_back([&d, whole] { enterFolder(d, whole); });
    }
    if (d.entries.empty()) ImGui::TextDisabled("No PNG, EXR, TIFF or R16 files here.");
    ImGui::EndChild();
}

void importOptions(ImageDialog& d) {
    ui::checkbox("Flip X", d.flipX);
    ImGui::SameLine(0, 14);
    ui::checkbox("Flip Z", d.flipZ);
    ui::tooltip("The image's first row is z = max instead of z = 0.");
    if (d.task != ImageTask::Map) return;
    const float width = ImGui::GetFontSize() * 5;
    ImGui::SetNextItemWidth(width);
    ui::input("Low", d.low, "low");
    ImGui::SameLine(0, 5);
    ImGui::SetNextItemWidth(width);
    ui::input("High", d.high, "high");
    ui::tooltip(
        "Heights: what 0 and full scale of integers stand for, in metres. Other maps: the numbers of an image of "
        "floats that become 0 and 1. Nothing: as they are.");
}

void look(ImageDialog& d) {
    const ImagePreview& p = d.preview;
    ImGui::BeginGroup();
    drawPreview(p, ImGui::GetFontSize() * 12, d.flipX, d.flipZ);
    const std::string told = d.reading.active() ? "Reading it..."
                             : !p.error.empty() ? p.error
                             : p.file.empty()   ? "Choose an image."
                                                : describe(p);
    ImGui::PushTextWrapPos(0);
    ui::coloredText(p.error.empty() ? ui::kDimText : ui::kErrorText, told.c_str());
    for (const std::string& repaired : p.repaired) ImGui::TextUnformatted(repaired.c_str());
    ImGui::PopTextWrapPos();
    ui::record("Told", ui::Kind::Label, told);
    if (d.task != ImageTask::Shape) importOptions(d);
    ImGui::EndGroup();
}

// The dialog closes, or says what was wrong; it comes back for that if something was waited for.
void act(ImageDialog& d, const TakeImage& take) {
    const auto acted = [&d](const Status& done) {
        d.error = done ? "" : done.error().text();
        d.opening = !done;
        if (done)
            d.task = ImageTask::None;
        else
            logWarning(d.error);
    };
    if (d.path.empty()) return acted(usage("no file is named", "type one or choose one above"));
    take(d, acted);
}

void body(ImageDialog& d, Edits& edits, const TakeImage& take) {
    if (ui::button("Up")) edits.deferred.push_back([&d] { enterFolder(d, d.folder.parent_path()); });
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(d.folder.c_str());
    ui::record("Folder", ui::Kind::Label, d.folder.string());
    list(d, edits);
    ImGui::SameLine();
    look(d);
    ImGui::SetNextItemWidth(-1);
    ui::input("Path", d.path, "the image's file");  // Enter looks at it; only the button takes it
    if (d.path != d.preview.file || d.reading.active()) edits.deferred.push_back([&d] { lookAt(d); });
    ui::coloredText(ui::kErrorText, d.error.empty() ? " " : d.error.c_str());
    if (!d.error.empty()) ui::record("Error", ui::Kind::Label, d.error);
    const float width = ImGui::GetFontSize() * 6;
    ImGui::SetCursorPosX(std::max(ImGui::GetWindowContentRegionMax().x - 2 * width - 8, 0.f));
    const bool cancelled = ui::button("Cancel", width) || (ui::escapePressed() && !ImGui::IsAnyItemActive());
    ImGui::SameLine(0, 8);
    const bool pressed = ui::button(wordsOf(d.task).action, width, true);
    if (cancelled) d.task = ImageTask::None;
    if (pressed) edits.deferred.push_back([&d, take] { act(d, take); });
}

}  // namespace

Result<std::optional<std::pair<double, double>>> rangeOf(const std::string& low, const std::string& high) {
    std::optional<std::pair<double, double>> range;
    if (low.empty() && high.empty()) return range;
    const std::optional<double> from = numberOf(low), to = numberOf(high);
    if (!from || !to || !(*from < *to))
        return usage("\"" + low + "\" to \"" + high + "\" is no range", "write two numbers, the smaller first");
    range = std::pair{*from, *to};
    return range;
}

void drawPreview(const ImagePreview& p, float side, bool flipX, bool flipZ) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::Dummy({side, side});
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(at, {at.x + side, at.y + side}, IM_COL32(30, 30, 30, 255));
    const float pixel = side / static_cast<float>(std::max({p.width, p.height, 1}));
    for (int y = 0; y < p.height; ++y)
        for (int x = 0, from = 0; x < p.width; from = x) {
            const auto of = [&](int column) {
                const int px = flipX ? p.width - 1 - column : column, py = flipZ ? p.height - 1 - y : y;
                return p.pixels[static_cast<size_t>(py) * static_cast<size_t>(p.width) + static_cast<size_t>(px)];
            };
            while (x < p.width && of(x) == of(from)) ++x;  // as many alike as there are, in one rectangle
            const float top = at.y + static_cast<float>(y) * pixel;
            draw.AddRectFilled({at.x + static_cast<float>(from) * pixel, top},
                               {at.x + static_cast<float>(x) * pixel, top + pixel}, of(from));
        }
    ui::record("Preview", ui::Kind::Area, p.file);
}

void drawImageDialog(ImageDialog& d, Edits& edits, const TakeImage& take) {
    if (d.task == ImageTask::None) return;
    if (std::exchange(d.opening, false) && !ImGui::IsPopupOpen("###image")) ImGui::OpenPopup("###image");
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowSize({std::min(screen.x * 0.9f, em * 44), std::min(screen.y * 0.85f, em * 30)});
    ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    const std::string title = std::string(wordsOf(d.task).title) + "###image";
    const int flags = ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
    if (!ImGui::BeginPopupModal(title.c_str(), nullptr, flags)) return;
    body(d, edits, take);
    if (d.task == ImageTask::None) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace sward
