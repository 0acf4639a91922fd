#include "frame/renderer.h"

#include <glm/gtc/matrix_transform.hpp>

#include "core/log.h"
#include "frame/draw_context.h"
#include "frame/drawn_beside.h"
#include "frame/explain.h"
#include "gpu/timer.h"
#include "scene/map_fields.h"
#include "scene/tiling.h"
#include "world/view_camera.h"

namespace sward {
namespace {

constexpr float kNear = 0.05f;  // metres; the far plane is at infinity

// Reversed depth without a far plane: depth = near / distance. Clip z in [0, w].
glm::mat4 projection(float fovDeg, float aspect) {
    const float f = 1.0f / std::tan(glm::radians(fovDeg) / 2);
    glm::mat4 m(0);
    m[0][0] = f / aspect;
    m[1][1] = f;
    m[2][3] = -1;
    m[3][2] = kNear;
    return m;
}

glm::mat4 rotation(const ViewCamera& c) {
    const glm::dvec3 d = c.target - c.eye;
    const glm::vec3 forward = glm::length(d) > 0 ? glm::vec3(glm::normalize(d)) : glm::vec3(0, 0, -1);
    const glm::vec3 up = std::abs(forward.y) > 0.9999f ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
    return glm::lookAt(glm::vec3(0), forward, up);
}

int wholeWidth(const ViewSettings& s) { return s.part.wholeWidth > 0 ? s.part.wholeWidth : s.width; }

// Stretches the part of clip space that the settings name over all of it.
glm::mat4 partProjection(const ViewSettings& s) {
    glm::mat4 m(1);
    if (s.part.wholeWidth <= 0) return m;
    const double scaleX = static_cast<double>(s.part.wholeWidth) / s.width,
                 scaleY = static_cast<double>(s.part.wholeHeight) / s.height;
    const double middleX = (2.0 * s.part.x + s.width) / s.part.wholeWidth - 1,
                 middleY = (2.0 * s.part.y + s.height) / s.part.wholeHeight - 1;
    m[0][0] = static_cast<float>(scaleX);
    m[1][1] = static_cast<float>(scaleY);
    m[3][0] = static_cast<float>(-middleX * scaleX);
    m[3][1] = static_cast<float>(-middleY * scaleY);
    return m;
}

// Moves what is drawn by a fraction of a pixel.
glm::mat4 jitterProjection(const ViewSettings& s) {
    glm::mat4 m(1);
    m[3][0] = 2 * s.jitter.x / static_cast<float>(s.width);
    m[3][1] = 2 * s.jitter.y / static_cast<float>(s.height);
    return m;
}

// With a stencil only where a pass asks for it. One sample is no multisample texture: drivers may
// give that four.
void ensureTargets(Gpu& gpu, ViewTargets& t, const ViewSettings& s, const FramePlan& plan) {
    const bool motion = framesAddUp(plan, s);
    const int samples = motion ? 1 : gpu.samplesFor(s.msaa);
    if (t.width == s.width && t.height == s.height && t.samples == samples && t.stencil == plan.stencil &&
        (t.motion.id() != 0) == motion)
        return;
    t = {};
    t = makeTargets(gpu, "frame/targets", {s.width, s.height, samples, plan.stencil, 1, true, motion});
}

// Into what of the scene's target a pass draws: beside the colour how far things move, where it says that.
void drawInto(const ViewTargets& t, bool motion) {
    static constexpr GLenum kBoth[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    if (t.motion.id()) glNamedFramebufferDrawBuffers(t.scene.id(), motion ? 2 : 1, kBoth);
}

// The fixed state that every pass may rely on; a pass that changes more restores it. The rest is as a context begins,
// and a user interface that draws between frames leaves it so.
void fixState() {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GEQUAL);  // the ground is lit where its own depth was drawn, the sky at depth 0, where nothing was
}
// What the scene is drawn into: ready before the first pass that has to do with it.
constexpr SlotSet kScene{Slot::SceneColor, Slot::SceneDepth};
void beginScene(const ViewTargets& t) {
    glBindFramebuffer(GL_FRAMEBUFFER, t.scene.id());
    glViewport(0, 0, t.width, t.height);
    const float black[] = {0, 0, 0, 1}, still[] = {0, 0, 0, 0};
    drawInto(t, true);
    glClearNamedFramebufferfv(t.scene.id(), GL_COLOR, 0, black);
    if (t.motion.id()) glClearNamedFramebufferfv(t.scene.id(), GL_COLOR, 1, still);
    glClearNamedFramebufferfi(t.scene.id(), GL_DEPTH_STENCIL, 0, 0, 0);
}

}  // namespace

bool Frustum::touches(const glm::vec3& low, const glm::vec3& high) const {
    for (const glm::vec4& p : planes) {
        const glm::vec3 far(p.x > 0 ? high.x : low.x, p.y > 0 ? high.y : low.y, p.z > 0 ? high.z : low.z);
        if (glm::dot(glm::vec3(p), far) + p.w < 0) return false;
    }
    return true;
}

bool Frustum::holds(const glm::vec3& low, const glm::vec3& high) const {
    for (const glm::vec4& p : planes) {
        const glm::vec3 near(p.x > 0 ? low.x : high.x, p.y > 0 ? low.y : high.y, p.z > 0 ? low.z : high.z);
        if (glm::dot(glm::vec3(p), near) + p.w < 0) return false;
    }
    return true;
}

Frustum frustumOf(const glm::mat4& m) {
    const auto row = [&](int r) { return glm::vec4(m[0][r], m[1][r], m[2][r], m[3][r]); };
    // Left, right, bottom, top, near; the sixth repeats the near one: there is no far plane.
    return {{row(3) + row(0), row(3) - row(0), row(3) + row(1), row(3) - row(1), row(3) - row(2), row(3) - row(2)}};
}

ViewTargets makeTargets(Gpu& gpu, const std::string& owner, const TargetsWanted& wanted) {
    ViewTargets t;
    const auto [width, height, samples, stencil, levels, image, motion] = wanted;
    const GLenum depth = stencil ? GL_DEPTH32F_STENCIL8 : GL_DEPTH_COMPONENT32F;
    t.resolved = makeTexture2D(gpu, owner, GL_RGBA16F, width, height, levels);
    if (samples > 1) t.color = makeTexture2DMultisample(gpu, owner, GL_RGBA16F, width, height, samples);
    t.depth = samples > 1 ? makeTexture2DMultisample(gpu, owner, depth, width, height, samples)
                          : makeTexture2D(gpu, owner, depth, width, height);
    if (image) t.image = makeTexture2D(gpu, owner, GL_RGBA8, width, height);
    t.scene = makeFramebuffer(samples > 1 ? t.color.id() : t.resolved.id(), t.depth.id(), "frame/scene");
    if (motion) {
        t.motion = makeTexture2D(gpu, owner, GL_RGBA16F, width, height);
        glNamedFramebufferTexture(t.scene.id(), GL_COLOR_ATTACHMENT1, t.motion.id(), 0);
    }
    t.resolve = makeFramebuffer(t.resolved.id(), 0, "frame/resolve");
    if (image) t.final = makeFramebuffer(t.image.id(), 0, "frame/image");
    t.width = width, t.height = height, t.samples = samples;
    t.stencil = stencil;
    return t;
}

std::string depthConstants(const ViewTargets& t) { return depthVariants()[t.samples > 1]; }
std::vector<std::string> depthVariants() {
    return {"const bool MULTISAMPLED = false;\n", "const bool MULTISAMPLED = true;\n"};
}

void copyDepth(DrawContext& ctx, const std::string& owner, DepthCopy& copy) {
    const ViewTargets& t = ctx.targets;
    const GLenum format = t.stencil ? GL_DEPTH32F_STENCIL8 : GL_DEPTH_COMPONENT32F,
                 kind = t.samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
    const Texture& had = copy.texture;
    if (had.width != t.width || had.height != t.height || had.format != format || copy.samples != t.samples)
        copy.texture = t.samples > 1 ? makeTexture2DMultisample(ctx.gpu, owner, format, t.width, t.height, t.samples)
                                     : makeTexture2D(ctx.gpu, owner, format, t.width, t.height);
    copy.samples = t.samples;
    glCopyImageSubData(t.depth.id(), kind, 0, 0, 0, 0, copy.texture.id(), kind, 0, 0, 0, 0, t.width, t.height, 1);
    glBindTextureUnit(t.samples > 1 ? TEX_DEPTH_SAMPLES : TEX_DEPTH, copy.texture.id());
}

size_t drawNodes(const GroundMesh& mesh, std::span<const TerrainNode> nodes, const Buffer& room) {
    size_t calls = 0;
    glBindVertexArray(mesh.mesh);
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_NODES, room.id());
    for (size_t first = 0; first < nodes.size(); first += NODES_PER_DRAW, ++calls) {
        const size_t n = std::min<size_t>(NODES_PER_DRAW, nodes.size() - first);
        glNamedBufferSubData(room.id(), 0, static_cast<GLsizeiptr>(n * sizeof(TerrainNode)), &nodes[first]);
        glDrawElementsInstanced(GL_TRIANGLES, mesh.indices, GL_UNSIGNED_SHORT,
                                reinterpret_cast<const void*>(2 * static_cast<uintptr_t>(mesh.firstIndex)),
                                static_cast<GLsizei>(n));
    }
    return calls;
}

