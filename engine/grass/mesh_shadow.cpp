#include "grass/mesh_shadow.h"

#include "core/hash.h"
#include "frame/gpu_mesh.h"
#include "scene/tiling.h"

namespace sward {
namespace {

std::vector<glm::vec3> shellOf(const MeshCarrier& carrier, const MapField& density, float height) {
    std::vector<glm::vec3> out;
    for (const CarrierVertex& v : carrier.vertices) {
        const float grows =
            density.present() ? tiledSample(density.map, {glm::dvec2(1), true}, double(v.uv.x), double(v.uv.y)) : 1.0f;
        out.push_back(v.position + v.normal * (v.lift * height * shadowHeight(grows)));
    }
    return out;
}

// As drawCaster wants it; nothing is cut out, so that texture coordinates are not read.
void describe(const MeshShadow& s) {
    const GLuint mesh = s.mesh.id();
    glVertexArrayVertexBuffer(mesh, 0, s.vertices.id(), 0, sizeof(glm::vec3));
    glVertexArrayElementBuffer(mesh, s.indices.id());
    glVertexArrayBindingDivisor(mesh, 1, 1);
    const auto attribute = [&](GLuint number, GLuint binding, int channels, size_t offset) {
        glEnableVertexArrayAttrib(mesh, number);
        glVertexArrayAttribBinding(mesh, number, binding);
        glVertexArrayAttribFormat(mesh, number, channels, GL_FLOAT, GL_FALSE, static_cast<GLuint>(offset));
    };
    attribute(0, 0, 3, 0);
    for (GLuint row = 0; row < 3; ++row) attribute(3 + row, 1, 4, row * sizeof(glm::vec4));
}

}  // namespace

// Thin grass lets light in down to its feet.
float shadowHeight(float density) {
    constexpr float kHalf = 0.15f;  // density at which it is about half
    return std::clamp(density, 0.0f, 1.0f) * (1 + kHalf) / (std::clamp(density, 0.0f, 1.0f) + kHalf);
}

void updateMeshShadow(DrawContext& ctx, MeshShadow& s, const char* owner, const MeshCarrier& carrier,
                      const std::string& version, const MapField& density, float height, float scale) {
    const float high = height / scale;
    if (s.version == version && s.height == high && s.density.sameTiles(density.map)) return;
    const std::vector<glm::vec3> vertices = shellOf(carrier, density, high);
    s.vertices = makeBuffer(ctx.gpu, owner, vertices.size() * sizeof(glm::vec3), vertices.data());
    s.indices = makeBuffer(ctx.gpu, owner, carrier.indices.size() * sizeof(uint32_t), carrier.indices.data());
    s.mesh = makeVertexArray(owner);
    describe(s);
    s.version = version, s.density = density.map, s.height = high;
    s.indexCount = static_cast<uint32_t>(carrier.indices.size());
    s.hash = hashBytes(vertices.data(), vertices.size() * sizeof(glm::vec3));
    glm::vec3 low(1e30f), far(-1e30f);
    for (const glm::vec3& v : vertices) low = glm::min(low, v), far = glm::max(far, v);
    s.centre = (low + far) * 0.5f, s.radius = glm::length(far - low) * 0.5f;
}

void castMeshShadow(DrawContext& ctx, const MeshShadow& s, const PlacedMesh& placed, const Buffer& rows,
                    size_t instance) {
    const double scale = static_cast<double>(placed.mesh->scale);
    glVertexArrayVertexBuffer(s.mesh.id(), 1, rows.id(), 0, sizeof(ObjectInstance));
    const glm::vec3 centre(placed.at - ctx.camera.eye + placed.turn * (scale * glm::dvec3(s.centre)));
    ctx.shared.casters.push_back({.vertexArray = s.mesh.id(),
                                  .instance = static_cast<GLuint>(instance),
                                  .indices = s.indexCount,
                                  .centre = centre,
                                  .radius = s.radius * placed.mesh->scale,
                                  .behind = true});
    Hasher h;
    for (int c = 0; c < 3; ++c) h.add(&placed.turn[c], sizeof placed.turn[c]);
    h.add(&placed.at, sizeof placed.at), h.add(&placed.mesh->scale, sizeof placed.mesh->scale);
    h.add(&s.hash, sizeof s.hash);
    ctx.shared.castersHash += h.value();
}

}  // namespace sward
