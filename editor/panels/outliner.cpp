// The entities of the project: choose, add, remove.
#include <imgui.h>

#include "panels/panels.h"
#include "ui/theme.h"

namespace sward {
namespace {

std::string componentsOf(EditorApp& app, Entity e) {
    std::string names;
    for (const ComponentRow& row : app.doc.tables().components)
        if (row.get(app.doc.project().registry, e)) names += (names.empty() ? "" : ", ") + std::string(row.name);
    return names;
}

void entityRow(EditorApp& app, const std::string& name, Entity e) {
    const bool chosen = app.selected == name;
    if (ui::selectable(name, chosen)) app.selected = name;
    const std::string parts = componentsOf(app, e);
    ui::tooltip(parts.empty() ? "no components" : parts);
    ImGui::SameLine(std::max(ImGui::CalcTextSize(name.c_str()).x + 16, ImGui::GetContentRegionAvail().x * 0.42f));
    ui::coloredText(ui::kDimText, parts.c_str());
}

void add(EditorApp& app) {
    const std::string name = app.newEntity;
    app.deferred.push_back([&app, name] {
        const Status status = app.doc.addEntity(name);
        app.book.errors.erase("Outliner/New entity");
        if (!status) {
            app.book.errors["Outliner/New entity"] = status.error().text();
            return;
        }
        app.selected = name;
        app.newEntity.clear();
    });
}

void footer(EditorApp& app) {
    bool entered = false;
    const float padding = 2 * ImGui::GetStyle().FramePadding.x;
    const float addWidth = ImGui::CalcTextSize("Add entity").x + padding,
                removeWidth = ImGui::CalcTextSize("Remove").x + padding;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - addWidth - removeWidth - 8);
    ui::input("New entity", app.newEntity, "new entity", &entered);
    ImGui::SameLine(0, 4);
    {
        const ui::Disabled nameless(app.newEntity.empty());
        if (ui::button("Add entity", addWidth) || (entered && !app.newEntity.empty())) add(app);
    }
    ImGui::SameLine(0, 4);
    const ui::Disabled nothing(app.selected.empty());
    if (ui::button("Remove", removeWidth))
        app.deferred.push_back([&app] {
            if (accept(app, app.doc.removeEntity(app.selected))) app.selected.clear();
        });
    ui::tooltip("Removes the chosen entity with all its components.");
}

}  // namespace

void drawOutliner(EditorApp& app) {
    ui::coloredText(ui::kDimText, "SCENE");
    const ui::Disabled noProject(!app.doc.isOpen());
    const std::string* error = ui::errorAt("New entity");
    const float below = ImGui::GetFrameHeightWithSpacing() + (error ? ImGui::GetTextLineHeightWithSpacing() * 2 : 0);
    ImGui::BeginChild("entities", {0, -below});
    if (app.doc.isOpen())
        for (const auto& [name, entity] : app.doc.project().entities) entityRow(app, name, entity);
    ImGui::EndChild();
    footer(app);
    if (!error) return;
    ImGui::PushTextWrapPos(0);
    ui::coloredText(ui::kErrorText, error->c_str());
    ImGui::PopTextWrapPos();
}

}  // namespace sward
