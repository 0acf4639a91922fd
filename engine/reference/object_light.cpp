#include "reference/object_light.h"

#include <chrono>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <thread>

#include "core/cache_file.h"
#include "core/file.h"
#include "core/hash.h"
#include "core/log.h"
#include "core/numerics.h"
#include "frame/object_light.h"
#include "mesh/mesh_io.h"
#include "reference/hemisphere.h"
#include "reference/solids.h"
#include "reference/vertex_fit.h"
#include "scene/forest.h"
#include "scene/technique.h"
#include "shared/objects.h"
#include "sky/air_tables.h"
#include "sky/daylight.h"
#include "world/forest_stand.h"
#include "world/land.h"
#include "world/lights.h"
#include "world/scatter.h"

namespace sward {
namespace {

constexpr uint32_t kVersion = 5;  // of the method: another one finds other light
constexpr int kWays = 64;         // from a point, over the whole sphere
constexpr int kBounces = 3;
constexpr double kPerM2 = 80;  // points; from one for two vertices of a mesh to two for each, and at least kFewest
constexpr size_t kFewest = 1024;
constexpr float kUnreached = 0.05f;  // what a point counts that no light reaches
constexpr double kOff = 2e-3;        // metres by which rays start off a surface

// Directions spread evenly over the sphere, along a spiral of golden angles that begins by chance.
glm::vec3 wayOf(int i, float up, float turned) {
    const float y = 1 - 2 * (static_cast<float>(i) + up) / kWays, r = std::sqrt(std::max(1 - y * y, 0.0f));
    const float turn = f32::kTau * (0.6180339887f * static_cast<float>(i) + turned);
    return {r * std::cos(turn), y, r * std::sin(turn)};
}

}  // namespace

struct AroundTracer::Impl {
    Project project;  // without wind, which would lean trees as it happens to blow
    std::optional<Solids> solids;
    FrameGlobals globals{};
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
    // Adds what comes along a ray.
    void follow(AroundFactors& sum, glm::vec3 weight, Ray ray, uint32_t seed) const {
        for (uint32_t bounce = 0; bounce < kBounces; ++bounce) {
            const std::optional<Surface> s = solids->closest(ray);
            if (!s) return addBackground(sum, weight, glm::vec3(ray.way));
            weight *= sentBy(*s);
            addSun(sum, weight, *s);
            const uint32_t h = f32::hash2(seed, bounce);
            const glm::vec3 on =
                cosineAround(s->normal, f32::hashUnit(f32::hash2(h, 0)), f32::hashUnit(f32::hash2(h, 1)));
            if (glm::dot(on, s->face) <= 0) return;
            ray = {s->at + glm::dvec3(s->face) * kOff, glm::normalize(glm::dvec3(on))};
            ray.grain = h;
        }
    }
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
    const FeatureSet features = sceneFeatures(p.registry, tables);
    impl->hasSun = has(features, Feature::Sun), impl->hasSky = has(features, Feature::Sky);
    impl->globals.exposure = 1;
    if (impl->hasSun) addSun(impl->globals, p, seconds);
    if (has(features, Feature::Fog)) addHaze(impl->globals, p);
    if (has(features, Feature::Atmosphere)) addAir(impl->globals, p, seconds, impl->air.emplace());
    SkySums sums;
    if (impl->hasSky) addSky(impl->globals, p, seconds, sums, impl->air ? &*impl->air : nullptr);
    if (impl->hasSky) impl->sky = f32::skyModel(impl->globals.skySun, impl->globals.turbidity);
    for (const auto& [name, field] : fieldsOf(impl->project)) impl->fields.push_back(&field.grows);
    return AroundTracer(std::move(impl));
}

AroundFactors AroundTracer::at(const glm::dvec3& position, const glm::vec3& n, uint32_t seed) const {
    AroundFactors sum;
    const float up = f32::hashUnit(f32::hash2(seed, 0xa1u)), turned = f32::hashUnit(f32::hash2(seed, 0xa2u));
    for (int i = 0; i < kWays; ++i) {
        const glm::vec3 way = wayOf(i, up, turned);
        const float cosine = glm::dot(n, way);
        if (!(cosine > 0)) continue;
        const uint32_t h = f32::hash2(seed, static_cast<uint32_t>(i));
        Ray ray{position + glm::dvec3(n) * kOff, glm::normalize(glm::dvec3(way))};
        ray.grain = h;
        impl_->follow(sum, glm::vec3(4 * cosine / kWays), ray, h);
    }
    return sum;
}

namespace {

bool isLit(const Project& p, const PlacedMesh& m) {
    return m.mesh->bakeLight == BakeLight::Traced && !p.registry.get<Rolling>(m.entity);
}

// A copy of the project may number its entities otherwise.
void setEntities(const Project& p, std::vector<TracedObject>& objects) {
    size_t i = 0;
    for (const PlacedMesh& m : placedMeshes(p))
        if (isLit(p, m) && i < objects.size()) objects[i++].entity = m.entity;
}

bool isInGround(const Ground& ground, const glm::dvec3& at) {
    return ground.terrain && at.y < terrainHeight(*ground.terrain, at.x, at.z);
}

size_t pointsOf(const Mesh& mesh, double scale) {
    const auto asked = static_cast<size_t>(std::min(surfaceArea(mesh) * scale * scale * kPerM2, 1e9));
    return std::max(std::clamp(asked, mesh.vertices.size() / 2, 2 * mesh.vertices.size()), kFewest);
}

glm::vec3 mixedAt(const Mesh& mesh, const SurfacePoint& p, glm::vec3 MeshVertex::*member) {
    glm::vec3 sum(0);
    for (uint32_t k = 0; k < 3; ++k)
        sum += p.weights[static_cast<int>(k)] * (mesh.vertices[mesh.indices[p.triangle + k]].*member);
    return sum;
}

FittedRow rowOf(const AroundFactors& f) {
    return {f.sky.x, f.sky.y, f.sky.z, f.sun.x, f.sun.y, f.sun.z, f.ground.x, f.ground.y, f.ground.z};
}
AroundFactors factorsOf(const FittedRow& r) {
    return {glm::max(glm::vec3(r[0], r[1], r[2]), glm::vec3(0)), glm::max(glm::vec3(r[3], r[4], r[5]), glm::vec3(0)),
            glm::max(glm::vec3(r[6], r[7], r[8]), glm::vec3(0))};
}

// What lies in the ground is not seen, and says nothing of what does not; what no light reaches most likely lies in
// another part of the mesh, as a branch does in its trunk, and says little.
void lightVertices(const AroundTracer& tracer, const Ground& ground, const PlacedMesh& m, const Mesh& mesh,
                   const JobControl& control, std::vector<AroundFactors>& out) {
    const auto scale = static_cast<double>(m.mesh->scale);
    const auto placeOf = [&](const SurfacePoint& p) {
        return m.at - ground.origin + m.turn * (scale * glm::dvec3(mixedAt(mesh, p, &MeshVertex::position)));
    };
    std::vector<SurfacePoint> points = pointsOver(mesh, pointsOf(mesh, scale), kVersion);
    std::erase_if(points, [&](const SurfacePoint& p) { return isInGround(ground, placeOf(p)); });
    std::vector<FittedRow> found(points.size());
    parallelFor(points.size(), [&](size_t i) {
        if (control.cancelled()) return;
        const glm::dvec3 n = m.turn * glm::dvec3(mixedAt(mesh, points[i], &MeshVertex::normal));
        found[i] = rowOf(tracer.at(placeOf(points[i]), glm::vec3(glm::normalize(n)), static_cast<uint32_t>(i)));
        if (found[i] == FittedRow{}) points[i].counts = kUnreached;
    });
    const std::vector<FittedRow> rows = fitVertices(mesh, points, found);
    for (size_t i = 0; i < out.size(); ++i) out[i] = factorsOf(rows[i]);
}

// --- the file of the cache: of each object the number of its vertices, and their factors; last a hash of all that
std::filesystem::path cacheFile(uint64_t key) { return cacheDir() / "objects" / (hashHex(key) + ".light"); }

void keep(uint64_t key, const std::vector<TracedObject>& objects) {
    std::string bytes;
    for (const TracedObject& o : objects) {
        const uint64_t count = o.vertices.size();
        bytes.append(reinterpret_cast<const char*>(&count), sizeof(count));
        bytes.append(reinterpret_cast<const char*>(o.vertices.data()), count * sizeof(AroundFactors));
    }
    const uint64_t sum = hashBytes(bytes.data(), bytes.size());
    bytes.append(reinterpret_cast<const char*>(&sum), sizeof(sum));
    writeCached(cacheFile(key), "light of objects", bytes);
}

std::optional<std::vector<TracedObject>> parse(const std::string& bytes, std::string& wrong) {
    uint64_t sum;
    if (bytes.size() < sizeof(sum)) return wrong = "it is truncated", std::nullopt;
    const size_t end = bytes.size() - sizeof(sum);
    std::memcpy(&sum, bytes.data() + end, sizeof(sum));
    if (sum != hashBytes(bytes.data(), end)) return wrong = "it is damaged", std::nullopt;
    std::vector<TracedObject> out;
    for (size_t at = 0; at < end;) {
        uint64_t count = 0;
        if (end - at < sizeof(count)) return wrong = "it is damaged", std::nullopt;
        std::memcpy(&count, bytes.data() + at, sizeof(count)), at += sizeof(count);
        if (count > (end - at) / sizeof(AroundFactors)) return wrong = "it is damaged", std::nullopt;
        out.emplace_back().vertices.resize(count);
        std::memcpy(out.back().vertices.data(), bytes.data() + at, count * sizeof(AroundFactors));
        at += count * sizeof(AroundFactors);
    }
    return out;
}

// --- what the light hangs on ---------------------------------------------------------------------------------------
// Compared each frame: what is quickly told apart.
struct LitBy {
    struct Thing {
        Entity entity;
        std::string version;  // of its file
        glm::dvec3 at;
        glm::dmat3 turn;
        float scale;
        bool lit, casts;
        bool operator==(const Thing&) const = default;
    };
    std::vector<Thing> things;
    std::vector<Map> maps;  // of the ground and of what grows on it
    std::vector<Forest> forests;
    uint64_t rest = 0;  // hash of all else
    bool operator==(const LitBy& o) const {
        const auto sameMap = [](const Map& a, const Map& b) { return a.sameTiles(b); };
        return rest == o.rest && things == o.things &&
               std::equal(forests.begin(), forests.end(), o.forests.begin(), o.forests.end(), sameForest) &&
               std::equal(maps.begin(), maps.end(), o.maps.begin(), o.maps.end(), sameMap);
    }
};

class Adding {
  public:
    template <class T>
    void operator()(const T& value) {
        h_.add(&value, sizeof(value));
    }
    void text(const std::string& t) { h_.add(t.data(), t.size()); }
    uint64_t value() const { return h_.value(); }

