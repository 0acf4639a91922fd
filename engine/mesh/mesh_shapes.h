// Objects put together from simple shapes, for sample projects and tests: what a script's mesh.write makes.
// Does not: write files (mesh_io.h). The same numbers give the same mesh on every machine.
#pragma once
#include <glm/glm.hpp>
#include <span>

#include "core/enum_names.h"
#include "mesh/mesh.h"

namespace sward {

enum class SolidKind {
    Box,       // size: x, y, z; stands on `at`
    Cylinder,  // size: radius at the base, height, radius at the top (0: a cone); stands on `at`
    Ball,      // size: half axes; `at` is its centre
    Leaves,    // size: half axes of the ball that `count` leaves of length `leaf` fill, denser outside; `at` is its
               // centre
};
inline constexpr auto kSolidKinds = enumNames<SolidKind>("box", "cylinder", "ball", "leaves");

struct Solid {
    SolidKind kind = SolidKind::Box;
    glm::vec3 size{1};
    glm::vec3 at{0};
    glm::vec3 turnDeg{0};   // about `at`: about x, then z, then y
    glm::vec3 color{0.5f};  // reflectance
    int sides = 16;         // Cylinder: 3 to 256
    int count = 500;        // Leaves: 1 to 100000
    float leaf = 0.15f;     // Leaves: metres
    float rough = 0;        // Ball: share of its size that dents are deep; 0: smooth
    uint32_t seed = 0;      // Ball, Leaves
    bool unwrap = false;    // Box, Ball: texture coordinates, a square for each of six faces; else all are 0
};
// One mesh with a part for each colour, in the order in which they first occur; leaves have three tints.
Mesh makeMesh(std::span<const Solid> solids);

}  // namespace sward
