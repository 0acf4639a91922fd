#include "objects/scatter.h"

#include <algorithm>

#include "core/hash.h"
#include "core/log.h"
#include "frame/gpu_mesh.h"
#include "world/scatter.h"

namespace sward {
namespace {

constexpr const char* kOwner = "objects/scatter";
constexpr double kSquare = 32;              // metres, of what is seen or not as one
constexpr float kScatterShadowsFrom = 400;  // metres from the eye to which what is not seen may cast shadows into view

// Objects of one mesh whose origins lie in one square.
struct ScatterChunk {
    size_t first = 0, count = 0;
    glm::dvec3 centre{0};  // of their origins, in the world
    float radius = 0;      // of a ball around those
    float largest = 0;     // scale
};
// One mesh of one entity.
struct ScatterKind {
    std::string file;
    std::vector<ScatteredObject> objects;  // chunk by chunk
    std::vector<ScatterChunk> chunks;
};
struct ScatterEntry {
    std::shared_ptr<const Scattering> of;
    std::vector<std::string> files;
    std::vector<ScatterKind> kinds;
};
struct ScatterState : EffectState {
    GpuMeshes meshes;
    ScatterMemory memory;
    std::map<std::string, ScatterEntry> entries;  // by entity
    explicit ScatterState(Gpu& gpu) : meshes(gpu, kOwner) {}
};
// Rows of one mesh: first the seen.
struct ScatterGroup {
    const GpuMesh* mesh;
    size_t first, seen;
};
struct ScatterView : EffectState {
    Buffer instances;
    std::vector<ObjectInstance> rows;
    std::vector<ScatterGroup> groups;
};

glm::ivec2 squareOf(const glm::dvec3& at) { return {std::floor(at.x / kSquare), std::floor(at.z / kSquare)}; }

void addChunk(ScatterKind& k, size_t first, size_t end) {
    ScatterChunk c{first, end - first};
    glm::dvec3 low = k.objects[first].at, high = low;
    for (size_t i = first; i < end; ++i) {
        low = glm::min(low, k.objects[i].at), high = glm::max(high, k.objects[i].at);
        c.largest = std::max(c.largest, k.objects[i].scale);
    }
    c.centre = (low + high) * 0.5;
    c.radius = static_cast<float>(glm::length(high - low) * 0.5);
    k.chunks.push_back(c);
}

void sortIntoChunks(ScatterKind& k) {
    const auto key = [](const ScatteredObject& o) {
        const glm::ivec2 square = squareOf(o.at);
        return std::pair(square.y, square.x);
    };
    std::stable_sort(k.objects.begin(), k.objects.end(),
                     [&](const ScatteredObject& a, const ScatteredObject& b) { return key(a) < key(b); });
    for (size_t i = 0, end = 0; i < k.objects.size(); i = end) {
        while (end < k.objects.size() && key(k.objects[end]) == key(k.objects[i])) ++end;
        addChunk(k, i, end);
    }
}

std::vector<std::string> filesOf(const Scatter& s) {
    std::vector<std::string> files;
    for (const ScatterMesh& m : s.meshes) files.push_back(m.file);
    return files;
}

void follow(ScatterEntry& e, const std::string& entity, const Scatter& s, std::shared_ptr<const Scattering> now) {
    std::vector<std::string> files = filesOf(s);
    if (e.of == now && e.files == files) return;
    if (const std::string said = e.of == now ? "" : shortfall(entity, s, *now); !said.empty()) logWarning(said);
    e.of = std::move(now);
    e.files = std::move(files);
    e.kinds.assign(s.meshes.size(), {});
    for (const ScatteredObject& o : e.of->objects) e.kinds[o.mesh].objects.push_back(o);
    for (size_t i = 0; i < e.kinds.size(); ++i) {
        e.kinds[i].file = e.files[i];
        sortIntoChunks(e.kinds[i]);
    }
}

struct ScatterBall {
    glm::vec3 centre;  // relative to the eye
    float radius;
};
ScatterBall ballOf(const ScatterChunk& c, const GpuMesh& m, const glm::dvec3& eye) {
    return {glm::vec3(c.centre - eye), c.radius + (glm::length(m.centre) + m.radius) * c.largest};
}

void addRows(DrawContext& ctx, ScatterView& view, const ScatterKind& k, const GpuMesh& m, const ScatterChunk& c,
             bool casts) {
    const ScatterBall ball = ballOf(c, m, ctx.camera.eye);
    if (casts) addCaster(ctx, m, view.rows.size(), c.count, ball.centre, ball.radius);
    for (size_t i = c.first; i < c.first + c.count; ++i) {
        const ScatteredObject& o = k.objects[i];
        view.rows.push_back(instanceAt(o.at - ctx.camera.eye, glm::dmat3(o.turn * o.scale)));
    }
}

void addKind(DrawContext& ctx, ScatterView& view, const ScatterKind& k, const GpuMesh& m, bool casts) {
    if (m.parts.empty()) return;
    ScatterGroup group{&m, view.rows.size(), 0};
    std::vector<const ScatterChunk*> unseen;
    for (const ScatterChunk& c : k.chunks) {
        const ScatterBall ball = ballOf(c, m, ctx.camera.eye);
        if (ctx.frustum.touches(ball.centre - ball.radius, ball.centre + ball.radius))
            addRows(ctx, view, k, m, c, casts);
        else if (casts && glm::length(ball.centre) < kScatterShadowsFrom + ball.radius)
            unseen.push_back(&c);
    }
    group.seen = view.rows.size() - group.first;
    for (const ScatterChunk* c : unseen) addRows(ctx, view, k, m, *c, true);
    view.groups.push_back(group);
}

void placeScattered(DrawContext& ctx) {
    ScatterState& s = ctx.own<ScatterState>();
    ScatterView& view = ctx.ofView<ScatterView>();
    const auto all = scattersOf(ctx.project);
    const Ground ground = findGround(ctx.project);
    s.memory.keepOnly(all);
    std::erase_if(s.entries, [&](const auto& e) {
        return std::none_of(all.begin(), all.end(), [&](const auto& a) { return a.first == e.first; });
    });
    view.rows.clear();
    view.groups.clear();
    Hasher hash;
    std::vector<std::string> files;
    for (const auto& [entity, scatter] : all) {
        ScatterEntry& e = s.entries[entity];
        follow(e, entity, *scatter, s.memory.of(ctx.project, ground, entity, *scatter));
        for (const ScatterKind& k : e.kinds) {
            if (k.objects.empty()) continue;
            addKind(ctx, view, k, s.meshes.of(ctx, k.file), scatter->castShadows);
            files.push_back(k.file);
            if (scatter->castShadows) hash.add(s.meshes.version(k.file).data(), s.meshes.version(k.file).size());
        }
        if (scatter->castShadows) hash.add(&e.of->hash, sizeof e.of->hash);
    }
    s.meshes.keepIf([&](const std::string& f) { return std::find(files.begin(), files.end(), f) != files.end(); });
    ctx.shared.castersHash += hash.value();
    writeBuffer(ctx.gpu, view.instances, kOwner, view.rows.size() * sizeof(ObjectInstance), view.rows.data());
    for (const ScatterGroup& g : view.groups)
        glVertexArrayVertexBuffer(g.mesh->mesh.id(), 1, view.instances.id(), 0, sizeof(ObjectInstance));
}

void drawScattered(DrawContext& ctx) {
    const ScatterState& s = ctx.own<ScatterState>();
    if (!ctx.use()) return;
    for (const ScatterGroup& g : ctx.ofView<ScatterView>().groups)
        if (g.seen > 0) s.meshes.draw(ctx, *g.mesh, g.first, g.seen);
}

const System kSystems[] = {{"objects/scatter/place", {.appends = {Slot::Casters}}, placeScattered}};
const ProgramRow kPrograms[] = {{"objects/scatter", "objects/mesh.vert.glsl", "objects/mesh.frag.glsl", nullptr}};
const Pass kPasses[] = {{"objects/scatter",
                         Stage::Opaque,
                         kViewMain | kViewReflection,
                         {.reads = {Slot::Shadows}, .appends = {Slot::SceneColor, Slot::SceneDepth}},
                         kPrograms,
                         drawScattered}};

}  // namespace

const EffectRow& scatterEffect() {
    static const EffectRow row{
        "objects/scatter",
        featureSet(Feature::Scatter, Feature::Terrain),
        kSystems,
        kPasses,
        [](DrawContext& ctx) -> std::unique_ptr<EffectState> { return std::make_unique<ScatterState>(ctx.gpu); },
        "objects are scattered over the terrain",
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<ScatterView>(); }};
    return row;
}

}  // namespace sward
