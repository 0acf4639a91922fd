// tinygltf costs two seconds to compile: it is included here and in mesh_write.cpp alone. What it hands over is not
// trusted: every offset, count and type is held against the bytes there are.
// Index: reading by tinygltf · accessors · triangles · materials and images · nodes · reading.
#include "mesh/mesh_io.h"

#include <stb/stb_image.h>
#include <tiny_gltf.h>

#include <cstring>
#include <glm/gtc/quaternion.hpp>
#include <optional>

#include "core/file.h"
#include "core/save_folder.h"
#include "mesh/gltf_head.h"

namespace fs = std::filesystem;

namespace sward {
namespace {

constexpr size_t kMaxVerticesRead = 12 * kMaxMeshTriangles;  // of all parts, each with all that its accessor holds
constexpr float kMaxCoordinate = 1e6f;

// An error without a file: readMesh knows it.
Error refused(std::string message, std::string remedy = "export it again") {
    return unsound(std::move(message), std::move(remedy));
}

// --- reading by tinygltf -----------------------------------------------------------------------------------------
// What the library asks files of: inside the project, and no longer than the limit.
struct Files {
    fs::path root;
    std::vector<std::string> read;
    std::optional<Error> failed;
};
bool readPart(std::vector<unsigned char>* out, std::string* said, const std::string& name, void* user) {
    Files& files = *static_cast<Files*>(user);
    const std::string clean = fs::path(name).lexically_normal().generic_string();
    const Result<fs::path> place = currentFile(files.root, clean);
    const Result<std::string> bytes = place ? readFile(*place, kMaxMeshBytes) : Result<std::string>(place.error());
    if (!bytes) {
        files.failed = bytes.error();
        files.failed->message = "refers to " + clean + ": " + files.failed->message;
        *said = files.failed->message;
        return false;
    }
    out->assign(bytes->begin(), bytes->end());
    files.read.push_back(clean);
    return true;
}
tinygltf::FsCallbacks callbacks(Files& files) {
    tinygltf::FsCallbacks c{};
    c.FileExists = [](const std::string&, void*) { return true; };
    c.ExpandFilePath = [](const std::string& path, void*) { return path; };
    c.ReadWholeFile = readPart;
    c.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) { return false; };
    // Later versions of the library ask for the size, too.
    [](auto& own) {
        if constexpr (requires { own.GetFileSizeInBytes; })
            own.GetFileSizeInBytes = [](size_t* size, std::string*, const std::string&, void*) {
                *size = 1;
                return true;
            };
    }(c);
    c.user_data = &files;
    return c;
}
// Images are kept as they come, and decoded if a material shows them. Those in buffer views are looked up then: here
// their place was not yet checked.
bool keepImage(tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes, int size,
               void*) {
    if (image->bufferView < 0 && size > 0) image->image.assign(bytes, bytes + size);
    image->as_is = true;
    return true;
}

Status parse(tinygltf::Model& model, const std::string& bytes, const std::string& folder, Files& files) try {
    tinygltf::TinyGLTF reader;
    (void)reader.SetFsCallbacks(callbacks(files));
    reader.SetImageLoader(keepImage, nullptr);
    std::string error, warning;
    const unsigned size = static_cast<unsigned>(bytes.size());
    const bool done =
        isGlb(bytes) ? reader.LoadBinaryFromMemory(&model, &error, &warning,
                                                   reinterpret_cast<const unsigned char*>(bytes.data()), size, folder)
                     : reader.LoadASCIIFromString(&model, &error, &warning, bytes.data(), size, folder);
    if (files.failed) return *files.failed;
    if (done) return {};
    return refused("is damaged or no glTF 2.0: " + error.substr(0, error.find('\n')));
} catch (const std::exception& e) {
    return refused(std::string("is damaged: ") + e.what());
}

// --- accessors ---------------------------------------------------------------------------------------------------
struct Bytes {
    const unsigned char* data = nullptr;
    size_t size = 0;
};
Result<Bytes> bytesOf(const tinygltf::Model& model, int view, const std::string& what) {
    if (view < 0 || static_cast<size_t>(view) >= model.bufferViews.size()) return refused(what + " has no buffer view");
    const tinygltf::BufferView& v = model.bufferViews[static_cast<size_t>(view)];
    if (v.buffer < 0 || static_cast<size_t>(v.buffer) >= model.buffers.size()) return refused(what + " has no buffer");
    const auto& data = model.buffers[static_cast<size_t>(v.buffer)].data;
    if (v.byteOffset > data.size() || v.byteLength > data.size() - v.byteOffset)
        return refused(what + " reaches beyond its buffer");
    return Bytes{data.data() + v.byteOffset, v.byteLength};
}

// The elements of an accessor; every one lies inside its buffer.
struct Elements {
    const unsigned char* data = nullptr;
    size_t count = 0, stride = 0, each = 0;  // bytes of a component
    int componentType = 0, components = 0;
    bool normalized = false;

