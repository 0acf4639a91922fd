// The layers over the map that the brush paints: the topmost first, as they lie; the painted map at the bottom.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "model/layer_edits.h"
#include "panels/bar_rows.h"
#include "panels/field_edit.h"
#include "panels/panels.h"
#include "scene/ground_path.h"
#include "tools/brush_target.h"
#include "tools/layer_view.h"
#include "ui/theme.h"
#include "ui/words.h"
#include "world/layer_masks.h"
#include "world/layered_tiles.h"
#include "world/map_stacks.h"

namespace sward {
namespace {

using bar::em;
using ui::beside;
float wide(const char* text) { return ImGui::CalcTextSize(text).x; }
float buttonWide(const char* text) { return wide(text) + 2 * ImGui::GetStyle().FramePadding.x; }
float boxWide(const char* title) { return ImGui::GetFrameHeight() + 3 + wide(title); }

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

void flag(const FieldParts& parts, const std::string& path, const char* title) {
    const ConstFieldRef f = fieldAt(parts, path);
    bool value = *static_cast<const bool*>(f.value);
    if (ui::checkbox(path, value, false)) setField(parts, path, value ? "true" : "false", labelOf(path));
    told(path, f.row->help);
    ImGui::SameLine(0, 3);
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, title);
}

// A number with its name before it, beside the last widget.
void captioned(const FieldParts& parts, const char* text, const std::string& path, float width,
               const ui::NumberSpec* spec = nullptr) {
    beside(wide(text) + 4 + width);
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, text);
    ImGui::SameLine(0, 4);
    number(parts, path, width, spec ? *spec : numberSpec(*fieldAt(parts, path).row));
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
        ui::NumberSpec spec = numberSpec(*fieldAt(parts, path + "." + end).row);
        spec.softMin = least, spec.softMax = row.softMax, spec.unit = row.unit;
        captioned(parts, end, path + "." + end, em(6), &spec);
    }
    if (m.by == MaskBy::Object || m.by == MaskBy::Path)
        beside(em(8)), objectOf(parts, path + ".object", m.by, m.object);
    if (m.by == MaskBy::Noise) {
        captioned(parts, "size", path + ".size", em(5));
        captioned(parts, "seed", path + ".seed", em(4));
    }
    beside(boxWide("invert"));
    flag(parts, path + ".invert", "invert");
    beside(buttonWide("x"));
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
    beside(wide("image file") + 4 + em(16));
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, "image file");
    ImGui::SameLine(0, 4);
    ImGui::SetNextItemWidth(em(16));
    ui::input(of.path + "/File", view.file, "/folder/mask.png");
    ui::tooltip("PNG, EXR, TIFF or R16; integers from 0 to full scale become 0 to 1.");
    beside(boxWide("Flip"));
    ui::checkbox(of.path + "/Flip", view.flip);
    ui::tooltip("The image's first row is z = max.");
    beside(buttonWide("Import"));
    const ui::Disabled none(view.file.empty());
    if (ui::button(of.path + "/Import"))
        deferEdit(parts, [&doc = parts.doc, path = of.path, file = view.file, flip = view.flip] {
            return importLayer(doc, path, file, {.flip = flip, .range = {}});
        });
}

// Metres of a layer over heights: what it lifts or levels to, or what its picture's ends stand for.
void metres(const FieldParts& parts, const LayerOf& of) {
    const LayerKind kind = of.layer->kind;
    if (kind != LayerKind::Rule)
        captioned(parts, kind == LayerKind::Path ? "over the ground" : "black is", of.path + ".low", em(6));
    if (kind != LayerKind::Path)
        captioned(parts, kind == LayerKind::Rule ? "metres" : "white is", of.path + ".high", em(6));
}

// The colour that a layer lays, as a swatch.
void swatch(const FieldParts& parts, const LayerOf& of) {
    const std::string path = of.path + ".color";
    beside(wide("lays") + 4 + ImGui::GetFrameHeight());
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, "lays");
    ImGui::SameLine(0, 4);
    float v[3] = {of.layer->color.x, of.layer->color.y, of.layer->color.z};
    if (ui::colorEdit(path, v)) {
        holdEdit(parts, path);
        setField(parts, path, fmt::format("[{}, {}, {}]", v[0], v[1], v[2]), labelOf(path));
    }
    told(path, "The colour that it lays where it counts. Click to choose.");
}

// The path that a layer goes along.
void alongPath(const FieldParts& parts, const LayerOf& of) {
    ImGui::Indent(em(1.5f));
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, "along");
    ImGui::SameLine(0, 4);
    objectOf(parts, of.path + ".path", MaskBy::Path, of.layer->path);
    ImGui::Unindent(em(1.5f));
}

void ownMap(const FieldParts& parts, BrushBook& brushes, const LayerOf& of, LayerView& view) {
    const std::string amounts = of.path + ".amounts";
    ImGui::Indent(em(1.5f));
    if (ui::button(of.path + "/Paint", 0, brushes.map == amounts)) selectMap(parts.doc, brushes, amounts);
    ui::tooltip("The brush paints on this layer.");
    if (of.layer->kind == LayerKind::Image) image(parts, of, view);
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
    const float gaps = 2 * 3, all = buttonWide("Up") + buttonWide("Down") + buttonWide("Delete") + gaps;
    beside(all);  // they stay together
    for (const bool up : {true, false}) {
        if (ui::button(path + (up ? "/Up" : "/Down")))
            deferEdit(parts, [&doc = parts.doc, path, up] { return moveLayer(doc, path, up); });
        ui::tooltip(up ? "Over the next one above" : "Below the next one");
        ImGui::SameLine(0, 3);
    }
    if (ui::button(path + "/Delete")) deferEdit(parts, [&doc = parts.doc, path] { return removeLayer(doc, path); });
    ui::tooltip("Remove this layer; undo brings it back.");
}

