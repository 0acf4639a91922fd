// The species of a field and the presets, as pictures: add a preset as a new species, give its looks to the chosen one,
// copy a species. The chosen species is the one whose density the brush paints.
#include <imgui.h>

#include <algorithm>
#include <functional>

#include "app/thumbnails.h"
#include "model/species_presets.h"
#include "panels/field_edit.h"
#include "panels/panels.h"
#include "tools/brush_target.h"
#include "tools/species_palette.h"
#include "ui/theme.h"

namespace sward {
namespace {

struct SpeciesParts {
    const FieldParts& fields;
    SpeciesPalette& palette;
    BrushBook& brushes;
};

std::string densityOf(const std::string& field, const std::string& species) {
    return field + ".GrassField.species[" + species + "].density";
}

ui::TileSize speciesTile() { return {ImGui::GetFontSize() * 5, ImGui::GetFontSize() * 5}; }

// Chosen here, and painted from now on.
void take(const SpeciesParts& p, const std::string& species) {
    p.palette.species = species;
    selectMap(p.fields.doc, p.brushes, densityOf(p.palette.field, species));
}

// Runs an edit that makes a species, which is chosen then.
void make(const SpeciesParts& p, const std::function<Result<std::string>()>& edit) {
    p.fields.edits.deferred.push_back([parts = p.fields, &palette = p.palette, &brushes = p.brushes, edit] {
        const Result<std::string> made = edit();
        if (!made) return showError(parts.messages, made.error());
        take({parts, palette, brushes}, *made);
        say(parts.messages, "new: " + *made + "; paint where it grows");
    });
}

void ownSpecies(const SpeciesParts& p, const GrassField& field) {
    const ui::Scope scope("Own");
    const std::filesystem::path& dir = p.fields.doc.project().dir;
    for (const Species& s : field.species) {
        ui::nextTile(speciesTile(), &s == &field.species.front());
        const Thumbnail& picture = speciesThumbnail(*p.fields.thumbnails, s, dir);
        if (ui::tile(s.name, s.name, shownOf(picture), speciesTile(), p.palette.species == s.name)) take(p, s.name);
        ui::tooltip(picture.error.empty() ? s.name : picture.error);
    }
}

void presets(const SpeciesParts& p) {
    const ui::Scope scope("Presets");
    bool first = true;
    for (const SpeciesPreset& preset : speciesPresets()) {
        ui::nextTile(speciesTile(), std::exchange(first, false));
        const Thumbnail& picture = speciesThumbnail(*p.fields.thumbnails, speciesOf(preset), presetFolder());
        if (ui::tile(preset.name, preset.title, shownOf(picture), speciesTile(), p.palette.preset == preset.name))
            p.palette.preset = preset.name;
        ui::tooltip(picture.error.empty() ? preset.help : picture.error);
    }
}

void buttons(const SpeciesParts& p) {
    Document& doc = p.fields.doc;
    const SpeciesPreset* preset = findPreset(p.palette.preset);
    const std::string field = p.palette.field, species = p.palette.species;
    {
        const ui::Disabled none(!preset);
        if (ui::button("Add as New")) make(p, [&doc, field, preset] { return addPreset(doc, field, *preset); });
        ui::tooltip("Another species of this field that looks like the chosen preset. It grows where you paint it.");
        ImGui::SameLine(0, 6);
        const ui::Disabled unchosen(species.empty());
        if (ui::button("Apply to Species"))
            deferEdit(p.fields, [&doc, field, species, preset] { return applyPreset(doc, field, species, *preset); });
        ui::tooltip("The chosen species looks like the chosen preset, and grows where it grew.");
    }
    ImGui::SameLine(0, 6);
    const ui::Disabled unchosen(species.empty());
    if (ui::button("Duplicate")) make(p, [&doc, field, species] { return duplicateSpecies(doc, field, species); });
    ui::tooltip("A copy of the chosen species, which grows where that does until either is painted.");
}

const GrassField* fieldAt(const Project& p, const std::string& name) {
    const Entity e = findEntity(p, name);
    return e == kNoEntity ? nullptr : p.registry.get<GrassField>(e);
}

// The field that is chosen, else the one that the brush paints, else the first; and a species that it has.
const GrassField* followChoice(SpeciesPalette& palette, const Document& doc, const BrushBook& brushes,
                               const std::string& selected) {
    const Project& p = doc.project();
    const std::string painted = brushes.map.substr(0, brushes.map.find('.'));
    if (fieldAt(p, selected))
        palette.field = selected;
    else if (!fieldAt(p, palette.field))
        palette.field = fieldAt(p, painted) ? painted : entityOf(p, *firstOf<GrassField>(p));
    const GrassField* field = fieldAt(p, palette.field);
    for (const Species& s : field->species)
        if (brushes.map == densityOf(palette.field, s.name)) palette.species = s.name;
    const auto has = [&](const Species& s) { return s.name == palette.species; };
    if (std::none_of(field->species.begin(), field->species.end(), has))
        palette.species = field->species.empty() ? "" : field->species.front().name;
    return field;
}

}  // namespace

void drawSpecies(const FieldParts& fields, SpeciesPalette& palette, BrushBook& brushes, const std::string& selected) {
    if (!fields.doc.isOpen()) return ImGui::TextDisabled("No project is open.");
    if (!firstOf<GrassField>(fields.doc.project())) return ImGui::TextDisabled("There is no field of grass.");
    const GrassField& field = *followChoice(palette, fields.doc, brushes, selected);
    const SpeciesParts p{fields, palette, brushes};
    buttons(p);
    const std::string told = "species of " + palette.field + ", and presets below";
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (ImGui::GetItemRectMax().x + 14 + ImGui::CalcTextSize(told.c_str()).x < right) ImGui::SameLine(0, 14);
    ImGui::AlignTextToFramePadding();
    ui::coloredText(ui::kDimText, told.c_str());
    ImGui::BeginChild("species");
    ownSpecies(p, field);
    ImGui::Separator();
    presets(p);
    ImGui::EndChild();
}

}  // namespace sward
