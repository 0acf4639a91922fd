// Made-up results of a sweep.
#pragma once
#include "cost/cost.h"

namespace sward::test {

inline CostRow row(int index, double ms, double error, const std::string& camera = "eye") {
    CostRow r;
    r.camera = camera, r.technique = "hybrid", r.settings = "maxGeom=" + std::to_string(index), r.index = index;
    r.msMedian = ms, r.msP95 = 2 * ms;
    r.metrics.appearance = {error, error / 2, error / 3, 0.1 * error};
    r.metrics.flip = 0.25, r.metrics.ssim = 0.5, r.metrics.rmse = 0.125,
    r.metrics.psnr = std::numeric_limits<double>::infinity();
    r.converged = r.metrics.appearance;
    r.gpuBytes = 1000, r.image = "row.png";
    return r;
}
inline CostRun run(std::vector<CostRow> rows, int total) {
    CostRun r;
    r.project = "park", r.hash = "abc", r.width = 320, r.height = 240, r.samples = 64, r.lighting = "full",
    r.total = total;
    r.machines = {{"llvmpipe", "wall-finish", 2}};
    r.floors = {{"eye", {0.01, 0.01, 0, 0.001}, {0.02, 0.01, 0, 0.001}, {0.2, 0.1, 0.1, 0.001}, 0.004, "truth.png"}};
    r.rows = std::move(rows);
    return r;
}

}  // namespace sward::test
