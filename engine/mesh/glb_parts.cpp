#include "mesh/glb_parts.h"

#include <tiny_gltf.h>

#include <limits>
#include <sstream>

#include "maps/image_file.h"

namespace sward {
namespace {

// Appends bytes at a multiple of 4; the number of their view.
int addView(tinygltf::Model& m, const void* data, size_t bytes, int target) {
    m.buffers.resize(1);
    auto& buffer = m.buffers[0].data;
    buffer.resize((buffer.size() + 3) / 4 * 4);
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = buffer.size();
    view.byteLength = bytes;
    view.target = target;
    const auto* from = static_cast<const unsigned char*>(data);
    buffer.insert(buffer.end(), from, from + bytes);
    m.bufferViews.push_back(view);
    return static_cast<int>(m.bufferViews.size()) - 1;
}

int addAccessor(tinygltf::Model& m, int view, size_t count, int componentType, int type) {
    tinygltf::Accessor accessor;
    accessor.bufferView = view;
    accessor.componentType = componentType;
    accessor.type = type;
    accessor.count = count;
    m.accessors.push_back(accessor);
    return static_cast<int>(m.accessors.size()) - 1;
}

template <class V>
void setBounds(tinygltf::Accessor& accessor, std::span<const V> values) {
    V low = values[0], high = values[0];
    for (const V& v : values) low = glm::min(low, v), high = glm::max(high, v);
    for (int c = 0; c < V::length(); ++c) {
        accessor.minValues.push_back(static_cast<double>(low[c]));
        accessor.maxValues.push_back(static_cast<double>(high[c]));
    }
}

template <class V>
int addVectors(tinygltf::Model& m, std::span<const V> values, AccessorKind kind, int type) {
    const bool vertices = kind == AccessorKind::Vertices || kind == AccessorKind::VerticesWithBounds;
    const int view = addView(m, values.data(), values.size_bytes(), vertices ? TINYGLTF_TARGET_ARRAY_BUFFER : 0);
    const int number = addAccessor(m, view, values.size(), TINYGLTF_COMPONENT_TYPE_FLOAT, type);
    if (!values.empty() && (kind == AccessorKind::VerticesWithBounds || kind == AccessorKind::WithBounds))
        setBounds(m.accessors[static_cast<size_t>(number)], values);
    return number;
}

template <class V>
int addMember(tinygltf::Model& m, const Mesh& mesh, V MeshVertex::*of, AccessorKind kind) {
    std::vector<V> values;
    values.reserve(mesh.vertices.size());
    for (const MeshVertex& v : mesh.vertices) values.push_back(v.*of);
    return addFloats(m, values, kind);
}

// Repeats, as objects' images do here.
Result<int> addTexture(tinygltf::Model& m, const MeshImage& image) {
    const MapInfo info{image.width, image.height, 4, PixelType::U8};
    const auto png = encodeImage("png", info, [&](int y, int rows, void* out) {
        const size_t row = static_cast<size_t>(image.width) * 4;
        std::memcpy(out, image.rgba.data() + static_cast<size_t>(y) * row, static_cast<size_t>(rows) * row);
    });
    if (!png) return png.error();
    tinygltf::Image shown;
    shown.mimeType = "image/png";
    shown.bufferView = addView(m, png->data(), png->size(), 0);
    m.images.push_back(shown);
    if (m.samplers.empty()) {
        m.samplers.emplace_back();
        m.samplers[0].minFilter = TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
        m.samplers[0].magFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
    }
    tinygltf::Texture texture;
    texture.source = static_cast<int>(m.images.size()) - 1;
    texture.sampler = 0;
    m.textures.push_back(texture);
    return static_cast<int>(m.textures.size()) - 1;
}

// firstTexture: of the object's images, -1 without them.
int addMaterial(tinygltf::Model& m, const MeshPart& part, int firstTexture) {
    tinygltf::Material material;
    material.doubleSided = true;
    material.pbrMetallicRoughness.metallicFactor = 0;
    material.pbrMetallicRoughness.baseColorFactor = {part.color.x, part.color.y, part.color.z, 1};
    if (firstTexture >= 0 && part.image >= 0)
        material.pbrMetallicRoughness.baseColorTexture.index = firstTexture + part.image;
    if (firstTexture >= 0 && part.image >= 0 && part.cutoff > 0) {
        material.alphaMode = "MASK";
        material.alphaCutoff = static_cast<double>(part.cutoff);
    }
    m.materials.push_back(material);
    return static_cast<int>(m.materials.size()) - 1;
}

bool isUnwrapped(const Mesh& mesh) {
    return std::any_of(mesh.vertices.begin(), mesh.vertices.end(),
                       [](const MeshVertex& v) { return v.uv != glm::vec2(0); });
}

}  // namespace

void beginModel(tinygltf::Model& m) {
    m.asset.version = "2.0";
    m.asset.generator = "Sward";
    m.scenes.resize(1);
    m.defaultScene = 0;
}

int addNode(tinygltf::Model& m, const std::string& name, const glm::dvec3& at) {
    tinygltf::Node node;
    node.name = name;
    if (at != glm::dvec3(0)) node.translation = {at.x, at.y, at.z};
    m.nodes.push_back(node);
    m.scenes[0].nodes.push_back(static_cast<int>(m.nodes.size()) - 1);
    return m.scenes[0].nodes.back();
}

int addFloats(tinygltf::Model& m, std::span<const glm::vec2> values, AccessorKind kind) {
    return addVectors(m, values, kind, TINYGLTF_TYPE_VEC2);
}
int addFloats(tinygltf::Model& m, std::span<const glm::vec3> values, AccessorKind kind) {
    return addVectors(m, values, kind, TINYGLTF_TYPE_VEC3);
}
int addFloats(tinygltf::Model& m, std::span<const glm::vec4> values, AccessorKind kind) {
    return addVectors(m, values, kind, TINYGLTF_TYPE_VEC4);
}

int addIndices(tinygltf::Model& m, std::span<const uint32_t> indices) {
    const int view = addView(m, indices.data(), indices.size_bytes(), TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    return addAccessor(m, view, indices.size(), TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR);
}

Result<int> addObject(tinygltf::Model& m, const Mesh& mesh, bool images) {
    const int firstTexture = images && !mesh.images.empty() ? static_cast<int>(m.textures.size()) : -1;
    for (size_t i = 0; images && i < mesh.images.size(); ++i)
        if (const Result<int> texture = addTexture(m, mesh.images[i]); !texture) return texture.error();
    const int positions = addMember(m, mesh, &MeshVertex::position, AccessorKind::VerticesWithBounds);
    const int normals = addMember(m, mesh, &MeshVertex::normal, AccessorKind::Vertices);
    const int uvs = isUnwrapped(mesh) ? addMember(m, mesh, &MeshVertex::uv, AccessorKind::Vertices) : -1;
    tinygltf::Mesh out;
    for (const MeshPart& part : mesh.parts) {
        tinygltf::Primitive p;
        p.mode = TINYGLTF_MODE_TRIANGLES;
        p.attributes = {{"POSITION", positions}, {"NORMAL", normals}};
        if (uvs >= 0) p.attributes["TEXCOORD_0"] = uvs;
        p.indices = addIndices(m, std::span(mesh.indices).subspan(part.first, part.count));
        p.material = addMaterial(m, part, uvs >= 0 ? firstTexture : -1);
        out.primitives.push_back(p);
    }
    m.meshes.push_back(out);
    return static_cast<int>(m.meshes.size()) - 1;
}

Result<std::string> glbBytes(const tinygltf::Model& m) try {
    if (!m.buffers.empty() && m.buffers[0].data.size() > std::numeric_limits<uint32_t>::max() / 2)
        return failed("is more than a .glb can hold", "leave more out");
    std::ostringstream out;
    if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&m, out, false, true)) return failed("cannot be encoded");
    return std::move(out).str();
} catch (const std::bad_alloc&) {
    return failed("cannot be encoded: there is not enough memory", "leave more out");
}

}  // namespace sward
