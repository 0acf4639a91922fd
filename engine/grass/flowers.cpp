#include "grass/flowers.h"

#include "core/numerics.h"
#include "frame/flower_image.h"
#include "grass/cells.h"
#include "grass/field.h"
#include "shared/flowers.h"

namespace sward {
namespace {

constexpr const char* kOwner = "grass/flowers";
constexpr uint32_t kCorners = 8, kIndices = 12;  // of a flower: stem and head
constexpr float kThinFrom = 0.35f;               // share of maxDistance from which flowers are left out
constexpr float kWidest = 1.7f;                  // how much larger those left are, each way
constexpr float kLeastPixels = 0.5f;             // across a head; smaller ones stand for each other
constexpr int kLeastRows = 16;  // of the head in the smallest image: in a smaller one stems run into it

struct DrawnKind {
    std::string textureOf = "?";
    FlowerImage image;
    Texture texture;
    Buffer globals, cells, commands, indices;
    VertexArray mesh;
    uint32_t most = 0;  // flowers that the indices are for
    GLuint density = 0;
    DensityRanges ranges;  // of the density map
    GLsizei drawn = 0;     // commands
};
struct FlowersState : EffectState {
    std::map<std::string, DrawnKind> kinds;  // by entity
};

void updateTexture(DrawContext& ctx, DrawnKind& k, const Flowers& f) {
    if (k.textureOf == f.texture) return;
    k.textureOf = f.texture;
    k.image = flowerImage(ctx.project, f);
    k.texture = makeColorTexture(ctx.gpu, kOwner, k.image.pixels, false);
    const float rows = k.image.headShare * static_cast<float>(k.image.pixels.height);
    const int smallest = static_cast<int>(std::log2(std::max(rows / kLeastRows, 1.0f)));
    glTextureParameteri(k.texture.id(), GL_TEXTURE_MAX_LEVEL, smallest);
}

// Corners 0 to 3 are the stem's, from the root up; 4 to 7 the head's.
void makeMesh(DrawContext& ctx, DrawnKind& k, uint32_t most) {
    if (k.most == most && k.mesh.id()) return;
    k.most = most;
    std::vector<uint32_t> indices;
    indices.reserve(static_cast<size_t>(most) * kIndices);
    for (uint32_t i = 0; i < most; ++i)
        for (const uint32_t c : {0, 1, 2, 2, 1, 3, 4, 5, 6, 6, 5, 7}) indices.push_back(kCorners * i + c);
    k.indices = makeBuffer(ctx.gpu, kOwner, indices.size() * sizeof(uint32_t), indices.data());
    k.mesh = makeVertexArray(kOwner);
    const GLuint mesh = k.mesh.id();
    glVertexArrayElementBuffer(mesh, k.indices.id());
    glVertexArrayBindingDivisor(mesh, 0, 1);
    for (GLuint attribute = 0; attribute < 2; ++attribute) {
        glEnableVertexArrayAttrib(mesh, attribute);
        glVertexArrayAttribBinding(mesh, attribute, 0);
    }
    glVertexArrayAttribIFormat(mesh, 0, 2, GL_INT, offsetof(FlowerCell, cell));
    glVertexArrayAttribFormat(mesh, 1, 2, GL_FLOAT, GL_FALSE, offsetof(FlowerCell, corner));
}

// Least size of a head that is drawn, in metres a metre of distance.
float leastSize(const DrawContext& ctx) { return kLeastPixels / pixelsPerMetre(ctx.camera, wholeHeight(ctx.settings)); }

FlowerGlobals globalsOf(const DrawContext& ctx, const Flowers& f, const FlowerGrid& grid, const DrawnKind& k) {
    FlowerGlobals g{};
    const float from = kThinFrom * f.maxDistance;
    g.petal = f.color, g.second = f.secondColor, g.center = f.centerColor, g.stem = f.stemColor;
    g.height = f.height, g.variation = f.heightVariation;
    g.headSize = f.headSize;
    g.cellSize = static_cast<float>(grid.side);
    g.expected = grid.expected;
    g.seed = static_cast<uint32_t>(f.seed & 0xFFFFFF);
    g.tiling = f.density.present() ? shaderTiling(*ctx.shared.ground.terrain, f.densityTiling) : -1;
    g.made = k.image.made;
    g.thinFrom = from, g.thinInv = f32::lodInverse(from, f.maxDistance);
    g.widest = kWidest;
    g.headShare = k.image.headShare;
    g.leastSize = leastSize(ctx);
    return g;
}

// What is asked of the cells of one kind of flowers.
struct CellSearch {
    DrawContext& ctx;
    const Flowers& f;
    const FlowerGrid& grid;
    DensityRanges& ranges;
    float least;  // as leastSize has it
    std::vector<FlowerCell> cells;
    std::vector<DrawCommand> commands;

