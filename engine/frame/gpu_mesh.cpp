#include "frame/gpu_mesh.h"

#include "core/log.h"
#include "frame/color_image.h"
#include "mesh/mesh_io.h"
#include "world/placement.h"

namespace sward {
namespace {

void describe(GpuMesh& m) {
    const GLuint mesh = m.mesh.id();
    glVertexArrayVertexBuffer(mesh, 0, m.vertices.id(), 0, sizeof(MeshVertex));
    glVertexArrayElementBuffer(mesh, m.indices.id());
    glVertexArrayBindingDivisor(mesh, 1, 1);
    for (GLuint attribute = 0; attribute < 6; ++attribute) {
        glEnableVertexArrayAttrib(mesh, attribute);
        glVertexArrayAttribBinding(mesh, attribute, attribute < 3 ? 0 : 1);
    }
    glVertexArrayAttribFormat(mesh, 0, 3, GL_FLOAT, GL_FALSE, offsetof(MeshVertex, position));
    glVertexArrayAttribFormat(mesh, 1, 3, GL_FLOAT, GL_FALSE, offsetof(MeshVertex, normal));
    glVertexArrayAttribFormat(mesh, 2, 2, GL_FLOAT, GL_FALSE, offsetof(MeshVertex, uv));
    for (GLuint row = 0; row < 3; ++row)
        glVertexArrayAttribFormat(mesh, 3 + row, 4, GL_FLOAT, GL_FALSE, row * sizeof(glm::vec4));
}

}  // namespace

GpuMesh uploadMesh(Gpu& gpu, const char* owner, const Mesh& mesh) {
    GpuMesh out;
    out.vertices = makeBuffer(gpu, owner, mesh.vertices.size() * sizeof(MeshVertex), mesh.vertices.data());
    out.indices = makeBuffer(gpu, owner, mesh.indices.size() * 4, mesh.indices.data());
    out.mesh = makeVertexArray(owner);
    for (const MeshImage& image : mesh.images)
        out.images.push_back(makeColorTexture(gpu, owner, {image.width, image.height, image.rgba}));
    out.parts = mesh.parts;
    out.centre = (mesh.low + mesh.high) * 0.5f;
    out.radius = glm::length(mesh.high - mesh.low) * 0.5f;
    describe(out);
    return out;
}

GpuMeshes::GpuMeshes(Gpu& gpu, const char* owner)
    : owner_(owner), white_(makeColorTexture(gpu, owner, {1, 1, {255, 255, 255, 255}})) {}

const GpuMesh& GpuMeshes::of(DrawContext& ctx, const std::string& file) {
    GpuMesh& m = meshes_[file];
    std::string version = fileVersion(ctx.project.dir, file);
    if (m.version == version) return m;
    const Result<Mesh> mesh = readMesh(ctx.project.dir, file);
    m = mesh ? uploadMesh(ctx.gpu, owner_, *mesh) : GpuMesh{};
    m.version = std::move(version);
    if (!mesh) logWarning(mesh.error().text() + "; the object is not drawn");
    return m;
}

void drawMesh(DrawContext& ctx, const GpuMesh& mesh, const Texture& white, size_t first, size_t count) {
    glBindVertexArray(mesh.mesh.id());
    for (size_t i = 0; i < mesh.parts.size(); ++i) {
        const MeshPart& part = mesh.parts[i];
        if (!mesh.leaves.empty()) glUniform1f(2, mesh.leaves[i]);
        glBindTextureUnit(TEX_OBJECT, part.image >= 0 ? mesh.images[static_cast<size_t>(part.image)].id() : white.id());
        glUniform3f(0, part.color.x, part.color.y, part.color.z);
        glUniform1f(1, part.cutoff);
        glDrawElementsInstancedBaseInstance(GL_TRIANGLES, static_cast<GLsizei>(part.count), GL_UNSIGNED_INT,
                                            reinterpret_cast<const void*>(size_t(part.first) * 4),
                                            static_cast<GLsizei>(count), static_cast<GLuint>(first));
        ctx.pass->draws += 1;
        ctx.pass->instances += count;
    }
}

ObjectInstance instanceAt(const glm::dvec3& at, const glm::dmat3& turn) {
    ObjectInstance out;
    for (int r = 0; r < 3; ++r)
        out.row[r] = glm::vec4(glm::vec3(glm::dvec3(turn[0][r], turn[1][r], turn[2][r])), static_cast<float>(at[r]));
    return out;
}

void addCaster(DrawContext& ctx, const GpuMesh& mesh, size_t first, size_t count, const glm::vec3& centre,
               float radius) {
    for (const MeshPart& part : mesh.parts)
        ctx.shared.casters.push_back({mesh.mesh.id(), static_cast<GLuint>(first), part.first, part.count,
                                      part.image >= 0 ? mesh.images[static_cast<size_t>(part.image)].id() : 0,
                                      part.cutoff, centre, radius, static_cast<GLsizei>(count)});
}

}  // namespace sward
