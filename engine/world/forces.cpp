#include "world/forces.h"

#include "core/log.h"
#include "core/numerics.h"
#include "mesh/mesh_io.h"
#include "world/ground.h"
#include "world/placement.h"

namespace sward {
namespace {

// From the middle to the middle of one end of what presses; in the world.
glm::dvec2 halfLength(const ForceSource& s) {
    if (s.shape == ForceShape::Object || s.shape == ForceShape::Outline) return glm::dvec2(0);
    const double angle = glm::radians(static_cast<double>(s.headingDeg));
    const double half = std::max(0.5 * static_cast<double>(s.length) - static_cast<double>(s.radius), 0.0);
    return half * glm::dvec2(std::sin(angle), -std::cos(angle));
}

// Metres over the ground up to which blades stand.
double tallestBlade(const Project& p) {
    double most = 0;
    p.registry.each<GrassField>([&](Entity, const GrassField& f) {
        for (const Species& s : f.species)
            if (s.bladesPerM2 > 0) most = std::max(most, static_cast<double>(s.height * (1 + s.heightVariation)));
    });
    return most;
}

double groundBelow(const Project& p, const glm::dvec3& at) {
    const Ground ground = findGround(p);
    return ground.origin.y +
           (ground.terrain ? terrainHeight(*ground.terrain, at.x - ground.origin.x, at.z - ground.origin.z) : 0);
}

// From the y of the turned mesh on it is higher than all blades; infinity: all of it is lower.
float cutOf(const Project& p, const PlacedMesh& placed, const Mesh& mesh, const glm::mat3& tilt) {
    const double top =
        (groundBelow(p, placed.at) + tallestBlade(p) - placed.at.y) / static_cast<double>(placed.mesh->scale);
    float highest = -std::numeric_limits<float>::infinity();
    for (const MeshVertex& v : mesh.vertices) highest = std::max(highest, (tilt * v.position).y);
    return top >= static_cast<double>(highest) ? std::numeric_limits<float>::infinity() : static_cast<float>(top);
}

Force outlineForce(const Project& p, const ForceSource& s, const std::string& entity, const glm::dvec2& at,
                   Outlines& outlines) {
    Force f{at, at, s.radius, s.reach, s.strength, outlines.of(p, entity)};
    if (!f.outline) return f;
    const StaticMesh& mesh = *p.registry.get<StaticMesh>(findEntity(p, entity));
    const double turn = glm::radians(mesh.rotationDeg.y);
    f.heading = glm::vec2(std::cos(turn), std::sin(turn));
    f.scale = mesh.scale;
    return f;
}

bool isOutline(const ForceSource& s) { return s.shape == ForceShape::Outline; }

// Turned about the vertical from the world to the outline, and back: x, z.
glm::vec2 intoOutline(const Force& f, const glm::vec2& v) {
    return {f.heading.x * v.x - f.heading.y * v.y, f.heading.y * v.x + f.heading.x * v.y};
}
glm::vec2 outOfOutline(const Force& f, const glm::vec2& v) {
    return {f.heading.x * v.x + f.heading.y * v.y, f.heading.x * v.y - f.heading.y * v.x};
}

glm::vec3 oneForce(const Force& f, const glm::dvec2& place) {
    const glm::vec2 from(place - f.from);
    if (!f.outline) return f32::longForce(from, glm::vec2(f.to - f.from), f.radius, f.reach, f.share);
    if (!(glm::length(from) <= farOf(f))) return glm::vec3(0);
    const glm::vec3 at = outlineAt(*f.outline, intoOutline(f, from) / f.scale);
    return f32::outlineForce(at.x * f.scale, outOfOutline(f, {at.y, at.z}), f.radius, f.reach, f.share);
}

}  // namespace

float farOf(const Force& f) {
    if (!f.outline) return f.radius * f.reach;
    return f.scale * f.outline->farthest + f.radius * std::max(f.reach - 1, 0.2f);
}

std::shared_ptr<const Footprint> Outlines::of(const Project& p, const std::string& entity) {
    const auto tell = [&](const std::string& what) {
        if (told_.insert(entity + what).second) logWarning(entity + ".ForceSource.shape: " + what);
        return nullptr;
    };
    const StaticMesh* mesh = p.registry.get<StaticMesh>(findEntity(p, entity));
    if (!mesh || mesh->file.empty()) return tell(kOutlineOfNothing);
    const PlacedMesh placed = placeMesh(p, findEntity(p, entity));
    const std::string key =
        fmt::format("{} {} {} {} {} {}", fileVersion(p.dir, mesh->file), mesh->rotationDeg.x, mesh->rotationDeg.z,
                    mesh->scale, groundBelow(p, placed.at) - placed.at.y, tallestBlade(p));
    const auto known = made_.find(key);
    if (known != made_.end()) {
        known->second.asked = true;
        return known->second.footprint;
    }
    const Result<Mesh> read = readMesh(p.dir, mesh->file);
    if (!read) tell(read.error().text() + "; it presses nothing");
    std::shared_ptr<const Footprint> made;
    if (read) {
        const glm::mat3 tilt(rotationOf({mesh->rotationDeg.x, 0, mesh->rotationDeg.z}));  // the heading is the force's
        Footprint f = makeFootprint(*read, tilt, cutOf(p, placed, *read, tilt));
        if (!f.empty()) made = std::make_shared<const Footprint>(std::move(f));
    }
    made_[key] = {made};
    return made;
}

void Outlines::sweep() {
    std::erase_if(made_, [](const auto& e) { return !e.second.asked; });
    for (auto& [key, entry] : made_) entry.asked = false;
}

double trackLeft(double age, float recovery) {
    if (std::isinf(recovery)) return 1;
    if (!(recovery > 0) || !(age < static_cast<double>(recovery))) return 0;
    return 1 - f64::clumpFade(std::max(age, 0.0) / static_cast<double>(recovery));
}

std::vector<Force> forcesOf(const Project& p, double seconds, Outlines* outlines) {
    Outlines own;
    if (!outlines) outlines = &own;
    const Ground ground = findGround(p);
    const glm::dvec2 origin(ground.origin.x, ground.origin.z);
    std::vector<Force> out;
    for (const auto& [name, e] : p.entities) {
        const ForceSource* s = p.registry.get<ForceSource>(e);
        if (!s || !(s->strength > 0) || !(s->radius > 0)) continue;
        for (const Track& t : s->tracks)
            if (const double left = trackLeft(seconds - t.seconds, s->recovery); left > 0)
                out.push_back(
                    {t.from - origin, t.to - origin, s->radius, s->reach, s->strength * static_cast<float>(left)});
        if (const Transform* at = p.registry.get<Transform>(e)) {
            const glm::dvec2 middle = glm::dvec2(at->position.x, at->position.z) - origin, half = halfLength(*s);
            if (!isOutline(*s))
                out.push_back({middle - half, middle + half, s->radius, s->reach, s->strength});
            else if (Force f = outlineForce(p, *s, name, middle, *outlines); f.outline)
                out.push_back(std::move(f));
        }
    }
    outlines->sweep();
    return out;
}

glm::vec3 forceAt(std::span<const Force> forces, const glm::dvec2& place) {
    glm::vec3 sum(0);
    for (const Force& f : forces) {
        const glm::vec3 one = oneForce(f, place);
        sum = {sum.x + one.x, sum.y + one.y, std::max(sum.z, one.z)};
    }
    return f32::forceOf(sum);
}

void leaveTrack(ForceSource& source, const glm::dvec2& from, const glm::dvec2& to, double seconds) {
    std::erase_if(source.tracks,
                  [&](const Track& t) { return !(trackLeft(seconds - t.seconds, source.recovery) > 0); });
    if (std::isfinite(from.x + from.y + to.x + to.y)) source.tracks.push_back({from, to, seconds});
}

}  // namespace sward
