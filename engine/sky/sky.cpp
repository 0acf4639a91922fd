#include "sky/sky.h"

#include "core/numerics.h"
#include "frame/draw_context.h"
#include "scene/lights.h"
#include "sky/exposure.h"

namespace sward {
namespace {

constexpr glm::vec3 kGroundAlbedo{0.07f, 0.10f, 0.045f};

float turbidityOf(Project& p) {
    const Sky* sky = firstOf<Sky>(p);
    return sky ? sky->turbidity : 3.0f;
}

// Without a light component the sky has its sun at the zenith.
glm::vec3 sunOf(DrawContext& ctx) {
    const Light* light = sunLight(ctx.project);
    return light ? directionTo(*light, ctx.settings.time) : glm::vec3(0, 1, 0);
}

void runSun(DrawContext& ctx) {
    const Light& light = *sunLight(ctx.project);
    FrameGlobals& g = ctx.globals;
    const glm::vec3 sun = directionTo(light, ctx.settings.time);
    const float up = sun.y > 0 ? 1.0f : 0.0f;
    const glm::vec3 irradiance = f32::sunIlluminance(sun, turbidityOf(ctx.project)) * light.color * (light.intensity * kExposure / kPi * g.mode.y * up);
    g.sunDirection = glm::vec4(sun, up);
    g.sunLight = glm::vec4(f32::soundLight(irradiance), light.castShadows ? 1 : 0);
    g.groundLight += glm::vec4(irradiance * std::max(sun.y, 0.0f) * kGroundAlbedo, 0);
}

// The sky's part, integrated anew only when sun or turbidity change.
struct SkyState : EffectState {
    glm::vec3 sun{2};  // no direction: nothing integrated yet
    float turbidity = 0;
    glm::vec3 level{0}, horizon[3]{};
};

// Irradiance of the sky on level ground, divided by pi: midpoint rule over 12 elevations and 24 azimuths.
glm::vec3 skyOnGround(const glm::vec3& sun, float turbidity) {
    constexpr int kRows = 12, kColumns = 24;
    glm::vec3 sum(0);
    for (int r = 0; r < kRows; ++r)
        for (int c = 0; c < kColumns; ++c) {
            const float y = (r + 0.5f) / kRows, h = std::sqrt(1 - y * y), a = 2 * kPi * (c + 0.5f) / kColumns;
            sum += f32::skyRadiance(glm::vec3(h * std::cos(a), y, h * std::sin(a)), sun, turbidity) * y;
        }
    return sum * (2.0f / (kRows * kColumns));  // solid angle 2 pi / n each, divided by pi
}

void integrateSky(SkyState& s, const glm::vec3& sun, float turbidity) {
    if (s.sun == sun && s.turbidity == turbidity) return;
    s.sun = sun;
    s.turbidity = turbidity;
    s.level = skyOnGround(sun, turbidity);
    const glm::vec2 flat(sun.x, sun.z);
    const glm::vec2 h = glm::length(flat) > 1e-4f ? glm::normalize(flat) : glm::vec2(1, 0);
    const glm::vec2 ways[3] = {h, {-h.y, h.x}, -h};
    for (int i = 0; i < 3; ++i) s.horizon[i] = f32::skyRadiance(glm::normalize(glm::vec3(ways[i].x, 0.02f, ways[i].y)), sun, turbidity);
}

// A camera's white balance: three quarters of the way to making white ground look white. Luminance is kept.
glm::vec3 whiteBalance(const glm::vec3& onGround) {
    const float luminance = glm::dot(onGround, glm::vec3(0.2126f, 0.7152f, 0.0722f));
    if (!(luminance > 0)) return glm::vec3(1);
    return glm::pow(glm::vec3(luminance) / glm::max(onGround, glm::vec3(1e-4f * luminance)), glm::vec3(0.75f));
}

void runSky(DrawContext& ctx) {
    SkyState& s = ctx.own<SkyState>();
    FrameGlobals& g = ctx.globals;
    const glm::vec3 sun = sunOf(ctx);
    const float turbidity = turbidityOf(ctx.project);
    integrateSky(s, sun, turbidity);
    const float scale = firstOf<Sky>(ctx.project)->intensity * kExposure * g.mode.y;
    const glm::vec3 balance = whiteBalance(s.level * scale + glm::vec3(g.sunLight) * std::max(g.sunDirection.y, 0.0f));
    const glm::vec3 gain = balance * scale;
    g.skySun = glm::vec4(sun, turbidity);
    g.skyGain = glm::vec4(gain, 0);
    g.sunLight *= glm::vec4(balance, 1);
    g.skyLight = glm::vec4(s.level * gain, 0);
    g.groundLight = glm::vec4(glm::vec3(g.groundLight) * balance + s.level * gain * kGroundAlbedo, 0);
    for (int i = 0; i < 3; ++i) g.horizon[i] = glm::vec4(s.horizon[i] * gain, 0);
}

void runHaze(DrawContext& ctx) {
    // Koschmieder: contrast falls to 2% at the visibility, exp(-k d) = 0.02.
    ctx.globals.haze.x = 3.912f / std::max(firstOf<Fog>(ctx.project)->visibility, 0.1f);
}

void drawDome(DrawContext& ctx) {
    if (!ctx.use()) return;
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_GEQUAL);  // the dome lies at depth 0, where nothing was drawn
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_TRUE);
    ctx.pass->draws += 1;
    ctx.pass->instances += 1;
}

const System kSunSystems[] = {{"sky/sun", runSun}};
const System kSkySystems[] = {{"sky/ambient", runSky}};
const System kHazeSystems[] = {{"sky/haze", runHaze}};
const ProgramRow kDomePrograms[] = {{"sky/dome", "sky/dome.vert.glsl", "sky/dome.frag.glsl", nullptr, featureSet(Feature::Sun, Feature::Fog)}};
const Pass kDomePasses[] = {{"sky/dome", Stage::Opaque, kViewMain | kViewReflection | kViewCompare, kSceneDepth, kSceneColor, kDomePrograms, drawDome}};

}  // namespace

const EffectRow& sunEffect() {
    static const EffectRow row{"sky/sun", featureSet(Feature::Sun), kSunSystems, {}, nullptr, "a light shines from one direction"};
    return row;
}
const EffectRow& skyEffect() {
    static const EffectRow row{"sky/dome", featureSet(Feature::Sky), kSkySystems, kDomePasses,
                               [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<SkyState>(); },
                               "the sky lights the scene and is seen where nothing stands before it"};
    return row;
}
const EffectRow& hazeEffect() {
    static const EffectRow row{"sky/haze", featureSet(Feature::Fog), kHazeSystems, {}, nullptr, "what is far fades into the horizon"};
    return row;
}

}  // namespace sward
