// What traced tables come to: polynomials of their quotients, and means.
#include <algorithm>
#include <functional>

#include "core/numerics.h"
#include "reference/hemisphere.h"
#include "reference/traced_light.h"

namespace sward {
namespace {

// A weighted least-squares fit of N numbers a colour, held near `first` = 1 and the rest 0 where nothing tells them.
template <size_t N>
struct Fit {
    std::array<std::array<double, N>, N> squares{};
    std::array<glm::dvec3, N> products{};
    void add(const std::array<double, N>& terms, const glm::dvec3& value, double weight) {
        for (size_t i = 0; i < N; ++i) {
            for (size_t k = 0; k < N; ++k) squares[i][k] += weight * terms[i] * terms[k];
            products[i] += weight * terms[i] * value;
        }
    }
    // By elimination; the held fit has no vanishing pivot.
    std::array<glm::vec3, N> solve() {
        constexpr double kHeld = 1e-3;
        for (size_t i = 0; i < N; ++i) squares[i][i] += kHeld;
        products[0] += kHeld;
        for (size_t i = 0; i < N; ++i)
            for (size_t k = i + 1; k < N; ++k) {
                const double times = squares[k][i] / squares[i][i];
                for (size_t m = i; m < N; ++m) squares[k][m] -= times * squares[i][m];
                products[k] -= times * products[i];
            }
        std::array<glm::vec3, N> out{};
        for (size_t i = N; i-- > 0;) {
            glm::dvec3 rest = products[i];
            for (size_t m = i + 1; m < N; ++m) rest -= squares[i][m] * glm::dvec3(out[m]);
            out[i] = glm::vec3(rest / squares[i][i]);
        }
        return out;
    }
};

// What a factor is a sum of, for one elevation of the light; the glow is the last.
std::array<double, TRACED_TERMS> termsOf(float view, float light, float turn) {
    const f32::TracedTerms t = f32::tracedTerms(raised(0, view), raised(turn, light));
    std::array<double, TRACED_TERMS> out{};
    for (int i = 0; i < 3; ++i) {
        out[static_cast<size_t>(i)] = static_cast<double>(t.rise[i]);
        out[static_cast<size_t>(i) + 3] = static_cast<double>(t.across[i]);
    }
    out[6] = static_cast<double>(t.near2), out[7] = static_cast<double>(t.glow);
    return out;
}

std::array<glm::vec3, TRACED_RISE> fitRise(const std::array<TracedSums, kTracedViews>& sums) {
    Fit<TRACED_RISE> fit;
    for (size_t i = 0; i < sums.size(); ++i) {
        const glm::vec3 rise = f32::tracedRise(kViewSines[i]);
        fit.add({static_cast<double>(rise.x), static_cast<double>(rise.y), static_cast<double>(rise.z)},
                sums[i].full / glm::max(sums[i].local, glm::dvec3(1e-9)), 1);
    }
    return fit.solve();
}

// A quotient of the table, and how much it counts: by what local light says.
struct Seen {
    int light, view, turn;
    glm::dvec3 quotient;
    double weight;
};
// By view and direction, what is taken from the sums first.
using Without = std::function<glm::dvec3(size_t view, size_t direction)>;
std::vector<Seen> quotientsOf(const TracedTable& table, const Without& without) {
    std::vector<Seen> out;
    for (int light = 0; light < kTracedLights; ++light) {
        const auto sumsOf = [&](int view, int turn) -> const TracedSums& {
            return table.direct[static_cast<size_t>(view)][static_cast<size_t>(light * kTracedTurns + turn)];
        };
        double mean = 0;
        for (int view = 0; view < kTracedViews; ++view)
            for (int turn = 0; turn < kTracedTurns; ++turn)
                mean += sumsOf(view, turn).local.y / (kTracedViews * kTracedTurns);
        for (int view = 0; view < kTracedViews && mean > 0; ++view)
            for (int turn = 0; turn < kTracedTurns; ++turn) {
                const TracedSums& s = sumsOf(view, turn);
                const glm::dvec3 left =
                    s.full - without(static_cast<size_t>(view), static_cast<size_t>(light * kTracedTurns + turn));
                out.push_back({light, view, turn, glm::max(left, glm::dvec3(0)) / glm::max(s.local, glm::dvec3(1e-9)),
                               s.local.y / mean});
            }
    }
    return out;
}

// The glow about each elevation of the light: a few directions of each see it, so that it is fitted with all of them,
// as a polynomial of the elevation like the rest.
std::array<glm::vec3, TRACED_LIGHTS> fitGlow(const std::vector<Seen>& seen) {
    Fit<TRACED_TERMS * TRACED_RISE> fit;
    for (const Seen& s : seen) {
        const auto terms = termsOf(kViewSines[s.view], kLightSines[s.light], kTurns[s.turn]);
        const glm::vec3 by = f32::tracedRise(kLightSines[s.light]);
        std::array<double, TRACED_TERMS * TRACED_RISE> all{};
        for (size_t i = 0; i < all.size(); ++i)
            all[i] = static_cast<double>(by[static_cast<int>(i / TRACED_TERMS)]) * terms[i % TRACED_TERMS];
        fit.add(all, s.quotient, s.weight);
    }
    const auto numbers = fit.solve();
    std::array<glm::vec3, TRACED_LIGHTS> out{};
    for (size_t light = 0; light < out.size(); ++light)
        for (size_t k = 0; k < TRACED_RISE; ++k)
            out[light] +=
                f32::tracedRise(kLightSines[light])[static_cast<int>(k)] * numbers[TRACED_TERMS * k + TRACED_TERMS - 1];
    return out;
}

// Each elevation of the light has its own numbers.
std::array<glm::vec3, TRACED_DIRECT> fitDirect(const std::vector<Seen>& seen) {
    constexpr size_t kBeside = TRACED_TERMS - 1;
    const auto glow = fitGlow(seen);
    std::array<Fit<kBeside>, TRACED_LIGHTS> fits;
    for (const Seen& s : seen) {
        const auto terms = termsOf(kViewSines[s.view], kLightSines[s.light], kTurns[s.turn]);
        std::array<double, kBeside> beside{};
        std::copy_n(terms.begin(), kBeside, beside.begin());
        const auto light = static_cast<size_t>(s.light);
        fits[light].add(beside, s.quotient - terms[kBeside] * glm::dvec3(glow[light]), s.weight);
    }
    std::array<glm::vec3, TRACED_DIRECT> out{};
    for (size_t light = 0; light < TRACED_LIGHTS; ++light) {
        const auto numbers = fits[light].solve();
        std::copy(numbers.begin(), numbers.end(), out.begin() + static_cast<std::ptrdiff_t>(TRACED_TERMS * light));
        out[TRACED_TERMS * light + kBeside] = glow[light];
    }
    return out;
}

// What comes from blade to blade is taken as the same for all views and turns; where it is, what is left to local light
// keeps the whole.
TracedParts partsOf(const TracedTable& table) {
    TracedParts out;
    for (size_t i = 0; i < TRACED_FILL; ++i) {
        glm::dvec3 reflect(0);
        for (const auto& view : table.reflect) reflect += view[i % TRACED_HEIGHTS];
        out.fill[i] = glm::vec3(table.filled[i / TRACED_HEIGHTS][i % TRACED_HEIGHTS] /
                                glm::max(reflect * double(kTracedTurns), glm::dvec3(1e-9)));
    }
    out.direct = fitDirect(quotientsOf(table, [&](size_t view, size_t direction) {
        glm::dvec3 sum(0);
        for (size_t k = 0; k < TRACED_HEIGHTS; ++k)
            sum += table.reflect[view][k] * glm::dvec3(out.fill[direction / kTracedTurns * TRACED_HEIGHTS + k]);
        return sum;
    }));
    return out;
}

// What paths have seen of a view, on average.
glm::vec3 meanOf(const TracedTable& table, size_t view, const glm::dvec3& sum) {
    return glm::vec3(sum / static_cast<double>(std::max(table.met[view], 1)));
}
// By what what is seen is divided for the glow about the light, which pictures put back.
glm::vec3 glowOf(const TracedFactors& factors, size_t view, size_t direction) {
    const glm::vec3 eye = raised(0, kViewSines[view]),
                    light = raised(kTurns[direction % kTracedTurns], kLightSines[direction / kTracedTurns]);
    return 1.0f + tracedHotSpot(factors, light) * f32::tracedGlow(eye, light);
}
LeaningShows leaningOf(const TracedTable& table, const TracedFactors& factors) {
    LeaningShows out;
    out.lean = table.lean;
    for (size_t view = 0; view < kTracedViews && table.lean > 0; ++view) {
        const TracedTable::Leaning& seen = table.leaning[view];
        const double share = 1.0 / std::max(seen.met, 1);
        for (size_t k = 0; k < kTracedLeans; ++k) {
            out.sky[k][view] = glm::vec3(share * seen.sky[k]);
            for (size_t i = 0; i < seen.direct.size(); ++i)
                out.direct[k][view * seen.direct.size() + i] =
                    glm::vec3(share * seen.direct[i][k]) / glowOf(factors, view, i);
        }
    }
    return out;
}
// of: `full` of the sums, or `grey`.
TracedShows showsOf(const TracedTable& table, const TracedFactors& factors, glm::dvec3 TracedSums::*of) {
    TracedShows out;
    for (size_t view = 0; view < kTracedViews; ++view) {
        out.sky[view] = meanOf(table, view, table.sky[view].*of);
        out.skyTilt[view] = meanOf(table, view, table.tilt[view].*of);
        out.ground[view] = meanOf(table, view, table.ground[view].*of);
        for (size_t i = 0; i < table.direct[view].size(); ++i)
            out.direct[view * table.direct[view].size() + i] =
                meanOf(table, view, table.direct[view][i].*of) / glowOf(factors, view, i);
    }
    return out;
}

}  // namespace

TracedLight fitTraced(const TracedTable& table) {
    TracedLight light;
    const std::vector<Seen> whole = quotientsOf(table, [](size_t, size_t) { return glm::dvec3(0); });
    light.blades = {fitDirect(whole), fitRise(table.sky), fitRise(table.ground), fitRise(table.tilt)};
    light.parts = partsOf(table);
    light.shows = showsOf(table, light.blades, &TracedSums::full);
    light.grey = showsOf(table, light.blades, &TracedSums::grey);
    light.leaning = leaningOf(table, light.blades);
    Fit<TRACED_RISE> scattered;
    for (size_t i = 0; i < kTracedLights; ++i) {
        const glm::dvec3 rise(f32::tracedRise(kLightSines[i]));
        scattered.add({rise.x, rise.y, rise.z}, glm::dvec3(table.soilScattered[i]), 1e3);
    }
    const auto numbers = scattered.solve();
    light.soilScattered = {numbers[0].x, numbers[1].x, numbers[2].x};
    light.recollision = std::clamp(static_cast<float>(table.twice / std::max(table.once, 1e-9)), 0.0f, 0.95f);
    light.soilSky = static_cast<float>(table.soilSky);
    light.soilTilt = static_cast<float>(table.soilTilt);
    return light;
}

}  // namespace sward
