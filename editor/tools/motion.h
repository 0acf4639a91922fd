// What moving, turning and scaling does to an entity's fields. Pure.
// Each kind has a place of its own: Transform, Camera's eye and target, Water's level, and a pond's Transform and
// radius beside; and a direction: StaticMesh's turn, ForceSource's heading, a lamp's azimuth. Does not: change a
// project (panels/viewport_gizmo.h does, through Document).
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <utility>
#include <vector>

#include "scene/project.h"
#include "tools/handles.h"

namespace sward {

// Scaled about the pivot, turned about an axis through it, then moved.
struct Motion {
    glm::dvec3 pivot{0};       // in the world
    glm::dvec3 move{0};        // metres
    glm::dvec3 axis{0};        // unit; 0: not turned
    double angle = 0;          // radians, counter-clockwise when the axis points at the eye
    double scale = 1;          // above 0
    bool alongGround = false;  // what does not stand on the ground keeps its height over it, too
};

// An entity as it was when the hand took hold of it.
struct EntityStart {
    Handle handle;
    Transform transform;  // its own, or where one without stands
    StaticMesh mesh;      // file empty: it has none
    Camera camera;
    Water water;
    ForceSource force;
    Light light;
};
EntityStart startOf(const Project& p, const Handle& handle);

// PATHs and what they are set to. A StaticMesh on the ground keeps its height over it wherever it goes; only `move`
// itself raises it. Values stay within their fields' ranges. What an entity of its kind has not is not named:
// an entity that is none of the kinds, nothing. A Transform may be named that is not there yet (needsTransform).
using FieldTexts = std::vector<std::pair<std::string, std::string>>;
FieldTexts movedFields(const EntityStart& start, const Motion& motion, const Ground& ground);
// Whether movedFields names a Transform for an entity of this kind.
bool movesTransform(HandleKind kind);

// Degrees about x, then z, then y (world/placement.h) after a turn about an axis of the world; each in [-180, 180].
// About y alone the other two stay as they are, to the bit.
glm::dvec3 turnedDegrees(const glm::dvec3& degrees, const glm::dvec3& axis, double angle);

}  // namespace sward
