// What to set so that a scene no longer asks for a feature: a table of rows, feature -> component.field -> value.
// What a scene is made of (its ground, its grass, by which tiers a technique draws it) has no row: without it there is
// another scene. Maps that are dropped take the layers over them along, which are muted; what paths lay over maps is
// set to nothing. Does not: draw, nor know a document (editor/model/effect_edits.h).
#pragma once
#include <string>
#include <vector>

#include "core/error.h"
#include "scene/project.h"

namespace sward {

// One thing to set.
struct SwitchStep {
    std::string entity;
    const ComponentRow* component = nullptr;
    std::string field;  // from the component on: "species[lawn].gloss"; empty: the component is removed
    std::string value;  // as setFieldText reads it; of a map "": none
    // "haze.Fog.visibility", or "pond.Water" of a component that goes.
    std::string path() const;
    // "haze.Fog.visibility = inf", "lawn.GrassField.vegetation = none", "without pond.Water".
    std::string told() const;
};

// Whether the table has a row of this feature.
bool canBeLeftOut(Feature feature);
// What to set so that the project no longer asks for it; empty if it does not, or if there is no row. `drawn`: the
// project as it is drawn (world/drawn_project.h), which may have maps that are not painted.
std::vector<SwitchStep> stepsWithout(const Project& painted, const Project& drawn, const Tables& tables,
                                     Feature feature);
// Sets them; settings that are not there come as components with their defaults first. Usage error: as setFieldText.
Status takeSteps(Project& project, const Tables& tables, const std::vector<SwitchStep>& steps);

}  // namespace sward
