// What a sweep tries: techniques, and for each a list of settings as NAME=VALUE. Does not: draw or measure (cost.h).
#pragma once
#include <string>
#include <vector>

#include "frame/renderer.h"
#include "scene/project.h"
#include "scene/technique.h"

namespace sward {

// One value by name: of a field of the technique's settings or of GrassField ("maxGeom=6"), of Forest ("meshesTo=40"),
// of the view ("msaa=1": so many samples in one frame; "detail=0.5"), or of the scene's Antialias
// ("antialias=temporal"). It is for every entity that takes the setting, or for the one that is named before a dot
// ("lawn.maxGeom=6").
struct SettingValue {
    std::string entity;  // empty: every one
    std::string name, value;
    // Whether the entity called `e` takes the value.
    bool isFor(const std::string& e) const { return entity.empty() || entity == e; }
};
// Usage error: the text has no '='.
Result<SettingValue> settingValue(const std::string& text);
// Settings that each of some entities has in its own way, as one: what all have in common is for every one, the rest
// for each by its name. Equally many values for each.
SettingValues mergedValues(const std::vector<std::pair<std::string, SettingValues>>& byEntity);

// What the settings that a project ships with are called.
inline constexpr const char* kAsItIs = "as it is";

struct CostSetting {
    std::string technique;  // a row of the table, or of forestTechniques(); empty: the fields' own
    std::vector<std::string> values;
    std::string text() const;  // "maxGeom=6 msaa=4"; kAsItIs without values
};

// The techniques of the project's fields, each once: "hybrid", or "hybrid+raytraced"; of its forests, if it has no
// grass.
std::string ownTechniques(const Project& project);
// What all of forestTechniques() together are called where one technique is named.
inline constexpr const char* kEveryForestTechnique = "forest";
// All settings for a project's grass and forests: first the project's own, without values (and, where its fields differ
// in it, without a technique); then those around each field's own in the order of the techniques' table
// (TechniqueRow::sweep), then those of its forests (forestTechniques); of one technique if it is named. Settings of one
// leave the other as it is. Where the project's frames add up (Antialias), they do in all of them but those that ask
// for another number of samples, "msaa=4" once for each technique. Usage error: no such technique. Unsound: the project
// has none of what it draws.
Result<std::vector<CostSetting>> costSettings(const Project& project, const Tables& tables,
                                              const std::string& technique = {});
// Whether `a` draws all that `b` draws and perhaps more: no distance, share of detail or number of samples is smaller,
// all else is equal.
bool drawsNoLess(const CostSetting& a, const CostSetting& b);
// The entities that take a technique's settings: those with forests, or those with grass.
std::vector<std::string> entitiesOf(const Project& project, const std::string& technique);
// The PATH of the field that holds a technique's name, and that name as the field has it.
std::pair<std::string, std::string> techniqueField(const std::string& entity, const std::string& technique);
// Names that costSettings takes, of grass and of forests, "a, b, c".
std::string sweptNames(const Tables& tables);
// The PATH of a setting by its name alone: of the forest's, of the technique's settings, else of the GrassField.
std::string settingPath(const Tables& tables, const std::string& entity, const std::string& technique,
                        const std::string& name);
// Makes it the project's (each field of grass, or each forest) and the view's. Usage error: a name or value that does
// not exist.
Status applySetting(Project& project, const Tables& tables, const CostSetting& setting, ViewSettings& view);

}  // namespace sward