    float density(int x, int z) const {
        if (!f.density.present()) return 1;
        const double x0 = x * grid.side, z0 = z * grid.side;
        return rangeOf(
                   ranges, x, z,
                   [&] { return densityRange(f.density.map, ranges.tiling, x0, z0, x0 + grid.side, z0 + grid.side); })
            .second;
    }
    // Flowers of a cell of this density that may be seen at a distance; their numbers are the least ones.
    uint32_t count(float most, float distance) const {
        const float kept = 1 - f32::lodRamp(distance, kThinFrom * f.maxDistance,
                                            f32::lodInverse(kThinFrom * f.maxDistance, f.maxDistance));
        const float standing = f32::flowersStanding(f.headSize / std::max(least * distance, 1e-6f));
        const float share = std::min(f32::flowerRankMost(standing, kept), 1.0f) * most;
        return std::min(static_cast<uint32_t>(std::ceil(share * grid.expected)), grid.most);
    }
    void visit(int x, int z) {
        const float most = density(x, z);
        if (!(most > 0)) return;
        const Terrain& t = *ctx.shared.ground.terrain;
        const double x0 = x * grid.side, z0 = z * grid.side,
                     reach = static_cast<double>(f.height * (1 + f.heightVariation) + 2 * f.headSize);
        const auto [low, high] = ctx.shared.bounds.over(t.size, x0, z0, x0 + grid.side, z0 + grid.side);
        const glm::vec3 from(glm::dvec3(x0 - reach, low, z0 - reach) - ctx.eye),
            to(glm::dvec3(x0 + grid.side + reach, high + reach, z0 + grid.side + reach) - ctx.eye);
        const float distance = glm::length(glm::max(glm::max(from, -to), glm::vec3(0)));
        if (distance >= f.maxDistance || !ctx.frustum.touches(from, to)) return;
        const uint32_t n = count(most, distance);
        if (n == 0) return;
        commands.push_back({n * kIndices, 1, 0, 0, static_cast<uint32_t>(cells.size())});
        cells.push_back({{x, z}, glm::vec2(glm::dvec2(x0 - ctx.eye.x, z0 - ctx.eye.z))});
        ctx.stats.cells += 1;
    }
    void run() {
        const Terrain& t = *ctx.shared.ground.terrain;
        const auto first = [&](double eye) {
            return static_cast<int>(std::floor(std::max(eye - static_cast<double>(f.maxDistance), 0.0) / grid.side));
        };
        const auto last = [&](double eye, double size) {
            return static_cast<int>(std::ceil(std::min(eye + static_cast<double>(f.maxDistance), size) / grid.side));
        };
        for (int z = first(ctx.eye.z); z < last(ctx.eye.z, t.size.y); ++z)
            for (int x = first(ctx.eye.x); x < last(ctx.eye.x, t.size.x); ++x) visit(x, z);
    }
};

void updateKind(DrawContext& ctx, const std::string& entity, const Flowers& f, DrawnKind& k) {
    const FlowerGrid grid = flowerGrid(f);
    updateTexture(ctx, k, f);
    makeMesh(ctx, k, grid.most);
    k.density = f.density.present() ? ctx.maps.get("flower/density", entity + ".Flowers.density", f.density.map, false,
                                                   tilingOf(*ctx.shared.ground.terrain, f.densityTiling).repeats)
                                    : 0;
    if (f.density.present())
        keepRangesOf(k.ranges, f.density.map, tilingOf(*ctx.shared.ground.terrain, f.densityTiling), grid.side);
    CellSearch search{ctx, f, grid, k.ranges, leastSize(ctx), {}, {}};
    search.run();
    k.drawn = static_cast<GLsizei>(search.commands.size());
    const FlowerGlobals g = globalsOf(ctx, f, grid, k);
    writeBuffer(ctx.gpu, k.globals, kOwner, sizeof(g), &g);
    writeBuffer(ctx.gpu, k.cells, kOwner, search.cells.size() * sizeof(FlowerCell), search.cells.data());
    writeBuffer(ctx.gpu, k.commands, kOwner, search.commands.size() * sizeof(DrawCommand), search.commands.data());
    glVertexArrayVertexBuffer(k.mesh.id(), 0, k.cells.id(), 0, sizeof(FlowerCell));
}

void selectFlowers(DrawContext& ctx) {
    FlowersState& s = ctx.own<FlowersState>();
    const auto all = flowersOf(ctx.project);
    std::erase_if(s.kinds, [&](const auto& k) {
        return std::none_of(all.begin(), all.end(), [&](const auto& f) { return f.first == k.first; });
    });
    if (!ctx.shared.ground.terrain) return;
    for (const auto& [entity, flowers] : all) updateKind(ctx, entity, *flowers, s.kinds[entity]);
}

// The field among whose grass an entity's flowers stand; null: none.
const Field* fieldAmong(const DrawContext& ctx, const std::string& entity) {
    const std::string name = grassAmong(ctx.project, entity);
    if (!ctx.shared.grass) return nullptr;
    for (const std::unique_ptr<Field>& field : ctx.shared.grass->all)
        if (field->grown->name == name) return field.get();
    return nullptr;
}

// Makes the program for a field current, whose maps lower, shade and press flowers.
bool beginAmong(DrawContext& ctx, const Field* field) {
    if (!ctx.use(0, {}, field ? &field->view->constants : nullptr)) return false;
    if (field) bindField(*field);
    return true;
}

void drawFlowers(DrawContext& ctx) {
    FlowersState& s = ctx.own<FlowersState>();
    std::optional<const Field*> begun;
    for (const auto& [entity, k] : s.kinds) {
        if (k.drawn == 0) continue;
        const Field* among = fieldAmong(ctx, entity);
        if (begun != among && !beginAmong(ctx, among)) return;
        begun = among;
        if (k.density) glBindTextureUnit(TEX_FLOWERS, k.density);
        glBindTextureUnit(TEX_BLADE, k.texture.id());
        glBindBufferBase(GL_UNIFORM_BUFFER, UBO_FLOWERS, k.globals.id());
        glBindVertexArray(k.mesh.id());
        glBindBuffer(GL_DRAW_INDIRECT_BUFFER, k.commands.id());
        glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr, k.drawn, 0);
        ctx.pass->draws += 1;
        ctx.pass->instances += static_cast<uint64_t>(k.drawn);
    }
}

const System kSystems[] = {{"grass/flowers/cells", {.reads = {Slot::Ground}}, selectFlowers}};
const ProgramRow kPrograms[] = {{"grass/flowers", "grass/flowers.vert.glsl", "grass/flowers.frag.glsl", nullptr}};
const Pass kPasses[] = {{"grass/flowers",
                         Stage::Flowers,
                         kViewMain,
                         {.reads = {Slot::Grass, Slot::Forces, Slot::Shadows, Slot::ObjectLight},
                          .appends = {Slot::SceneColor, Slot::SceneDepth}},
                         kPrograms,
                         drawFlowers,
                         featureSet(Feature::GrassBlended),
                         false,
                         true}};

}  // namespace

const EffectRow& flowersEffect() {
    static const EffectRow row{
        "grass/flowers",
        featureSet(Feature::Flowers, Feature::Terrain),
        kSystems,
        kPasses,
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<FlowersState>(); },
        "flowers stand among the grass"};
    return row;
}

}  // namespace sward