    template <class T>
    T component(size_t i, int c) const {
        T value;
        std::memcpy(&value, data + i * stride + static_cast<size_t>(c) * each, sizeof(T));
        return value;
    }
    float real(size_t i, int c) const {
        switch (componentType) {
            case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
                return static_cast<float>(component<uint8_t>(i, c)) / (normalized ? 255.0f : 1.0f);
            case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
                return static_cast<float>(component<uint16_t>(i, c)) / (normalized ? 65535.0f : 1.0f);
            default:
                return component<float>(i, c);
        }
    }
    uint32_t index(size_t i) const {
        switch (componentType) {
            case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
                return component<uint8_t>(i, 0);
            case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
                return component<uint16_t>(i, 0);
            default:
                return component<uint32_t>(i, 0);
        }
    }
};
size_t componentBytes(int type) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return 1;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return 2;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return 4;
        default:
            return 0;
    }
}
Result<Elements> elementsOf(const tinygltf::Model& model, int accessor, int components, const std::string& what) {
    if (accessor < 0 || static_cast<size_t>(accessor) >= model.accessors.size())
        return refused(fmt::format("{} names accessor {}, which is not there", what, accessor));
    const tinygltf::Accessor& a = model.accessors[static_cast<size_t>(accessor)];
    if (a.sparse.isSparse)
        return refused(what + " is a sparse accessor, which is not read", "export it without sparse accessors");
    const int has = a.type == TINYGLTF_TYPE_SCALAR ? 1 : a.type >= 2 && a.type <= 4 ? a.type : 0;
    const size_t each = componentBytes(a.componentType);
    if (has != components || each == 0) return refused(fmt::format("{} is of a type that is not read", what));
    const Result<Bytes> bytes = bytesOf(model, a.bufferView, what);
    if (!bytes) return bytes.error();
    const size_t size = each * static_cast<size_t>(components);
    const size_t stride = model.bufferViews[static_cast<size_t>(a.bufferView)].byteStride;
    Elements e{nullptr, a.count, stride ? stride : size, each, a.componentType, components, a.normalized};
    if (a.count == 0) return e;
    if (a.byteOffset > bytes->size || size > bytes->size - a.byteOffset ||
        (a.count - 1) > (bytes->size - a.byteOffset - size) / e.stride)
        return refused(
            fmt::format("{}: {} elements reach beyond the {} bytes of the buffer view", what, a.count, bytes->size));
    e.data = bytes->data + a.byteOffset;
    return e;
}

// --- triangles ---------------------------------------------------------------------------------------------------
// Corners of the triangles that a primitive's mode makes of a row of vertices.
std::vector<uint32_t> triangleOrder(int mode, size_t n) {
    std::vector<uint32_t> out;
    if (mode == TINYGLTF_MODE_TRIANGLES || mode == -1)
        for (size_t i = 0; i < n / 3 * 3; ++i) out.push_back(static_cast<uint32_t>(i));
    for (size_t i = 2; i < n && (mode == TINYGLTF_MODE_TRIANGLE_STRIP || mode == TINYGLTF_MODE_TRIANGLE_FAN); ++i) {
        const uint32_t at = static_cast<uint32_t>(i);
        if (mode == TINYGLTF_MODE_TRIANGLE_FAN)
            out.insert(out.end(), {0, at - 1, at});
        else
            out.insert(out.end(), {at - 2, i % 2 ? at : at - 1, i % 2 ? at - 1 : at});
    }
    return out;
}

