// What a sweep found, as one HTML file that opens alone: plots, a table that sorts, and for each row of the frontier
// the truth, the picture and maps of its errors, all within the file. Does not: measure.
#pragma once
#include <filesystem>

#include "cost/cost.h"

namespace sward {

// techniques: rows of the table, for their colours. Writes cost.csv, cost.json, plot-<camera>.svg and .png,
// shipped.md (the project as it is, a row a camera) and report.html into the folder, each atomically. `work`: where the
// sweep kept its pictures; those that are not there are left out of the report.
Status writeCostFiles(const CostRun& run, const std::filesystem::path& folder, const std::filesystem::path& work,
                      std::span<const TechniqueRow> techniques);
std::string base64(std::string_view bytes);

}  // namespace sward
