#include "world/scatter.h"

#include <algorithm>
#include <cmath>

#include "core/hash.h"
#include "core/jobs.h"
#include "core/numerics.h"
#include "scene/tiling.h"
#include "world/placement.h"

namespace sward {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kJamming = 0.5470735;  // coverage of discs at which none finds room any more
constexpr double kFullest = 0.9;        // share of it that is thrown for
constexpr double kDartsInCell = 8;      // in the mean, where the distance lets cells be so small

// Share of the ground where a disc finds room, by the share of the jamming coverage that is covered (Ricci, Schaaf and
// Talbot 1992; its first three terms are exact).
double room(double x) { return (1 + x * (0.812 + x * (0.4258 + x * 0.0716))) * (1 - x) * (1 - x) * (1 - x); }

// Cells from one beyond the terrain on each side: darts there take room as those within do, so that its edges are no
// better a place than its middle. A neighbour within the distance lies in the same cell or beside it.
struct Grid {
    double side;
    int across, down;
    // Number of the cell at x, z, which count from -1.
    size_t at(int x, int z) const { return static_cast<size_t>((z + 1) * across + x + 1); }
};
Grid gridOf(const glm::dvec2& size, double darts, double distance) {
    const double side = std::clamp(std::sqrt(kDartsInCell / std::max(darts, 1e-12)), std::max(distance, 0.25),
                                   std::max(distance, 256.0));
    return {side, static_cast<int>(std::ceil(size.x / side)) + 2, static_cast<int>(std::ceil(size.y / side)) + 2};
}

// A dart that lies where the rule allows it.
struct Dart {
    double x, z;
    uint32_t hash, order;
};

uint32_t part(uint32_t hash, uint32_t number) { return f32::hash2(hash, number); }
double unit(uint32_t hash, uint32_t number) { return static_cast<double>(f32::hashUnit(part(hash, number))); }

struct Thrower {
    const Scatter& s;
    const Terrain& t;
    Tiling tiling;
    double perM2, darts;  // a square metre, at density 1
    Grid grid;
    const KeepOff& off;

    // 24 bits would show as steps on a large cell: 32 are used.
    static double fine(uint32_t hash, uint32_t number) { return part(hash, number) * (1.0 / 4294967296.0); }

    bool inside(double x, double z) const { return x >= 0 && z >= 0 && x <= t.size.x && z <= t.size.y; }
    double densityAt(double x, double z) const {
        return s.density.present() ? std::clamp(static_cast<double>(tiledSample(s.density.map, tiling, x, z)), 0.0, 1.0)
                                   : 1.0;
    }
    bool allowed(double x, double z) const {
        const double height = terrainHeight(t, x, z);
        if (height < s.heights.x || height > s.heights.y) return false;
        const double slope = glm::degrees(std::acos(std::min(terrainNormal(t, x, z).y, 1.0)));
        return slope >= s.slopeDeg.x && slope <= s.slopeDeg.y;
    }
    // Adds a cell's darts; `asked` grows by the objects that the density asks for there.
    void cell(int x, int z, std::vector<Dart>& out, double& asked) const {
        const uint32_t seed = f32::cellHash(x, z, f32::hash2(static_cast<uint32_t>(s.seed), 0x5CA77E2u));
        const double expected = darts * grid.side * grid.side;
        const uint32_t count = static_cast<uint32_t>(std::floor(expected + fine(seed, 1)));
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t h = f32::hash2(seed, 2 + i);
            const double px = (x + fine(h, 1)) * grid.side, pz = (z + fine(h, 2)) * grid.side;
            const double density = densityAt(px, pz);
            if (density <= 0 || !allowed(px, pz) || off.holds(px, pz)) continue;
            if (inside(px, pz)) asked += density * perM2 / darts;
            if (fine(h, 3) * darts < dartsFor(density * perM2, static_cast<double>(s.distance)))
                out.push_back({px, pz, h, part(h, 4)});
        }
    }
};