// Puts the indices in the order of triangles; refuses those beyond the vertices.
Result<std::vector<uint32_t>> trianglesOf(const tinygltf::Model& model, const tinygltf::Primitive& p, size_t vertices) {
    std::optional<Elements> indices;
    if (p.indices >= 0) {
        const Result<Elements> e = elementsOf(model, p.indices, 1, "the indices");
        if (!e) return e.error();
        if (e->componentType == TINYGLTF_COMPONENT_TYPE_FLOAT) return refused("the indices are no integers");
        indices = *e;
    }
    const size_t n = indices ? indices->count : vertices;
    if (n / 3 > 3 * kMaxMeshTriangles)
        return refused(fmt::format("has more than {} triangles", kMaxMeshTriangles), "make the object simpler");
    std::vector<uint32_t> order = triangleOrder(p.mode, n);
    for (uint32_t& i : order) {
        if (indices) i = indices->index(i);
        if (i >= vertices) return refused(fmt::format("index {} is out of range: there are {} vertices", i, vertices));
    }
    return order;
}

bool finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
glm::vec3 unit(const glm::vec3& v) {
    const float l = glm::length(v);
    return l > 1e-20f && std::isfinite(l) ? v / l : glm::vec3(0, 1, 0);
}

// Where a node puts its mesh.
struct Placed {
    glm::dmat4 matrix{1};
    glm::dmat3 normals() const { return glm::transpose(glm::inverse(glm::dmat3(matrix))); }
    bool mirrors() const { return glm::determinant(glm::dmat3(matrix)) < 0; }
};

Result<std::vector<MeshVertex>> verticesOf(const tinygltf::Model& model, const tinygltf::Primitive& p, const Placed& at,
                                           bool& hasNormals) {
    const auto find = [&](const char* name) {
        const auto it = p.attributes.find(name);
        return it == p.attributes.end() ? -1 : it->second;
    };
    const Result<Elements> positions = elementsOf(model, find("POSITION"), 3, "POSITION");
    if (!positions) return positions.error();
    hasNormals = find("NORMAL") >= 0;
    const Result<Elements> normals = hasNormals ? elementsOf(model, find("NORMAL"), 3, "NORMAL") : Elements{};
    const Result<Elements> uvs =
        find("TEXCOORD_0") >= 0 ? elementsOf(model, find("TEXCOORD_0"), 2, "TEXCOORD_0") : Elements{};
    if (!normals) return normals.error();
    if (!uvs) return uvs.error();
    if ((hasNormals && normals->count < positions->count) || (uvs->data && uvs->count < positions->count))
        return refused("has fewer normals or texture coordinates than positions");
    if (positions->count > 3 * kMaxMeshTriangles)
        return refused(fmt::format("has more than {} vertices", 3 * kMaxMeshTriangles), "make the object simpler");
    const glm::dmat3 turn = at.normals();
    std::vector<MeshVertex> out(positions->count);
    for (size_t i = 0; i < out.size(); ++i) {
        const auto vec3 = [&](const Elements& e) { return glm::vec3(e.real(i, 0), e.real(i, 1), e.real(i, 2)); };
        const glm::vec3 raw = vec3(*positions), normal = hasNormals ? vec3(*normals) : glm::vec3(0, 1, 0);
        out[i].position = glm::vec3(at.matrix * glm::dvec4(raw, 1));
        out[i].uv = uvs->data ? glm::vec2(uvs->real(i, 0), uvs->real(i, 1)) : glm::vec2(0);
        if (!finite(out[i].position) || glm::length(out[i].position) > kMaxCoordinate)
            return refused(fmt::format("vertex {} lies nowhere: ({}, {}, {})", i, raw.x, raw.y, raw.z),
                           "positions are finite, and within 1000 km");
        if (!finite(normal) || !std::isfinite(out[i].uv.x + out[i].uv.y))
            return refused(fmt::format("vertex {} has a normal or texture coordinate that is not finite", i));
        out[i].normal = unit(glm::vec3(turn * glm::dvec3(unit(normal))));
    }
    return out;
}

