#include "objects/shadow.h"

#include "frame/draw_context.h"
#include "shared/objects.h"

namespace sward {
namespace {

constexpr const char* kOwner = "objects/shadow";
constexpr int kSide = 2048;                                // texels of a map
constexpr double kReach[SHADOW_CASCADES] = {14, 60, 256};  // metres from the eye
constexpr double kSlack = 0.1;           // share of the reach that the eye may move before a map is drawn anew
constexpr double kHalf = 1.02 + kSlack;  // half a map's side, as a share of the reach: and room for taps

struct ShadowMap {
    Framebuffer target;
    glm::dvec3 centre{0};   // in the world
    uint64_t drawn = 0;     // hash of what it shows; 0: nothing yet
    bool mirrored = false;  // drawn for what water mirrors, whose places round otherwise
};
struct ShadowState : EffectState {
    GlName<TextureKind> maps;  // an array of SHADOW_CASCADES
    Tally tally;
    ShadowMap map[SHADOW_CASCADES];
    glm::vec3 right{0}, up{0}, sun{0};  // the sun's axes
    glm::dvec3 origin{0};               // of the terrain in the world: texels lie at the same places of it
};
// From a view's eye to the maps, which all views share.
struct ShadowView : EffectState {
    Buffer globals;
    ShadowGlobals values;
};

void makeMaps(Gpu& gpu, ShadowState& s) {
    GLuint id = 0;
    glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &id);
    glTextureStorage3D(id, 1, GL_DEPTH_COMPONENT32F, kSide, kSide, SHADOW_CASCADES);
    throwWithoutMemory();
    glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(id, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTextureParameteri(id, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTextureParameteri(id, GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);  // depth is reversed: the nearest to the sun is 1
    glObjectLabel(GL_TEXTURE, id, -1, kOwner);
    s.maps = GlName<TextureKind>(id);
    s.tally = Tally(gpu, kOwner, size_t(4) * kSide * kSide * SHADOW_CASCADES);
}

std::unique_ptr<EffectState> makeState(DrawContext& ctx) {
    auto s = std::make_unique<ShadowState>();
    makeMaps(ctx.gpu, *s);
    for (int i = 0; i < SHADOW_CASCADES; ++i) {
        GLuint id = 0;
        glCreateFramebuffers(1, &id);
        glNamedFramebufferTextureLayer(id, GL_DEPTH_ATTACHMENT, s->maps.id(), 0, i);
        glNamedFramebufferDrawBuffer(id, GL_NONE);
        glObjectLabel(GL_FRAMEBUFFER, id, -1, kOwner);
        s->map[i].target = Framebuffer(id);
    }
    return s;
}
std::unique_ptr<EffectState> makeView(DrawContext& ctx) {
    auto s = std::make_unique<ShadowView>();
    s->globals = makeBuffer(ctx.gpu, kOwner, sizeof(ShadowGlobals), nullptr);
    return s;
}

// Axes across the sun's rays: from nothing but its direction, so that they stay while the eye moves.
void setAxes(ShadowState& s, const glm::vec3& sun) {
    s.sun = sun;
    s.right = glm::normalize(glm::cross(std::abs(sun.y) > 0.99f ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0), sun));
    s.up = glm::cross(sun, s.right);
}

// From eye-relative positions to a map around `centre`, its texels at the same places of the terrain whatever the
// centre, and wherever the terrain stands.
glm::mat4 toMap(const ShadowState& s, const glm::dvec3& centre, const glm::dvec3& eye, double half) {
    const double texel = 2 * half / kSide;
    const auto middle = [&](const glm::dvec3& axis) {
        return std::round(glm::dot(centre - s.origin, axis) / texel) * texel - glm::dot(eye - s.origin, axis);
    };
    const double scale = 0.5 / half;
    glm::mat4 m(0);
    for (int c = 0; c < 3; ++c) m[c] = glm::vec4(s.right[c], s.up[c], s.sun[c], 0) * static_cast<float>(scale);
    m[3] = glm::vec4(glm::dvec4(0.5 - middle(s.right) * scale, 0.5 - middle(s.up) * scale,
                                0.5 - glm::dot(centre - eye, glm::dvec3(s.sun)) * scale, 1));
    return m;
}

// around: what is shaded; both in the world.
void aimMap(ShadowState& s, ShadowGlobals& values, int i, const glm::dvec3& around, const glm::dvec3& eye) {
    ShadowMap& map = s.map[i];
    if (map.drawn == 0 || glm::distance(map.centre, around) > kSlack * kReach[i]) {
        map.centre = around;
        map.drawn = 0;
    }
    const double half = kReach[i] * kHalf;
    values.cascades[i].toMap = toMap(s, map.centre, eye, half);
    values.cascades[i].reach = static_cast<float>(kReach[i]);
    values.cascades[i].texel = static_cast<float>(2 * half / kSide);
}

void aim(DrawContext& ctx) {
    ShadowState& s = ctx.own<ShadowState>();
    ShadowView& view = ctx.ofView<ShadowView>();
    const glm::vec3 sun = ctx.globals.sunDirection;
    if (ctx.globals.sunIsUp > 0) {
        if (s.sun != sun || s.origin != ctx.shared.ground.origin) {
            setAxes(s, sun);
            s.origin = ctx.shared.ground.origin;
            for (ShadowMap& map : s.map) map.drawn = 0;
        }
        for (int i = 0; i < SHADOW_CASCADES; ++i) aimMap(s, view.values, i, ctx.around, ctx.camera.eye);
        view.values.texelShare = 1.0f / kSide;
        glNamedBufferSubData(view.globals.id(), 0, sizeof(ShadowGlobals), &view.values);
    }
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_SHADOW, view.globals.id());
    glBindTextureUnit(TEX_SHADOW, s.maps.id());
}

// Whether something at the ball may shade what lies within reach of the eye.
bool reaches(const ShadowState& s, const ShadowCaster& c, float reach) {
    const glm::vec2 across(glm::dot(c.centre, s.right), glm::dot(c.centre, s.up));
    return glm::length(across) < reach * 1.5f + c.radius && glm::dot(c.centre, s.sun) > -reach * 1.5f - c.radius;
}

void drawMap(DrawContext& ctx, const ShadowState& s, int map) {
    const float farthest = 0;
    const GLuint target = s.map[map].target.id();
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glClearNamedFramebufferfv(target, GL_DEPTH, 0, &farthest);
    glUniform1i(1, map);
    for (const ShadowCaster& c : ctx.shared.casters) {
        if (!reaches(s, c, static_cast<float>(kReach[map]))) continue;
        glUniform1f(0, c.image ? c.cutoff : 0.0f);
        if (c.image) glBindTextureUnit(TEX_OBJECT, c.image);
        glBindVertexArray(c.vertexArray);
        glDrawElementsInstancedBaseInstance(GL_TRIANGLES, static_cast<GLsizei>(c.indices), GL_UNSIGNED_INT,
                                            reinterpret_cast<const void*>(size_t(c.firstIndex) * 4), c.instances,
                                            c.instance);
        ctx.pass->draws += 1;
        ctx.pass->instances += static_cast<uint64_t>(c.instances);
    }
}

void draw(DrawContext& ctx) {
    ShadowState& s = ctx.own<ShadowState>();
    const uint64_t wanted = ctx.shared.castersHash | 1;
    // The mirror takes what the main view drew; the main view draws its own, so that it is the same without a mirror.
    const bool mirrored = ctx.globals.mirrored != 0;
    const auto stale = [&](const ShadowMap& map) { return map.drawn != wanted || (map.mirrored && !mirrored); };
    if (ctx.globals.sunIsUp <= 0 || std::none_of(std::begin(s.map), std::end(s.map), stale) || !ctx.use()) return;
    glViewport(0, 0, kSide, kSide);
    glEnable(GL_DEPTH_CLAMP);  // what stands nearer to the sun than the map still shades
    for (int i = 0; i < SHADOW_CASCADES; ++i) {
        if (!stale(s.map[i])) continue;
        drawMap(ctx, s, i);
        s.map[i].drawn = wanted;
        s.map[i].mirrored = mirrored;
    }
    glDisable(GL_DEPTH_CLAMP);
}

const System kSystems[] = {{"objects/aim", {.reads = {Slot::Sun, Slot::Ground}}, aim}};
const ProgramRow kPrograms[] = {{"objects/shadow", "objects/shadow.vert.glsl", "objects/shadow.frag.glsl", nullptr}};
const Pass kPasses[] = {{"objects/shadow",
                         Stage::Shadow,
                         kViewMain | kViewReflection,
                         {.reads = {Slot::Casters}, .appends = {Slot::Shadows}},
                         kPrograms,
                         draw}};

}  // namespace

const EffectRow& shadowEffect() {
    static const EffectRow row{"objects/shadow", featureSet(Feature::ObjectShadows),    kSystems, kPasses,
                               makeState,        "objects shade what lies behind them", makeView};
    return row;
}

}  // namespace sward