ProgramSources sourcesOf(const ProgramRow& p) {
    return {p.name, p.vertex, p.fragment, p.compute, p.control, p.evaluation};
}

bool framesAddUp(const FramePlan& plan, const ViewSettings& s) {
    return plan.motion && s.part.wholeWidth <= 0 && s.mode == ViewMode::Final;
}

bool sketchLeavesOut(Stage stage, const FramePlan& plan) {
    const std::vector<const Pass*> passes = plan.passes();
    const bool flat = std::any_of(passes.begin(), passes.end(), [](const Pass* p) { return p->stage == Stage::Far; });
    switch (stage) {
        case Stage::Shadow:
        case Stage::Flowers:
        case Stage::GroundShadow:
        case Stage::FarShadow:
            return true;
        case Stage::Blades:
        case Stage::Slices:
            return flat;  // which stands for them
        default:
            return false;
    }
}

namespace {
// Whether a sketch leaves a program to a later draw.
bool waits(const DrawContext& ctx, const char* program) {
    if (!ctx.sketching() || !ctx.row || !sketchLeavesOut(ctx.row->stage, ctx.plan)) return false;
    const std::vector<std::string> there = ctx.programs.names();
    if (std::binary_search(there.begin(), there.end(), program)) return false;
    if (ctx.sketch->left-- > 0) return false;
    ctx.sketch->waiting.push_back(program);
    return true;
}
}  // namespace

