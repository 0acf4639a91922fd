// An object's triangles as the CPU keeps them, whatever file they came from.
// Does not: read or write files (mesh_io.h), nor hold GL handles.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace sward {

inline constexpr float kFullTurn = 6.2831853f;  // radians

struct MeshVertex {
    glm::vec3 position;  // metres; y is up
    glm::vec3 normal;    // unit
    glm::vec2 uv;
};
// Triangles of one material.
struct MeshPart {
    uint32_t first = 0, count = 0;  // of Mesh::indices; count is a multiple of 3
    glm::vec3 color{1};             // reflectance (linear), a factor of the image's
    int image = -1;                 // into Mesh::images; -1: none
    float cutoff = 0;               // where the image's alpha is less, there is nothing; 0: everything is there
};
// sRGB colour and alpha, rows first.
struct MeshImage {
    int width = 0, height = 0;
    std::vector<uint8_t> rgba;
};
struct Mesh {
    std::vector<MeshVertex> vertices;
    std::vector<uint32_t> indices;  // each below vertices.size(); three a triangle, counter-clockwise from outside
    std::vector<MeshPart> parts;
    std::vector<MeshImage> images;
    std::vector<std::string> files;  // that it was read from, relative to the project
    glm::vec3 low{0}, high{0};       // bounds
};

// Sets low and high from the vertices.
void updateBounds(Mesh& mesh);

}  // namespace sward
