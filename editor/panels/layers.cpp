// The layers over the map that the brush paints: the topmost first, as they lie; the painted map at the bottom.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "model/layer_edits.h"
#include "panels/field_edit.h"
#include "panels/panels.h"
#include "scene/ground_path.h"
#include "tools/brush_target.h"
#include "tools/layer_view.h"
#include "ui/theme.h"
#include "ui/words.h"
#include "world/layer_masks.h"
#include "world/map_stacks.h"

namespace sward {
namespace {

float em(float ems) { return ImGui::GetFontSize() * ems; }

void beside(float gap = 6) { ImGui::SameLine(0, gap); }

std::string labelOf(const std::string& path) { return "Layers/" + path; }

// A refusal makes the frame red, and the tooltip says it.
void told(const std::string& path, const std::string& help) {
    const std::string* error = ui::errorAt(path);
    ui::tooltip(error ? *error : help);
    if (!error) return;
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddRect(low, high, ui::kErrorText, 3);
}

ConstFieldRef fieldAt(const FieldParts& parts, const std::string& path) {
    const Result<ConstFieldRef> f = findField(parts.doc.project(), parts.doc.tables().components, path);
    CHECK(bool(f));
    return *f;
}

void choice(const FieldParts& parts, const std::string& path, float width) {
    const ConstFieldRef f = fieldAt(parts, path);
    const std::vector<std::string> items(f.row->options.begin(), f.row->options.end());
    int chosen = enumIndex(f.value);
    ImGui::SetNextItemWidth(width);
    if (ui::combo(path, items, chosen)) setField(parts, path, items[static_cast<size_t>(chosen)], labelOf(path));
    told(path, f.row->help);
}

void number(const FieldParts& parts, const std::string& path, float width, const ui::NumberSpec& spec) {
    const ConstFieldRef f = fieldAt(parts, path);
    double value = f.row->type == FieldType::Int ? *static_cast<const int*>(f.value)
                                                 : static_cast<double>(*static_cast<const float*>(f.value));
    ImGui::SetNextItemWidth(width);
    const ui::NumberEdit edit = ui::number(path, value, spec);
    told(path, f.row->help);
    takeEdit(parts, f, edit, value, labelOf(path));
}
void number(const FieldParts& parts, const std::string& path, float width) {
    number(parts, path, width, numberSpec(*fieldAt(parts, path).row));
}

void flag(const FieldParts& parts, const std::string& path, const char* title) {
    const ConstFieldRef f = fieldAt(parts, path);
    bool value = *static_cast<const bool*>(f.value);
    if (ui::checkbox(path, value, false)) setField(parts, path, value ? "true" : "false", labelOf(path));
    told(path, f.row->help);
    beside(3);
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, title);
}

void caption(const char* text) {
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, text);
    beside(4);
}

void name(const FieldParts& parts, const std::string& path, const std::string& value, float width) {
    ImGui::SetNextItemWidth(width);
    if (const auto typed = ui::textField(path, value)) setField(parts, path, *typed, labelOf(path));
    told(path, "what it is called");
}

// --- masks of a rule

void objectOf(const FieldParts& parts, const std::string& path, MaskBy by, const std::string& object) {
    std::vector<std::string> names;
    const Project& p = parts.doc.project();
    for (const auto& [entity, e] : p.entities)
        if (by == MaskBy::Path ? bool(p.registry.get<GroundPath>(e))
                               : p.registry.get<Transform>(e) || p.registry.get<StaticMesh>(e))
            names.push_back(entity);
    int chosen = static_cast<int>(std::find(names.begin(), names.end(), object) - names.begin());
    ImGui::SetNextItemWidth(em(8));
    if (ui::combo(path, names, chosen)) setField(parts, path, names[static_cast<size_t>(chosen)], labelOf(path));
    told(path, "the entity whose distance counts");
}

void mask(const FieldParts& parts, const std::string& path, const MapMask& m) {
    const MaskRow& row = maskRows()[static_cast<size_t>(m.by)];
    choice(parts, path + ".by", em(5.5f));
    for (const auto& [end, least] :
         {std::pair{"from", row.softMin}, std::pair{"to", row.softMin}, std::pair{"falloff", 0.0}}) {
        beside();
        caption(end);
        ui::NumberSpec spec = numberSpec(*fieldAt(parts, path + "." + end).row);
        spec.softMin = least, spec.softMax = row.softMax, spec.unit = row.unit;
        number(parts, path + "." + end, em(6), spec);
    }
    if (m.by == MaskBy::Object || m.by == MaskBy::Path) beside(), objectOf(parts, path + ".object", m.by, m.object);
    if (m.by == MaskBy::Noise) {
        beside(), caption("size"), number(parts, path + ".size", em(5));
        beside(), caption("seed"), number(parts, path + ".seed", em(4));
    }
    beside();
    flag(parts, path + ".invert", "invert");
    beside();
    if (ui::button(path + "/x")) deferEdit(parts, [&doc = parts.doc, path] { return doc.removeListElement(path); });
    ui::tooltip("Remove this mask");
}

void masks(const FieldParts& parts, const LayerOf& of) {
    const std::string list = of.path + ".masks";
    const ConstFieldRef field = fieldAt(parts, list);
    const std::vector<std::string> selectors = elementSelectors(*field.row->list, field.value);
    ImGui::Indent(em(1.5f));
    for (size_t i = 0; i < selectors.size(); ++i)
        mask(parts, fmt::format("{}[{}]", list, selectors[i]), of.layer->masks[i]);
    if (ui::button(of.path + "/Add mask"))
        deferEdit(parts, [&doc = parts.doc, list] { return doc.addListElement(list); });
    ui::tooltip("Masks are multiplied: the layer counts where all of them do.");
    ImGui::Unindent(em(1.5f));
}