bool DrawContext::use(size_t index, const std::string& constants, const std::string* features) {
    if (waits(*this, row->programs[index].name)) return false;
    auto program = programs.get(sourcesOf(row->programs[index]), (features ? *features : plan.constants) + constants);
    if (!program) {
        if (error.empty()) error = program.error().text();
        return false;
    }
    glUseProgram(*program);
    return true;
}

int wholeHeight(const ViewSettings& s) { return s.part.wholeHeight > 0 ? s.part.wholeHeight : s.height; }

glm::mat4 viewProjection(const ViewCamera& camera, int width, int height) {
    return projection(camera.fovDeg, static_cast<float>(width) / static_cast<float>(height)) * rotation(camera);
}

float pixelsPerMetre(const ViewCamera& camera, int height) {
    return static_cast<float>(height) / (2 * std::tan(glm::radians(camera.fovDeg) / 2));
}

namespace {

using States = std::map<const EffectRow*, std::unique_ptr<EffectState>>;

// What the renderer keeps of a view: the one that is asked for, or one within it.
struct RenderedView {
    FramePlan plan;
    SharedResources shared;
    Buffer globals;
    States states;
};

// What the picture's place and size say of it.
void fillView(FrameGlobals& g, const ViewCamera& camera, const ViewSettings& s, const glm::mat4& viewProj,
              int samples) {
    const float w = static_cast<float>(s.width), h = static_cast<float>(s.height);
    g.viewProj = viewProj;
    g.invViewProj = glm::inverse(g.viewProj);
    g.pixels = {w, h};
    g.pixelShare = {1 / w, 1 / h};
    g.lookShare = 1;
    g.pixelFrom = {s.part.x, s.part.y};
    g.mode = static_cast<int>(s.mode);
    g.exposure = std::exp2(camera.exposure);
    g.samples = samples;
    g.widening = std::min(1 / std::clamp(s.detail, kLeastDetail, 1.0f), 6.0f);
}

// Starts a view's frame with what all views share.
void beginShared(SharedResources& shared, SharedByViews once) {
    shared = {};
    static_cast<SharedByViews&>(shared) = std::move(once);
}

void keepOnly(States& states, const FramePlan& plan) {
    std::erase_if(states, [&](const auto& s) {
        return std::find(plan.effects.begin(), plan.effects.end(), s.first) == plan.effects.end();
    });
}

// Made where it is absent; null for an effect that keeps nothing.
EffectState* stateIn(States& states, const EffectRow* effect, std::unique_ptr<EffectState> (*make)(DrawContext&),
                     DrawContext& ctx) {
    std::unique_ptr<EffectState>& state = states[effect];
    if (!state && make) state = make(ctx);
    return state.get();
}

}  // namespace

