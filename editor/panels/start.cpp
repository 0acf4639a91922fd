#include "panels/start.h"

#include <imgui.h>

#include <algorithm>

#include "panels/new_project.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace sward {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPicture = "picture.png";  // of a sample, in its folder

ui::TileSize projectTile() { return {ImGui::GetFontSize() * 10, ImGui::GetFontSize() * 6.25f}; }

void open(const StartParts& p, const fs::path& project) {
    p.edits.deferred.push_back([&doc = p.doc, &waiting = p.waiting, &messages = p.messages, adopt = p.adopt, project] {
        openBeside(waiting, doc, project, [&messages, adopt](const Status& opened) {
            if (accept(messages, opened)) adopt();
        });
    });
}

void heading(const char* title) {
    ImGui::Dummy({0, ImGui::GetFontSize() * 0.4f});
    ui::coloredText(ui::kDimText, title);
}

void templates(const StartParts& p) {
    const ui::Scope scope("New");
    if (p.start.templates.empty()) return;
    heading("New from");
    for (const ProjectTemplate& t : p.start.templates) {
        ui::nextTile(projectTile(), &t == &p.start.templates.front());
        if (!drawTemplate(t, p.thumbnails, projectTile(), false)) continue;
        chooseTemplate(p.files.wish, t);
        requestTask(p.files, p.unsaved, p.doc, FileTask::New);
    }
}

void list(const StartParts& p, const char* title, const std::vector<fs::path>& projects) {
    const ui::Scope scope(title);
    if (projects.empty()) return;
    heading(title);
    for (const fs::path& project : projects) {
        ui::nextTile(projectTile(), &project == &projects.front());
        const std::string name = project.filename().string();
        const Thumbnail& picture = fileThumbnail(p.thumbnails, project, kPicture);
        if (ui::tile(name, name, shownOf(picture), projectTile(), false)) open(p, project);
        ui::tooltip(project.string());
    }
}

void buttons(const StartParts& p) {
    const float width = ImGui::GetFontSize() * 9;
    if (ui::button("New project...", width, true)) requestTask(p.files, p.unsaved, p.doc, FileTask::New);
    ui::tooltip("A terrain with grass, sky and sun (Ctrl+N).");
    ImGui::SameLine(0, 8);
    if (ui::button("Open...", width)) requestTask(p.files, p.unsaved, p.doc, FileTask::Open);
    ui::tooltip("A folder that holds project.json (Ctrl+O).");
}

}  // namespace

void drawStart(const StartParts& p, const Rect& r) {
    ImGui::GetWindowDrawList()->AddRectFilled({r.x, r.y}, {r.x + r.w, r.y + r.h},
                                              ImGui::GetColorU32(ImGuiCol_MenuBarBg));
    const float margin = std::min(ImGui::GetFontSize() * 2, r.w / 20);
    const float across = projectTile().width + 6;
    const float width = std::min(r.w - 2 * margin, 5 * across + ImGui::GetStyle().ScrollbarSize);
    if (width < 40 || r.h < 40) return;
    const ui::Scope scope("Start");
    ImGui::SetCursorScreenPos({r.x + (r.w - width) / 2, r.y + margin});
    ImGui::BeginChild("start", {width, r.h - 2 * margin});
    ImGui::TextUnformatted("Sward");
    ui::coloredText(ui::kDimText, "No project is open.");
    buttons(p);
    templates(p);
    list(p, "Last opened", p.start.recent);
    list(p, "Samples", p.start.samples);
    ImGui::EndChild();
}

}  // namespace sward
