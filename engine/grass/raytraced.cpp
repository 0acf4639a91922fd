#include "grass/raytraced.h"

#include "frame/draw_context.h"
#include "grass/field.h"
#include "grass/raytraced_settings.h"
#include "grass/slices.h"

namespace sward {
namespace {

constexpr const char* kOwner = "grass/raytraced";

// The ground over which a field is traced, nearest first.
struct Carrier {
    const Field* field;
    std::vector<TerrainNode> nodes;
    bool inside = false;  // the eye is in the shell
    float reach = 0;      // metres over the ground within which rays begin
};
struct RayView : EffectState {
    Buffer nodes;
    VertexArray screen;
    DepthCopy depth;                // the scene's, if rays end there
    std::vector<Carrier> carriers;  // of this frame
};

// Least and greatest distance of a node from the eye, over the ground.
struct Reach {
    float least, most;
};
Reach reachOf(const TerrainNode& n) {
    const glm::vec2 low = n.corner, high = low + glm::vec2(16 * n.spacing);
    return {glm::length(glm::max(glm::max(low, -high), glm::vec2(0))),
            glm::length(glm::max(glm::abs(low), glm::abs(high)))};
}

float topOf(const Field& field) {
    float top = 0;
    for (const FieldSpecies& s : field.species) top = std::max(top, s.grown->slices.top);
    return top;
}

// How far over the ground from the eye rays begin at most, where the shell above the ground is at most `far` away;
// negative: none does.
float reachOver(const DrawContext& ctx, float top, float far) {
    const float eye = static_cast<float>(ctx.eye.y), low = ctx.shared.bounds.low + top,
                high = ctx.shared.bounds.high + top, above = std::max({eye - high, low - eye, 0.0f});
    return above < far ? std::sqrt(far * far - above * above) : -1;
}

// Those over which a field's rays begin between two distances, the greater one over the ground, or come to slices
// there.
std::vector<TerrainNode> nodesBetween(const DrawContext& ctx, float near, float far) {
    const float above = std::max(std::abs(static_cast<float>(ctx.eye.y) - ctx.shared.bounds.low),
                                 std::abs(static_cast<float>(ctx.eye.y) - ctx.shared.bounds.high));
    std::vector<TerrainNode> out;
    for (const TerrainNode& n : ctx.shared.groundMesh.nodes)
        if (const Reach r = reachOf(n); r.least < far && std::hypot(r.most, above) > near) out.push_back(n);
    std::stable_sort(out.begin(), out.end(),
                     [](const TerrainNode& a, const TerrainNode& b) { return reachOf(a).least < reachOf(b).least; });
    return out;
}

// Whether the eye is over the terrain and lower than the grass may reach.
bool eyeInside(const DrawContext& ctx, const Field& field) {
    const Terrain& t = *ctx.shared.ground.terrain;
    if (!(ctx.eye.x >= 0 && ctx.eye.z >= 0 && ctx.eye.x <= t.size.x && ctx.eye.z <= t.size.y)) return false;
    const double above = ctx.eye.y - terrainHeight(t, ctx.eye.x, ctx.eye.z);
    return above >= 0 && above < static_cast<double>(topOf(field));
}

// Rays go on for a while behind where they come in: nodes that lie a little nearer than the first slices have some.
constexpr float kAhead = 4;        // metres
constexpr float kFarthest = 1e9f;  // metres: its square is a float

Carrier carrierOfBlades(const DrawContext& ctx, const Field& field) {
    const FieldTiers& tiers = field.view->tiers;
    const float reach = reachOver(ctx, topOf(field), std::min(tiers.slicesTo, kFarthest));
    return {&field, nodesBetween(ctx, tiers.slicesFrom - kAhead, reach), tiers.slicesFrom <= 0 && eyeInside(ctx, field),
            reach};
}

void selectRays(DrawContext& ctx) {
    RayView& view = ctx.ofView<RayView>();
    view.carriers.clear();
    if (!ctx.shared.grass) return;
    if (!view.nodes.id()) view.nodes = makeBuffer(ctx.gpu, kOwner, NODES_PER_DRAW * sizeof(TerrainNode), nullptr);
    if (!view.screen.id()) view.screen = makeVertexArray(kOwner);
    for (const Field* field : fieldsWith(ctx, Feature::GrassRaytraced))
        view.carriers.push_back(carrierOfBlades(ctx, *field));
}

std::string rayConstants(bool inside, bool whole, RayRest rest, RayVisibility visibility) {
    return fmt::format(
        "const bool INSIDE = {};\nconst bool WHOLE = {};\nconst int REST = {};\nconst bool ENDS_AT_SCENE = {};\n",
        inside, whole, static_cast<int>(rest), visibility == RayVisibility::Scene);
}
// Whether all of its blades grow and slices draw them all, wherever rays go: opacity is then what slices store.
bool isWhole(const Field& field) {
    const FieldTiers& tiers = field.view->tiers;
    return !field.draws(Feature::GrassDensity) && isSownWhole(field) && tiers.slicesFrom <= 0 && tiers.images.inv < 0 &&
           tiers.images.min <= 0 && tiers.flat.inv == 0;
}
bool endsAtScene(const Field& field) {
    return field.view->settings<RaytracedGrass>().visibility == RayVisibility::Scene;
}

enum RayProgram { kRaysOver, kRaysInside };

bool begin(DrawContext& ctx, const Carrier& c, bool inside) {
    const Field& field = *c.field;
    const auto& own = field.view->settings<RaytracedGrass>();
    const std::string constants = fieldConstants(field.view->of) +
                                  rayConstants(inside, isWhole(field), own.rest, own.visibility) +
                                  (endsAtScene(field) ? depthConstants(ctx.targets) : depthVariants()[0]);
    if (!beginField(ctx, field, inside ? kRaysInside : kRaysOver, constants)) return false;
    glUniform1i(0, own.steps);
    glUniform1f(1, own.cutOff);
    glUniform1f(2, own.depthAt);
    glUniform1f(3, pixelsPerMetre(ctx.camera, wholeHeight(ctx.settings)));
    glUniform1f(6, own.footprint);
    if (!inside) glUniform1f(4, c.reach);
    return true;
}

void drawOver(DrawContext& ctx, const Carrier& c, const Buffer& room) {
    if (c.nodes.empty() || !begin(ctx, c, false)) return;
    for (size_t i = 0; i < c.field->species.size(); ++i) {
        bindVerticalSlices(ctx, *c.field, i, SliceLevels::One);
        ctx.pass->draws += drawNodes(ctx.shared.groundMesh, c.nodes, room);
        ctx.pass->instances += c.nodes.size();
    }
}

void drawInside(DrawContext& ctx, const Carrier& c, const VertexArray& screen) {
    if (!c.inside || !begin(ctx, c, true)) return;
    glBindVertexArray(screen.id());
    for (size_t i = 0; i < c.field->species.size(); ++i) {
        bindVerticalSlices(ctx, *c.field, i, SliceLevels::One);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        ctx.pass->draws += 1;
        ctx.pass->instances += 1;
    }
}

void drawRays(DrawContext& ctx) {
    RayView& view = ctx.ofView<RayView>();
    if (std::any_of(view.carriers.begin(), view.carriers.end(), [](const Carrier& c) { return endsAtScene(*c.field); }))
        copyDepth(ctx, kOwner, view.depth);
    else
        view.depth = {};
    for (const Carrier& c : view.carriers) {
        drawInside(ctx, c, view.screen);
        drawOver(ctx, c, view.nodes);
    }
    endTransparency();
}

// All ways in which its programs differ.
std::vector<std::string> rayVariants(bool inside) {
    std::vector<std::string> out;
    const std::vector<std::string> depths = depthVariants();
    for (const std::string& field : fieldVariants())
        for (const bool whole : {false, true})
            out.push_back(field + rayConstants(inside, whole, RayRest::Mean, RayVisibility::Depth) + depths[0]);
    const std::string plain = fieldConstants(GrassDrawing{}, {});
    for (const RayRest rest : {RayRest::Opaque, RayRest::Nothing})
        out.push_back(plain + rayConstants(inside, false, rest, RayVisibility::Depth) + depths[0]);
    for (const std::string& depth : depths)
        out.push_back(plain + rayConstants(inside, false, RayRest::Mean, RayVisibility::Scene) + depth);
    return out;
}

const System kSystems[] = {
    {"grass/raytraced/select", {.reads = {Slot::Grass, Slot::Ground, Slot::GroundNodes, Slot::Slices}}, selectRays}};
const ProgramRow kPrograms[] = {{"grass/raytraced", "grass/raytraced.vert.glsl", "grass/raytraced.frag.glsl", nullptr,
                                 [] { return rayVariants(false); }},
                                {"grass/raytraced/inside", "grass/raytraced.vert.glsl", "grass/raytraced.frag.glsl",
                                 nullptr, [] { return rayVariants(true); }}};
const Pass kPasses[] = {{"grass/raytraced",
                         Stage::Slices,
                         kViewMain | kViewReflection,
                         {.reads = {Slot::Grass, Slot::GroundNodes, Slot::Slices, Slot::FarGround, Slot::Forces,
                                    Slot::Shadows, Slot::ObjectLight, Slot::Lamps},
                          .appends = {Slot::SceneColor, Slot::SceneDepth}},
                         kPrograms,
                         drawRays,
                         featureSet(Feature::GrassBlended),
                         false,
                         true}};
const Follows kFollows[] = {
    {Feature::Wind, "rays lean against the gust, so that slices lean with it"},
    {Feature::Forces, "the shell sinks and leans"},
    {Feature::ForceMap, "the shell sinks and leans"},
    {Feature::GrassUnique, "slices are images of one patch: grass that is drawn by them repeats it"}};

}  // namespace

const EffectRow& raytracedEffect() {
    static const EffectRow row{
        .name = "grass/raytraced",
        .needs = featureSet(Feature::GrassRaytraced, Feature::Grass, Feature::Terrain),
        .systems = kSystems,
        .passes = kPasses,
        .help = "rays are traced through slices, pixel by pixel",
        .makeView = [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<RayView>(); },
        .follows = kFollows};
    return row;
}

}  // namespace sward