struct Renderer::Impl {
    Gpu& gpu;
    const Tables& tables;
    Programs programs;
    MapTextures maps{gpu};
    ViewTargets targets;
    VertexArray empty;
    RenderedView main;
    std::map<const EffectRow*, std::vector<RenderedView>> within;  // by who shows them, as many as it asked for
    bool planned = false;
    FeatureSet coarsePlanned;  // of the views within
    States states;
    FrameStats stats;
    GpuTimer timer{gpu};
    PopulationCount population;
    DrawnBeside drawn;
    bool beside = false;  // as the last draw was asked for
    Sketch sketch;
    bool sketched = false;     // the last draw made a sketch
    bool programsWait = true;  // of what is planned some may not be there yet
    bool begun = false;        // a sketch of what is planned was drawn

    Impl(Gpu& g, const Tables& t) : gpu(g), tables(t) { empty = makeVertexArray("frame/empty"); }

    const Project& asDrawn(const Project& p) {
        return beside ? drawn.soon(p, tables.components) : drawn.now(p, tables.components);
    }

    void replan(const Project& project) {
        const FeatureSet features = sceneFeatures(project.registry, tables),
                         coarse = sceneFeatures(project.registry, tables, true);
        if (planned && features == main.plan.features && coarse == coarsePlanned) return;
        planned = true;
        programsWait = true, begun = false;
        coarsePlanned = coarse;
        main.plan = planFrame(features, kViewMain, tables.effects);
        std::vector<std::string> programsKept = main.plan.programs();
        std::map<const EffectRow*, std::vector<RenderedView>> kept;
        for (const Step& s : main.plan.steps)
            if (s.within) {
                std::vector<RenderedView>& views = kept[s.effect] = std::move(within[s.effect]);
                const FramePlan plan = planFrame(coarse, s.within->view, tables.effects);
                if (views.empty()) views.emplace_back();
                for (RenderedView& view : views) view.plan = plan, keepOnly(view.states, plan);
                const std::vector<std::string> more = plan.programs();
                programsKept.insert(programsKept.end(), more.begin(), more.end());
            }
        within = std::move(kept);
        keepOnly(main.states, main.plan);
        keepOnly(states, main.plan);
        programs.keepOnly(programsKept);
        main.shared = {};
    }

