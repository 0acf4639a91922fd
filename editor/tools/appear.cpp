#include "tools/appear.h"

#include <fmt/format.h>

#include <cmath>

#include "core/json.h"
#include "model/one_step.h"
#include "model/whole_map.h"
#include "tools/handles.h"
#include "world/ground.h"

namespace sward {
namespace {

constexpr double kLampHeight = 2;  // metres above the ground, of a new one without an object

std::string pointText(const glm::dvec3& at) {
    const auto millimetres = [](double metres) { return shortestText(std::round(metres * 1e3) / 1e3 + 0.0); };
    return fmt::format("[{}, {}, {}]", millimetres(at.x), millimetres(at.y), millimetres(at.z));
}

Status setPlace(Document& doc, const std::string& entity, const glm::dvec3& at) {
    return doc.setField(entity + ".Transform.position", pointText(at));
}

bool hasSunBeside(const Project& p, Entity lamp) {
    for (const auto& [name, e] : p.entities) {
        const Light* light = e == lamp ? nullptr : p.registry.get<Light>(e);
        if (light && light->type == LightType::Directional) return true;
    }
    return false;
}

// Beside a sun a new light is a lamp; a second sun would take over the sky.
Status fitLight(Document& doc, const std::string& entity, Entity e) {
    const Project& p = doc.project();
    if (!hasSunBeside(p, e)) return {};
    if (Status s = doc.setField(entity + ".Light.type", "point"); !s) return s;
    const Transform* transform = p.registry.get<Transform>(e);
    if (!transform || p.registry.get<StaticMesh>(e)) return {};
    const glm::dvec3 at = transform->position;
    const double above = at.y - groundHeight(doc.ground(), at.x, at.z);
    return above < kLampHeight / 2 ? setPlace(doc, entity, {at.x, at.y - above + kLampHeight, at.z}) : Status();
}

Status fitCamera(Document& doc, const ViewCamera& view, const std::string& entity) {
    const std::string camera = entity + ".Camera.";
    if (Status s = doc.setField(camera + "eye", pointText(view.eye)); !s) return s;
    if (Status s = doc.setField(camera + "target", pointText(view.target)); !s) return s;
    return doc.setField(camera + "fovDeg", shortestText(view.fovDeg));
}

// What the new component's defaults become.
Status fit(Document& doc, const ViewCamera& view, const std::string& entity, const ComponentRow& row) {
    const Project& p = doc.project();
    const Ground ground = doc.ground();
    const Entity e = findEntity(p, entity);
    const Transform* transform = p.registry.get<Transform>(e);
    if (isRowOf<StaticMesh>(row) && transform) {
        const glm::dvec3 at = transform->position;
        return setPlace(doc, entity, {at.x, at.y - groundHeight(ground, at.x, at.z), at.z});
    }
    if (isRowOf<Light>(row)) return fitLight(doc, entity, e);
    if (isRowOf<Camera>(row)) return fitCamera(doc, view, entity);
    const auto middle = pickGround(doc.standing(), view, 2, 2, 1, 1);
    if (!middle || p.registry.get<Terrain>(e)) return {};  // the ground itself stays where it is
    if (isRowOf<Transform>(row)) {
        const StaticMesh* mesh = p.registry.get<StaticMesh>(e);
        const Light* light = mesh ? nullptr : p.registry.get<Light>(e);
        const double lamp = light && light->type == LightType::Point ? kLampHeight : 0;
        return setPlace(doc, entity, {middle->x, mesh && mesh->onGround ? 0 : middle->y + lamp, middle->z});
    }
    if (isRowOf<Water>(row))
        return doc.setField(entity + ".Water.level", shortestText(static_cast<float>(middle->y - ground.origin.y)));
    return {};
}

}  // namespace

Status addInView(Document& doc, const ViewCamera& view, const std::string& entity, const std::string& component) {
    return inOneStep(doc, fmt::format("add {}.{}", entity, component), [&]() -> Status {
        if (Status s = addComponentUnpainted(doc, entity, component); !s) return s;
        return fit(doc, view, entity, *findComponent(doc.tables().components, component));
    });
}

}  // namespace sward
