#include "frame/renderer.h"

#include <glm/gtc/matrix_transform.hpp>

#include "core/log.h"
#include "frame/draw_context.h"
#include "frame/explain.h"
#include "gpu/timer.h"
#include "scene/unique.h"
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

// With a stencil only where a pass asks for it: ground shadows do. One sample is no multisample texture: drivers may
// give that four.
void ensureTargets(Gpu& gpu, ViewTargets& t, int width, int height, int msaa, bool stencil) {
    const int samples = std::clamp(msaa, 1, std::max(gpu.maxSamples, 1));
    if (t.width == width && t.height == height && t.samples == samples && t.stencil == stencil) return;
    t = {};
    t = makeTargets(gpu, "frame/targets", {width, height, samples, stencil, 1, true});
}

// The fixed state that every pass may rely on; a pass that changes more restores it. The rest is as a context begins,
// and a user interface that draws between frames leaves it so.
void fixState() {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GEQUAL);  // the ground is lit where its own depth was drawn, the sky at depth 0, where nothing was
}
void beginScene(const ViewTargets& t) {
    glBindFramebuffer(GL_FRAMEBUFFER, t.scene.id());
    glViewport(0, 0, t.width, t.height);
    const float black[] = {0, 0, 0, 1};
    glClearNamedFramebufferfv(t.scene.id(), GL_COLOR, 0, black);
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
    const auto [width, height, samples, stencil, levels, image] = wanted;
    const GLenum depth = stencil ? GL_DEPTH32F_STENCIL8 : GL_DEPTH_COMPONENT32F;
    t.resolved = makeTexture2D(gpu, owner, GL_RGBA16F, width, height, levels);
    if (samples > 1) t.color = makeTexture2DMultisample(gpu, owner, GL_RGBA16F, width, height, samples);
    t.depth = samples > 1 ? makeTexture2DMultisample(gpu, owner, depth, width, height, samples)
                          : makeTexture2D(gpu, owner, depth, width, height);
    if (image) t.image = makeTexture2D(gpu, owner, GL_RGBA8, width, height);
    t.scene = makeFramebuffer(samples > 1 ? t.color.id() : t.resolved.id(), t.depth.id(), "frame/scene");
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

bool DrawContext::use(size_t index, const std::string& constants) {
    const ProgramRow& p = row->programs[index];
    auto program = programs.get({p.name, p.vertex, p.fragment, p.compute, p.control, p.evaluation},
                                featureConstants(p.features, plan.features) + constants);
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

struct Renderer::Impl {
    Gpu& gpu;
    const Tables& tables;
    Programs programs;
    MapTextures maps{gpu};
    ViewTargets targets;
    Buffer globalsBuffer;
    VertexArray empty;
    FramePlan plan;
    FramePlan within;  // of the views within a view
    bool planned = false;
    std::map<const EffectRow*, std::unique_ptr<EffectState>> states;
    SharedResources shared;
    FrameStats stats;
    GpuTimer timer{gpu};
    std::vector<Map> counted;  // the density maps of virtualCount
    std::vector<double> countedFactors;
    double virtualCount = 0;

    Impl(Gpu& g, const Tables& t) : gpu(g), tables(t) {
        globalsBuffer = makeBuffer(gpu, "frame/globals", sizeof(FrameGlobals), nullptr);
        empty = makeVertexArray("frame/empty");
    }

    void replan(const Project& project) {
        FramePlan next = planFrame(sceneFeatures(project.registry, tables.components), kViewMain, tables.effects);
        if (planned && next == plan) return;
        plan = std::move(next);
        planned = true;
        within = {};
        if (has(plan.features, Feature::WaterReflection))
            within = planFrame(coarseFeatures(plan.features), kViewReflection, tables.effects);
        std::erase_if(states, [&](const auto& s) {
            return std::find(plan.effects.begin(), plan.effects.end(), s.first) == plan.effects.end();
        });
        std::vector<std::string> kept = plan.programs(), others = within.programs();
        kept.insert(kept.end(), others.begin(), others.end());
        programs.keepOnly(kept);
        shared = {};
    }

    DrawContext context(const Project& project, const FramePlan& of, const ViewCamera& camera,
                        const ViewSettings& settings, ViewTargets& into, FrameGlobals& globals, FrameStats& counts) {
        DrawContext ctx{gpu,
                        project,
                        tables,
                        of,
                        camera,
                        settings,
                        programs,
                        maps,
                        shared,
                        into,
                        globals,
                        counts,
                        frustumOf(globals.viewProj)};
        shared.ground = findGround(project);
        ctx.eye = camera.eye - shared.ground.origin;
        ctx.around = camera.eye;
        globals.eye = ctx.eye;
        return ctx;
    }

    static void fillGlobals(FrameGlobals& g, const ViewCamera& camera, const ViewSettings& s, const glm::mat4& viewProj,
                            int samples) {
        g = {};
        const float w = static_cast<float>(s.width), h = static_cast<float>(s.height);
        g.viewProj = viewProj;
        g.invViewProj = glm::inverse(g.viewProj);
        g.pixels = {w, h};
        g.pixelShare = {1 / w, 1 / h};
        g.mode = static_cast<int>(s.mode);
        g.exposure = std::exp2(camera.exposure);
        g.samples = samples;
        g.widening = std::min(1 / std::clamp(s.detail, 0.01f, 1.0f), 6.0f);
    }

    EffectState* stateOf(DrawContext& ctx, const EffectRow* effect) {
        std::unique_ptr<EffectState>& state = states[effect];
        ctx.state = state.get();
        if (!state && effect->makeState) state = effect->makeState(ctx);
        return ctx.state = state.get();
    }

    void runSystems(DrawContext& ctx) {
        for (const EffectRow* effect : ctx.plan.effects) stateOf(ctx, effect);
        for (const auto& [effect, system] : ctx.plan.systems) {
            stateOf(ctx, effect);
            system->run(ctx);
        }
    }

    // Passes of stage Reflect draw views of their own, whose effects leave what they know of those in their states; the
    // systems then tick for this view.
    void drawReflections(DrawContext& ctx) {
        ctx.view = [&](const ViewRequest& request) { drawWithin(ctx, request); };
        PassStats none;
        for (const PlannedPass& p : ctx.plan.passes)
            if (p.pass->stage == Stage::Reflect) {
                ctx.pass = &none;
                ctx.row = p.pass;
                stateOf(ctx, p.effect);
                p.pass->draw(ctx);
            }
        ctx.view = {};
    }

    void drawWithin(DrawContext& outer, const ViewRequest& request) {
        FrameStats counts;
        FrameGlobals globals;
        fillGlobals(globals, request.camera, request.settings, request.viewProj, request.targets->samples);
        globals.mirrored = 1;
        globals.mirrorHeight = request.cutAt;
        DrawContext ctx =
            context(outer.project, within, request.camera, request.settings, *request.targets, globals, counts);
        ctx.around = outer.around;
        runSystems(ctx);
        glFrontFace(GL_CW);
        glEnable(GL_CLIP_DISTANCE0);
        draw(ctx, "mirrored ");
        glDisable(GL_CLIP_DISTANCE0);
        glFrontFace(GL_CCW);
        outer.stats.passes.insert(outer.stats.passes.end(), counts.passes.begin(), counts.passes.end());
        outer.stats.cpuCullMs += counts.cpuCullMs;
        if (outer.error.empty()) outer.error = ctx.error;
    }

    void runPass(DrawContext& ctx, const PlannedPass& p, const char* prefix) {
        ctx.stats.passes.push_back({});
        PassStats& pass = ctx.stats.passes.back();
        pass.name = std::string(prefix) + p.pass->name;
        ctx.pass = &pass;
        ctx.row = p.pass;
        ctx.state = states[p.effect].get();
        const bool labelled = gpu.watched || ctx.settings.measure;
        if (labelled) glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, pass.name.c_str());
        if (ctx.settings.measure) timer.begin();
        p.pass->draw(ctx);
        if (ctx.settings.measure) {
            const GpuCost cost = timer.end();
            pass.ms = cost.ms;
            pass.vertices = cost.vertices;
            pass.fragments = cost.fragments;
        }
        if (labelled) glPopDebugGroup();
    }

    // The population is recounted only when what it is a product of has changed.
    double population(const Project& project) {
        std::vector<Map> densities;
        std::vector<double> factors;
        for (const auto& [name, e] : project.entities) {
            if (const Terrain* t = project.registry.get<Terrain>(e)) factors.push_back(t->size.x * t->size.y);
            if (const GrassField* f = project.registry.get<GrassField>(e))
                for (const Species& s : f->species) {
                    densities.push_back(s.density.map);
                    factors.push_back(s.bladesPerM2);
                }
        }
        const bool same =
            factors == countedFactors && std::equal(densities.begin(), densities.end(), counted.begin(), counted.end(),
                                                    [](const Map& a, const Map& b) { return a.sameTiles(b); });
        if (!same) virtualCount = virtualBlades(project);
        counted = std::move(densities);
        countedFactors = std::move(factors);
        return virtualCount;
    }

    void describe(const Project& project) {
        stats.bladesVirtual = population(project);
        for (size_t f = 0; f < plan.features.size(); ++f)
            if (plan.features.test(f)) stats.features.push_back(featureName(static_cast<Feature>(f)));
        stats.programs = programs.names();
        stats.systems = plan.systemNames();
    }

    void draw(DrawContext& ctx, const char* prefix = "") {
        ctx.stats.passes.reserve(ctx.stats.passes.size() + ctx.plan.passes.size());
        fixState();
        glBindVertexArray(empty.id());
        glNamedBufferSubData(globalsBuffer.id(), 0, sizeof(FrameGlobals), &ctx.globals);
        glBindBufferBase(GL_UNIFORM_BUFFER, UBO_FRAME, globalsBuffer.id());
        bool begun = false;
        for (const PlannedPass& p : ctx.plan.passes) {
            if (p.pass->stage == Stage::Reflect) continue;
            if (p.pass->stage > Stage::Reflect && !std::exchange(begun, true)) beginScene(ctx.targets);
            runPass(ctx, p, prefix);
        }
        glUseProgram(0);  // so that none is current that is deleted: what restores it would fail
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
    }
};

Renderer::Renderer(Gpu& gpu, const Tables& tables) : impl_(std::make_unique<Impl>(gpu, tables)) {}
Renderer::~Renderer() = default;

Status Renderer::draw(const Project& project, const ViewCamera& camera, const ViewSettings& settings) {
    Impl& r = *impl_;
    const auto start = std::chrono::steady_clock::now();
    r.stats = {};
    r.replan(project);
    if (has(r.plan.features, Feature::GrassUnique))
        if (Status s = checkUnique(project, r.population(project)); !s) return s;
    ensureTargets(r.gpu, r.targets, settings.width, settings.height, settings.msaa,
                  has(r.plan.features, Feature::GroundShadows));
    FrameGlobals globals;
    Impl::fillGlobals(globals, camera, settings,
                      jitterProjection(settings) * partProjection(settings) *
                          viewProjection(camera, wholeWidth(settings), wholeHeight(settings)),
                      r.targets.samples);
    DrawContext ctx = r.context(project, r.plan, camera, settings, r.targets, globals, r.stats);
    const BrushDecal& d = settings.decal;
    globals.decalAt = {d.x - ctx.eye.x, d.z - ctx.eye.z};
    globals.decalRadius = d.radius;
    globals.decalFalloff = d.falloff;
    r.maps.beginFrame();
    r.drawReflections(ctx);
    r.runSystems(ctx);
    r.draw(ctx);
    r.maps.endFrame();
    if (settings.measure) glFinish();
    if (settings.measure) r.describe(project);
    r.stats.gpuBytes = static_cast<uint64_t>(r.gpu.totalBytes());
    r.stats.frameMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    if (!ctx.error.empty()) return failed(ctx.error, "the shaders/ folder must be of the same version as the program");
    return {};
}

unsigned Renderer::image() const { return impl_->targets.image.id(); }
const FrameStats& Renderer::stats() const { return impl_->stats; }
std::vector<JobNews> Renderer::jobs() const {
    std::vector<JobNews> out;
    for (const auto& [row, state] : impl_->states)
        if (state) state->jobs(out);
    return out;
}
void Renderer::finish() { glFinish(); }
std::vector<std::string> Renderer::programNames() const { return impl_->programs.names(); }

Reload Renderer::reloadPrograms() {
    Reload done = impl_->programs.reload();
    for (const std::string& message : done.failed) logError(message);
    return done;
}

std::string Renderer::explain(const Project& project, bool json) {
    impl_->replan(project);
    return explainPlan(impl_->plan, project, impl_->tables, impl_->gpu, json);
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
