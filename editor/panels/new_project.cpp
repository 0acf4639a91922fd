#include "panels/new_project.h"

#include <imgui.h>

#include "ui/theme.h"

namespace sward {

const ProjectTemplate* findTemplate(const std::vector<ProjectTemplate>& templates, const std::string& name) {
    for (const ProjectTemplate& t : templates)
        if (t.name == name) return &t;
    return nullptr;
}

void chooseTemplate(NewProject& wish, const ProjectTemplate& from) { wish = {from.name, from.size, from.relief}; }

bool drawTemplate(const ProjectTemplate& from, Thumbnails& thumbnails, const ui::TileSize& size, bool chosen) {
    const Thumbnail& picture = fileThumbnail(thumbnails, from.script.parent_path(), from.picture);
    const bool pressed = ui::tile(from.name, from.title, shownOf(picture), size, chosen);
    ui::tooltip(from.help);
    return pressed;
}

void drawNewProject(FileDialog& d, Thumbnails& thumbnails) {
    const float em = ImGui::GetFontSize();
    const ui::TileSize size{em * 8, em * 5};
    {
        const ui::Scope scope("Template");
        for (const ProjectTemplate& t : d.templates) {
            ui::nextTile(size, &t == &d.templates.front());
            if (drawTemplate(t, thumbnails, size, d.wish.name == t.name)) chooseTemplate(d.wish, t);
        }
    }
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Size");
    ImGui::SameLine(0, 6);
    ImGui::SetNextItemWidth(em * 9);
    const ui::NumberSpec metres{
        .softMin = 20, .softMax = 400, .hardMin = kLeastSize, .hardMax = kMostSize, .unit = "m"};
    ui::slider("Size", d.wish.size, metres);
    ui::tooltip("Metres of the terrain each way. A double click types a number, up to 4000.");
    ImGui::SameLine(0, 16);
    ImGui::TextUnformatted("Relief");
    ImGui::SameLine(0, 6);
    ImGui::SetNextItemWidth(em * 9);
    const ui::NumberSpec relief{.softMax = 40, .hardMin = 0, .hardMax = kMostRelief, .unit = "m"};
    ui::slider("Relief", d.wish.relief, relief);
    ui::tooltip("Metres between the lowest and the highest ground; 0: level.");
    ImGui::PushTextWrapPos(0);
    if (const ProjectTemplate* t = findTemplate(d.templates, d.wish.name))
        ui::coloredText(ui::kDimText, t->help.c_str());
    ImGui::PopTextWrapPos();
    ImGui::Spacing();
}

}  // namespace sward
