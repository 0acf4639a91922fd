#include "reference/grass_rays.h"

#include <mutex>

#include "core/numerics.h"
#include "grass/cells.h"
#include "grass/field.h"
#include "reference/embree.h"
#include "scene/unique.h"
#include "world/forces.h"
#include "world/wind.h"

namespace sward {
namespace {

constexpr float kLeanStep = 0.2f;    // metres a metre between the mean leans that scenes are made for
constexpr float kSpreadStep = 0.1f;  // ... and between their spreads
constexpr float kAnyLean = 3;        // of blades that are pressed: any way, down to the ground
constexpr float kBump =
    0.005f;  // metres: least class of how far ground leaves the plane through a cell; each next doubles
constexpr int kPrefixes[] = {16, 48, 112, 255};

// A blade as it stands in a cell: relative to the cell's corner and to its base height. width 0: it does not exist
// there.
struct Posed {
    glm::vec3 root, control, tip;
    glm::vec2 facing;
    float width, lighter;
};

// The ground under a cell: a plane through its corner, and how far the ground leaves it.
struct CellGround {
    float slopeX = 0, slopeZ = 0, bump = 0;
    float low = 0, high = 0;  // metres above the corner
};

struct Cell {
    uint64_t key = ~uint64_t(0);
    RTCScene scene = nullptr;  // null: nothing grows
    f32::CellVersion version{glm::vec2(1), glm::vec2(0)};
    double base = 0;     // height of the plane at the cell's corner
    WindGlobals wind{};  // about the cell's corner, as strong as the kind feels it; unused in a calm
    CellGround ground;
    uint32_t first = 0;  // of its blades among the kind's
};
struct Kept {
    uint64_t key = ~uint64_t(0);
    Posed blade;
};
constexpr size_t kCells = 1 << 12, kBlades = 1 << 17;

uint64_t cellKey(int species, int x, int z) {
    return (static_cast<uint64_t>(species) << 40) | (static_cast<uint64_t>(static_cast<uint32_t>(x) & 0xFFFFF) << 20) |
           (static_cast<uint32_t>(z) & 0xFFFFF);
}
size_t slotOf(uint64_t cell) { return static_cast<size_t>((cell * 0x9E3779B97F4A7C15ull) >> 40); }

}  // namespace

struct GrassMemory::Tables {
    std::vector<Cell> cells{kCells};
    std::vector<Kept> blades{kBlades};
};
GrassMemory::GrassMemory() : tables(std::make_unique<Tables>()) {}
GrassMemory::~GrassMemory() = default;

std::pair<glm::vec3, glm::vec3> leaningBounds(const Blade& b, const glm::vec2& lean, float spread, float scale) {
    // poseBlade at scale 1: the tip's reach is own + lean * size, kept within the circle that leaves it a twentieth of
    // height. Moving onto that circle is a contraction, so that a spread of leans stays a disc of the same radius
    // around the mean one's.
    const float size = glm::length(b.tip), radius = spread * size, most = size * 0.99875f;
    const glm::vec2 own(b.tip.x, b.tip.z);
    glm::vec2 reach = own + lean * size;
    if (const float l = glm::length(reach); l > most) reach *= most / l;
    const float near = std::max(glm::length(reach) - radius, 0.0f),
                highest = std::sqrt(std::max(size * size - near * near, 0.0f));
    // The curve lies in the hull of root, control and tip. Nothing of it is below the root.
    const glm::vec2 tip = reach, control = glm::vec2(b.control.x, b.control.z) + 0.5f * (reach - own);
    // The control is moved by half of what the tip is: nothing reaches farther than the longer of both.
    const float farthest =
        std::max(most, glm::length(glm::vec2(b.control.x, b.control.z)) + 0.5f * (most + glm::length(own)));
    const float rise = b.control.y / std::max(b.tip.y, size * 0.05f + 1e-30f);
    const glm::vec2 low = glm::max(glm::min(glm::vec2(0), glm::min(tip, control)) - radius, glm::vec2(-farthest));
    const glm::vec2 high = glm::min(glm::max(glm::vec2(0), glm::max(tip, control)) + radius, glm::vec2(farthest));
    const float top = std::max(highest, std::min(rise * highest, b.control.y + 0.5f * (highest - b.tip.y))),
                side = 0.5f * b.width + 1e-5f;
    return {glm::vec3(low.x, 0, low.y) * (1 + scale) - glm::vec3(side, 1e-5f, side),
            glm::vec3(high.x, top, high.y) * (1 + scale) + glm::vec3(side, 1e-5f, side)};
}

namespace {

// What a scene of boxes is made for: the cell, where cells have blades of their own (else 0); thresholds up to 255ths,
// mean lean, its spread, the ground's bump; in steps.
struct SceneKey {
    uint64_t cell;
    int prefix, leanX, leanZ, spread, bump;
    auto operator<=>(const SceneKey&) const = default;
};
struct BoxScene {
    const Blade* blades;
    glm::vec2 lean;
    float spread, scale, bump;
    ScenePtr scene;
};

// One species: its patch, its looks, and the scenes made so far.
struct Kind {
    const Species* species = nullptr;
    Patch patch;
    UniqueBlades unique;  // empty: cells repeat the patch
    const std::vector<Blade>& blades() const { return unique.empty() ? patch.blades : unique.patch.blades; }
    TexelGrid image;
    Look look;
    float leanAtFull = 0, reach = 0;
    float gust = 0,
          windSlope =
              0;  // lean (m per m) that a full gust gives it, and by how much the wind's may change over a metre
    glm::vec3 clumps{0};
    DevicePtr device;
    mutable std::mutex mutex;
    mutable std::map<SceneKey, BoxScene> scenes;
};

void boundsOf(const RTCBoundsFunctionArguments* a) {
    const BoxScene& s = *static_cast<const BoxScene*>(a->geometryUserPtr);
    const Blade& b = s.blades[a->primID];
    auto [low, high] = leaningBounds(b, s.lean, s.spread, s.scale);
    const glm::vec3 root(b.root.x, 0, b.root.y), bump(0, s.bump, 0);
    low += root - bump, high += root + bump;
    *a->bounds_o = {low.x, low.y, low.z, 0, high.x, high.y, high.z, 0};
}

}  // namespace

struct RayField {
    const Terrain* terrain = nullptr;
    const GrassField* grass = nullptr;
    HeightBounds bounds;
    const Wind* wind = nullptr;  // null: a calm
    const Map* gusts = nullptr;  // its picture of gusts, which may be the one that is made
    Map made;
    double time = 0;
    std::vector<Force> forces;
    std::vector<std::unique_ptr<Kind>> kinds;
};

namespace {

using Memory = GrassMemory::Tables;

// A ray within a cell, as the callbacks of its scene see it. First member: Embree's.
struct Query {
    RayContext context;
    const RayField* field;
    size_t number;  // of the species among the field's kinds
    const Kind* kind;
    Memory* memory;
    const Cell* cell;
    int x, z;
    glm::vec3 origin, way;  // relative to the cell's corner and base height
    uint32_t grain;
    uint32_t blade = 0;  // of the closest hit
    f32::RibbonHit hit{};
};

glm::vec2 paintAt(const GrassField& g, const glm::dvec2& place) {
    if (!g.orientation.present()) return glm::vec2(0);
    const glm::vec4 t = paintedAt(g.orientation.map, place, static_cast<double>(g.orientationTiling), false);
    return f32::paintOf(t.x, t.y);
}

glm::vec2 windLeanIn(const RayField& f, const Cell& cell, const glm::vec2& inCell, float grain) {
    return f.wind ? windLeanAt(cell.wind, *f.gusts, inCell, grain) : glm::vec2(0);
}

bool pressed(const RayField& f) { return f.grass->forces.present() || !f.forces.empty(); }

// Push and press at a place, on maps (shares of what a map of tiling 1 covers) and in metres.
glm::vec3 forceOn(const RayField& f, const glm::dvec2& place, const glm::dvec2& ground) {
    glm::vec3 sum = f.forces.empty() ? glm::vec3(0) : forceAt(f.forces, ground);
    if (f.grass->forces.present())
        sum +=
            f32::paintedForce(paintedAt(f.grass->forces.map, place, static_cast<double>(f.grass->forcesTiling), false));
    return f32::forceOf(sum);
}

glm::dvec2 onMaps(const RayField& f, const glm::dvec2& ground) { return ground / mapExtent(*f.terrain); }
float densityAt(const RayField& f, const Species& s, const glm::dvec2& ground) {
    return s.density.present() ? tiledSample(s.density.map, tilingOf(*f.terrain, s.densityTiling), ground.x, ground.y)
                               : 1.0f;
}
float bladeShareAt(const RayField& f, const glm::dvec2& ground) {
    const GrassField& g = *f.grass;
    return g.bladeHeight.present()
               ? tiledSample(g.bladeHeight.map, tilingOf(*f.terrain, g.bladeHeightTiling), ground.x, ground.y)
               : 1.0f;
}

// The blade where it stands; its root's place on maps.
Posed poseBladeAt(const RayField& f, const Kind& kind, const Cell& cell, int x, int z, uint32_t index,
                  glm::dvec2* rootPlace = nullptr) {
    const Blade& b = kind.blades()[cell.first + index];
    const float size = f.grass->cellSize;
    const glm::vec2 inCell = f32::rootInCell(b.root, cell.version.mirror, cell.version.shift, size);
    const glm::dvec2 ground = glm::dvec2(x, z) * static_cast<double>(size) + glm::dvec2(inCell),
                     place = onMaps(f, ground);
    if (rootPlace) *rootPlace = place;
    if (ground.x > f.terrain->size.x || ground.y > f.terrain->size.y ||
        densityAt(f, *kind.species, ground) < b.threshold)
        return {};
    const bool clumped = kind.clumps != glm::vec3(0);
    const glm::vec3 clump =
        clumped ? f32::clumpValues(x, z, inCell, size, kind.species->clumpSize, static_cast<uint32_t>(f.grass->seed))
                : glm::vec3(0);
    const f32::BladePlace at = f32::bladePlace(paintAt(*f.grass, place), kind.leanAtFull, clump, kind.clumps);
    glm::vec2 lean = at.lean + windLeanIn(f, cell, inCell, b.dither);
    if (pressed(f)) {
        const glm::vec3 force = forceOn(f, place, ground);
        lean = f32::forcedLean(lean, {force.x, force.y}, force.z, b.facing * cell.version.mirror);
    }
    const f32::BladePose pose =
        f32::poseBlade(b.control, b.tip, b.facing, cell.version.mirror, lean, at.scale * bladeShareAt(f, ground));
    const float up = static_cast<float>(terrainHeight(*f.terrain, ground.x, ground.y) - cell.base);
    return {{inCell.x, up, inCell.y}, pose.control, pose.tip, pose.facing, b.width, at.lighter};
}

const Posed& keptBlade(const Query& q, uint32_t blade) {
    const uint64_t key = (q.cell->key << 22) | blade;
    Kept& k = q.memory->blades[(slotOf(q.cell->key) + blade) & (kBlades - 1)];
    if (k.key != key) k = {key, poseBladeAt(*q.field, *q.kind, *q.cell, q.x, q.z, blade)};
    return k.blade;
}

// The nearest place in ]near, far[ where the query's ray meets the blade, and its image's opacity there lets it.
std::optional<f32::RibbonHit> bladeMet(const Query& q, uint32_t blade, float near, float far) {
    const Posed& b = keptBlade(q, blade);
    if (b.width <= 0) return std::nullopt;
    const glm::vec3 o = q.origin - b.root;
    const glm::vec2 at = f32::ribbonMeetings(o, q.way, b.control, b.tip, b.facing);
    std::optional<f32::RibbonHit> found;
    for (const float v : {at.x, at.y}) {
        if (!(v >= 0 && v <= 1)) continue;
        const f32::RibbonHit h = f32::ribbonAt(o, q.way, b.control, b.tip, b.facing, b.width, v);
        if (!(h.t > near && h.t < far) || std::abs(h.across) > 0.5f) continue;
        const float opacity = q.kind->image.at(static_cast<double>(h.across) + 0.5, static_cast<double>(v), false).w;
        if (opacity <= f32::hashUnit(f32::hash3(q.grain, blade, static_cast<uint32_t>(q.cell->key)))) continue;
        found = h;
        far = h.t;
    }
    return found;
}

void meetClosest(const RTCIntersectFunctionNArguments* a) {
    if (!a->valid[0]) return;
    Query& q = *reinterpret_cast<Query*>(a->context);
    RTCRayHit& r = *reinterpret_cast<RTCRayHit*>(a->rayhit);
    const auto met = bladeMet(q, a->primID, r.ray.tnear, r.ray.tfar);
    if (!met) return;
    q.blade = a->primID;
    q.hit = *met;
    r.ray.tfar = met->t;
    r.hit.geomID = a->geomID, r.hit.primID = a->primID;
}
void meetAny(const RTCOccludedFunctionNArguments* a) {
    if (!a->valid[0]) return;
    const Query& q = *reinterpret_cast<const Query*>(a->context);
    RTCRay& r = *reinterpret_cast<RTCRay*>(a->ray);
    if (bladeMet(q, a->primID, r.tnear, r.tfar)) r.tfar = -std::numeric_limits<float>::infinity();
}

// The scene of a key, made the first time it is asked for.
RTCScene sceneFor(const Kind& kind, const SceneKey& key, std::span<const Blade> blades) {
    std::lock_guard lock(kind.mutex);
    const auto found = kind.scenes.find(key);
    if (found != kind.scenes.end()) return found->second.scene.get();
    BoxScene& s = kind.scenes[key];
    s.blades = blades.data();
    s.lean = glm::vec2(key.leanX, key.leanZ) * kLeanStep;
    s.spread = static_cast<float>(key.spread) * kSpreadStep;
    s.scale = kind.clumps.y;
    s.bump = key.bump == 0 ? 1e-6f : kBump * std::exp2(static_cast<float>(key.bump - 1));
    s.scene.reset(rtcNewScene(kind.device.get()));
    RTCGeometry g = rtcNewGeometry(kind.device.get(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(g, static_cast<unsigned>(blades.size()));
    rtcSetGeometryUserData(g, &s);
    rtcSetGeometryBoundsFunction(
        g, [](const RTCBoundsFunctionArguments* a) { boundsOf(a); }, nullptr);
    rtcSetGeometryIntersectFunction(g, meetClosest);
    rtcSetGeometryOccludedFunction(g, meetAny);
    rtcCommitGeometry(g);
    rtcAttachGeometry(s.scene.get(), g);
    rtcReleaseGeometry(g);
    rtcCommitScene(s.scene.get());
    return s.scene.get();
}

// Calls see(texel x, y) for those whose bilinear reach touches the part of a map that [from, to] (in repeats of it)
// covers.
template <class F>
void eachTexel(const MapInfo& info, const glm::dvec2& from, const glm::dvec2& to, F see) {
    const auto low = [](double v, int n) { return static_cast<int>(std::floor(v * n - 0.5)); };
    for (int y = low(from.y, info.height); y <= low(to.y, info.height) + 1; ++y)
        for (int x = low(from.x, info.width); x <= low(to.x, info.width) + 1; ++x) see(x, y);
}

// Mean of the paint's extremes over a part of the terrain (from, to: on maps), and how far it goes from there. Paint is
// cut to a circle and to nothing where it is faint: neither moves two values apart by more than 1/255.
std::pair<glm::vec2, float> paintOver(const GrassField& g, const glm::dvec2& from, const glm::dvec2& to) {
    if (!g.orientation.present()) return {glm::vec2(0), 0.0f};
    const Map& map = g.orientation.map;
    const MapInfo& info = map.info();
    const double tiling = static_cast<double>(g.orientationTiling);
    glm::vec2 low(1), high(-1);
    const auto wrap = [](int v, int n) { return (v % n + n) % n; };
    const auto see = [&](int x, int y) {
        const int i = wrap(x, info.width), j = wrap(y, info.height);
        const glm::vec2 d(2 * map.at(i, j, 0) - 1, 2 * map.at(i, j, 1) - 1);
        low = glm::min(low, d), high = glm::max(high, d);
    };
    const glm::dvec2 across = (to - from) * tiling;
    if (across.x >= 1 || across.y >= 1)
        eachTexel(info, {0, 0}, {1, 1}, see);
    else
        eachTexel(info, from * tiling, to * tiling, see);
    const glm::vec2 middle = (low + high) * 0.5f;
    const float l = glm::length(middle);
    return {l > 1 ? middle / l : middle, glm::length(high - low) * 0.5f + 1.0f / 255};
}

// The plane through the ground under a part of the terrain (metres), and how far the ground leaves it. Bilinear ground
// leaves a plane by no more than its texels do; beyond the outermost texels' middles it is level instead.
CellGround groundUnder(const Terrain& t, double x0, double z0, double x1, double z1) {
    CellGround g;
    if (!t.height.present()) return g;
    const Map& map = t.height.map;
    const MapInfo& info = map.info();
    const auto height = [&](double x, double z) { return terrainHeight(t, x, z); };
    const double base = height(x0, z0), sx = (height(x1, z0) - base) / (x1 - x0),
                 sz = (height(x0, z1) - base) / (z1 - z0);
    const auto [offset, scale] = heightScale(t);
    double bump = 0;
    const Tiling tiling = tilingOf(t, t.heightTiling);
    const auto texel = [&](int k, int n) {  // beyond the map: its edge's, or mirrored
        const int m = (k % (2 * n) + 2 * n) % (2 * n);
        return !tiling.repeats ? std::clamp(k, 0, n - 1) : m < n ? m : 2 * n - 1 - m;
    };
    eachTexel(info, glm::dvec2(x0, z0) / tiling.metres, glm::dvec2(x1, z1) / tiling.metres, [&](int x, int y) {
        const int i = texel(x, info.width), j = texel(y, info.height);
        const double px = (x + 0.5) / info.width * tiling.metres.x, pz = (y + 0.5) / info.height * tiling.metres.y;
        bump = std::max(bump, std::abs(offset + scale * static_cast<double>(map.at(i, j)) -
                                       (base + sx * (px - x0) + sz * (pz - z0))));
    });
    g.slopeX = static_cast<float>(sx), g.slopeZ = static_cast<float>(sz);
    g.bump = static_cast<float>(bump) + 1e-4f;
    const double cornerX = sx * (x1 - x0), cornerZ = sz * (z1 - z0);
    g.low = static_cast<float>(std::min(0.0, cornerX) + std::min(0.0, cornerZ)) - g.bump;
    g.high = static_cast<float>(std::max(0.0, cornerX) + std::max(0.0, cornerZ)) + g.bump;
    return g;
}

// Whether anything may press on blades between two places on maps.
bool pressedBetween(const RayField& f, const glm::dvec2& from, const glm::dvec2& to) {
    const glm::dvec2 extent = mapExtent(*f.terrain), low = from * extent, high = to * extent;
    for (const Force& force : f.forces) {
        const glm::dvec2 far(static_cast<double>(farOf(force)));
        if (glm::all(glm::greaterThanEqual(glm::max(force.from, force.to) + far, low)) &&
            glm::all(glm::lessThanEqual(glm::min(force.from, force.to) - far, high)))
            return true;
    }
    if (!f.grass->forces.present()) return false;
    const Map& map = f.grass->forces.map;
    const MapInfo& info = map.info();
    const double tiling = static_cast<double>(f.grass->forcesTiling);
    const glm::dvec2 across = (to - from) * tiling;
    const auto wrap = [](int v, int n) { return (v % n + n) % n; };
    bool found = false;
    const auto see = [&](int x, int y) { found = found || map.at(wrap(x, info.width), wrap(y, info.height), 3) > 0; };
    if (across.x >= 1 || across.y >= 1)
        eachTexel(info, {0, 0}, {1, 1}, see);
    else
        eachTexel(info, from * tiling, to * tiling, see);
    return found;
}

int classOf(float value, float step) { return static_cast<int>(std::ceil(value / step - 1e-4f)); }

// Which scene serves a cell; null if nothing grows there.
RTCScene sceneOf(const RayField& f, const Kind& kind, Cell& cell, int x, int z, double x0, double z0) {
    const double size = static_cast<double>(f.grass->cellSize);
    const glm::dvec2 from = onMaps(f, {x0, z0}), to = onMaps(f, {x0 + size, z0 + size});
    const MapField& densities = kind.species->density;
    const float most = densities.present()
                           ? densityRange(densities.map, tilingOf(*f.terrain, kind.species->densityTiling), x0, z0,
                                          x0 + size, z0 + size)
                                 .second
                           : 1.0f;
    SceneKey key{};
    while (key.prefix + 1 < static_cast<int>(std::size(kPrefixes)) &&
           static_cast<float>(kPrefixes[key.prefix]) / 255 < most)
        ++key.prefix;
    std::span<const Blade> blades(kind.patch.blades.data(),
                                  kind.patch.upTo[static_cast<size_t>(kPrefixes[key.prefix])]);
    if (!kind.unique.empty()) {
        const auto [first, last] = kind.unique.range(x, z, 0, 1);
        blades = std::span(kind.unique.patch.blades).subspan(first, last - first);
        key.prefix = 0, key.cell = 1 + cellKey(0, x, z);
        cell.first = first;
    }
    if (most < 1.0f / 255 || blades.empty()) return nullptr;
    const auto [paint, differs] = paintOver(*f.grass, from, to);
    const float half = 0.5f * f.grass->cellSize;
    const glm::vec2 lean = (paint * kind.leanAtFull + windLeanIn(f, cell, glm::vec2(half), -1)) * cell.version.mirror;
    const float wind = f.wind ? kind.windSlope * 1.4142136f * half + 0.13f * kind.gust * f.wind->turbulence : 0.0f;
    key.leanX = static_cast<int>(std::lround(lean.x / kLeanStep)),
    key.leanZ = static_cast<int>(std::lround(lean.y / kLeanStep));
    const float beside = glm::length(lean - glm::vec2(key.leanX, key.leanZ) * kLeanStep);
    key.spread = classOf(beside + differs * kind.leanAtFull + wind + 1.4142136f * kind.clumps.x, kSpreadStep);
    if (pressed(f) && pressedBetween(f, from, to))
        key.leanX = key.leanZ = 0, key.spread = classOf(kAnyLean, kSpreadStep);
    key.bump = cell.ground.bump > 0 ? std::max(1, 1 + classOf(std::log2(cell.ground.bump / kBump), 1)) : 0;
    return sceneFor(kind, key, blades);
}

const Cell& cellAt(const RayField& f, Memory& memory, size_t kind, int x, int z) {
    const uint64_t key = cellKey(static_cast<int>(kind), x, z);
    Cell& c = memory.cells[slotOf(key) & (kCells - 1)];
    if (c.key == key) return c;
    const double size = static_cast<double>(f.grass->cellSize), x0 = x * size, z0 = z * size;
    c.key = key;
    c.first = 0;
    c.version = isUnique(*f.grass) ? f32::CellVersion{glm::vec2(1), glm::vec2(0)}
                                   : f32::cellVersion(x, z, static_cast<uint32_t>(f.grass->seed));
    c.base = terrainHeight(*f.terrain, x0, z0);
    c.ground = groundUnder(*f.terrain, x0, z0, x0 + size, z0 + size);
    if (f.wind) c.wind = windGlobals(*f.wind, {x0, z0}, f.time), c.wind.strength = f.kinds[kind]->gust;
    c.scene = sceneOf(f, *f.kinds[kind], c, x, z, x0, z0);
    return c;
}

// The part of [from, to] in which low <= origin + t way <= high; empty (from > to) if none.
std::pair<double, double> within(double origin, double way, double low, double high, double from, double to) {
    if (way == 0) return origin >= low && origin <= high ? std::pair{from, to} : std::pair{1.0, 0.0};
    const double a = (low - origin) / way, b = (high - origin) / way;
    return {std::max(from, std::min(a, b)), std::min(to, std::max(a, b))};
}

// Calls visit(x, z, from, to) for the cells whose blades a ray may meet, roughly in its order: by columns across the
// axis that it runs along. `end` may come nearer while it goes; columns that begin beyond are not visited.
template <class F>
void march(const RayField& f, const Ray& ray, double reach, const double& end, const F& visit) {
    const double size = static_cast<double>(f.grass->cellSize);
    const int major = std::abs(ray.way.x) >= std::abs(ray.way.z) ? 0 : 2, minor = 2 - major;
    const glm::dvec3 extent(f.terrain->size.x, 0, f.terrain->size.y);
    auto [from, to] = within(ray.origin.y, ray.way.y, static_cast<double>(f.bounds.low) - 1e-3,
                             static_cast<double>(f.bounds.high) + reach, ray.near, ray.far);
    std::tie(from, to) = within(ray.origin[major], ray.way[major], -reach, extent[major] + reach, from, to);
    std::tie(from, to) = within(ray.origin[minor], ray.way[minor], -reach, extent[minor] + reach, from, to);
    if (!(from <= to)) return;
    const auto cellsBetween = [&](int axis, double a, double b) {
        const double last = std::ceil(extent[axis] / size) - 1;
        const double low = std::min(ray.origin[axis] + ray.way[axis] * a, ray.origin[axis] + ray.way[axis] * b) - reach;
        const double high =
            std::max(ray.origin[axis] + ray.way[axis] * a, ray.origin[axis] + ray.way[axis] * b) + reach;
        return std::pair{static_cast<int>(std::clamp(std::floor(low / size), 0.0, last)),
                         static_cast<int>(std::clamp(std::floor(high / size), 0.0, last))};
    };
    const auto [first, last] = cellsBetween(major, from, to);
    for (int n = 0; n <= last - first; ++n) {
        const int i = ray.way[major] < 0 ? last - n : first + n;
        const auto [a, b] =
            within(ray.origin[major], ray.way[major], i * size - reach, (i + 1) * size + reach, from, to);
        if (a > end) return;
        if (!(a <= b)) continue;
        const auto [low, high] = cellsBetween(minor, a, b);
        for (int m = 0; m <= high - low; ++m) {
            const int j = ray.way[minor] < 0 ? high - m : low + m;
            const auto [c, d] =
                within(ray.origin[minor], ray.way[minor], j * size - reach, (j + 1) * size + reach, a, b);
            if (c <= d && c <= end) visit(major == 0 ? i : j, major == 0 ? j : i, c, d);
        }
    }
}

// A cell that begins its patch at `start` (metres) shows it in up to four pieces. Calls ask(origin in the patch, how
// far) for those that the ray o + t w, t < far, may meet; o in the cell, already mirrored. Blades of another piece that
// it meets so are met where they are.
template <class F>
void eachPiece(const glm::vec2& start, float size, float reach, const glm::vec3& o, const glm::vec3& w, float far,
               const F& ask) {
    for (int i = 0; i < 4; ++i) {
        const bool wrapsX = i & 1, wrapsZ = i & 2;
        if ((wrapsX && start.x <= 0) || (wrapsZ && start.y <= 0)) continue;
        const auto part = [&](bool wraps, float begin, float at, float way, double from, double to) {
            return within(static_cast<double>(at), static_cast<double>(way),
                          static_cast<double>((wraps ? 0 : begin) - reach),
                          static_cast<double>((wraps ? begin : size) + reach), from, to);
        };
        auto [from, to] = part(wrapsX, start.x, o.x, w.x, 0, static_cast<double>(far));
        std::tie(from, to) = part(wrapsZ, start.y, o.z, w.z, from, to);
        if (from <= to)
            ask(o - glm::vec3(start.x - (wrapsX ? size : 0), 0, start.y - (wrapsZ ? size : 0)),
                static_cast<float>(to) * 1.0001f + 1e-6f);
    }
}

// Calls ask(query, embree's ray, where on the ray that begins) for each species in each cell on the way that has
// anything to meet.
template <class F>
void eachScene(const RayField& f, const Ray& ray, Memory& memory, const double& end, const F& ask) {
    if (f.kinds.empty()) return;
    const double size = static_cast<double>(f.grass->cellSize);
    for (size_t k = 0; k < f.kinds.size(); ++k) {
        const Kind& kind = *f.kinds[k];
        const double reach = static_cast<double>(kind.reach);
        march(f, ray, reach, end, [&](int x, int z, double from, double to) {
            const Cell& cell = cellAt(f, memory, k, x, z);
            if (!cell.scene) return;
            const auto [a, b] = within(ray.origin.y, ray.way.y, cell.base + static_cast<double>(cell.ground.low) - 1e-3,
                                       cell.base + static_cast<double>(cell.ground.high) + reach, from, to);
            if (!(a <= b)) return;
            Query q{{}, &f, k, &kind, &memory, &cell, x, z, {}, glm::vec3(ray.way), ray.grain};
            q.origin = glm::vec3(ray.origin + ray.way * a - glm::dvec3(x * size, cell.base, z * size));
            // Into the patch's frame: over the plane of the ground, mirrored, and begun where the cell begins the
            // patch.
            const CellGround& g = cell.ground;
            glm::vec3 o = q.origin, w = q.way;
            o.y -= g.slopeX * o.x + g.slopeZ * o.z, w.y -= g.slopeX * w.x + g.slopeZ * w.z;
            if (cell.version.mirror.x < 0) o.x = f.grass->cellSize - o.x, w.x = -w.x;
            if (cell.version.mirror.y < 0) o.z = f.grass->cellSize - o.z, w.z = -w.z;
            eachPiece(cell.version.shift * f.grass->cellSize, f.grass->cellSize, kind.reach, o, w,
                      static_cast<float>(std::min(end, b) - a) * 1.0001f + 1e-6f,
                      [&](const glm::vec3& start, float far) { ask(q, embreeRay(start, w, 0, far), a); });
        });
    }
}

glm::vec3 bladeColor(const RayField& f, const Query& q, const Blade& b, const Posed& p, float v,
                     const glm::dvec2& place) {
    const Species& s = *q.kind->species;
    const glm::vec3 c =
        f32::bladeTint(f32::bladeGradient(s.rootColor, s.midColor, s.tipColor, v), b.hue, b.lightness * p.lighter);
    if (!f.grass->vegetation.present()) return c;
    const glm::vec4 paint =
        paintedAt(f.grass->vegetation.map, place, static_cast<double>(f.grass->vegetationTiling), true);
    return glm::mix(c, glm::vec3(paint), paint.w);
}

Surface bladeSurface(const RayField& f, const Ray& ray, const Query& q, double t) {
    Surface s;
    s.met = Met::Blade;
    s.t = t;
    s.at = ray.origin + ray.way * t;
    const Posed p = poseBladeAt(f, *q.kind, *q.cell, q.x, q.z, q.blade, &s.place);
    s.normal = f32::bladeFrameFacing(p.control, p.tip, p.facing, q.hit.v).normal;
    if (glm::dot(glm::dvec3(s.normal), ray.way) > 0) s.normal = -s.normal;
    s.face = s.normal;
    s.color = bladeColor(f, q, q.kind->blades()[q.cell->first + q.blade], p, q.hit.v, s.place);
    const Species& species = *q.kind->species;
    s.looks = {species.translucency, species.gloss, species.roughness};
    s.tint = 2.0f *
             glm::vec3(q.kind->image.at(static_cast<double>(q.hit.across) + 0.5, static_cast<double>(q.hit.v), false));
    s.open = glm::mix(species.rootOcclusion, 1.0f, q.hit.v);
    return s;
}

void feelWind(Kind& kind, const Wind& wind, const Map& gusts) {
    WindGlobals g = windGlobals(wind, {0, 0}, 0);
    g.strength = kind.gust = windStrength(wind, *kind.species);
    kind.windSlope = windSlope(g, gusts);
}

}  // namespace

GrassRays::GrassRays(std::unique_ptr<RayField> field) : field_(std::move(field)) {}
GrassRays::GrassRays(GrassRays&&) noexcept = default;
GrassRays& GrassRays::operator=(GrassRays&&) noexcept = default;
GrassRays::~GrassRays() = default;

Result<GrassRays> GrassRays::make(const Project& p, double time, const JobControl& control) {
    auto f = std::make_unique<RayField>();
    f->terrain = findGround(p).terrain;
    f->grass = firstOf<GrassField>(p);
    if (!f->terrain || !f->grass) return GrassRays(std::move(f));
    if (Status s = checkUnique(p); !s) return s.error();
    updateHeightBounds(f->bounds, *f->terrain);
    f->time = time;
    f->forces = forcesOf(p, time);
    f->wind = windOf(p);
    if (f->wind) f->gusts = &gustsOf(*f->wind, f->made);
    for (size_t i = 0; i < f->grass->species.size() && i < MAX_SPECIES; ++i) {
        if (control.cancelled()) return failed("cancelled");
        const Species& s = f->grass->species[i];
        auto kind = std::make_unique<Kind>();
        kind->species = &s;
        kind->patch = makePatch(s, f->grass->cellSize, static_cast<uint32_t>(f->grass->seed));
        if (isUnique(*f->grass)) kind->unique = makeUnique(s, *f->grass, *f->terrain);
        if (kind->blades().empty()) continue;
        const Rgba8 image = bladeImage(p, s);
        kind->image = texelGridOf(image);
        uint64_t lookKey = 0;
        updateLook(kind->look, lookKey, s, kind->patch, 1, image);
        kind->leanAtFull = leanAtFull(s);
        kind->clumps = clumpStrengths(s);
        if (f->wind) feelWind(*kind, *f->wind, *f->gusts);
        kind->reach = bladeReach(s, kind->unique.empty() ? kind->patch : kind->unique.patch);
        kind->device.reset(rtcNewDevice(nullptr));
        if (!kind->device)
            return failed("rays cannot be prepared: Embree has no memory, or does not know this processor",
                          "close other programs");
        f->kinds.push_back(std::move(kind));
    }
    return GrassRays(std::move(f));
}

std::optional<Surface> GrassRays::closest(const Ray& ray, GrassMemory& memory) const {
    double end = ray.far;
    std::optional<Query> best;
    eachScene(*field_, ray, *memory.tables, end, [&](Query& q, const RTCRay& r, double from) {
        RTCRayHit hit{r, {}};
        closestHit(q.cell->scene, q.context, hit);
        if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return;
        const double t = from + static_cast<double>(hit.ray.tfar);
        if (t >= end) return;
        end = t;
        best = q;
    });
    if (!best) return std::nullopt;
    // The memory may have given the cell's place to another: its number is the query's.
    const Cell cell = cellAt(*field_, *memory.tables, best->number, best->x, best->z);
    best->cell = &cell;
    return bladeSurface(*field_, ray, *best, end);
}

float GrassRays::lightLeft(const glm::dvec2& place, float sinElevation) const {
    float left = 1;
    for (const auto& kind : field_->kinds) {
        const glm::dvec2 ground = place * mapExtent(*field_->terrain);
        left *= glm::mix(1.0f, std::pow(sward::lightLeft(kind->look, sinElevation), bladeShareAt(*field_, ground)),
                         densityAt(*field_, *kind->species, ground));
    }
    return left;
}

bool GrassRays::blocks(const Ray& ray, GrassMemory& memory) const {
    double end = ray.far;
    bool blocked = false;
    eachScene(*field_, ray, *memory.tables, end, [&](Query& q, const RTCRay& r, double) {
        if (blocked || !anyHit(q.cell->scene, q.context, r)) return;
        blocked = true;
        end = -std::numeric_limits<double>::infinity();
    });
    return blocked;
}

}  // namespace sward
