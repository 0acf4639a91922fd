#include "tools/scene_objects.h"

#include <fmt/format.h>

#include "mesh/mesh_io.h"
#include "scene/locked.h"
#include "world/placement.h"

namespace sward {
namespace {

ObjectShape shapeOfMesh(const Result<Mesh>& mesh) {
    ObjectShape shape;
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

// Versions of the files that its species come from.
std::vector<std::string> filesOf(const Project& p, const Forest& forest) {
    std::vector<std::string> versions;
    for (const TreeSpecies& s : forest.species) versions.push_back(s.file.empty() ? "" : fileVersion(p.dir, s.file));
    return versions;
}

Corners cornersOfBox(const Box& bounds, const glm::dvec3& at, const glm::dmat3& turn) {
    Corners out;
    for (size_t i = 0; i < out.size(); ++i)
        out[i] = at + turn * glm::dvec3(i & 1 ? bounds.high.x : bounds.low.x, i & 2 ? bounds.high.y : bounds.low.y,
                                        i & 4 ? bounds.high.z : bounds.low.z);
    return out;
}

// The box along the world's axes around a turned one.
Box boxAround(const Box& bounds, const glm::dvec3& at, const glm::dmat3& turn) {
    const glm::dvec3 middle = at + turn * ((bounds.low + bounds.high) / 2.0), half = (bounds.high - bounds.low) / 2.0;
    const glm::dvec3 reach = glm::abs(turn[0]) * half.x + glm::abs(turn[1]) * half.y + glm::abs(turn[2]) * half.z;
    return {middle - reach, middle + reach};
}

glm::dmat3 scaledTurn(const PlacedMesh& placed) { return placed.turn * static_cast<double>(placed.mesh->scale); }

}  // namespace

const ObjectShape& SceneObjects::shapeOf(const Project& p, const std::string& file) {
    if (dir_ != p.dir)
        shapes_.clear(), own_ = {}, sources_.clear(), rules_.clear(), groves_.clear(), revision_ = 0, dir_ = p.dir;
    const auto known = shapes_.find(file);
    if (known != shapes_.end()) return known->second;
    ObjectShape& shape = shapes_[file] = shapeOfMesh(readMesh(p.dir, file));
    shape.version = fileVersion(p.dir, file);
    return shape;
}

void SceneObjects::forgetChangedFiles(const Project& p) {
    const auto changed = [&](const auto& s) { return s.second.version != fileVersion(p.dir, s.first); };
    if (std::erase_if(shapes_, changed) > 0) rules_.clear(), own_ = {}, sources_.clear();  // objects point at shapes
}

// Takes note of the ground; whether it is another than at the last call.
bool SceneObjects::groundMoved(const Ground& ground) {
    const bool same = ownGround_.has_value() == (ground.terrain != nullptr) && ownOrigin_ == ground.origin &&
                      (!ground.terrain || sameGround(*ownGround_, *ground.terrain));
    ownGround_ = ground.terrain ? std::optional(*ground.terrain) : std::nullopt;
    ownOrigin_ = ground.origin;
    return !same;
}

// Who stands where it stood is passed over; the hierarchy is made anew only when there are others than before.
void SceneObjects::followOwn(const Project& p, const Ground& ground) {
    const bool otherGround = groundMoved(ground);
    std::vector<std::pair<uint32_t, Box>> moved;
    size_t n = 0;
    bool others = false;
    const ObjectShape* shape = nullptr;
    const std::string* file = nullptr;  // of the shape
    for (const auto& [name, e] : p.entities) {
        const StaticMesh* mesh = p.registry.get<StaticMesh>(e);
        if (!mesh || mesh->file.empty() || p.registry.get<Hidden>(e) || p.registry.get<Locked>(e)) continue;
        if (!file || *file != mesh->file) shape = &shapeOf(p, mesh->file), file = &mesh->file;
        if (!shape->triangles) continue;
        const Transform* at = p.registry.get<Transform>(e);
        const Source source{at ? at->position : glm::dvec3(0), mesh->rotationDeg, mesh->scale, mesh->onGround, shape};
        const size_t i = n++;
        const bool known = i < sources_.size() && own_.entities[i] == name;
        if (known && sources_[i] == source && !(otherGround && mesh->onGround)) continue;
        others |= !known;
        if (i >= sources_.size()) sources_.resize(i + 1), own_.entities.resize(i + 1), own_.placed.resize(i + 1);
        const PlacedMesh placed = placeMesh(p, ground, e);
        sources_[i] = source;
        own_.entities[i] = name;
        own_.placed[i] = {placed.at, scaledTurn(placed), shape};
        moved.emplace_back(static_cast<uint32_t>(i), boxAround(shape->bounds, placed.at, own_.placed[i].turn));
    }
    others |= n < sources_.size();
    sources_.resize(n), own_.entities.resize(n), own_.placed.resize(n);
    if (!others) return own_.tree.follow(moved);
    std::vector<Box> boxes;
    for (const Placed& o : own_.placed) boxes.push_back(boxAround(o.shape->bounds, o.at, o.turn));
    own_.tree = BoxTree(std::move(boxes));
}

void SceneObjects::followScattered(const Project& p, const Ground& ground) {
    auto all = scattersOf(p);
    scattered_.keepOnly(all);
    std::erase_if(
        all, [&](const auto& s) { return p.registry.get<Hidden>(findEntity(p, s.first)) || isLocked(p, s.first); });
    std::map<std::string, Group> kept;
    for (const auto& [name, scatter] : all) {
        Group& group = kept[name] = std::move(rules_[name]);
        const std::shared_ptr<const Scattering> made = scattered_.of(p, ground, name, *scatter);
        if (group.of == made) continue;
        group = {{name}, {}, {}, made};
        std::vector<const ObjectShape*> shapes;
        for (const ScatterMesh& m : scatter->meshes) shapes.push_back(isScattered(m) ? &shapeOf(p, m.file) : nullptr);
        std::vector<Box> boxes;
        for (const ScatteredObject& o : made->objects) {
            if (!shapes[o.mesh]->triangles) continue;
            group.placed.push_back({o.at, glm::dmat3(o.turn * o.scale), shapes[o.mesh]});
            boxes.push_back(boxAround(shapes[o.mesh]->bounds, o.at, group.placed.back().turn));
        }
        group.tree = BoxTree(std::move(boxes));
    }
    rules_ = std::move(kept);
}

void SceneObjects::followForests(const Project& p, const Ground& ground) {
    std::map<std::string, Grove> kept;
    for (const auto& [name, forest] : forestsOf(p)) {
        if (p.registry.get<Hidden>(findEntity(p, name)) || isLocked(p, name) || !ground.terrain) continue;
        Grove& grove = kept[name] = std::move(groves_[name]);
        const std::vector<std::string> files = filesOf(p, *forest);
        if (grove.terrain && sameForest(grove.rule, *forest) && sameGround(*grove.terrain, *ground.terrain) &&
            grove.origin == ground.origin && grove.files == files)
            continue;
        grove = {{{name}, {}, {}, {}}, *forest, *ground.terrain, ground.origin, files, {}, {}};
        for (const TreeSpecies& s : forest->species)
            grove.species.push_back(
                std::make_unique<ObjectShape>(stands(s) ? shapeOfMesh(treeMesh(p.dir, s)) : ObjectShape{}));
        std::vector<Box> boxes;
        for (const StandingTree& tree : standingForest(*forest, ground).trees) {
            const ObjectShape* shape = grove.species[tree.species].get();
            if (!shape->triangles) continue;
            grove.trees.placed.push_back({tree.at, turnOf(tree), shape});
            grove.speciesOf.push_back(tree.species);
            boxes.push_back(boxAround(shape->bounds, tree.at, grove.trees.placed.back().turn));
        }
        grove.trees.tree = BoxTree(std::move(boxes));
    }
    groves_ = std::move(kept);
}

void SceneObjects::follow(const Project& p, uint64_t revision) {
    if (revision_ == revision && dir_ == p.dir) return;
    forgetChangedFiles(p);
    const Ground ground = findGround(p);
    followOwn(p, ground);
    followScattered(p, ground);
    followForests(p, ground);
    revision_ = revision;
    dir_ = p.dir;
}

ObjectHit SceneObjects::hitOf(const Group& group, size_t i, double distance) const {
    const Placed& o = group.placed[i];
    ObjectHit hit{group.entities[&group == &own_ ? i : 0], distance, "", cornersOfBox(o.shape->bounds, o.at, o.turn)};
    const auto grove = groves_.find(hit.entity);
    if (grove != groves_.end() && &grove->second.trees == &group) {
        const TreeSpecies& species = grove->second.rule.species[grove->second.speciesOf[i]];
        hit.which = fmt::format("{}, {:.3g} m high, one of {} trees", species.name,
                                o.shape->bounds.high.y * glm::length(o.turn[1]), group.placed.size());
    } else if (group.of) {
        hit.which = fmt::format("one of {} that its rule scatters", group.placed.size());
    }
    return hit;
}

std::optional<ObjectHit> SceneObjects::closest(const Project& p, uint64_t revision, const glm::dvec3& origin,
                                               const glm::dvec3& way) {
    follow(p, revision);
    std::optional<ObjectHit> hit;
    looked_ = 0;
    const auto castInto = [&](const Group& group) {
        looked_ += group.tree.cast(origin, way, hit ? hit->distance : 1e9, [&](size_t i, double far) {
            const Placed& o = group.placed[i];
            const glm::dmat3 back = glm::inverse(o.turn);  // into the object's own lengths: t stays as it is
            const auto met = o.shape->triangles->closest(glm::vec3(back * (origin - o.at)), glm::vec3(back * way), 0,
                                                         static_cast<float>(far));
            if (!met) return far;
            hit = hitOf(group, i, static_cast<double>(met->t));
            return hit->distance;
        });
    };
    castInto(own_);
    for (const auto& [name, group] : rules_) castInto(group);
    for (const auto& [name, grove] : groves_) castInto(grove.trees);
    return hit;
}

bool SceneObjects::readAhead(const Project& p) {
    for (const auto& [name, e] : p.entities) {
        const StaticMesh* mesh = p.registry.get<StaticMesh>(e);
        if (!mesh || mesh->file.empty() || hasRead(p, mesh->file)) continue;
        shapeOf(p, mesh->file);
        return true;
    }
    return false;
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
