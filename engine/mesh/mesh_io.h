// Objects from glTF 2.0 files: .glb, or .gltf with what it refers to, all inside the project's folder.
// Read: triangles, strips and fans, indexed or not; positions, normals, the first texture coordinates; node transforms;
// base colour factor, texture (PNG or JPEG) and alpha cut-off. Normals that are not there are the faces'.
// Does not: skins, animation, morph targets, other material terms, compression (such files are refused by name).
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

#include "core/error.h"
#include "mesh/mesh.h"

namespace sward {

inline constexpr size_t kMaxMeshTriangles = 2'000'000;  // of all nodes together
inline constexpr uint64_t kMaxMeshBytes = uint64_t(256)
                                          << 20;  // of each file; so many triangles fit that share nothing
static_assert(kMaxMeshBytes > kMaxMeshTriangles * 3 * (sizeof(MeshVertex) + sizeof(uint32_t)));
inline constexpr int kMaxMeshImageSide = 4096;

// file: relative to root, the project's folder. Unsound error, naming the file and what to do: unreadable, truncated,
// beyond a limit, no triangles, accessors or indices out of range, numbers that are not finite, a path that leaves the
// folder.
Result<Mesh> readMesh(const std::filesystem::path& root, const std::string& file);

// The same from the bytes of a file; what they refer to lies beside `file` in root.
Result<Mesh> readMeshBytes(const std::string& bytes, const std::filesystem::path& root, const std::string& file);
// Unsound error that names both, if there are more triangles than an object may have.
Status checkMeshTriangles(size_t count);

// The bytes of a .glb with the mesh; images are left out. Failed error if readMesh would refuse them: nothing is
// written that cannot be read again.
Result<std::string> encodeGlb(const Mesh& mesh);

}  // namespace sward
