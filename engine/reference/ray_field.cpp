#include "reference/ray_field.h"

#include "core/numerics.h"
#include "grass/cells.h"
#include "grass/grown.h"
#include "reference/blade_hits.h"
#include "scene/field_limits.h"

namespace sward {
namespace {

constexpr float kLeanStep = 0.2f;    // metres a metre between the mean leans that scenes are made for
constexpr float kSpreadStep = 0.1f;  // ... and between their spreads
constexpr float kAnyLean = 3;        // of blades that are pressed: any way, down to the ground
constexpr float kBump =
    0.005f;  // metres: least class of how far ground leaves the plane through a cell; each next doubles
constexpr int kPrefixes[] = {16, 48, 112, 255};

using Memory = GrassMemory::Tables;

uint64_t cellKey(int species, int x, int z) {
    return (static_cast<uint64_t>(species) << 40) | (static_cast<uint64_t>(static_cast<uint32_t>(x) & 0xFFFFF) << 20) |
           (static_cast<uint32_t>(z) & 0xFFFFF);
}
size_t slotOf(uint64_t cell) { return static_cast<size_t>((cell * 0x9E3779B97F4A7C15ull) >> 40); }

}  // namespace

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

void cellBounds(const RTCBoundsFunctionArguments* a) {
    const BoxScene& s = *static_cast<const BoxScene*>(a->geometryUserPtr);
    const Blade& b = s.blades[a->primID];
    auto [low, high] = leaningBounds(b, s.lean, s.spread, s.scale);
    const glm::vec3 root(b.root.x, 0, b.root.y), bump(0, s.bump, 0);
    low += root - bump, high += root + bump;
    *a->bounds_o = {low.x, low.y, low.z, 0, high.x, high.y, high.z, 0};
}

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

}  // namespace

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

namespace {
// What the place has for a blade that stands there (numerics/stand.h). ground, place: of its root, in metres from the
// terrain's corner and on maps.
f32::BladeStand standAt(const RayField& f, const Kind& kind, const Cell& cell, const glm::ivec2& at, const Blade& b,
                        const glm::vec2& inCell, const glm::dvec2& ground, const glm::dvec2& place) {
    f32::BladeStand s = f32::emptyStand();
    s.paint = paintAt(*f.grass, place), s.leanAtFull = kind.leanAtFull;
    if (kind.clumps != glm::vec3(0))
        s.clump = f32::clumpValues(at.x, at.y, inCell, f.grass->cellSize, kind.species->clumpSize,
                                   static_cast<uint32_t>(f.grass->seed));
    s.clumpLean = kind.clumps.x, s.clumpHeight = kind.clumps.y, s.clumpLightness = kind.clumps.z;
    s.wind = windLeanIn(f, cell, inCell, b.dither);
    if (pressed(f)) {
        const glm::vec3 force = forceOn(f, place, ground);
        s.push = {force.x, force.y}, s.press = force.z;
    }
    s.tall = bladeShareAt(f, ground);
    return s;
}
}  // namespace

Posed poseBladeAt(const RayField& f, const Kind& kind, const Cell& cell, int x, int z, uint32_t index,
                  glm::dvec2* rootPlace) {
    const Blade& b = kind.blades()[cell.first + index];
    const float size = f.grass->cellSize;
    const glm::vec2 inCell = f32::rootInCell(b.root, cell.version.mirror, cell.version.shift, size);
    const glm::dvec2 ground = glm::dvec2(x, z) * static_cast<double>(size) + glm::dvec2(inCell),
                     place = onMaps(f, ground);
    if (rootPlace) *rootPlace = place;
    if (ground.x > f.terrain->size.x || ground.y > f.terrain->size.y ||
        densityAt(f, *kind.species, ground) < f32::thresholdIn(b.threshold, kind.sown(), cell.chance))
        return {};
    const f32::BladeStand stand = standAt(f, kind, cell, {x, z}, b, inCell, ground, place);
    const f32::BladeLean at = f32::leanOf(stand, b.facing * cell.version.mirror);
    const f32::BladePose pose = f32::poseBlade(b.control, b.tip, b.facing, cell.version.mirror, at.lean, at.scale);
    const float up = static_cast<float>(terrainHeight(*f.terrain, ground.x, ground.y) - cell.base);
    return {{inCell.x, up, inCell.y}, pose.control, pose.tip, pose.facing, b.width, at.lighter};
}

