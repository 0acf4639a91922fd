#include "model/scatter_edits.h"

#include <fmt/format.h>

#include <algorithm>

#include "model/assets.h"
#include "model/entity_edits.h"
#include "model/one_step.h"
#include "world/drawn_project.h"
#include "world/placement.h"
#include "world/scatter.h"

namespace sward {
namespace {

const ComponentRow& rowOf(const Document& doc, const char* name) {
    return *findComponent(doc.tables().components, name);
}

std::vector<std::string> meshesOf(const Document& doc, std::span<const std::string> entities) {
    std::vector<std::string> files;
    for (const std::string& name : entities) {
        const Entity e = findEntity(doc.project(), name);
        const StaticMesh* mesh = e == kNoEntity ? nullptr : doc.project().registry.get<StaticMesh>(e);
        if (mesh && !mesh->file.empty() && std::find(files.begin(), files.end(), mesh->file) == files.end())
            files.push_back(mesh->file);
    }
    return files;
}

Status addObject(Document& doc, const std::string& name, const ScatteredObject& o, const Scatter& s) {
    StaticMesh mesh;
    mesh.file = s.meshes[o.mesh].file;
    mesh.rotationDeg = degreesOf(glm::dmat3(o.turn));
    mesh.scale = o.scale;
    mesh.castShadows = s.castShadows;
    const Transform at{{o.at.x, 0, o.at.z}};  // onGround: the terrain's height comes on top
    if (Status done = doc.addEntity(name); !done) return done;
    if (Status done = doc.assignComponent(name, rowOf(doc, "Transform"), &at); !done) return done;
    return doc.assignComponent(name, rowOf(doc, "StaticMesh"), &mesh);
}

bool hasOtherParts(const Document& doc, Entity e) {
    const Registry& r = doc.project().registry;
    return std::any_of(doc.tables().components.begin(), doc.tables().components.end(),
                       [&](const ComponentRow& row) { return row.get(r, e) && !isRowOf<Scatter>(row); });
}

}  // namespace

Result<std::string> addScatter(Document& doc, std::span<const std::string> like) {
    if (!doc.isOpen()) return failed("no project is open", "open or create one first");
    std::vector<std::string> files = meshesOf(doc, like);
    if (files.empty())
        for (const std::string& file : projectAssets(doc.project().dir)) files.push_back(file);
    if (files.empty())
        return failed("the project has no object to scatter",
                      "drop a .glb onto the window, or copy one into its folder");
    Scatter scatter;
    scatter.meshes.clear();
    for (const std::string& file : files)
        scatter.meshes.push_back({std::filesystem::path(file).stem().string(), file, 1});
    const std::string name = freeName(doc.project(), "scatter");
    const Status done = inOneStep(doc, "add " + name, [&]() -> Status {
        if (Status s = doc.addEntity(name); !s) return s;
        return doc.assignComponent(name, rowOf(doc, "Scatter"), &scatter);
    });
    if (!done) return done.error();
    return name;
}

Result<std::vector<std::string>> makeObjectsOf(Document& doc, const std::string& entity) {
    DrawnProject drawn;
    const Project& shown = doc.isOpen() ? drawn.of(doc.project(), doc.tables().components) : doc.project();
    const Entity e = doc.isOpen() ? findEntity(shown, entity) : kNoEntity;
    const Scatter* found = e == kNoEntity ? nullptr : shown.registry.get<Scatter>(e);
    if (!found) return usage(fmt::format("\"{}\" has no Scatter", entity), "choose an entity that has one");
    const Scatter scatter = *found;
    const Ground ground = findGround(shown);
    const Scattering all = scatterIn(shown, scatter, ground);
    if (all.objects.empty()) return failed(entity + " scatters nothing here", "give it a mesh and a number");
    if (all.objects.size() > kMostObjectsMade)
        return failed(fmt::format("{} scatters {} objects; at most {} are made into entities", entity,
                                  all.objects.size(), kMostObjectsMade),
                      "lower perHectare");
    const bool whole = !hasOtherParts(doc, e);
    std::vector<std::string> names;
    const Status done = inOneStep(doc, "make objects of " + entity, [&]() -> Status {
        for (const ScatteredObject& o : all.objects) {
            names.push_back(
                freeName(doc.project(), std::filesystem::path(scatter.meshes[o.mesh].file).stem().string()));
            if (Status s = addObject(doc, names.back(), o, scatter); !s) return s;
        }
        return whole ? doc.removeEntity(entity) : doc.removeComponent(entity, "Scatter");
    });
    if (!done) return done.error();
    return names;
}

}  // namespace sward
