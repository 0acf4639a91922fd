#include "tools/handles.h"

#include <algorithm>

#include "scene/locked.h"
#include "world/lights.h"
#include "world/placement.h"

namespace sward {
namespace {

// The first of the lowest of some places of the ground, from its middle on, at the water's level.
glm::dvec3 placeOf(const Water& water, const Ground& ground) {
    constexpr int kPlaces = 16;  // each way
    const double y = ground.origin.y + static_cast<double>(water.level);
    if (!ground.terrain) return {0, y, 0};
    const glm::dvec2 size = ground.terrain->size;
    glm::dvec2 best = size / 2.0;
    double low = terrainHeight(*ground.terrain, best.x, best.y);
    for (int i = 0; i < kPlaces * kPlaces; ++i) {
        const glm::dvec2 at = size * (glm::dvec2(i % kPlaces, i / kPlaces) + 0.5) / double(kPlaces);
        const double height = terrainHeight(*ground.terrain, at.x, at.y);
        if (height < low) low = height, best = at;
    }
    return {ground.origin.x + best.x, y, ground.origin.z + best.y};
}

}  // namespace

double groundHeight(const Ground& ground, double x, double z) {
    if (!ground.terrain) return 0;
    return ground.origin.y + terrainHeight(*ground.terrain, x - ground.origin.x, z - ground.origin.z);
}

Handle handleOf(const Project& p, const Ground& ground, const std::string& entity, double seconds) {
    const Entity e = findEntity(p, entity);
    if (e == kNoEntity) return {entity};
    const Registry& r = p.registry;
    const Transform* transform = r.get<Transform>(e);
    const glm::dvec3 at = transform ? transform->position : glm::dvec3(0);
    if (const StaticMesh* mesh = r.get<StaticMesh>(e); mesh && !mesh->file.empty())
        return {entity, HandleKind::Object, placeMesh(p, ground, e).at};
    if (const Camera* camera = r.get<Camera>(e)) return {entity, HandleKind::Camera, camera->eye};
    if (const Light* light = r.get<Light>(e); light && light->type == LightType::Point)
        return {entity, HandleKind::Lamp, placeOf(*light, at, seconds)};
    if (r.get<ForceSource>(e) && transform)
        return {entity, HandleKind::Force, {at.x, groundHeight(ground, at.x, at.z), at.z}};
    const Water* water = r.get<Water>(e);
    if (water && water->radius > 0)
        return {entity, HandleKind::Pond, {at.x, ground.origin.y + static_cast<double>(water->level), at.z}};
    if (water) return {entity, HandleKind::Water, placeOf(*water, ground)};
    return transform ? Handle{entity, HandleKind::Other, at} : Handle{entity};
}

std::vector<Handle> movable(const Project& p, const Ground& ground, std::span<const std::string> entities,
                            double seconds) {
    std::vector<Handle> out;
    for (const std::string& name : entities)
        if (Handle h = handleOf(p, ground, name, seconds); h.kind != HandleKind::None && !isLocked(p, name))
            out.push_back(std::move(h));
    return out;
}

std::vector<Handle> icons(const Project& p, const Ground& ground, double seconds) {
    std::vector<Handle> out;
    const auto add = [&](Entity e) {
        const Name* name = p.registry.get<Name>(e);
        if (!name || p.registry.get<Hidden>(e) || p.registry.get<Locked>(e)) return;
        const Handle handle = handleOf(p, ground, name->value, seconds);
        if (handle.kind != HandleKind::Object && handle.kind != HandleKind::Other && handle.kind != HandleKind::None)
            out.push_back(handle);
    };
    p.registry.each<Camera>([&](Entity e, const Camera&) { add(e); });
    p.registry.each<Light>([&](Entity e, const Light&) { add(e); });
    p.registry.each<ForceSource>([&](Entity e, const ForceSource&) { add(e); });
    p.registry.each<Water>([&](Entity e, const Water&) { add(e); });
    const auto byName = [](const Handle& a, const Handle& b) { return a.entity < b.entity; };
    std::sort(out.begin(), out.end(), byName);
    const auto same = [](const Handle& a, const Handle& b) { return a.entity == b.entity; };
    out.erase(std::unique(out.begin(), out.end(), same), out.end());
    return out;
}

}  // namespace sward
