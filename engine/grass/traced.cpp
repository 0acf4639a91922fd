#include "grass/traced.h"

#include <algorithm>

#include "core/luminance.h"
#include "core/numerics.h"

namespace sward {
namespace {

// Of one elevation of the light, of N numbers for each.
template <size_t N>
std::array<glm::vec3, N> numbersFor(const std::array<glm::vec3, N * TRACED_LIGHTS>& all, float sinElevation) {
    const float at = f32::tracedLightAt(sinElevation);
    const size_t low = std::min(static_cast<size_t>(at), static_cast<size_t>(TRACED_LIGHTS - 2));
    std::array<glm::vec3, N> out{};
    for (size_t i = 0; i < N; ++i)
        out[i] = glm::mix(all[N * low + i], all[N * (low + 1) + i], at - static_cast<float>(low));
    return out;
}
std::array<glm::vec3, TRACED_TERMS> termsFor(const TracedFactors& traced, float sinElevation) {
    return numbersFor<TRACED_TERMS>(traced.direct, sinElevation);
}

// All of it but the glow.
glm::vec3 sumBeside(const f32::TracedTerms& t, const std::array<glm::vec3, TRACED_TERMS>& numbers) {
    glm::vec3 sum = numbers[6] * t.near2;
    for (int i = 0; i < 3; ++i)
        sum += numbers[static_cast<size_t>(i)] * t.rise[i] + numbers[static_cast<size_t>(i) + 3] * t.across[i];
    return sum;
}

// Where a value lies among ascending ones.
struct Between {
    size_t low;
    float share;  // of the next
};
template <size_t N>
Between between(const float (&among)[N], float value) {
    size_t low = 0;
    while (low + 2 < N && value > among[low + 1]) ++low;
    return {low, std::clamp((value - among[low]) / (among[low + 1] - among[low]), 0.0f, 1.0f)};
}
float turnBetween(const glm::vec3& a, const glm::vec3& b) {
    const glm::vec2 level(a.x, a.z), other(b.x, b.z);
    return std::acos(
        std::clamp(glm::dot(level, other) / std::max(glm::length(level) * glm::length(other), 1e-6f), -1.0f, 1.0f));
}

}  // namespace

void TracedState::jobs(std::vector<JobNews>& out) const {
    for (const auto& [name, species] : fields)
        for (const One& one : species)
            if (one.bake.active()) out.push_back(one.bake.news());
}

const TracedLight* tracedOf(const DrawContext& ctx, const std::string& field, size_t species) {
    if (!ctx.shared.traced) return nullptr;
    const auto found = ctx.shared.traced->fields.find(field);
    if (found == ctx.shared.traced->fields.end() || species >= found->second.size()) return nullptr;
    return found->second[species].light ? &found->second[species].here : nullptr;
}

TracedLight underSky(const TracedLight& traced, const glm::vec3& tilt) {
    TracedLight out = traced;
    for (size_t i = 0; i < TRACED_RISE; ++i) out.blades.sky[i] += tilt * out.blades.skyTilt[i];
    for (TracedShows* shows : {&out.shows, &out.grey})
        for (size_t i = 0; i < kTracedViews; ++i) shows->sky[i] += tilt * shows->skyTilt[i];
    for (size_t i = 0; i < kTracedViews; ++i)  // a lean changes both alike
        for (auto& lean : out.leaning.sky)
            lean[i] *= out.shows.sky[i] / glm::max(traced.shows.sky[i], glm::vec3(1e-6f));
    const float soil = traced.soilSky + traced.soilTilt * luminance(tilt);
    out.soilSky = std::clamp(soil, 0.0f, 1.0f);
    return out;
}

glm::vec3 tracedDirect(const TracedFactors& traced, const glm::vec3& toEye, const glm::vec3& towards) {
    const f32::TracedTerms t = f32::tracedTerms(toEye, towards);
    const auto numbers = termsFor(traced, towards.y);
    return glm::max(sumBeside(t, numbers) + numbers[7] * t.glow, glm::vec3(0));
}

glm::vec3 tracedBeside(const TracedFactors& traced, const glm::vec3& toEye, const glm::vec3& towards) {
    return glm::max(sumBeside(f32::tracedTerms(toEye, towards), termsFor(traced, towards.y)), glm::vec3(0));
}

glm::vec3 tracedHotSpot(const TracedFactors& traced, const glm::vec3& towards) {
    const glm::vec3 beside = glm::max(tracedBeside(traced, towards, towards), glm::vec3(0.1f));
    return glm::clamp(termsFor(traced, towards.y)[7] / beside, 0.0f, 4.0f);
}

glm::vec3 shownDirect(const decltype(TracedShows::direct)& direct, const glm::vec3& toEye, const glm::vec3& towards) {
    const Between view = between(kViewSines, toEye.y), light = between(kLightSines, towards.y),
                  turn = between(kTurns, turnBetween(toEye, towards));
    glm::vec3 sum(0);
    for (size_t i = 0; i < 8; ++i) {
        const size_t v = i & 1, l = i >> 1 & 1, t = i >> 2;
        const float weight =
            (v ? view.share : 1 - view.share) * (l ? light.share : 1 - light.share) * (t ? turn.share : 1 - turn.share);
        sum += weight * direct[((view.low + v) * kTracedLights + light.low + l) * kTracedTurns + turn.low + t];
    }
    return sum;
}

glm::vec3 shownRise(const std::array<glm::vec3, kTracedViews>& shows, float sinElevation) {
    const Between view = between(kViewSines, sinElevation);
    return glm::mix(shows[view.low], shows[view.low + 1], view.share);
}

glm::vec3 tracedRise(const std::array<glm::vec3, TRACED_RISE>& numbers, float sinElevation) {
    const glm::vec3 rise = f32::tracedRise(sinElevation);
    return glm::max(numbers[0] * rise.x + numbers[1] * rise.y + numbers[2] * rise.z, glm::vec3(0));
}

float soilScattered(const TracedLight& traced, float sinElevation) {
    return std::max(glm::dot(traced.soilScattered, f32::tracedRise(sinElevation)), 0.0f);
}

void setSunFill(glm::vec4 (&fill)[TRACED_HEIGHTS], const TracedLight& traced, const glm::vec3& sun) {
    const auto numbers = numbersFor<TRACED_HEIGHTS>(traced.parts.fill, sun.y);
    for (size_t i = 0; i < numbers.size(); ++i) fill[i] = glm::vec4(numbers[i], 0);
}

void setTraced(SpeciesGlobals& g, const TracedLight* traced) {
    TracedFactors none;
    none.sky[0] = none.ground[0] = glm::vec3(1);
    TracedParts alone;
    for (size_t i = 0; i < alone.direct.size(); i += TRACED_TERMS) alone.direct[i] = glm::vec3(1);
    const TracedFactors& t = traced ? traced->blades : none;
    const TracedParts& parts = traced ? traced->parts : alone;
    g.recollision = traced ? traced->recollision : 0;
    const auto write = [](auto& to, const auto& numbers) {
        for (size_t i = 0; i < numbers.size(); ++i) to[i] = glm::vec4(numbers[i], 0);
    };
    write(g.traced, parts.direct), write(g.tracedFill, parts.fill);
    write(g.tracedSky, t.sky), write(g.tracedGround, t.ground);
}

}  // namespace sward