// Those that stay, in the order of `darts`.
std::vector<Dart> staying(const std::vector<Dart>& darts, const Grid& grid, double distance) {
    if (!(distance > 0)) return darts;
    std::vector<uint32_t> order(darts.size());
    for (uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(),
              [&](uint32_t a, uint32_t b) { return std::pair(darts[a].order, a) < std::pair(darts[b].order, b); });
    constexpr uint32_t kNone = ~0u;
    std::vector<uint32_t> first(static_cast<size_t>(grid.across) * static_cast<size_t>(grid.down), kNone),
        next(darts.size(), kNone);
    std::vector<bool> stays(darts.size());
    for (const uint32_t i : order) {
        const Dart& d = darts[i];
        const int cx = static_cast<int>(std::floor(d.x / grid.side)),
                  cz = static_cast<int>(std::floor(d.z / grid.side));
        bool free = true;
        for (int z = std::max(cz - 1, -1); free && z <= std::min(cz + 1, grid.down - 2); ++z)
            for (int x = std::max(cx - 1, -1); free && x <= std::min(cx + 1, grid.across - 2); ++x)
                for (uint32_t k = first[grid.at(x, z)]; free && k != kNone; k = next[k])
                    free = std::hypot(darts[k].x - d.x, darts[k].z - d.z) >= distance;
        if (!free) continue;
        stays[i] = true;
        next[i] = std::exchange(first[grid.at(cx, cz)], i);
    }
    std::vector<Dart> out;
    for (size_t i = 0; i < darts.size(); ++i)
        if (stays[i]) out.push_back(darts[i]);
    return out;
}

// The least rotation that takes the upright to `up`, after a turn about it.
glm::mat3 turnOf(const glm::dvec3& up, double headingDeg) {
    const glm::dmat3 heading = rotationOf({0, headingDeg, 0});
    const double k = 1 / (1 + up.y);  // up.y >= 0
    const glm::dmat3 tilt(glm::dvec3(1 - up.x * up.x * k, -up.x, -up.x * up.z * k), up,
                          glm::dvec3(-up.x * up.z * k, -up.z, 1 - up.z * up.z * k));
    return glm::mat3(tilt * heading);
}

uint32_t meshFor(const Scatter& s, double at) {
    double all = 0;
    for (const ScatterMesh& m : s.meshes) all += isScattered(m) ? static_cast<double>(m.share) : 0;
    double left = at * all;
    uint32_t last = 0;
    for (uint32_t i = 0; i < s.meshes.size(); ++i) {
        if (!isScattered(s.meshes[i])) continue;
        last = i;
        left -= static_cast<double>(s.meshes[i].share);
        if (left < 0) break;
    }
    return last;
}

ScatteredObject objectOf(const Scatter& s, const Ground& ground, const Dart& d) {
    const auto within = [&](const glm::dvec2& r, uint32_t number) { return glm::mix(r.x, r.y, unit(d.hash, number)); };
    ScatteredObject o;
    o.at = ground.origin + glm::dvec3(d.x, terrainHeight(*ground.terrain, d.x, d.z), d.z);
    const glm::dvec3 normal = s.alignToGround > 0 ? terrainNormal(*ground.terrain, d.x, d.z) : glm::dvec3(0, 1, 0);
    const glm::dvec3 up = glm::normalize(glm::mix(glm::dvec3(0, 1, 0), normal, static_cast<double>(s.alignToGround)));
    o.turn = turnOf(up, within(s.headingDeg, 5));
    o.scale = static_cast<float>(within(s.size, 6));
    o.mesh = meshFor(s, unit(d.hash, 7));
    return o;
}

uint64_t hashOf(const std::vector<ScatteredObject>& objects) {
    Hasher h;
    const auto add = [&](const auto& v) { h.add(&v, sizeof(v)); };
    for (const ScatteredObject& o : objects) add(o.at), add(o.turn), add(o.scale), add(o.mesh);
    return h.value();
}

bool sameMeshes(const Scatter& a, const Scatter& b) {
    return std::equal(a.meshes.begin(), a.meshes.end(), b.meshes.begin(), b.meshes.end(),
                      [](const ScatterMesh& x, const ScatterMesh& y) {
                          return isScattered(x) == isScattered(y) && x.share == y.share;
                      });
}
bool sameRule(const Scatter& a, const Scatter& b) {
    return sameMeshes(a, b) && a.perHectare == b.perHectare && a.density.map.sameTiles(b.density.map) &&
           a.densityTiling == b.densityTiling && a.distance == b.distance && a.slopeDeg == b.slopeDeg &&
           a.heights == b.heights && a.size == b.size && a.headingDeg == b.headingDeg &&
           a.alignToGround == b.alignToGround && a.seed == b.seed;
}

}  // namespace

