#include "reference/standing.h"

#include <atomic>

#include "reference/ray_field.h"

namespace sward {
namespace {

// One species being collected, row by row.
struct Collector {
    const RayField& field;
    size_t kind;
    const StandingWithin& within;
    size_t most;
    std::atomic<size_t>& count;

    // False where the whole cell lies too far away.
    bool near(int x, int z) const {
        const double size = static_cast<double>(field.grass->cellSize);
        const glm::dvec2 low = glm::dvec2(x, z) * size;
        return within.holds(glm::clamp(within.at, low, low + size));
    }
    void cell(int x, int z, std::vector<StandingCell>& out) const {
        Cell c = bareCell(field, kind, x, z);
        const Kind& of = *field.kinds[kind];
        const uint32_t n = bladesIn(field, of, c, x, z);
        const glm::dvec2 corner = glm::dvec2(x, z) * static_cast<double>(field.grass->cellSize);
        StandingCell standing{{corner.x, c.base, corner.y}, {}};
        for (uint32_t i = 0; i < n; ++i) {
            const Posed b = poseBladeAt(field, of, c, x, z, i);
            if (b.width > 0 && within.holds(corner + glm::dvec2(b.root.x, b.root.z))) standing.blades.push_back(b);
        }
        if (standing.blades.empty()) return;
        count += standing.blades.size();
        out.push_back(std::move(standing));
    }
    void row(int z, int cells, std::vector<StandingCell>& out, const JobControl& control) const {
        for (int x = 0; x < cells && count <= most && !control.cancelled(); ++x)
            if (near(x, z)) cell(x, z, out);
    }
};

std::vector<StandingCell> cellsOf(const Collector& c, JobControl& control, double from, double share) {
    const double size = static_cast<double>(c.field.grass->cellSize);
    const glm::dvec2 extent = c.field.terrain->size;
    const int across = static_cast<int>(std::ceil(extent.x / size)),
              down = static_cast<int>(std::ceil(extent.y / size));
    std::vector<std::vector<StandingCell>> rows(static_cast<size_t>(down));
    std::atomic<int> done = 0;
    parallelFor(rows.size(), [&](size_t z) {
        c.row(static_cast<int>(z), across, rows[z], control);
        control.setProgress(from + share * ++done / down);
    });
    std::vector<StandingCell> out;
    for (std::vector<StandingCell>& row : rows) std::move(row.begin(), row.end(), std::back_inserter(out));
    return out;
}

}  // namespace

Result<std::vector<StandingSpecies>> standingBlades(const Project& p, double time, const StandingWithin& within,
                                                    size_t most, JobControl& control) {
    const auto fields = makeRayFields(p, time, control);
    if (!fields) return fields.error();
    std::vector<StandingSpecies> out;
    std::atomic<size_t> count = 0;
    size_t kinds = 0;
    for (const auto& f : *fields) kinds += f->kinds.size();
    for (const auto& f : *fields)
        for (size_t k = 0; k < f->kinds.size(); ++k) {
            const double share = 1.0 / static_cast<double>(kinds);
            auto cells = cellsOf({*f, k, within, most, count}, control, share * static_cast<double>(out.size()), share);
            if (control.cancelled()) return failed("cancelled");
            out.push_back({entityOf(p, *f->grass), f->kinds[k]->species, std::move(cells)});
        }
    return out;
}

}  // namespace sward
