#include "model/species_presets.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/resources.h"
#include "model/assets.h"
#include "model/new_map.h"
#include "model/one_step.h"
#include "scene/field_limits.h"

namespace sward {
namespace {

constexpr SpeciesPreset kPresets[] = {
    {"pitch", "Pitch", "Ryegrass as on a football ground: 3 cm, mown and very dense.", nullptr,
     [] {
         Species s;
         s.bladesPerM2 = 45000, s.height = 0.032f, s.heightVariation = 0.2f, s.width = 0.0033f, s.bend = 0.25f;
         s.leanDeg = 20, s.leanVariationDeg = 10, s.segments = 2, s.smoothness = 3;
         s.clumpSize = 0.3f, s.clumpStrength = 0.25f, s.translucency = 0.5f, s.gloss = 0.45f;
         s.rootColor = {0.04f, 0.06f, 0.018f}, s.midColor = {0.05f, 0.12f, 0.028f}, s.tipColor = {0.075f, 0.15f, 0.04f};
         return s;
     }},
    {"lawn", "Lawn", "A garden's grass a week after mowing: 7 cm, dense.", nullptr,
     [] {
         Species s;
         s.bladesPerM2 = 12000, s.height = 0.075f, s.heightVariation = 0.25f, s.width = 0.0037f, s.bend = 0.45f;
         s.leanDeg = 10, s.leanVariationDeg = 13, s.segments = 3, s.smoothness = 4;
         s.clumpSize = 0.35f, s.clumpStrength = 0.5f, s.translucency = 0.6f, s.gloss = 0.6f;
         return s;
     }},
    {"meadow", "Meadow", "Uncut grass in early summer: knee-high, in clumps.", nullptr,
     [] {
         Species s;
         s.bladesPerM2 = 2400, s.height = 0.42f, s.heightVariation = 0.35f, s.width = 0.006f, s.bend = 0.65f;
         s.leanDeg = 11, s.leanVariationDeg = 16, s.segments = 4, s.smoothness = 6;
         s.clumpSize = 0.45f, s.clumpStrength = 0.6f, s.translucency = 0.8f, s.gloss = 0.4f;
         s.rootColor = {0.05f, 0.062f, 0.02f}, s.midColor = {0.075f, 0.125f, 0.034f},
         s.tipColor = {0.15f, 0.17f, 0.06f};
         return s;
     }},
    {"wheat", "Wheat", "Ripe wheat with ears: 85 cm, upright.", "ear.png",
     [] {
         Species s;
         s.bladesPerM2 = 900, s.height = 0.85f, s.heightVariation = 0.12f, s.width = 0.024f, s.bend = 0.35f;
         s.leanDeg = 9, s.leanVariationDeg = 8, s.segments = 5, s.smoothness = 6;
         s.clumpSize = 0.8f, s.clumpStrength = 0.5f, s.translucency = 0.5f, s.gloss = 0.3f, s.hueVariationDeg = 3;
         s.rootColor = {0.16f, 0.12f, 0.05f}, s.midColor = {0.31f, 0.23f, 0.085f}, s.tipColor = {0.42f, 0.32f, 0.14f};
         return s;
     }},
    {"reed", "Reed", "Reed at a pond's edge: 1.7 m, stiff and broad-leaved.", nullptr,
     [] {
         Species s;
         s.bladesPerM2 = 160, s.height = 1.7f, s.heightVariation = 0.25f, s.width = 0.022f, s.bend = 0.4f;
         s.leanDeg = 5, s.leanVariationDeg = 9, s.stiffness = 2, s.segments = 6, s.smoothness = 8;
         s.clumpSize = 0.9f, s.clumpStrength = 0.5f, s.translucency = 0.7f, s.gloss = 0.6f;
         s.rootColor = {0.09f, 0.08f, 0.035f}, s.midColor = {0.075f, 0.125f, 0.035f},
         s.tipColor = {0.16f, 0.175f, 0.07f};
         return s;
     }},
    {"straw", "Straw", "Dry grass in late summer: 40 cm, pale and tangled.", nullptr,
     [] {
         Species s;
         s.bladesPerM2 = 1800, s.height = 0.4f, s.heightVariation = 0.4f, s.width = 0.0045f, s.bend = 0.8f;
         s.leanDeg = 16, s.leanVariationDeg = 26, s.segments = 4, s.smoothness = 6;
         s.clumpSize = 0.5f, s.clumpStrength = 0.7f, s.translucency = 0.5f, s.hueVariationDeg = 5;
         s.rootColor = {0.16f, 0.12f, 0.06f}, s.midColor = {0.3f, 0.235f, 0.11f}, s.tipColor = {0.42f, 0.345f, 0.19f};
         return s;
     }},
    {"heather", "Heather", "Heath in bloom: 30 cm, woody, in purple spikes.", "spike.png",
     [] {
         Species s;
         s.bladesPerM2 = 2600, s.height = 0.3f, s.heightVariation = 0.3f, s.width = 0.017f, s.bend = 0.25f;
         s.leanDeg = 14, s.leanVariationDeg = 20, s.stiffness = 3, s.segments = 3, s.smoothness = 4;
         s.clumpSize = 0.6f, s.clumpStrength = 0.75f, s.translucency = 0.3f;
         s.hueVariationDeg = 12, s.lightnessVariation = 0.25f;
         s.rootColor = {0.07f, 0.055f, 0.03f}, s.midColor = {0.075f, 0.09f, 0.04f}, s.tipColor = {0.36f, 0.13f, 0.33f};
         return s;
     }},
};

const GrassField* fieldOf(const Document& doc, const std::string& entity) {
    const Entity e = doc.isOpen() ? findEntity(doc.project(), entity) : kNoEntity;
    return e == kNoEntity ? nullptr : doc.project().registry.get<GrassField>(e);
}

Error noField(const std::string& entity) {
    return usage(fmt::format("\"{}\" is no field of grass", entity), "choose an entity with a GrassField");
}
Error noSpecies(const std::string& entity, const std::string& species) {
    return usage(fmt::format("{} has no species \"{}\"", entity, species));
}

Species* findSpecies(GrassField& field, const std::string& name) {
    const auto at =
        std::find_if(field.species.begin(), field.species.end(), [&](const Species& s) { return s.name == name; });
    return at == field.species.end() ? nullptr : &*at;
}

// "lawn", "lawn2" ...
std::string freeName(GrassField& field, const std::string& like) {
    const std::string stem = like.substr(0, like.find_last_not_of("0123456789") + 1);
    std::string name = like;
    for (int n = 2; findSpecies(field, name); ++n) name = fmt::format("{}{}", stem, n);
    return name;
}

Status put(Document& doc, const std::string& entity, const GrassField& field, const std::string& label) {
    return inOneStep(doc, label, [&] {
        return doc.assignComponent(entity, *findComponent(doc.tables().components, "GrassField"), &field);
    });
}

Result<GrassField> withRoom(const Document& doc, const std::string& entity) {
    const GrassField* field = fieldOf(doc, entity);
    if (!field) return noField(entity);
    if (field->species.size() >= kMaxSpecies)
        return usage(fmt::format("{} has {} species, the most that a field may have", entity, kMaxSpecies),
                     "add another field, or remove one");
    return *field;
}

// As it looks in this project, into which its image comes.
Result<Species> dressed(const Document& doc, const SpeciesPreset& preset) {
    Species s = preset.make();
    s.name = preset.name;
    if (!preset.image) return s;
    const Result<std::string> image = importImage(doc.project().dir, presetFolder() / preset.image);
    if (!image) return image.error();
    s.texture = *image;
    return s;
}

}  // namespace

std::span<const SpeciesPreset> speciesPresets() { return kPresets; }

const SpeciesPreset* findPreset(const std::string& name) {
    for (const SpeciesPreset& p : kPresets)
        if (name == p.name) return &p;
    return nullptr;
}

std::filesystem::path presetFolder() { return resource("projects/presets"); }

Species speciesOf(const SpeciesPreset& preset) {
    Species s = preset.make();
    s.name = preset.name;
    if (preset.image) s.texture = preset.image;
    return s;
}

Result<std::string> addPreset(Document& doc, const std::string& entity, const SpeciesPreset& preset) {
    Result<GrassField> field = withRoom(doc, entity);
    if (!field) return field.error();
    Result<Species> species = dressed(doc, preset);
    if (!species) return species.error();
    species->name = freeName(*field, preset.name);
    const std::string name = species->name, path = fmt::format("{}.GrassField.species[{}].density", entity, name);
    field->species.push_back(std::move(*species));
    const Status done = inOneStep(doc, fmt::format("add {} to {}", name, entity), [&]() -> Status {
        if (Status s = put(doc, entity, *field, "add"); !s) return s;
        const Result<ConstFieldRef> map = findField(doc.project(), doc.tables().components, path);
        return map ? doc.setMap(path, Map(newMapInfo(doc.project(), *map)), "new map") : Status{map.error()};
    });
    return done ? Result<std::string>(name) : done.error();
}

Status applyPreset(Document& doc, const std::string& entity, const std::string& name, const SpeciesPreset& preset) {
    const GrassField* now = fieldOf(doc, entity);
    if (!now) return noField(entity);
    GrassField field = *now;
    Species* species = findSpecies(field, name);
    if (!species) return noSpecies(entity, name);
    Result<Species> looks = dressed(doc, preset);
    if (!looks) return looks.error();
    looks->name = name;
    looks->density = species->density;
    looks->densityTiling = species->densityTiling;
    *species = std::move(*looks);
    return put(doc, entity, field, fmt::format("{} looks like {}", name, preset.name));
}

Result<std::string> duplicateSpecies(Document& doc, const std::string& entity, const std::string& name) {
    Result<GrassField> field = withRoom(doc, entity);
    if (!field) return field.error();
    const Species* species = findSpecies(*field, name);
    if (!species) return noSpecies(entity, name);
    Species copy = *species;
    copy.name = freeName(*field, name);
    const std::string made = copy.name;
    field->species.push_back(std::move(copy));
    const Status done = put(doc, entity, *field, fmt::format("duplicate {}", name));
    return done ? Result<std::string>(made) : done.error();
}

}  // namespace sward
