#include "world/water.h"

#include <algorithm>
#include <compare>

#include "core/numerics.h"

namespace sward {
namespace {

constexpr double kShortest = 1.0 / 20;  // of the ripples, as a share of the longest
constexpr double kSpreadDeg = 70;       // of their ways about the wind
constexpr double kGravity = 9.81;
constexpr double kWidestPlace = 1e9;  // metres: wider than any terrain, and its square is still a float
constexpr float kMirroredAt = 10;     // metres from the surface: what ripples move in the mirror is taken to be so far
constexpr glm::vec3 kPureWater{0.264f, 0.0565f, 0.0101f};  // 1/m

// Its turns a metre and phase at the eye; its share of the slopes is every wave's.
WaterWave waveOf(int i, const Water& water, const Wind& wind, const glm::dvec2& eye, double seconds, float slope) {
    const double share = static_cast<double>(i) / (WATER_WAVES - 1);
    const double length = static_cast<double>(water.rippleSize) * std::pow(kShortest, share);
    const double off = (glm::fract(0.5 + i * 0.6180339887498949) * 2 - 1) * kSpreadDeg;
    const double angle = glm::radians(static_cast<double>(wind.azimuthDeg) + off);
    const glm::dvec2 k = glm::dvec2(std::sin(angle), -std::cos(angle)) / length;
    const double hertz = std::sqrt(kGravity / (2 * f64::kPi * length));
    const double phase = glm::dot(k, eye) - hertz * seconds + i * 0.7548776662466927;
    return {k, static_cast<float>(glm::fract(phase)), slope};
}

}  // namespace

std::vector<WaterPlace> watersOf(const Project& p, const Ground& ground) {
    std::vector<WaterPlace> places;
    p.registry.each<Water>([&](Entity e, const Water& water) {
        WaterPlace& place = places.emplace_back();
        place.water = &water;
        if (!(water.radius > 0)) return;
        const Transform* t = p.registry.get<Transform>(e);
        const glm::dvec3 at = (t ? t->position : glm::dvec3(0)) - ground.origin;
        place.middle = {at.x, at.z};
        place.radius = static_cast<double>(water.radius);
    });
    std::stable_sort(places.begin(), places.end(), [](const WaterPlace& a, const WaterPlace& b) {
        return std::strong_order(a.water->level, b.water->level) < 0;
    });
    return places;
}

bool within(const WaterPlace& place, double x, double z) {
    const glm::dvec2 off = glm::dvec2(x, z) - place.middle;
    return !(glm::dot(off, off) > place.radius * place.radius);
}

WaterGlobals waterGlobals(const WaterPlace& place, const Wind* wind, const glm::dvec3& eye, double seconds) {
    const Water& water = *place.water;
    WaterGlobals g{};
    g.middle = place.middle - glm::dvec2(eye.x, eye.z);
    g.radius = static_cast<float>(std::min(place.radius, kWidestPlace));
    g.height = static_cast<float>(static_cast<double>(water.level) - eye.y);
    g.color = water.color;
    g.mirroredAt = kMirroredAt;
    g.extinction = kPureWater + glm::vec3(3.912f / std::max(water.clarity, 0.01f));
    if (!wind) return g;
    const float slopes = water.ripples * std::sqrt(0.003f + 0.00512f * wind->speed);  // root of the mean square
    for (int i = 0; i < WATER_WAVES; ++i)
        g.waves[i] = waveOf(i, water, *wind, {eye.x, eye.z}, seconds, slopes * std::sqrt(2.0f / WATER_WAVES));
    return g;
}

void setCovers(WaterGlobals& g, const std::vector<WaterPlace>& places, size_t which, const Terrain& terrain,
               const glm::dvec3& eye) {
    const WaterPlace& own = places[which];
    const auto apart = [&](const WaterPlace* other) {
        return glm::distance(own.middle, other->middle) - std::min(other->radius, kWidestPlace);
    };
    std::vector<const WaterPlace*> over;
    for (size_t i = 0; i < places.size(); ++i) {
        const float level = places[i].water->level;
        const bool higher = level > own.water->level || (level == own.water->level && i < which);
        if (higher && static_cast<double>(level) < eye.y) over.push_back(&places[i]);
    }
    std::stable_sort(over.begin(), over.end(), [&](const auto* a, const auto* b) { return apart(a) < apart(b); });
    over.resize(std::min<size_t>(over.size(), WATER_COVERS));
    const glm::vec2 corner(-eye.x, -eye.z);
    g.land = glm::vec4(corner, glm::vec2(terrain.size - glm::dvec2(eye.x, eye.z)));
    std::fill(std::begin(g.covers), std::end(g.covers), glm::vec4(0));
    for (size_t i = 0; i < over.size(); ++i)
        g.covers[i] = {over[i]->middle.x - eye.x, over[i]->middle.y - eye.z, std::min(over[i]->radius, kWidestPlace),
                       static_cast<double>(over[i]->water->level) - eye.y};
}

glm::vec2 waterSlope(const WaterGlobals& g, const glm::vec2& at, float share) {
    glm::vec2 sum(0);
    for (const WaterWave& wave : g.waves)
        sum += f32::waveWay(wave.turns) * f32::waveSlope(wave.turns, wave.phase, wave.slope, at);
    return sum * share;
}

}  // namespace sward
