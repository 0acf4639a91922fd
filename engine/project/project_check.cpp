// What `check` finds in a scene that loads: what other verbs would refuse, what does nothing, and what is surely not
// meant.
#include "project/project_files.h"
#include "project/project_json.h"
#include "scene/unique.h"

namespace sward {
namespace {

// The value of a PATH without list elements, in the tree that the project was read from; null if it is not written
// there.
const Json* valueOf(const Json& root, const std::string& entity, const char* component, const char* field) {
    const Json* at = root.find("entities");
    for (const std::string_view key : {std::string_view(entity), std::string_view(component), std::string_view(field)})
        if (at) at = at->find(key);
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

std::string placeOf(const SceneToCheck& s, const Json* at) {
    const std::string file = (s.project.dir / "project.json").string();
    return at ? fmt::format("{}:{}", file, at->line) : file;
}

// Drawing says the same once it comes to it (world/forces.h).
void checkOutline(const SceneToCheck& s, const std::string& name, Entity e, CheckReport& report) {
    const ForceSource* f = s.project.registry.get<ForceSource>(e);
    const StaticMesh* mesh = s.project.registry.get<StaticMesh>(e);
    if (!f || f->shape != ForceShape::Outline || (mesh && !mesh->file.empty())) return;
    report.repaired.push_back(
        {placeOf(s, valueOf(s.root, name, "ForceSource", "shape")), name + ".ForceSource.shape: " + kOutlineOfNothing});
}

// A blade that has no height or no width is not seen.
void checkSpecies(const SceneToCheck& s, const std::string& name, Entity e, CheckReport& report) {
    const GrassField* f = s.project.registry.get<GrassField>(e);
    if (!f) return;
    const Json* list = valueOf(s.root, name, "GrassField", "species");
    for (size_t i = 0; i < f->species.size(); ++i) {
        const Species& sp = f->species[i];
        const Json* read = list && i < list->array.size() ? &list->array[i] : nullptr;
        for (const auto& [field, value] : {std::pair("height", sp.height), std::pair("width", sp.width)})
            if (sp.bladesPerM2 > 0 && value == 0)
                report.noticed.push_back({placeOf(s, read ? read->find(field) : nullptr),
                                          fmt::format("{}.GrassField.species[{}].{} is 0: none of its blades is seen; "
                                                      "raise it, or set bladesPerM2 to 0",
                                                      name, sp.name, field)});
    }
}

}  // namespace

void checkScene(const SceneToCheck& scene, CheckReport& report) {
    if (report.refused.empty())
        checkPopulation(scene, report);  // maps that could not be read say nothing of how many blades grow
    for (const auto& [name, e] : scene.project.entities) {
        checkOutline(scene, name, e, report);
        checkSpecies(scene, name, e, report);
    }
}

}  // namespace sward
