// The entities of the project, in folders: choose, add, remove, drag from folder to folder.
#include <imgui.h>

#include <algorithm>
#include <set>

#include "app/object_actions.h"
#include "model/entity_edits.h"
#include "model/folder_edits.h"
#include "panels/field_edit.h"
#include "panels/panels.h"
#include "scene/in_folder.h"
#include "scene/locked.h"
#include "ui/imgui_compat.h"
#include "ui/theme.h"

namespace sward {
namespace {

constexpr const char* kDragged = "ENTITY";

struct Parts {
    const FieldParts& fields;
    Selection& selection;
    bool& menu;
    std::set<std::string> chosen;
    std::vector<std::string> shown;  // entities in the order in which they are listed
};

std::string componentsOf(const Document& doc, Entity e) {
    std::string names;
    for (const ComponentRow& row : doc.tables().components)
        if (row.get(doc.project().registry, e) && &row != findComponent(doc.tables().components, "InFolder"))
            names += (names.empty() ? "" : ", ") + std::string(row.name);
    return names;
}

bool holds(const std::string& text, const std::string& search) {
    const auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    };
    return std::search(text.begin(), text.end(), search.begin(), search.end(), same) != text.end();
}

// Whether its name, a component or its folder holds what is searched for, in any case.
bool isFound(const Document& doc, const std::string& name, const std::string& search) {
    return holds(name, search) || holds(componentsOf(doc, findEntity(doc.project(), name)), search) ||
           holds(folderOf(doc.project(), name), search);
}

// Shift chooses all rows from the one chosen last to this one.
void chooseRow(const Parts& p, const std::string& name) {
    const ImGuiIO& io = ImGui::GetIO();
    const auto row = [&](const std::string& of) { return std::find(p.shown.begin(), p.shown.end(), of); };
    auto from = row(shownEntity(p.selection)), to = row(name);
    if (!io.KeyShift || from == p.shown.end())
        return choose(p.selection, name, io.KeyCtrl ? Choose::Toggle : Choose::Only);
    std::vector<std::string> range(std::min(from, to), std::max(from, to) + 1);
    if (to < from) std::reverse(range.begin(), range.end());  // the one under the pointer is the last
    choose(p.selection, range, Choose::Add);
}

// What is dropped on the last item comes into the folder; all that is chosen, if it is one of these.
void takeDrop(const Parts& p, const std::string& folder) {
    if (!ImGui::BeginDragDropTarget()) return;
    if (const ImGuiPayload* got = ImGui::AcceptDragDropPayload(kDragged)) {
        const std::string name = static_cast<const char*>(got->Data);
        const std::vector<std::string> names =
            isChosen(p.selection, name) ? p.selection.entities : std::vector<std::string>{name};
        deferEdit(p.fields, [&doc = p.fields.doc, names, folder] { return moveToFolder(doc, names, folder); });
    }
    ImGui::EndDragDropTarget();
}

void offerDrag(const Parts& p, const std::string& name) {
    if (!ImGui::BeginDragDropSource()) return;
    ImGui::SetDragDropPayload(kDragged, name.c_str(), name.size() + 1);
    const size_t several = p.chosen.contains(name) ? p.chosen.size() : 1;
    ImGui::TextUnformatted(several > 1 ? (std::to_string(several) + " entities").c_str() : name.c_str());
    ImGui::EndDragDropSource();
}

// At the left end of a row's second column.
void padlock(const ImVec2& at, float size) {
    ImDrawList& d = *ImGui::GetWindowDrawList();
    const float x = at.x + size * 0.2f, y = at.y + size * 0.5f, w = size * 0.5f;
    d.AddRectFilled({x, y}, {x + w, y + size * 0.4f}, ui::kDimText, 1);
    d.PathArcTo({x + w / 2, y}, w * 0.35f, -3.1416f, 0, 8);
    d.PathStroke(ui::kDimText, 0, 1.5f);
}

void entityRow(const Parts& p, const std::string& name) {
    const Document& doc = p.fields.doc;
    const Entity e = findEntity(doc.project(), name);
    const bool chosen = p.chosen.contains(name);
    if (ui::selectable(name, chosen)) chooseRow(p, name);
    if (ImGui::IsItemHovered() && ImGui::IsMouseReleased(1)) {
        if (!chosen) choose(p.selection, name);
        p.menu = true;
    }
    const std::string parts = componentsOf(doc, e);
    ui::tooltip(parts.empty() ? "no components" : parts);
    takeDrop(p, folderOf(doc.project(), name));
    offerDrag(p, name);
    ImGui::SameLine(std::max(ImGui::CalcTextSize(name.c_str()).x + 16 + ImGui::GetCursorPosX(),
                             ImGui::GetContentRegionAvail().x * 0.42f));
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

// --- folders

// A button at the right end of a folder's row that does something to all in it; the end of the next one further left.
bool folderButton(const std::string& path, const char* name, const char* help, float right) {
    ImGui::SameLine(right);
    const bool pressed = ImGui::SmallButton((std::string(name) + "##" + path).c_str());
    ui::record(path + "/" + name, ui::Kind::Button);
    ui::tooltip(help);
    return pressed;
}

template <class F>
bool all(const std::vector<std::string>& names, const F& is) {
    return std::all_of(names.begin(), names.end(), is);
}

void hideAndLock(const Parts& p, const std::string& path, const std::vector<std::string>& names) {
    Document& doc = p.fields.doc;
    const auto has = [&](const std::string& name, const char* component) {
        const ComponentRow* row = findComponent(doc.tables().components, component);
        return row->get(doc.project().registry, findEntity(doc.project(), name)) != nullptr;
    };
    const bool hidden = all(names, [&](const std::string& n) { return has(n, "Hidden"); });
    const bool locked = all(names, [&](const std::string& n) { return has(n, "Locked"); });
    const float width = ImGui::CalcTextSize("Unlock").x + 12, right = ImGui::GetContentRegionMax().x;
    if (folderButton(path, hidden ? "Show" : "Hide", "Hides or shows all in the folder.", right - 2 * width))
        deferEdit(p.fields, [&doc, names, hidden] { return hideEntities(doc, names, !hidden); });
    if (folderButton(path, locked ? "Unlock" : "Lock", "Locks or unlocks all in the folder.", right - width))
        deferEdit(p.fields, [&doc, names, locked] { return lockEntities(doc, names, !locked); });
}

void arrow(const Parts& p, const std::string& path, const std::string& folder, bool open) {
    const float size = ImGui::GetTextLineHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton(("##arrow" + folder).c_str(), {size, size})) {
        if (open)
            p.selection.closedFolders.insert(folder);
        else
            p.selection.closedFolders.erase(folder);
    }
    ui::record(path + "/Open", ui::Kind::Checkbox, open ? "true" : "false");
    const float a = size * 0.25f, b = size * 0.75f, m = size * 0.5f;
    ImDrawList& d = *ImGui::GetWindowDrawList();
    if (open)
        d.AddTriangleFilled({at.x + a, at.y + a}, {at.x + b, at.y + a}, {at.x + m, at.y + b}, ui::kDimText);
    else
        d.AddTriangleFilled({at.x + a, at.y + a}, {at.x + b, at.y + m}, {at.x + a, at.y + b}, ui::kDimText);
}

constexpr int kFramesToFocus = 4;
// The name as it is being typed, until Enter, Escape or a click elsewhere.
void nameLine(const Parts& p, const std::string& path, const std::string& folder) {
    Selection& s = p.selection;
    if (s.nameAge == 0) ui::focusNext();
    ImGui::SetNextItemWidth(-1);
    const std::optional<std::string> typed = ui::textField(path + "/Name", folder);
    const bool typing = ImGui::IsItemActive();
    if (typed)
        deferEdit(p.fields, [&doc = p.fields.doc, folder, to = *typed] { return renameFolder(doc, folder, to); });
    if (typing) s.nameAge = -1;
    const bool left = !typing && (s.nameAge < 0 || ++s.nameAge > kFramesToFocus);
    if (typed || left) s.renaming.clear(), s.nameAge = 0;
}

// True while it is open.
bool folderRow(const Parts& p, const std::string& folder, const std::vector<std::string>& names) {
    const std::string path = "Folders/" + folder;
    const bool open = !p.selection.closedFolders.contains(folder);
    arrow(p, path, folder, open);
    ImGui::SameLine(0, 2);
    if (p.selection.renaming == folder) {
        nameLine(p, path, folder);
        return open;
    }
    const bool chosen = all(names, [&](const std::string& n) { return p.chosen.contains(n); });
    bool twice = false;
    ui::allowOverlapOfNext();
    const bool pressed = ui::selectable(path, chosen, &twice);
    ui::allowOverlapOfLast();
    const bool asked = ImGui::IsItemHovered() && ImGui::IsMouseReleased(1);
    if (pressed || asked) choose(p.selection, names, ImGui::GetIO().KeyCtrl ? Choose::Add : Choose::Only);
    if (asked) p.menu = true;
    if (twice) p.selection.renaming = folder, p.selection.nameAge = 0;
    ui::tooltip(std::to_string(names.size()) + " in it; a click chooses all, a double click renames the folder");
    takeDrop(p, folder);
    hideAndLock(p, path, names);
    return open;
}

void tree(Parts& p, const std::map<std::string, std::vector<std::string>>& folders) {
    for (const auto& [folder, names] : folders)
        if (!folder.empty() && !p.selection.closedFolders.contains(folder))
            p.shown.insert(p.shown.end(), names.begin(), names.end());
    if (const auto loose = folders.find(""); loose != folders.end())
        p.shown.insert(p.shown.end(), loose->second.begin(), loose->second.end());
    for (const auto& [folder, names] : folders) {
        if (folder.empty() || !folderRow(p, folder, names)) continue;
        ImGui::Indent();
        for (const std::string& name : names) entityRow(p, name);
        ImGui::Unindent();
    }
    if (const auto loose = folders.find(""); loose != folders.end())
        for (const std::string& name : loose->second) entityRow(p, name);
    ImGui::Dummy({ImGui::GetContentRegionAvail().x, std::max(ImGui::GetContentRegionAvail().y, ImGui::GetFontSize())});
    ui::record("No folder", ui::Kind::Area);
    takeDrop(p, "");
}

void rows(Parts& p) {
    const Document& doc = p.fields.doc;
    const std::string& search = p.selection.search;
    if (search.empty()) return tree(p, entitiesByFolder(doc.project()));
    for (const auto& [name, e] : doc.project().entities)
        if (isFound(doc, name, search)) p.shown.push_back(name);
    for (const std::string& name : p.shown) entityRow(p, name);
}

// --- below

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
    ui::input("Search", selection.search, "search names, components, folders");
    const std::string* error = ui::errorAt("New entity");
    const float below = ImGui::GetFrameHeightWithSpacing() + (error ? ImGui::GetTextLineHeightWithSpacing() * 2 : 0);
    ImGui::BeginChild("entities", {0, -below});
    if (doc.isOpen()) {
        Parts p{parts, selection, menu, {selection.entities.begin(), selection.entities.end()}, {}};
        rows(p);
    }
    ImGui::EndChild();
    footer(parts, selection);
    if (!error) return;
    ImGui::PushTextWrapPos(0);
    ui::coloredText(ui::kErrorText, error->c_str());
    ImGui::PopTextWrapPos();
}

}  // namespace sward