// One line where there is room; else it breaks between its widgets.
void layer(const FieldParts& parts, BrushBook& brushes, const LayerOf& of, MapKind under) {
    const std::string& path = of.path;
    bool on = !of.layer->muted;
    if (ui::checkbox(path + "/On", on, false))
        setField(parts, path + ".muted", on ? "false" : "true", labelOf(path + "/On"));
    told(path + "/On", "Off: the layer is muted; it is kept and does nothing.");
    beside(em(10));
    name(parts, path + ".name", of.layer->name, em(10));
    beside(wide(kLayerKinds[of.layer->kind]));
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, kLayerKinds[of.layer->kind]);
    beside(em(6));
    choice(parts, path + ".operation", em(6));
    captioned(parts, "opacity", path + ".opacity", em(5));
    if (under == MapKind::Heights) metres(parts, of);
    if (under == MapKind::Colours && of.layer->operation == LayerOperation::Replace) swatch(parts, of);
    if (under != MapKind::Heights || of.layer->kind != LayerKind::Path) {
        beside(boxWide("invert"));
        flag(parts, path + ".invert", "invert");
    }
    beside(buttonWide("Preview"));
    if (ui::button(path + "/Preview", 0, brushes.preview == path))
        brushes.preview = brushes.preview == path ? "" : path;
    ui::tooltip("Shows in the viewport how much of the layer there is where.");
    order(parts, path);
}

void addButtons(const FieldParts& parts, const std::string& map) {
    for (size_t i = 0; i < kLayerKinds.size(); ++i) {
        const std::string label = fmt::format("Add {}", kLayerKinds[i]);
        if (i > 0) beside(buttonWide(label.c_str()), 3);
        if (ui::button(label))
            deferEdit(parts, [&doc = parts.doc, map, i] { return addLayer(doc, map, static_cast<LayerKind>(i)); });
        ui::tooltip(layerKindRows()[i].help);
    }
}

// Of many layers only those in sight are built; another leaves the room that it took when it was.
template <class Build>
void inSight(const std::string& path, size_t layers, const Build& build) {
    constexpr size_t kMany = 8;
    float& height = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID((path + "/height").c_str()), 0);
    if (layers > kMany && height > 0 && !ImGui::IsRectVisible({ImGui::GetContentRegionAvail().x, height}))
        return ImGui::Dummy({1, height});
    const float top = ImGui::GetCursorPosY();
    build();
    height = ImGui::GetCursorPosY() - top - ImGui::GetStyle().ItemSpacing.y;
}

// Who flattens to a height that is seen, or digs, must know that layers add theirs to it.
void sculptedBelow() {
    ImGui::PushTextWrapPos(0);
    ui::coloredText(ui::kDimText, kSculptsBelow);
    ImGui::PopTextWrapPos();
    ui::record("Below", ui::Kind::Label, kSculptsBelow);
}

void noLayersOver(const std::string& map) {
    const std::string text =
        ui::inWords(map) + " holds directions or pushes: layers lie over amounts, colours and heights.";
    ui::coloredText(ui::kDimText, text.c_str());
    ui::record("Note", ui::Kind::Label, text);
}

}  // namespace

void drawLayers(const FieldParts& parts, BrushBook& brushes, LayerView& view, const std::vector<LayerNote>& notes) {
    const Document& doc = parts.doc;
    const std::optional<ConstFieldRef> chosen = chosenMap(doc, brushes);
    if (!chosen) return ImGui::TextDisabled("The brush is on no map.");
    const std::string map = stackedMap(doc.project(), chosen->path);
    const MapKind under = kindUnder(doc, map);
    const bool heights = under == MapKind::Heights;
    if (!heights && !layeredKind(under)) return noLayersOver(map);
    addButtons(parts, map);
    ImGui::BeginChild("layers");
    const std::vector<LayerOf> layers = layersOver(doc.project(), map);
    for (auto of = layers.rbegin(); of != layers.rend(); ++of)
        inSight(of->path, layers.size(), [&] {
            layer(parts, brushes, *of, under);
            note(notes, of->path);
            if (of->layer->kind == LayerKind::Rule)
                masks(parts, *of);
            else if (of->layer->kind == LayerKind::Path)
                alongPath(parts, *of);
            else
                ownMap(parts, brushes, *of, view);
        });
    if (heights && !layers.empty() && brushes.map == map) sculptedBelow();
    if (ui::button("Paint the map itself", 0, brushes.map == map)) selectMap(doc, brushes, map);
    ui::tooltip("The brush paints below all layers, on " + map);
    const std::string words = ui::inWords(map);
    beside(wide(words.c_str()));
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, words.c_str());
    ImGui::EndChild();
}

}  // namespace sward
