#include "forest/texcells.h"

#include <algorithm>
#include <cmath>

#include "core/hash.h"
#include "core/log.h"
#include "core/numerics.h"
#include "forest/low_sky.h"
#include "forest/slicing.h"
#include "forest/stretch.h"
#include "forest/veil.h"
#include "forest/volume.h"
#include "shared/forest.h"
#include "world/wind.h"

namespace sward {
namespace {

static_assert(sizeof(TileInView) % 16 == 0, "as std430 strides it");
constexpr const char* kOwner = "forest/texcells";
constexpr float kNoTree = 1e30f;                // as high as a foot may lie
constexpr size_t kBatches = 14;                 // of tiles, after each of which full pixels are closed
constexpr VeilPrograms kVeilPrograms{1, 2, 3};  // in kPrograms
constexpr double kLevelView = 1e-3;
// Levels by which slices that face the eye show finer slabs than they lie apart: along the line of sight they follow
// each other more closely, and slabs that are joined upwards hide less from the side than their trees do.
constexpr int kTiltedFiner = 1;
static_assert(kTreeSlots == FOREST_SLOTS);

struct TexcellsState : EffectState {
    std::map<std::string, Volume> volumes;  // by entity
    VertexArray noVertices = makeVertexArray(kOwner);
    Texture shade;          // of all forests on the ground
    uint64_t shadeKey = 0;  // over all that it was made of
    LowSky lowSky;
    uint64_t lowSkyKey = 0;
    void jobs(std::vector<JobNews>& out) const override {
        for (const auto& [entity, v] : volumes)
            if (v.bake.active()) out.push_back(v.bake.news());
    }
};
// Tiles that are drawn by one call.
struct Run {
    const ForestHere* here;
    const Volume* volume;
    size_t tiles, first, slices = 0;  // first: among all slices
};
struct TexcellsView : EffectState {
    Buffer tileBuffer, feetBuffer, sliceBuffer, globals;
    std::vector<TileInView> inView;
    std::vector<TreeInView> feet;  // FOREST_SLOTS of each tile in view
    std::vector<uint32_t> slices;  // of all tiles, one after the other: as the shader reads them
    std::vector<Run> runs;
    size_t batch = 1;  // tiles of a run at most
    Veil veil;
};

// --- tiles ---------------------------------------------------------------------------------------------------------

// How a tree looks from the eye.
TreeInView lookOf(const Volume& v, const ForestHere& here, const StandingTree& tree, const glm::dvec3& eye) {
    const glm::dvec3 way = eye - tree.at;
    const glm::vec3 towards(way / std::max(glm::length(way), 1e-6));
    const FoliageLook look = v.foliage[tree.species].from(towards);
    const float through = here.throughOf(tree.species);
    const glm::vec3& scatter = here.scatter[tree.species];
    const float faces = v.images.trees[tree.species].litFacing, litSeen = v.images.air.litSeen;
    // What hides what is as it was baked.
    const glm::vec3 baked(bakedWay(glm::dvec3(towards), static_cast<double>(v.verticalScale)));
    TreeInView t{};
    t.foot = static_cast<float>(-way.y);
    t.seen = look.seen, t.sun = faces * look.sun, t.passed = faces * through * look.passed;
    t.sky = look.sky, t.through = through;
    // The mean cosine to the upper half of all directions is half the rise.
    t.sunward = std::exp(litSeen * glm::dot(baked, v.bakedSun)), t.skyward = std::exp(0.5f * litSeen * baked.y);
    t.facing = faces;
    t.red = scatter.x, t.green = scatter.y, t.blue = scatter.z;
    t.level = look.level, t.upright = look.upright;
    return t;
}

// Feet of those trees that are drawn as volumes, relative to the eye, and their looks; and what they reach.
Reach feetOf(const DrawContext& ctx, const ForestHere& here, const Volume& v, const ForestTriangle& t, const Prism& p,
             bool near, std::vector<TreeInView>& out) {
    Reach r;
    for (const int32_t number : t.trees) {
        out.push_back({}), out.back().foot = kNoTree;
        if (number < 0) continue;
        const StandingTree& tree = here.stand->trees[static_cast<size_t>(number)];
        if (near && isMesh(here.rule, tree, glm::distance(tree.at, ctx.camera.eye))) continue;
        const double foot = tree.at.y - planeAt(p, tree.at), aside = p.slope * here.stand->tiles.circle;
        r.low = std::min(r.low, foot - aside);
        r.high = std::max(r.high, foot + aside + static_cast<double>(heightOf(tree, here.rule.species[tree.species])));
        out.back() = lookOf(v, here, tree, ctx.camera.eye);
    }
    return r;
}

struct Choice {
    uint32_t triangle;
    double distance;
};

// The nearest first.
std::vector<Choice> inView(const DrawContext& ctx, const ForestHere& here, const Volume& v) {
    std::vector<Choice> out;
    const double circle = here.stand->tiles.edge * 0.5774;  // around a triangle
    const double begin = volumesBegin(here.rule) - circle;
    for (uint32_t i = 0; i < v.prisms.size(); ++i) {
        const Prism& p = v.prisms[i];
        const double distance = glm::length(p.centre - ctx.camera.eye);
        if (distance < begin || !p.usable) continue;
        glm::dvec3 low = p.corner[0], high = p.corner[0];
        for (const glm::dvec3& c : p.corner) low = glm::min(low, c), high = glm::max(high, c);
        const double aside = p.slope * circle;
        low.y -= aside, high.y += v.height() + aside;
        if (ctx.frustum.touches(glm::vec3(low - ctx.camera.eye), glm::vec3(high - ctx.camera.eye)))
            out.push_back({i, distance});
    }
    std::sort(out.begin(), out.end(), [](const Choice& a, const Choice& b) {
        return std::pair(a.distance, a.triangle) < std::pair(b.distance, b.triangle);
    });
    return out;
}

float pixelAt1m(const DrawContext& ctx) {
    return static_cast<float>(2 * std::tan(glm::radians(double(ctx.camera.fovDeg)) / 2)) * ctx.globals.pixelShare.y;
}

// Fills up its last instance. Many small instances: of long lists of vertices llvmpipe clears all for each few.
void endRun(TexcellsView& view) {
    while (view.slices.size() % FOREST_CHUNK != 0) view.slices.push_back(FOREST_MOST_SLICES - 1);
    if (!view.runs.empty()) view.runs.back().slices = view.slices.size() - view.runs.back().first;
}

void addSlices(TexcellsView& view, const glm::dvec3& eye, const ForestHere& here, const Volume& v,
               const ForestTriangle& t, const Prism& p, double level, const Slicing& s) {
    const int apart = static_cast<int>(level), cells = v.images.cells;
    const int whole = std::max(apart - (s.tilted ? kTiltedFiner : 0), 0);
    const double slab = v.height() / v.images.layers * (1 << whole);
    TileInView tile{};
    for (size_t k = 0; k < 3; ++k)
        tile.corner[k] = glm::vec4(glm::vec3(p.corner[k] - eye), static_cast<float>(s.begin[k]));
    tile.spacing = static_cast<float>(s.reach / s.count);
    tile.path = static_cast<float>(s.weight * s.reach / s.count / slab);
    tile.coarser = static_cast<float>(level - apart);
    tile.canopy = p.canopy, tile.rise = p.rise;
    tile.stored = {static_cast<float>(t.tile.cell % cells), static_cast<float>(t.tile.cell / cells)};
    tile.up = t.tile.up;
    tile.slices = s.count;
    tile.below = s.below;
    tile.level = whole;
    if (view.runs.empty() || view.runs.back().volume != &v || view.runs.back().tiles >= view.batch) {
        endRun(view);
        view.runs.push_back({&here, &v, 0, view.slices.size()});
    }
    view.runs.back().tiles += 1;
    const uint32_t first = static_cast<uint32_t>(view.inView.size()) * FOREST_MOST_SLICES;
    for (int k = 0; k < s.count; ++k) view.slices.push_back(first + static_cast<uint32_t>(k));
    view.inView.push_back(tile);
}

void addTile(const DrawContext& ctx, TexcellsView& view, const ForestHere& here, const Volume& v, const Choice& c) {
    const ForestTriangle& t = here.stand->triangles[c.triangle];
    const Prism& p = v.prisms[c.triangle];
    std::vector<TreeInView> feet;
    const Reach reach = feetOf(ctx, here, v, t, p, c.distance < meshesEnd(here.rule) + here.stand->tiles.edge, feet);
    if (!(reach.low < reach.high)) return;
    const glm::dvec3 way = (p.centre - ctx.camera.eye) / std::max(c.distance, 1e-6);
    const double finest = v.height() / v.images.layers;
    const double level =
        here.rule.technique == ForestTechnique::Flat
            ? v.levels - 1
            : levelAt(finest, v.levels - 1, c.distance, static_cast<double>(pixelAt1m(ctx)), std::abs(way.y));
    const double slab = finest * (1 << static_cast<int>(level)), slant = static_cast<double>(here.rule.slant);
    const auto add = [&](Slicing s, double weight) {
        s.weight = weight;
        addSlices(view, ctx.camera.eye, here, v, t, p, level, s);
        view.feet.insert(view.feet.end(), feet.begin(), feet.end());
    };
    if (here.rule.technique == ForestTechnique::Flat) return add(flatSlice(p, reach, ctx.camera.eye), 1);
    const SliceShares shares = sliceShares(static_cast<double>(here.rule.silhouetteDeg), p.normal, way);
    const auto tilted = [&](double y) { return tiltedSlices(p, reach, {way.x, y, way.z}, slant, slab); };
    if (shares.regular > 0) add(regularSlices(p, reach, ctx.camera.eye, slab), shares.regular);
    if (shares.fromAbove > 0) add(tilted(std::min(way.y, -kLevelView)), shares.fromAbove);
    if (shares.fromBelow > 0) add(tilted(std::max(way.y, kLevelView)), shares.fromBelow);
}

ForestGlobals globalsOf(const DrawContext& ctx, const Volume& v) {
    ForestGlobals g{};
    g.height = static_cast<float>(v.height());
    g.verticalScale = v.verticalScale;
    g.voxel = static_cast<float>(v.images.cells * v.images.edge / v.images.side);
    g.pixel = pixelAt1m(ctx);
    g.edge = static_cast<float>(v.images.edge);
    g.cells = static_cast<float>(v.images.cells);
    g.slabs = static_cast<float>(v.images.layers);
    const auto green = [](const glm::vec3& light) { return light.y; };
    const float sun = ctx.globals.sunIsUp > 0 ? green(ctx.globals.sunLight) * ctx.globals.sunDirection.y : 0;
    const float sky = green(ctx.globals.skyLight), all = sun + sky;
    g.floor = all > 0 ? (sun * v.floorSun + sky * v.floorSky) / all : 1;
    return g;
}

// Cliffs (D-6) have no volume: said once for each stand.
void tellCliffs(const ForestHere& here, const std::vector<Prism>& prisms) {
    const auto cut = std::count_if(prisms.begin(), prisms.end(), [](const Prism& p) { return !p.usable; });
    if (cut > 0)
        logWarning(
            fmt::format("{}.Forest: {} of {} tiles lie on cliffs, where far trees are not drawn (lower slopeDeg's "
                        "second value, so that none stands there)",
                        here.entity, cut, prisms.size()));
}

// What trees' meshes need to be lit by the same air.
void publish(DrawContext& ctx, Volume& v, ForestHere& here) {
    const ForestGlobals g = globalsOf(ctx, v);
    writeBuffer(ctx.gpu, v.globals, kOwner, sizeof(g), &g);
    here.light = v.light.id();
    here.lightGlobals = v.globals.id();
}

// --- shade on the ground -------------------------------------------------------------------------------------------

bool isDrawn(const ForestHere& h) {
    return !h.stand->triangles.empty() && meshesTo(h.rule) < std::numeric_limits<float>::infinity();
}

// What far trees hide of the sky does not hang on the sun.
void updateLowSky(DrawContext& ctx, TexcellsState& s, uint64_t trees) {
    if (s.lowSkyKey == trees) return;
    s.lowSkyKey = trees;
    std::vector<AiryForest> forests;
    for (const auto& here : ctx.shared.forests->all)
        if (const auto v = s.volumes.find(here->entity); v != s.volumes.end())
            forests.push_back(
                {here->stand.get(), &v->second.images.trees, static_cast<double>(v->second.verticalScale)});
    s.lowSky = lowSkyOf(*ctx.shared.ground.terrain, ctx.shared.ground.origin, forests);
}

void drawShadeMap(DrawContext& ctx, TexcellsState& s, const glm::vec3& sun) {
    Hasher hasher;
    for (const auto& [entity, v] : s.volumes)
        hasher.add(&v.stood, sizeof v.stood), hasher.add(&v.shown, sizeof v.shown);
    const uint64_t trees = hasher.value();
    hasher.add(&sun, sizeof sun);
    const uint64_t key = hasher.value();
    if (s.shadeKey != key) {
        s.shadeKey = key;
        updateLowSky(ctx, s, trees);
        ShadeSum sum(*ctx.shared.ground.terrain, ctx.shared.ground.origin, glm::dvec3(sun));
        for (const auto& here : ctx.shared.forests->all)
            if (const auto v = s.volumes.find(here->entity); v != s.volumes.end())
                sum.add(*here->stand, v->second.images.trees, static_cast<double>(v->second.verticalScale));
        const ShadeMap map = sum.map(s.lowSky);
        if (s.shade.width != map.size.x || s.shade.height != map.size.y)
            s.shade = makeTexture2D(ctx.gpu, kOwner, GL_RGB8, map.size.x, map.size.y, 0);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTextureSubImage2D(s.shade.id(), 0, 0, 0, map.size.x, map.size.y, GL_RGB, GL_UNSIGNED_BYTE, map.shares.data());
        glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
        glGenerateTextureMipmap(s.shade.id());
    }
    glBindTextureUnit(TEX_FOREST_SHADE, s.shade.id());
}

// Near the eye trees are meshes, whose shadow maps take the sun's light.
void publishShade(DrawContext& ctx) {
    double from = 1e30, to = -1;
    for (const auto& here : ctx.shared.forests->all) {
        const bool cast = here->rule.castShadows && meshesTo(here->rule) > 0;
        from = std::min(from, cast ? volumesBegin(here->rule) : -2);
        to = std::max(to, cast ? meshesEnd(here->rule) : -1);
    }
    ctx.globals.treesShadeFrom = static_cast<float>(from);
    ctx.globals.treesShadeTo = static_cast<float>(std::max(to, from + 1e-3));
}

void placeCells(DrawContext& ctx) {
    TexcellsState& s = ctx.own<TexcellsState>();
    TexcellsView& view = ctx.ofView<TexcellsView>();
    view.inView.clear(), view.feet.clear(), view.slices.clear(), view.runs.clear();
    std::erase_if(s.volumes, [&](const auto& f) {
        return std::none_of(ctx.shared.forests->all.begin(), ctx.shared.forests->all.end(),
                            [&](const auto& h) { return h->entity == f.first && isDrawn(*h); });
    });
    const glm::vec3 sun = ctx.globals.sunIsUp > 0 ? ctx.globals.sunDirection : glm::vec3(0, 1, 0);
    for (const auto& here : ctx.shared.forests->all) {
        if (!isDrawn(*here)) continue;
        Volume& v = s.volumes[here->entity];
        ensureVolume(ctx, kOwner, v, *here);
        const bool stale = v.stood != here->stood;
        if (stale) v.prisms = prismsOf(*here), tellCliffs(*here, v.prisms);
        v.stood = here->stood;
        if (lightVolume(v, sun) || stale) fillCanopies(v, *here->stand, glm::dvec3(sun)), lightSlopes(v);
        publish(ctx, v, *here);
        const std::vector<Choice> choices = inView(ctx, *here, v);
        view.batch = std::max<size_t>(choices.size() / kBatches, 32);
        for (const Choice& c : choices) addTile(ctx, view, *here, v, c);
    }
    endRun(view);
    drawShadeMap(ctx, s, sun);
    publishShade(ctx);
    writeBuffer(ctx.gpu, view.tileBuffer, kOwner, view.inView.size() * sizeof(TileInView), view.inView.data());
    writeBuffer(ctx.gpu, view.sliceBuffer, kOwner, view.slices.size() * sizeof(uint32_t), view.slices.data());
    writeBuffer(ctx.gpu, view.feetBuffer, kOwner, view.feet.size() * sizeof(TreeInView), view.feet.data());
}

// --- drawing -------------------------------------------------------------------------------------------------------

void bind(DrawContext& ctx, TexcellsView& view, const Run& run) {
    const Volume& v = *run.volume;
    ForestGlobals g = globalsOf(ctx, v);
    const Wind* wind = has(ctx.plan.features, Feature::Wind) ? windOf(ctx.project) : nullptr;
    if (wind) g.sway = wind->strength / run.here->rule.stiffness;
    writeBuffer(ctx.gpu, view.globals, kOwner, sizeof(g), &g);
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_FOREST, view.globals.id());
    glBindTextureUnit(TEX_FOREST_SLABS, v.slabs.id());
    glBindTextureUnit(TEX_FOREST_LIGHT, v.light.id());
    glBindTextureUnit(TEX_FOREST_SLOTS, v.slots.id());
}

void drawCells(DrawContext& ctx) {
    TexcellsView& view = ctx.ofView<TexcellsView>();
    // All are made before a second run asks for what closes pixels: programs follow from the scene alone.
    if (view.runs.empty() || !useVeil(ctx, kVeilPrograms) || !ctx.use()) return;
    beginVeil(ctx, kOwner, view.veil, kVeilPrograms);
    // Tilted slices end where no tree reaches.
    glEnable(GL_CLIP_DISTANCE1), glEnable(GL_CLIP_DISTANCE2);
    for (const Run& run : view.runs) {
        if (&run != view.runs.data()) closeFull(ctx, view.veil, kVeilPrograms);
        if (!ctx.use()) break;
        bind(ctx, view, run);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_FOREST_TILES, view.tileBuffer.id());
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_FOREST_FEET, view.feetBuffer.id());
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SSBO_FOREST_SLICES, view.sliceBuffer.id());
        glBindVertexArray(ctx.own<TexcellsState>().noVertices.id());
        glUniform1i(0, static_cast<GLint>(run.first));
        glDrawArraysInstanced(GL_TRIANGLES, 0, 3 * FOREST_CHUNK, static_cast<GLsizei>(run.slices / FOREST_CHUNK));
        ctx.pass->draws += 1;
        ctx.pass->instances += run.tiles;
    }
    glDisable(GL_CLIP_DISTANCE1), glDisable(GL_CLIP_DISTANCE2);
    endVeil(ctx, view.veil, kVeilPrograms);
}