  private:
    Hasher h_;
};

void addTerrain(const Project& p, const Ground& ground, Adding& add, std::vector<Map>& maps) {
    const Terrain* t = ground.terrain;
    if (!t) return;
    add(t->size), add(t->heightRange), add(ground.origin), add(t->heightTiling), add(t->terrainMapTiling);
    add(t->mapSize), add(t->tileSize), add(t->groundColor), add(t->castShadows), add(t->beyond);
    add.text(t->groundTexture.empty() ? "" : fileVersion(p.dir, t->groundTexture));
    maps.push_back(t->height.map), maps.push_back(t->terrainMap.map);
}
void addFields(const Project& p, Adding& add, std::vector<Map>& maps) {
    for (const auto& [name, field] : fieldsOf(p)) {
        if (!field.grows.onTerrain) continue;
        add(field.grows.vegetationTiling);
        maps.push_back(field.grows.vegetation.map);
        for (const Species& s : field.grows.species) {
            add(s.densityTiling), add(s.bladesPerM2), add(s.height), add(s.width);
            add(s.rootColor), add(s.midColor), add(s.tipColor);
            maps.push_back(s.density.map);
        }
    }
}
void addLight(const Project& p, double seconds, Adding& add) {
    if (const Light* sun = sunLight(p)) {
        // A sun that moves is followed in steps of a degree.
        add(glm::ivec3(glm::round(directionTo(*sun, seconds) * 57.3f))), add(sun->castShadows), add(shines(*sun));
    }
    if (const Sky* sky = firstOf<Sky>(p)) add(sky->model), add(sky->turbidity), add(sky->intensity > 0);
}

LitBy litBy(const Project& p, double seconds, ScatterMemory& scatters) {
    LitBy by;
    Adding add;
    const Ground ground = findGround(p);
    for (const PlacedMesh& m : placedMeshes(p))
        by.things.push_back({m.entity, fileVersion(p.dir, m.mesh->file), m.at, m.turn, m.mesh->scale, isLit(p, m),
                             m.mesh->castShadows});
    addTerrain(p, ground, add, by.maps);
    addFields(p, add, by.maps);
    for (const auto& [name, scatter] : scattersOf(p)) add(scatters.of(p, ground, name, *scatter)->hash);
    for (const auto& [name, forest] : forestsOf(p)) by.forests.push_back(*forest);
    addLight(p, seconds, add);
    by.rest = add.value();
    return by;
}
// Names it by content, over runs of the program.
uint64_t keyOf(const Project& p, const LitBy& by) {
    Adding add;
    add(kVersion), add(by.rest), add(sceneTrianglesHash(p));
    for (const LitBy::Thing& t : by.things) {
        add.text(t.version);
        add(t.at), add(t.turn), add(t.scale), add(t.lit), add(t.casts);
    }
    for (const Map& m : by.maps) add(m.info().width > 0 ? m.hash() : uint64_t{0});
    return add.value();
}

// --- the effect
struct LightState : EffectState {
    ObjectLight shown;
    ScatterMemory scatters;
    std::vector<TracedObject> traced;
    std::optional<LitBy> of;      // what `traced` is of
    std::optional<LitBy> wanted;  // what the job makes
    uint64_t wantedNumber = 0;    // counts what was wanted
    Job<std::vector<TracedObject>> bake;
    glm::vec3 sky{-1}, sun{-1}, ground{-1};  // by which the vertices are lit
    void jobs(std::vector<JobNews>& out) const override {
        if (bake.active()) out.push_back(bake.news());
    }
};

// From the cache folder, or traced and kept there.
Result<std::vector<TracedObject>> objectLight(const Project& p, const Tables& tables, double seconds, const LitBy& by,
                                              JobControl& control) {
    const uint64_t key = keyOf(p, by);
    if (auto kept = loadCached(cacheFile(key), uint64_t{1} << 30, "light of objects", parse)) return *kept;
    auto traced = traceObjectLight(p, tables, seconds, control);
    if (traced) keep(key, *traced);
    return traced;
}

void take(const Project& p, LightState& s, LitBy by, Result<std::vector<TracedObject>> made) {
    if (!made) logWarning("light around objects is missing: " + made.error().text());
    s.traced = made ? std::move(*made) : std::vector<TracedObject>{};
    setEntities(p, s.traced);
    s.of = std::move(by);  // what failed is not tried again until something is changed
    s.sky = glm::vec3(-1);
}

// Waits until nothing has changed for a while: during a stroke each frame asks anew. False: something has.
bool isSettled(const JobControl& control) {
    for (int i = 0; i < 20 && !control.cancelled(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(25));
    return !control.cancelled();
}

// Where one may wait, waits; else traces beside.
void update(DrawContext& ctx, LightState& s) {
    LitBy by = litBy(ctx.project, ctx.settings.time, s.scatters);
    if (s.of && *s.of == by) return;
    if (ctx.sketching()) return;
    const double seconds = ctx.settings.time;
    if (!ctx.settings.background) {
        JobControl control;
        auto made = objectLight(ctx.project, ctx.tables, seconds, by, control);
        return take(ctx.project, s, std::move(by), std::move(made));
    }
    if (!s.wanted || !(*s.wanted == by)) s.bake = {}, s.wanted = by, ++s.wantedNumber;
    if (auto made = s.bake.take(s.wantedNumber)) return take(ctx.project, s, std::move(by), std::move(*made));
    if (s.bake.active()) return;
    const auto copy = std::make_shared<Project>(snapshot(ctx.project, ctx.tables.components));
    s.bake = Job<std::vector<TracedObject>>(
        "light around objects", s.wantedNumber,
        [copy, tables = &ctx.tables, seconds, by = std::move(by)](JobControl& c) -> Result<std::vector<TracedObject>> {
            if (!isSettled(c)) return failed("cancelled");
            return objectLight(*copy, *tables, seconds, by, c);
        });
}

// Under the frame's own lights.
void upload(DrawContext& ctx, LightState& s) {
    const FrameGlobals& g = ctx.globals;
    if (s.sky == g.skyLight && s.sun == g.sunLight && s.ground == g.groundLight) return;
    s.sky = g.skyLight, s.sun = g.sunLight, s.ground = g.groundLight;
    s.shown.first.clear();
    std::vector<glm::uvec2> packed;
    for (const TracedObject& o : s.traced) {
        if (o.vertices.empty()) continue;
        s.shown.first[o.entity.index] = static_cast<uint32_t>(packed.size());
        for (const AroundFactors& f : o.vertices) {
            const glm::vec3 light = glm::min(f.sky * s.sky + f.sun * s.sun + f.ground * s.ground, glm::vec3(65504.0f));
            packed.push_back({glm::packHalf2x16({light.x, light.y}), glm::packHalf2x16({light.z, 0})});
        }
    }
    writeBuffer(ctx.gpu, s.shown.vertices, "objects/light", packed.size() * sizeof(glm::uvec2), packed.data());
}

void run(DrawContext& ctx) {
    LightState& s = ctx.own<LightState>();
    update(ctx, s);
    upload(ctx, s);
    ctx.shared.objectLight = &s.shown;
}

const System kSystems[] = {
    {"objects/light", {.reads = {Slot::Sun, Slot::SkyLight, Slot::Ground}, .writes = {Slot::ObjectLight}}, run, true}};

}  // namespace

Result<std::vector<TracedObject>> traceObjectLight(const Project& p, const Tables& tables, double seconds,
                                                   JobControl& control) {
    const auto tracer = AroundTracer::make(p, tables, seconds, control);
    if (!tracer) return tracer.error();
    const Ground ground = findGround(p);
    std::map<std::string, Mesh> meshes;
    std::vector<TracedObject> out;
    std::vector<PlacedMesh> placed;
    for (const PlacedMesh& m : placedMeshes(p)) {
        if (!isLit(p, m)) continue;
        Result<Mesh> mesh = meshes.contains(m.mesh->file) ? Mesh{} : readMesh(p.dir, m.mesh->file);
        if (!mesh) return mesh.error();
        const Mesh& of = meshes.try_emplace(m.mesh->file, std::move(*mesh)).first->second;
        TracedObject& o = out.emplace_back();
        o.vertices.resize(of.vertices.size() <= kMostLitVertices ? of.vertices.size() : 0);
        placed.push_back(m);
    }
    setEntities(p, out);
    for (size_t i = 0; i < out.size(); ++i) {
        if (!out[i].vertices.empty())
            lightVertices(*tracer, ground, placed[i], meshes.at(placed[i].mesh->file), control, out[i].vertices);
        control.setProgress(static_cast<double>(i + 1) / static_cast<double>(out.size()));
        if (control.cancelled()) return failed("cancelled");
    }
    return out;
}

const EffectRow& objectLightEffect() {
    static const EffectRow row{
        .name = "objects/light",
        .needs = featureSet(Feature::Objects, Feature::ObjectLight),
        .systems = kSystems,
        .makeState = [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<LightState>(); },
        .help = "light from all around objects"};
    return row;
}

}  // namespace sward
