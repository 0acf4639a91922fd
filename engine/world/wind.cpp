#include "world/wind.h"

#include <numeric>

#include "core/numerics.h"

namespace sward {
namespace {

constexpr int kSide = 128;
constexpr double kFiner = 4;         // fine gusts are so much smaller
constexpr double kAcross = 0.5;      // gusts are bands: twice as wide as they are long
constexpr double kOvertakes = 1.4;   // fine gusts go faster, so that the picture changes while it moves
constexpr double kPhaseGrains = 20;  // c1 and c3 are whole numbers of 1/20 m

double wrapped(double x) { return x - std::floor(x); }
double inGrains(float c) { return std::round(static_cast<double>(c) * kPhaseGrains) / kPhaseGrains; }

// Value noise that repeats after `cells` in both directions, in [0, 1].
float periodicNoise(float x, float y, int cells, uint32_t seed) {
    const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
    const float fx = f32::clumpFade(x - static_cast<float>(i)), fy = f32::clumpFade(y - static_cast<float>(j));
    const auto at = [&](int a, int b) {
        return f32::hashUnit(f32::hash3(static_cast<uint32_t>(a % cells), static_cast<uint32_t>(b % cells), seed));
    };
    return glm::mix(glm::mix(at(i, j), at(i + 1, j), fx), glm::mix(at(i, j + 1), at(i + 1, j + 1), fx), fy);
}

// Of a repeating picture, bilinear, as a GPU samples it.
float sampleRepeated(const Map& m, const glm::vec2& uv) {
    const auto taps = [](float u, int n) {
        const double x = wrapped(static_cast<double>(u)) * n - 0.5, low = std::floor(x);
        const int i = static_cast<int>(low);
        return std::tuple{(i + n) % n, (i + 1) % n, static_cast<float>(x - low)};
    };
    const auto [x0, x1, fx] = taps(uv.x, m.info().width);
    const auto [y0, y1, fy] = taps(uv.y, m.info().height);
    return glm::mix(glm::mix(m.at(x0, y0), m.at(x1, y0), fx), glm::mix(m.at(x0, y1), m.at(x1, y1), fx), fy);
}

glm::vec2 wayOf(const WindGlobals& g) { return {g.way.x, g.way.y}; }
glm::vec2 coarsePlace(const WindGlobals& g, const glm::vec2& at) {
    return f32::gustPlace(at, wayOf(g), {g.begin.x, g.begin.y}, {g.rate.x, g.rate.y});
}
glm::vec2 finePlace(const WindGlobals& g, const glm::vec2& at) {
    return f32::gustPlace(at, wayOf(g), {g.begin.z, g.begin.w}, {g.rate.z, g.rate.w});
}

}  // namespace

const Wind* windOf(const Project& p) {
    for (const auto& [name, e] : p.entities)
        if (const Wind* w = p.registry.get<Wind>(e); w && w->strength > 0) return w;
    return nullptr;
}

Map makeGusts() {
    Map m(MapInfo{kSide, kSide, 1, PixelType::U16});
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const auto octave = [&](int cells, uint32_t seed) {
                const float scale = static_cast<float>(cells) / kSide;
                return periodicNoise((static_cast<float>(x) + 0.5f) * scale, (static_cast<float>(y) + 0.5f) * scale,
                                     cells, seed);
            };
            const float mean = 0.7f * octave(static_cast<int>(kGustsInPicture) * 2, 1) +
                               0.3f * octave(static_cast<int>(kGustsInPicture) * 4, 2);
            m.set(x, y, 0, std::clamp(0.5f + (mean - 0.5f) * 1.6f, 0.0f, 1.0f));
        }
    return m;
}

const Map& gustsOf(const Wind& wind, Map& made) {
    if (wind.model == WindModel::Waves) return made = {};
    if (wind.gusts.present()) return wind.gusts.map;
    if (made.empty()) made = makeGusts();
    return made;
}

float windStrength(const Wind& w, const Species& s) { return std::min(w.strength / s.stiffness, kStrongestWind); }

