#include "forest/trees.h"

#include <algorithm>
#include <array>

#include "core/hash.h"
#include "forest/stand.h"
#include "forest/tree_light.h"
#include "frame/color_image.h"
#include "frame/gpu_mesh.h"
#include "mesh/facing.h"
#include "world/forest_sway.h"

namespace sward {
namespace {

constexpr const char* kOwner = "forest/trees";
constexpr double kTreeShadowsFrom = 300;  // metres to which trees cast shadows: beyond the reach of all maps

// A species' mesh at one level, and what its leaves leave of the light from all around at its vertices.
struct TreeLevel : GpuMesh {
    Buffer shares;
};
using TreeLevels = std::array<TreeLevel, kTreeLevels>;
struct Uploaded {
    uint64_t grown = 0;       // ForestHere::grown
    float verticalScale = 1;  // Forest's
    std::vector<TreeLevels> species;
    uint64_t stood = 0;             // ForestHere::stood
    std::vector<glm::vec3> around;  // by tree: woodAround
};
struct TreesState : EffectState {
    std::map<std::string, Uploaded> forests;  // by entity
    Texture white;
    explicit TreesState(Gpu& gpu) : white(makeColorTexture(gpu, kOwner, {1, 1, {255, 255, 255, 255}})) {}
};
// Where an instance stands in its forest.
struct TreePlace {
    glm::vec2 stored;  // lattice coordinates in the cells that repeat
    glm::vec3 around;  // woodAround
};
// Instances of one mesh that are seen.
struct TreeGroup {
    const ForestHere* here;
    const TreeLevel* mesh;
    size_t species, first, seen;
};
struct TreesView : EffectState {
    Buffer instances, placesBuffer;
    std::vector<ObjectInstance> rows;
    std::vector<TreePlace> places;  // of each row
    std::vector<TreeGroup> groups;
    TreeSway sway;
};

constexpr GLuint kPlace = 6, kPlaceBinding = 2, kWood = 7, kAlone = 8, kAmong = 9, kOpen = 10, kSharesBinding = 3;

TreeLevel uploadTree(Gpu& gpu, const Mesh& mesh, const std::vector<VertexShares>& shares) {
    TreeLevel out{uploadMesh(gpu, kOwner, mesh), {}};
    out.leaves = leafParts(mesh);
    out.shares = makeBuffer(gpu, kOwner, shares.size() * sizeof(VertexShares), shares.data());
    const GLuint id = out.mesh.id();
    const auto attribute = [&](GLuint number, GLuint binding, GLint count, GLenum type, size_t offset) {
        glEnableVertexArrayAttrib(id, number);
        glVertexArrayAttribBinding(id, number, binding);
        glVertexArrayAttribFormat(id, number, count, type, type != GL_FLOAT, static_cast<GLuint>(offset));
    };
    attribute(kPlace, kPlaceBinding, 2, GL_FLOAT, offsetof(TreePlace, stored));
    attribute(kWood, kPlaceBinding, 3, GL_FLOAT, offsetof(TreePlace, around));
    glVertexArrayBindingDivisor(id, kPlaceBinding, 1);
    glVertexArrayVertexBuffer(id, kSharesBinding, out.shares.id(), 0, sizeof(VertexShares));
    attribute(kAlone, kSharesBinding, 4, GL_UNSIGNED_BYTE, offsetof(VertexShares, alone));
    attribute(kAmong, kSharesBinding, 4, GL_UNSIGNED_BYTE, offsetof(VertexShares, among));
    attribute(kOpen, kSharesBinding, 3, GL_BYTE, offsetof(VertexShares, open));
    return out;
}

void upload(DrawContext& ctx, Uploaded& u, const ForestHere& here) {
    if (u.grown == here.grown && u.verticalScale == here.rule.verticalScale) return;
    u.grown = here.grown, u.verticalScale = here.rule.verticalScale;
    u.species.clear();
    u.species.resize(here.meshes.size());
    std::vector<TreeAir> airs;
    for (const Mesh& m : here.meshes) airs.push_back(leafAir(m));
    const WoodAir wood = woodAir(here.stand->tiles, static_cast<double>(here.rule.perHectare), airs);
    const double up = static_cast<double>(u.verticalScale);
    for (size_t i = 0; i < here.meshes.size(); ++i)
        for (size_t l = 0; l < kTreeLevels && !here.meshes[i].parts.empty(); ++l) {
            const Mesh mesh = thinned(here.meshes[i], kTreeKeep[l]);
            u.species[i][l] = uploadTree(ctx.gpu, mesh, lightOnTree(mesh, airs[i], wood, up));
        }
}

void followStand(Uploaded& u, const ForestHere& here) {
    if (u.stood == here.stood) return;
    u.stood = here.stood;
    u.around = woodAround(*here.stand, static_cast<double>(here.rule.perHectare));
}

size_t levelAt(double distance, double height, double detail) {
    size_t level = 0;
    while (level + 1 < kTreeLevels && distance > kTreeLevelEnds[level] * detail * height / 12) ++level;
    return level;
}

// Factor of its mesh's reach in any direction.
float widest(const StandingTree& t) { return t.size * std::max(t.upright, 1.0f); }

using Chosen = std::vector<const StandingTree*>;  // of one mesh, in this frame

void addRow(const DrawContext& ctx, TreesView& view, const ForestHere& here, const Uploaded& u, const StandingTree& t) {
    const glm::dvec3 at = t.at - ctx.camera.eye;
    view.rows.push_back(instanceAt(at, view.sway.at(here.rule, {at.x, at.z}) * turnOf(t)));
    const size_t number = static_cast<size_t>(&t - here.stand->trees.data());
    view.places.push_back({t.stored, u.around[number]});
}

void addGroup(const DrawContext& ctx, TreesView& view, const ForestHere& here, const Uploaded& u, size_t species,
              const TreeLevel& m, const Chosen& seen) {
    view.groups.push_back({&here, &m, species, view.rows.size(), seen.size()});
    for (const StandingTree* t : seen) addRow(ctx, view, here, u, *t);
}

// What shadow maps are kept by: where the tree stands, at which level, and how it leans.
void hashCaster(Hasher& h, const TreesView& view, const StandingTree& t, const GpuMesh& m) {
    h.add(&t.at, sizeof t.at);
    h.add(&m.parts[0].count, sizeof(uint32_t));
    for (const glm::vec4& r : view.rows.back().row)
        for (int k = 0; k < 3; ++k) {
            const int64_t steps = std::llround(static_cast<double>(r[k]) * 10000);
            h.add(&steps, sizeof steps);
        }
}

bool drawsMeshes(const ForestHere& h) { return meshesTo(h.rule) > 0 || !h.rule.placed.empty(); }

size_t levelOf(const ForestHere& here, const StandingTree& t, double distance) {
    const double height = static_cast<double>(here.rule.species[t.species].height * widest(t));
    return levelAt(distance, height, static_cast<double>(here.rule.meshDetail));
}

// What this view sees.
void chooseSeen(DrawContext& ctx, TreesView& view, const ForestHere& here, const Uploaded& u) {
    std::vector<std::array<Chosen, kTreeLevels>> chosen(u.species.size());
    for (const StandingTree& t : here.stand->trees) {
        const GpuMesh& whole = u.species[t.species][0];
        if (whole.parts.empty()) continue;
        const glm::dvec3 at = t.at - ctx.camera.eye;
        const double distance = glm::length(at);
        if (!isMesh(here.rule, t, distance)) continue;
        const float radius = (whole.radius + glm::length(whole.centre)) * widest(t);
        if (ctx.frustum.touches(glm::vec3(at) - radius, glm::vec3(at) + radius))
            chosen[t.species][levelOf(here, t, distance)].push_back(&t);
    }
    for (size_t s = 0; s < chosen.size(); ++s)
        for (size_t l = 0; l < kTreeLevels; ++l)
            if (!chosen[s][l].empty()) addGroup(ctx, view, here, u, s, u.species[s][l], chosen[s][l]);
}

// What casts shadows, seen or not: the same for all views and wherever they look, so that shadow maps are kept.
uint64_t chooseCasters(DrawContext& ctx, TreesView& view, const ForestHere& here, const Uploaded& u) {
    if (!here.rule.castShadows) return 0;
    Hasher h;
    h.add(&u.grown, sizeof u.grown);
    for (const StandingTree& t : here.stand->trees) {
        const double distance = glm::distance(t.at, ctx.around);
        if (distance >= kTreeShadowsFrom || u.species[t.species][0].parts.empty() || !isMesh(here.rule, t, distance))
            continue;
        const GpuMesh& m = u.species[t.species][levelOf(here, t, distance)];
        addCaster(ctx, m, view.rows.size(), 1,
                  glm::vec3(t.at - ctx.camera.eye) + m.centre * glm::vec3(1, t.upright, 1) * t.size,
                  (m.radius + glm::length(glm::vec2(m.centre.x, m.centre.z))) * widest(t));
        addRow(ctx, view, here, u, t);
        hashCaster(h, view, t, m);
    }
    return h.value();
}

void placeTrees(DrawContext& ctx) {
    TreesState& s = ctx.own<TreesState>();
    TreesView& view = ctx.ofView<TreesView>();
    view.rows.clear();
    view.places.clear();
    view.groups.clear();
    std::erase_if(s.forests, [&](const auto& f) {
        return std::none_of(ctx.shared.forests->all.begin(), ctx.shared.forests->all.end(),
                            [&](const auto& h) { return h->entity == f.first && drawsMeshes(*h); });
    });
    view.sway.follow(has(ctx.plan.features, Feature::Wind) ? windOf(ctx.project) : nullptr, {ctx.eye.x, ctx.eye.z},
                     ctx.settings.time);
    for (const auto& here : ctx.shared.forests->all) {
        if (!drawsMeshes(*here)) continue;
        Uploaded& u = s.forests[here->entity];
        upload(ctx, u, *here);
        followStand(u, *here);
        chooseSeen(ctx, view, *here, u);
        ctx.shared.castersHash += chooseCasters(ctx, view, *here, u);
    }
    writeBuffer(ctx.gpu, view.instances, kOwner, view.rows.size() * sizeof(ObjectInstance), view.rows.data());
    writeBuffer(ctx.gpu, view.placesBuffer, kOwner, view.places.size() * sizeof(TreePlace), view.places.data());
    // Of meshes that nobody sees, too: they may cast shadows.
    for (const auto& [entity, u] : s.forests)
        for (const TreeLevels& levels : u.species)
            for (const TreeLevel& m : levels) {
                if (!m.mesh.id()) continue;
                glVertexArrayVertexBuffer(m.mesh.id(), 1, view.instances.id(), 0, sizeof(ObjectInstance));
                glVertexArrayVertexBuffer(m.mesh.id(), kPlaceBinding, view.placesBuffer.id(), 0, sizeof(TreePlace));
            }
}

void drawTrees(DrawContext& ctx) {
    const TreesState& s = ctx.own<TreesState>();
    if (!ctx.use()) return;
    for (const TreeGroup& g : ctx.ofView<TreesView>().groups) {
        if (g.seen == 0) continue;
        glBindBufferBase(GL_UNIFORM_BUFFER, UBO_FOREST, g.here->lightGlobals);
        glBindTextureUnit(TEX_FOREST_LIGHT, g.here->light);
        glUniform1f(3, g.here->rule.species[g.species].translucency);
        const glm::vec3& scatter = g.here->scatter[g.species];
        glUniform3f(4, scatter.x, scatter.y, scatter.z);
        glUniform1f(5, g.here->rule.verticalScale);
        glUniform1f(6, 1 / g.here->rule.stiffness);
        drawMesh(ctx, *g.mesh, s.white, g.first, g.seen);
    }
}

const System kSystems[] = {{"forest/trees/place", {.reads = {Slot::Forests}, .appends = {Slot::Casters}}, placeTrees}};
const ProgramRow kPrograms[] = {{"forest/trees", "forest/trees.vert.glsl", "forest/trees.frag.glsl", nullptr}};
const Pass kPasses[] = {{"forest/trees",
                         Stage::Opaque,
                         kViewMain | kViewReflection,
                         {.reads = {Slot::Shadows}, .appends = {Slot::SceneColor, Slot::SceneDepth}},
                         kPrograms,
                         drawTrees,
                         {},
                         false,
                         true}};

}  // namespace

const EffectRow& treesEffect() {
    static const EffectRow row{
        "forest/trees",
        featureSet(Feature::ForestMeshes, Feature::Terrain),
        kSystems,
        kPasses,
        [](DrawContext& ctx) -> std::unique_ptr<EffectState> { return std::make_unique<TreesState>(ctx.gpu); },
        "near trees of a forest are drawn as meshes",
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<TreesView>(); }};
    return row;
}

}  // namespace sward
