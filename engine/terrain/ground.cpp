#include "terrain/ground.h"

#include <algorithm>
#include <random>

#include "core/log.h"
#include "core/numerics.h"
#include "frame/color_image.h"
#include "frame/draw_context.h"
#include "scene/tiling.h"
#include "terrain/lod.h"
#include "world/land.h"

namespace sward {
namespace {

constexpr const char* kOwner = "terrain/ground";

struct GroundState : EffectState {
    Buffer vertices, indices;
    VertexArray mesh;
    Texture soil;
    std::string soilOf = "?";  // file of the ground's texture; "" is the made one
    Land land;
};
struct GroundView : EffectState {
    Buffer nodes;
    std::vector<TerrainNode> selected;
};
struct DepthView : EffectState {
    Buffer nodes;
};

Buffer makeRoom(Gpu& gpu, const char* owner) {
    return makeBuffer(gpu, owner, NODES_PER_DRAW * sizeof(TerrainNode), nullptr);
}

constexpr int kNodeIndices = 6 * kNodeQuads * kNodeQuads;

// 17 x 17 vertices as two bytes each and two triangles a quad; then two triangles for a whole node, where ground is
// level.
void makeMesh(Gpu& gpu, GroundState& s) {
    std::vector<uint8_t> vertices;
    std::vector<uint16_t> indices;
    constexpr int n = kNodeQuads + 1;
    for (int z = 0; z < n; ++z)
        for (int x = 0; x < n; ++x) vertices.insert(vertices.end(), {static_cast<uint8_t>(x), static_cast<uint8_t>(z)});
    for (int z = 0; z < kNodeQuads; ++z)
        for (int x = 0; x < kNodeQuads; ++x) {
            const uint16_t a = static_cast<uint16_t>(z * n + x), b = a + 1, c = static_cast<uint16_t>(a + n), d = c + 1;
            indices.insert(indices.end(), {a, c, b, b, c, d});
        }
    for (const int corner : {0, n * (n - 1), n - 1, n - 1, n * (n - 1), n * n - 1})
        indices.push_back(static_cast<uint16_t>(corner));
    s.vertices = makeBuffer(gpu, kOwner, vertices.size(), vertices.data());
    s.indices = makeBuffer(gpu, kOwner, indices.size() * 2, indices.data());
    s.mesh = makeVertexArray(kOwner);
    glVertexArrayVertexBuffer(s.mesh.id(), 0, s.vertices.id(), 0, 2);
    glVertexArrayElementBuffer(s.mesh.id(), s.indices.id());
    glEnableVertexArrayAttrib(s.mesh.id(), 0);
    glVertexArrayAttribFormat(s.mesh.id(), 0, 2, GL_UNSIGNED_BYTE, GL_FALSE, 0);
}

std::unique_ptr<EffectState> makeGroundState(DrawContext& ctx) {
    auto s = std::make_unique<GroundState>();
    makeMesh(ctx.gpu, *s);
    return s;
}
std::unique_ptr<EffectState> makeGroundView(DrawContext& ctx) {
    auto s = std::make_unique<GroundView>();
    s->nodes = makeRoom(ctx.gpu, kOwner);
    return s;
}

void updateSoil(DrawContext& ctx, GroundState& s, const Terrain& t) {
    if (s.soilOf == t.groundTexture) return;
    s.soilOf = t.groundTexture;
    const Rgba8 pixels = t.groundTexture.empty() ? makeSoil(256) : loadColorImage(ctx.project.dir / t.groundTexture);
    s.soil = makeColorTexture(ctx.gpu, kOwner, pixels.pixels.empty() ? makeSoil(256) : pixels);
}

// For the whole frame: nothing else uses the bindings.
void bindMaps(DrawContext& ctx, const GroundState& s, const Terrain& t) {
    const auto texture = [&](const MapField& m) {
        return ctx.maps.get("terrain/map", entityOf(ctx.project, t) + ".Terrain.terrainMap", m.map, true,
                            tilingOf(t, t.terrainMapTiling).repeats);
    };
    const GLuint map = t.terrainMap.present() ? texture(t.terrainMap) : 0;
    static_assert(TEX_TERRAIN_MAP == TEX_HEIGHT + 1 && TEX_GROUND == TEX_HEIGHT + 2);
    const GLuint textures[] = {ctx.shared.heights, map, s.soil.id()};
    glBindTextures(TEX_HEIGHT, 3, textures);
}

// What is the same for every eye.
void prepareGround(DrawContext& ctx) {
    GroundState& s = ctx.own<GroundState>();
    const Terrain& t = *ctx.shared.ground.terrain;
    updateHeightBounds(ctx.shared.bounds, t);
    updateSoil(ctx, s, t);
    const bool level = !t.height.present();
    const std::string path = entityOf(ctx.project, t) + ".Terrain.height";
    ctx.shared.heights = level ? 0 : ctx.maps.get("terrain/heights", path, t.height.map);
    FrameGlobals& g = ctx.globals;
    g.terrainSize = t.size;
    g.terrainShare = 1.0 / t.size;
    g.mapShare = 1.0 / mapExtent(t);
    g.heightTiling = shaderTiling(t, t.heightTiling);
    g.terrainTiling = shaderTiling(t, t.terrainMapTiling);
    g.soilColor = t.groundColor;
    g.soilRepeats = 1 / t.tileSize;
    s.land = has(ctx.plan.features, Feature::TerrainBeyond) ? landOf(ctx.project) : Land{};
    g.landReach = static_cast<float>(s.land.reach), g.landFade = s.land.fade;
    g.landMean = s.land.mean, g.landGrass = s.land.grass;
    bindMaps(ctx, s, t);
}

void selectGround(DrawContext& ctx) {
    const GroundState& s = ctx.own<GroundState>();
    GroundView& view = ctx.ofView<GroundView>();
    const Terrain& t = *ctx.shared.ground.terrain;
    TerrainLod lod = terrainLod(t, s.land.reach);
    lod.landLevel = s.land.level;
    lod.plainFrom = 0.5 * static_cast<double>(ctx.shared.bounds.high - ctx.shared.bounds.low) *
                    static_cast<double>(pixelsPerMetre(ctx.camera, wholeHeight(ctx.settings)));
    const bool hazy = has(ctx.plan.features, Feature::Fog) || has(ctx.plan.features, Feature::Atmosphere);
    if (hazy && has(ctx.plan.features, Feature::Sky)) lod.hidden = f32::hazeReach(ctx.globals.haze);
    view.selected = selectNodes(t, lod, ctx.shared.bounds, ctx.eye, ctx.frustum);
    const bool level = !t.height.present();
    const auto beyond = std::find_if_not(view.selected.begin(), view.selected.end(),
                                         [&](const TerrainNode& n) { return touches(t, n); });
    ctx.shared.groundMesh = {s.mesh.id(),
                             level ? kNodeIndices : 0,
                             level ? 6 : kNodeIndices,
                             {view.selected.begin(), beyond},
                             view.selected};
    FrameGlobals& g = ctx.globals;
    g.eyeAbove = std::max(static_cast<float>(ctx.eye.y) - ctx.shared.bounds.high, 0.0f);
    g.groundScale = g.groundTexel = 0;
    g.landLevel = static_cast<float>(static_cast<double>(s.land.level) - ctx.eye.y);
    if (t.height.present()) {
        const auto [offset, scale] = heightScale(t);
        const float base =
            t.height.map.at(0, 0);  // subtracted from texels first, so that slopes keep their digits (T-4)
        g.groundBase = static_cast<float>(offset + scale * base - ctx.eye.y);
        g.groundScale = static_cast<float>(scale);
        g.groundTexel = base;
    } else {
        g.groundBase = static_cast<float>(-ctx.eye.y);
    }
}

void drawMesh(DrawContext& ctx, const Buffer& room) {
    ctx.pass->draws += drawNodes(ctx.shared.groundMesh, ctx.shared.groundMesh.land, room);
    ctx.pass->instances += ctx.shared.groundMesh.land.size();
}

void drawDepth(DrawContext& ctx) {
    if (ctx.shared.groundMesh.land.empty() || !ctx.use()) return;
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    drawMesh(ctx, ctx.ofView<DepthView>().nodes);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

// Where the ground is seen, the stencil says so, if there is one: blades' shadows lie there alone.
void drawGround(DrawContext& ctx) {
    if (ctx.shared.groundMesh.land.empty() || !ctx.use(0, ctx.shared.soil.constants)) return;
    bindSoil(ctx.shared.soil);
    if (ctx.targets.stencil) {
        glEnable(GL_STENCIL_TEST);
        glStencilFunc(GL_ALWAYS, kStencilGround, kStencilGround);
        glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    }
    drawMesh(ctx, ctx.ofView<GroundView>().nodes);
    if (ctx.targets.stencil) glDisable(GL_STENCIL_TEST);
}

const System kSystems[] = {
    {"terrain/maps", {.writes = {Slot::Ground}}, prepareGround, true},
    {"terrain/select", {.reads = {Slot::Ground, Slot::Haze}, .writes = {Slot::GroundNodes}}, selectGround}};
const ProgramRow kDepthPrograms[] = {{"terrain/depth", "terrain/ground.vert.glsl", nullptr, nullptr}};
const ProgramRow kPrograms[] = {
    {"terrain/ground", "terrain/ground.vert.glsl", "terrain/ground.frag.glsl", nullptr, soilVariants}};
const Pass kDepthPasses[] = {{"terrain/depth",
                              Stage::Depth,
                              kViewMain | kViewReflection,
                              {.reads = {Slot::GroundNodes}, .appends = {Slot::SceneDepth}},
                              kDepthPrograms,
                              drawDepth}};
const Pass kPasses[] = {{"terrain/ground",
                         Stage::Ground,
                         kViewMain | kViewReflection,
                         {.reads = {Slot::GroundNodes, Slot::Grass, Slot::Shadows, Slot::ObjectLight},
                          .appends = {Slot::SceneColor, Slot::SceneDepth}},
                         kPrograms,
                         drawGround}};

}  // namespace

const EffectRow& groundEffect() {
    static const EffectRow row{"terrain/ground", featureSet(Feature::Terrain),  kSystems,      kPasses,
                               makeGroundState,  "there is ground to stand on", makeGroundView};
    return row;
}
const EffectRow& groundDepthEffect() {
    static const EffectRow row{"terrain/depth",
                               featureSet(Feature::Terrain, Feature::TerrainHeights),
                               {},
                               kDepthPasses,
                               nullptr,
                               "hills hide what stands behind them, so that it is not lit",
                               [](DrawContext& ctx) -> std::unique_ptr<EffectState> {
                                   auto s = std::make_unique<DepthView>();
                                   s->nodes = makeRoom(ctx.gpu, "terrain/depth");
                                   return s;
                               }};
    return row;
}

}  // namespace sward
