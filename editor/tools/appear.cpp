#include "tools/appear.h"

#include <fmt/format.h>

#include <cmath>

#include "core/json.h"
#include "model/whole_map.h"
#include "tools/handles.h"
#include "world/ground.h"

namespace sward {
namespace {

Status setPlace(Document& doc, const std::string& entity, const glm::dvec3& at) {
    const auto millimetres = [](double metres) { return shortestText(std::round(metres * 1e3) / 1e3); };
    return doc.setField(entity + ".Transform.position",
                        fmt::format("[{}, {}, {}]", millimetres(at.x), millimetres(at.y), millimetres(at.z)));
}

// What the new component's defaults become.
Status fit(Document& doc, const ViewCamera& view, const std::string& entity, const ComponentRow& row) {
    const Project& p = doc.project();
    const Ground ground = findGround(p);
    const Entity e = findEntity(p, entity);
    const Transform* transform = p.registry.get<Transform>(e);
    if (isRowOf<StaticMesh>(row) && transform) {
        const glm::dvec3 at = transform->position;
        return setPlace(doc, entity, {at.x, at.y - groundHeight(ground, at.x, at.z), at.z});
    }
    const auto middle = pickGround(p, view, 2, 2, 1, 1);
    if (!middle || p.registry.get<Terrain>(e)) return {};  // the ground itself stays where it is
    if (isRowOf<Transform>(row)) {
        const StaticMesh* mesh = p.registry.get<StaticMesh>(e);
        return setPlace(doc, entity, {middle->x, mesh && mesh->onGround ? 0 : middle->y, middle->z});
    }
    if (isRowOf<Water>(row))
        return doc.setField(entity + ".Water.level", shortestText(static_cast<float>(middle->y - ground.origin.y)));
    return {};
}

}  // namespace

Status addInView(Document& doc, const ViewCamera& view, const std::string& entity, const std::string& component) {
    doc.beginGroup(fmt::format("add {}.{}", entity, component));
    Status done = addComponentUnpainted(doc, entity, component);
    if (done) done = fit(doc, view, entity, *findComponent(doc.tables().components, component));
    if (done)
        doc.endGroup();
    else
        doc.cancelGroup();
    return done;
}

}  // namespace sward