namespace {

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
    const float chance = f32::hashUnit(f32::hash3(q.grain, blade, static_cast<uint32_t>(q.cell->key)));
    return bladeMetBy({q.origin - b.root, q.way, b.control, b.tip, b.facing, b.width, q.kind->image, chance}, near,
                      far);
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
    s.scene = sceneOfBoxes<cellBounds>(kind.device.get(), blades.size(), &s, meetClosestBlade<Query, bladeMet>,
                                       meetAnyBlade<Query, bladeMet>);
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

// The greatest of the patch's own thresholds that is `most` or less in a cell of this chance, or a little more.
float patchThreshold(const f32::Sown& s, float most, float chance) {
    return s.step > 0 ? (most + chance * s.step) / s.spread * 1.00001f : most;
}

// The greatest of the patch's own thresholds that the density within a cell may reach.
float highestIn(const RayField& f, const Kind& kind, const Cell& cell, double x0, double z0) {
    const double size = static_cast<double>(f.grass->cellSize);
    const MapField& densities = kind.species->density;
    const float most = densities.present()
                           ? densityRange(densities.map, tilingOf(*f.terrain, kind.species->densityTiling), x0, z0,
                                          x0 + size, z0 + size)
                                 .second
                           : 1.0f;
    return patchThreshold(kind.sown(), most, cell.chance);
}
uint32_t patchUpTo(const Kind& kind, float highest) {
    return kind.patch.upTo[static_cast<size_t>(f32::thresholdNumber(highest + 1e-5f))];
}

// Which scene serves a cell; null if nothing grows there.
RTCScene sceneOf(const RayField& f, const Kind& kind, Cell& cell, int x, int z, double x0, double z0) {
    const double size = static_cast<double>(f.grass->cellSize);
    const glm::dvec2 from = onMaps(f, {x0, z0}), to = onMaps(f, {x0 + size, z0 + size});
    SceneKey key{};
    const float highest = highestIn(f, kind, cell, x0, z0);
    while (key.prefix + 1 < static_cast<int>(std::size(kPrefixes)) &&
           static_cast<float>(kPrefixes[key.prefix]) / 255 < highest)
        ++key.prefix;
    std::span<const Blade> blades(kind.patch.blades.data(),
                                  kind.patch.upTo[static_cast<size_t>(kPrefixes[key.prefix])]);
    if (kind.unique.empty() && patchUpTo(kind, highest) == 0) return nullptr;
    if (!kind.unique.empty()) {
        const auto [first, last] = kind.unique.range(x, z, 0, 1);
        blades = std::span(kind.unique.patch.blades).subspan(first, last - first);
        key.prefix = 0, key.cell = 1 + cellKey(0, x, z);
        cell.first = first;
    }
    if (blades.empty()) return nullptr;
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

void feelWind(Kind& kind, const Wind& wind, const Map& gusts) {
    WindGlobals g = windGlobals(wind, {0, 0}, 0);
    g.strength = kind.gust = windStrength(wind, *kind.species);
    kind.windSlope = windSlope(g, gusts);
}

// The kinds of one field, their Embree devices with them.
Status addKinds(RayField& f, const Project& p, const JobControl& control) {
    for (const Species& s : f.grass->species) {
        if (!f.grass->onTerrain) continue;
        if (control.cancelled()) return failed("cancelled");
        auto kind = std::make_unique<Kind>();
        kind->species = &s;
        kind->patch = makePatch(s, f.grass->cellSize, static_cast<uint32_t>(f.grass->seed));
        kind->sowSeed = sowingSeed(s, static_cast<uint32_t>(f.grass->seed));
        if (isUnique(*f.grass)) kind->unique = makeUnique(s, *f.grass, *f.terrain);
        if (kind->blades().empty()) continue;
        const Rgba8 image = bladeImage(p, s);
        kind->image = texelGridOf(image);
        uint64_t lookKey = 0;
        updateLook(kind->look, lookKey, s, kind->patch, 1, image);
        kind->leanAtFull = leanAtFull(s);
        kind->clumps = clumpStrengths(s);
        if (f.wind) feelWind(*kind, *f.wind, *f.gusts);
        kind->reach = bladeReach(s, kind->unique.empty() ? kind->patch : kind->unique.patch);
        kind->device.reset(rtcNewDevice(nullptr));
        if (!kind->device)
            return failed("rays cannot be prepared: Embree has no memory, or does not know this processor",
                          "close other programs");
        f.kinds.push_back(std::move(kind));
    }
    return {};
}

}  // namespace

Result<std::vector<std::unique_ptr<RayField>>> makeRayFields(const Project& p, double time, const JobControl& control) {
    std::vector<std::unique_ptr<RayField>> fields;
    const Terrain* terrain = findGround(p).terrain;
    if (!terrain) return fields;
    if (Status s = checkFields(p); !s) return s.error();
    if (Status s = checkUnique(p); !s) return s.error();
    size_t kinds = 0;
    const auto posedBytes = std::make_shared<std::atomic<size_t>>(0);
    for (const auto& [name, field] : fieldsOf(p)) {
        auto f = std::make_unique<RayField>();
        f->number = static_cast<uint32_t>(fields.size());
        f->firstKind = kinds;
        f->posedBytes = posedBytes;
        f->terrain = terrain;
        f->grass = &field.grows;
        updateHeightBounds(f->bounds, *terrain);
        f->time = time;
        f->forces = forcesOf(p, time);
        f->wind = windOf(p);
        if (f->wind) f->gusts = &gustsOf(*f->wind, f->made);
        if (Status s = addKinds(*f, p, control); !s) return s.error();
        kinds += f->kinds.size();
        fields.push_back(std::move(f));
    }
    return fields;
}

Cell bareCell(const RayField& f, size_t kind, int x, int z) {
    const double size = static_cast<double>(f.grass->cellSize), x0 = x * size, z0 = z * size;
    Cell c;
    c.key = cellKey(static_cast<int>(f.firstKind + kind), x, z);
    c.version = isUnique(*f.grass) ? f32::CellVersion{glm::vec2(1), glm::vec2(0)}
                                   : f32::cellVersion(x, z, static_cast<uint32_t>(f.grass->seed));
    const Kind& of = *f.kinds[kind];
    c.chance = of.sown().step > 0 ? f32::cellChance(x, z, of.sowSeed) : 0.5f;
    c.base = terrainHeight(*f.terrain, x0, z0);
    if (f.wind) c.wind = windGlobals(*f.wind, {x0, z0}, f.time), c.wind.strength = of.gust;
    return c;
}

uint32_t bladesIn(const RayField& f, const Kind& kind, Cell& cell, int x, int z) {
    if (kind.unique.empty()) {
        const double size = static_cast<double>(f.grass->cellSize);
        return patchUpTo(kind, highestIn(f, kind, cell, x * size, z * size));
    }
    const auto [first, last] = kind.unique.range(x, z, 0, 1);
    cell.first = first;
    return last - first;
}

Cell& cellAt(const RayField& f, Memory& memory, size_t kind, int x, int z) {
    const uint64_t key = cellKey(static_cast<int>(f.firstKind + kind), x, z);
    Cell& c = memory.cells[slotOf(key) & (kCells - 1)];
    if (c.key == key) return c;
    c = bareCell(f, kind, x, z);
    const double size = static_cast<double>(f.grass->cellSize), x0 = x * size, z0 = z * size;
    c.ground = groundUnder(*f.terrain, x0, z0, x0 + size, z0 + size);
    c.scene = sceneOf(f, *f.kinds[kind], c, x, z, x0, z0);
    return c;
}

}  // namespace sward
