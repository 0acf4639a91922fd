// Index: making slices · uniforms · vertical slices · the horizontal slice · rows.
#include "grass/slices.h"

#include <chrono>
#include <numeric>

#include "core/file.h"
#include "core/hash.h"
#include "core/log.h"
#include "core/numerics.h"
#include "grass/cells.h"
#include "grass/field.h"
#include "grass/grass_fields.h"
#include "grass/raytraced_settings.h"
#include "grass/slice_file.h"
#include "grass/slice_gains.h"
#include "shared/slices.h"
#include "world/lights.h"
#include "world/wind.h"

namespace sward {
namespace {

constexpr const char* kOwner = "grass/slices";
constexpr const char* kFarOwner = "grass/far";

// --- making slices -----------------------------------------------------------------------------------------
// The ground over which a field's horizontal slices are drawn.
struct FarGround {
    const Field* field;
    std::vector<TerrainNode> nodes;
};
struct FarView : EffectState {
    Buffer nodes;
    std::vector<FarGround> selected;  // of this frame
};
bool slicesAreShaded(const FeatureSet& features) {
    return has(features, Feature::BladeShadows) && has(features, Feature::CastingLights);
}

// Steeper than `steepest` one would look between slices.
SliceStand standOf(const GrownField& f, float height) {
    const auto& images = f.of->settings<GrassSlices>();
    SliceStand s;
    s.across = f.grows().cellSize, s.apart = s.across / static_cast<float>(images.slices);
    s.steepest = 0.6f * height / s.apart;
    s.sharpness = images.sharpness;
    s.traced = f.draws(Feature::GrassRaytraced) || f.draws(Feature::GrassOnMeshes);
    if (!s.traced) return s;
    const auto& rays = f.of->settings<RaytracedGrass>();
    s.steps = rays.steps, s.footprint = rays.footprint, s.restShown = rays.rest == RayRest::Mean;
    return s;
}

void upload(DrawContext& ctx, const GrownField& f, GrownSpecies& s, uint64_t key, const SliceImages& images) {
    const auto& how = f.of->settings<GrassSlices>();
    s.slices = uploadSlices(ctx.gpu, showsVertical(f) ? kOwner : "", kFarOwner, images, how.storage, how.sets,
                            standOf(f, s.look.height));
    s.sliceKey = key;
}

// Of how they are looked at; their height is their patch's.
uint64_t standKey(const GrownField& f) {
    const SliceStand s = standOf(f, 1);
    const float read[] = {s.sharpness, s.traced ? 1.0f : 0.0f, static_cast<float>(s.steps), s.footprint,
                          s.restShown ? 1.0f : 0.0f};
    return hashBytes(read, sizeof(read));
}
// Which textures the species should have: what they are made from, and how they are stored.
uint64_t textureKey(const GrownField& f, uint64_t slices) {
    const uint64_t parts[] = {slices, static_cast<uint64_t>(f.of->settings<GrassSlices>().storage),
                              static_cast<uint64_t>(f.of->settings<GrassSlices>().sets), showsVertical(f) ? 1u : 0u,
                              standKey(f)};
    return hashBytes(parts, sizeof(parts));
}

// Slices that can be shown now. Where one may wait, waits for them.
std::optional<SliceImages> slicesThere(const DrawContext& ctx, GrownSpecies& s, const SliceSpec& spec, uint64_t key) {
    if (!ctx.settings.background) {
        s.bake = {};
        JobControl control;
        return std::move(*slicesOf(cacheDir(), spec, control));
    }
    if (auto made = s.bake.take(key); made && *made) return std::move(**made);
    if (s.bake.active()) return std::nullopt;
    return loadCachedSlices(cacheDir(), key);
}

void startBake(GrownSpecies& s, const SliceSpec& spec, uint64_t key) {
    s.bakeOf = key;
    s.bake = Job<SliceImages>("slices of " + spec.species.name, key,
                              [spec](JobControl& c) { return slicesOf(cacheDir(), spec, c); });
}

void showDraft(DrawContext& ctx, const GrownField& f, size_t i, uint64_t wanted) {
    GrownSpecies& s = *f.species[i];
    if (s.sliceKey == ~wanted) return;
    JobControl control;
    upload(ctx, f, s, ~wanted,
           *bakeSlices(sliceSpec(*f.of, i, s.bladeImage, slicesAreShaded(f.features), true), control));
}

// What was begun for other blades is cancelled. While slices are made beside, a draft of them is shown. A sketch takes
// the draft: files are read, and baking begins, once there is something to see.
void ensureSlices(DrawContext& ctx, const GrownField& f, size_t i) {
    GrownSpecies& s = *f.species[i];
    const FieldEntity& of = *f.of;
    const bool shaded = slicesAreShaded(f.features);
    // Most frames ask for what is there: the image's hash stands for its pixels.
    const uint64_t asked = textureKey(f, sliceKey(sliceSpec(of, i, {}, shaded)) ^ s.bladeHash);
    if (s.sliceAsked == asked) return;
    s.sliceAsked = 0;
    const SliceSpec spec = sliceSpec(of, i, s.bladeImage, shaded);
    const uint64_t key = sliceKey(spec), wanted = textureKey(f, key);
    if (s.sliceKey == wanted) {
        s.sliceAsked = asked;
        return;
    }
    if (s.bakeOf != key) s.bake = {};
    if (ctx.sketching()) return showDraft(ctx, f, i, wanted);
    if (const auto there = slicesThere(ctx, s, spec, key)) return upload(ctx, f, s, wanted, *there);
    if (s.bake.active()) return;
    showDraft(ctx, f, i, wanted);
    startBake(s, spec, key);
}

// --- uniforms ----------------------------------------------------------------------------------------------
void bindSlices(const FieldSpecies& s, GLuint reflectance, GLuint threshold, GLuint light) {
    glBindTextureUnit(TEX_SLICE_REFLECTANCE, reflectance);
    glBindTextureUnit(TEX_SLICE_THRESHOLD, threshold);
    glBindTextureUnit(TEX_SLICE_LIGHT, light);
    if (s.grown->lampGains.id()) glBindTextureUnit(TEX_LAMP_GAINS, s.grown->lampGains.id());
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_SLICES, s.sliceGlobals.id());
}

// --- vertical slices ---------------------------------------------------------------------------------------
// Selected cells in a row that take their quads in the same order.
struct SliceRun {
    int order;  // of sliceIndices
    size_t first, count;
};
struct SliceDraw {
    Buffer indices, cells;
    VertexArray mesh;
    int slices = 0;
    std::vector<SliceCell> selected;
    std::vector<SliceRun> runs;
};
struct SlicesView : EffectState {
    PerSpecies<SliceDraw> species;
};

// Quads of a cell in eight orders: for an eye to its -x or +x, -z or +z, nearest first, and the same farthest first.
// Vertex 4 q + corner of quad q; the first n quads cut x. Where the two families cross, neither is first.
std::vector<uint16_t> sliceIndices(int n) {
    std::vector<uint16_t> out;
    for (int order = 0; order < 8; ++order)
        for (int i = 0; i < n; ++i)
            for (int axis = 0; axis < 2; ++axis) {
                const bool farthestFirst = order >= 4, fromHigh = (order >> axis & 1) != (farthestFirst ? 1 : 0);
                const int q = axis * n + (fromHigh ? n - 1 - i : i);
                for (const int corner : {0, 1, 2, 2, 1, 3}) out.push_back(static_cast<uint16_t>(4 * q + corner));
            }
    return out;
}

void makeSliceMesh(DrawContext& ctx, SliceDraw& s, int n) {
    const auto indices = sliceIndices(n);
    s.slices = n;
    s.indices = makeBuffer(ctx.gpu, kOwner, indices.size() * 2, indices.data());
    s.mesh = makeVertexArray(kOwner);
}

// 0..3: the eye lies to the cell's -x or +x (1), -z or +z (2).
int quarterOf(const SliceCell& c, float cellSize) {
    return (c.x + 0.5f * cellSize < 0 ? 1 : 0) + (c.z + 0.5f * cellSize < 0 ? 2 : 0);
}

// How many of its two rows of cells the eye is in.
int rowsWithEye(const SliceCell& c, float cellSize) {
    return (c.x <= 0 && c.x + cellSize >= 0 ? 1 : 0) + (c.z <= 0 && c.z + cellSize >= 0 ? 1 : 0);
}

// How many cells a ray to it comes through.
float cellsBefore(const SliceCell& c, float cellSize) {
    return std::abs(c.x / cellSize + 0.5f) + std::abs(c.z / cellSize + 0.5f);
}

// Cells as they are drawn: by quarters, nearest first; or, to be blended, so that no ray from the eye meets a cell
// after one that it goes through sooner: those of the eye's own rows last.
std::vector<SliceRun> orderCells(std::vector<SliceCell>& cells, float cellSize, bool farthestFirst) {
    const auto group = [&](const SliceCell& c) {
        return farthestFirst ? 4 * rowsWithEye(c, cellSize) + quarterOf(c, cellSize) : quarterOf(c, cellSize);
    };
    std::stable_sort(cells.begin(), cells.end(), [&](const SliceCell& a, const SliceCell& b) {
        const int ga = group(a), gb = group(b);
        return ga != gb ? ga < gb : farthestFirst && cellsBefore(a, cellSize) > cellsBefore(b, cellSize);
    });
    std::vector<SliceRun> runs;
    for (size_t i = 0; i < cells.size(); ++i) {
        if (i == 0 || group(cells[i]) != group(cells[i - 1]))
            runs.push_back({quarterOf(cells[i], cellSize) + (farthestFirst ? 4 : 0), i, 0});
        ++runs.back().count;
    }
    return runs;
}

void uploadSliceCells(DrawContext& ctx, SliceDraw& s, const Field& field) {
    s.runs = orderCells(s.selected, field.grows().cellSize, blends(field.view->settings<GrassDrawing>().transparency));
    writeBuffer(ctx.gpu, s.cells, kOwner, s.selected.size() * sizeof(SliceCell), s.selected.data());
    describeCells(s.mesh.id(), s.cells.id(), sizeof(SliceCell), s.indices.id());
    ctx.stats.sliceQuads += s.selected.size() * 2 * static_cast<size_t>(s.slices);
    ctx.stats.cells += s.selected.size();
}

void selectSpecies(DrawContext& ctx, const Field& field, size_t i, SliceDraw& s) {
    const int slices = field.species[i].grown->slices.slices;
    if (s.slices != slices) makeSliceMesh(ctx, s, slices);
    const FieldTiers& tiers = field.view->tiers;
    s.selected = selectSliceCells(patchQuery(ctx, field, i, 1), tiers.slicesFrom, tiers.slicesTo);
    uploadSliceCells(ctx, s, field);
}

void selectSlices(DrawContext& ctx) {
    SlicesView& view = ctx.ofView<SlicesView>();
    if (!ctx.shared.grass) return;
    const auto start = std::chrono::steady_clock::now();
    view.species.keep(ctx.shared.grass->all, Feature::GrassSlices);
    eachSpecies(ctx, Feature::GrassSlices,
                [&](const Field& field, size_t i) { selectSpecies(ctx, field, i, view.species.at(field.number, i)); });
    ctx.stats.cpuCullMs += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// Where texels are smaller than pixels even for the nearest slices, one is as good as four, and costs a third.
void filterSlices(const DrawContext& ctx, const Field& f, const SliceTextures& t, SliceLevels levels) {
    const float texels = std::min(static_cast<float>(t.reflectance.width) / f.grows().cellSize,
                                  static_cast<float>(t.reflectance.height) / std::max(t.top, 1e-3f));
    const float nearest = std::max(f.view->tiers.slicesFrom, 0.0f);
    const bool small = texels * nearest > pixelsPerMetre(ctx.camera, wholeHeight(ctx.settings));
    for (const Texture* s : {&t.reflectance, &t.threshold, &t.light}) {
        glTextureParameteri(s->id(), GL_TEXTURE_MIN_FILTER,
                            small                        ? GL_NEAREST_MIPMAP_NEAREST
                            : levels == SliceLevels::One ? GL_LINEAR_MIPMAP_NEAREST
                                                         : GL_LINEAR_MIPMAP_LINEAR);
        glTextureParameteri(s->id(), GL_TEXTURE_MAG_FILTER, small ? GL_NEAREST : GL_LINEAR);
    }
}

void drawSpecies(DrawContext& ctx, const Field& field, size_t i, const SliceDraw& s) {
    if (s.selected.empty()) return;
    bindVerticalSlices(ctx, field, i, SliceLevels::Blended);
    glBindVertexArray(s.mesh.id());
    const int each = 12 * s.slices;
    for (const SliceRun& run : s.runs) {
        glDrawElementsInstancedBaseInstance(GL_TRIANGLES, each, GL_UNSIGNED_SHORT,
                                            reinterpret_cast<const void*>(static_cast<uintptr_t>(run.order * each) * 2),
                                            static_cast<GLsizei>(run.count), static_cast<GLuint>(run.first));
        ctx.pass->draws += 1;
        ctx.pass->instances += run.count;
    }
}

void drawSlices(DrawContext& ctx) {
    SlicesView& view = ctx.ofView<SlicesView>();
    const Field* begun = nullptr;
    eachSpecies(ctx, Feature::GrassSlices, [&](const Field& field, size_t i) {
        if (begun != &field && !beginField(ctx, field, 0, fieldConstants(field.view->of))) return;
        begun = &field;
        drawSpecies(ctx, field, i, view.species.at(field.number, i));
    });
    endTransparency();
}

// --- the horizontal slice ----------------------------------------------------------------------------------
void bakeFar(DrawContext& ctx) { makeSlices(ctx, Feature::GrassFar); }

void selectFar(DrawContext& ctx) {
    FarView& state = ctx.ofView<FarView>();
    if (!ctx.shared.grass) return;
    if (!state.nodes.id()) state.nodes = makeBuffer(ctx.gpu, kFarOwner, NODES_PER_DRAW * sizeof(TerrainNode), nullptr);
    state.selected.clear();
    for (Field* field : fieldsWith(ctx, Feature::GrassFar)) {
        for (size_t i = 0; i < field->species.size(); ++i) {
            const SliceGlobals g = sliceGlobalsOf(ctx, *field, i);
            writeBuffer(ctx.gpu, field->species[i].sliceGlobals, kFarOwner, sizeof(g), &g);
        }
        state.selected.push_back({field, farNodes(ctx, *field, std::numeric_limits<float>::infinity())});
        ctx.stats.macroCells += state.selected.back().nodes.size();
    }
}

void filterFar(GLuint texture, Filtering filtering) {
    const bool anisotropic = filtering == Filtering::Anisotropic;
    glTextureParameterf(texture, GL_TEXTURE_MAX_ANISOTROPY, anisotropic ? 8.0f : 1.0f);
}

const GrownSpecies& grownOf(const FarSpecies& far) { return *far.field->species[far.species].grown; }

// From the lowest slice to the highest: they are blended over each other without depth, and eyes are above.
std::vector<FarSpecies> lowestFirst(const FarView& state) {
    std::vector<FarSpecies> order;
    for (const FarGround& ground : state.selected)
        for (size_t i = 0; i < ground.field->species.size(); ++i) order.push_back({ground.field, i, ground.nodes});
    std::stable_sort(order.begin(), order.end(), [](const FarSpecies& a, const FarSpecies& b) {
        return grownOf(a).slices.top < grownOf(b).slices.top;
    });
    return order;
}

void beginFar(const DrawContext& ctx, const Field& field) {
    const bool overdraw = ctx.settings.mode == ViewMode::Overdraw, blended = field.draws(Feature::GrassBlended);
    if (overdraw || blended)
        glEnable(GL_BLEND);
    else
        glDisable(GL_BLEND);
    glBlendFunc(overdraw ? GL_ONE : GL_SRC_ALPHA, overdraw ? GL_ONE : GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(!blended);
}

void drawFar(DrawContext& ctx) {
    FarView& state = ctx.ofView<FarView>();
    const Field* begun = nullptr;
    for (const FarSpecies& far : lowestFirst(state)) {
        if (far.nodes.empty()) continue;
        if (begun != far.field) {
            if (!ctx.use(0, fieldConstants(far.field->view->of), &far.field->view->constants)) return;
            bindField(*far.field);
            beginFar(ctx, *far.field);
        }
        begun = far.field;
        const GrownSpecies& s = grownOf(far);
        for (const Texture* t : {&s.slices.farReflectance, &s.slices.farThreshold, &s.slices.farLight})
            filterFar(t->id(), far.field->view->settings<GrassSlices>().filtering);
        drawFarSpecies(ctx, far, state.nodes);
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

// --- rows --------------------------------------------------------------------------------------------------
const System kFarSystems[] = {
    {"grass/far/bake", {.reads = {Slot::Grown, Slot::Sun, Slot::SkyLight}, .writes = {Slot::Slices}}, bakeFar, true},
    {"grass/far/select",
     {.reads = {Slot::Grass, Slot::Ground, Slot::GroundNodes, Slot::Sun, Slot::Slices}, .writes = {Slot::FarGround}},
     selectFar}};
const System kSliceSystems[] = {
    {"grass/slices/select", {.reads = {Slot::Grass, Slot::Ground, Slot::Slices}}, selectSlices}};
const ProgramRow kFarPrograms[] = {{"grass/far", "grass/far.vert.glsl", "grass/far.frag.glsl", nullptr, fieldVariants}};
const ProgramRow kSlicePrograms[] = {
    {"grass/slices", "grass/slices.vert.glsl", "grass/slices.frag.glsl", nullptr, fieldVariants}};
const Pass kFarPasses[] = {
    {"grass/far",
     Stage::Far,
     kViewMain | kViewReflection,
     {.reads = {Slot::Grass, Slot::GroundNodes, Slot::FarGround, Slot::Forces, Slot::Shadows, Slot::ObjectLight},
      .appends = {Slot::SceneColor, Slot::SceneDepth}},
     kFarPrograms,
     drawFar,
     featureSet(Feature::GrassBlended)}};
const Pass kSlicePasses[] = {
    {"grass/slices",
     Stage::Slices,
     kViewMain | kViewReflection,
     {.reads = {Slot::Grass, Slot::Slices, Slot::FarGround, Slot::Forces, Slot::Shadows, Slot::ObjectLight},
      .appends = {Slot::SceneColor, Slot::SceneDepth}},
     kSlicePrograms,
     drawSlices,
     featureSet(Feature::GrassBlended),
     false,
     true}};
constexpr const char* kRepeats = "slices are images of one patch: grass that is drawn by them repeats it";
constexpr const char* kSinks = "slices sink and lean";
constexpr const char* kLies = "the horizontal slice covers what sunk slices leave, as grass that lies";
const Follows kSlicesFollow[] = {{Feature::Wind, "slices lean with the gust"},
                                 {Feature::Forces, kSinks},
                                 {Feature::ForceMap, kSinks},
                                 {Feature::GrassUnique, kRepeats}};
const Follows kFarFollows[] = {{Feature::Wind, "the horizontal slice brightens and darkens with the gust"},
                               {Feature::Forces, kLies},
                               {Feature::ForceMap, kLies},
                               {Feature::GrassUnique, kRepeats}};

// Where the horizontal slice begins to rise: where what stands upright ends, and not before eyes over grass that is so
// high (m) look down less than it rises.
float risesFrom(const Field& field, float height) {
    const bool vertical = field.draws(Feature::GrassSlices) || field.draws(Feature::GrassRaytraced);
    const FieldTiers& tiers = field.view->tiers;
    const FadeRange& last = vertical ? tiers.flat : tiers.images;
    return std::isinf(last.max) ? last.max : std::max(last.min, 10 * height);
}

}  // namespace

std::vector<TerrainNode> farNodes(const DrawContext& ctx, const Field& f, float far) {
    std::vector<TerrainNode> out;
    const float near = f.view->tiers.flatFrom;
    for (const TerrainNode& n : ctx.shared.groundMesh.nodes) {
        const float side = 16 * n.spacing;
        const glm::vec2 low = n.corner, high = low + glm::vec2(side), reach = glm::max(glm::abs(low), glm::abs(high));
        const float tall = std::max(std::abs(static_cast<float>(ctx.eye.y) - ctx.shared.bounds.low),
                                    std::abs(static_cast<float>(ctx.eye.y) - ctx.shared.bounds.high));
        if (glm::length(glm::vec3(reach.x, reach.y, tall)) > near &&
            glm::length(glm::max(glm::max(low, -high), glm::vec2(0))) < far)
            out.push_back(n);
    }
    return out;
}

void drawFarSpecies(DrawContext& ctx, const FarSpecies& far, const Buffer& room) {
    const GrownSpecies& s = grownOf(far);
    if (s.density) glBindTextureUnit(TEX_DENSITY, s.density);
    bindSlices(far.field->species[far.species], s.slices.farReflectance.id(), s.slices.farThreshold.id(),
               s.slices.farLight.id());
    ctx.pass->draws += drawNodes(ctx.shared.groundMesh, far.nodes, room);
    ctx.pass->instances += far.nodes.size();
}

void bindVerticalSlices(const DrawContext& ctx, const Field& field, size_t i, SliceLevels levels) {
    const FieldSpecies& species = field.species[i];
    const GrownSpecies& grown = *species.grown;
    if (grown.density) glBindTextureUnit(TEX_DENSITY, grown.density);
    filterSlices(ctx, field, grown.slices, levels);
    bindSlices(species, grown.slices.reflectance.id(), grown.slices.threshold.id(), grown.slices.light.id());
}

SliceGlobals sliceGlobalsOf(const DrawContext& ctx, const Field& field, size_t index) {
    const GrassField& f = field.grows();
    const Species& sp = f.species[index];
    const GrownSpecies& s = *field.species[index].grown;
    const FieldTiers& tiers = field.view->tiers;
    const auto& images = field.view->settings<GrassSlices>();
    SliceGlobals g{};
    const glm::dvec2 eye = glm::dvec2(ctx.eye.x, ctx.eye.z) / double(f.cellSize), cell = glm::floor(eye);
    g.minGeom = tiers.images.min, g.geomInv = tiers.images.inv;
    g.minBTF = tiers.flat.min, g.btfInv = tiers.flat.inv;
    setGains(g, images.sliceCover == SliceCover::Conserving, s.gains);
    g.cellSize = f.cellSize;
    g.top = s.slices.top;
    g.slices = s.slices.slices;
    g.reflectScale = s.slices.reflectScale;
    g.area = {s.look.across, s.look.above}, g.laidArea = {s.look.laidAcross, s.look.laidAbove};
    g.farHeight = images.farHeight * s.slices.top, g.farDepth = s.slices.farDepth * s.patch.sown.share;
    g.farRise = std::max(s.look.grazed - g.farHeight, 0.0f);
    g.riseFrom = risesFrom(field, s.look.grazed);
    g.eyeCell = cell, g.inCell = eye - cell;
    g.fade = field.view->settings<GrassDrawing>().fade;
    g.seed = static_cast<uint32_t>(f.seed);
    g.species = static_cast<int>(index);
    g.farTexels = static_cast<float>(s.slices.farReflectance.width);
    g.sunWeights = imageWeights(ctx.globals.sunDirection, weightingOf(images));
    g.ambient = s.gains.sliceAmbient, g.farAmbient = s.gains.farAmbient;
    g.steepest = s.slices.means.stand.steepest;
    const glm::vec3 clumps = clumpStrengths(sp);
    g.clumpSize = sp.clumpSize, g.clumpLean = clumps.x, g.clumpHeight = clumps.y, g.clumpLightness = clumps.z;
    g.leanAtFull = leanAtFull(sp);
    g.translucency = sp.translucency;
    g.meanHeight = s.look.height / f.cellSize;
    g.sharpness = std::exp2(-images.sharpness);
    g.layers = s.slices.layers;
    const f32::Sown& sown = s.patch.sown;
    g.spread = sown.spread, g.step = sown.step, g.sownShare = sown.share;
    g.sowSeed = sowingSeed(sp, g.seed);
    return g;
}

void makeSlices(DrawContext& ctx, Feature feature) {
    eachGrown(ctx, feature, [&](GrownField& field, size_t i) {
        ensureSlices(ctx, field, i);
        makeGains(ctx, field, i);
    });
}

bool showsVertical(const GrownField& field) {
    return field.draws(Feature::GrassSlices) || field.draws(Feature::GrassRaytraced) ||
           field.draws(Feature::GrassOnMeshes);
}

SliceSpec sliceSpec(const FieldEntity& field, size_t species, const Rgba8& blade, bool shaded, bool draft) {
    const auto& images = field.settings<GrassSlices>();
    SliceSpec s;
    s.species = field.grows.species[species];
    s.species.density = {};
    s.cellSize = field.grows.cellSize;
    s.seed = static_cast<uint32_t>(field.grows.seed);
    const int share = draft ? 8 : 1;
    s.slices = images.slices;
    s.width = images.sliceWidth / share, s.height = images.sliceHeight / share, s.farSize = images.farSize / share;
    s.blade = blade;
    s.shadowMask = shaded ? field.settings<GrassDrawing>().shadowMask : 0;
    return s;
}

Result<SliceImages> slicesOf(const std::filesystem::path& folder, const SliceSpec& spec, JobControl& control,
                             bool* cached) {
    const uint64_t key = sliceKey(spec);
    auto kept = loadCachedSlices(folder, key);
    if (cached) *cached = kept.has_value();
    if (kept) return std::move(*kept);
    Result<SliceImages> made = bakeSlices(spec, control);
    if (made) cacheSlices(folder, key, *made);
    return made;
}

std::vector<SliceSpec> projectSlices(const Project& project, const Tables& tables) {
    std::vector<SliceSpec> out;
    const bool lit = has(sceneFeatures(project.registry, tables), Feature::CastingLights);
    for (const auto& [name, field] : fieldsOf(project)) {
        const FeatureSet own = fieldFeatures(tables.techniques, field);
        if (!has(own, Feature::GrassFar) && !has(own, Feature::GrassOnMeshes)) continue;
        for (size_t i = 0; i < field.grows.species.size(); ++i)
            out.push_back(sliceSpec(field, i, bladeImage(project, field.grows.species[i]),
                                    lit && has(own, Feature::BladeShadows)));
    }
    return out;
}

const EffectRow& farEffect() {
    static const EffectRow row{
        .name = "grass/far",
        .needs = featureSet(Feature::GrassFar, Feature::Grass, Feature::Terrain),
        .systems = kFarSystems,
        .passes = kFarPasses,
        .help = "far grass is one slice over the ground",
        .makeView = [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<FarView>(); },
        .follows = kFarFollows};
    return row;
}
const EffectRow& slicesEffect() {
    static const EffectRow row{
        .name = "grass/slices",
        .needs = featureSet(Feature::GrassSlices, Feature::Grass, Feature::Terrain),
        .systems = kSliceSystems,
        .passes = kSlicePasses,
        .help = "grass at middle distance is vertical slices",
        .makeView = [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<SlicesView>(); },
        .follows = kSlicesFollow};
    return row;
}

}  // namespace sward
