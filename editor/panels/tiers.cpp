// The hybrid field's distances, how its tiers look and what they cost; the rings in the viewport are viewport_rings.h.
// A drag stops at the neighbouring distances; a typed one pushes them (tools/tiers.h).
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <functional>

#include "app/viewport.h"
#include "panels/field_edit.h"
#include "panels/panels.h"
#include "panels/viewport_rings.h"
#include "ui/theme.h"

namespace sward {
namespace {

// A field of a component on an entity.
ConstFieldRef fieldNamed(const Document& doc, const std::string& entity, const char* component, const char* name) {
    const Result<ConstFieldRef> f =
        findField(doc.project(), doc.tables().components, fmt::format("{}.{}.{}", entity, component, name));
    CHECK(bool(f));
    return *f;
}

// A refusal has no line of its own here: the frame is red, and the tooltip says it.
void showRefusal(const char* label, const char* help) {
    const std::string* error = ui::errorAt(label);
    ui::tooltip(error ? *error : help);
    if (!error) return;
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddRect(low, high, ui::kErrorText, 3);
}

// Once this frame's widgets are built, unless the field is gone by then.
void deferAll(const TierParts& parts, const std::string& entity,
              std::function<TierDistances(const TierDistances&)> change) {
    parts.edit.edits.deferred.push_back(
        [p = parts.edit, pixels = parts.pixelsPerMetre, entity, change = std::move(change)] {
            const std::optional<FieldEntity> field = tierField(p.doc, entity);
            if (!field) return;
            p.doc.beginGroup("set tiers of " + entity);
            setTiers(p.doc, p.messages, entity, pixels, change(tiersShown(*field, pixels)));
            p.doc.endGroup();
        });
}

void typeDistance(const TierParts& parts, const std::string& entity, size_t i, const std::string& text,
                  const ui::NumberSpec& spec) {
    std::string error;
    const std::optional<double> value = ui::parseNumber(text, spec, error);
    ui::setError(kTierFields[i], error);
    if (!value) return;
    deferAll(parts, entity, [i, v = *value](const TierDistances& now) { return pushedTiers(now, i, v); });
}

void distance(const TierParts& parts, const std::string& entity, size_t i, const TierDistances& now) {
    const char* name = kTierFields[i];
    const ConstFieldRef field = fieldNamed(parts.edit.doc, entity, "HybridTiers", name);
    const std::string help =
        fmt::format("{}\n{}\nDragged, it stops at its neighbours; typed, it pushes them.", field.row->help, field.path);
    ImGui::TableNextColumn();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float size = ImGui::GetTextLineHeight() * 0.7f, y = at.y + (ImGui::GetFrameHeight() - size) / 2;
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, y}, {at.x + size, y + size}, kTierColors[i], 2);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + size + 6);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(kTierTitles[i]);
    ui::tooltip(help);
    ImGui::TableNextColumn();
    ImGui::SetNextItemWidth(-1);
    const ui::NumberSpec spec = numberSpec(*field.row);
    double value = now[i];
    ui::NumberEdit edit = ui::number(name, value, spec);
    showRefusal(name, help.c_str());
    if (edit.typed) return typeDistance(parts, entity, i, *edit.typed, spec);
    if (!edit.changed) return;
    holdEdit(parts.edit, field.path);
    deferAll(parts, entity, [i, value](const TierDistances& t) {
        TierDistances dragged = t;
        dragged[i] = stoppedTier(t, i, value);
        return dragged;
    });
}

bool beginForm(const char* id, float left) {
    if (!ImGui::BeginTable(id, 2)) return false;
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, ImGui::GetFontSize() * left);
    ImGui::TableSetupColumn("value");
    return true;
}

void chooseField(const Document& doc, std::string& chosenField, std::string& entity) {
    std::vector<std::string> names;
    for (const auto& [name, e] : doc.project().entities)
        if (doc.project().registry.get<GrassField>(e)) names.push_back(name);
    if (names.size() < 2) return;
    int chosen = static_cast<int>(std::find(names.begin(), names.end(), entity) - names.begin());
    caption("Field", "Whose tiers these are.");
    if (ui::combo("Field", names, chosen)) chosenField = entity = names[static_cast<size_t>(chosen)];
}

