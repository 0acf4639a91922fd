#include "panels/inspector_fields.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cctype>

#include "panels/inspector_maps.h"
#include "ui/theme.h"
#include "ui/words.h"

namespace sward {
namespace {

void set(const FieldParts& parts, const std::string& path, const std::string& text) {
    setField(parts, path, text, "Inspector/" + path);
}

void numberField(const FieldParts& parts, const ConstFieldRef& f) {
    double value = f.row->type == FieldType::Int ? static_cast<double>(*static_cast<const int*>(f.value))
                                                 : static_cast<double>(*static_cast<const float*>(f.value));
    const ui::NumberEdit edit = ui::number(f.path, value, numberSpec(*f.row));
    takeEdit(parts, f, edit, value, "Inspector/" + f.path);
}

std::string vectorText(const double* v, int n) {
    std::string text = "[";
    for (int i = 0; i < n; ++i) text += (i ? ", " : "") + ui::numberText(v[i], false, true);
    return text + "]";
}

void vectorField(const FieldParts& parts, const ConstFieldRef& f) {
    const int n = f.row->type == FieldType::Vec2 ? 2 : 3;
    double v[3] = {};
    for (int i = 0; i < n; ++i) v[i] = static_cast<const double*>(f.value)[i];
    ui::NumberSpec spec = numberSpec(*f.row);
    spec.softMin = spec.softMax = 0;
    spec.precise = true;
    spec.unit.clear();
    const float width = (ImGui::GetContentRegionAvail().x - static_cast<float>(n - 1) * 3) / static_cast<float>(n);
    ImGui::BeginGroup();
    for (int i = 0; i < n; ++i) {
        if (i > 0) ImGui::SameLine(0, 3);
        ImGui::SetNextItemWidth(width);
        const std::string label = f.path + "." + (n == 2 ? "xz" : "xyz")[i];
        const ui::NumberEdit edit = ui::number(label, v[i], spec);
        if (edit.changed) holdEdit(parts, f.path), set(parts, f.path, vectorText(v, n));
        if (!edit.typed) continue;
        std::string error;
        if (const auto typed = ui::parseNumber(*edit.typed, spec, error))
            v[i] = *typed, set(parts, f.path, vectorText(v, n));
        ui::setError(f.path, error);
    }
    ImGui::EndGroup();
    ui::record(f.path, ui::Kind::Vector, vectorText(v, n));
}

void textLine(const FieldParts& parts, const ConstFieldRef& f, const std::string& shown) {
    if (const auto typed = ui::textField(f.path, shown)) set(parts, f.path, *typed);
}

void colorField(const FieldParts& parts, const ConstFieldRef& f) {
    const glm::vec3 color = *static_cast<const glm::vec3*>(f.value);
    float v[3] = {color.x, color.y, color.z};
    if (ui::colorEdit(f.path + "/Swatch", v)) {
        holdEdit(parts, f.path);
        set(parts, f.path, fmt::format("[{}, {}, {}]", v[0], v[1], v[2]));
    }
    ui::tooltip("Click to choose. The numbers are reflectances in linear light.");
    ImGui::SameLine(0, 4);
    ImGui::SetNextItemWidth(-1);
    textLine(parts, f, fieldText(f));
}

void boolField(const FieldParts& parts, const ConstFieldRef& f) {
    bool value = *static_cast<const bool*>(f.value);
    if (ui::checkbox(f.path, value, false)) set(parts, f.path, value ? "true" : "false");
}

void choiceField(const FieldParts& parts, const ConstFieldRef& f) {
    const std::vector<std::string> items(f.row->options.begin(), f.row->options.end());
    int chosen = static_cast<int>(std::find(items.begin(), items.end(), fieldText(f)) - items.begin());
    if (ui::combo(f.path, items, chosen)) set(parts, f.path, items[static_cast<size_t>(chosen)]);
}

void label(const FieldParts& parts, const ConstFieldRef& f, const void* fallback, float width) {
    const ConstFieldRef usual{fallback, f.row, f.component, f.entity, f.path};
    const bool map = f.row->type == FieldType::Map;
    const std::string usualText = map ? "" : fieldText(usual);
    const bool changed = !map && fieldText(f) != usualText;
    const std::string title = f.row->title ? f.row->title : fieldTitle(f.row->name);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool clicked = ImGui::InvisibleButton(("##label" + f.path).c_str(), {width, ImGui::GetFrameHeight()});
    ui::record(f.path + "/Reset", ui::Kind::Button);
    const bool hot = ImGui::IsItemHovered() && !map;
    std::string help = std::string(f.row->help) + "\n" + f.path;
    if (map)
        help +=
            "\nfile: " +
            (static_cast<const MapField*>(f.value)->present() ? static_cast<const MapField*>(f.value)->file : "none");
    if (!map) help += "\nClick: back to " + (usualText.empty() ? "nothing" : usualText);
    ui::tooltip(help);
    const ImU32 color = hot ? ui::kAccent : changed ? ImGui::GetColorU32(ImGuiCol_Text) : ui::kDimText;
    ImGui::PushClipRect(at, {at.x + width, at.y + ImGui::GetFrameHeight()}, true);
    ImGui::GetWindowDrawList()->AddText({at.x, at.y + ImGui::GetStyle().FramePadding.y}, color, title.c_str());
    ImGui::PopClipRect();
    if (clicked && changed) set(parts, f.path, usualText);
}

void value(const FieldParts& parts, const ConstFieldRef& f) {
    switch (f.row->type) {
        case FieldType::Bool:
            return boolField(parts, f);
        case FieldType::Int:
        case FieldType::Float:
            return numberField(parts, f);
        case FieldType::Vec2:
        case FieldType::Vec3:
            return vectorField(parts, f);
        case FieldType::Color:
            return colorField(parts, f);
        case FieldType::String:
            if (f.row->isFile && parts.files) return drawFileField(parts, f);
            return textLine(parts, f, *static_cast<const std::string*>(f.value));
        case FieldType::Enum:
        case FieldType::Name:
            return choiceField(parts, f);
        case FieldType::Map:
            return drawMapField(parts, f);
        case FieldType::List:
            return;  // lists have rows of their own
    }
}

}  // namespace

std::string fieldTitle(const std::string& name) {
    std::string stem = ui::spelt(name);
    if (stem.size() > 3 && stem.ends_with("Deg")) stem.resize(stem.size() - 3);
    std::string title;
    for (const char c : stem) {
        const unsigned char u = static_cast<unsigned char>(c);
        if (std::isupper(u) && !title.empty()) title += ' ';
        title += static_cast<char>(title.empty() ? std::toupper(u) : std::tolower(u));
    }
    return title;
}

std::string elementTitle(const std::string& list) {
    const bool hissing = list.ends_with("shes") || list.ends_with("ches") || list.ends_with("xes");
    const size_t ending = list.ends_with("ies") ? 0 : hissing ? 2 : list.ends_with("s") ? 1 : 0;
    return fieldTitle(list.substr(0, list.size() - ending));
}

void drawField(const FieldParts& parts, const ConstFieldRef& field, const void* fallback) {
    const float width = std::max(ImGui::GetContentRegionAvail().x * 0.42f, 60.f);
    const float x = ImGui::GetCursorPosX();
    label(parts, field, fallback, width - 6);
    ImGui::SameLine(x + width);
    ImGui::SetNextItemWidth(-1);
    value(parts, field);
    const std::string* error = ui::errorAt(field.path);
    if (!error) return;
    ImGui::PushTextWrapPos(0);
    ui::coloredText(ui::kErrorText, error->c_str());
    ImGui::PopTextWrapPos();
}

}  // namespace sward
