// The report of hard cases: what each published formula does on this machine where it breaks, and what replaces it.
// Does not: choose inputs or tolerances; the rows of the table of formulas do (formulas/formula_rows.h).
// Cost: below a second on the CPU, a few seconds with a GPU context, nearly all of it compiling shaders.
#pragma once
#include <string>
#include <vector>

#include "formulas/formula_rows.h"
#include "gpu/gpu.h"

namespace sward {

struct HardCaseRow {
    std::string id;  // "B-1"
    std::string name;
    bool hasPublished = false;  // some rows show ours only
    double published = 0;       // largest error of the printed form, float on this CPU; NaN or infinity where it breaks
    double oursCpu = 0;         // largest error of ours in float; NaN where it is not finite
    bool hasGpu = false;
    double oursGpu = 0;    // error of ours on the GPU
    double tolerance = 0;  // of the CPU
    double gpuTolerance = 0;
    bool pass = false;  // errors within their tolerances, every output finite and in range
    std::string fault;  // why the row could not be run, or empty
};

// One row of the table on its samples; gpu may be null.
HardCaseRow runHardCase(const FormulaRow& row, const ExpectedValues& values, Gpu* gpu);
// Every hard case; gpu may be null: CPU only. Where the expected values cannot be read, one failing row says so.
std::vector<HardCaseRow> runHardCases(Gpu* gpu);
bool allPass(const std::vector<HardCaseRow>& rows);

// An aligned table with a line a row and a last line that counts them.
std::string hardCasesText(const std::vector<HardCaseRow>& rows);
// {"rows": [{"id", "name", "published", "ours_cpu", "ours_gpu", "tolerance", "pass"}, ...]}: errors that are no numbers
// are "nan" or "inf", what was not run is null.
std::string hardCasesJson(const std::vector<HardCaseRow>& rows);

}  // namespace sward
