#include "sky/lamps.h"

#include "core/numerics.h"
#include "frame/draw_context.h"
#include "scene/lights.h"
#include "sky/exposure.h"

namespace sward {
namespace {

constexpr float kLampKlx = 45;               // of intensity 1
constexpr float kFadeSine = 0.0523f;         // directional lights fade out over the last 3 degrees above the horizon (B-4)

struct LampsState : EffectState {
    Buffer block;
};

LightGlobals directional(const Light& light, double time) {
    LightGlobals g{};
    const glm::vec3 towards = directionTo(light, time);
    const f32::LightWeights w = f32::lightWeights(towards);
    g.place = glm::vec4(towards, 0);
    g.color = glm::vec4(glm::vec3(f32::horizonFade(towards.y, kFadeSine)), 0);
    g.weights = {w.xPos, w.yPos, w.zPos, w.xNeg};
    return g;
}

LightGlobals point(const Light& light, const glm::dvec3& centre, double time, const glm::dvec3& eye) {
    LightGlobals g{};
    g.place = glm::vec4(glm::vec3(placeOf(light, centre, time) - eye), 1);
    g.color = glm::vec4(glm::vec3(1), light.attenuation);
    return g;
}

struct Lamp {
    LightGlobals globals;
    bool casts;
};

std::vector<Lamp> lampsOf(DrawContext& ctx) {
    std::vector<Lamp> lamps;
    const Entity sun = sunEntity(ctx.project.registry);
    for (const auto& [name, e] : ctx.project.entities) {
        const Light* light = ctx.project.registry.get<Light>(e);
        if (!light || e == sun || !shines(*light) || lamps.size() == MAX_LIGHTS) continue;
        const Transform* t = ctx.project.registry.get<Transform>(e);
        const bool isPoint = light->type == static_cast<int>(LightType::Point);
        LightGlobals g = isPoint ? point(*light, t ? t->position : glm::dvec3(0), ctx.settings.time, ctx.camera.eye) : directional(*light, ctx.settings.time);
        const glm::vec3 color = light->color * (light->intensity * kLampKlx * kExposure / kPi * ctx.globals.mode.y);
        g.color = glm::vec4(f32::soundLight(color) * glm::vec3(g.color), g.color.w);
        lamps.push_back({g, light->castShadows});
    }
    std::stable_partition(lamps.begin(), lamps.end(), [](const Lamp& l) { return l.casts; });
    return lamps;
}

// Bound once: nothing else uses the binding.
void runLamps(DrawContext& ctx) {
    LightsGlobals& all = ctx.shared.lights;
    all = {};
    for (const Lamp& l : lampsOf(ctx)) {
        all.lights[static_cast<size_t>(all.count.x)] = l.globals;
        all.count.x += 1;
        all.count.y += l.casts ? 1 : 0;
    }
    Buffer& block = ctx.own<LampsState>().block;
    writeBuffer(ctx.gpu, block, "sky/lamps", sizeof(all), &all);
    glBindBufferBase(GL_UNIFORM_BUFFER, UBO_LIGHTS, block.id());
}

const System kSystems[] = {{"sky/lamps", runLamps}};

}  // namespace

const EffectRow& lampsEffect() {
    static const EffectRow row{"sky/lamps", featureSet(Feature::Lamps), kSystems, {},
                               [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<LampsState>(); },
                               "lights shine beside the sun"};
    return row;
}

}  // namespace sward
