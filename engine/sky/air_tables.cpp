#include "sky/air_tables.h"

#include <algorithm>
#include <functional>
#include <mutex>

#include "core/jobs.h"
#include "core/numerics.h"

namespace sward {
namespace {

using f32::Air;
using glm::vec3;

constexpr float kGroundSends = 0.3f;  // share of light, of all land and sea (Hillaire 2020, section 5.5.4)
constexpr int kColumnSteps = 64, kAroundSteps = 24, kAround = 48, kSkySteps = 48, kStepsPerColumn = 4;

float share(int i, int n) { return static_cast<float>(i) / static_cast<float>(n - 1); }

AirTable fill(int width, int height, const std::function<vec3(float x, float y)>& value) {
    AirTable t{width, height, std::vector<vec3>(static_cast<size_t>(width) * static_cast<size_t>(height))};
    parallelFor(static_cast<size_t>(height), [&](size_t y) {
        for (int x = 0; x < width; ++x)
            t.values[y * static_cast<size_t>(width) + static_cast<size_t>(x)] =
                value(share(x, width), share(static_cast<int>(y), height));
    });
    return t;
}

// Heights are closer together near the ground.
float heightShare(float height) { return std::sqrt(std::clamp(height / f32::kAirTop, 0.0f, 1.0f)); }
float heightAtShare(float share) { return f32::kAirTop * share * share; }
// And the sun's heights near the horizon.
float sunShare(float mu) { return 0.5f + 0.5f * std::copysign(std::sqrt(std::min(std::abs(mu), 1.0f)), mu); }
float sunMu(float share) {
    const float s = 2 * share - 1;
    return std::copysign(s * s, s);
}

// Rays that rise, by the distance to the top: Bruneton and Neyret 2008, section 4.
struct Way {
    float least, most;  // straight up, and level
};
Way waysOut(float height) { return {f32::kAirTop - height, f32::airExit(height, 0)}; }
float muOfExit(float height, float exit) {
    if (!(exit > 0)) return 1;
    const float out = (f32::kAirTop - height) * (2 * f32::kPlanet + f32::kAirTop + height);
    return std::clamp((out - exit * exit) / (2 * (f32::kPlanet + height) * exit), 0.0f, 1.0f);
}
vec3 columnsAt(float x, float y) {
    const float height = heightAtShare(y);
    const Way w = waysOut(height);
    return f32::airColumns(height, muOfExit(height, w.least + x * (w.most - w.least)), kColumnSteps);
}
vec3 risingColumns(const AirTable& columns, float height, float mu) {
    const Way w = waysOut(height);
    return columns.at((f32::airExit(height, mu) - w.least) / std::max(w.most - w.least, 1e-3f), heightShare(height));
}
// A ray that sinks passes its lowest point: all of the level ray there, less what lies behind the eye.
vec3 columnsTo(const AirTable& columns, float height, float mu) {
    if (mu >= 0) return risingColumns(columns, height, mu);
    const vec3 behind = risingColumns(columns, height, -mu),
               level = risingColumns(columns, f32::lowestOf(height, mu), 0);
    return glm::max(2.0f * level - behind, vec3(0));
}
vec3 left(const vec3& taken) { return glm::exp(-taken); }

// Share of the sun's light that reaches a height.
vec3 sunAt(const AirTable& columns, const Air& air, float height, float mu) {
    const float seen = f32::sunOverHorizon(height, mu);
    return seen > 0 ? left(f32::airTakes(air, columnsTo(columns, height, mu))) * seen : vec3(0);
}

// A ray through the air: from a height, with cosines to the zenith, of the sun to the zenith, and between both.
struct AirRay {
    float height, mu, sun, between;
};
struct AirStep {
    float height, sun, length;
    vec3 density;
};
AirStep stepAt(const AirRay& ray, float at, float length) {
    const float h = f32::airHeight(ray.height, ray.mu, at), r = f32::kPlanet + ray.height;
    return {h, std::clamp((r * ray.sun + at * ray.between) / (f32::kPlanet + h), -1.0f, 1.0f), length,
            f32::airDensity(h)};
}
// Ends of `steps` steps over a length, closer where the air is denser: at the begin (+1), the end (-1), neither (0).
float endOf(int i, int steps, float length, int denser) {
    const float s = static_cast<float>(i) / static_cast<float>(steps);
    return length * (denser > 0 ? s * s : denser < 0 ? 1 - (1 - s) * (1 - s) : s);
}

// (1 - exp(-x)) / x: the share of a step's source that comes through the step itself. Thin air takes a millionth, of
// which 1 - exp(-x) would keep no digit.
float comesOut(float x) { return x < 0.02f ? 1 - x * (0.5f - x / 6) : (1 - std::exp(-x)) / x; }

// Light that adds up along a ray, for 1 klx above the air; through: what is left of light from behind. Within a step
// the source is constant and what is taken is not (section 5.3).
struct Gathered {
    vec3 light{0}, through{1};
    void add(const vec3& source, const vec3& taken, float length) {
        const vec3 x = taken * length;
        light += through * source * length * vec3(comesOut(x.x), comesOut(x.y), comesOut(x.z));
        through *= left(x);
    }
};
vec3 scatters(const Air& air, const vec3& density) {
    return air.rayleigh * density.x + vec3(air.haze * f32::kHazeScatters * density.y);
}
vec3 sourceAt(const AirTables& t, const Air& air, const AirStep& s, float between) {
    const vec3 once = air.rayleigh * (s.density.x * f32::rayleighPhase(between)) +
                      vec3(air.haze * f32::kHazeScatters * s.density.y * f32::hazePhase(between));
    return once * sunAt(t.columns, air, s.height, s.sun) +
           scatters(air, s.density) * t.scattered.at(sunShare(s.sun), heightShare(s.height));
}

// Equations 5 to 8: of light from all around a place, what was scattered twice (without phase), and the share of such
// light that is scattered once more; summed over a ray.
struct Around {
    vec3 twice{0}, again{0};
};
Around aroundAlong(const AirTable& columns, const Air& air, const AirRay& ray) {
    const float ground = f32::groundAt(ray.height, ray.mu),
                length = ground >= 0 ? ground : f32::airExit(ray.height, ray.mu);
    const int denser = ground >= 0 ? -1 : ray.mu >= 0 ? 1 : 0;
    constexpr float kAllWays = 0.0795774715f;  // 1 / (4 pi)
    Gathered twice, again;
    for (int i = 0; i < kAroundSteps; ++i) {
        const float from = endOf(i, kAroundSteps, length, denser), to = endOf(i + 1, kAroundSteps, length, denser);
        const AirStep s = stepAt(ray, 0.5f * (from + to), to - from);
        const vec3 scattered = scatters(air, s.density), taken = f32::airTakes(air, s.density);
        twice.add(scattered * sunAt(columns, air, s.height, s.sun) * kAllWays, taken, s.length);
        again.add(scattered, taken, s.length);
    }
    if (ground >= 0) {
        const AirStep s = stepAt(ray, length, 0);
        twice.light +=
            twice.through * sunAt(columns, air, 0, s.sun) * (std::max(s.sun, 0.0f) * kGroundSends / f32::kPi);
    }
    return {twice.light, again.light};
}
vec3 scatteredAt(const AirTable& columns, const Air& air, float height, float sun) {
    const float sine = std::sqrt(std::max(1 - sun * sun, 0.0f));
    Around sum;
    for (int i = 0; i < kAround; ++i) {
        const float mu = 1 - 2 * (static_cast<float>(i) + 0.5f) / kAround, turn = static_cast<float>(i) * 2.39996323f,
                    r = std::sqrt(std::max(1 - mu * mu, 0.0f));
        const Around one = aroundAlong(columns, air, {height, mu, sun, mu * sun + r * sine * std::cos(turn)});
        sum.twice += one.twice / static_cast<float>(kAround), sum.again += one.again / static_cast<float>(kAround);
    }
    return sum.twice / glm::max(1.0f - sum.again, vec3(0.02f));  // equations 9 and 10
}

// A ray from kAirEye: up: sine over the horizon; across: half the chord to the sun (airAcross).
AirRay rayTo(float sunUp, float across, float up) {
    const float level = std::sqrt(std::max(1 - up * up, 0.0f)), sunLevel = std::sqrt(std::max(1 - sunUp * sunUp, 0.0f));
    return {kAirEye, up, sunUp, up * sunUp + level * sunLevel * (1 - 2 * across * across)};
}
vec3 skySeen(const AirTables& t, const Air& air, const AirRay& ray) {
    const float length = f32::airExit(ray.height, ray.mu);
    Gathered sum;
    for (int i = 0; i < kSkySteps; ++i) {
        const float from = endOf(i, kSkySteps, length, 1), to = endOf(i + 1, kSkySteps, length, 1);
        const AirStep s = stepAt(ray, 0.5f * (from + to), to - from);
        sum.add(sourceAt(t, air, s, ray.between), f32::airTakes(air, s.density), s.length);
    }
    return sum.light * f32::sunAboveAir();
}

// A row of `between`: along one level ray, what the air and the haze in it add up to.
void airAlongRay(AirTables& t, const Air& air, int x) {
    AirTable& table = t.between;
    const AirRay ray = rayTo(t.sunUp, share(x, table.width), 0);
    const vec3 horizon = t.sky.at(share(x, table.width), 0) / f32::sunAboveAir(), haze(t.haze * 1000);
    const float takes = t.haze + airExtinction(t.turbidity);
    Gathered sum;
    float from = 0;
    for (int y = 0; y < table.height; ++y) {
        // The first column is of a metre: its air is what that of no distance comes to.
        const float end = std::max(f32::airDistance(share(y, table.height)), 1.0f),
                    step = (end / 1000 - from) / kStepsPerColumn;
        for (int i = 0; i < kStepsPerColumn; ++i, from += step) {
            const AirStep s = stepAt(ray, from + 0.5f * step, step);
            sum.add(sourceAt(t, air, s, ray.between) + haze * horizon, f32::airTakes(air, s.density) + haze, step);
        }
        table.values[static_cast<size_t>(y) * static_cast<size_t>(table.width) + static_cast<size_t>(x)] =
            sum.light * f32::sunAboveAir() / f32::hazeTaken(takes, end);
    }
}

// How many of a scene's tables, as they are made one from another (scattered, sky, between), hold for another asked
// for.
constexpr int kAllTables = 3;
int sharedWith(const AirTables& t, float turbidity, float sunUp, float haze) {
    if (t.turbidity != turbidity) return 0;
    if (t.sunUp != sunUp) return 1;
    return t.haze == haze ? kAllTables : 2;
}
// The latest that were made in this process: drawing, the truth, each row of a sweep and a project opened anew ask for
// the same air. 1 MB.
struct LatestAir {
    static constexpr size_t kMost = 4;
    std::mutex lock;
    std::vector<AirTables> tables;
};
LatestAir& latestAir() {
    static LatestAir latest;
    return latest;
}
// Those of the latest that save most; none save less than t's own.
void takeLatest(AirTables& t, float turbidity, float sunUp, float haze) {
    LatestAir& latest = latestAir();
    const std::lock_guard hold(latest.lock);
    const AirTables* best = t.columns.values.empty() ? nullptr : &t;
    for (const AirTables& other : latest.tables)
        if (!best || sharedWith(other, turbidity, sunUp, haze) > sharedWith(*best, turbidity, sunUp, haze))
            best = &other;
    if (!best || best == &t) return;
    const unsigned changes = t.changes + 1;
    t = *best;
    t.changes = changes;
}
void keepLatest(const AirTables& t) {
    LatestAir& latest = latestAir();
    const std::lock_guard hold(latest.lock);
    if (latest.tables.size() == LatestAir::kMost) latest.tables.erase(latest.tables.begin());
    latest.tables.push_back(t);
}

}  // namespace

vec3 AirTable::at(float x, float y) const {
    const float px = std::clamp(x, 0.0f, 1.0f) * static_cast<float>(width - 1),
                py = std::clamp(y, 0.0f, 1.0f) * static_cast<float>(height - 1);
    const int x0 = std::min(static_cast<int>(px), width - 2), y0 = std::min(static_cast<int>(py), height - 2);
    const vec3* v = &values[static_cast<size_t>(y0) * static_cast<size_t>(width) + static_cast<size_t>(x0)];
    const float fx = px - static_cast<float>(x0), fy = py - static_cast<float>(y0);
    return glm::mix(glm::mix(v[0], v[1], fx), glm::mix(v[width], v[width + 1], fx), fy);
}

void updateAir(AirTables& t, float turbidity, float sunUp, float haze) {
    if (sharedWith(t, turbidity, sunUp, haze) == kAllTables) return;
    takeLatest(t, turbidity, sunUp, haze);
    const int shared = sharedWith(t, turbidity, sunUp, haze);
    if (shared == kAllTables) return;
    const Air air = f32::airOf(turbidity);
    if (t.columns.values.empty()) t.columns = fill(96, 48, columnsAt);
    if (shared < 1)
        t.scattered =
            fill(33, 24, [&](float x, float y) { return scatteredAt(t.columns, air, heightAtShare(y), sunMu(x)); });
    t.turbidity = turbidity, t.sunUp = sunUp, t.haze = haze;
    if (shared < 2)
        t.sky = fill(64, 96, [&](float x, float y) { return skySeen(t, air, rayTo(sunUp, x, f32::skySine(y))); });
    t.between = {32, 48, std::vector<vec3>(size_t(32) * 48)};
    parallelFor(32, [&](size_t x) { airAlongRay(t, air, static_cast<int>(x)); });
    ++t.changes;
    keepLatest(t);
}

float airExtinction(float turbidity) {
    const vec3 taken = f32::airTakes(f32::airOf(turbidity), f32::airDensity(kAirEye));
    return (taken.x + taken.y + taken.z) / 3000;
}

vec3 skyOf(const AirTables& t, const vec3& sun, const vec3& towards) {
    return t.sky.at(f32::airAcross({sun.x, sun.z}, {towards.x, towards.z}), f32::skyUp(towards.y));
}

vec3 airOver(const AirTables& t, const vec3& sun, const glm::vec2& way, float distance) {
    return t.between.at(f32::airAcross({sun.x, sun.z}, way), f32::airAlong(distance));
}

}  // namespace sward