    DrawContext context(const Project& project, RenderedView& view, const ViewCamera& camera,
                        const ViewSettings& settings, ViewTargets& into, FrameGlobals& globals, FrameStats& counts) {
        DrawContext ctx{gpu,
                        project,
                        tables,
                        view.plan,
                        camera,
                        settings,
                        programs,
                        maps,
                        view.shared,
                        into,
                        globals,
                        counts,
                        frustumOf(globals.viewProj)};
        view.shared.ground = findGround(project);
        ctx.eye = camera.eye - view.shared.ground.origin;
        ctx.around = camera.eye;
        ctx.sketch = &sketch;
        globals.eye = ctx.eye;
        const BrushDecal& d = settings.decal;
        globals.decalAt = {d.x - ctx.eye.x, d.z - ctx.eye.z};
        globals.decalRadius = d.radius;
        globals.decalFalloff = d.falloff;
        return ctx;
    }

    void enter(DrawContext& ctx, RenderedView& view, const EffectRow* effect) {
        ctx.state = stateIn(states, effect, effect->makeState, ctx);
        ctx.seen = stateIn(view.states, effect, effect->makeView, ctx);
    }

    void run(DrawContext& ctx, RenderedView& view, const char* prefix = "") {
        for (const EffectRow* effect : ctx.plan.effects) enter(ctx, view, effect);
        bool passes = false, scene = false;
        for (const Step& step : ctx.plan.steps) {
            enter(ctx, view, step.effect);
            if (step.system) step.system->run(ctx);
            if (step.within) drawWithin(ctx, step);
            if (!step.pass) continue;
            const SlotUse& u = step.pass->uses;
            if (!std::exchange(passes, true)) beginPasses(ctx, view);
            if (((u.reads | u.writes | u.appends) & kScene).any() && !std::exchange(scene, true))
                beginScene(ctx.targets);
            runPass(ctx, *step.pass, prefix);
        }
        glUseProgram(0);  // so that none is current that is deleted: what restores it would fail
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
    }

    // The first sketch compiles nothing that it can be without, the next ones a program each; then there is none.
    void beginSketch(const ViewSettings& s) {
        const bool quick = s.background && s.detail < 1;
        sketch = {quick && programsWait, begun ? 1 : 0, {}};
        begun = begun || quick;
    }
    // What does not compile is told, and waited for no longer.
    void endSketch(bool failed) {
        sketched = sketch.on;
        programsWait = !sketch.waiting.empty() && !failed;
    }

    // Every system ticks before the first pass.
    void beginPasses(DrawContext& ctx, RenderedView& view) {
        fixState();
        glBindVertexArray(empty.id());
        writeBuffer(gpu, view.globals, "frame/globals", sizeof(FrameGlobals), &ctx.globals);
        glBindBufferBase(GL_UNIFORM_BUFFER, UBO_FRAME, view.globals.id());
    }

    void drawWithin(DrawContext& outer, const Step& step) {
        std::vector<ViewRequest> requests;
        step.within->request(outer, requests);
        if (requests.empty()) return;
        std::vector<RenderedView>& views = within[step.effect];
        while (views.size() < requests.size()) {
            RenderedView another;
            another.plan = views.front().plan;
            views.push_back(std::move(another));
        }
        for (size_t i = 0; i < requests.size(); ++i) drawRequest(outer, requests[i], views[i], step.within->prefix);
        step.within->drawn(outer);
    }
    void drawRequest(DrawContext& outer, const ViewRequest& request, RenderedView& view, const char* prefix) {
        beginShared(view.shared, outer.shared);
        FrameStats counts;
        FrameGlobals globals = outer.globals;
        fillView(globals, request.camera, request.settings, request.viewProj, request.targets->samples);
        globals.mirrored = request.mirrored ? 1 : 0;
        globals.mirrorHeight = request.cutAt;
        DrawContext ctx =
            context(outer.project, view, request.camera, request.settings, *request.targets, globals, counts);
        ctx.around = outer.around;
        glFrontFace(request.mirrored ? GL_CW : GL_CCW);
        if (request.mirrored) glEnable(GL_CLIP_DISTANCE0);
        run(ctx, view, prefix);
        glDisable(GL_CLIP_DISTANCE0);
        glFrontFace(GL_CCW);
        outer.stats.passes.insert(outer.stats.passes.end(), counts.passes.begin(), counts.passes.end());
        outer.stats.cpuCullMs += counts.cpuCullMs;
        if (outer.error.empty()) outer.error = ctx.error;
    }

