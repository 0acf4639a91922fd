#include "panels/field_edit.h"

#include <functional>

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

void setField(const FieldParts& parts, const std::string& path, const std::string& text, const std::string& label) {
    parts.edits.deferred.push_back([parts, path, text, label] {
        const Status status = parts.doc.setField(path, text);
        if (status)
            parts.errors.erase(label);
        else
            parts.errors[label] = refusal(status.error(), path);
    });
}

void holdEdit(const FieldParts& parts, const std::string& path) {
    if (!parts.edits.holding.empty()) return;
    parts.edits.holding = path;
    parts.edits.deferred.push_back([&doc = parts.doc, path] { doc.beginGroup("set " + path); });
}

void deferEdit(const FieldParts& parts, std::function<Status()> edit) {
    parts.edits.deferred.push_back([&messages = parts.messages, edit = std::move(edit)] { accept(messages, edit()); });
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

void takeEdit(const FieldParts& parts, const ConstFieldRef& f, const ui::NumberEdit& edit, double value,
              const std::string& label) {
    if (edit.changed) {
        holdEdit(parts, f.path);
        setField(parts, f.path, ui::numberText(value, f.row->type == FieldType::Int), label);
    }
    if (edit.typed) setField(parts, f.path, *edit.typed, label);
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