const System kSystems[] = {{"forest/texcells/place",
                            {.reads = {Slot::Forests, Slot::Sun, Slot::Ground}, .writes = {Slot::Forests}},
                            placeCells}};
const ProgramRow kPrograms[] = {
    {"forest/texcells", "forest/texcells.vert.glsl", "forest/texcells.frag.glsl", nullptr},
    {"forest/texcells/behind", "post/fullscreen.vert.glsl", "forest/behind.frag.glsl", nullptr, depthVariants},
    {"forest/texcells/full", "forest/full.vert.glsl", "forest/full.frag.glsl", nullptr},
    {"forest/texcells/veil", "post/fullscreen.vert.glsl", "forest/veil.frag.glsl", nullptr}};
const Pass kPasses[] = {{"forest/texcells",
                         Stage::Canopy,
                         kViewMain | kViewReflection,
                         {.reads = {Slot::SceneDepth, Slot::Shadows}, .appends = {Slot::SceneColor}},
                         kPrograms,
                         drawCells}};

}  // namespace

const EffectRow& texcellsEffect() {
    static const EffectRow row{
        "forest/texcells",
        featureSet(Feature::ForestVolumes, Feature::Terrain),
        kSystems,
        kPasses,
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<TexcellsState>(); },
        "far trees of a forest are drawn as volumes",
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<TexcellsView>(); }};
    return row;
}

}  // namespace sward
