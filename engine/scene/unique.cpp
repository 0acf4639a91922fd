#include "scene/unique.h"

#include "core/hash.h"
#include "core/jobs.h"
#include "core/numerics.h"

namespace sward {
namespace {

struct Cells {
    int x, z;
};
Cells cellsOf(const GrassField& f, const Terrain& t) {
    const double size = static_cast<double>(f.cellSize);
    return {static_cast<int>(std::ceil(t.size.x / size)), static_cast<int>(std::ceil(t.size.y / size))};
}

// A cell's blades where the density is 1: the whole ones, and one more as often as the rest asks for.
int bladesAtFull(const Species& s, const GrassField& f, uint32_t cellSeed) {
    const double expected =
        static_cast<double>(s.bladesPerM2) * static_cast<double>(f.cellSize) * static_cast<double>(f.cellSize);
    return static_cast<int>(std::min<double>(
        std::floor(expected + static_cast<double>(f32::hashUnit(f32::hash3(cellSeed, 1, 9)))), kMaxPatchBlades));
}

std::vector<Blade> bladesOfCell(const Species& s, const GrassField& f, const Terrain& t, int x, int z) {
    const uint32_t seed = f32::cellHash(x, z, static_cast<uint32_t>(f.seed));
    std::vector<Blade> blades = cellBlades(s, f.cellSize, seed, bladesAtFull(s, f, seed));
    const Tiling tiling = tilingOf(t, s.densityTiling);
    const double size = static_cast<double>(f.cellSize);
    std::erase_if(blades, [&](const Blade& b) {
        const double atX = x * size + static_cast<double>(b.root.x), atZ = z * size + static_cast<double>(b.root.y);
        const float density = s.density.present() ? tiledSample(s.density.map, tiling, atX, atZ) : 1.0f;
        return atX > t.size.x || atZ > t.size.y || density < b.threshold;
    });
    return blades;
}

}  // namespace

bool isUnique(const GrassField& f) { return f.population == static_cast<int>(Population::Unique); }

std::pair<uint32_t, uint32_t> UniqueBlades::range(int x, int z, float low, float high) const {
    const size_t cell = static_cast<size_t>(z) * static_cast<size_t>(cellsX) + static_cast<size_t>(x);
    const auto begin = patch.blades.begin() + first[cell], end = patch.blades.begin() + first[cell + 1];
    const auto from = std::lower_bound(begin, end, low, [](const Blade& b, float t) { return b.threshold < t; });
    const auto to = std::upper_bound(from, end, high, [](float t, const Blade& b) { return t < b.threshold; });
    return {static_cast<uint32_t>(from - patch.blades.begin()), static_cast<uint32_t>(to - patch.blades.begin())};
}

UniqueBlades makeUnique(const Species& s, const GrassField& f, const Terrain& t) {
    const Cells cells = cellsOf(f, t);
    std::vector<std::vector<Blade>> rows(static_cast<size_t>(cells.z));
    UniqueBlades u;
    u.cellsX = cells.x;
    u.first.assign(static_cast<size_t>(cells.x) * static_cast<size_t>(cells.z) + 1, 0);
    parallelFor(rows.size(), [&](size_t z) {
        for (int x = 0; x < cells.x; ++x) {
            const std::vector<Blade> own = bladesOfCell(s, f, t, x, static_cast<int>(z));
            u.first[z * static_cast<size_t>(cells.x) + static_cast<size_t>(x) + 1] = static_cast<uint32_t>(own.size());
            rows[z].insert(rows[z].end(), own.begin(), own.end());
        }
    });
    for (size_t i = 1; i < u.first.size(); ++i)
        u.mostInCell = std::max(u.mostInCell, u.first[i]), u.first[i] += u.first[i - 1];
    u.patch.blades.reserve(u.first.back());
    for (const std::vector<Blade>& row : rows) u.patch.blades.insert(u.patch.blades.end(), row.begin(), row.end());
    return u;
}

uint64_t uniqueKey(const Species& s, const GrassField& f, const Terrain& t) {
    Hasher h;
    const auto add = [&](const auto& v) { h.add(&v, sizeof(v)); };
    add(patchKey(s, f.cellSize, static_cast<uint32_t>(f.seed))), add(t.size), add(t.mapSize), add(s.densityTiling);
    return h.value();
}

std::string uniqueField(const Project& p) {
    for (const auto& [name, e] : p.entities)
        if (const GrassField* f = p.registry.get<GrassField>(e); f && isUnique(*f)) return name;
    return {};
}

Status checkUnique(const Project& p, double blades) {
    const std::string field = uniqueField(p);
    if (field.empty() || blades <= kMaxUniqueBlades) return {};
    const std::string path = field + ".GrassField.population";
    return unsound(fmt::format(
                       "{}: {:.0f} blades of their own are more than \"unique\" may have: {:.0f}, which take 128 MB",
                       path, blades, kMaxUniqueBlades),
                   "set it to \"patch\", or lower bladesPerM2 or the terrain's size")
        .at(p.dir.empty() ? std::string() : (p.dir / "project.json").string());
}

Status checkUnique(const Project& p) { return uniqueField(p).empty() ? Status() : checkUnique(p, virtualBlades(p)); }

}  // namespace sward
