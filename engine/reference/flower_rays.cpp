#include "reference/flower_rays.h"

#include "core/numerics.h"
#include "frame/flower_image.h"
#include "reference/embree.h"
#include "reference/standing.h"
#include "scene/components.h"
#include "scene/tiling.h"
#include "world/forces.h"
#include "world/ground.h"
#include "world/wind.h"

namespace sward {
namespace {

struct FlowerKind {
    const Flowers* flowers = nullptr;
    TexelGrid image;
    bool made = true;
    float headShare = 1;
};
// Where a ray meets a flower.
struct Meeting {
    float t = 0;
    glm::vec2 uv{0};
    glm::vec3 normal{0};
    float open = 1;
};

}  // namespace

struct RayFlowers {
    const Terrain* terrain = nullptr;
    std::vector<FlowerKind> kinds;
    std::vector<StandingFlower> standing;
    DevicePtr device;
    ScenePtr scene;
};

namespace {

struct FlowerQuery {
    RayContext context;  // first: Embree's
    const RayFlowers* all;
    glm::vec3 origin, way;
    uint32_t grain;
    uint32_t left;  // as Ray has it
    uint32_t number = 0;
    Meeting met;
};

// What bends flowers.
struct Weather {
    const Wind* wind;
    const Map* gusts;
    WindGlobals globals{};
    std::vector<Force> forces;
    const GrassField* grass;
};

glm::vec2 leanOf(const Weather& w, const f32::Flower& f, const glm::dvec2& ground, const Terrain& t) {
    f32::BladeStand stand = f32::emptyStand();
    if (w.wind) stand.wind = windLeanAt(w.globals, *w.gusts, glm::vec2(ground), f.grain);
    const bool painted = w.grass && w.grass->forces.present();
    if (!painted && (w.forces.empty() || !w.grass)) return f32::leanOf(stand, f.facing).lean;
    glm::vec3 sum = w.grass ? forceAt(w.forces, ground) : glm::vec3(0);
    if (painted)
        sum += f32::paintedForce(
            paintedAt(w.grass->forces.map, ground / mapExtent(t), static_cast<double>(w.grass->forcesTiling), false));
    const glm::vec3 force = f32::forceOf(sum);
    stand.push = {force.x, force.y}, stand.press = force.z;
    return f32::leanOf(stand, f.facing).lean;
}

float flowersAt(const Terrain& t, const Flowers& f, const glm::dvec2& ground) {
    return f.density.present() ? tiledSample(f.density.map, tilingOf(t, f.densityTiling), ground.x, ground.y) : 1.0f;
}

void standCell(RayFlowers& all, const Weather& weather, uint32_t kind, const FlowerGrid& grid, int x, int z) {
    const Flowers& f = *all.kinds[kind].flowers;
    const Terrain& t = *all.terrain;
    for (uint32_t i = 0; i < grid.most; ++i) {
        const f32::Flower one = f32::flowerOf(x, z, i, grid.expected, static_cast<uint32_t>(f.seed & 0xFFFFFF));
        const glm::dvec2 ground = (glm::dvec2(x, z) + glm::dvec2(one.place)) * grid.side, place = ground / t.size;
        if (place.x > 1 || place.y > 1 || one.threshold > flowersAt(t, f, ground)) continue;
        const glm::vec3 stem =
            f32::flowerStem(one, f.height * (1 + f.heightVariation * one.taller), leanOf(weather, one, ground, t));
        const glm::vec3 root(glm::dvec3(ground.x, terrainHeight(t, ground.x, ground.y), ground.y));
        all.standing.push_back({root, stem, one.facing, 0.5f * f.headSize * one.larger, one.second, kind,
                                f32::hash3(static_cast<uint32_t>(x), static_cast<uint32_t>(z), i)});
    }
}

bool covers(const FlowerQuery& q, const FlowerKind& kind, const StandingFlower& s, const glm::vec2& uv) {
    const float alpha = kind.image.at(static_cast<double>(uv.x), static_cast<double>(uv.y), false).w;
    return alpha > f32::hashUnit(f32::hash2(q.grain, s.grain));
}

// Nearest place in ]near, far[ where the ray meets one of its two pieces. `a` and `b` span a piece about `middle`.
std::optional<glm::vec3> planeMet(const FlowerQuery& q, const glm::vec3& middle, const glm::vec3& a,
                                  const glm::vec3& b) {
    const glm::vec3 n = glm::cross(a, b);
    const float across = glm::dot(n, q.way);
    if (std::abs(across) < 1e-9f) return std::nullopt;
    const float t = glm::dot(n, middle - q.origin) / across;
    const glm::vec3 at = q.origin + q.way * t - middle;
    const glm::vec3 out(t, glm::dot(at, a) / glm::dot(a, a), glm::dot(at, b) / glm::dot(b, b));
    return std::abs(out.y) <= 1 && std::abs(out.z) <= 1 ? std::optional(out) : std::nullopt;
}

std::optional<Meeting> flowerMet(const FlowerQuery& q, const StandingFlower& s, float near, float far) {
    const FlowerKind& kind = q.all->kinds[s.kind];
    const f32::FlowerFrame f = f32::flowerFrame(s.stem, s.facing, -q.way);
    std::optional<Meeting> found;
    const auto take = [&](const glm::vec3& met, const glm::vec2& uv, const glm::vec3& normal, float open) {
        if (!(met.x > near && met.x < far) || !covers(q, kind, s, uv)) return;
        found = Meeting{met.x, uv, normal, open};
        far = met.x;
    };
    if (const auto head = planeMet(q, s.root + s.stem, f.side * s.half, f.up * s.half))
        take(*head, {0.5f + 0.5f * head->y, (0.5f - 0.5f * head->z) * kind.headShare}, f.face, 1);
    if (const auto stem = planeMet(q, s.root + 0.5f * s.stem, f.side * s.half, 0.5f * s.stem)) {
        const float v = 0.5f + 0.5f * stem->z;
        take(*stem, {0.5f + 0.5f * stem->y, glm::mix(1.0f, kind.headShare, v)}, f32::stemNormal(-q.way),
             f32::flowerOpen(v));
    }
    return found;
}

void meetClosest(const RTCIntersectFunctionNArguments* a) {
    if (!a->valid[0]) return;
    FlowerQuery& q = *reinterpret_cast<FlowerQuery*>(a->context);
    RTCRayHit& r = *reinterpret_cast<RTCRayHit*>(a->rayhit);
    if (a->primID == q.left) return;
    const auto met = flowerMet(q, q.all->standing[a->primID], r.ray.tnear, r.ray.tfar);
    if (!met) return;
    q.number = a->primID;
    q.met = *met;
    r.ray.tfar = met->t;
    r.hit.geomID = a->geomID, r.hit.primID = a->primID;
}

void flowerBounds(const RTCBoundsFunctionArguments* a) {
    const StandingFlower& s = static_cast<const RayFlowers*>(a->geometryUserPtr)->standing[a->primID];
    const glm::vec3 tip = s.root + s.stem, side(1.4143f * s.half);
    const glm::vec3 low = glm::min(s.root, tip) - side, high = glm::max(s.root, tip) + side;
    *a->bounds_o = {low.x, low.y, low.z, 0, high.x, high.y, high.z, 0};
}

bool makeScene(RayFlowers& f) {
    f.device.reset(rtcNewDevice(nullptr));
    if (!f.device) return false;
    f.scene = sceneOfBoxes<flowerBounds>(f.device.get(), f.standing.size(), &f, meetClosest, nullptr);
    return rtcGetDeviceError(f.device.get()) == RTC_ERROR_NONE;
}

// All that one kind has. Failed: too many, cancelled.
Status standAll(RayFlowers& all, const Weather& weather, uint32_t kind, const JobControl& control) {
    const FlowerGrid grid = flowerGrid(*all.kinds[kind].flowers);
    const int across = static_cast<int>(std::ceil(all.terrain->size.x / grid.side)),
              down = static_cast<int>(std::ceil(all.terrain->size.y / grid.side));
    for (int z = 0; z < down; ++z) {
        if (control.cancelled()) return failed("cancelled");
        for (int x = 0; x < across; ++x) standCell(all, weather, kind, grid, x, z);
        if (all.standing.size() > kMostRayFlowers)
            return failed(fmt::format("more than {} flowers make no reference", kMostRayFlowers),
                          "lower Flowers.flowersPerM2, or paint fewer");
    }
    return {};
}

Result<std::unique_ptr<RayFlowers>> standUp(const Project& p, double time, const JobControl& control) {
    auto all = std::make_unique<RayFlowers>();
    all->terrain = findGround(p).terrain;
    const auto found = flowersOf(p);
    if (!all->terrain || found.empty()) return all;
    Map made;
    Weather weather{windOf(p), nullptr, {}, forcesOf(p, time), nullptr};
    if (weather.wind)
        weather.gusts = &gustsOf(*weather.wind, made), weather.globals = windGlobals(*weather.wind, {0, 0}, time);
    for (const auto& [entity, flowers] : found) {
        const FlowerImage image = flowerImage(p, *flowers);
        weather.grass = p.registry.get<GrassField>(findEntity(p, grassAmong(p, entity)));
        all->kinds.push_back({flowers, texelGridOf(image.pixels), image.made, image.headShare});
        if (Status s = standAll(*all, weather, static_cast<uint32_t>(all->kinds.size() - 1), control); !s)
            return s.error();
    }
    return all;
}

}  // namespace

FlowerRays::FlowerRays(std::unique_ptr<RayFlowers> flowers) : flowers_(std::move(flowers)) {}
FlowerRays::FlowerRays(FlowerRays&&) noexcept = default;
FlowerRays& FlowerRays::operator=(FlowerRays&&) noexcept = default;
FlowerRays::~FlowerRays() = default;

Result<FlowerRays> FlowerRays::make(const Project& p, double time, const JobControl& control) {
    auto made = standUp(p, time, control);
    if (!made) return made.error();
    std::unique_ptr<RayFlowers> all = std::move(*made);
    if (!all->standing.empty() && !makeScene(*all))
        return failed("rays cannot be prepared: Embree has no memory, or does not know this processor",
                      "close other programs");
    return FlowerRays(std::move(all));
}

Result<std::vector<StandingFlower>> standingFlowers(const Project& p, double time, const JobControl& control) {
    auto all = standUp(p, time, control);
    if (!all) return all.error();
    return std::move((*all)->standing);
}

std::optional<Surface> FlowerRays::closest(const Ray& ray) const {
    const RayFlowers& all = *flowers_;
    if (!all.scene) return std::nullopt;
    const glm::dvec3 from = ray.origin + ray.way * ray.near;
    FlowerQuery q{{}, &all, glm::vec3(from), glm::vec3(ray.way), ray.grain, ray.left, 0, {}};
    RTCRayHit hit{embreeRay(q.origin, q.way, 0, static_cast<float>(std::min(ray.far - ray.near, 1e30))), {}};
    closestHit(all.scene.get(), q.context, hit);
    if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    const StandingFlower& one = all.standing[q.number];
    const FlowerKind& kind = all.kinds[one.kind];
    Surface s;
    s.met = Met::Flower;
    s.flower = q.number;
    s.t = ray.near + static_cast<double>(q.met.t);
    s.at = ray.origin + ray.way * s.t;
    s.normal = s.face = q.met.normal;
    const glm::vec3 petal = glm::mix(kind.flowers->color, kind.flowers->secondColor, one.second);
    s.color = f32::flowerColor(
        glm::vec3(kind.image.at(static_cast<double>(q.met.uv.x), static_cast<double>(q.met.uv.y), false)), petal,
        kind.flowers->centerColor, kind.flowers->stemColor, kind.made);
    s.open = q.met.open;
    s.place = glm::dvec2(one.root.x, one.root.z) / mapExtent(*all.terrain);
    return s;
}

}  // namespace sward
