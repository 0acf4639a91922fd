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
#include "grass/slice_file.h"
#include "shared/slices.h"
#include "world/wind.h"

namespace sward {
namespace {

constexpr const char* kOwner = "grass/slices";
constexpr const char* kFarOwner = "grass/far";

// --- making slices
// -----------------------------------------------------------------------------------------------------
struct FarState : EffectState {
    Buffer nodes;
    std::vector<TerrainNode> selected;
};
struct FarShadowState : EffectState {
    Buffer nodes;
};

bool slicesAreShaded(const FeatureSet& features) {
    return has(features, Feature::BladeShadows) && has(features, Feature::CastingLights);
}

void upload(DrawContext& ctx, const GrassField& f, FieldSpecies& s, uint64_t key, const SliceImages& images) {
    const bool vertical = has(ctx.plan.features, Feature::GrassSlices);
    s.slices = uploadSlices(ctx.gpu, vertical ? kOwner : "", kFarOwner, images, static_cast<Storage>(f.storage));
    s.sliceKey = key;
}

// Which textures the species should have: what they are made from, and how they are stored.
uint64_t textureKey(const DrawContext& ctx, const GrassField& f, uint64_t slices) {
    const uint64_t parts[] = {slices, static_cast<uint64_t>(f.storage),
                              has(ctx.plan.features, Feature::GrassSlices) ? 1u : 0u};
    return hashBytes(parts, sizeof(parts));
}

// Slices that can be shown now. Where one may wait, waits for them.
std::optional<SliceImages> slicesThere(const DrawContext& ctx, FieldSpecies& s, const SliceSpec& spec, uint64_t key) {
    if (!ctx.settings.background) {
        s.bake = {};
        JobControl control;
        return std::move(*slicesOf(cacheDir(), spec, control));
    }
    if (auto made = s.bake.take(key); made && *made) return std::move(**made);
    if (s.bake.active()) return std::nullopt;
    return loadCachedSlices(cacheDir(), key);
}

void startBake(FieldSpecies& s, const SliceSpec& spec, uint64_t key) {
    s.bakeOf = key;
    s.bake = Job<SliceImages>("slices of " + spec.species.name, key,
                              [spec](JobControl& c) { return slicesOf(cacheDir(), spec, c); });
}

// What was begun for other blades is cancelled. While slices are made beside, a draft of them is shown.
void ensureSlices(DrawContext& ctx, const GrassField& f, const Species& species, FieldSpecies& s) {
    const bool shaded = slicesAreShaded(ctx.plan.features);
    // Most frames ask for what is there: the image's hash stands for its pixels.
    const uint64_t asked = textureKey(ctx, f, sliceKey(sliceSpec(f, species, {}, shaded)) ^ s.bladeHash);
    if (s.sliceAsked == asked) return;
    s.sliceAsked = 0;
    const SliceSpec spec = sliceSpec(f, species, s.bladeImage, shaded);
    const uint64_t key = sliceKey(spec), wanted = textureKey(ctx, f, key);
    if (s.sliceKey == wanted) {
        s.sliceAsked = asked;
        return;
    }
    if (s.bakeOf != key) s.bake = {};
    if (const auto there = slicesThere(ctx, s, spec, key)) return upload(ctx, f, s, wanted, *there);
    if (s.bake.active()) return;
    JobControl control;
    upload(ctx, f, s, ~wanted, *bakeSlices(sliceSpec(f, species, s.bladeImage, shaded, true), control));
    startBake(s, spec, key);
}

// Whether slices stand for what else is drawn blade by blade (frame/plan.h, coarseFeatures).
bool slicesAlone(const DrawContext& ctx, const GrassField& f) {
    return ctx.settings.coarse && has(ctx.plan.features, Feature::GrassSlices) &&
           static_cast<Technique>(f.technique) == Technique::Hybrid;
}

// --- uniforms
// ------------------------------------------------------------------------------------------------------------
FieldLight fieldLight(const DrawContext& ctx, const GrassField& f, const Species& s, size_t index) {
    const FrameGlobals& g = ctx.globals;
    FieldLight l;
    l.sky = g.skyLight, l.ground = g.groundLight;
    if (has(ctx.plan.features, Feature::Sun) && g.sunIsUp > 0) l.suns.push_back({g.sunDirection, g.sunLight});
    l.weighting = f.lightWeights;
    l.translucency = s.translucency, l.gloss = s.gloss, l.roughness = s.roughness;
    if (g.sunCasts > 0 && ctx.shared.shades[index].texture) l.shade = &ctx.shared.shades[index];
    l.lean = has(ctx.plan.features, Feature::GrassOrientation) ? leanAtFull(s) : 0.0f;
    if (s.clumpSize > 0) l.lean = std::max(l.lean, clumpStrengths(s).x);
    if (has(ctx.plan.features, Feature::Wind))
        l.lean = std::max(l.lean, std::clamp(windStrength(*firstOf<Wind>(ctx.project), s), 0.25f, 0.6f));
    l.pressed = has(ctx.plan.features, Feature::Forces) || has(ctx.plan.features, Feature::ForceMap);
    return l;
}

void updateGains(FieldSpecies& s, const FieldLight& l) {
    std::vector<float> read{l.sky.x,
                            l.sky.y,
                            l.sky.z,
                            l.ground.x,
                            l.ground.y,
                            l.ground.z,
                            static_cast<float>(l.weighting),
                            l.lean,
                            l.translucency,
                            l.gloss,
                            l.roughness,
                            l.pressed ? 1.0f : 0.0f};
    if (l.shade) read.insert(read.end(), l.shade->rows.begin(), l.shade->rows.end());
    for (const auto& [d, c] : l.suns) read.insert(read.end(), {d.x, d.y, d.z, c.x, c.y, c.z});
    const uint64_t key = hashBytes(read.data(), read.size() * sizeof(float)) ^ s.lookKey;
    if (s.gainKey == key) return;
    s.gainKey = key;
    s.gains = gainsOf(s.look, l);
}

// The distances between which slices stand for blades.
void setTiers(SliceGlobals& g, const DrawContext& ctx, const GrassField& f) {
    const bool only = static_cast<Technique>(f.technique) == Technique::Slices;
    GeometryRange range = slicesAlone(ctx, f) ? GeometryRange{0, f32::lodInverse(0, 0), 0} : geometryRange(f);
    if (static_cast<Technique>(f.technique) == Technique::Tessellated)  // takes over while blades get lower
        range = {f.lowerFrom * f.maxDistance, f32::lodInverse(f.lowerFrom * f.maxDistance, f.maxDistance),
                 f.maxDistance};
    g.minGeom = range.min, g.geomInv = range.inv;
    g.minBTF = only ? 0.0f : f.minBTF, g.btfInv = only ? 0.0f : f32::lodInverse(f.minBTF, f.maxBTF);
}

void setGains(SliceGlobals& g, const GrassField& f, const Gains& gains) {
    const bool conserving = f.sliceCover == static_cast<int>(SliceCover::Conserving);
    const glm::vec4 none(1, 1, 1, 0);
    for (size_t i = 0; i < LOOK_VIEWS; ++i) {
        const glm::vec4 across = conserving ? gains.slices[i] : none, above = conserving ? gains.far[i] : none,
                        laid = conserving ? gains.laid[i] : none;
        g.gains[i] = {across, across.w, above, above.w, laid};
    }
}

SliceGlobals globalsOf(const DrawContext& ctx, const GrassField& f, const Species& sp, const FieldSpecies& s,
                       size_t index) {
    SliceGlobals g{};
    const glm::dvec2 eye = glm::dvec2(ctx.eye.x, ctx.eye.z) / double(f.cellSize), cell = glm::floor(eye);
    setTiers(g, ctx, f);
    setGains(g, f, s.gains);
    g.cellSize = f.cellSize;
    g.top = s.slices.top;
    g.slices = s.slices.slices;
    g.reflectScale = s.slices.reflectScale;
    g.area = {s.look.across, s.look.above}, g.laidArea = {s.look.laidAcross, s.look.laidAbove};
    g.farHeight = f.farHeight * s.slices.top, g.farDepth = s.slices.farDepth;
    g.eyeCell = cell, g.inCell = eye - cell;
    g.fade = f.fade;
    g.seed = static_cast<uint32_t>(f.seed);
    g.species = static_cast<int>(index);
    g.farTexels = static_cast<float>(s.slices.farReflectance.width);
    g.sunWeights = imageWeights(ctx.globals.sunDirection, f.lightWeights);
    g.ambient = s.gains.sliceAmbient, g.farAmbient = s.gains.farAmbient;
    g.steepest = 0.6f * s.look.height * static_cast<float>(s.slices.slices) / f.cellSize;
    const glm::vec3 clumps = clumpStrengths(sp);
    g.clumpSize = sp.clumpSize, g.clumpLean = clumps.x, g.clumpHeight = clumps.y, g.clumpLightness = clumps.z;
    g.leanAtFull = leanAtFull(sp);
    g.translucency = sp.translucency;
    g.meanHeight = s.look.height / f.cellSize;
    g.sharpness = std::exp2(-f.sharpness);
    return g;
}

void bindSlices(const FieldSpecies& s, GLuint reflectance, GLuint threshold, GLuint light) {
    glBindTextureUnit(TEX_SLICE_REFLECTANCE, reflectance);
    glBindTextureUnit(TEX_SLICE_THRESHOLD, threshold);
    glBindTextureUnit(TEX_SLICE_LIGHT, light);
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_SLICES, s.sliceGlobals.id());
}

// --- vertical slices
// ---------------------------------------------------------------------------------------------------
struct SliceDraw {
    Buffer indices, cells;
    VertexArray mesh;
    int slices = 0;
    std::vector<SliceCell> selected;
    int first[5] = {};  // cells sorted into the four quarters around the eye
};
struct SlicesState : EffectState {
    std::vector<std::unique_ptr<SliceDraw>> species;
};

// Quads of a cell in four orders, nearest first for an eye to its -x or +x, -z or +z. Vertex 4 q + corner of quad q;
// the first n quads cut x.
std::vector<uint16_t> sliceIndices(int n) {
    std::vector<uint16_t> out;
    for (int quarter = 0; quarter < 4; ++quarter)
        for (int i = 0; i < n; ++i)
            for (int axis = 0; axis < 2; ++axis) {
                const bool fromHigh = quarter >> axis & 1;
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

void uploadSliceCells(DrawContext& ctx, SliceDraw& s, float cellSize) {
    std::stable_sort(s.selected.begin(), s.selected.end(), [&](const SliceCell& a, const SliceCell& b) {
        return quarterOf(a, cellSize) < quarterOf(b, cellSize);
    });
    for (int q = 0; q <= 4; ++q)
        s.first[q] =
            static_cast<int>(std::partition_point(s.selected.begin(), s.selected.end(),
                                                  [&](const SliceCell& c) { return quarterOf(c, cellSize) < q; }) -
                             s.selected.begin());
    writeBuffer(ctx.gpu, s.cells, kOwner, s.selected.size() * sizeof(SliceCell), s.selected.data());
    describeCells(s.mesh.id(), s.cells.id(), sizeof(SliceCell), s.indices.id());
    ctx.stats.sliceQuads += s.selected.size() * 2 * static_cast<size_t>(s.slices);
    ctx.stats.cells += s.selected.size();
}

void selectSlices(DrawContext& ctx) {
    SlicesState& state = ctx.own<SlicesState>();
    if (!ctx.shared.grass) return;
    const auto start = std::chrono::steady_clock::now();
    const GrassField& f = *firstOf<GrassField>(ctx.project);
    const bool only = static_cast<Technique>(f.technique) == Technique::Slices;
    state.species.resize(ctx.shared.grass->species.size());
    for (size_t i = 0; i < state.species.size(); ++i) {
        if (!state.species[i]) state.species[i] = std::make_unique<SliceDraw>();
        SliceDraw& s = *state.species[i];
        const FieldSpecies& field = *ctx.shared.grass->species[i];
        if (s.slices != field.slices.slices) makeSliceMesh(ctx, s, field.slices.slices);
        const CellQuery q = cellQuery(*ctx.shared.ground.terrain, ctx.shared.bounds, f, f.species[i], field.patch,
                                      ctx.eye, ctx.frustum, 1);
        s.selected = selectSliceCells(q, only || slicesAlone(ctx, f) ? -1 : f.minGeom,
                                      only ? std::numeric_limits<float>::infinity() : f.maxBTF);
        uploadSliceCells(ctx, s, f.cellSize);
    }
    ctx.stats.cpuCullMs += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// Where texels are smaller than pixels even for the nearest slices, one is as good as four, and costs a third.
void filterSlices(const DrawContext& ctx, const GrassField& f, const SliceTextures& t) {
    const float texels = std::min(static_cast<float>(t.reflectance.width) / f.cellSize,
                                  static_cast<float>(t.reflectance.height) / std::max(t.top, 1e-3f));
    const float nearest =
        static_cast<Technique>(f.technique) == Technique::Hybrid && !slicesAlone(ctx, f) ? f.minGeom : 0;
    const bool small = texels * nearest > pixelsPerMetre(ctx.camera, wholeHeight(ctx.settings));
    for (const Texture* s : {&t.reflectance, &t.threshold, &t.light}) {
        glTextureParameteri(s->id(), GL_TEXTURE_MIN_FILTER,
                            small ? GL_NEAREST_MIPMAP_NEAREST : GL_LINEAR_MIPMAP_LINEAR);
        glTextureParameteri(s->id(), GL_TEXTURE_MAG_FILTER, small ? GL_NEAREST : GL_LINEAR);
    }
}

void drawSlices(DrawContext& ctx) {
    SlicesState& state = ctx.own<SlicesState>();
    if (!ctx.shared.grass) return;
    const GrassField& f = *firstOf<GrassField>(ctx.project);
    if (!ctx.use(0, fieldConstants(f))) return;
    beginTransparency(ctx, f);
    for (size_t i = 0; i < state.species.size(); ++i) {
        SliceDraw& s = *state.species[i];
        const FieldSpecies& field = *ctx.shared.grass->species[i];
        if (s.selected.empty()) continue;
        if (ctx.shared.densities[i]) glBindTextureUnit(TEX_DENSITY, ctx.shared.densities[i]);
        filterSlices(ctx, f, field.slices);
        bindSlices(field, field.slices.reflectance.id(), field.slices.threshold.id(), field.slices.light.id());
        glBindVertexArray(s.mesh.id());
        const int each = 12 * s.slices;
        for (int q = 0; q < 4; ++q) {
            const int n = s.first[q + 1] - s.first[q];
            if (n == 0) continue;
            glDrawElementsInstancedBaseInstance(GL_TRIANGLES, each, GL_UNSIGNED_SHORT,
                                                reinterpret_cast<const void*>(static_cast<uintptr_t>(q * each) * 2), n,
                                                static_cast<GLuint>(s.first[q]));
            ctx.pass->draws += 1;
            ctx.pass->instances += static_cast<uint64_t>(n);
        }
    }
    endTransparency();
}

// --- the horizontal slice
// ------------------------------------------------------------------------------------------------ Nodes that reach
// beyond the distance where blades are all there and begin before `far`.
std::vector<TerrainNode> farNodes(const DrawContext& ctx, const GrassField& f, float far) {
    std::vector<TerrainNode> out;
    const float near =
        static_cast<Technique>(f.technique) == Technique::Hybrid && !slicesAlone(ctx, f) ? f.minGeom : -1;
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

void updateFar(DrawContext& ctx) {
    FarState& state = ctx.own<FarState>();
    if (!ctx.shared.grass) return;
    const GrassField& f = *firstOf<GrassField>(ctx.project);
    FieldState& field = *ctx.shared.grass;
    if (!state.nodes.id()) state.nodes = makeBuffer(ctx.gpu, kFarOwner, NODES_PER_DRAW * sizeof(TerrainNode), nullptr);
    for (size_t i = 0; i < field.species.size(); ++i) {
        FieldSpecies& s = *field.species[i];
        ensureSlices(ctx, f, f.species[i], s);
        updateGains(s, fieldLight(ctx, f, f.species[i], i));
        const SliceGlobals g = globalsOf(ctx, f, f.species[i], s, i);
        writeBuffer(ctx.gpu, s.sliceGlobals, kFarOwner, sizeof(g), &g);
    }
    state.selected = farNodes(ctx, f, std::numeric_limits<float>::infinity());
    ctx.stats.macroCells += state.selected.size();
}

void filterFar(GLuint texture, const GrassField& f) {
    const bool anisotropic = f.filtering == static_cast<int>(Filtering::Anisotropic);
    glTextureParameterf(texture, GL_TEXTURE_MAX_ANISOTROPY, anisotropic ? 8.0f : 1.0f);
}

// Species from the lowest slice to the highest: they are blended over each other without depth, and eyes are above.
std::vector<size_t> lowestFirst(const FieldState& field) {
    std::vector<size_t> order(field.species.size());
    std::iota(order.begin(), order.end(), size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](size_t a, size_t b) { return field.species[a]->slices.top < field.species[b]->slices.top; });
    return order;
}

void drawFar(DrawContext& ctx) {
    FarState& state = ctx.own<FarState>();
    if (!ctx.shared.grass || state.selected.empty()) return;
    const GrassField& f = *firstOf<GrassField>(ctx.project);
    if (!ctx.use(0, fieldConstants(f))) return;
    const bool overdraw = ctx.settings.mode == ViewMode::Overdraw,
               blended = has(ctx.plan.features, Feature::GrassBlended);
    if (overdraw || blended) glEnable(GL_BLEND);
    glBlendFunc(overdraw ? GL_ONE : GL_SRC_ALPHA, overdraw ? GL_ONE : GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(!blended);
    for (const size_t i : lowestFirst(*ctx.shared.grass)) {
        const FieldSpecies& s = *ctx.shared.grass->species[i];
        if (ctx.shared.densities[i]) glBindTextureUnit(TEX_DENSITY, ctx.shared.densities[i]);
        for (const Texture* t : {&s.slices.farReflectance, &s.slices.farThreshold, &s.slices.farLight})
            filterFar(t->id(), f);
        bindSlices(s, s.slices.farReflectance.id(), s.slices.farThreshold.id(), s.slices.farLight.id());
        ctx.pass->draws += drawNodes(ctx.shared.groundMesh, state.selected, state.nodes);
        ctx.pass->instances += state.selected.size();
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

// Its shadow on the ground, for each light that casts shadows.
void drawFarShadow(DrawContext& ctx) {
    FarShadowState& state = ctx.own<FarShadowState>();
    if (ctx.settings.mode != ViewMode::Final || !ctx.shared.grass) return;
    const GrassField& f = *firstOf<GrassField>(ctx.project);
    const std::vector<TerrainNode> shaded = farNodes(ctx, f, std::max(f.maxBTF, f.maxGeom));
    if (shaded.empty() || !ctx.use(0, fieldConstants(f))) return;
    if (!state.nodes.id())
        state.nodes = makeBuffer(ctx.gpu, "grass/far-shadow", NODES_PER_DRAW * sizeof(TerrainNode), nullptr);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
    glDepthMask(GL_FALSE);
    const bool sun = has(ctx.plan.features, Feature::Sun) && ctx.globals.sunIsUp > 0 && ctx.globals.sunCasts > 0;
    const int lamps = ctx.shared.lights.casting;
    for (int light = sun ? 0 : 1; light <= lamps; ++light)
        for (size_t i = 0; i < ctx.shared.grass->species.size(); ++i) {
            const FieldSpecies& s = *ctx.shared.grass->species[i];
            glUniform1i(0, light);
            if (ctx.shared.densities[i]) glBindTextureUnit(TEX_DENSITY, ctx.shared.densities[i]);
            bindSlices(s, s.slices.farReflectance.id(), s.slices.farThreshold.id(), s.slices.farLight.id());
            ctx.pass->draws += drawNodes(ctx.shared.groundMesh, shaded, state.nodes);
            ctx.pass->instances += shaded.size();
        }
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

// --- rows
// ------------------------------------------------------------------------------------------------------------------
constexpr auto kLook = [] {
    return featureSet(Feature::TerrainHeights, Feature::GrassSlices, Feature::GrassDensity, Feature::GrassOrientation,
                      Feature::GrassVegetation, Feature::GrassHeights, Feature::GrassOcclusion, Feature::GrassClumps,
                      Feature::Wind, Feature::Gusts, Feature::Forces, Feature::ForceMap, Feature::FarDarkening,
                      Feature::Translucency, Feature::ObjectShadows, Feature::TerrainShadows, Feature::Sun,
                      Feature::Lamps, Feature::Sky, Feature::Fog, Feature::WaterReflection);
};
constexpr auto kShadow = [] {
    return featureSet(Feature::TerrainHeights, Feature::GrassSlices, Feature::GrassDensity, Feature::GrassOrientation,
                      Feature::GrassVegetation, Feature::GrassHeights, Feature::GrassOcclusion, Feature::Forces,
                      Feature::ForceMap, Feature::GroundShadows, Feature::FarDarkening, Feature::CastingLights,
                      Feature::Translucency, Feature::ObjectShadows, Feature::TerrainShadows, Feature::Sun,
                      Feature::Lamps, Feature::Sky, Feature::Fog, Feature::WaterReflection);
};
const System kFarSystems[] = {{"grass/far/bake", updateFar}};
const System kSliceSystems[] = {{"grass/slices/select", selectSlices}};
const ProgramRow kFarPrograms[] = {
    {"grass/far", "grass/far.vert.glsl", "grass/far.frag.glsl", nullptr, kLook(), fieldVariants}};
const ProgramRow kSlicePrograms[] = {
    {"grass/slices", "grass/slices.vert.glsl", "grass/slices.frag.glsl", nullptr, kLook(), fieldVariants}};
const Pass kFarPasses[] = {{"grass/far", Stage::Slices, kViewMain | kViewReflection | kViewCompare, kSceneDepth,
                            kSceneColor | kSceneDepth, kFarPrograms, drawFar}};
const ProgramRow kFarShadowPrograms[] = {
    {"grass/far-shadow", "terrain/ground.vert.glsl", "grass/far_shadow.frag.glsl", nullptr, kShadow(), fieldVariants}};
const Pass kFarShadowPasses[] = {{"grass/far-shadow", Stage::GroundShadow, kViewMain | kViewCompare, kSceneDepth,
                                  kSceneColor, kFarShadowPrograms, drawFarShadow}};
const Pass kSlicePasses[] = {{"grass/slices", Stage::Slices, kViewMain | kViewReflection | kViewCompare, 0,
                              kSceneColor | kSceneDepth, kSlicePrograms, drawSlices}};

}  // namespace

SliceSpec sliceSpec(const GrassField& f, const Species& species, const Rgba8& blade, bool shaded, bool draft) {
    SliceSpec s;
    s.species = species;
    s.species.density = {};
    s.cellSize = f.cellSize;
    s.seed = static_cast<uint32_t>(f.seed);
    const int share = draft ? 8 : 1;
    s.slices = f.slices;
    s.width = f.sliceWidth / share, s.height = f.sliceHeight / share, s.farSize = f.farSize / share;
    s.blade = blade;
    s.shadowMask = shaded ? f.shadowMask : 0;
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
    const FeatureSet features = sceneFeatures(project.registry, tables.components);
    if (!has(features, Feature::GrassFar)) return out;
    for (const auto& [name, e] : project.entities)
        if (const GrassField* f = project.registry.get<GrassField>(e))
            for (size_t i = 0; i < f->species.size() && i < MAX_SPECIES; ++i)
                out.push_back(
                    sliceSpec(*f, f->species[i], bladeImage(project, f->species[i]), slicesAreShaded(features)));
    return out;
}

const EffectRow& farEffect() {
    static const EffectRow row{
        "grass/far",
        featureSet(Feature::GrassFar, Feature::Grass, Feature::Terrain),
        kFarSystems,
        kFarPasses,
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<FarState>(); },
        "far grass is one slice over the ground"};
    return row;
}
const EffectRow& farShadowEffect() {
    static const EffectRow row{
        "grass/far-shadow",
        featureSet(Feature::GrassFar, Feature::Grass, Feature::Terrain, Feature::GroundShadows, Feature::CastingLights),
        {},
        kFarShadowPasses,
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<FarShadowState>(); },
        "slices shade the ground"};
    return row;
}
const EffectRow& slicesEffect() {
    static const EffectRow row{
        "grass/slices",
        featureSet(Feature::GrassSlices, Feature::Grass, Feature::Terrain),
        kSliceSystems,
        kSlicePasses,
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<SlicesState>(); },
        "grass at middle distance is vertical slices"};
    return row;
}

}  // namespace sward
