// What a fit turns: techniques of grass or of forests as one kind of list, each with its knobs and the settings that
// they stand for. Does not: search or measure (fit.h). Pure.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "cost/cost_settings.h"
#include "scene/forest_technique.h"
#include "scene/technique.h"

namespace sward {

// One row of either table; the other is null.
struct FitTechnique {
    const TechniqueRow* grass = nullptr;
    const ForestTechniqueRow* forest = nullptr;
    // That of the row which is there.
    const char* name() const { return grass ? grass->name : forest->name; }
    std::span<const KnobRow> knobs() const { return grass ? grass->knobs : forest->knobs; }
};
// Those with knobs, the project's own first: of its grass, or, where it has none or kEveryForestTechnique is asked for,
// of its forests; one alone where it is named. Usage error: no such technique, or one without knobs. Unsound: the
// project has none of what it draws.
Result<std::vector<FitTechnique>> techniquesToFit(const Project& project, const Tables& tables,
                                                  const std::string& asked);
// What knobs stand for, in the order of their rows: for each field of grass, or each forest, around its own values.
CostSetting turnedSetting(const Project& project, const FitTechnique& technique, std::span<const double> knobs);

}  // namespace sward
