// Index: text · pictures · the table · the page · files.
#include "cost/cost_report.h"

#include "core/file.h"
#include "cost/cost_files.h"
#include "cost/cost_plot.h"
#include "cost/cost_shipped.h"
#include "maps/map_io.h"
#include "metrics/heatmap.h"

namespace sward {
namespace {
namespace fs = std::filesystem;

constexpr uint64_t kMaxPicture = 256 << 20;

// --- text --------------------------------------------------------------------------------------------------------
constexpr const char* kHead = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<style>
:root { color-scheme: light dark; --line: #8884; --soft: #8882; }
body { font: 15px/1.5 system-ui, "DejaVu Sans", sans-serif; max-width: 1320px; margin: 2em auto; padding: 0 1em; }
h1 { font-size: 1.5em; } h2 { font-size: 1.2em; margin-top: 2em; } h3 { font-size: 1em; margin: 1.5em 0 .4em; }
table { border-collapse: collapse; font-size: 13px; width: 100%; }
th, td { padding: .25em .45em; border-bottom: 1px solid var(--line); text-align: right; font-variant-numeric: tabular-nums; }
th:nth-child(-n+3), td:nth-child(-n+3) { text-align: left; } td:nth-child(2) { min-width: 21em; }
th { cursor: pointer; white-space: nowrap; } tr.frontier { background: var(--soft); font-weight: 600; }
.strip { display: grid; grid-template-columns: repeat(4, 1fr); gap: .5em; } .strip figure { margin: 0; }
.strip img { width: 100%; display: block; } figcaption { font-size: 12px; opacity: .8; }
svg { max-width: 100%; height: auto; }
</style>
)";
constexpr const char* kSort = R"(<script>
for (const th of document.querySelectorAll("th")) th.onclick = () => {
  const table = th.closest("table"), body = table.tBodies[0], i = th.cellIndex, up = th.dataset.up = th.dataset.up === "1" ? "0" : "1";
  const value = r => r.cells[i].textContent, number = t => t === "" ? Infinity : Number(t);
  const rows = [...body.rows].sort((a, b) => {
    const x = value(a), y = value(b), c = isNaN(number(x)) || isNaN(number(y)) ? x.localeCompare(y) : number(x) - number(y);
    return up === "1" ? c : -c;
  });
  body.append(...rows);
};
</script>
)";

std::string cell(double v, const char* format) { return std::isfinite(v) ? fmt::format(fmt::runtime(format), v) : ""; }

// --- pictures ----------------------------------------------------------------------------------------------------
std::string figure(const fs::path& file, const std::string& caption) {
    const auto bytes = readFile(file, kMaxPicture);
    if (!bytes) return "";
    return "<figure><img alt=\"" + escaped(caption) + "\" src=\"data:image/png;base64," + base64(*bytes) +
           "\"><figcaption>" + escaped(caption) + "</figcaption></figure>\n";
}
// The heat map's file, beside the picture; nothing if one of both cannot be read.
std::optional<fs::path> heatFile(const fs::path& image, const fs::path& truth, ErrorMetric metric) {
    const auto a = readImage(image), b = readImage(truth);
    if (!a || !b) return {};
    const auto pair = pairPictures(pictureOf(*a, false), pictureOf(*b, false));
    if (!pair) return {};
    const fs::path file = fs::path(image).replace_extension(std::string(".") + kErrorMetrics[metric] + ".png");
    if (!writeImagePng(file, a->width, a->height, 3, heatmap(errorMap(*pair, metric), heatScale(metric)))) return {};
    return file;
}
std::string strip(const CostRow& row, const CostFloors& floors, const fs::path& work) {
    const fs::path image = work / row.image, truth = work / floors.image;
    std::string out = figure(truth, "truth") + figure(image, "as drawn");
    for (const auto& [metric, name] :
         {std::pair{ErrorMetric::Appearance, "appearance, 0 to 0.2"}, std::pair{ErrorMetric::Flip, "FLIP, 0 to 1"}})
        if (const auto file = heatFile(image, truth, metric)) out += figure(*file, name);
    return "<div class=\"strip\">\n" + out + "</div>\n";
}

// --- the table ---------------------------------------------------------------------------------------------------
std::string tableOf(const CostRun& run, const std::string& camera) {
    std::string out =
        "<table><thead><tr><th>technique<th>settings<th>frontier<th>ms<th>&plusmn;<th>frames<th>p95<th>appearance<th>&"
        "plusmn;<th>bias<th>contrast<th>converged<th>FLIP<th>SSIM<th>RMSE<th>GPU MB</tr></thead><tbody>\n";
    for (const CostRow& r : run.rows) {
        if (r.camera != camera || !r.skipped.empty()) continue;
        const auto value = [&](double v, const char* format) { return "<td>" + cell(v, format); };
        const Appearance& a = r.metrics.appearance;
        out += fmt::format("<tr{}><td>{}<td>{}<td>{}", r.onFrontier ? " class=\"frontier\"" : "", escaped(r.technique),
                           escaped(r.settings), r.onFrontier ? "yes" : "");
        out += value(r.msMedian, "{:.1f}") + value(r.msSigma, "{:.1f}") + "<td>" + std::to_string(r.ms.size()) +
               value(r.msP95, "{:.1f}") + value(a.distance, "{:.5f}") + value(a.sigma, "{:.5f}") +
               value(a.bias, "{:.5f}") + value(a.contrast, "{:.5f}");
        out += value(r.converged.distance, "{:.5f}") + value(r.metrics.flip, "{:.4f}") +
               value(r.metrics.ssim, "{:.4f}") + value(r.metrics.rmse, "{:.4f}");
        out += value(static_cast<double>(r.gpuBytes) / 1e6, "{:.1f}") + "</tr>\n";
    }
    return out + "</tbody></table>\n";
}
std::string leftOut(const CostRun& run, const std::string& camera) {
    std::string rows;
    int n = 0;
    for (const CostRow& r : run.rows)
        if (r.camera == camera && !r.skipped.empty())
            rows += "<li>" + escaped(r.technique + " " + r.settings + ": " + r.skipped) + "\n", ++n;
    return n == 0 ? ""
                  : fmt::format("<details><summary>Left out: {} settings</summary><ul>\n{}</ul></details>\n", n, rows);
}
std::string floorsText(const CostFloors& f) {
    return fmt::format(
        "<p>To hold scores against: other blades of the same field {:.5f}; the truth at few samples a pixel {:.5f}; "
        "the truth with flat rows for grass {:.5f}. Mean standard error of the truth "
        "{:.5f} (linear). A score below the first is as good as it need be; one above the last is worthless.</p>\n",
        f.seed.distance, f.sampling.distance, f.flat.distance, f.truthError);
}

// --- the page ----------------------------------------------------------------------------------------------------
std::string cameraPart(const CostRun& run, const CostFloors& f, const fs::path& work,
                       std::span<const TechniqueRow> techniques) {
    std::string out = "<h2>Camera " + escaped(f.camera) + "</h2>\n" + floorsText(f);
    for (const ShippedStanding& s : shippedStandings(run))
        if (s.row->camera == f.camera) out += "<p>As it is: " + escaped(standingText(s)) + ".</p>\n";
    if (const Plot plot = costPlot(run, f.camera, techniques); plot.width > 0) out += plotSvg(plot);
    out += tableOf(run, f.camera) + leftOut(run, f.camera);
    std::vector<const CostRow*> frontier;
    for (const CostRow& r : run.rows)
        if (r.camera == f.camera && r.onFrontier) frontier.push_back(&r);
    std::sort(frontier.begin(), frontier.end(),
              [](const CostRow* a, const CostRow* b) { return a->msMedian < b->msMedian; });
    for (const CostRow* r : frontier)
        out += fmt::format("<h3>{} {}: {:.1f} ms, appearance {:.5f}</h3>\n", escaped(r->technique),
                           escaped(r->settings), r->msMedian, r->metrics.appearance.distance) +
               strip(*r, f, work);
    return out;
}
std::string page(const CostRun& run, const fs::path& work, std::span<const TechniqueRow> techniques) {
    std::string out = kHead;
    out +=
        fmt::format("<title>{0}: what accuracy costs</title></head><body>\n<h1>{0}: what accuracy costs in time</h1>\n",
                    escaped(run.project));
    out += fmt::format(
        "<p>{}x{} pixels against a ray-traced truth of {} samples a pixel, {} lighting. Appearance is the distance of "
        "blocks' means and contrasts from the truth's: 0 is equal, whichever "
        "blade stands where. Times are wall clock with one finish a frame; a row is off the "
        "frontier if another is better in one of both by more than their standard errors and in the other not worse. "
        "The row <em>as it is</em> has the settings that the project ships with; rows that would draw the same picture "
        "are one.</p>\n<ul>\n",
        run.width, run.height, run.samples, run.lighting);
    for (const CostMachine& m : run.machines)
        out += fmt::format(
            "<li>{}, {} cores ({})\n",
            escaped(m.host + (m.host.empty() ? "" : ": ") + m.cpu + (m.cpu.empty() ? "" : ", ") + m.renderer), m.cores,
            m.timing);
    out += "</ul>\n";
    for (const CostFloors& f : run.floors) out += cameraPart(run, f, work, techniques);
    return out + kSort + "</body></html>\n";
}

}  // namespace

