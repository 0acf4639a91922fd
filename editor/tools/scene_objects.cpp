#include "tools/scene_objects.h"

#include "mesh/mesh_io.h"
#include "scene/locked.h"
#include "world/placement.h"

namespace sward {
namespace {

ObjectShape readShape(const Project& p, const std::string& file) {
    ObjectShape shape;
    const Result<Mesh> mesh = readMesh(p.dir, file);
    if (!mesh) return shape;  // drawing tells of it
    Triangles triangles;
    triangles.indices = mesh->indices;
    for (const MeshVertex& v : mesh->vertices) triangles.positions.push_back(v.position);
    Result<RayScene> scene = RayScene::make({triangles});
    if (!scene) return shape;
    shape.bounds = {mesh->low, mesh->high};
    shape.triangles = std::move(*scene);
    return shape;
}

Corners cornersOfBox(const Box& bounds, const glm::dvec3& at, const glm::dmat3& turn) {
    Corners out;
    for (size_t i = 0; i < out.size(); ++i)
        out[i] = at + turn * glm::dvec3(i & 1 ? bounds.high.x : bounds.low.x, i & 2 ? bounds.high.y : bounds.low.y,
                                        i & 4 ? bounds.high.z : bounds.low.z);
    return out;
}

glm::dmat3 scaledTurn(const PlacedMesh& placed) { return placed.turn * static_cast<double>(placed.mesh->scale); }

}  // namespace

const ObjectShape& SceneObjects::shapeOf(const Project& p, const std::string& file) {
    if (dir_ != p.dir) shapes_.clear(), placed_.clear(), revision_ = 0, dir_ = p.dir;
    const auto known = shapes_.find(file);
    if (known != shapes_.end()) return known->second;
    ObjectShape& shape = shapes_[file] = readShape(p, file);
    shape.version = fileVersion(p.dir, file);
    return shape;
}

void SceneObjects::add(std::vector<Box>& boxes, Placed placed) {
    Box& box = boxes.emplace_back();
    for (const glm::dvec3& corner : cornersOfBox(placed.shape->bounds, placed.at, placed.turn)) box.add(corner);
    placed_.push_back(std::move(placed));
}

void SceneObjects::addScattered(std::vector<Box>& boxes, const Project& p, const Ground& ground) {
    const auto all = scattersOf(p);
    scattered_.keepOnly(all);
    for (const auto& [name, scatter] : all) {
        if (p.registry.get<Hidden>(findEntity(p, name)) || isLocked(p, name)) continue;
        std::vector<const ObjectShape*> shapes;
        for (const ScatterMesh& m : scatter->meshes) shapes.push_back(isScattered(m) ? &shapeOf(p, m.file) : nullptr);
        for (const ScatteredObject& o : scattered_.of(p, ground, name, *scatter)->objects)
            if (shapes[o.mesh]->triangles) add(boxes, {name, o.at, glm::dmat3(o.turn * o.scale), shapes[o.mesh]});
    }
}

void SceneObjects::follow(const Project& p, uint64_t revision) {
    if (revision_ == revision && dir_ == p.dir) return;
    placed_.clear();
    std::erase_if(shapes_, [&](const auto& s) { return s.second.version != fileVersion(p.dir, s.first); });
    const Ground ground = findGround(p);
    std::vector<Box> boxes;
    for (const auto& [name, e] : p.entities) {
        const StaticMesh* mesh = p.registry.get<StaticMesh>(e);
        if (!mesh || mesh->file.empty() || p.registry.get<Hidden>(e) || p.registry.get<Locked>(e)) continue;
        const ObjectShape& shape = shapeOf(p, mesh->file);
        if (!shape.triangles) continue;
        const PlacedMesh placed = placeMesh(p, ground, e);
        add(boxes, {name, placed.at, scaledTurn(placed), &shape});
    }
    addScattered(boxes, p, ground);
    tree_ = BoxTree(std::move(boxes));
    revision_ = revision;
    dir_ = p.dir;
}

std::optional<ObjectHit> SceneObjects::closest(const Project& p, uint64_t revision, const glm::dvec3& origin,
                                               const glm::dvec3& way) {
    follow(p, revision);
    std::optional<ObjectHit> hit;
    looked_ = tree_.cast(origin, way, 1e9, [&](size_t i, double far) {
        const Placed& o = placed_[i];
        const glm::dmat3 back = glm::inverse(o.turn);  // into the object's own lengths: t stays as it is
        const auto met = o.shape->triangles->closest(glm::vec3(back * (origin - o.at)), glm::vec3(back * way), 0,
                                                     static_cast<float>(far));
        if (!met) return far;
        hit = {o.entity, static_cast<double>(met->t)};
        return hit->distance;
    });
    return hit;
}

std::optional<Corners> SceneObjects::cornersOf(const Project& p, const Ground& ground, const std::string& entity) {
    const Entity e = findEntity(p, entity);
    const StaticMesh* mesh = e == kNoEntity ? nullptr : p.registry.get<StaticMesh>(e);
    if (!mesh || mesh->file.empty()) return std::nullopt;
    const ObjectShape& shape = shapeOf(p, mesh->file);
    if (!shape.triangles) return std::nullopt;
    const PlacedMesh placed = placeMesh(p, ground, e);
    return cornersOfBox(shape.bounds, placed.at, scaledTurn(placed));
}

std::optional<Corners> SceneObjects::cornersAt(const Project& p, const std::string& file, const glm::dvec3& at) {
    const ObjectShape& shape = shapeOf(p, file);
    return shape.triangles ? std::optional(cornersOfBox(shape.bounds, at, glm::dmat3(1))) : std::nullopt;
}

}  // namespace sward
