// The entities of the project: choose, add, remove.
#include <imgui.h>

#include <algorithm>
#include <set>

#include "app/object_actions.h"
#include "panels/field_edit.h"
#include "panels/panels.h"
#include "scene/locked.h"
#include "ui/theme.h"

namespace sward {
namespace {

std::string componentsOf(const Document& doc, Entity e) {
    std::string names;
    for (const ComponentRow& row : doc.tables().components)
        if (row.get(doc.project().registry, e)) names += (names.empty() ? "" : ", ") + std::string(row.name);
    return names;
}

// Names that hold what is searched for, in any case.
std::vector<std::string> listed(const Document& doc, const std::string& search) {
    const auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    };
    std::vector<std::string> names;
    for (const auto& [name, e] : doc.project().entities)
        if (std::search(name.begin(), name.end(), search.begin(), search.end(), same) != name.end() || search.empty())
            names.push_back(name);
    return names;
}

// Shift chooses all rows from the one chosen last to this one.
void chooseRow(Selection& selection, const std::vector<std::string>& names, const std::string& name) {
    const ImGuiIO& io = ImGui::GetIO();
    const auto row = [&](const std::string& of) { return std::find(names.begin(), names.end(), of); };
    auto from = row(shownEntity(selection)), to = row(name);
    if (!io.KeyShift || from == names.end()) return choose(selection, name, io.KeyCtrl ? Choose::Toggle : Choose::Only);
    std::vector<std::string> range(std::min(from, to), std::max(from, to) + 1);
    if (to < from) std::reverse(range.begin(), range.end());  // the one under the pointer is the last
    choose(selection, range, Choose::Add);
}

// At the left end of a row's second column.
void padlock(const ImVec2& at, float size) {
    ImDrawList& d = *ImGui::GetWindowDrawList();
    const float x = at.x + size * 0.2f, y = at.y + size * 0.5f, w = size * 0.5f;
    d.AddRectFilled({x, y}, {x + w, y + size * 0.4f}, ui::kDimText, 1);
    d.PathArcTo({x + w / 2, y}, w * 0.35f, -3.1416f, 0, 8);
    d.PathStroke(ui::kDimText, 0, 1.5f);
}

void entityRow(const Document& doc, Selection& selection, const std::vector<std::string>& names,
               const std::string& name, bool chosen, bool& menu) {
    const Entity e = findEntity(doc.project(), name);
    if (ui::selectable(name, chosen)) chooseRow(selection, names, name);
    if (ImGui::IsItemHovered() && ImGui::IsMouseReleased(1)) {
        if (!chosen) choose(selection, name);
        menu = true;
    }
    const std::string parts = componentsOf(doc, e);
    ui::tooltip(parts.empty() ? "no components" : parts);
    ImGui::SameLine(std::max(ImGui::CalcTextSize(name.c_str()).x + 16, ImGui::GetContentRegionAvail().x * 0.42f));
    if (isLocked(doc.project(), name)) {
        const float size = ImGui::GetTextLineHeight();
        padlock(ImGui::GetCursorScreenPos(), size);
        ImGui::Dummy({size, size});
        ui::record("Locked " + name, ui::Kind::Label, "true");
        ui::tooltip("The viewport neither chooses nor moves it; L unlocks.");
        ImGui::SameLine(0, 4);
    }
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
        choose(selection, name);
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
    const ui::Disabled nothing(selection.entities.empty());
    if (ui::button("Remove", removeWidth))
        parts.edits.deferred.push_back([parts, &selection] { removeChosen(parts.doc, selection, parts.messages); });
    ui::tooltip("Removes the chosen entities with all their components.");
}

}  // namespace

void drawOutliner(const FieldParts& parts, Selection& selection, bool& menu) {
    Document& doc = parts.doc;
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, "SCENE");
    const ui::Disabled noProject(!doc.isOpen());
    ImGui::SameLine(0, 12);
    ImGui::SetNextItemWidth(-1);
    ui::input("Search", selection.search, "search");
    const std::string* error = ui::errorAt("New entity");
    const float below = ImGui::GetFrameHeightWithSpacing() + (error ? ImGui::GetTextLineHeightWithSpacing() * 2 : 0);
    ImGui::BeginChild("entities", {0, -below});
    if (doc.isOpen()) {
        const std::vector<std::string> names = listed(doc, selection.search);
        const std::set<std::string> chosen(selection.entities.begin(), selection.entities.end());
        for (const std::string& name : names) entityRow(doc, selection, names, name, chosen.contains(name), menu);
    }
    ImGui::EndChild();
    footer(parts, selection);
    if (!error) return;
    ImGui::PushTextWrapPos(0);
    ui::coloredText(ui::kErrorText, error->c_str());
    ImGui::PopTextWrapPos();
}

}  // namespace sward