// Each triangle gets vertices of its own, with the face's normal.
void flatten(std::vector<MeshVertex>& vertices, std::vector<uint32_t>& order) {
    std::vector<MeshVertex> flat(order.size());
    for (size_t i = 0; i < order.size(); ++i) flat[i] = vertices[order[i]];
    for (size_t i = 0; i + 2 < flat.size(); i += 3) {
        const glm::vec3 n =
            unit(glm::cross(flat[i + 1].position - flat[i].position, flat[i + 2].position - flat[i].position));
        for (size_t k = 0; k < 3; ++k) flat[i + k].normal = n;
    }
    for (size_t i = 0; i < order.size(); ++i) order[i] = static_cast<uint32_t>(i);
    vertices = std::move(flat);
}

// Leaves the vertices that a triangle uses.
void compact(std::vector<MeshVertex>& vertices, std::vector<uint32_t>& order) {
    std::vector<uint32_t> place(vertices.size(), ~0u);
    std::vector<MeshVertex> used;
    for (uint32_t& i : order) {
        if (place[i] == ~0u) {
            place[i] = static_cast<uint32_t>(used.size());
            used.push_back(vertices[i]);
        }
        i = place[i];
    }
    vertices = std::move(used);
}

// --- materials and images ----------------------------------------------------------------------------------------
Result<MeshImage> decode(const Bytes& bytes) {
    int width = 0, height = 0, channels = 0;
    const int size = static_cast<int>(bytes.size);
    if (!stbi_info_from_memory(bytes.data, size, &width, &height, &channels))
        return refused("an image is neither PNG nor JPEG, or damaged");
    if (width < 1 || height < 1 || width > kMaxMeshImageSide || height > kMaxMeshImageSide)
        return refused(fmt::format("an image is {} x {}; the limit is {} a side", width, height, kMaxMeshImageSide),
                       "scale it down");
    unsigned char* pixels = stbi_load_from_memory(bytes.data, size, &width, &height, &channels, 4);
    if (!pixels) return refused("an image is truncated or damaged");
    MeshImage image{width, height, {pixels, pixels + static_cast<size_t>(width) * static_cast<size_t>(height) * 4}};
    stbi_image_free(pixels);
    return image;
}

struct Reading {
    tinygltf::Model model;
    Mesh mesh;
    std::map<int, int> images;  // of the model -> of the mesh
    std::vector<bool> visited;  // nodes
    size_t verticesRead = 0;    // of all primitives together: many small ones may share one large accessor
};

// The mesh's number of the image that a texture of the model shows.
Result<int> imageOf(Reading& r, int texture) {
    const tinygltf::Model& m = r.model;
    if (static_cast<size_t>(texture) >= m.textures.size())
        return refused("a material names a texture that is not there");
    const int source = m.textures[static_cast<size_t>(texture)].source;
    if (source < 0 || static_cast<size_t>(source) >= m.images.size())
        return refused("a texture names no image that is there");
    if (const auto known = r.images.find(source); known != r.images.end()) return known->second;
    const tinygltf::Image& image = m.images[static_cast<size_t>(source)];
    const Result<Bytes> bytes = image.bufferView >= 0 ? bytesOf(m, image.bufferView, "an image")
                                                      : Bytes{image.image.data(), image.image.size()};
    if (!bytes) return bytes.error();
    Result<MeshImage> decoded = decode(*bytes);
    if (!decoded) return decoded.error();
    r.mesh.images.push_back(std::move(*decoded));
    return r.images[source] = static_cast<int>(r.mesh.images.size()) - 1;
}

