#include "reference/around_tracer.h"

#include "core/numerics.h"
#include "reference/hemisphere.h"
#include "reference/solids.h"
#include "scene/technique.h"
#include "sky/air_tables.h"
#include "sky/daylight.h"
#include "world/land.h"
#include "world/lights.h"
#include "world/placement.h"

namespace sward {
namespace {

constexpr int kWays = 64;         // from a point of an object, over the whole sphere
constexpr int kGroundWays = 256;  // from a point of the ground, likewise: nothing is fitted to its points
constexpr int kBounces = 3;
constexpr float kLeast =
    0.03f;  // share of the sky's light: where less is left, all but what slips through edges is hidden
constexpr double kOff = 2e-3;  // metres by which rays start off a surface

// Directions spread evenly over the sphere, along a spiral of golden angles that begins by chance.
glm::vec3 wayOf(int i, int ways, float up, float turned) {
    const float y = 1 - 2 * (static_cast<float>(i) + up) / static_cast<float>(ways),
                r = std::sqrt(std::max(1 - y * y, 0.0f));
    const float turn = f32::kTau * (0.6180339887f * static_cast<float>(i) + turned);
    return {r * std::cos(turn), y, r * std::sin(turn)};
}

void add(AroundFactors& sum, const AroundFactors& f, float times) {
    sum.sky += times * f.sky, sum.sun += times * f.sun, sum.ground += times * f.ground;
}

}  // namespace

glm::vec3 lightBy(const AroundFactors& f, const AroundLights& l) {
    return f.sky * l.sky + f.sun * l.sun + f.ground * l.ground;
}
glm::vec3 shareAfter(const AroundFactors& change, const AroundLights& l) {
    return glm::max(glm::vec3(1) + lightBy(change, l) / glm::max(l.sky, glm::vec3(1e-6f)), glm::vec3(0));
}

struct AroundTracer::Impl {
    Project project;  // without wind, which would lean trees as it happens to blow
    std::optional<Solids> solids;
    std::vector<bool> lit;  // by placedMeshes: whether their light is traced
    FrameGlobals globals{};
    AroundLights lights;
    f32::SkyModel sky{};
    std::optional<AirTables> air;
    std::vector<const GrassField*> fields;
    bool hasSky = false, hasSun = false;