    void runPass(DrawContext& ctx, const Pass& row, const char* prefix) {
        ctx.stats.passes.push_back({});
        PassStats& pass = ctx.stats.passes.back();
        pass.name = std::string(prefix) + row.name;
        ctx.pass = &pass;
        ctx.row = &row;
        const bool labelled = gpu.watched || ctx.settings.measure;
        if (labelled) glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, pass.name.c_str());
        drawInto(ctx.targets, row.moves);
        if (ctx.settings.measure) timer.begin();
        row.draw(ctx);
        if (ctx.settings.measure) {
            const GpuCost cost = timer.end();
            pass.ms = cost.ms;
            pass.vertices = cost.vertices;
            pass.fragments = cost.fragments;
        }
        if (labelled) glPopDebugGroup();
    }

    void describe(const Project& project) {
        stats.bladesVirtual = population.of(project);
        for (size_t f = 0; f < main.plan.features.size(); ++f)
            if (main.plan.features.test(f)) stats.features.push_back(featureName(static_cast<Feature>(f)));
        stats.programs = programs.names();
        stats.systems = main.plan.systemNames();
    }

    // Whether what the project has can be drawn at all.
    Status check(const Project& project) {
        for (const EffectRow* effect : main.plan.effects)
            if (effect->check)
                if (Status s = effect->check(project, population.of(project)); !s) return s;
        return {};
    }
};

Renderer::Renderer(Gpu& gpu, const Tables& tables) : impl_(std::make_unique<Impl>(gpu, tables)) {}
Renderer::~Renderer() = default;

namespace {
// The overlay shows the map that is drawn, which does not repeat where paths lie over it.
ViewSettings overDrawn(const ViewSettings& wanted, const Project& drawn, const Tables& tables) {
    ViewSettings s = wanted;
    const Terrain* terrain = firstOf<Terrain>(drawn);
    const Result<ConstFieldRef> map = findField(drawn, tables.components, s.overlay.map);
    if (terrain && map && map->row->type == FieldType::Map)
        s.overlay.tiling = static_cast<double>(shaderTiling(*terrain, mapTiling(*map)));
    return s;
}
}  // namespace

Status Renderer::draw(const Project& painted, const ViewCamera& camera, const ViewSettings& wanted) {
    Impl& r = *impl_;
    const auto start = std::chrono::steady_clock::now();
    const int refusedBefore = r.gpu.errors;
    r.beside = wanted.background;
    const Project& project = r.asDrawn(painted);
    const ViewSettings settings = &project == &painted ? wanted : overDrawn(wanted, project, r.tables);
    r.stats = {};
    r.replan(project);
    if (Status s = r.check(project); !s) return s;
    ensureTargets(r.gpu, r.targets, settings, r.main.plan);
    FrameGlobals globals{};
    fillView(globals, camera, settings,
             jitterProjection(settings) * partProjection(settings) *
                 viewProjection(camera, wholeWidth(settings), wholeHeight(settings)),
             r.targets.samples);
    beginShared(r.main.shared, std::move(r.main.shared));
    r.beginSketch(settings);
    DrawContext ctx = r.context(project, r.main, camera, settings, r.targets, globals, r.stats);
    r.maps.beginFrame();
    r.run(ctx, r.main);
    r.endSketch(!ctx.error.empty());
    r.maps.endFrame();
    if (settings.measure) glFinish();
    if (settings.measure) r.describe(project);
    r.stats.gpuBytes = static_cast<uint64_t>(r.gpu.totalBytes());
    r.stats.frameMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    if (!ctx.error.empty()) return failed(ctx.error, "the shaders/ folder must be of the same version as the program");
    if (r.gpu.errors != refusedBefore && !settings.background)  // somebody at work goes on with what there is
        return failed("OpenGL refused a part of the picture: " + r.gpu.lastError,
                      "update the graphics driver; if that does not help, report the scene and the driver's name");
    return {};
}

