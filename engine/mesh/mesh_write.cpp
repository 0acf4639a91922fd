// Writing objects, with what tinygltf has for it. What was written is read before anybody gets it.
#include <tiny_gltf.h>

#include <sstream>

#include "core/file.h"
#include "mesh/mesh_io.h"

namespace sward {
namespace {

// Adds bytes to the one buffer; the number of their accessor.
int addAccessor(tinygltf::Model& m, const void* data, size_t bytes, size_t count, int componentType, int type,
                int target) {
    auto& buffer = m.buffers[0].data;
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = buffer.size();
    view.byteLength = bytes;
    view.target = target;
    buffer.insert(buffer.end(), static_cast<const unsigned char*>(data),
                  static_cast<const unsigned char*>(data) + bytes);
    m.bufferViews.push_back(view);
    tinygltf::Accessor accessor;
    accessor.bufferView = static_cast<int>(m.bufferViews.size()) - 1;
    accessor.componentType = componentType;
    accessor.type = type;
    accessor.count = count;
    m.accessors.push_back(accessor);
    return static_cast<int>(m.accessors.size()) - 1;
}

template <class V>
int addVectors(tinygltf::Model& m, const Mesh& mesh, V MeshVertex::*of) {
    std::vector<V> values;
    for (const MeshVertex& v : mesh.vertices) values.push_back(v.*of);
    return addAccessor(m, values.data(), values.size() * sizeof(V), values.size(), TINYGLTF_COMPONENT_TYPE_FLOAT,
                       std::is_same_v<V, glm::vec3> ? TINYGLTF_TYPE_VEC3 : TINYGLTF_TYPE_VEC2,
                       TINYGLTF_TARGET_ARRAY_BUFFER);
}
bool isUnwrapped(const Mesh& mesh) {
    return std::any_of(mesh.vertices.begin(), mesh.vertices.end(),
                       [](const MeshVertex& v) { return v.uv != glm::vec2(0); });
}

tinygltf::Material materialFor(const MeshPart& part) {
    tinygltf::Material m;
    m.doubleSided = true;
    m.pbrMetallicRoughness.metallicFactor = 0;
    m.pbrMetallicRoughness.baseColorFactor = {part.color.x, part.color.y, part.color.z, 1};
    return m;
}

}  // namespace

Result<std::string> encodeGlb(const Mesh& mesh) {
    if (Status s = checkMeshTriangles(mesh.indices.size() / 3); !s) return failed(s.error().message, s.error().remedy);
    tinygltf::Model m;
    m.asset.version = "2.0";
    m.asset.generator = "Sward";
    m.buffers.resize(1);
    m.meshes.resize(1);
    const int positions = addVectors(m, mesh, &MeshVertex::position);
    auto& accessor = m.accessors[static_cast<size_t>(positions)];
    accessor.minValues = {mesh.low.x, mesh.low.y, mesh.low.z};
    accessor.maxValues = {mesh.high.x, mesh.high.y, mesh.high.z};
    const int normals = addVectors(m, mesh, &MeshVertex::normal);
    const int uvs = isUnwrapped(mesh) ? addVectors(m, mesh, &MeshVertex::uv) : -1;
    for (const MeshPart& part : mesh.parts) {
        tinygltf::Primitive p;
        p.mode = TINYGLTF_MODE_TRIANGLES;
        p.attributes = {{"POSITION", positions}, {"NORMAL", normals}};
        if (uvs >= 0) p.attributes["TEXCOORD_0"] = uvs;
        p.indices =
            addAccessor(m, &mesh.indices[part.first], part.count * 4, part.count, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                        TINYGLTF_TYPE_SCALAR, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
        p.material = static_cast<int>(m.materials.size());
        m.materials.push_back(materialFor(part));
        m.meshes[0].primitives.push_back(p);
    }
    tinygltf::Node node;
    node.mesh = 0;
    m.nodes.push_back(node);
    tinygltf::Scene scene;
    scene.nodes = {0};
    m.scenes.push_back(scene);
    m.defaultScene = 0;
    std::ostringstream out;
    if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&m, out, false, true))
        return failed("the object cannot be encoded");
    std::string bytes = out.str();
    if (Status s = checkLength(bytes.size(), kMaxMeshBytes); !s) return failed(s.error().message, s.error().remedy);
    if (const Result<Mesh> again = readMeshBytes(bytes, {}, "object.glb"); !again)
        return failed("cannot be written: " + again.error().message, again.error().remedy);
    return bytes;
}

}  // namespace sward
