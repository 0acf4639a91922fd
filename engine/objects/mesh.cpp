#include "objects/mesh.h"

#include "core/hash.h"
#include "frame/gpu_mesh.h"
#include "frame/object_light.h"
#include "world/placement.h"

namespace sward {
namespace {

constexpr const char* kOwner = "objects/mesh";

// Those of one file: first the seen, then the unseen that cast shadows.
struct MeshGroup {
    const GpuMesh* mesh = nullptr;
    size_t first = 0, seen = 0;
};
struct MeshState : EffectState {
    GpuMeshes meshes;
    explicit MeshState(Gpu& gpu) : meshes(gpu, kOwner) {}
};
struct MeshView : EffectState {
    Buffer instances, lights;
    std::vector<ObjectInstance> rows;
    std::vector<uint32_t> firstLights;  // of the rows: numbers of their first vertices (frame/object_light.h)
    std::vector<MeshGroup> groups;
};

std::unique_ptr<EffectState> makeMeshState(DrawContext& ctx) { return std::make_unique<MeshState>(ctx.gpu); }

ObjectInstance instanceOf(const PlacedMesh& p, const glm::dvec3& eye) {
    return instanceAt(p.at - eye, p.turn * static_cast<double>(p.mesh->scale));
}

struct MeshBall {
    glm::vec3 centre;
    float radius;
};
MeshBall ballOf(const GpuMesh& m, const ObjectInstance& i, float scale) {
    const glm::vec4 c(m.centre, 1);
    return {{glm::dot(i.row[0], c), glm::dot(i.row[1], c), glm::dot(i.row[2], c)}, m.radius * scale};
}

// Adds those of one file.
void addGroup(DrawContext& ctx, MeshView& s, const GpuMesh& m, const std::vector<const PlacedMesh*>& placed) {
    if (m.parts.empty()) return;
    MeshGroup group{&m, s.rows.size(), 0};
    std::vector<std::pair<ObjectInstance, MeshBall>> unseen;
    for (const PlacedMesh* p : placed) {
        const ObjectInstance row = instanceOf(*p, ctx.camera.eye);
        const MeshBall ball = ballOf(m, row, p->mesh->scale);
        const bool seen = ctx.frustum.touches(ball.centre - ball.radius, ball.centre + ball.radius);
        if (seen && p->mesh->castShadows) addCaster(ctx, m, s.rows.size(), 1, ball.centre, ball.radius);
        if (seen) s.rows.push_back(row), s.firstLights.push_back(firstLightOf(ctx, p->entity));
        if (!seen && p->mesh->castShadows) unseen.push_back({row, ball});
    }
    group.seen = s.rows.size() - group.first;
    for (const auto& [row, ball] : unseen) {
        addCaster(ctx, m, s.rows.size(), 1, ball.centre, ball.radius);
        s.rows.push_back(row), s.firstLights.push_back(NO_OBJECT_LIGHT);
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
        const std::string& version = s.meshes.version(p.mesh->file);
        h.add(version.data(), version.size());
    }
    return ctx.shared.casters.empty() ? 0 : h.value();
}

// Gives a mesh the numbers of its instances' first vertices where scenes have light for them.
void setLights(const DrawContext& ctx, const GpuMesh& m, const Buffer& lights) {
    const GLuint mesh = m.mesh.id();
    if (!ctx.shared.objectLight)
        return glDisableVertexArrayAttrib(mesh, 6), glVertexArrayVertexBuffer(mesh, 2, 0, 0, 4);
    glEnableVertexArrayAttrib(mesh, 6);
    glVertexArrayAttribIFormat(mesh, 6, 1, GL_UNSIGNED_INT, 0);
    glVertexArrayAttribBinding(mesh, 6, 2);
    glVertexArrayBindingDivisor(mesh, 2, 1);
    glVertexArrayVertexBuffer(mesh, 2, lights.id(), 0, sizeof(uint32_t));
}

void placeObjects(DrawContext& ctx) {
    MeshState& s = ctx.own<MeshState>();
    MeshView& view = ctx.ofView<MeshView>();
    const std::vector<PlacedMesh> placed = placedMeshes(ctx.project);
    std::map<std::string, std::vector<const PlacedMesh*>> byFile;
    for (const PlacedMesh& p : placed) byFile[p.mesh->file].push_back(&p);
    s.meshes.keepIf([&](const std::string& file) { return byFile.contains(file); });
    view.rows.clear();
    view.firstLights.clear();
    view.groups.clear();
    for (const auto& [file, those] : byFile) addGroup(ctx, view, s.meshes.of(ctx, file), those);
    ctx.shared.castersHash += hashOf(ctx, s, placed);
    writeBuffer(ctx.gpu, view.instances, kOwner, view.rows.size() * sizeof(ObjectInstance), view.rows.data());
    if (ctx.shared.objectLight)
        writeBuffer(ctx.gpu, view.lights, kOwner, view.firstLights.size() * sizeof(uint32_t), view.firstLights.data());
    else
        view.lights = {};
    for (const MeshGroup& g : view.groups) {
        glVertexArrayVertexBuffer(g.mesh->mesh.id(), 1, view.instances.id(), 0, sizeof(ObjectInstance));
        setLights(ctx, *g.mesh, view.lights);
    }
}

void drawObjects(DrawContext& ctx) {
    const MeshState& s = ctx.own<MeshState>();
    if (!ctx.use()) return;  // also while none is seen: no halt when the first comes into view
    bindObjectLight(ctx);
    for (const MeshGroup& g : ctx.ofView<MeshView>().groups)
        if (g.seen > 0) s.meshes.draw(ctx, *g.mesh, g.first, g.seen);
}

const System kSystems[] = {{"objects/place", {.reads = {Slot::ObjectLight}, .appends = {Slot::Casters}}, placeObjects}};
const ProgramRow kPrograms[] = {{"objects/mesh", "objects/mesh.vert.glsl", "objects/mesh.frag.glsl", nullptr}};
const Pass kPasses[] = {{"objects/mesh",
                         Stage::Opaque,
                         kViewMain | kViewReflection,
                         {.reads = {Slot::Shadows}, .appends = {Slot::SceneColor, Slot::SceneDepth}},
                         kPrograms,
                         drawObjects,
                         {},
                         false,
                         true}};

}  // namespace

const EffectRow& meshEffect() {
    static const EffectRow row{
        "objects/mesh",
        featureSet(Feature::Objects),
        kSystems,
        kPasses,
        makeMeshState,
        "objects stand in the scene",
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<MeshView>(); }};
    return row;
}

}  // namespace sward
