#include "sky/daylight.h"

#include <algorithm>
#include <functional>

#include "core/luminance.h"
#include "core/numerics.h"
#include "scene/project.h"
#include "sky/air_tables.h"
#include "sky/exposure.h"
#include "world/lights.h"

namespace sward {
namespace {

constexpr glm::vec3 kGroundAlbedo{0.07f, 0.10f, 0.045f};
constexpr float kLampKlx = 45;        // of intensity 1
constexpr float kFadeSine = 0.0523f;  // directional lights fade out over the last 3 degrees above the horizon (B-4)

float turbidityOf(const Project& p) {
    const Sky* sky = firstOf<Sky>(p);
    return sky ? sky->turbidity : 3.0f;
}

bool hasAir(const Project& p) {
    const Sky* sky = firstOf<Sky>(p);
    return sky && sky->intensity > 0 && sky->model == SkyModel::Atmosphere;
}

// Without a light component the sky has its sun at the zenith.
glm::vec3 sunOf(const Project& p, double seconds) {
    const Light* light = sunLight(p);
    return light ? directionTo(*light, seconds) : glm::vec3(0, 1, 0);
}

constexpr float kLeastSine = 0.15f;  // of the sun, for which the glow grows

using SkySeen = std::function<glm::vec3(const glm::vec3& towards)>;

// Irradiance of the sky on level ground, divided by pi, and what falls on upright leaves all around, of which the more
// is hidden by others the lower it comes from (by the sine's root, as paths up from a lawn's leaves are spread: their
// mean sine is 0.5), and on a wall that looks along `wall` (unit, level): midpoint rule over 12 elevations and 24
// azimuths.
struct SkyFalls {
    glm::vec3 onGround{0}, onLeaves{0}, onWall{0};
};
SkyFalls skyFalls(const SkySeen& seen, const glm::vec2& wall) {
    constexpr int kRows = 12, kColumns = 24;
    SkyFalls sum;
    for (int r = 0; r < kRows; ++r)
        for (int c = 0; c < kColumns; ++c) {
            const float y = (r + 0.5f) / kRows, h = std::sqrt(1 - y * y), a = 2 * kPi * (c + 0.5f) / kColumns;
            const glm::vec2 level = h * glm::vec2(std::cos(a), std::sin(a));
            const glm::vec3 radiance = seen(glm::vec3(level.x, y, level.y));
            sum.onGround += radiance * y;
            sum.onLeaves += radiance * (h * std::sqrt(y));
            sum.onWall += radiance * std::max(glm::dot(level, wall), 0.0f);
        }
    const float each = 2.0f / (kRows * kColumns);  // solid angle 2 pi / n, divided by pi
    return {sum.onGround * each, sum.onLeaves * each, sum.onWall * each};
}
// Of a sky whose radiance is 1.
const SkyFalls& evenFalls() {
    static const SkyFalls falls = skyFalls([](const glm::vec3&) { return glm::vec3(1); }, {1, 0});
    return falls;
}
glm::vec3 tiltOf(const SkyFalls& sky) {
    static const float even = evenFalls().onLeaves.x,
                       tilted =
                           skyFalls([](const glm::vec3&d) { return glm::vec3(skyTilted(d.y)); }, {1, 0}).onLeaves.x;
    const glm::vec3 leaves = sky.onLeaves / glm::max(sky.onGround, glm::vec3(1e-9f));
    return glm::clamp((leaves - even) / tilted, -1.5f, 3.0f);
}

// A wall that looks away from the sun has the even sky's light alone: what level ground has more is the glow's.
glm::vec3 glowOf(const SkyFalls& sky, float sunsSine) {
    const glm::vec3 even = sky.onWall * (evenFalls().onGround.x / evenFalls().onWall.x);
    return sunsSine > 0 ? glm::max(sky.onGround - even, glm::vec3(0)) / std::max(sunsSine, kLeastSine) : glm::vec3(0);
}

// The sky at the horizon as horizonLight has it: a polynomial through the five points of Chebyshev's between the least
// chord to the sun and the greatest, by its series.
void fitHorizon(SkySums& s, const glm::vec3& sun, const SkySeen& seenIn) {
    const float r = glm::length(glm::vec2(sun.x, sun.z)), least = std::sqrt(2 - 2 * r), most = std::sqrt(2 + 2 * r);
    const glm::vec2 h = r > 1e-4f ? glm::vec2(sun.x, sun.z) / r : glm::vec2(1, 0);
    const float middle = 0.5f * (least + most), half = std::max(0.5f * (most - least), 1e-4f);
    glm::vec3 a[5]{};
    for (int i = 0; i < 5; ++i) {
        const float node = static_cast<float>(i) * kPi / 4, chord = middle + half * std::cos(node);
        const float c = std::clamp((1 - 0.5f * chord * chord) / std::max(r, 1e-4f), -1.0f, 1.0f),
                    n = std::sqrt(1 - c * c);
        const glm::vec3 seen = seenIn(glm::vec3(h.x * c - h.y * n, 0, h.y * c + h.x * n));
        for (int k = 0; k < 5; ++k)
            a[k] += seen *
                    (std::cos(static_cast<float>(k) * node) * (i % 4 == 0 ? 0.25f : 0.5f) * (k % 4 == 0 ? 0.5f : 1.0f));
    }
    const glm::vec3 powers[] = {a[0] - a[2] + a[4], a[1] - 3.0f * a[3], 2.0f * a[2] - 8.0f * a[4], 4.0f * a[3],
                                8.0f * a[4]};
    std::copy(std::begin(powers), std::end(powers), s.horizon);
    s.horizonMiddle = middle, s.horizonScale = 1 / half;
}

void integrateSky(SkySums& s, const glm::vec3& sun, float turbidity, const AirTables* air) {
    const unsigned changes = air ? air->changes : 0;
    if (s.sun == sun && s.turbidity == turbidity && s.airChanges == changes) return;
    s.sun = sun;
    s.turbidity = turbidity;
    s.airChanges = changes;
    const SkySeen seen = [&](const glm::vec3& towards) {
        return air ? skyOf(*air, sun, towards) : f32::skyRadiance(towards, sun, turbidity);
    };
    const float across = glm::length(glm::vec2(sun.x, sun.z));
    const SkyFalls falls = skyFalls(seen, across > 1e-4f ? -glm::vec2(sun.x, sun.z) / across : glm::vec2(1, 0));
    s.level = falls.onGround, s.tilt = tiltOf(falls), s.glow = glowOf(falls, sun.y);
    fitHorizon(s, sun, seen);
}

// A camera's white balance: as far (a share) of the way to making white ground look white. Luminance is kept.
glm::vec3 whiteBalance(const glm::vec3& onGround, float share) {
    const float bright = luminance(onGround);
    if (!(bright > 0)) return glm::vec3(1);
    return glm::pow(glm::vec3(bright) / glm::max(onGround, glm::vec3(1e-4f * bright)), glm::vec3(share));
}
// Three quarters; in air, where the sun sinks through ten degrees, down to what keeps the blue hour blue.
float balanceShare(bool inAir, float sunUp) {
    return inAir ? glm::mix(0.3f, 0.75f, glm::smoothstep(0.0f, 0.17f, sunUp)) : 0.75f;
}

LightGlobals directional(const glm::dvec3& towards) {
    LightGlobals g{};
    g.place = towards;
    g.color = glm::vec3(f32::horizonFade(g.place.y, kFadeSine));
    return g;
}

LightGlobals point(const Light& light, const glm::dvec3& at, const glm::dvec3& eye) {
    LightGlobals g{};
    g.place = glm::vec3(at - eye);
    g.isPoint = 1;
    g.color = glm::vec3(1);
    g.beta = light.attenuation;
    return g;
}

struct Lamp {
    const Light* light;
    glm::dvec3 place;  // in the world; of a directional light: unit vector towards it
};
// Those that shine, at most MAX_LIGHTS, those that cast shadows first.
std::vector<Lamp> lampsOf(const Project& project, double seconds) {
    std::vector<Lamp> lamps;
    const Entity sun = sunEntity(project.registry);
    for (const auto& [name, e] : project.entities) {
        const Light* light = project.registry.get<Light>(e);
        if (!light || e == sun || !shines(*light) || lamps.size() == MAX_LIGHTS) continue;
        const Transform* t = project.registry.get<Transform>(e);
        const bool isPoint = light->type == LightType::Point;
        lamps.push_back({light, isPoint ? placeOf(*light, t ? t->position : glm::dvec3(0), seconds)
                                        : glm::dvec3(directionTo(*light, seconds))});
    }
    std::stable_partition(lamps.begin(), lamps.end(), [](const Lamp& l) { return l.light->castShadows; });
    return lamps;
}

}  // namespace

glm::vec3 sunKlx(const Project& p, const glm::vec3& sun) {
    return hasAir(p) ? f32::sunThroughAir(sun, turbidityOf(p)) : f32::sunIlluminance(sun, turbidityOf(p));
}

void addSun(FrameGlobals& g, const Project& p, double seconds) {
    const Light& light = *sunLight(p);
    const glm::vec3 sun = directionTo(light, seconds);
    const float up = sun.y > 0 ? 1.0f : 0.0f;
    const glm::vec3 irradiance = sunKlx(p, sun) * light.color * (light.intensity * kExposure / kPi * g.exposure * up);
    g.sunDirection = sun;
    g.sunIsUp = up;
    g.sunLight = f32::soundLight(irradiance);
    g.sunCasts = light.castShadows ? 1.0f : 0.0f;
    g.groundLight += irradiance * std::max(sun.y, 0.0f) * kGroundAlbedo;
}

void addAir(FrameGlobals& g, const Project& p, double seconds, AirTables& tables) {
    updateAir(tables, turbidityOf(p), sunOf(p, seconds).y, g.haze);
    g.haze += airExtinction(turbidityOf(p));
}

void addSky(FrameGlobals& g, const Project& p, double seconds, SkySums& s, const AirTables* air) {
    const glm::vec3 sun = sunOf(p, seconds);
    const float turbidity = firstOf<Sky>(p)->model == SkyModel::Uniform ? 0 : turbidityOf(p);
    integrateSky(s, sun, turbidity, air);
    const float scale = firstOf<Sky>(p)->intensity * kExposure * g.exposure;
    const glm::vec3 balance =
        whiteBalance(s.level * scale + g.sunLight * std::max(g.sunDirection.y, 0.0f), balanceShare(air, sun.y));
    const glm::vec3 gain = balance * scale;
    g.skySun = sun;
    g.turbidity = turbidity;
    g.skyGain = gain;
    g.sunLight *= balance;
    g.skyLight = s.level * gain, g.skyGlow = s.glow * gain;
    g.groundLight = g.groundLight * balance + s.level * gain * kGroundAlbedo;
    for (int i = 0; i < 5; ++i) g.horizon[i] = glm::vec4(s.horizon[i] * gain, 0);
    g.horizonMiddle = s.horizonMiddle, g.horizonScale = s.horizonScale;
}

void addHaze(FrameGlobals& g, const Project& p) {
    // Koschmieder: contrast falls to 2% at the visibility, exp(-k d) = 0.02.
    g.haze = 3.912f / std::max(firstOf<Fog>(p)->visibility, 0.1f);
}

LightsGlobals lampsAround(const Project& project, const glm::dvec3& eye, double seconds, float exposure) {
    LightsGlobals all{};
    for (const auto& [light, place] : lampsOf(project, seconds)) {
        LightGlobals g = light->type == LightType::Point ? point(*light, place, eye) : directional(place);
        const glm::vec3 color = light->color * (light->intensity * kLampKlx * kExposure / kPi * exposure);
        g.color = f32::soundLight(color) * g.color;
        all.lights[all.count++] = g;
        all.casting += light->castShadows ? 1 : 0;
    }
    return all;
}

std::vector<glm::dvec3> lampPlaces(const Project& project, double seconds) {
    std::vector<glm::dvec3> places;
    for (const Lamp& l : lampsOf(project, seconds)) places.push_back(l.place);
    return places;
}

}  // namespace sward