    // What comes from the sky, or from the plain below it.
    void addBackground(AroundFactors& sum, const glm::vec3& weight, const glm::vec3& way) const {
        if (!hasSky) return;
        if (way.y < 0) {
            sum.ground += weight;
            return;
        }
        const glm::vec3 here =
            (air ? skyOf(*air, globals.skySun, way) : f32::skyRadianceOf(sky, way)) * globals.skyGain;
        sum.sky += weight * here / glm::max(globals.skyLight, glm::vec3(1e-6f));
    }
    glm::vec3 sentBy(const Surface& s) const {
        const Terrain* t = solids->ground().terrain;
        return s.met == Met::Ground && t ? groundSends(*t, fields, s.at.x, s.at.z, s.color) : s.color;
    }
    void addSun(AroundFactors& sum, const glm::vec3& weight, const Surface& s) const {
        const float facing = glm::dot(s.normal, globals.sunDirection);
        if (!hasSun || !(globals.sunIsUp > 0) || !(facing > 0)) return;
        const Ray ray{s.at + glm::dvec3(s.face) * kOff, glm::normalize(glm::dvec3(globals.sunDirection))};
        if (globals.sunCasts > 0 && solids->blocks(ray)) return;
        sum.sun += weight * facing;
    }
    // Adds what comes along a ray that has met something.
    void follow(AroundFactors& sum, glm::vec3 weight, std::optional<Surface> s, uint32_t seed) const {
        for (uint32_t bounce = 0; bounce < kBounces; ++bounce) {
            weight *= sentBy(*s);
            addSun(sum, weight, *s);
            if (bounce + 1 == kBounces) return;
            const uint32_t h = f32::hash2(seed, bounce);
            const glm::vec3 on =
                cosineAround(s->normal, f32::hashUnit(f32::hash2(h, 0)), f32::hashUnit(f32::hash2(h, 1)));
            if (glm::dot(on, s->face) <= 0) return;
            Ray ray{s->at + glm::dvec3(s->face) * kOff, glm::normalize(glm::dvec3(on))};
            ray.grain = h;
            s = solids->closest(ray);
            if (!s) return addBackground(sum, weight, glm::vec3(ray.way));
        }
    }
    // Calls f(ray, weight, seed) for each direction above a surface of normal n.
    template <class F>
    void eachWay(const glm::dvec3& position, const glm::vec3& n, int ways, uint32_t seed, F f) const {
        const float up = f32::hashUnit(f32::hash2(seed, 0xa1u)), turned = f32::hashUnit(f32::hash2(seed, 0xa2u));
        for (int i = 0; i < ways; ++i) {
            const glm::vec3 way = wayOf(i, ways, up, turned);
            const float cosine = glm::dot(n, way);
            if (!(cosine > 0)) continue;
            const uint32_t h = f32::hash2(seed, static_cast<uint32_t>(i));
            Ray ray{position + glm::dvec3(n) * kOff, glm::normalize(glm::dvec3(way))};
            ray.grain = h;
            f(ray, glm::vec3(4 * cosine / static_cast<float>(ways)), h);
        }
    }
    bool isLit(const Surface& s) const { return s.met == Met::Object && s.object < lit.size() && lit[s.object]; }
};

AroundTracer::AroundTracer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
AroundTracer::AroundTracer(AroundTracer&&) noexcept = default;
AroundTracer& AroundTracer::operator=(AroundTracer&&) noexcept = default;
AroundTracer::~AroundTracer() = default;

Result<AroundTracer> AroundTracer::make(const Project& p, const Tables& tables, double seconds,
                                        const JobControl& control) {
    auto impl = std::make_unique<Impl>();
    impl->project = snapshot(p, tables.components);
    for (const auto& [name, e] : impl->project.entities) impl->project.registry.remove<Wind>(e);
    auto solids = Solids::make(impl->project, seconds, control);
    if (!solids) return solids.error();
    impl->solids = std::move(*solids);
    for (const PlacedMesh& m : placedMeshes(impl->project)) impl->lit.push_back(hasTracedLight(impl->project, m));
    const FeatureSet features = sceneFeatures(p.registry, tables);
    FrameGlobals& g = impl->globals;
    impl->hasSun = has(features, Feature::Sun), impl->hasSky = has(features, Feature::Sky);
    g.exposure = 1;
    if (impl->hasSun) addSun(g, p, seconds);
    if (has(features, Feature::Fog)) addHaze(g, p);
    if (has(features, Feature::Atmosphere)) addAir(g, p, seconds, impl->air.emplace());
    SkySums sums;
    if (impl->hasSky) addSky(g, p, seconds, sums, impl->air ? &*impl->air : nullptr);
    if (impl->hasSky) impl->sky = f32::skyModel(g.skySun, g.turbidity);
    impl->lights = {g.skyLight, g.sunLight, g.groundLight};
    for (const auto& [name, field] : fieldsOf(impl->project)) impl->fields.push_back(&field.grows);
    return AroundTracer(std::move(impl));
}

const AroundLights& AroundTracer::lights() const { return impl_->lights; }

AroundFactors AroundTracer::at(const glm::dvec3& position, const glm::vec3& n, uint32_t seed) const {
    AroundFactors sum;
    impl_->eachWay(position, n, kWays, seed, [&](const Ray& ray, const glm::vec3& weight, uint32_t h) {
        const std::optional<Surface> s = impl_->solids->closest(ray);
        if (!s) return impl_->addBackground(sum, weight, glm::vec3(ray.way));
        impl_->follow(sum, weight, s, h);
    });
    return sum;
}

// What a direction above the horizon would bring without the objects is the sky's light, hills behind them or not.
std::optional<AroundFactors> AroundTracer::changeOnGround(double x, double z) const {
    AroundFactors sum;
    const glm::vec3 n = impl_->solids->groundNormal(x, z);
    impl_->eachWay(impl_->solids->onGround(x, z), n, kGroundWays, 0,
                   [&](const Ray& ray, const glm::vec3& weight, uint32_t h) {
                       const std::optional<Surface> s = impl_->solids->closest(ray);
                       if (!s || !impl_->isLit(*s) || !(ray.way.y > 0)) return;
                       AroundFactors sent, hidden;
                       impl_->follow(sent, weight, s, h);
                       impl_->addBackground(hidden, weight, glm::vec3(ray.way));
                       add(sum, sent, 1), add(sum, hidden, -1);
                   });
    if (shareAfter(sum, impl_->lights).y < kLeast) return std::nullopt;
    return sum;
}

}  // namespace sward
