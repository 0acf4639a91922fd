#include "panels/field_edit.h"

#include <imgui.h>

namespace sward {
namespace {

// Under the field its path need not be said again.
std::string refusal(const Error& error, const std::string& path) {
    std::string text = error.message;
    if (text.starts_with(path + ": ")) text.erase(0, path.size() + 2);
    return error.remedy.empty() ? text : text + " (" + error.remedy + ")";
}

}  // namespace

void setField(EditorApp& app, const std::string& path, const std::string& text, const std::string& label) {
    app.deferred.push_back([&app, path, text, label] {
        const Status status = app.doc.setField(path, text);
        if (status)
            app.book.errors.erase(label);
        else
            app.book.errors[label] = refusal(status.error(), path);
    });
}

void holdEdit(EditorApp& app, const std::string& path) {
    if (!app.holding.empty()) return;
    app.holding = path;
    app.deferred.push_back([&app, path] { app.doc.beginGroup("set " + path); });
}

ui::NumberSpec numberSpec(const FieldRow& row) {
    ui::NumberSpec s;
    s.softMin = row.softMin, s.softMax = row.softMax;
    s.hardMin = row.hardMin, s.hardMax = row.hardMax;
    s.unit = row.unit;
    s.allowInf = row.allowInf;
    s.integer = row.type == FieldType::Int;
    return s;
}

void takeEdit(EditorApp& app, const ConstFieldRef& f, const ui::NumberEdit& edit, double value,
              const std::string& label) {
    if (edit.changed) {
        holdEdit(app, f.path);
        setField(app, f.path, ui::numberText(value, f.row->type == FieldType::Int), label);
    }
    if (edit.typed) setField(app, f.path, *edit.typed, label);
}

void caption(const char* text, const char* help) {
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text);
    ui::tooltip(help);
    ImGui::TableNextColumn();
    ImGui::SetNextItemWidth(-1);
}

}  // namespace sward
