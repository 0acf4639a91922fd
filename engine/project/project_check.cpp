// What `check` finds in a scene that loads: what other verbs would refuse, what does nothing, and what is surely not
// meant.
#include "project/map_health.h"
#include "project/project_files.h"
#include "project/project_json.h"
#include "scene/field_limits.h"
#include "scene/unique.h"
#include "world/drawn_project.h"

namespace sward {
namespace {

// The value of a PATH without list elements, in the tree that the project was read from; null if it is not written
// there.
const Json* valueOf(const Json& root, const std::string& entity, const char* component, const char* field) {
    const Json* at = root.find("entities");
    for (const std::string_view key : {std::string_view(entity), std::string_view(component), std::string_view(field)})
        if (at && !key.empty()) at = at->find(key);
    return at;
}

void checkPopulation(const SceneToCheck& s, CheckReport& report) {
    Status counted = checkUnique(s.project);
    if (counted) return;
    Error e = counted.error();
    if (const Json* at = valueOf(s.root, uniqueField(s.project), "GrassField", "population"))
        e.line = at->line, e.column = at->column;
    report.refused.push_back(std::move(e));
}

// More grass than a scene may have: the renderer refuses it, too.
void checkLimits(const SceneToCheck& s, CheckReport& report) {
    const std::optional<FieldFault> fault = brokenLimit(s.project);
    if (!fault) return;
    Error e = checkFields(s.project).error();
    const Json* component = valueOf(s.root, fault->entity, "GrassField", fault->field.c_str());
    if (component) e.line = component->line, e.column = component->column;
    report.refused.push_back(std::move(e));
}

std::string placeInFile(const SceneToCheck& s, const Json* at) {
    const std::string file = (s.project.dir / "project.json").string();
    return at ? fmt::format("{}:{}", file, at->line) : file;
}

// The value of a field such as "species[1].height" below a component's; null if it is not written there.
const Json* valueBelow(const Json* component, const std::string& field) {
    const Json* at = component;
    for (size_t i = 0; at && i < field.size();) {
        const size_t end = std::min(field.find_first_of(".[", i), field.size());
        const std::string key = field.substr(i, end - i);
        if (key.ends_with(']')) {
            const size_t n = std::stoul(key);
            at = n < at->array.size() ? &at->array[n] : nullptr;
        } else if (!key.empty()) {
            at = at->find(key);
        }
        i = end + 1;
    }
    return at;
}

void checkComponent(const SceneToCheck& s, const std::string& name, Entity e, const ComponentRow& row,
                    CheckReport& report) {
    if (!row.get(s.project.registry, e)) return;
    std::vector<ComponentFault> faults;
    if (row.check) row.check(s.project.registry, e, name + "." + row.name, faults);
    if (row.checkFiles && report.refused.empty())
        row.checkFiles(s.project, e, name + "." + row.name, report.refused, faults);
    for (ComponentFault& f : faults) {
        const Json* at = valueBelow(valueOf(s.root, name, row.name, ""), f.field);
        (f.withoutIt ? report.repaired : report.noticed).push_back({placeInFile(s, at), std::move(f.message)});
    }
}

}  // namespace

void checkScene(const SceneToCheck& given, CheckReport& report) {
    DrawnProject drawn;
    const SceneToCheck scene{drawn.of(given.project, given.rows), given.rows, given.root};
    for (const LayerNote& note : drawn.layerNotes())
        report.noticed.push_back({placeInFile(given, nullptr), note.layer + ": " + note.message});
    if (report.refused.empty())
        checkPopulation(scene, report);  // maps that could not be read say nothing of how many blades grow
    checkLimits(scene, report);
    for (const auto& [name, e] : scene.project.entities)
        for (const ComponentRow& row : scene.rows) checkComponent(scene, name, e, row, report);
    for (const MapFinding& found : mapFindings(given.project, given.rows))
        if (!found.meant)
            report.noticed.push_back(
                {placeInFile(given, nullptr), fmt::format("{}: {}; worst about ({:.1f}, {:.1f}) m", found.map,
                                                          found.message, found.worst.x, found.worst.y)});
    for (const std::string& map : mapsBeyondPaths(scene.project, scene.rows))
        report.noticed.push_back({placeInFile(scene, nullptr), beyondPaths(map)});
}

}  // namespace sward