std::string base64(std::string_view bytes) {
    constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t v = 0;
        for (size_t k = 0; k < 3; ++k)
            v = v << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? kDigits[v >> (18 - 6 * k) & 63] : '=';
    }
    return out;
}

// --- files -------------------------------------------------------------------------------------------------------
Status writeCostFiles(const CostRun& run, const fs::path& folder, const fs::path& work,
                      std::span<const TechniqueRow> techniques) {
    if (Status s = makeFolderOf(folder / "cost.csv"); !s) return s;
    if (Status s = writeFileAtomic(folder / "cost.csv", costCsv(run)); !s) return s;
    if (Status s = writeFileAtomic(folder / "cost.json", writeJson(costJson(run))); !s) return s;
    if (Status s = writeFileAtomic(folder / "shipped.md", shippedHeader() + shippedRows(run)); !s) return s;
    for (const CostFloors& f : run.floors) {
        const Plot plot = costPlot(run, f.camera, techniques);
        if (plot.width == 0) continue;
        if (Status s = writeFileAtomic(folder / ("plot-" + f.camera + ".svg"), plotSvg(plot)); !s) return s;
        if (Status s =
                writeImagePng(folder / ("plot-" + f.camera + ".png"), plot.width, plot.height, 3, plotPixels(plot));
            !s)
            return s;
    }
    return writeFileAtomic(folder / "report.html", page(run, work, techniques));
}

}  // namespace sward
