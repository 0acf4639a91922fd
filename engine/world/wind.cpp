#include "world/wind.h"

#include <numeric>

#include "core/numerics.h"

namespace sward {
namespace {

constexpr int kGustTexels = 128;
constexpr double kFiner = 4;         // fine gusts are so much smaller
constexpr double kAcross = 0.5;      // gusts are bands: twice as wide as they are long
constexpr double kOvertakes = 1.4;   // fine gusts go faster, so that the picture changes while it moves
constexpr double kPhaseGrains = 20;  // c1 and c3 are whole numbers of 1/20 m

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
        const double x = glm::fract(static_cast<double>(u)) * n - 0.5, low = std::floor(x);
        const int i = static_cast<int>(low);
        return std::tuple{(i + n) % n, (i + 1) % n, static_cast<float>(x - low)};
    };
    const auto [x0, x1, fx] = taps(uv.x, m.info().width);
    const auto [y0, y1, fy] = taps(uv.y, m.info().height);
    return glm::mix(glm::mix(m.at(x0, y0), m.at(x1, y0), fx), glm::mix(m.at(x0, y1), m.at(x1, y1), fx), fy);
}

glm::vec2 coarsePlace(const WindGlobals& g, const glm::vec2& at) {
    return f32::gustPlace(at, g.way, g.coarseBegin, g.coarseRate);
}
glm::vec2 finePlace(const WindGlobals& g, const glm::vec2& at) {
    return f32::gustPlace(at, g.way, g.fineBegin, g.fineRate);
}

}  // namespace

const Wind* windOf(const Project& p) {
    for (const auto& [name, e] : p.entities)
        if (const Wind* w = p.registry.get<Wind>(e); w && w->strength > 0) return w;
    return nullptr;
}

Map makeGusts() {
    Map m(MapInfo{kGustTexels, kGustTexels, 1, PixelType::U16});
    for (int y = 0; y < kGustTexels; ++y)
        for (int x = 0; x < kGustTexels; ++x) {
            const auto octave = [&](int cells, uint32_t seed) {
                const float scale = static_cast<float>(cells) / kGustTexels;
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
    g.way = way;
    g.strength = w.strength, g.turbulence = w.turbulence;
    g.coarseBegin = {glm::fract((along - speed * seconds) * rate), glm::fract(across * rate * kAcross)};
    g.fineBegin = {glm::fract((along - kOvertakes * speed * seconds) * fine), glm::fract(across * fine)};
    g.coarseRate = {rate, rate * kAcross}, g.fineRate = {fine, fine};
    g.c1 = static_cast<float>(inGrains(w.c1)), g.c2 = w.c2, g.c3 = static_cast<float>(inGrains(w.c3));
    g.epsilon = w.epsilon;
    // Equation 9 as printed moves at 1/pi metres a unit of time, against x.
    const f64::WindPhase phase = f64::windPhase(along, across, -f64::kPi * speed * seconds, inGrains(w.c1),
                                                static_cast<double>(w.c2), inGrains(w.c3));
    g.quiverPhase = static_cast<float>(glm::fract(static_cast<double>(w.quiverHz) * seconds));
    g.firstPhase = static_cast<float>(phase.first), g.secondPhase = static_cast<float>(phase.second);
    g.acrossPhase = static_cast<float>(phase.across);
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
        return f32::windAt({g.firstPhase, g.secondPhase, g.acrossPhase}, glm::dot(at, g.way),
                           at.y * g.way.x - at.x * g.way.y, g.c1, g.c2, g.c3, g.epsilon);
    }
    return f32::gustStrength(sampleRepeated(gusts, coarsePlace(g, at)), sampleRepeated(gusts, finePlace(g, at)),
                             g.turbulence);
}

glm::vec2 windLeanAt(const WindGlobals& g, const Map& gusts, const glm::vec2& at, float grain) {
    const float own = grain < 0 ? 0.0f : f32::quiver(g.quiverPhase, grain, finePlace(g, at));
    return f32::windLean(g.way, g.strength, blowsAt(g, gusts, at), g.turbulence, own);
}

float windSlope(const WindGlobals& g, const Map& gusts) {
    const float own = 0.125f * g.turbulence;  // a quiver's share
    if (gusts.empty()) {
        const float bound = (g.c1 + g.c3) * f32::kPi * (1 + 0.25f * g.c2 * f32::kPi / (g.epsilon * g.epsilon));
        return g.strength * (bound * (1 + own) + own * 8 * (g.fineRate.x + g.fineRate.y) * f32::kTau);
    }
    float step = 0;
    const MapInfo& i = gusts.info();
    for (int y = 0; y < i.height; ++y)
        for (int x = 0; x < i.width; ++x)
            step =
                std::max({step, std::abs(gusts.at((x + 1) % i.width, y) - gusts.at(x, y)) * static_cast<float>(i.width),
                          std::abs(gusts.at(x, (y + 1) % i.height) - gusts.at(x, y)) * static_cast<float>(i.height)});
    const float bound = step * ((g.coarseRate.x + g.coarseRate.y) * (1 - 0.4f * g.turbulence) +
                                (g.fineRate.x + g.fineRate.y) * 0.4f * g.turbulence);
    return g.strength * (bound * (1 + own) + own * 4 * (g.fineRate.x + g.fineRate.y) * f32::kTau);
}

}  // namespace sward
