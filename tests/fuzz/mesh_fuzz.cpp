// glTF, binary or text: a mesh whose indices and parts lie within it and whose vertices are finite, or an error.
#include <cmath>

#include "fuzz/scratch.h"
#include "mesh/mesh_io.h"

using namespace sward;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
    const auto mesh = readMeshBytes(std::string(fuzz::textOf(data, size)), fuzz::scratch(), "models/object.glb");
    if (!mesh) return 0;
    for (const uint32_t i : mesh->indices) fuzz::promise(i < mesh->vertices.size(), "indices lie within the vertices");
    for (const MeshPart& p : mesh->parts) {
        fuzz::promise(p.count % 3 == 0 && size_t(p.first) + p.count <= mesh->indices.size(), "parts are of triangles");
        fuzz::promise(p.image >= -1 && p.image < static_cast<int>(mesh->images.size()), "parts name images");
    }
    for (const MeshVertex& v : mesh->vertices)
        for (int c = 0; c < 3; ++c)
            fuzz::promise(std::isfinite(v.position[c]) && std::isfinite(v.normal[c]), "vertices are finite");
    return 0;
}
