// Where an entity is taken hold of in the viewport, and which of them are shown there as an icon. Pure.
// Does not: draw (panels/viewport_objects.h), or move anything (tools/motion.h).
#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/project.h"
#include "world/ground.h"

namespace sward {

// What an entity is to the hand; None: it has no place in the scene.
enum class HandleKind { None, Object, Lamp, Camera, Force, Water, Pond, Other };
struct Handle {
    std::string entity;
    HandleKind kind = HandleKind::None;
    glm::dvec3 at{0};  // in the world
};

// An object stands where its file's origin does, a lamp where it shines at that time, a camera at its eye, a force on
// the ground, a pond at its level in its middle, water everywhere over the lowest of some places of the ground. Other:
// what has a Transform and is none of these.
Handle handleOf(const Project& p, const Ground& ground, const std::string& entity, double seconds);
// Of those named that have a place and are not Locked: what a drag moves.
std::vector<Handle> movable(const Project& p, const Ground& ground, std::span<const std::string> entities,
                            double seconds);
// Lamps, cameras, forces and water, in the order of their names; what is an object too, hidden or locked, has no icon.
std::vector<Handle> icons(const Project& p, const Ground& ground, double seconds);

// Height of the ground in the world at (x, z) of the world; 0 without any.
double groundHeight(const Ground& ground, double x, double z);

}  // namespace sward
