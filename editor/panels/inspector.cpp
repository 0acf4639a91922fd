// The chosen entity's components, made from their field tables. Fields themselves: inspector_fields.cpp.
#include <imgui.h>

#include "panels/inspector_camera.h"
#include "panels/inspector_fields.h"
#include "panels/panels.h"
#include "ui/theme.h"

namespace sward {
namespace {

void removeButton(EditorApp& app, const std::string& path, const char* what, const std::function<Status()>& remove) {
    const float width = ImGui::GetFontSize() * 1.6f;
    ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
    if (ImGui::SmallButton(("x##" + path).c_str())) app.deferred.push_back([&app, remove] { accept(app, remove()); });
    ui::record(path + "/Remove", ui::Kind::Button);
    ui::tooltip(what);
}

// A header that leaves room for the button at its right end.
bool header(const std::string& path, const std::string& title, bool openAtFirst) {
    ImGui::PushClipRect(
        ImGui::GetCursorScreenPos(),
        {ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x, ImGui::GetCursorScreenPos().y + 1000}, true);
    const bool open = ui::section(path, title, openAtFirst);
    ImGui::PopClipRect();
    ImGui::SetItemAllowOverlap();
    return open;
}

void listField(EditorApp& app, const std::string& owner, const ComponentRow& component, const FieldRow& row,
               const void* list) {
    const ListRow& l = *row.list;
    const std::string path = owner + "." + row.name;
    for (size_t i = 0; i < l.size(list); ++i) {
        const void* element = l.at(list, i);
        const std::string name = *static_cast<const std::string*>(
            static_cast<const void*>(static_cast<const char*>(element) + l.fields[0].offset));
        const std::string at = path + "[" + (name.empty() ? std::to_string(i) : name) + "]";
        const bool open = header(at, fieldTitle(row.name) + ": " + name, l.size(list) < 3);
        removeButton(app, at, "Remove this one", [&app, at] { return app.doc.removeListElement(at); });
        if (!open) continue;
        ImGui::Indent(8);
        for (const FieldRow& f : l.fields) {
            const void* value = static_cast<const char*>(element) + f.offset;
            const void* fallback = static_cast<const char*>(l.defaults()) + f.offset;
            drawField(app, {value, &f, &component, app.selected, at + "." + f.name}, fallback);
        }
        ImGui::Unindent(8);
    }
    if (ui::button(path + "/Add " + row.name))
        app.deferred.push_back([&app, path] { accept(app, app.doc.addListElement(path)); });
}

void component(EditorApp& app, const ComponentRow& row, const void* value) {
    const std::string path = app.selected + "." + row.name;
    const bool open = header(path, row.name, true);
    removeButton(app, path, "Remove this component",
                 [&app, &row] { return app.doc.removeComponent(app.selected, row.name); });
    if (!open) return;
    for (const FieldRow& f : row.fields) {
        const void* field = static_cast<const char*>(value) + f.offset;
        if (f.type == FieldType::List)
            listField(app, path, row, f, field);
        else
            drawField(app, {field, &f, &row, app.selected, path + "." + f.name},
                      static_cast<const char*>(row.defaults()) + f.offset);
    }
    drawCameraTools(app, row, value);
    ImGui::Spacing();
}

void addComponent(EditorApp& app, Entity e) {
    std::vector<std::string> names;
    for (const ComponentRow& row : app.doc.tables().components)
        if (!row.get(app.doc.project().registry, e)) names.push_back(row.name);
    int chosen = -1;
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, "Add component");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    if (ui::combo("Add component", names, chosen)) {
        const std::string name = names[static_cast<size_t>(chosen)];
        app.deferred.push_back([&app, name] { accept(app, app.doc.addComponent(app.selected, name)); });
    }
}

}  // namespace

void drawInspector(EditorApp& app) {
    const Entity e = app.doc.isOpen() ? findEntity(app.doc.project(), app.selected) : kNoEntity;
    ui::coloredText(ui::kDimText, e == kNoEntity ? "INSPECTOR" : ("INSPECTOR: " + app.selected).c_str());
    if (e == kNoEntity) {
        ImGui::TextDisabled("Choose an entity above to see its fields.");
        return;
    }
    ImGui::BeginChild("fields");
    for (const ComponentRow& row : app.doc.tables().components)
        if (const void* value = row.get(app.doc.project().registry, e)) component(app, row, value);
    addComponent(app, e);
    ImGui::EndChild();
}

}  // namespace sward
