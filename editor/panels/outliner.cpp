// The entities of the project: choose, add, remove.
#include <imgui.h>

#include <algorithm>

#include "app/selection.h"
#include "panels/field_edit.h"
#include "panels/panels.h"
#include "ui/theme.h"

namespace sward {
namespace {

std::string componentsOf(const Document& doc, Entity e) {
    std::string names;
    for (const ComponentRow& row : doc.tables().components)
        if (row.get(doc.project().registry, e)) names += (names.empty() ? "" : ", ") + std::string(row.name);
    return names;
}

void entityRow(const Document& doc, std::string& selected, const std::string& name, Entity e) {
    const bool chosen = selected == name;
    if (ui::selectable(name, chosen)) selected = name;
    const std::string parts = componentsOf(doc, e);
    ui::tooltip(parts.empty() ? "no components" : parts);
    ImGui::SameLine(std::max(ImGui::CalcTextSize(name.c_str()).x + 16, ImGui::GetContentRegionAvail().x * 0.42f));
    ui::coloredText(ui::kDimText, parts.c_str());
}

void add(const FieldParts& parts, Selection& selection) {
    const std::string name = selection.newEntity;
    parts.edits.deferred.push_back([parts, &selection, name] {
        const Status status = parts.doc.addEntity(name);
        parts.errors.erase("Outliner/New entity");
        if (!status) {
            parts.errors["Outliner/New entity"] = status.error().text();
            return;
        }
        selection.entity = name;
        selection.newEntity.clear();
    });
}

void footer(const FieldParts& parts, Selection& selection) {
    bool entered = false;
    std::string& name = selection.newEntity;
    const float padding = 2 * ImGui::GetStyle().FramePadding.x;
    const float addWidth = ImGui::CalcTextSize("Add entity").x + padding,
                removeWidth = ImGui::CalcTextSize("Remove").x + padding;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - addWidth - removeWidth - 8);
    ui::input("New entity", name, "new entity", &entered);
    ImGui::SameLine(0, 4);
    {
        const ui::Disabled nameless(name.empty());
        if (ui::button("Add entity", addWidth) || (entered && !name.empty())) add(parts, selection);
    }
    ImGui::SameLine(0, 4);
    const ui::Disabled nothing(selection.entity.empty());
    if (ui::button("Remove", removeWidth))
        parts.edits.deferred.push_back([parts, &entity = selection.entity] {
            if (accept(parts.messages, parts.doc.removeEntity(entity))) entity.clear();
        });
    ui::tooltip("Removes the chosen entity with all its components.");
}

}  // namespace

void drawOutliner(const FieldParts& parts, Selection& selection) {
    Document& doc = parts.doc;
    ui::coloredText(ui::kDimText, "SCENE");
    const ui::Disabled noProject(!doc.isOpen());
    const std::string* error = ui::errorAt("New entity");
    const float below = ImGui::GetFrameHeightWithSpacing() + (error ? ImGui::GetTextLineHeightWithSpacing() * 2 : 0);
    ImGui::BeginChild("entities", {0, -below});
    if (doc.isOpen())
        for (const auto& [name, entity] : doc.project().entities) entityRow(doc, selection.entity, name, entity);
    ImGui::EndChild();
    footer(parts, selection);
    if (!error) return;
    ImGui::PushTextWrapPos(0);
    ui::coloredText(ui::kErrorText, error->c_str());
    ImGui::PopTextWrapPos();
}

}  // namespace sward
