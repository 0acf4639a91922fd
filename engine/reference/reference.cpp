#include "reference/reference.h"

#include <mutex>

#include "core/luminance.h"
#include "core/numerics.h"
#include "grass/drawing.h"
#include "reference/flower_rays.h"
#include "reference/grass_rays.h"
#include "reference/hemisphere.h"
#include "reference/mesh_blades.h"
#include "reference/solids.h"
#include "reference/water_rays.h"
#include "scene/technique.h"
#include "shared/frame.h"
#include "sky/air_tables.h"
#include "sky/daylight.h"
#include "world/drawn_project.h"
#include "world/view_camera.h"

namespace sward {
namespace {

constexpr int kBlockWidth = 32;  // pixels; as high as a shard's band
constexpr int kMostBounces = 32;
constexpr double kOffBlade =
    2e-5;  // metres by which a new ray starts off the surface it leaves, so as not to meet it again
constexpr double kOffSolid = 2e-4;
constexpr float kBrightest = 65504;  // as the scene's target holds

// Independent numbers of one sample: the n-th is hashUnit(hash3(seed, place, n)).
struct Dice {
    uint32_t seed, place, next = 0;
    float unit() { return f32::hashUnit(f32::hash3(seed, place, next++)); }
    uint32_t grain() { return f32::hash3(seed, place, next++); }
};

glm::vec3 drawnAround(const glm::vec3& n, Dice& dice) {
    const float share = dice.unit();
    return cosineAround(n, share, dice.unit());
}

}  // namespace

struct ReferenceScene::Impl {
    Project project;
    FeatureSet features;
    double time = 0;
    std::optional<Solids> solids;
    std::optional<GrassRays> grass;
    std::optional<MeshBlades> meshBlades;
    std::optional<FlowerRays> flowers;
};

namespace {

// A camera's view of the scene: what shaders get as globals, and one thread's memory.
struct View {
    const ReferenceScene::Impl& scene;
    const ReferenceSettings& settings;
    FrameGlobals globals{};
    LightsGlobals lamps{};
    f32::SkyModel sky{};
    glm::dmat4 toWorld{1};
    glm::dvec3 eye{0};  // from the terrain's corner
    std::vector<const GrassField*> fields{};
    FieldBits masked = 0, shading = 0;  // fields whose blades shade each other; the ground
    WaterRays water{};
    std::shared_ptr<const AirTables> air = {};  // of a sky of that model
    bool hasSky = false, hasSun = false, hasHaze = false;
};

View viewFrom(const ReferenceScene::Impl& scene, const ViewCamera& camera, const ReferenceSettings& settings) {
    View v{scene, settings};
    v.eye = camera.eye - scene.solids->ground().origin;
    v.toWorld = glm::inverse(glm::dmat4(viewProjection(camera, settings.width, settings.height)));
    v.globals.exposure = std::exp2(camera.exposure);
    v.globals.eye = v.eye;
    const Terrain& t = *firstOf<Terrain>(scene.project);
    v.globals.terrainSize = t.size;
    v.globals.terrainShare = 1.0 / t.size;
    v.hasSun = has(scene.features, Feature::Sun), v.hasSky = has(scene.features, Feature::Sky);
    const bool hasAir = has(scene.features, Feature::Atmosphere);
    v.hasHaze = has(scene.features, Feature::Fog) || hasAir;
    SkySums sums;
    if (v.hasSun) addSun(v.globals, scene.project, scene.time);
    if (has(scene.features, Feature::Fog)) addHaze(v.globals, scene.project);
    if (hasAir) {
        auto tables = std::make_shared<AirTables>();
        addAir(v.globals, scene.project, scene.time, *tables);
        v.air = std::move(tables);
    }
    if (v.hasSky) addSky(v.globals, scene.project, scene.time, sums, v.air.get());
    if (has(scene.features, Feature::Lamps))
        v.lamps = lampsAround(scene.project, camera.eye, scene.time, v.globals.exposure);
    if (v.hasSky) v.sky = f32::skyModel(v.globals.skySun, v.globals.turbidity);
    FieldBits bit = 1;
    for (const auto& [name, field] : fieldsOf(scene.project)) {
        const auto& drawing = field.settings<GrassDrawing>();
        if (drawing.shadowMask > 0) v.masked |= bit;
        if (drawing.groundShadows) v.shading |= bit;
        bit <<= 1;
        v.fields.push_back(&field.grows);
    }
    v.water = WaterRays::make(scene.project, scene.time, v.eye);
    return v;
}

glm::vec3 horizonOf(const View& v, const glm::dvec3& way) {
    const FrameGlobals& g = v.globals;
    const auto h = [&g](int i) { return glm::vec3(g.horizon[i]); };
    return f32::horizonLight(h(0), h(1), h(2), h(3), h(4), g.horizonMiddle, g.horizonScale, {g.skySun.x, g.skySun.z},
                             {static_cast<float>(way.x), static_cast<float>(way.z)});
}

// What haze fades into over a distance (m).
glm::vec3 hazeOf(const View& v, const glm::dvec3& way, double distance) {
    if (!v.air) return horizonOf(v, way);
    const glm::vec2 level(way.x, way.z);
    return airOver(*v.air, v.globals.skySun, level, static_cast<float>(distance)) * v.globals.skyGain;
}

// What a ray sees that meets nothing: the sky, and the plain beyond the terrain.
glm::vec3 background(const View& v, const glm::dvec3& way, bool withSun) {
    if (!v.hasSky) return glm::vec3(0);
    const FrameGlobals& g = v.globals;
    const glm::vec3 d(way);
    if (d.y < 0) {
        const float distance = f32::plainDistance(g.eye, g.terrainSize, d);
        return f32::plainLight(g.groundLight, hazeOf(v, way, static_cast<double>(distance)),
                               v.air ? g.haze : f32::clearHaze(g.haze), distance);
    }
    glm::vec3 light = (v.air ? skyOf(*v.air, g.skySun, d) : f32::skyRadianceOf(v.sky, d)) * g.skyGain;
    if (withSun && v.hasSun) light += g.sunLight * f32::sunDisc(glm::dot(d, g.sunDirection));
    return light;
}

// Of ground beyond the terrain, with what grows there.
glm::vec3 landColor(const View& v, const Surface& s) {
    const Land& land = v.scene.solids->land();
    const float beyond = f32::beyondBy({s.at.x, s.at.z}, v.globals.terrainSize),
                left = v.scene.grass->lightLeft(s.place, v.globals.sunDirection, s.normal);
    return f32::landSends(s.color * left, land.grass, left, land.mean, f32::landMean(beyond, land.fade));
}

std::optional<Surface> meet(const View& v, Ray ray, GrassMemory& memory) {
    std::optional<Surface> solid = v.scene.solids->closest(ray);
    if (solid && solid->beyond) solid->color = landColor(v, *solid);
    if (solid) ray.far = solid->t;
    if (std::optional<Surface> flower = v.scene.flowers->closest(ray)) {
        solid = flower;
        ray.far = flower->t;
    }
    if (std::optional<Surface> blade = v.scene.meshBlades->closest(ray)) {
        solid = blade;
        ray.far = blade->t;
    }
    std::optional<Surface> blade = v.scene.grass->closest(ray, memory);
    return blade ? blade : solid;
}

Ray leave(const Surface& s, const glm::vec3& towards, double far, Dice& dice) {
    const double off = s.met == Met::Blade ? kOffBlade : kOffSolid, side = glm::dot(s.face, towards) < 0 ? -1 : 1;
    return {
        s.at + glm::dvec3(s.face) * (off * side), glm::normalize(glm::dvec3(towards)), 0, far, dice.grain(), s.flower};
}

// Whether light reaches a surface from a direction and distance, past what casts shadows on it.
bool lit(const View& v, const Surface& s, const glm::vec3& towards, double far, Dice& dice, GrassMemory& memory) {
    const Ray ray = leave(s, towards, far, dice);
    if (v.scene.solids->blocks(ray)) return false;
    if (v.settings.lighting == ReferenceLighting::Full && v.scene.flowers->blocks(ray)) return false;
    const bool leaves = v.settings.lighting == ReferenceLighting::Full || s.met == Met::Object || s.onMesh;
    if (leaves && v.scene.meshBlades->blocks(ray)) return false;
    FieldBits by = kAllFields;
    if (v.settings.lighting != ReferenceLighting::Full) {
        const bool masked = s.met == Met::Blade && !s.onMesh && (v.masked >> s.field & 1);
        by = masked ? kAllFields : s.met == Met::Ground ? v.shading : 0;
    }
    return by == 0 || !v.scene.grass->blocks(ray, memory, by);
}

// What a surface sends to the eye of light from a direction that would light what faces it by 1 (irradiance over pi).
glm::vec3 sends(const Surface& s, const glm::vec3& toEye, const glm::vec3& towards) {
    if (s.met == Met::Flower) return s.color * f32::flowerSends(s.normal, towards);
    return f32::leafSends(s.color, s.looks, s.normal, toEye, towards) * s.tint;
}

// Share of direct light that is left where shadows are not traced: as shaders have it without masks and drawn shadows.
float untracedShare(const View& v, const Surface& s, bool casts, const glm::vec3& towards) {
    if (v.settings.lighting == ReferenceLighting::Full) return 1;
    if (s.met == Met::Flower) return s.open;
    if (s.met == Met::Blade) return (v.masked >> s.field & 1) && casts ? 1 : s.open;
    if (s.met == Met::Ground && !s.beyond)
        return v.scene.grass->lightLeft(s.place, towards, s.normal, casts ? ~v.shading : kAllFields);
    return 1;
}

// A light as a surface meets it.
struct Arriving {
    glm::vec3 towards;  // unit
    double far;         // metres to the light
    glm::vec3 color;    // irradiance on what faces it, divided by pi
    bool casts;         // whether things in between shade the surface
};
glm::vec3 lightFrom(const View& v, const Surface& s, const glm::vec3& toEye, const Arriving& light, Dice& dice,
                    GrassMemory& memory) {
    const glm::vec3 sent = sends(s, toEye, light.towards) * light.color;
    if (sent == glm::vec3(0)) return glm::vec3(0);
    if (light.casts && !lit(v, s, light.towards, light.far, dice, memory)) return glm::vec3(0);
    return sent * untracedShare(v, s, light.casts, light.towards);
}

// Calls body(arriving) for the sun, if it is up, and for each lamp.
template <class F>
void eachLight(const View& v, const glm::dvec3& at, F body) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    const FrameGlobals& g = v.globals;
    if (v.hasSun && g.sunIsUp > 0) body(Arriving{g.sunDirection, kFar, g.sunLight, g.sunCasts > 0});
    for (int i = 0; i < v.lamps.count; ++i) {
        const LightGlobals& l = v.lamps.lights[i];
        const glm::vec3 way = l.place - glm::vec3(at - v.eye) * l.isPoint;
        const f32::PointLight p = f32::pointLight(way, l.beta);
        const double far = l.isPoint > 0 ? static_cast<double>(glm::length(way)) : kFar;
        body(Arriving{p.direction, far, l.color * p.attenuation, i < v.lamps.casting});
    }
}
glm::vec3 directLight(const View& v, const Surface& s, const glm::vec3& toEye, Dice& dice, GrassMemory& memory) {
    glm::vec3 sum(0);
    eachLight(v, s.at, [&](const Arriving& light) { sum += lightFrom(v, s, toEye, light, dice, memory); });
    return sum;
}

// Share of the sky that maps of ambient occlusion leave: a blade's own field's; elsewhere the least of any.
float skyShare(const View& v, const Surface& s) {
    float least = 1;
    for (size_t i = 0; i < v.fields.size(); ++i) {
        const GrassField& f = *v.fields[i];
        if (!f.ambientOcclusion.present() || (s.met == Met::Blade && (s.field != i || s.onMesh))) continue;
        least = std::min(
            least, paintedAt(f.ambientOcclusion.map, s.place, static_cast<double>(f.ambientOcclusionTiling), false).x);
    }
    return least;
}

// Light from above and below as shaders have it (ReferenceLighting::Direct).
glm::vec3 ambientLight(const View& v, const Surface& s) {
    float share = s.met == Met::Object ? 1 : s.open;
    if (s.met != Met::Object) share *= skyShare(v, s);
    if (s.met == Met::Ground && !s.beyond)
        share *= v.scene.grass->lightLeft(s.place, v.globals.sunDirection, {0, 1, 0});
    const auto from = [&](float up) { return f32::halvesLight(v.globals.groundLight, v.globals.skyLight, up); };
    glm::vec3 sent = s.color * s.tint * from(s.normal.y);
    // Blades have no light from all around through them, as shaders light them.
    if (s.ofTree && s.looks.x > 0) sent += f32::leafPasses(s.color, s.looks.x) * from(-s.normal.y);
    return sent * share;
}

// The next direction of a path, and by how much it counts. A leaf sends part of it on from behind.
struct Bounce {
    glm::vec3 towards;
    glm::vec3 weight;
};
Bounce bounceOff(const Surface& s, const glm::vec3& toEye, Dice& dice) {
    const float through = s.looks.x > 0 ? luminance(f32::leafPasses(s.color, s.looks.x)) : 0;
    const float share = through > 0 ? through / (through + luminance(s.color)) : 0;
    const bool behind = share > 0 && dice.unit() < share;
    const glm::vec3 side = behind ? -s.normal : s.normal, towards = drawnAround(side, dice);
    const float cosine = std::max(glm::dot(side, towards), 1e-6f);
    return {towards, sends(s, toEye, towards) / (cosine * (behind ? share : 1 - share))};
}

// What the surface of water itself shows: glints of sun and lamps; and of the light that enters, what its body sends
// back, as a factor of the share that does not come through.
struct WaterShows {
    glm::vec3 glint{0}, body{0};
};
WaterShows waterShows(const View& v, const WaterMet& w, const Ray& ray, Dice& dice, GrassMemory& memory) {
    WaterShows shows;
    shows.body = w.color * v.globals.skyLight;
    Surface s;
    s.met = Met::Water;
    s.at = w.at;
    eachLight(v, s.at, [&](const Arriving& l) {
        if (!(l.towards.y > 0) || (l.casts && !lit(v, s, l.towards, l.far, dice, memory))) return;
        shows.body += w.color * l.color * l.towards.y;
        shows.glint += l.color * f32::sunGlint(w.slope, f32::kSmoothest, glm::vec3(-ray.way), l.towards);
    });
    return shows;
}

// A path of light, back from the eye. met: the surface that it has come to.
struct Path {
    Ray ray;
    glm::vec3 weight{1}, sum{0};
    std::optional<Surface> met = {};
    bool seesSun = true;
};
// On from water, thrown back or let in, to the surface that is met then.
void leaveWater(const View& v, Path& path, const WaterMet& w, const WaterShows& shows, bool back, Dice& dice,
                GrassMemory& memory) {
    const glm::vec3 way(path.ray.way);
    path.ray = {w.at + glm::dvec3(0, back ? kOffSolid : -kOffSolid, 0),
                glm::normalize(glm::dvec3(back ? f32::mirrored(way, w.normal) : f32::refracted(way, w.normal))), 0,
                std::numeric_limits<double>::infinity(), dice.grain()};
    path.met = meet(v, path.ray, memory);
    if (back) {
        path.seesSun = false;  // the glint is the sun's image
        if (!path.met || !v.hasHaze) return;
        const float haze = f32::hazeTaken(v.globals.haze, static_cast<float>(path.met->t));
        path.sum += path.weight * haze * hazeOf(v, path.ray.way, path.met->t);
        path.weight *= 1 - haze;
        return;
    }
    const glm::vec3 left = path.met ? f32::waterLeft(w.extinction, static_cast<float>(path.met->t),
                                                     static_cast<float>(w.level - path.met->at.y))
                                    : glm::vec3(0);
    path.sum += path.weight * shows.body * (glm::vec3(1) - left);
    path.weight *= left;
}

// To the next surface; water that lies before it.
std::optional<WaterMet> advance(const View& v, Path& path, GrassMemory& memory) {
    path.met = meet(v, path.ray, memory);
    return v.water.enters(path.ray, path.met ? path.met->t : std::numeric_limits<double>::infinity());
}

// Light along a path that has come to its first surface that is not water. It takes one way at water, by chance.
glm::vec3 follow(const View& v, Path path, Dice& dice, GrassMemory& memory) {
    glm::vec3 &sum = path.sum, &weight = path.weight;
    for (int bounce = 0; bounce < kMostBounces; ++bounce) {
        const std::optional<Surface>& s = path.met;
        if (!s) return sum + weight * background(v, path.ray.way, bounce == 0 && path.seesSun);
        const glm::vec3 toEye(-path.ray.way);
        sum += weight * directLight(v, *s, toEye, dice, memory);
        if (v.settings.lighting == ReferenceLighting::Direct) return sum + weight * ambientLight(v, *s);
        const Bounce next = bounceOff(*s, toEye, dice);
        if (glm::dot(s->face, next.towards) * glm::dot(s->normal, next.towards) <= 0)
            return sum;  // a smooth normal's part below the surface
        weight *= next.weight;
        if (bounce > 0) {
            const float goesOn = std::clamp(std::max({next.weight.x, next.weight.y, next.weight.z}), 0.02f, 0.95f);
            if (dice.unit() >= goesOn) return sum;
            weight /= goesOn;
        }
        path.ray = leave(*s, next.towards, std::numeric_limits<double>::infinity(), dice);
        if (const auto water = advance(v, path, memory)) {
            const WaterShows shows = waterShows(v, *water, path.ray, dice, memory);
            sum += weight * shows.glint;
            leaveWater(v, path, *water, shows, dice.unit() < water->mirror, dice, memory);
        }
    }
    return sum;
}

// Light along a ray from the eye. firstMet: what it meets first, if anything. At water that the eye sees it goes both
// ways: by chance, a pixel of few rays would be sky or ground.
glm::vec3 radiance(const View& v, const Ray& ray, Dice& dice, GrassMemory& memory, std::optional<Surface>& firstMet) {
    Path path{ray};
    const std::optional<WaterMet> water = advance(v, path, memory);
    firstMet = path.met;
    if (!water) return follow(v, path, dice, memory);
    firstMet.emplace();
    firstMet->met = Met::Water;
    firstMet->at = water->at, firstMet->t = water->t;
    const WaterShows shows = waterShows(v, *water, ray, dice, memory);
    glm::vec3 light = shows.glint;
    for (const bool back : {true, false}) {
        Path way{ray};
        way.weight = glm::vec3(back ? water->mirror : 1 - water->mirror);
        leaveWater(v, way, *water, shows, back, dice, memory);
        light += follow(v, way, dice, memory);
    }
    return light;
}

glm::vec3 inHaze(const View& v, const glm::vec3& light, const Surface& s) {
    const glm::dvec3 way = s.at - v.eye;
    const double distance = glm::length(way);
    const float share = f32::hazeTaken(v.globals.haze, static_cast<float>(distance));
    return glm::mix(light, hazeOf(v, way, distance), share);
}

// From the near plane on, through (x, y) in pixels from the top left.
Ray eyeRay(const View& v, double x, double y, uint32_t grain) {
    const glm::dvec4 near = v.toWorld * glm::dvec4(2 * x / v.settings.width - 1, 1 - 2 * y / v.settings.height, 1, 1);
    const glm::dvec3 at = glm::dvec3(near) / near.w;
    const double distance = glm::length(at);
    return {v.eye, at / distance, distance, std::numeric_limits<double>::infinity(), grain};
}

// Sums over a pixel's samples.
struct Sums {
    glm::dvec3 light{0}, squares{0};
    int grass = 0;
};
// Cancelled, it ends after the sample that it is at: one of deep grass may take a tenth of a second.
Sums samplePixel(const View& v, int x, int y, GrassMemory& memory, const JobControl& control) {
    Sums sums;
    const uint32_t pixel = f32::hash3(static_cast<uint32_t>(x), static_cast<uint32_t>(y), v.settings.seed);
    for (int i = 0; i < v.settings.samples && !control.cancelled(); ++i) {
        Dice dice{pixel, static_cast<uint32_t>(i)};
        const double dx = static_cast<double>(dice.unit()), dy = static_cast<double>(dice.unit());
        std::optional<Surface> met;
        glm::vec3 light = radiance(v, eyeRay(v, x + dx, y + dy, dice.grain()), dice, memory, met);
        if (met && v.hasHaze) light = inHaze(v, light, *met);
        const glm::dvec3 l(glm::clamp(light, glm::vec3(0), glm::vec3(kBrightest)));
        sums.light += l, sums.squares += l * l;
        sums.grass += met && (met->met == Met::Blade || met->ofTree);
    }
    return sums;
}

void writePixel(Truth& t, size_t i, const Sums& s, int samples) {
    const double n = samples;
    const glm::dvec3 mean = s.light / n, spread = glm::max(s.squares / n - mean * mean, glm::dvec3(0));
    for (int c = 0; c < 3; ++c) {
        t.color[3 * i + static_cast<size_t>(c)] = static_cast<float>(mean[c]);
        t.error[3 * i + static_cast<size_t>(c)] =
            samples > 1 ? static_cast<float>(std::sqrt(spread[c] / (n - 1))) : std::numeric_limits<float>::infinity();
    }
    t.grass[i] = static_cast<float>(s.grass / n);
}

// Memories for as many threads as ask at once.
struct MemoryPool {
    std::mutex mutex;
    std::vector<std::unique_ptr<GrassMemory>> free;
    std::unique_ptr<GrassMemory> take() {
        std::lock_guard lock(mutex);
        if (free.empty()) return std::make_unique<GrassMemory>();
        auto m = std::move(free.back());
        free.pop_back();
        return m;
    }
    void give(std::unique_ptr<GrassMemory> m) {
        std::lock_guard lock(mutex);
        free.push_back(std::move(m));
    }
};

Status checkSettings(const ReferenceSettings& s) {
    if (s.samples < 1 || s.samples > kMaxReferenceSamples)
        return usage(fmt::format("{} samples a pixel make no picture", s.samples),
                     fmt::format("1 to {}", kMaxReferenceSamples));
    if (s.width < 1 || s.height < 1 || int64_t(s.width) * s.height > kMaxReferencePixels)
        return usage(fmt::format("{}x{} pixels make no reference", s.width, s.height),
                     "at least 1x1, at most 2^26 pixels, such as 8192x8192");
    if (s.shards < 1 || s.shard < 0 || s.shard >= s.shards)
        return usage(fmt::format("there is no shard {} of {}", s.shard, s.shards), "write I/N, I from 0 to N-1");
    if (s.bandRows < 1 || s.bandRows > kShardRows)
        return usage(fmt::format("bands of {} rows are none", s.bandRows), fmt::format("1 to {}", kShardRows));
    return {};
}

}  // namespace

