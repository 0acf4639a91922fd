// Tables of what formulas cost: for people, as CSV and as JSON.
#include <algorithm>
#include <array>
#include <cmath>

#include "formulas/kernels.h"

namespace sward {
namespace {

std::string errorText(double v) { return std::isnan(v) ? "none" : v == 0 ? "0" : fmt::format("{:.1e}", v); }
std::string nsText(const KernelTime& t) {
    return std::isnan(t.ns)
               ? "-"
               : fmt::format("{:.{}f} +-{:.{}f}", t.ns, t.ns < 100 ? 1 : 0, t.spread, t.spread < 100 ? 1 : 0);
}
std::string timesText(const KernelTime& t) {
    return std::isnan(t.times) ? "-" : fmt::format("{:.{}f}", t.times, t.times < 100 ? 1 : 0);
}

// Where the error is largest, else where there is none to be had; the first numbers, which say enough for people.
std::string placeText(const KernelError& e) {
    const std::vector<double>& at = e.at.empty() ? e.fails : e.at;
    std::string out;
    for (size_t i = 0; i < std::min<size_t>(at.size(), 5); ++i) out += fmt::format("{}{:.3g}", i ? " " : "", at[i]);
    return at.size() > 5 ? out + " .." : out;
}

std::string cell(double v) { return std::isfinite(v) ? shortestText(v) : ""; }
std::string cell(const std::vector<double>& numbers) {
    std::string out;
    for (const double v : numbers) out += (out.empty() ? "" : " ") + shortestText(v);
    return out;
}
std::string quoted(const std::string& text) {
    return text.find(',') == std::string::npos ? text : fmt::format("\"{}\"", text);
}

Json finiteOrNull(double v) { return std::isfinite(v) ? Json(v) : Json(); }
Json numbers(const std::vector<double>& values) {
    Json j = Json::makeArray();
    for (const double v : values) j.push(Json(v));
    return j;
}
double orNone(const KernelRun& run, double v) { return run.renderer.empty() ? std::nan("") : v; }

}  // namespace

std::string kernelText(const KernelRun& run) {
    size_t width = 4;
    for (const KernelRow& r : run.rows) width = std::max(width, r.form.size());
    std::string out;
    const auto line = [&](const std::array<std::string, 9>& c) {
        out += fmt::format("  {:<{}} {:>9} {:>8} {:>16} {:>8} {:>13} {:>16} {:>8}{}{}\n", c[0], width, c[1], c[2], c[3],
                           c[4], c[5], c[6], c[7], c[8].empty() ? "" : "  ", c[8]);
    };
    line({"form", "error CPU", "no value", "ns CPU", "times", "error shader", "ns shader", "times", "largest at"});
    for (size_t i = 0; i < run.rows.size(); ++i) {
        const KernelRow& r = run.rows[i];
        if (i == 0 || run.rows[i - 1].formula != r.formula)
            out += fmt::format("{}{}{}, {} inputs\n", r.id, r.id.empty() ? "" : " ", r.formula, r.inputs);
        line({r.form, errorText(r.cpu.largest), std::to_string(r.cpu.notFinite), nsText(r.cpuTime),
              timesText(r.cpuTime), run.renderer.empty() ? "-" : errorText(r.shader.largest), nsText(r.shaderTime),
              timesText(r.shaderTime), placeText(r.cpu)});
    }
    return out + fmt::format(
                     "error: largest, of float against double; no value: inputs without a finite answer on the CPU; "
                     "times: the cheapest form's; rounds: {}, median +- half of what lies between quartiles\n"
                     "shaders: {}\n",
                     run.rounds, run.renderer.empty() ? "not measured, there is no OpenGL context" : run.renderer);
}

std::string kernelCsv(const KernelRun& run) {
    std::string out = kKernelColumns;
    out += '\n';
    for (const KernelRow& r : run.rows) {
        out +=
            fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", r.id, quoted(r.formula), quoted(r.form),
                        r.inputs, cell(r.tolerance), cell(r.cpu.largest), cell(r.cpu.at), r.cpu.notFinite,
                        cell(r.cpu.fails), cell(r.cpuTime.ns), cell(r.cpuTime.spread), cell(r.cpuTime.times),
                        cell(orNone(run, r.shader.largest)), cell(orNone(run, r.shader.notFinite)),
                        cell(r.shaderTime.ns), cell(r.shaderTime.spread), cell(r.shaderTime.times));
    }
    return out;
}

Json kernelJson(const KernelRun& run) {
    Json j;
    j["sward"] = SWARD_VERSION, j["rounds"] = run.rounds, j["rows"] = Json::makeArray();
    j["renderer"] = run.renderer.empty() ? Json() : Json(run.renderer);
    for (const KernelRow& r : run.rows) {
        Json row;
        row["case"] = r.id, row["formula"] = r.formula, row["form"] = r.form, row["inputs"] = r.inputs,
        row["tolerance"] = finiteOrNull(r.tolerance);
        row["error"] = finiteOrNull(r.cpu.largest), row["error_at"] = numbers(r.cpu.at),
        row["not_finite"] = r.cpu.notFinite, row["not_finite_at"] = numbers(r.cpu.fails);
        row["ns_cpu"] = finiteOrNull(r.cpuTime.ns), row["ns_cpu_spread"] = finiteOrNull(r.cpuTime.spread),
        row["times_cpu"] = finiteOrNull(r.cpuTime.times);
        row["error_shader"] = finiteOrNull(orNone(run, r.shader.largest)),
        row["not_finite_shader"] = finiteOrNull(orNone(run, r.shader.notFinite));
        row["ns_shader"] = finiteOrNull(r.shaderTime.ns), row["ns_shader_spread"] = finiteOrNull(r.shaderTime.spread),
        row["times_shader"] = finiteOrNull(r.shaderTime.times);
        j["rows"].push(std::move(row));
    }
    return j;
}

}  // namespace sward
