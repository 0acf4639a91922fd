#include "panels/start.h"

#include <imgui.h>

#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

namespace fs = std::filesystem;

void open(const StartParts& p, const fs::path& project) {
    p.edits.deferred.push_back([&doc = p.doc, &messages = p.messages, adopt = p.adopt, project] {
        if (accept(messages, doc.open(project))) adopt();
    });
}

void list(const StartParts& p, const char* title, const std::vector<fs::path>& projects) {
    const ui::Scope scope(title);
    if (projects.empty()) return;
    ImGui::Dummy({0, ImGui::GetFontSize() * 0.4f});
    ui::coloredText(ui::kDimText, title);
    for (const fs::path& project : projects) {
        if (ui::selectable(project.filename().string(), false)) open(p, project);
        ui::tooltip(project.string());
    }
}

void buttons(const StartParts& p) {
    const float width = ImGui::GetFontSize() * 9;
    if (ui::button("New project...", width, true)) requestTask(p.files, p.unsaved, p.doc, FileTask::New);
    ui::tooltip("An empty terrain with grass, sky and sun (Ctrl+N).");
    ImGui::SameLine(0, 8);
    if (ui::button("Open...", width)) requestTask(p.files, p.unsaved, p.doc, FileTask::Open);
    ui::tooltip("A folder that holds project.json (Ctrl+O).");
}

}  // namespace

void drawStart(const StartParts& p, const Rect& r) {
    ImGui::GetWindowDrawList()->AddRectFilled({r.x, r.y}, {r.x + r.w, r.y + r.h},
                                              ImGui::GetColorU32(ImGuiCol_MenuBarBg));
    const float width = std::min(r.w - 16, ImGui::GetFontSize() * 22);
    const float rows = static_cast<float>(p.start.recent.size() + p.start.samples.size() + 7);
    const float height = std::min(r.h - 16, rows * ImGui::GetTextLineHeightWithSpacing());
    if (width < 40 || height < 40) return;
    const ui::Scope scope("Start");
    ImGui::SetCursorScreenPos({r.x + (r.w - width) / 2, r.y + (r.h - height) / 2});
    ImGui::BeginChild("start", {width, height});
    ImGui::TextUnformatted("Sward");
    ui::coloredText(ui::kDimText, "No project is open.");
    buttons(p);
    list(p, "Last opened", p.start.recent);
    list(p, "Samples", p.start.samples);
    ImGui::EndChild();
}

}  // namespace sward