ReferenceScene::ReferenceScene(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ReferenceScene::ReferenceScene(ReferenceScene&&) noexcept = default;
ReferenceScene& ReferenceScene::operator=(ReferenceScene&&) noexcept = default;
ReferenceScene::~ReferenceScene() = default;

Result<ReferenceScene> ReferenceScene::make(const Project& p, const Tables& tables, double time,
                                            const JobControl& control) {
    auto impl = std::make_unique<Impl>();
    DrawnProject drawn;
    impl->project = snapshot(drawn.of(p, tables.components), tables.components);
    impl->features = sceneFeatures(impl->project.registry, tables);
    impl->time = time;
    auto solids = Solids::make(impl->project, time, control);
    if (!solids) return solids.error();
    impl->solids.emplace(std::move(*solids));
    auto grass = GrassRays::make(impl->project, time, control);
    if (!grass) return grass.error();
    impl->grass.emplace(std::move(*grass));
    auto meshBlades = MeshBlades::make(impl->project, time, control);
    if (!meshBlades) return meshBlades.error();
    impl->meshBlades.emplace(std::move(*meshBlades));
    auto flowers = FlowerRays::make(impl->project, time, control);
    if (!flowers) return flowers.error();
    impl->flowers.emplace(std::move(*flowers));
    return ReferenceScene(std::move(impl));
}

Result<Truth> ReferenceScene::trace(const ViewCamera& camera, const ReferenceSettings& settings,
                                    JobControl& control) const {
    if (Status s = checkSettings(settings); !s) return s.error();
    const View view = viewFrom(*impl_, camera, settings);
    const size_t pixels = static_cast<size_t>(settings.width) * static_cast<size_t>(settings.height);
    Truth truth{settings.width, settings.height, std::vector<float>(3 * pixels), std::vector<float>(3 * pixels),
                std::vector<float>(pixels)};
    const int across = (settings.width + kBlockWidth - 1) / kBlockWidth, high = settings.bandRows,
              down = (settings.height + high - 1) / high;
    MemoryPool memories;
    std::atomic<size_t> done{0};
    parallelFor(static_cast<size_t>(across) * static_cast<size_t>(down), [&](size_t block) {
        const int x0 = static_cast<int>(block) % across * kBlockWidth, y0 = static_cast<int>(block) / across * high;
        if (control.cancelled() || !isOfShard(y0, settings)) return;
        auto memory = memories.take();
        for (int y = y0; y < std::min(y0 + high, settings.height); ++y)
            for (int x = x0; x < std::min(x0 + kBlockWidth, settings.width); ++x) {
                writePixel(truth, static_cast<size_t>(y) * static_cast<size_t>(settings.width) + static_cast<size_t>(x),
                           samplePixel(view, x, y, *memory, control), settings.samples);
                control.setProgress(static_cast<double>(++done) * settings.shards / static_cast<double>(pixels));
            }
        memories.give(std::move(memory));
    });
    if (control.cancelled()) return failed("cancelled");
    return truth;
}

}  // namespace sward
