#include "grass/mesh_planting.h"

#include <algorithm>
#include <array>

#include "core/numerics.h"
#include "scene/tiling.h"

namespace sward {
namespace {

constexpr int kBins = 16;                  // a side, of a cell's blades
constexpr size_t kMostPairs = 50'000'000;  // of triangles and the cells that they touch

glm::dvec2 inPatch(const MeshPlanting& p, uint32_t vertex) {
    return glm::dvec2(p.carrier.vertices[vertex].uv) * p.uvLength;
}

// Where in a cell the patch's blades stand, sorted into squares.
struct CellRoots {
    std::vector<glm::vec2> roots;  // metres, by blade
    std::array<std::vector<uint32_t>, kBins * kBins> bins;
};
int binOf(float at, float size) { return std::clamp(static_cast<int>(at / size * kBins), 0, kBins - 1); }
CellRoots rootsIn(const Patch& patch, const f32::CellVersion& version, float size) {
    CellRoots r;
    for (const Blade& b : patch.blades) {
        const glm::vec2 at = f32::rootInCell(b.root, version.mirror, version.shift, size);
        r.bins[static_cast<size_t>(binOf(at.y, size) * kBins + binOf(at.x, size))].push_back(
            static_cast<uint32_t>(r.roots.size()));
        r.roots.push_back(at);
    }
    return r;
}

// Weights of a triangle's corners at a place of the patch.
struct TriangleInPatch {
    std::array<glm::dvec2, 3> at;
    double area2;
    glm::dvec3 weights(const glm::dvec2& p) const {
        const auto part = [&](const glm::dvec2& a, const glm::dvec2& b) {
            return ((a.x - p.x) * (b.y - p.y) - (a.y - p.y) * (b.x - p.x)) / area2;
        };
        return {part(at[1], at[2]), part(at[2], at[0]), part(at[0], at[1])};
    }
};
TriangleInPatch triangleOf(const MeshPlanting& p, const CellPart& part) {
    TriangleInPatch c{};
    for (size_t k = 0; k < 3; ++k) c.at[k] = inPatch(p, p.carrier.indices[part.triangle + k]);
    c.area2 = (c.at[1].x - c.at[0].x) * (c.at[2].y - c.at[0].y) - (c.at[1].y - c.at[0].y) * (c.at[2].x - c.at[0].x);
    return c;
}

// What is the same for all blades of a species in a cell.
struct CellSowing {
    const MeshPlanting& p;
    const Patch& patch;
    f32::CellVersion version;
    float chance;
    glm::dvec2 corner;  // metres
};

glm::dvec3 mixed(const MeshPlanting& p, const CellPart& part, const glm::dvec3& w, glm::vec3 CarrierVertex::*member) {
    const auto at = [&](size_t k) {
        return glm::dvec3(p.carrier.vertices[p.carrier.indices[part.triangle + k]].*member);
    };
    return at(0) * w.x + at(1) * w.y + at(2) * w.z;
}

// The blade, if it stands on the triangle and the density lets it.
std::optional<MeshRoot> plant(const CellSowing& s, const TriangleInPatch& corners, const CellPart& part, uint32_t blade,
                              const glm::vec2& inCell) {
    const glm::dvec3 w = corners.weights(s.corner + glm::dvec2(inCell));
    if (!(w.x >= 0 && w.y >= 0 && w.z >= 0)) return std::nullopt;
    MeshRoot r{};
    r.uv = glm::vec2((s.corner + glm::dvec2(inCell)) / s.p.uvLength);
    const MapField& density = s.p.on.grows->density;
    r.density =
        density.present() ? tiledSample(density.map, {glm::dvec2(1), true}, double(r.uv.x), double(r.uv.y)) : 1.0f;
    r.sownAt = f32::thresholdIn(s.patch.blades[blade].threshold, s.patch.sown, s.chance);
    if (r.density < r.sownAt) return std::nullopt;
    r.position = mixed(s.p, part, w, &CarrierVertex::position), r.normal = mixed(s.p, part, w, &CarrierVertex::normal);
    r.alongU = mixed(s.p, part, w, &CarrierVertex::alongU), r.alongV = mixed(s.p, part, w, &CarrierVertex::alongV);
    r.bend = mixed(s.p, part, w, &CarrierVertex::bend);
    r.inCell = inCell, r.cellX = part.x, r.cellZ = part.z, r.mirror = s.version.mirror, r.blade = blade;
    for (size_t k = 0; k < 3; ++k) r.corners[k] = s.p.carrier.vertices[s.p.carrier.indices[part.triangle + k]].of;
    r.weights = glm::vec2(w);
    r.edged = s.p.carrier.vertices[s.p.carrier.indices[part.triangle]].part < 0;
    return r;
}

void plantCell(const MeshPlanting& p, std::span<const CellPart> parts, const Patch& patch, uint32_t sowSeed,
               const std::function<void(const MeshRoot&)>& visit) {
    const float size = p.field.cellSize;
    const CellPart& first = parts.front();
    const CellSowing sowing{p, patch, f32::cellVersion(first.x, first.z, static_cast<uint32_t>(p.field.seed)),
                            f32::cellChance(first.x, first.z, sowSeed),
                            glm::dvec2(first.x, first.z) * static_cast<double>(size)};
    const CellRoots roots = rootsIn(patch, sowing.version, size);
    for (const CellPart& part : parts) {
        const TriangleInPatch c = triangleOf(p, part);
        glm::vec2 low(1e30f), high(-1e30f);
        for (const glm::dvec2& at : c.at)
            low = glm::min(low, glm::vec2(at - sowing.corner)), high = glm::max(high, glm::vec2(at - sowing.corner));
        for (int z = binOf(low.y, size); z <= binOf(high.y, size); ++z)
            for (int x = binOf(low.x, size); x <= binOf(high.x, size); ++x)
                for (const uint32_t blade : roots.bins[static_cast<size_t>(z * kBins + x)])
                    if (const auto root = plant(sowing, c, part, blade, roots.roots[blade])) visit(*root);
    }
}

}  // namespace

Result<std::vector<CellPart>> cellsOf(const MeshPlanting& p) {
    std::vector<CellPart> out;
    const double size = static_cast<double>(p.field.cellSize);
    for (size_t i = 0; i < p.carrier.surface; i += 3) {
        glm::dvec2 low(1e30), high(-1e30);
        for (size_t k = 0; k < 3; ++k) {
            const glm::dvec2 at = inPatch(p, p.carrier.indices[i + k]) / size;
            low = glm::min(low, at), high = glm::max(high, at);
        }
        low = glm::floor(low), high = glm::floor(high);
        const glm::dvec2 cells = high - low + 1.0;
        if (!(glm::max(glm::abs(low), glm::abs(high)).x < 1e9) || !(glm::max(glm::abs(low), glm::abs(high)).y < 1e9) ||
            static_cast<double>(out.size()) + cells.x * cells.y > static_cast<double>(kMostPairs))
            return unsound(p.on.name + ".MeshGrass: its texture coordinates run over too many cells of the grass",
                           "give uvLength a smaller value, or the field larger cells");
        for (int z = static_cast<int>(low.y); z <= static_cast<int>(high.y); ++z)
            for (int x = static_cast<int>(low.x); x <= static_cast<int>(high.x); ++x)
                out.push_back({x, z, static_cast<uint32_t>(i)});
    }
    std::sort(out.begin(), out.end(), [](const CellPart& a, const CellPart& b) {
        return std::pair(a.cell(), a.triangle) < std::pair(b.cell(), b.triangle);
    });
    return out;
}

bool plantOn(const MeshPlanting& p, std::span<const CellPart> cells, const Species& species, const Patch& patch,
             const JobControl& control, const std::function<void(const MeshRoot&)>& visit) {
    const uint32_t sowSeed = sowingSeed(species, static_cast<uint32_t>(p.field.seed));
    for (size_t i = 0, end = 0; i < cells.size(); i = end) {
        if (control.cancelled()) return false;
        while (end < cells.size() && cells[end].cell() == cells[i].cell()) ++end;
        plantCell(p, cells.subspan(i, end - i), patch, sowSeed, visit);
    }
    return true;
}

double bladesAsked(const MeshPlanting& p) {
    double perM2 = 0;
    for (const Species& s : p.field.species) perM2 += static_cast<double>(s.bladesPerM2);
    return perM2 * p.carrier.uvArea * p.uvLength * p.uvLength;
}

}  // namespace sward
