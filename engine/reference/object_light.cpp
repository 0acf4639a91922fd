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
#include "reference/scene_rays.h"
#include "reference/vertex_fit.h"
#include "scene/forest.h"
#include "scene/technique.h"
#include "shared/objects.h"
#include "world/forest_stand.h"
#include "world/lights.h"
#include "world/scatter.h"

namespace sward {
namespace {

constexpr const char* kOwner = "objects/light";
constexpr uint32_t kAroundVersion = 12;  // of the method: another one finds other light
constexpr double kPerM2 = 80;            // points; from one for two vertices of a mesh to two for each,
constexpr size_t kFewest = 1024;         // and at least so many
constexpr uint32_t kSeed = 1;            // of the points
constexpr float kUnreached = 0.01f;      // what a point counts that no light reaches
constexpr double kGroundsShare = 0.2;    // of the progress

// A copy of the project may number its entities otherwise.
void setEntities(const Project& p, std::vector<TracedObject>& objects) {
    size_t i = 0;
    for (const PlacedMesh& m : placedMeshes(p))
        if (hasTracedLight(p, m) && i < objects.size()) objects[i++].entity = m.entity;
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
    std::vector<SurfacePoint> points = pointsOver(mesh, pointsOf(mesh, scale), kSeed);
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

// --- the file of the cache: how many objects, of each the number of its vertices and their factors; then squares of
// the ground, with their points' factors; last a hash of all that
std::filesystem::path cacheFile(uint64_t key) { return cacheDir() / "objects" / (hashHex(key) + ".light"); }

template <class T>
void put(std::string& bytes, const T* values, size_t count = 1) {
    bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

void keep(uint64_t key, const TracedAround& light) {
    std::string bytes;
    const uint64_t objects = light.objects.size();
    put(bytes, &objects);
    for (const TracedObject& o : light.objects) {
        const uint64_t count = o.vertices.size();
        put(bytes, &count), put(bytes, o.vertices.data(), count);
    }
    for (const GroundTile& t : light.ground)
        put(bytes, &t.cell), put(bytes, &t.side), put(bytes, t.change.data(), t.change.size());
    const uint64_t sum = hashBytes(bytes.data(), bytes.size());
    put(bytes, &sum);
    writeCached(cacheFile(key), "light of objects", bytes);
}

// Reads what put() has written; `fits` ends where something is missing.
struct AroundReading {
    std::string_view rest;
    bool fits = true;
    template <class T>
    void get(T* values, size_t count = 1) {
        fits = fits && count <= rest.size() / sizeof(T);
        if (!fits || count == 0) return;
        std::memcpy(values, rest.data(), count * sizeof(T));
        rest.remove_prefix(count * sizeof(T));
    }
    void get(std::vector<AroundFactors>& out, uint64_t count) {
        fits = fits && count <= rest.size() / sizeof(AroundFactors);
        if (fits) out.resize(count), get(out.data(), count);
    }
};

std::optional<TracedAround> parseAround(const std::string& bytes, std::string& wrong) {
    uint64_t sum, objects = 0;
    if (bytes.size() < sizeof(sum)) return wrong = "it is truncated", std::nullopt;
    const size_t end = bytes.size() - sizeof(sum);
    std::memcpy(&sum, bytes.data() + end, sizeof(sum));
    if (sum != hashBytes(bytes.data(), end)) return wrong = "it is damaged", std::nullopt;
    TracedAround out;
    AroundReading from{std::string_view(bytes).substr(0, end)};
    for (from.get(&objects); from.fits && objects > 0; --objects) {
        uint64_t count = 0;
        from.get(&count), from.get(out.objects.emplace_back().vertices, count);
    }
    while (from.fits && !from.rest.empty()) {
        GroundTile& t = out.ground.emplace_back();
        from.get(&t.cell), from.get(&t.side);
        from.fits = from.fits && t.side >= 2 && t.side <= AROUND_SIDE;
        from.get(t.change, static_cast<uint64_t>(t.side) * static_cast<uint64_t>(t.side));
    }
    if (!from.fits) return wrong = "it is damaged", std::nullopt;
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
        by.things.push_back({m.entity, fileVersion(p.dir, m.mesh->file), m.at, m.turn, m.mesh->scale,
                             hasTracedLight(p, m), m.mesh->castShadows});
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
    add(kAroundVersion), add(by.rest), add(sceneTrianglesHash(p));
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
    TracedAround traced;
    std::optional<LitBy> of;      // what `traced` is of
    std::optional<LitBy> wanted;  // what the job makes
    uint64_t wantedNumber = 0;    // counts what was wanted
    Job<TracedAround> bake;
    std::optional<AroundLights> by;  // what `shown` is lit by
    void jobs(std::vector<JobNews>& out) const override {
        if (bake.active()) out.push_back(bake.news());
    }
};

// From the cache folder, or traced and kept there.
Result<TracedAround> objectLight(const Project& p, const Tables& tables, double seconds, const LitBy& by,
                                 JobControl& control) {
    const uint64_t key = keyOf(p, by);
    if (auto kept = loadCached(cacheFile(key), uint64_t{1} << 30, "light of objects", parseAround))
        return std::move(*kept);
    auto traced = traceObjectLight(p, tables, seconds, control);
    if (traced) keep(key, *traced);
    return traced;
}

void take(const Project& p, LightState& s, LitBy by, Result<TracedAround> made) {
    if (!made) logWarning("light around objects is missing: " + made.error().text());
    s.traced = made ? std::move(*made) : TracedAround{};
    setEntities(p, s.traced.objects);
    s.of = std::move(by);  // what failed is not tried again until something is changed
    s.by.reset();
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
    s.bake = Job<TracedAround>(
        "light around objects", s.wantedNumber,
        [copy, tables = &ctx.tables, seconds, by = std::move(by)](JobControl& c) -> Result<TracedAround> {
            if (!isSettled(c)) return failed("cancelled");
            return objectLight(*copy, *tables, seconds, by, c);
        });
}

void uploadVertices(DrawContext& ctx, LightState& s) {
    s.shown.first.clear();
    std::vector<glm::uvec2> packed;
    for (const TracedObject& o : s.traced.objects) {
        if (o.vertices.empty()) continue;
        s.shown.first[o.entity.index] = static_cast<uint32_t>(packed.size());
        for (const AroundFactors& f : o.vertices) {
            const glm::vec3 light = glm::min(lightBy(f, *s.by), glm::vec3(65504.0f));
            packed.push_back({glm::packHalf2x16({light.x, light.y}), glm::packHalf2x16({light.z, 0})});
        }
    }
    writeBuffer(ctx.gpu, s.shown.vertices, kOwner, packed.size() * sizeof(glm::uvec2), packed.data());
}

void write(Gpu& gpu, Texture& texture, GLenum format, glm::ivec2 size, GLenum channels, GLenum type, const void* data) {
    if (texture.width != size.x || texture.height != size.y) {
        texture = {};
        if (size.y > 0) texture = makeTexture2D(gpu, kOwner, format, size.x, size.y);
    }
    if (texture.id()) glTextureSubImage2D(texture.id(), 0, 0, 0, size.x, size.y, channels, type, data);
}

void uploadGround(DrawContext& ctx, LightState& s) {
    const PackedGround p = packGround(s.traced.ground, *s.by);
    const auto rows = [](size_t texels, int width) { return static_cast<int>(texels / static_cast<size_t>(width)); };
    write(ctx.gpu, s.shown.ground, GL_RGBA16F,
          {AROUND_ACROSS * AROUND_SIDE, rows(p.share.size(), AROUND_ACROSS * AROUND_SIDE)}, GL_RGBA, GL_FLOAT,
          p.share.data());
    write(ctx.gpu, s.shown.cells, GL_RG32UI, {AROUND_TABLE, rows(p.table.size(), AROUND_TABLE)}, GL_RG_INTEGER,
          GL_UNSIGNED_INT, p.table.data());
    if (s.shown.cells.id()) glTextureParameteri(s.shown.cells.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    if (s.shown.cells.id()) glTextureParameteri(s.shown.cells.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    s.shown.from = p.from, s.shown.to = p.to, s.shown.slots = static_cast<uint32_t>(p.table.size());
}

// Under the frame's own lights.
void upload(DrawContext& ctx, LightState& s) {
    const FrameGlobals& g = ctx.globals;
    const AroundLights by{g.skyLight, g.sunLight, g.groundLight};
    if (s.by == by) return;
    s.by = by;
    uploadVertices(ctx, s);
    uploadGround(ctx, s);
}

void traceObjects(DrawContext& ctx) {
    LightState& s = ctx.own<LightState>();
    update(ctx, s);
    upload(ctx, s);
    ctx.shared.objectLight = &s.shown;
    ctx.globals.aroundFrom = s.shown.from, ctx.globals.aroundTo = s.shown.to, ctx.globals.aroundSlots = s.shown.slots;
    // For the whole frame: nothing else uses the bindings.
    glBindTextureUnit(TEX_AROUND, s.shown.ground.id());
    glBindTextureUnit(TEX_AROUND_CELLS, s.shown.cells.id());
}

const System kSystems[] = {
    {kOwner, {.reads = {Slot::Sun, Slot::SkyLight, Slot::Ground}, .writes = {Slot::ObjectLight}}, traceObjects, true}};

}  // namespace

Result<TracedAround> traceObjectLight(const Project& p, const Tables& tables, double seconds, JobControl& control) {
    const auto tracer = AroundTracer::make(p, tables, seconds, control);
    if (!tracer) return tracer.error();
    const Ground ground = findGround(p);
    std::map<std::string, Mesh> meshes;
    TracedAround out;
    std::vector<PlacedMesh> placed;
    std::vector<StandingBox> boxes;
    for (const PlacedMesh& m : placedMeshes(p)) {
        if (!hasTracedLight(p, m)) continue;
        Result<Mesh> mesh = meshes.contains(m.mesh->file) ? Mesh{} : readMesh(p.dir, m.mesh->file);
        if (!mesh) return mesh.error();
        const Mesh& of = meshes.try_emplace(m.mesh->file, std::move(*mesh)).first->second;
        TracedObject& o = out.objects.emplace_back();
        o.vertices.resize(of.vertices.size() <= kMostLitVertices ? of.vertices.size() : 0);
        placed.push_back(m);
        boxes.push_back(standingBox(ground, m, of));
    }
    setEntities(p, out.objects);
    for (size_t i = 0; i < placed.size(); ++i) {
        TracedObject& o = out.objects[i];
        if (!o.vertices.empty())
            lightVertices(*tracer, ground, placed[i], meshes.at(placed[i].mesh->file), control, o.vertices);
        control.setProgress((1 - kGroundsShare) * static_cast<double>(i + 1) / static_cast<double>(placed.size()));
        if (control.cancelled()) return failed("cancelled");
    }
    auto around = traceGround(*tracer, p, boxes, control);
    if (!around) return around.error();
    out.ground = std::move(*around);
    return out;
}

const EffectRow& objectLightEffect() {
    static const EffectRow row{
        .name = kOwner,
        .needs = featureSet(Feature::Objects, Feature::ObjectLight),
        .systems = kSystems,
        .makeState = [](DrawContext&) -> std::unique_ptr<EffectState> { return std::make_unique<LightState>(); },
        .help = "light from all around objects, and what they change of it on the ground"};
    return row;
}

}  // namespace sward
