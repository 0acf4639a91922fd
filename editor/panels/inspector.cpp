// The chosen entity's components, made from their field tables. Fields themselves: inspector_fields.cpp.
#include <imgui.h>

#include "panels/inspector_camera.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <string_view>

#include "app/add_actions.h"
#include "model/whole_map.h"
#include "panels/inspector_fields.h"
#include "panels/panels.h"
#include "scene/field_rows.h"
#include "scene/technique.h"
#include "tools/appear.h"
#include "ui/imgui_compat.h"
#include "ui/theme.h"

namespace sward {
namespace {

void removeButton(const FieldParts& parts, const std::string& path, const char* what,
                  const std::function<Status()>& remove) {
    const float width = ImGui::GetFontSize() * 1.6f;
    ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
    if (ImGui::SmallButton(("x##" + path).c_str())) deferEdit(parts, remove);
    ui::record(path + "/Remove", ui::Kind::Button);
    ui::tooltip(what);
}

// A header that leaves room for the button at its right end.
bool header(const std::string& path, const std::string& title, bool openAtFirst) {
    ImGui::PushClipRect(
        ImGui::GetCursorScreenPos(),
        {ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x, ImGui::GetCursorScreenPos().y + 1000}, true);
    ui::allowOverlapOfNext();
    const bool open = ui::section(path, title, openAtFirst);
    ImGui::PopClipRect();
    ui::allowOverlapOfLast();
    return open;
}

// Whose component is drawn; the entity's name stays where the person chose it.
struct Owner {
    const std::string& entity;
    const ComponentRow& component;
    std::string path() const { return entity + "." + component.name; }
};

// The fields under one heading; "" for those that stand above all headings.
struct Group {
    std::string_view title;
    std::vector<const FieldRow*> fields;
};
std::vector<Group> groupsOf(std::span<const FieldRow> fields) {
    std::vector<Group> out;
    std::string_view title;
    for (const FieldRow& f : fields) {
        if (f.group) title = f.group;
        auto at = std::find_if(out.begin(), out.end(), [&](const Group& g) { return g.title == title; });
        if (at == out.end()) at = out.insert(out.end(), Group{title, {}});
        at->fields.push_back(&f);
    }
    return out;
}
// Draws each field of `owner` that does something there and is not under a closed heading.
void drawGroups(const std::string& path, std::span<const FieldRow> fields, const void* owner,
                const std::function<void(const FieldRow&)>& drawOne) {
    for (const Group& g : groupsOf(fields)) {
        const std::string title(g.title);
        if (!title.empty() && !ui::section(path + "/" + title, title, title != kAdvanced)) continue;
        for (const FieldRow* f : g.fields)
            if (!f->acts || f->acts(owner)) drawOne(*f);
    }
}

std::string lowered(std::string title) {
    if (!title.empty()) title[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(title[0])));
    return title;
}

// What is added grows where it is painted: the brush goes to its density. `owner`: PATH of what the edit adds.
void addAndPaint(const FieldParts& parts, const std::function<Status()>& edit,
                 const std::function<std::string()>& owner) {
    deferEdit(parts, [&doc = parts.doc, brushes = parts.brushes, edit, owner] {
        const Status done = edit();
        if (done && brushes) paintNew(doc, *brushes, owner());
        return done;
    });
}

void addElement(const FieldParts& parts, const std::string& list) {
    Document& doc = parts.doc;
    addAndPaint(
        parts, [&doc, list] { return addUnpainted(doc, list); },
        [&doc, list] {
            const auto field = findField(doc.project(), doc.tables().components, list);
            return list + "[" + elementSelectors(*field->row->list, field->value).back() + "]";
        });
}

// Of a long list only the rows in sight are built, and those that are open: a path has a thousand points.
bool isOutOfSight(size_t rows, const std::string& path, const std::string& title) {
    constexpr size_t kMany = 64;
    const ImVec2 size(ImGui::GetContentRegionAvail().x, ImGui::GetFrameHeight());
    if (rows <= kMany || ImGui::IsRectVisible(size) || ui::sectionIsOpen(path, title)) return false;
    ImGui::Dummy(size);
    return true;
}

void listField(const FieldParts& parts, const Owner& owner, const FieldRow& row, const std::string& path,
               const void* list) {
    const ListRow& l = *row.list;
    for (size_t i = 0; i < l.size(list); ++i) {
        const void* element = l.at(list, i);
        const std::string name = *static_cast<const std::string*>(
            static_cast<const void*>(static_cast<const char*>(element) + l.fields[0].offset));
        const std::string called = name.empty() ? std::to_string(i) : name, at = path + "[" + called + "]";
        const std::string title = elementTitle(row.name) + ": " + called;
        if (isOutOfSight(l.size(list), at, title)) continue;
        const bool open = header(at, title, l.size(list) < 3);
        removeButton(parts, at, "Remove this one", [&doc = parts.doc, at] { return doc.removeListElement(at); });
        if (!open) continue;
        ImGui::Indent(8);
        drawGroups(at, l.fields, element, [&](const FieldRow& f) {
            const void* value = static_cast<const char*>(element) + f.offset;
            const void* fallback = static_cast<const char*>(l.defaults()) + f.offset;
            if (f.type == FieldType::List) return listField(parts, owner, f, at + "." + f.name, value);
            drawField(parts, {value, &f, &owner.component, owner.entity, at + "." + f.name}, fallback);
        });
        ImGui::Unindent(8);
    }
    if (ui::button(path + "/Add " + lowered(elementTitle(row.name)))) addElement(parts, path);
}

void component(const FieldParts& parts, ViewState& view, const Owner& owner, const void* value) {
    const ComponentRow& row = owner.component;
    const std::string path = owner.path();
    const bool open = header(path, row.name, true);
    if (value != row.defaults())  // settings that are absent
        removeButton(parts, path, row.settingsOf ? "Back to defaults" : "Remove this component",
                     [&doc = parts.doc, entity = owner.entity, &row] { return doc.removeComponent(entity, row.name); });
    if (!open) return;
    drawGroups(path, row.fields, value, [&](const FieldRow& f) {
        const void* field = static_cast<const char*>(value) + f.offset;
        if (f.type == FieldType::List)
            listField(parts, owner, f, path + "." + f.name, field);
        else
            drawField(parts, {field, &f, &row, owner.entity, path + "." + f.name},
                      static_cast<const char*>(row.defaults()) + f.offset);
    });
    drawCameraTools(parts, view, owner.entity, row, value);
    ImGui::Spacing();
}

// Whether settings act: those of the technique that the entity's field is drawn by.
bool acts(const Document& doc, Entity e, const ComponentRow& row) {
    const GrassField* field = doc.project().registry.get<GrassField>(e);
    const TechniqueRow* technique = field ? findTechnique(doc.tables().techniques, field->technique) : nullptr;
    return technique && std::find(technique->settings.begin(), technique->settings.end(), std::string_view(row.name)) !=
                            technique->settings.end();
}
// What the inspector shows of a component: settings only where they act, and then their defaults if they are absent.
const void* shownComponent(const Document& doc, Entity e, const ComponentRow& row) {
    const void* own = row.get(doc.project().registry, e);
    if (!row.settingsOf) return own;
    if (!acts(doc, e, row)) return nullptr;
    return own ? own : row.defaults();
}

// What has a place appears where one looks.
void addComponent(const FieldParts& parts, const ViewState& view, const std::string& entity, Entity e) {
    std::vector<std::string> names;
    for (const ComponentRow& row : parts.doc.tables().components)
        if (!row.settingsOf && !row.get(parts.doc.project().registry, e)) names.push_back(row.name);
    int chosen = -1;
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, "Add component");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    if (ui::combo("Add component", names, chosen)) {
        const std::string name = names[static_cast<size_t>(chosen)];
        addAndPaint(
            parts,
            [&doc = parts.doc, &view, entity, name] { return addInView(doc, viewOf(view.camera), entity, name); },
            [entity, name] { return entity + "." + name; });
    }
}

}  // namespace

void drawInspector(const FieldParts& parts, const std::string& selected, ViewState& view) {
    Document& doc = parts.doc;
    const Entity e = doc.isOpen() ? findEntity(doc.project(), selected) : kNoEntity;
    ui::coloredText(ui::kDimText, e == kNoEntity ? "INSPECTOR" : ("INSPECTOR: " + selected).c_str());
    if (e == kNoEntity) {
        ImGui::TextDisabled("Choose an entity above to see its fields.");
        return;
    }
    ImGui::BeginChild("fields");
    for (const ComponentRow& row : doc.tables().components)
        if (const void* value = shownComponent(doc, e, row)) component(parts, view, {selected, row}, value);
    addComponent(parts, view, selected, e);
    ImGui::EndChild();
}

}  // namespace sward
