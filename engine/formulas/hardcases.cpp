#include "formulas/hardcases.h"

#include <algorithm>
#include <cmath>

#include "formulas/formula_gpu.h"

namespace sward {
namespace {

bool runOnThisGpu(Gpu& gpu, const FormulaRow& row, const FormulaSamples& samples, HardCaseRow& out) {
    const auto outputs = runOnGpu(gpu, row, row.ours, samples);
    if (!outputs) {
        out.fault = outputs.error().text();
        return false;
    }
    out.hasGpu = true;
    out.oursGpu = largestError(row, samples, *outputs);
    return out.oursGpu <= out.gpuTolerance && outOfRange(row, *outputs) == 0;
}

std::string number(double error) {
    if (std::isnan(error)) return "NaN";
    if (std::isinf(error)) return "inf";
    return fmt::format("{:.2g}", error);
}

std::string jsonNumber(bool has, double error) {
    if (!has) return "null";
    if (std::isnan(error)) return "\"nan\"";
    if (std::isinf(error)) return "\"inf\"";
    return fmt::format("{}", error);
}

std::string jsonText(const std::string& text) {
    std::string out = "\"";
    for (char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c == '\n' ? ' ' : c;
    }
    return out + "\"";
}

}  // namespace

HardCaseRow runHardCase(const FormulaRow& row, const ExpectedValues& values, Gpu* gpu) {
    HardCaseRow out;
    out.id = row.id;
    out.name = row.name;
    out.tolerance = row.tolerance;
    out.gpuTolerance = row.gpuTolerance > 0 ? row.gpuTolerance : row.tolerance;
    const FormulaSamples samples = samplesOf(row, values);
    if (samples.count == 0) {
        out.fault = "the expected values have no such group";
        return out;
    }
    out.hasPublished = bool(row.published);
    if (out.hasPublished) out.published = largestError(row, samples, runSingle(row, row.published, samples));
    const auto outputs = runSingle(row, row.ours, samples);
    out.oursCpu = largestError(row, samples, outputs);
    out.pass = out.oursCpu <= out.tolerance && outOfRange(row, outputs) == 0;
    if (gpu && !runOnThisGpu(*gpu, row, samples, out)) out.pass = false;
    return out;
}

std::vector<HardCaseRow> runHardCases(Gpu* gpu) {
    std::vector<HardCaseRow> out;
    const auto values = loadExpectedValues(expectedValuesFile());
    if (!values) {
        HardCaseRow row;
        row.id = "-";
        row.name = "expected values";
        row.fault = values.error().text();
        return {row};
    }
    for (const FormulaRow& row : formulaRows())
        if (!row.id.empty()) out.push_back(runHardCase(row, *values, gpu));
    return out;
}

bool allPass(const std::vector<HardCaseRow>& rows) {
    return std::all_of(rows.begin(), rows.end(), [](const HardCaseRow& r) { return r.pass; });
}

std::string hardCasesText(const std::vector<HardCaseRow>& rows) {
    size_t width = 4;
    for (const HardCaseRow& r : rows) width = std::max(width, r.name.size());
    std::string out = fmt::format("{:<5} {:<{}} {:>10} {:>10} {:>10} {:>10}\n", "case", "what", width, "published",
                                  "ours, CPU", "ours, GPU", "tolerance");
    size_t passed = 0;
    for (const HardCaseRow& r : rows) {
        passed += r.pass;
        const bool ran = r.fault.empty() || r.hasPublished || r.hasGpu;
        out += fmt::format("{:<5} {:<{}} {:>10} {:>10} {:>10} {:>10} {}{}\n", r.id, r.name, width,
                           r.hasPublished ? number(r.published) : "-", ran ? number(r.oursCpu) : "-",
                           r.hasGpu ? number(r.oursGpu) : "-",
                           r.gpuTolerance > r.tolerance && r.hasGpu ? number(r.tolerance) + "/" + number(r.gpuTolerance)
                                                                    : number(r.tolerance),
                           r.pass ? "pass" : "FAIL", r.fault.empty() ? "" : ": " + r.fault);
    }
    return out + fmt::format("{} of {} pass\n", passed, rows.size());
}

std::string hardCasesJson(const std::vector<HardCaseRow>& rows) {
    std::string out = "{\n  \"rows\": [";
    for (size_t i = 0; i < rows.size(); ++i) {
        const HardCaseRow& r = rows[i];
        out += fmt::format(
            "{}\n    {{\"id\": {}, \"name\": {}, \"published\": {}, \"ours_cpu\": {}, \"ours_gpu\": {}, \"tolerance\": "
            "{}, "
            "\"tolerance_gpu\": {}, \"pass\": {}}}",
            i ? "," : "", jsonText(r.id), jsonText(r.name), jsonNumber(r.hasPublished, r.published),
            jsonNumber(true, r.oursCpu), jsonNumber(r.hasGpu, r.oursGpu), jsonNumber(true, r.tolerance),
            jsonNumber(true, r.gpuTolerance), r.pass ? "true" : "false");
    }
    return out + "\n  ]\n}\n";
}

}  // namespace sward