Result<MeshPart> materialOf(Reading& r, int material) {
    MeshPart part;
    if (material < 0) return part;
    if (static_cast<size_t>(material) >= r.model.materials.size())
        return refused("a primitive names a material that is not there");
    const tinygltf::Material& m = r.model.materials[static_cast<size_t>(material)];
    const auto& factor = m.pbrMetallicRoughness.baseColorFactor;
    for (int c = 0; c < 3 && factor.size() == 4; ++c)
        part.color[c] = static_cast<float>(factor[static_cast<size_t>(c)]);
    if (!finite(part.color)) return refused("a base colour is not finite");
    part.color = glm::clamp(part.color, 0.0f, 1.0f);
    if (m.alphaMode == "MASK") part.cutoff = std::clamp(static_cast<float>(m.alphaCutoff), 0.0f, 1.0f);
    if (m.alphaMode == "BLEND") part.cutoff = 0.5f;
    if (m.pbrMetallicRoughness.baseColorTexture.index >= 0) {
        const Result<int> image = imageOf(r, m.pbrMetallicRoughness.baseColorTexture.index);
        if (!image) return image.error();
        part.image = *image;
    }
    return part;
}

// --- nodes -------------------------------------------------------------------------------------------------------
Status addPrimitive(Reading& r, const tinygltf::Primitive& p, const Placed& at) {
    if (p.mode >= 0 && p.mode < TINYGLTF_MODE_TRIANGLES) return {};  // points and lines have no surface
    Result<MeshPart> part = materialOf(r, p.material);
    if (!part) return part.error();
    bool hasNormals = false;
    Result<std::vector<MeshVertex>> vertices = verticesOf(r.model, p, at, hasNormals);
    if (!vertices) return vertices.error();
    if ((r.verticesRead += vertices->size()) > kMaxVerticesRead)
        return refused(fmt::format("its parts take {} vertices or more together; the limit is {}", r.verticesRead,
                                   kMaxVerticesRead),
                       "make the object simpler, or of fewer parts");
    Result<std::vector<uint32_t>> order = trianglesOf(r.model, p, vertices->size());
    if (!order) return order.error();
    if (Status s = checkMeshTriangles((r.mesh.indices.size() + order->size()) / 3); !s) return s;
    if (at.mirrors())
        for (size_t i = 0; i + 2 < order->size(); i += 3) std::swap((*order)[i + 1], (*order)[i + 2]);
    hasNormals ? compact(*vertices, *order) : flatten(*vertices, *order);
    part->first = static_cast<uint32_t>(r.mesh.indices.size());
    part->count = static_cast<uint32_t>(order->size());
    const uint32_t base = static_cast<uint32_t>(r.mesh.vertices.size());
    for (const uint32_t i : *order) r.mesh.indices.push_back(base + i);
    r.mesh.vertices.insert(r.mesh.vertices.end(), vertices->begin(), vertices->end());
    if (part->count > 0) r.mesh.parts.push_back(*part);
    return {};
}

glm::dmat4 matrixOf(const tinygltf::Node& n) {
    glm::dmat4 m(1);
    if (n.matrix.size() == 16) {
        for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = n.matrix[static_cast<size_t>(i)];
        return m;
    }
    if (n.rotation.size() == 4)
        m = glm::mat4_cast(glm::dquat(n.rotation[3], n.rotation[0], n.rotation[1], n.rotation[2]));
    for (int c = 0; c < 3 && n.scale.size() == 3; ++c) m[c] *= n.scale[static_cast<size_t>(c)];
    for (int c = 0; c < 3 && n.translation.size() == 3; ++c) m[3][c] = n.translation[static_cast<size_t>(c)];
    return m;
}

