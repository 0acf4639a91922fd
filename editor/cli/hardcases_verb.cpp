// `sward hardcases`: the table of hard cases on this machine, and one of them along its variable.
#include "cli/cli.h"
#include "core/file.h"
#include "core/log.h"
#include "formulas/case_plot.h"
#include "formulas/hardcases.h"
#include "maps/map_io.h"

namespace sward {
namespace {

constexpr int kLines = 24;  // of a curve that is printed

Result<HardCase> findCase(const std::string& key) {
    std::string known;
    for (HardCase& h : hardCases()) {
        if (h.key == key) return std::move(h);
        if (isSwept(h)) known += (known.empty() ? "" : ", ") + h.key;
    }
    return usage("there is no hard case \"" + key + "\"", "one of " + known);
}

// About kLines lines, with each point at which the printed form is no number.
std::string curveText(const HardCase& h) {
    const std::vector<CasePoint> points = sweepCase(h, kLines);
    const std::string unit = h.curve.unit.empty() ? "" : ", " + h.curve.unit;
    std::string out = fmt::format(
        "{}  {}\nshaders/numerics/{}, {}: {}\n{}\n\n{}{}; {}\n{:>12} {:>14} {:>14} {:>14} "
        "{:>12} {:>12}\n",
        h.key, h.row.name, h.curve.source, h.curve.function, h.curve.where, h.curve.picture, h.curve.variable, unit,
        h.curve.value, "at", "published", "ours", "wanted", "error", "ours, error");
    const auto output = static_cast<size_t>(h.curve.output);
    for (const CasePoint& p : points) {
        const bool has = !p.published.empty();
        out +=
            fmt::format("{:>12} {:>14} {:>14} {:>14} {:>12} {:>12}\n", caseNumber(p.at),
                        has ? caseNumber(p.published[output]) : "-", caseNumber(p.ours[output]),
                        caseNumber(p.truth[output]), has ? caseNumber(p.publishedError) : "-", caseNumber(p.oursError));
    }
    return out;
}

Status writeCurve(const HardCase& h, const std::filesystem::path& file) {
    if (file.extension() == ".csv") return writeFileAtomic(file, caseCsv(h, sweepCase(h)));
    const Plot plot = casePlot(h);
    if (file.extension() == ".svg") return writeFileAtomic(file, plotSvg(plot));
    return writeImagePng(file, plot.width, plot.height, 3, plotPixels(plot));
}

int curveVerb(const HardCasesOptions& o) {
    const std::string ending = std::filesystem::path(o.out).extension().string();
    if (!o.out.empty() && ending != ".png" && ending != ".svg" && ending != ".csv")
        return report(usage("a curve is written as .png, .svg or .csv", "name --out so").at(o.out));
    const auto found = findCase(o.curve);
    if (!found) return report(found.error());
    if (!isSwept(*found)) return report(failed(o.curve + " has no curve", found->curve.whyNot));
    if (o.out.empty()) {
        std::printf("%s", curveText(*found).c_str());
        return 0;
    }
    if (const Status s = writeCurve(*found, o.out); !s) return report(s.error());
    std::printf("%s: %s %s\n", o.out.c_str(), found->key.c_str(), found->row.name.c_str());
    return 0;
}

}  // namespace

int hardcasesVerb(const HardCasesOptions& o) {
    if (!o.curve.empty()) return curveVerb(o);
    auto gpu = makeHeadlessGpu();
    if (!gpu) logWarning(gpu.error().text() + "; the shaders' column stays empty");
    const std::vector<HardCaseRow> rows = runHardCases(gpu ? gpu->get() : nullptr);
    std::printf("%s", (o.json ? hardCasesJson(rows) : hardCasesText(rows)).c_str());
    return allPass(rows) ? 0 : 1;
}

}  // namespace sward
