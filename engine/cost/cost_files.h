// A sweep's results as files: cost.csv for tables, cost.json with all that is known, and parts of a sharded sweep
// joined. Does not: draw plots or the report (cost_report.h).
#pragma once
#include "core/json.h"
#include "cost/cost.h"

namespace sward {

// Columns of cost.csv; they hold from the first release.
inline constexpr const char* kCostColumns =
    "camera,technique,settings,ms_median,ms_p95,appearance,appearance_sigma,bias,contrast,flip,rmse,gpu_bytes,on_"
    "frontier,skipped";
// A field with a comma, quote or line break stands in quotes; what was not taken is empty; on_frontier is 0 or 1.
std::string costCsv(const CostRun& run);

// What has no value is null.
Json costRowJson(const CostRow& row);
Result<CostRow> costRowFrom(const Json& json);
Json costJson(const CostRun& run);
// Unsound error naming the file and what is missing.
Result<CostRun> costFrom(const Json& json, const std::string& file);
// A cost.json, or the folder that holds one. Unsound also: any value another than was written, by the hash it names.
Result<CostRun> readCost(const std::filesystem::path& file);

// The whole of a sharded sweep: rows in the order of the sweep, each with the machine that took its time; frontiers
// are those of each machine; of rows that draw the same picture the first is left. Failed: parts of different sweeps,
// or a row that is there twice or nowhere, named.
Result<CostRun> mergeCosts(const std::vector<CostRun>& parts);

}  // namespace sward