// The node and what hangs on it, without recursion: chains of nodes may be long.
Status addNodes(Reading& r, int root) {
    std::vector<std::pair<int, glm::dmat4>> left{{root, glm::dmat4(1)}};
    while (!left.empty()) {
        const auto [index, parent] = left.back();
        left.pop_back();
        if (index < 0 || static_cast<size_t>(index) >= r.model.nodes.size())
            return refused(fmt::format("names node {}, which is not there", index));
        if (r.visited[static_cast<size_t>(index)])
            return refused(fmt::format("node {} hangs on several: nodes must make trees", index));
        r.visited[static_cast<size_t>(index)] = true;
        const tinygltf::Node& n = r.model.nodes[static_cast<size_t>(index)];
        const Placed at{parent * matrixOf(n)};
        for (const int child : n.children) left.push_back({child, at.matrix});
        if (n.mesh < 0) continue;
        if (static_cast<size_t>(n.mesh) >= r.model.meshes.size())
            return refused(fmt::format("node {} names mesh {}, which is not there", index, n.mesh));
        for (const tinygltf::Primitive& p : r.model.meshes[static_cast<size_t>(n.mesh)].primitives)
            if (Status s = addPrimitive(r, p, at); !s) return s;
    }
    return {};
}

// The nodes of the scene to show; without scenes those that hang on none.
Result<std::vector<int>> rootNodes(const tinygltf::Model& m) {
    if (!m.scenes.empty()) {
        const int scene = m.defaultScene < 0 ? 0 : m.defaultScene;
        if (static_cast<size_t>(scene) >= m.scenes.size()) return refused("names a scene that is not there");
        return m.scenes[static_cast<size_t>(scene)].nodes;
    }
    std::vector<bool> hangs(m.nodes.size());
    for (const tinygltf::Node& n : m.nodes)
        for (const int child : n.children)
            if (child >= 0 && static_cast<size_t>(child) < hangs.size()) hangs[static_cast<size_t>(child)] = true;
    std::vector<int> roots;
    for (size_t i = 0; i < hangs.size(); ++i)
        if (!hangs[i]) roots.push_back(static_cast<int>(i));
    return roots;
}

// --- reading -----------------------------------------------------------------------------------------------------
Result<Mesh> readFrom(const fs::path& root, const std::string& file) {
    const Result<fs::path> place = currentFile(root, file);
    if (!place) return place.error();
    const Result<std::string> bytes = readFile(*place, kMaxMeshBytes);
    return bytes ? readMeshBytes(*bytes, root, file) : bytes.error();
}

}  // namespace

void updateBounds(Mesh& mesh) {
    mesh.low = mesh.high = mesh.vertices.empty() ? glm::vec3(0) : mesh.vertices[0].position;
    for (const MeshVertex& v : mesh.vertices) {
        mesh.low = glm::min(mesh.low, v.position);
        mesh.high = glm::max(mesh.high, v.position);
    }
}

Status checkMeshTriangles(size_t count) {
    if (count <= kMaxMeshTriangles) return {};
    return refused(fmt::format("has more than {} triangles: {} at least", kMaxMeshTriangles, count),
                   "make the object simpler");
}

Result<Mesh> readMeshBytes(const std::string& bytes, const fs::path& root, const std::string& file) {
    if (bytes.empty()) return refused("is empty");
    if (Status s = checkGltfHead(bytes, file); !s) return s.error();
    Reading r;
    Files files{root, {file}, {}};
    if (Status s = parse(r.model, bytes, fs::path(file).parent_path().generic_string(), files); !s) return s.error();
    const Result<std::vector<int>> roots = rootNodes(r.model);
    if (!roots) return roots.error();
    r.visited.resize(r.model.nodes.size());
    for (const int node : *roots)
        if (Status s = addNodes(r, node); !s) return s.error();
    if (r.mesh.indices.empty())
        return refused("has no mesh with triangles in its scene", "export the object's meshes with it");
    r.mesh.files = std::move(files.read);
    updateBounds(r.mesh);
    return std::move(r.mesh);
}

Result<Mesh> readMesh(const fs::path& root, const std::string& file) {
    Result<Mesh> mesh = readFrom(root, file);
    if (mesh) return mesh;
    Error e = mesh.error();
    e.file = (root / file).string();
    return e;
}

}  // namespace sward