void numberOf(const FieldParts& parts, const std::string& entity, const char* component, const char* name,
              const char* title) {
    const ConstFieldRef field = fieldNamed(parts.doc, entity, component, name);
    double value = field.row->type == FieldType::Int ? *static_cast<const int*>(field.value)
                                                     : static_cast<double>(*static_cast<const float*>(field.value));
    caption(title, field.row->help);
    const ui::NumberEdit edit = ui::number(name, value, numberSpec(*field.row));
    showRefusal(name, field.row->help);
    takeEdit(parts, field, edit, value, std::string("Tiers/") + name);
}

// What is shown stays as it is.
void follow(const TierParts& parts, const std::string& entity, TiersBy by) {
    parts.edit.edits.deferred.push_back([p = parts.edit, pixels = parts.pixelsPerMetre, entity, by] {
        const std::optional<FieldEntity> field = tierField(p.doc, entity);
        if (!field) return;
        const TierDistances now = tiersShown(*field, pixels);
        const BladeSize blades = bladeSize(field->grows);
        p.doc.beginGroup(fmt::format("tiers of {} by {}", entity, kTiersBy[by]));
        accept(p.messages, p.doc.setField(entity + ".HybridTiers.tiersBy", std::string(kTiersBy[by])));
        editTiers(p.doc, p.messages, entity, tierEdits(now, by, blades, pixels));
        p.doc.endGroup();
    });
}

void followed(const TierParts& parts, const std::string& entity) {
    const ConstFieldRef field = fieldNamed(parts.edit.doc, entity, "HybridTiers", "tiersBy");
    int chosen = static_cast<int>(*static_cast<const TiersBy*>(field.value));
    caption("Follow", field.row->help);
    if (ui::combo("tiersBy", std::vector<std::string>(kTiersBy.begin(), kTiersBy.end()), chosen))
        follow(parts, entity, static_cast<TiersBy>(chosen));
}

// By pixels: how wide and how high grass is where blades and slices end.
void pixels(const FieldParts& parts, const std::string& entity, TiersBy by) {
    if (by == TiersBy::Metres || !beginForm("pixels", 10)) return;
    numberOf(parts, entity, "HybridTiers", "bladePixels", "Blades end at width");
    numberOf(parts, entity, "HybridTiers", "slicePixels", "Slices end at height");
    ImGui::EndTable();
}

void distances(const TierParts& parts, const std::string& entity, const TierDistances& now) {
    if (!beginForm("distances", 8.6f)) return;
    for (size_t i = 0; i < kTierCount; ++i) distance(parts, entity, i, now);
    ImGui::EndTable();
}

void looks(const TierParts& p, std::string& chosenField, std::string& entity) {
    const FieldParts& parts = p.edit;
    if (!beginForm("looks", 5)) return;
    chooseField(parts.doc, chosenField, entity);
    const ConstFieldRef technique = fieldNamed(parts.doc, entity, "GrassField", "technique");
    const std::vector<std::string> items(technique.row->options.begin(), technique.row->options.end());
    const auto now = std::find(items.begin(), items.end(), *static_cast<const std::string*>(technique.value));
    int chosen = static_cast<int>(now - items.begin());
    caption("Technique", technique.row->help);
    if (ui::combo("technique", items, chosen))
        setField(parts, technique.path, items[static_cast<size_t>(chosen)], "Tiers/technique");
    numberOf(parts, entity, "GrassDrawing", "fade", "Fade");
    numberOf(parts, entity, "GrassSlices", "slices", "Slices");
    followed(p, entity);
    ImGui::EndTable();
}

void toggles(TierView& tiers, ViewState& view) {
    bool colours = view.mode == ViewMode::Tiers;
    if (ui::checkbox("False colours", colours)) view.mode = colours ? ViewMode::Tiers : ViewMode::Final;
    ui::tooltip(
        "Red: blades by themselves. Blue: vertical slices. Green: the horizontal slice and the ground's colour.");
    ImGui::SameLine(0, 14);
    ui::checkbox("Rings", tiers.rings);
    ui::tooltip("The distances as rings on the ground. Drag them with the mouse; Escape lets go.");
    ImGui::SameLine(0, 14);
    bool pinned = tiers.pin.has_value();
    if (ui::checkbox("Pin rings", pinned)) tiers.pin = pinned ? std::optional(view.camera.eye) : std::nullopt;
    ui::tooltip(
        "Leaves the rings around where the eye is now, so that you can fly off and look at them.\n"
        "The picture's own tiers stay around the eye.");
}

