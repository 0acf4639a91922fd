#include "objects/mesh.h"

#include "core/hash.h"
#include "core/log.h"
#include "frame/color_image.h"
#include "frame/draw_context.h"
#include "mesh/mesh_io.h"
#include "shared/objects.h"
#include "world/placement.h"

namespace sward {
namespace {

constexpr const char* kOwner = "objects/mesh";

struct GpuMesh {
    std::string version = "?";  // of the file, as it was read
    Buffer vertices, indices;
    VertexArray mesh;
    std::vector<Texture> images;
    std::vector<MeshPart> parts;  // none: the file cannot be read
    glm::vec3 centre{0};
    float radius = 0;
};
// Those of one file: first the seen, then the unseen that cast shadows.
struct Group {
    const GpuMesh* mesh = nullptr;
    size_t first = 0, seen = 0;
};
struct MeshState : EffectState {
    std::map<std::string, GpuMesh> meshes;  // by file
    Buffer instances;
    Texture white;
    std::vector<ObjectInstance> rows;
    std::vector<Group> groups;
};

std::unique_ptr<EffectState> makeState(DrawContext& ctx) {
    auto s = std::make_unique<MeshState>();
    s->white = makeColorTexture(ctx.gpu, kOwner, {1, 1, {255, 255, 255, 255}});
    return s;
}

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

GpuMesh uploadMesh(Gpu& gpu, const Mesh& mesh) {
    GpuMesh out;
    out.vertices = makeBuffer(gpu, kOwner, mesh.vertices.size() * sizeof(MeshVertex), mesh.vertices.data());
    out.indices = makeBuffer(gpu, kOwner, mesh.indices.size() * 4, mesh.indices.data());
    out.mesh = makeVertexArray(kOwner);
    for (const MeshImage& image : mesh.images)
        out.images.push_back(makeColorTexture(gpu, kOwner, {image.width, image.height, image.rgba}));
    out.parts = mesh.parts;
    out.centre = (mesh.low + mesh.high) * 0.5f;
    out.radius = glm::length(mesh.high - mesh.low) * 0.5f;
    describe(out);
    return out;
}

// The file's mesh; read again when the file changed. What cannot be read is told once and not drawn.
const GpuMesh& meshOf(DrawContext& ctx, MeshState& s, const std::string& file) {
    GpuMesh& m = s.meshes[file];
    std::string version = fileVersion(ctx.project.dir, file);
    if (m.version == version) return m;
    const Result<Mesh> mesh = readMesh(ctx.project.dir, file);
    m = mesh ? uploadMesh(ctx.gpu, *mesh) : GpuMesh{};
    m.version = std::move(version);
    if (!mesh) logWarning(mesh.error().text() + "; the object is not drawn");
    return m;
}

ObjectInstance instanceOf(const PlacedMesh& p, const glm::dvec3& eye) {
    ObjectInstance out;
    const glm::dvec3 at = p.at - eye;
    for (int r = 0; r < 3; ++r) {
        const glm::dvec3 row =
            glm::dvec3(p.turn[0][r], p.turn[1][r], p.turn[2][r]) * static_cast<double>(p.mesh->scale);
        out.row[r] = glm::vec4(glm::vec3(row), static_cast<float>(at[r]));
    }
    return out;
}

struct Ball {
    glm::vec3 centre;
    float radius;
};
Ball ballOf(const GpuMesh& m, const ObjectInstance& i, float scale) {
    const glm::vec4 c(m.centre, 1);
    return {{glm::dot(i.row[0], c), glm::dot(i.row[1], c), glm::dot(i.row[2], c)}, m.radius * scale};
}

void cast(DrawContext& ctx, const GpuMesh& m, const Ball& ball, size_t instance) {
    for (const MeshPart& part : m.parts)
        ctx.shared.casters.push_back({m.mesh.id(), static_cast<GLuint>(instance), part.first, part.count,
                                      part.image >= 0 ? m.images[static_cast<size_t>(part.image)].id() : 0, part.cutoff,
                                      ball.centre, ball.radius});
}

// Adds those of one file.
void addGroup(DrawContext& ctx, MeshState& s, const GpuMesh& m, const std::vector<const PlacedMesh*>& placed) {
    if (m.parts.empty()) return;
    Group group{&m, s.rows.size(), 0};
    std::vector<std::pair<ObjectInstance, Ball>> unseen;
    for (const PlacedMesh* p : placed) {
        const ObjectInstance row = instanceOf(*p, ctx.camera.eye);
        const Ball ball = ballOf(m, row, p->mesh->scale);
        const bool seen = ctx.frustum.touches(ball.centre - ball.radius, ball.centre + ball.radius);
        if (seen && p->mesh->castShadows) cast(ctx, m, ball, s.rows.size());
        if (seen) s.rows.push_back(row);
        if (!seen && p->mesh->castShadows) unseen.push_back({row, ball});
    }
    group.seen = s.rows.size() - group.first;
    for (const auto& [row, ball] : unseen) {
        cast(ctx, m, ball, s.rows.size());
        s.rows.push_back(row);
    }
    s.groups.push_back(group);
}

uint64_t hashOf(const DrawContext& ctx, const MeshState& s, const std::vector<PlacedMesh>& placed) {
    Hasher h;
    const auto add = [&](const auto& v) { h.add(&v, sizeof(v)); };
    for (const PlacedMesh& p : placed) {
        if (!p.mesh->castShadows) continue;
        for (int c = 0; c < 3; ++c) add(p.turn[c]);
        add(p.at), add(p.mesh->scale);
        const std::string& version = s.meshes.at(p.mesh->file).version;
        h.add(version.data(), version.size());
    }
    return ctx.shared.casters.empty() ? 0 : h.value();
}

void place(DrawContext& ctx) {
    MeshState& s = ctx.own<MeshState>();
    const std::vector<PlacedMesh> placed = placedMeshes(ctx.project);
    std::map<std::string, std::vector<const PlacedMesh*>> byFile;
    for (const PlacedMesh& p : placed) byFile[p.mesh->file].push_back(&p);
    std::erase_if(s.meshes, [&](const auto& m) { return !byFile.contains(m.first); });
    s.rows.clear();
    s.groups.clear();
    ctx.shared.casters.clear();
    for (const auto& [file, those] : byFile) addGroup(ctx, s, meshOf(ctx, s, file), those);
    ctx.shared.castersHash = hashOf(ctx, s, placed);
    writeBuffer(ctx.gpu, s.instances, kOwner, s.rows.size() * sizeof(ObjectInstance), s.rows.data());
    for (const Group& g : s.groups)
        glVertexArrayVertexBuffer(g.mesh->mesh.id(), 1, s.instances.id(), 0, sizeof(ObjectInstance));
}

void drawGroup(DrawContext& ctx, const MeshState& s, const Group& g) {
    glBindVertexArray(g.mesh->mesh.id());
    for (const MeshPart& part : g.mesh->parts) {
        glBindTextureUnit(TEX_OBJECT,
                          part.image >= 0 ? g.mesh->images[static_cast<size_t>(part.image)].id() : s.white.id());
        glUniform4f(0, part.color.x, part.color.y, part.color.z, part.cutoff);
        glDrawElementsInstancedBaseInstance(GL_TRIANGLES, static_cast<GLsizei>(part.count), GL_UNSIGNED_INT,
                                            reinterpret_cast<const void*>(size_t(part.first) * 4),
                                            static_cast<GLsizei>(g.seen), static_cast<GLuint>(g.first));
        ctx.pass->draws += 1;
        ctx.pass->instances += g.seen;
    }
}

void draw(DrawContext& ctx) {
    const MeshState& s = ctx.own<MeshState>();
    if (!ctx.use()) return;  // also while none is seen: no halt when the first comes into view
    for (const Group& g : s.groups)
        if (g.seen > 0) drawGroup(ctx, s, g);
}

const System kSystems[] = {{"objects/place", place}};
const ProgramRow kPrograms[] = {{"objects/mesh", "objects/mesh.vert.glsl", "objects/mesh.frag.glsl", nullptr,
                                 featureSet(Feature::ObjectShadows, Feature::TerrainShadows, Feature::Sun, Feature::Sky,
                                            Feature::Fog, Feature::WaterReflection)}};
const Pass kPasses[] = {{"objects/mesh", Stage::Opaque, kViewMain | kViewReflection | kViewCompare, 0,
                         kSceneColor | kSceneDepth, kPrograms, draw}};

}  // namespace

const EffectRow& meshEffect() {
    static const EffectRow row{"objects/mesh", featureSet(Feature::Objects), kSystems, kPasses,
                               makeState,      "objects stand in the scene"};
    return row;
}

}  // namespace sward
