// Kinds of grass to begin with: a row each, with all that a species says of how it looks. And what is done with whole
// species of a field: added, dressed, copied; each call is one undo step.
// Does not: paint where they grow. A new species grows nowhere until its density is painted, a copy where its original
// does.
#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "model/document.h"

namespace sward {

struct SpeciesPreset {
    const char* name;   // of the species, and of its row
    const char* title;  // for people
    const char* help;
    const char* image;  // a file of presetFolder() for Species::texture; null: the program's own blade
    Species (*make)();  // its name and texture are set by whoever takes it
};
std::span<const SpeciesPreset> speciesPresets();
// Null if there is none of this name.
const SpeciesPreset* findPreset(const std::string& name);
// Where the presets' images lie.
std::filesystem::path presetFolder();
// As it looks, its texture relative to presetFolder().
Species speciesOf(const SpeciesPreset& preset);

// Another species of a field, named as the preset or with a number behind it; its image is copied into the project.
// The new one's name. Usage error: there is no such field, or it has as many as there may be.
Result<std::string> addPreset(Document& document, const std::string& entity, const SpeciesPreset& preset);
// All but the name, where it grows and how often that repeats becomes the preset's. Usage error as above.
Status applyPreset(Document& document, const std::string& entity, const std::string& species,
                   const SpeciesPreset& preset);
// A copy behind the last one, with the same density map until one of them is painted. Its name.
Result<std::string> duplicateSpecies(Document& document, const std::string& entity, const std::string& species);

}  // namespace sward