double dartsFor(double perM2, double distance) {
    if (!(distance > 0) || !(perM2 > 0)) return std::max(perM2, 0.0);
    const double disc = kPi / 4 * distance * distance, x = std::min(perM2 * disc / kJamming, kFullest);
    constexpr int kSteps = 64;  // Simpson's rule over 1 / room
    double sum = 0;
    for (int i = 0; i <= kSteps; ++i) sum += (i == 0 || i == kSteps ? 1 : i % 2 ? 4 : 2) / room(x * i / kSteps);
    return kJamming * x / (3 * kSteps) * sum / disc;
}

Scattering scatterOver(const Scatter& s, const Ground& ground, const KeepOff& off) {
    Scattering out;
    if (!ground.terrain || !scatters(s)) return out;
    const Terrain& t = *ground.terrain;
    const double perM2 = static_cast<double>(s.perHectare) / 1e4, distance = static_cast<double>(s.distance);
    if (const double all = perM2 * t.size.x * t.size.y; all > kMostScattered) {
        out.asked = all;
        return out;
    }
    const double darts = dartsFor(perM2, distance);
    const Thrower thrower{s, t, tilingOf(t, s.densityTiling), perM2, darts, gridOf(t.size, darts, distance), off};
    std::vector<std::vector<Dart>> rows(static_cast<size_t>(thrower.grid.down));
    std::vector<double> asked(rows.size());
    parallelFor(rows.size(), [&](size_t z) {
        for (int x = -1; x < thrower.grid.across - 1; ++x) thrower.cell(x, static_cast<int>(z) - 1, rows[z], asked[z]);
    });
    std::vector<Dart> all;
    for (const std::vector<Dart>& row : rows) all.insert(all.end(), row.begin(), row.end());
    for (const double a : asked) out.asked += a;
    for (const Dart& d : staying(all, thrower.grid, distance))
        if (thrower.inside(d.x, d.z)) out.objects.push_back(objectOf(s, ground, d));
    out.hash = hashOf(out.objects);
    return out;
}

Scattering scatterIn(const Project& p, const Scatter& s, const Ground& ground) {
    Footprints outlines;
    return scatterOver(s, ground, keepOffOf(p, ground, s, outlines));
}

std::string shortfall(const std::string& entity, const Scatter& s, const Scattering& made) {
    if (static_cast<double>(made.objects.size()) >= 0.9 * made.asked) return {};
    if (made.asked > kMostScattered)
        return fmt::format(
            "{}.Scatter.perHectare: {:.0f} objects are asked for; the most are {:.0f}, and none is "
            "scattered (lower it)",
            entity, made.asked, kMostScattered);
    return fmt::format(
        "{}.Scatter.distance: {} of {:.0f} objects find room at {} m from each other (lower distance or "
        "perHectare)",
        entity, made.objects.size(), made.asked, s.distance);
}

std::vector<std::pair<std::string, const Scatter*>> scattersOf(const Project& p) {
    std::vector<std::pair<std::string, const Scatter*>> out;
    for (const auto& [name, e] : p.entities)
        if (const Scatter* s = p.registry.get<Scatter>(e); s && scatters(*s)) out.emplace_back(name, s);
    return out;
}

std::shared_ptr<const Scattering> ScatterMemory::of(const Project& p, const Ground& ground, const std::string& entity,
                                                    const Scatter& s) {
    Entry& e = entries_[entity];
    const bool there = ground.terrain != nullptr;
    std::string off = keepOffInputs(p, ground, s);
    if (e.made && e.there == there && e.origin == ground.origin && sameRule(e.rule, s) && e.off == off &&
        (!there || sameGround(e.terrain, *ground.terrain)))
        return e.made;
    e = {s,
         there ? *ground.terrain : Terrain{},
         ground.origin,
         there,
         std::move(off),
         std::make_shared<const Scattering>(scatterOver(s, ground, keepOffOf(p, ground, s, outlines_)))};
    return e.made;
}

void ScatterMemory::keepOnly(const std::vector<std::pair<std::string, const Scatter*>>& all) {
    std::erase_if(entries_, [&](const auto& e) {
        return std::none_of(all.begin(), all.end(), [&](const auto& s) { return s.first == e.first; });
    });
}

}  // namespace sward
