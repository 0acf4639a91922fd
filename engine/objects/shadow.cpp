#include "objects/shadow.h"

#include "core/hash.h"
#include "frame/draw_context.h"

namespace sward {
namespace {

constexpr const char* kOwner = "objects/shadow";
constexpr int kSide = 2048;                                          // texels of a map
constexpr double kReach[SHADOW_CASCADES] = {14, 60, 256};            // metres from the eye
constexpr double kMargin = 1.02;                                     // for taps and snapping

struct ShadowState : EffectState {
    GlName<TextureKind> maps;  // an array of SHADOW_CASCADES
    Tally tally;
    Framebuffer targets[SHADOW_CASCADES];
    Buffer globals;
    ShadowGlobals values;
    glm::vec3 right{0}, up{0}, sun{0};  // the sun's axes
    uint64_t drawn = 0;                 // hash of what the maps show; 0: nothing
};

void makeMaps(Gpu& gpu, ShadowState& s) {
    GLuint id = 0;
    glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &id);
    glTextureStorage3D(id, 1, GL_DEPTH_COMPONENT32F, kSide, kSide, SHADOW_CASCADES);
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
        s->targets[i] = Framebuffer(id);
    }
    s->globals = makeBuffer(ctx.gpu, kOwner, sizeof(ShadowGlobals), nullptr);
    return s;
}

// Axes across the sun's rays: from nothing but its direction, so that they stay while the eye moves.
void setAxes(ShadowState& s, const glm::vec3& sun) {
    s.sun = sun;
    s.right = glm::normalize(glm::cross(std::abs(sun.y) > 0.99f ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0), sun));
    s.up = glm::cross(sun, s.right);
}

// From eye-relative positions to the map whose middle is the texel nearest to the eye.
glm::mat4 toMap(const ShadowState& s, const glm::dvec3& eye, double half) {
    const double texel = 2 * half / kSide;
    const auto offset = [&](const glm::dvec3& axis) {
        const double e = glm::dot(eye, axis);
        return std::round(e / texel) * texel - e;
    };
    const float scale = static_cast<float>(0.5 / half);
    glm::mat4 m(0);
    for (int c = 0; c < 3; ++c) m[c] = glm::vec4(s.right[c], s.up[c], s.sun[c], 0) * scale;
    m[3] = glm::vec4(0.5f - static_cast<float>(offset(s.right)) * scale, 0.5f - static_cast<float>(offset(s.up)) * scale, 0.5f, 1);
    return m;
}

void aim(DrawContext& ctx) {
    ShadowState& s = ctx.own<ShadowState>();
    if (ctx.globals.sunDirection.w > 0) {
        setAxes(s, glm::vec3(ctx.globals.sunDirection));
        for (int i = 0; i < SHADOW_CASCADES; ++i) {
            s.values.toMap[i] = toMap(s, ctx.camera.eye, kReach[i] * kMargin);
            s.values.reach[i] = static_cast<float>(kReach[i]);
            s.values.texel[i] = static_cast<float>(2 * kReach[i] * kMargin / kSide);
        }
        s.values.texel.w = 1.0f / kSide;
        glNamedBufferSubData(s.globals.id(), 0, sizeof(ShadowGlobals), &s.values);
    }
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_SHADOW, s.globals.id());
    glBindTextureUnit(TEX_SHADOW, s.maps.id());
}

// Whether something at the ball may shade what lies within reach of the eye.
bool reaches(const ShadowState& s, const ShadowCaster& c, float reach) {
    const glm::vec2 across(glm::dot(c.centre, s.right), glm::dot(c.centre, s.up));
    return glm::length(across) < reach * 1.5f + c.radius && glm::dot(c.centre, s.sun) > -reach * 1.5f - c.radius;
}

void drawMap(DrawContext& ctx, const ShadowState& s, int map) {
    const float farthest = 0;
    glBindFramebuffer(GL_FRAMEBUFFER, s.targets[map].id());
    glClearNamedFramebufferfv(s.targets[map].id(), GL_DEPTH, 0, &farthest);
    glUniform1i(1, map);
    for (const ShadowCaster& c : ctx.shared.casters) {
        if (!reaches(s, c, static_cast<float>(kReach[map]))) continue;
        glUniform1f(0, c.image ? c.cutoff : 0.0f);
        if (c.image) glBindTextureUnit(TEX_OBJECT, c.image);
        glBindVertexArray(c.vertexArray);
        glDrawElementsInstancedBaseInstance(GL_TRIANGLES, static_cast<GLsizei>(c.indices), GL_UNSIGNED_INT, reinterpret_cast<const void*>(size_t(c.firstIndex) * 4), 1, c.instance);
        ctx.pass->draws += 1;
        ctx.pass->instances += 1;
    }
}

uint64_t hashOf(const DrawContext& ctx) {
    const double parts[] = {ctx.camera.eye.x, ctx.camera.eye.y, ctx.camera.eye.z, ctx.globals.sunDirection.x, ctx.globals.sunDirection.y, ctx.globals.sunDirection.z};
    return hashBytes(parts, sizeof(parts)) ^ ctx.shared.castersHash;
}

void draw(DrawContext& ctx) {
    ShadowState& s = ctx.own<ShadowState>();
    const uint64_t wanted = hashOf(ctx);
    if (ctx.globals.sunDirection.w <= 0 || s.drawn == wanted || !ctx.use()) return;
    s.drawn = wanted;
    glViewport(0, 0, kSide, kSide);
    glEnable(GL_DEPTH_CLAMP);  // what stands nearer to the sun than the map still shades
    for (int i = 0; i < SHADOW_CASCADES; ++i) drawMap(ctx, s, i);
    glDisable(GL_DEPTH_CLAMP);
    glBindFramebuffer(GL_FRAMEBUFFER, ctx.targets.scene.id());
    glViewport(0, 0, ctx.targets.width, ctx.targets.height);
}

const System kSystems[] = {{"objects/aim", aim}};
const ProgramRow kPrograms[] = {{"objects/shadow", "objects/shadow.vert.glsl", "objects/shadow.frag.glsl", nullptr, {}}};
const Pass kPasses[] = {{"objects/shadow", Stage::Shadow, kViewMain | kViewReflection | kViewCompare, 0, 0, kPrograms, draw}};

}  // namespace

const EffectRow& shadowEffect() {
    static const EffectRow row{"objects/shadow", featureSet(Feature::ObjectShadows), kSystems, kPasses, makeState, "objects shade what lies behind them"};
    return row;
}

}  // namespace sward
