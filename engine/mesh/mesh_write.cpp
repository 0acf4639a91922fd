// Writing objects, with what tinygltf has for it. What was written is read before anybody gets it.
#include <tiny_gltf.h>

#include "core/file.h"
#include "mesh/glb_parts.h"
#include "mesh/mesh_io.h"

namespace sward {

Result<std::string> encodeGlb(const Mesh& mesh) {
    if (Status s = checkMeshTriangles(mesh.indices.size() / 3); !s) return failed(s.error().message, s.error().remedy);
    tinygltf::Model m;
    beginModel(m);
    const Result<int> object = addObject(m, mesh, false);
    if (!object) return object.error();
    m.nodes[static_cast<size_t>(addNode(m, "", {}))].mesh = *object;
    Result<std::string> bytes = glbBytes(m);
    if (!bytes) return bytes;
    if (Status s = checkLength(bytes->size(), kMaxMeshBytes); !s) return failed(s.error().message, s.error().remedy);
    if (const Result<Mesh> again = readMeshBytes(*bytes, {}, "object.glb"); !again)
        return failed("cannot be written: " + again.error().message, again.error().remedy);
    return bytes;
}

}  // namespace sward
