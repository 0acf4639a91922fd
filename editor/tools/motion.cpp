#include "tools/motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/json.h"
#include "world/placement.h"

namespace sward {
namespace {

constexpr double kFarthestPosition = 1e8, kDeepest = 1e5;         // of positions and of water's levels, metres
constexpr float kLeastMeshScale = 0.001f, kMostMeshScale = 1000;  // as StaticMesh.scale takes it
constexpr float kLeastPond = 0.01f, kWidestPond = 1e5f;           // metres of its radius, as Water.radius takes it

double wrappedDegrees(double degrees) { return std::remainder(degrees, 360.0); }

glm::dmat3 turnOf(const Motion& m) {
    if (m.angle == 0 || m.axis == glm::dvec3(0)) return glm::dmat3(1);
    return glm::dmat3(glm::rotate(glm::dmat4(1), m.angle, m.axis));
}

// Whole millimetres or thousandths of a degree of what has changed: a hand means no more, and what did not move keeps
// its bits.
glm::dvec3 rounded(const glm::dvec3& before, glm::dvec3 after) {
    for (int i = 0; i < 3; ++i)
        after[i] = after[i] == before[i]
                       ? after[i]
                       : std::round(std::clamp(after[i], -kFarthestPosition, kFarthestPosition) * 1e3) / 1e3;
    return after;
}

std::string text(const glm::dvec3& before, const glm::dvec3& after) {
    const glm::dvec3 p = rounded(before, after);
    return fmt::format("[{}, {}, {}]", shortestText(p.x), shortestText(p.y), shortestText(p.z));
}

// How far a place goes.
glm::dvec3 shiftOf(const Motion& m, const glm::dvec3& place) {
    return m.pivot + turnOf(m) * ((place - m.pivot) * m.scale) + m.move - place;
}

// The same of what stays as high over the ground as `move` leaves it.
glm::dvec3 alongGround(const Motion& m, const glm::dvec3& place, const glm::dvec3& shift, const Ground& ground) {
    const double before = groundHeight(ground, place.x, place.z),
                 after = groundHeight(ground, place.x + shift.x, place.z + shift.z);
    return {shift.x, m.move.y + after - before, shift.z};
}

void moveObject(const EntityStart& s, const Motion& m, const glm::dvec3& shift, FieldTexts& out) {
    const std::string path = s.handle.entity + ".StaticMesh.";
    if (m.angle != 0)
        out.emplace_back(path + "rotationDeg",
                         text(s.mesh.rotationDeg, turnedDegrees(s.mesh.rotationDeg, m.axis, m.angle)));
    if (m.scale != 1)
        out.emplace_back(path + "scale", shortestText(std::clamp(s.mesh.scale * static_cast<float>(m.scale),
                                                                 kLeastMeshScale, kMostMeshScale)));
    const glm::dvec3 own = s.mesh.onGround ? glm::dvec3(shift.x, m.move.y, shift.z) : shift;
    out.emplace_back(s.handle.entity + ".Transform.position", text(s.transform.position, s.transform.position + own));
}

// An angle clockwise from north, of what turns about the vertical.
void turnHeading(const std::string& path, float before, const Motion& m, FieldTexts& out) {
    if (m.angle == 0 || m.axis.y == 0) return;
    const double turned = static_cast<double>(before) - glm::degrees(m.angle) * m.axis.y;
    out.emplace_back(path, shortestText(static_cast<float>(wrappedDegrees(turned))));
}

std::string levelAt(const Water& water, double risen) {
    return shortestText(static_cast<float>(std::clamp(static_cast<double>(water.level) + risen, -kDeepest, kDeepest)));
}

void movePond(const EntityStart& s, const Motion& m, const glm::dvec3& shift, FieldTexts& out) {
    const std::string& name = s.handle.entity;
    if (m.scale != 1)
        out.emplace_back(name + ".Water.radius", shortestText(std::clamp(s.water.radius * static_cast<float>(m.scale),
                                                                         kLeastPond, kWidestPond)));
    out.emplace_back(name + ".Water.level", levelAt(s.water, shift.y));
    out.emplace_back(name + ".Transform.position", text(s.transform.position, s.transform.position + shift));
}

}  // namespace

bool movesTransform(HandleKind kind) {
    return kind == HandleKind::Object || kind == HandleKind::Lamp || kind == HandleKind::Force ||
           kind == HandleKind::Pond || kind == HandleKind::Other;
}

EntityStart startOf(const Project& p, const Handle& handle) {
    EntityStart s{handle, {}, {}, {}, {}, {}, {}};
    const Entity e = findEntity(p, handle.entity);
    const auto take = [&](auto& component) {
        if (const auto* own = p.registry.get<std::remove_reference_t<decltype(component)>>(e)) component = *own;
    };
    take(s.transform), take(s.mesh), take(s.camera), take(s.water), take(s.force), take(s.light);
    return s;
}

FieldTexts movedFields(const EntityStart& s, const Motion& m, const Ground& ground) {
    FieldTexts out;
    const std::string& name = s.handle.entity;
    glm::dvec3 shift = shiftOf(m, s.handle.at);
    const bool standing = s.handle.kind == HandleKind::Object && s.mesh.onGround;
    if (m.alongGround && !standing) shift = alongGround(m, s.handle.at, shift, ground);
    switch (s.handle.kind) {
        case HandleKind::None:
            break;
        case HandleKind::Object:
            moveObject(s, m, shift, out);
            break;
        case HandleKind::Camera: {
            const glm::dvec3 eye = s.camera.eye + shift;
            out.emplace_back(name + ".Camera.eye", text(s.camera.eye, eye));
            out.emplace_back(name + ".Camera.target",
                             text(s.camera.target, eye + turnOf(m) * (s.camera.target - s.camera.eye)));
            break;
        }
        case HandleKind::Water:
            out.emplace_back(name + ".Water.level", levelAt(s.water, m.move.y));
            break;
        case HandleKind::Pond:
            movePond(s, m, shift, out);
            break;
        case HandleKind::Force:
            turnHeading(name + ".ForceSource.headingDeg", s.force.headingDeg, m, out);
            out.emplace_back(name + ".Transform.position", text(s.transform.position, s.transform.position + shift));
            break;
        case HandleKind::Lamp:
            if (s.light.orbitRadius > 0) turnHeading(name + ".Light.azimuthDeg", s.light.azimuthDeg, m, out);
            [[fallthrough]];
        case HandleKind::Other:
            out.emplace_back(name + ".Transform.position", text(s.transform.position, s.transform.position + shift));
            break;
    }
    return out;
}

glm::dvec3 turnedDegrees(const glm::dvec3& degrees, const glm::dvec3& axis, double angle) {
    if (axis.x == 0 && axis.z == 0)
        return {degrees.x, wrappedDegrees(degrees.y + glm::degrees(angle) * axis.y), degrees.z};
    const glm::dmat3 m = glm::dmat3(glm::rotate(glm::dmat4(1), angle, axis)) * rotationOf(degrees);
    // Ry Rz Rx: its first column is (cos y cos z, sin z, -sin y cos z), its second row (sin z, cos z cos x, -cos z sin
    // x).
    const double sinZ = std::clamp(m[0][1], -1.0, 1.0);
    if (std::abs(sinZ) > 1 - 1e-12)  // upright: turns about x and y are the same, and all is given to y
        return glm::degrees(glm::dvec3(0, std::atan2(m[2][0], m[2][2]), std::asin(sinZ)));
    return glm::degrees(glm::dvec3(std::atan2(-m[2][1], m[1][1]), std::atan2(-m[0][2], m[0][0]), std::asin(sinZ)));
}

}  // namespace sward
