#include "post/antialias.h"

#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>

#include "frame/draw_context.h"
#include "scene/antialias.h"

namespace sward {
namespace {

constexpr const char* kOwner = "post/antialias";
constexpr uint32_t kPixelPlaces = 64;  // within a pixel, until they repeat
// Each frame looks at another place of the pixel, and sees about a part of it: over all of it, their mean would be
// blurred twice.
constexpr float kLookShare = 0.35f;
constexpr float kStillFrames = 4;  // a picture at rest becomes the mean of so many times the frames of one that moves

// What a picture shows from where; two that are equal show the same.
struct SeenBefore {
    glm::dvec3 eye{0};
    glm::mat4 viewProj{0};  // not moved by a part of a pixel
    double time = 0;
    float exposure = 1;
    bool operator==(const SeenBefore&) const = default;
};
// Means so far: of which frames, and how far away what they show was.
struct History {
    Texture mean, distance;  // RGBA32F, its alpha the number of frames; R32F, metres along the eye's axis
    Framebuffer target;
};
struct AntialiasView : EffectState {
    History histories[2];
    int newest = 0;
    uint32_t frame = 0;  // since the picture was begun
    float atRest = 0;    // frames since something moved
    int width = 0, height = 0;
    SeenBefore now, before;
    const History& read() const { return histories[newest]; }
    const History& write() const { return histories[1 - newest]; }
};

History makeHistory(Gpu& gpu, int width, int height) {
    History h;
    h.mean = makeTexture2D(gpu, kOwner, GL_RGBA32F, width, height);
    h.distance = makeTexture2D(gpu, kOwner, GL_R32F, width, height);
    h.target = makeFramebuffer(h.mean.id(), 0, kOwner);
    static constexpr GLenum kBoth[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glNamedFramebufferTexture(h.target.id(), GL_COLOR_ATTACHMENT1, h.distance.id(), 0);
    glNamedFramebufferDrawBuffers(h.target.id(), 2, kBoth);
    return h;
}

// The i-th number of van der Corput's sequence: i's digits mirrored behind the point.
float mirroredDigits(uint32_t i, uint32_t base) {
    float sum = 0, digit = 1;
    for (; i > 0; i /= base) {
        digit /= static_cast<float>(base);
        sum += digit * static_cast<float>(i % base);
    }
    return sum;
}
glm::vec2 placeInPixel(uint32_t frame) {
    const uint32_t i = frame % kPixelPlaces + 1;
    return {mirroredDigits(i, 2) - 0.5f, mirroredDigits(i, 3) - 0.5f};
}

void begin(DrawContext& ctx, AntialiasView& s) {
    const ViewTargets& t = ctx.targets;
    if (s.width != t.width || s.height != t.height)
        for (History& h : s.histories) h = makeHistory(ctx.gpu, t.width, t.height);
    s.width = t.width, s.height = t.height;
    s.frame = 0;
}

// Whether the frame shows what the one before did.
bool stands(const AntialiasView& s) { return s.frame > 0 && s.now == s.before; }

// Moves the frame's samples, and its chances, to this frame's places.
void shift(DrawContext& ctx) {
    AntialiasView& s = ctx.ofView<AntialiasView>();
    const ViewTargets& t = ctx.targets;
    if (!t.motion.id()) {
        s.frame = 0;
        return;
    }
    if (s.frame == 0 || s.width != t.width || s.height != t.height || ctx.settings.begin) begin(ctx, s);
    FrameGlobals& g = ctx.globals;
    s.before = s.now;
    s.now = {ctx.eye, g.viewProj, ctx.settings.time, g.exposure};
    const glm::vec2 place = 2.0f * placeInPixel(s.frame) * g.pixelShare;
    ctx.shared.sampleShift = place;
    g.viewProj = glm::translate(glm::mat4(1), glm::vec3(place, 0)) * g.viewProj;
    g.invViewProj = glm::inverse(g.viewProj);
    g.lookShare = kLookShare;
    g.chanceShift = s.frame * 159 % 256;  // by the golden section, as near as 256ths come
}

void accumulate(DrawContext& ctx, AntialiasView& s, float frames) {
    const bool still = stands(s);
    s.atRest = still ? s.atRest + 1 : 1;
    const glm::mat4 before = s.before.viewProj * glm::translate(glm::mat4(1), glm::vec3(s.now.eye - s.before.eye));
    glUniformMatrix4fv(0, 1, GL_FALSE, &s.now.viewProj[0][0]);
    glUniformMatrix4fv(1, 1, GL_FALSE, &before[0][0]);
    // What was followed to here is as good as some frames; of a picture at rest all are its own.
    const float most = still ? std::max(s.atRest, frames / 2) : frames;
    glUniform1f(2, s.frame == 0 ? 1 : std::min(most, kStillFrames * frames));
    glUniform1i(3, still);
    const GLuint textures[] = {ctx.targets.motion.id(), s.read().mean.id(), s.read().distance.id()};
    static_assert(TEX_HISTORY == TEX_MOTION + 1 && TEX_HISTORY_DISTANCE == TEX_MOTION + 2);
    glBindTextures(TEX_MOTION, 3, textures);
    glBindFramebuffer(GL_FRAMEBUFFER, s.write().target.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    ctx.pass->draws += 1;
    ctx.pass->instances += 1;
}

void drawAddedUp(DrawContext& ctx) {
    AntialiasView& s = ctx.ofView<AntialiasView>();
    const ViewTargets& t = ctx.targets;
    if (!t.motion.id() || !ctx.use()) return;
    glBindTextureUnit(TEX_SCENE, t.resolved.id());
    glBindTextureUnit(TEX_DEPTH, t.depth.id());
    const float frames = static_cast<float>(temporalOf(ctx.project)->frames);
    accumulate(ctx, s, frames);
    glBlitNamedFramebuffer(s.write().target.id(), t.resolve.id(), 0, 0, t.width, t.height, 0, 0, t.width, t.height,
                           GL_COLOR_BUFFER_BIT, GL_NEAREST);
    s.newest = 1 - s.newest;
    s.frame += 1;
    ctx.stats.addsUp = s.atRest < frames;
}

// Before all views, so that what is shown within the main one moves as well.
const System kSystems[] = {{"post/antialias/shift", {.writes = {Slot::SampleShift}}, shift, true}};
const ProgramRow kPrograms[] = {{"post/antialias", "post/fullscreen.vert.glsl", "post/antialias.frag.glsl", nullptr}};
const Pass kPasses[] = {{"post/antialias",
                         Stage::Post,
                         kViewMain,
                         {.reads = {Slot::Resolved, Slot::SceneDepth}, .writes = {Slot::Resolved}},
                         kPrograms,
                         drawAddedUp,
                         {},
                         false,
                         false,
                         true}};

}  // namespace

const EffectRow& antialiasEffect() {
    static const EffectRow row{
        "post/antialias",
        featureSet(Feature::Temporal),
        kSystems,
        kPasses,
        nullptr,
        "one sample a pixel and frame: frames add up",
        [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<AntialiasView>(); }};
    return row;
}

}  // namespace sward