// Fields that only some renderers count.
template <class Stats>
std::vector<std::pair<const char*, uint64_t>> tierCounts(const Stats& s) {
    std::vector<std::pair<const char*, uint64_t>> counts{{"Blades", s.bladesGeometry}};
    if constexpr (requires { s.sliceQuads; }) counts.emplace_back("Slice quads", s.sliceQuads);
    if constexpr (requires { s.macroCells; }) counts.emplace_back("Macro-cells", s.macroCells);
    return counts;
}

void counts(const FrameStats& s) {
    bool first = true;
    for (const auto& [name, n] : tierCounts(s)) {
        const std::string number = counted(n);
        if (!first) ui::beside(ImGui::CalcTextSize(name).x + 5 + ImGui::CalcTextSize(number.c_str()).x, 14);
        first = false;
        ui::coloredText(ui::kDimText, name);
        ImGui::SameLine(0, 5);
        ImGui::TextUnformatted(number.c_str());
        ui::record(name, ui::Kind::Label, fmt::format("{}", n));
    }
}

// "geometry 3.10 ms   slices 1.20 ms", of the passes that draw grass.
void costs(ViewCounts& view, bool measured) {
    std::string line;
    for (const PassStats& p : view.stats.passes)
        if (measured && p.name.starts_with("grass/"))
            line +=
                fmt::format("{}{} {:.2f} ms", line.empty() ? "" : "   ", p.name.substr(p.name.rfind('/') + 1), p.ms);
    ui::checkbox("Measure", view.measure);
    ui::tooltip("Times each pass, as in the profiler. A frame takes longer then.");
    ImGui::SameLine(0, 10);
    ui::coloredText(ui::kDimText, !view.measure  ? "ms of the grass passes"
                                  : line.empty() ? "no grass pass ran"
                                                 : line.c_str());
    ui::record("Passes", ui::Kind::Label, line);
}

void orderHint(const TierParts& parts, const std::string& entity, const TierDistances& now) {
    if (tiersInOrder(now)) return;
    if (ui::button("Put in order", 0, true)) deferAll(parts, entity, orderedTiers);
    ImGui::SameLine(0, 8);
    ui::coloredText(ui::kWarningText, "near and far are swapped");
}

}  // namespace

void drawTiers(const TierParts& parts, TierView& tiers, const std::string& selected, ViewState& view,
               ViewCounts& viewCounts, bool measured) {
    std::string entity = tierEntity(parts.edit.doc, tiers.field, selected);
    const std::optional<FieldEntity> field = tierField(parts.edit.doc, entity);
    if (!field) {
        ImGui::TextDisabled("No entity has a GrassField.");
        return;
    }
    const TierDistances now = tiersShown(*field, parts.pixelsPerMetre);
    ImGui::BeginChild("tiers");
    const float ems = ImGui::GetContentRegionAvail().x / ImGui::GetFontSize();
    const int columns = ems < 28 ? 1 : ems < 46 ? 2 : 3;  // what does not fit beside goes below
    if (ImGui::BeginTable("columns", columns, ImGuiTableFlags_SizingStretchProp)) {
        for (const float share : {1.15f, 0.8f, 1.35f})
            if (columns == 3) ImGui::TableSetupColumn("", 0, share);
        ImGui::TableNextColumn();
        distances(parts, entity, now);
        ImGui::TableNextColumn();
        looks(parts, tiers.field, entity);
        ImGui::TableNextColumn();
        toggles(tiers, view);
        counts(viewCounts.stats);
        costs(viewCounts, measured);
        pixels(parts.edit, entity, field->settings<HybridTiers>().tiersBy);
        orderHint(parts, entity, now);
        ImGui::EndTable();
    }
    ImGui::EndChild();
}

}  // namespace sward