Status drawSettled(Renderer& renderer, const Project& project, const ViewCamera& camera, const ViewSettings& settings) {
    ViewSettings s = settings;
    s.begin = true;
    Status done = renderer.draw(project, camera, s);
    for (s.begin = false; done && renderer.addsUp();) done = renderer.draw(project, camera, s);
    return done;
}

unsigned Renderer::image() const { return impl_->targets.image.id(); }
const FrameStats& Renderer::stats() const { return impl_->stats; }
bool Renderer::addsUp() const { return impl_->stats.addsUp; }
std::vector<JobNews> Renderer::jobs() const {
    std::vector<JobNews> out;
    const auto add = [&](const States& states) {
        for (const auto& [row, state] : states)
            if (state) state->jobs(out);
    };
    add(impl_->states);
    add(impl_->main.states);
    for (const auto& [row, views] : impl_->within)
        for (const RenderedView& view : views) add(view.states);
    impl_->drawn.news(out);
    // Finished: the next draw shows more.
    if (impl_->sketched) out.push_back({"programs", 1, true});
    return out;
}

const Project& Renderer::asDrawn(const Project& project) { return impl_->asDrawn(project); }

const std::vector<LayerNote>& Renderer::layerNotes() const { return impl_->drawn.layerNotes(); }
void Renderer::finish() { glFinish(); }
std::vector<std::string> Renderer::programNames() const { return impl_->programs.names(); }

Reload Renderer::reloadPrograms() {
    Reload done = impl_->programs.reload();
    for (const std::string& message : done.failed) logError(message);
    return done;
}

std::string Renderer::explain(const Project& painted, bool json) {
    const Project& project = impl_->drawn.now(painted, impl_->tables.components);
    impl_->replan(project);
    return explainPlan({impl_->main.plan, project, layerNotes()}, impl_->tables, impl_->gpu, impl_->programs, json);
}

namespace {
template <class T>
std::vector<T> flipRows(std::vector<T> pixels, int width, int height, int channels) {
    const size_t row = static_cast<size_t>(width) * channels;
    for (int y = 0; y < height / 2; ++y)
        std::swap_ranges(pixels.begin() + static_cast<std::ptrdiff_t>(y * row),
                         pixels.begin() + static_cast<std::ptrdiff_t>((y + 1) * row),
                         pixels.begin() + static_cast<std::ptrdiff_t>((height - 1 - y) * row));
    return pixels;
}
}  // namespace

std::vector<uint8_t> Renderer::readImage() const {
    const ViewTargets& t = impl_->targets;
    std::vector<uint8_t> pixels(static_cast<size_t>(t.width) * t.height * 3);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(t.image.id(), 0, GL_RGB, GL_UNSIGNED_BYTE, static_cast<GLsizei>(pixels.size()), pixels.data());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    return flipRows(std::move(pixels), t.width, t.height, 3);
}

std::vector<float> Renderer::readLinear() const {
    const ViewTargets& t = impl_->targets;
    std::vector<float> pixels(static_cast<size_t>(t.width) * t.height * 3);
    glGetTextureImage(t.resolved.id(), 0, GL_RGB, GL_FLOAT, static_cast<GLsizei>(pixels.size() * sizeof(float)),
                      pixels.data());
    return flipRows(std::move(pixels), t.width, t.height, 3);
}

}  // namespace sward