WindGlobals windGlobals(const Wind& w, const glm::dvec2& eye, double seconds) {
    const double angle = glm::radians(static_cast<double>(w.azimuthDeg)), speed = static_cast<double>(w.speed);
    const glm::dvec2 way(std::sin(angle), -std::cos(angle));
    const double along = glm::dot(eye, way), across = eye.y * way.x - eye.x * way.y;
    const double rate = 1 / (kGustsInPicture * static_cast<double>(w.gustSize)), fine = rate * kFiner;
    WindGlobals g{};
    g.way = {glm::vec2(way), w.strength, w.turbulence};
    g.begin = {wrapped((along - speed * seconds) * rate), wrapped(across * rate * kAcross),
               wrapped((along - kOvertakes * speed * seconds) * fine), wrapped(across * fine)};
    g.rate = {rate, rate * kAcross, fine, fine};
    g.waves = {inGrains(w.c1), w.c2, inGrains(w.c3), w.epsilon};
    // Equation 9 as printed moves at 1/pi metres a unit of time, against x.
    const f64::WindPhase phase = f64::windPhase(along, across, -f64::kPi * speed * seconds, inGrains(w.c1),
                                                static_cast<double>(w.c2), inGrains(w.c3));
    g.phases = {wrapped(static_cast<double>(w.quiverHz) * seconds), phase.first, phase.second, phase.across};
    return g;
}

double wavePeriod(const Wind& w) {
    const long a = std::lround(static_cast<double>(w.c1) * kPhaseGrains),
               b = std::lround(static_cast<double>(w.c3) * kPhaseGrains);
    const long common = std::gcd(a, b);
    if (common == 0 || !(w.speed > 0)) return std::numeric_limits<double>::infinity();
    return 2 * kPhaseGrains / (static_cast<double>(common) * static_cast<double>(w.speed));
}

float blowsAt(const WindGlobals& g, const Map& gusts, const glm::vec2& at) {
    if (gusts.empty()) {
        const glm::vec2 way = wayOf(g);
        return f32::windAt({g.phases.y, g.phases.z, g.phases.w}, glm::dot(at, way), at.y * way.x - at.x * way.y,
                           g.waves.x, g.waves.y, g.waves.z, g.waves.w);
    }
    return f32::gustStrength(sampleRepeated(gusts, coarsePlace(g, at)), sampleRepeated(gusts, finePlace(g, at)),
                             g.way.w);
}

glm::vec2 windLeanAt(const WindGlobals& g, const Map& gusts, const glm::vec2& at, float grain) {
    const float own = grain < 0 ? 0.0f : f32::quiver(g.phases.x, grain, finePlace(g, at));
    return f32::windLean(wayOf(g), g.way.z, blowsAt(g, gusts, at), g.way.w, own);
}

float windSlope(const WindGlobals& g, const Map& gusts) {
    const float own = 0.125f * g.way.w;  // a quiver's share
    if (gusts.empty()) {
        const float bound =
            (g.waves.x + g.waves.z) * f32::kPi * (1 + 0.25f * g.waves.y * f32::kPi / (g.waves.w * g.waves.w));
        return g.way.z * (bound * (1 + own) + own * 8 * (g.rate.z + g.rate.w) * f32::kTau);
    }
    float step = 0;
    const MapInfo& i = gusts.info();
    for (int y = 0; y < i.height; ++y)
        for (int x = 0; x < i.width; ++x)
            step =
                std::max({step, std::abs(gusts.at((x + 1) % i.width, y) - gusts.at(x, y)) * static_cast<float>(i.width),
                          std::abs(gusts.at(x, (y + 1) % i.height) - gusts.at(x, y)) * static_cast<float>(i.height)});
    const float bound = step * ((g.rate.x + g.rate.y) * (1 - 0.4f * g.way.w) + (g.rate.z + g.rate.w) * 0.4f * g.way.w);
    return g.way.z * (bound * (1 + own) + own * 4 * (g.rate.z + g.rate.w) * f32::kTau);
}

}  // namespace sward