// --- layers with amounts of their own

void image(const FieldParts& parts, const LayerOf& of, LayerView& view) {
    caption("image file");
    ImGui::SetNextItemWidth(em(16));
    ui::input(of.path + "/File", view.file, "/folder/mask.png");
    ui::tooltip("PNG, EXR, TIFF or R16; integers from 0 to full scale become 0 to 1.");
    beside();
    ui::checkbox(of.path + "/Flip", view.flip);
    ui::tooltip("The image's first row is z = max.");
    beside();
    const ui::Disabled none(view.file.empty());
    if (ui::button(of.path + "/Import"))
        deferEdit(parts, [&doc = parts.doc, path = of.path, file = view.file, flip = view.flip] {
            return importLayer(doc, path, file, {.flip = flip, .range = {}});
        });
}

void ownMap(const FieldParts& parts, BrushBook& brushes, const LayerOf& of, LayerView& view) {
    const std::string amounts = of.path + ".amounts";
    ImGui::Indent(em(1.5f));
    if (ui::button(of.path + "/Paint", 0, brushes.map == amounts)) selectMap(parts.doc, brushes, amounts);
    ui::tooltip("The brush paints on this layer.");
    if (of.layer->kind == LayerKind::Image) beside(), image(parts, of, view);
    ImGui::Unindent(em(1.5f));
}

// --- a layer

void note(const std::vector<LayerNote>& notes, const std::string& path) {
    for (const LayerNote& n : notes) {
        if (n.layer != path) continue;
        const std::string text = (n.skipped ? "Skipped: " : "") + n.message;
        ImGui::Indent(em(1.5f));
        ImGui::PushTextWrapPos(0);
        ui::coloredText(ui::kErrorText, text.c_str());
        ImGui::PopTextWrapPos();
        ui::record(path + "/Note", ui::Kind::Label, text);
        ImGui::Unindent(em(1.5f));
    }
}

void order(const FieldParts& parts, const std::string& path) {
    for (const bool up : {true, false}) {
        beside(3);
        if (ui::button(path + (up ? "/Up" : "/Down")))
            deferEdit(parts, [&doc = parts.doc, path, up] { return moveLayer(doc, path, up); });
        ui::tooltip(up ? "Over the next one above" : "Below the next one");
    }
    beside(3);
    if (ui::button(path + "/Delete")) deferEdit(parts, [&doc = parts.doc, path] { return removeLayer(doc, path); });
    ui::tooltip("Remove this layer; undo brings it back.");
}

void layer(const FieldParts& parts, BrushBook& brushes, const LayerOf& of) {
    const std::string& path = of.path;
    bool on = !of.layer->muted;
    if (ui::checkbox(path + "/On", on, false))
        setField(parts, path + ".muted", on ? "false" : "true", labelOf(path + "/On"));
    told(path + "/On", "Off: the layer is muted; it is kept and does nothing.");
    beside();
    name(parts, path + ".name", of.layer->name, em(10));
    beside();
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, kLayerKinds[of.layer->kind]);
    beside();
    choice(parts, path + ".operation", em(6));
    beside(), caption("opacity"), number(parts, path + ".opacity", em(5));
    beside();
    flag(parts, path + ".invert", "invert");
    beside();
    if (ui::button(path + "/Preview", 0, brushes.preview == path))
        brushes.preview = brushes.preview == path ? "" : path;
    ui::tooltip("Shows in the viewport how much of the layer there is where.");
    order(parts, path);
}

void addButtons(const FieldParts& parts, const std::string& map) {
    for (size_t i = 0; i < kLayerKinds.size(); ++i) {
        if (i > 0) beside(3);
        if (ui::button(fmt::format("Add {}", kLayerKinds[i])))
            deferEdit(parts, [&doc = parts.doc, map, i] { return addLayer(doc, map, static_cast<LayerKind>(i)); });
        ui::tooltip(layerKindRows()[i].help);
    }
}

}  // namespace

void drawLayers(const FieldParts& parts, BrushBook& brushes, LayerView& view, const std::vector<LayerNote>& notes) {
    const Document& doc = parts.doc;
    const std::optional<ConstFieldRef> chosen = chosenMap(doc, brushes);
    if (!chosen) return ImGui::TextDisabled("The brush is on no map.");
    const std::string map = stackedMap(doc.project(), chosen->path);
    if (chosen->row->map->kind != MapKind::Amounts)
        return ImGui::TextDisabled("%s holds no amounts: layers lie over densities and the like.", map.c_str());
    addButtons(parts, map);
    ImGui::BeginChild("layers");
    const std::vector<LayerOf> layers = layersOver(doc.project(), map);
    for (auto of = layers.rbegin(); of != layers.rend(); ++of) {
        layer(parts, brushes, *of);
        note(notes, of->path);
        if (of->layer->kind == LayerKind::Rule)
            masks(parts, *of);
        else
            ownMap(parts, brushes, *of, view);
    }
    if (ui::button("Paint below", 0, brushes.map == map)) selectMap(doc, brushes, map);
    ui::tooltip("The brush paints on the map itself: " + map);
    beside();
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, ui::inWords(map).c_str());
    ImGui::EndChild();
}

}  // namespace sward
