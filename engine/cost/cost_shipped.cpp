#include "cost/cost_shipped.h"

#include <algorithm>

namespace sward {
namespace {

const CostRow* shippedRow(const CostRun& run, const std::string& camera) {
    const auto at = std::find_if(run.rows.begin(), run.rows.end(), [&](const CostRow& r) {
        return r.camera == camera && r.settings == kAsItIs && r.skipped.empty();
    });
    return at == run.rows.end() ? nullptr : &*at;
}

std::string briefly(const CostRow& r) {
    return fmt::format("{} {}, {:.4f} at {:.0f} ms", r.technique, r.settings, r.metrics.appearance.distance,
                       r.msMedian);
}
std::string beaters(const ShippedStanding& s) {
    if (s.beatenBy.empty()) return "on the frontier";
    const std::string others =
        s.beatenBy.size() > 1 ? fmt::format(", and {} more", s.beatenBy.size() - 1) : std::string();
    return "beaten by " + briefly(*s.beatenBy.front()) + others;
}

}  // namespace

std::vector<ShippedStanding> shippedStandings(const CostRun& run) {
    std::vector<ShippedStanding> out;
    for (const CostFloors& f : run.floors) {
        const CostRow* row = shippedRow(run, f.camera);
        if (!row) continue;
        const double error = row->metrics.appearance.distance;
        ShippedStanding s{row, error / f.seed.distance, error / f.flat.distance, {}};
        for (const CostRow& r : run.rows)
            if (r.camera == row->camera && r.machine == row->machine && r.skipped.empty() && beats(r, *row))
                s.beatenBy.push_back(&r);
        std::sort(s.beatenBy.begin(), s.beatenBy.end(), [](const CostRow* a, const CostRow* b) {
            return a->metrics.appearance.distance < b->metrics.appearance.distance;
        });
        out.push_back(std::move(s));
    }
    return out;
}

std::string standingText(const ShippedStanding& s) {
    return fmt::format("{:.2f} times other blades, {:.2f} of flat rows, {}", s.ofBlades, s.ofFlatRows, beaters(s));
}

std::string shippedHeader() {
    return "| project | pixels | camera | error | ms | times other blades | of flat rows | frontier |\n"
           "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
}

std::string shippedRows(const CostRun& run) {
    std::string out;
    for (const ShippedStanding& s : shippedStandings(run)) {
        const Appearance& a = s.row->metrics.appearance;
        out += fmt::format("| `{}` | {}x{} | `{}` | {:.4f} ± {:.4f} | {:.0f} | {:.2f} | {:.2f} | {} |\n", run.project,
                           run.width, run.height, s.row->camera, a.distance, a.sigma, s.row->msMedian, s.ofBlades,
                           s.ofFlatRows, beaters(s));
    }
    return out;
}

}  // namespace sward
