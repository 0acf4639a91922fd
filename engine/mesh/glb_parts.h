// Pieces of a glTF model as tinygltf has it, put into its one buffer: for whoever writes .glb files.
// Does not: read (mesh_io.h), nor write the file. Everything begins at a multiple of 4 bytes.
#pragma once
#include <glm/glm.hpp>
#include <span>
#include <string>

#include "core/error.h"
#include "mesh/mesh.h"

namespace tinygltf {
class Model;
}

namespace sward {

// An empty model of one scene, that says who wrote it.
void beginModel(tinygltf::Model& model);
// A node of that name at the scene's top; its number.
int addNode(tinygltf::Model& model, const std::string& name, const glm::dvec3& at);
// Whether an accessor of vertices says its least and greatest values: positions must, instances' places may.
enum class AccessorKind { Plain, Vertices, VerticesWithBounds, WithBounds };
// An accessor of floats; its number.
int addFloats(tinygltf::Model& model, std::span<const glm::vec2> values, AccessorKind kind);
int addFloats(tinygltf::Model& model, std::span<const glm::vec3> values, AccessorKind kind);
int addFloats(tinygltf::Model& model, std::span<const glm::vec4> values, AccessorKind kind);
// An accessor of a triangle list's corners; its number.
int addIndices(tinygltf::Model& model, std::span<const uint32_t> indices);
// The object with its materials and, with `images`, what they show; the number of its glTF mesh. Failed if an image
// cannot be encoded.
Result<int> addObject(tinygltf::Model& model, const Mesh& mesh, bool images);
// The bytes of a .glb. Failed without memory, or beyond the 4 GB that a .glb can say.
Result<std::string> glbBytes(const tinygltf::Model& model);

}  // namespace sward
