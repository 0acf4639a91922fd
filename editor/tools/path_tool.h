// What the path tool keeps between frames, and what its clicks make of a path. Pure.
// Does not: draw, or change a project (panels/viewport_path.h).
#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "scene/ground_path.h"

namespace sward {

// A point in the hand.
struct PathDrag {
    size_t point = 0;
    glm::dvec2 from{0}, offset{0};  // where the hand took it, and from there to the point; window coordinates
    bool moved = false;             // a click is no drag
};
// What the pointer is on: a point of a path, or its curve after one.
struct PathHover {
    std::string entity;
    bool onPoint = false;
    size_t point = 0;  // that one, or the one at which the piece begins
    glm::dvec2 at{0};  // place on the path, metres from the terrain's corner
};
struct PathTool {
    std::string entity;            // whose points these are
    std::optional<size_t> chosen;  // the point that Delete removes
    std::optional<PathHover> hover;
    std::optional<PathDrag> drag;
};

inline constexpr size_t kMostPathPoints = 1000;  // project files hold no longer lists (kMaxListElements)

// Where a click beside the curve adds a point: at the end, or before the first point of an open path where that is
// chosen. The number that the new point gets.
size_t nextPoint(const GroundPath& path, std::optional<size_t> chosen);
// The path with one more point, which gets the number `at`, of at most points.size().
GroundPath withPoint(GroundPath path, size_t at, const glm::dvec2& place);
// The path without a point that it has, and the point chosen then: the one before; nothing where none is left.
GroundPath withoutPoint(GroundPath path, size_t at);
std::optional<size_t> chosenAfterRemoval(const GroundPath& left, size_t removed);
// As it is written: millimetres.
glm::dvec2 roundedPlace(const glm::dvec2& place);

}  // namespace sward
