#include "cost/fit_technique.h"

#include <algorithm>

namespace sward {
namespace {

std::vector<FitTechnique> withKnobs(const Tables& tables, bool forests) {
    std::vector<FitTechnique> out;
    if (forests)
        for (const ForestTechniqueRow& row : forestTechniques()) out.push_back({nullptr, &row});
    else
        for (const TechniqueRow& row : tables.techniques) out.push_back({&row, nullptr});
    std::erase_if(out, [](const FitTechnique& t) { return t.knobs().empty(); });
    return out;
}
// Of the project's first field, or its first forest.
std::string ownName(const Project& project, bool forests) {
    if (forests) return techniqueOf(*growingForests(project).front().second).name;
    return fieldsOf(project).front().second.grows.technique;
}

}  // namespace

Result<std::vector<FitTechnique>> techniquesToFit(const Project& project, const Tables& tables,
                                                  const std::string& asked) {
    const bool hasGrass = !fieldsOf(project).empty(), hasForests = !growingForests(project).empty();
    const bool isForests =
        asked == kEveryForestTechnique || findForestTechnique(asked) || (asked.empty() && !hasGrass && hasForests);
    const bool all = asked.empty() || asked == kEveryForestTechnique;
    std::vector<FitTechnique> out = withKnobs(tables, isForests);
    const auto place = [&](const std::string& name) {
        return std::find_if(out.begin(), out.end(), [&](const FitTechnique& t) { return name == t.name(); });
    };
    if (!all && place(asked) == out.end())
        return usage("there is no technique \"" + asked + "\" that has anything to turn", sweptNames(tables));
    if (isForests && !hasForests) return unsound("the project has no forest", "add a Forest").at(project.dir);
    if (!isForests && !hasGrass) return unsound("the project has no grass", "add a GrassField").at(project.dir);
    if (!all) return std::vector<FitTechnique>{*place(asked)};
    if (const auto own = place(ownName(project, isForests)); own != out.end()) std::rotate(out.begin(), own, own + 1);
    if (out.empty()) return failed("no technique has anything to turn");
    return out;
}

CostSetting turnedSetting(const Project& project, const FitTechnique& technique, std::span<const double> knobs) {
    std::vector<std::pair<std::string, SettingValues>> each;
    if (technique.forest)
        for (const auto& [name, forest] : growingForests(project))
            each.push_back({name, technique.forest->turned(*forest, knobs)});
    else
        for (const auto& [name, field] : fieldsOf(project))
            each.push_back({name, technique.grass->turned(field, knobs)});
    return {technique.name(), mergedValues(each)};
}

}  // namespace sward
