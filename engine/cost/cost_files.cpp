#include "cost/cost_files.h"

#include "core/hash.h"
#include "cost/cost_machine.h"

namespace sward {
namespace {

Json number(double v) { return std::isnan(v) ? Json() : Json(v); }
std::string cell(double v) { return std::isnan(v) ? "" : shortestText(v); }
std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
    return out + "\"";
}

Json appearanceJson(const Appearance& a) {
    Json j;
    j["appearance"] = number(a.distance), j["bias"] = number(a.bias), j["contrast"] = number(a.contrast),
    j["sigma"] = number(a.sigma);
    return j;
}

// 0 of what no int holds.
int whole(double v) { return v >= -2e9 && v <= 2e9 ? static_cast<int>(v) : 0; }

// Reads members, noting the first that is missing or of another kind.
struct Reader {
    const Json& json;
    std::string missing;

    const Json* member(const char* name) {
        const Json* j = json.find(name);
        if (!j && missing.empty()) missing = name;
        return j;
    }
    double number(const char* name) {
        const Json* j = member(name);
        if (j && j->isString() && j->text == "inf") return std::numeric_limits<double>::infinity();
        if (j && !j->isNumber() && !j->isNull() && missing.empty()) missing = name;
        return j && j->isNumber() ? j->number : std::numeric_limits<double>::quiet_NaN();
    }
    int integer(const char* name) { return whole(number(name)); }
    std::string text(const char* name) {
        const Json* j = member(name);
        return j && j->isString() ? j->text : "";
    }
    Appearance appearance(const char* name) {
        const Json* j = member(name);
        if (!j) return {};
        Reader r{*j, {}};
        const Appearance a{r.number("appearance"), r.number("bias"), r.number("contrast"), r.number("sigma")};
        if (missing.empty() && !r.missing.empty()) missing = std::string(name) + "." + r.missing;
        return a;
    }
    template <class F>
    void each(const char* name, F&& body) {
        const Json* j = member(name);
        if (j && !j->isArray() && missing.empty()) missing = name;
        if (j && j->isArray())
            for (const Json& one : j->array) body(one);
    }
};

CostFloors floorsFrom(Reader r, std::string& missing) {
    const CostFloors f{r.text("camera"),     r.appearance("seed"),    r.appearance("sampling"),
                       r.appearance("flat"), r.number("truth_error"), r.text("image")};
    if (missing.empty()) missing = r.missing;
    return f;
}

std::string nameOf(const CostRow& r) { return r.camera + " " + r.technique + " " + r.settings; }

constexpr const char* kDigest = "digest";

// Hash of all values but the digest itself.
std::string digestOf(Json j) {
    j.object.erase(kDigest);
    return hashHex(hashText(writeJson(j)));
}

}  // namespace

std::string costCsv(const CostRun& run) {
    std::string out = std::string(kCostColumns) + "\n";
    for (const CostRow& r : run.rows) {
        const bool drawn = r.skipped.empty();
        const auto value = [&](double v) { return drawn ? cell(v) : ""; };
        const Appearance& a = r.metrics.appearance;
        out += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", quoted(r.camera), r.technique,
                           quoted(r.settings), value(r.msMedian), value(r.msP95), value(a.distance), value(a.sigma),
                           value(a.bias), value(a.contrast), value(r.metrics.flip), value(r.metrics.rmse),
                           drawn ? std::to_string(r.gpuBytes) : "", r.onFrontier ? 1 : 0, quoted(r.skipped));
    }
    return out;
}

Json costRowJson(const CostRow& r) {
    Json j;
    j["index"] = r.index, j["camera"] = r.camera, j["technique"] = r.technique, j["settings"] = r.settings,
    j["machine"] = r.machine;
    j["skipped"] = r.skipped, j["on_frontier"] = r.onFrontier, j["image"] = r.image, j["pixels"] = r.pixels;
    j["ms_median"] = number(r.msMedian), j["ms_p95"] = number(r.msP95), j["ms_sigma"] = number(r.msSigma),
    j["gpu_bytes"] = r.gpuBytes;
    j["drawn"] = appearanceJson(r.metrics.appearance), j["converged"] = appearanceJson(r.converged);
    j["ms"] = Json::makeArray();
    for (const double ms : r.ms) j["ms"].push(ms);
    j["flip"] = number(r.metrics.flip), j["ssim"] = number(r.metrics.ssim), j["rmse"] = number(r.metrics.rmse),
    j["psnr"] = number(r.metrics.psnr);
    return j;
}

Result<CostRow> costRowFrom(const Json& json) {
    Reader r{json, {}};
    CostRow row;
    row.index = r.integer("index"), row.camera = r.text("camera"), row.technique = r.text("technique"),
    row.settings = r.text("settings"), row.machine = r.integer("machine");
    row.skipped = r.text("skipped"), row.image = r.text("image");
    if (const Json* pixels = json.find("pixels"); pixels && pixels->isString()) row.pixels = pixels->text;
    const Json* frontier = r.member("on_frontier");
    row.onFrontier = frontier && frontier->boolean;
    row.msMedian = r.number("ms_median"), row.msP95 = r.number("ms_p95"), row.msSigma = r.number("ms_sigma");
    r.each("ms", [&](const Json& v) {
        row.ms.push_back(v.isNumber() ? v.number : std::numeric_limits<double>::quiet_NaN());
    });
    const double bytes = r.number("gpu_bytes");
    row.gpuBytes = bytes > 0 && bytes < 1e18 ? static_cast<uint64_t>(bytes) : 0;
    row.metrics.appearance = r.appearance("drawn"), row.converged = r.appearance("converged");
    row.metrics.flip = r.number("flip"), row.metrics.ssim = r.number("ssim"), row.metrics.rmse = r.number("rmse"),
    row.metrics.psnr = r.number("psnr");
    if (!r.missing.empty()) return unsound("is no row of a sweep: \"" + r.missing + "\" is missing").at("", json.line);
    return row;
}

Json costJson(const CostRun& run) {
    Json j;
    j["sward"] = SWARD_VERSION, j["project"] = run.project, j["hash"] = run.hash, j["samples"] = run.samples,
    j["lighting"] = run.lighting, j["total"] = run.total;
    j["size"].push(run.width), j["size"].push(run.height);
    j["machines"] = j["floors"] = j["rows"] = Json::makeArray();
    for (const CostMachine& m : run.machines) {
        Json one;
        one["renderer"] = m.renderer, one["timing"] = m.timing, one["cores"] = m.cores;
        one["host"] = m.host, one["cpu"] = m.cpu;
        j["machines"].push(std::move(one));
    }
    for (const CostFloors& f : run.floors) {
        Json one;
        one["camera"] = f.camera, one["seed"] = appearanceJson(f.seed), one["sampling"] = appearanceJson(f.sampling),
        one["flat"] = appearanceJson(f.flat);
        one["truth_error"] = number(f.truthError), one["image"] = f.image;
        j["floors"].push(std::move(one));
    }
    for (const CostRow& row : run.rows) j["rows"].push(costRowJson(row));
    j[kDigest] = digestOf(j);
    return j;
}

Result<CostRun> costFrom(const Json& json, const std::string& file) {
    Reader r{json, {}};
    CostRun run;
    run.project = r.text("project"), run.hash = r.text("hash"), run.samples = r.integer("samples"),
    run.lighting = r.text("lighting"), run.total = r.integer("total");
    std::vector<double> size;
    r.each("size", [&](const Json& v) { size.push_back(v.number); });
    if (size.size() == 2) run.width = whole(size[0]), run.height = whole(size[1]);
    r.each("machines", [&](const Json& v) {
        Reader m{v, {}};
        run.machines.push_back(
            {m.text("renderer"), m.text("timing"), m.integer("cores"), m.text("host"), m.text("cpu")});
    });
    r.each("floors", [&](const Json& v) { run.floors.push_back(floorsFrom({v, {}}, r.missing)); });
    std::string bad;
    r.each("rows", [&](const Json& v) {
        auto row = costRowFrom(v);
        if (row)
            run.rows.push_back(std::move(*row));
        else if (bad.empty())
            bad = row.error().message;
    });
    for (const CostRow& row : run.rows)
        if (row.machine < 0 || static_cast<size_t>(row.machine) >= run.machines.size())
            bad = "a row names a machine that is not listed";
    if (run.total < static_cast<int>(run.rows.size())) bad = "it holds more rows than its sweep has";
    if (r.missing.empty() && bad.empty()) return run;
    return unsound(bad.empty() ? "is no result of a sweep: \"" + r.missing + "\" is missing" : bad,
                   "name a cost.json, or its folder")
        .at(file);
}

Result<CostRun> readCost(const std::filesystem::path& file) {
    const std::filesystem::path at = std::filesystem::is_directory(file) ? file / "cost.json" : file;
    auto json = readJson(at);
    if (!json) return json.error();
    const Json* digest = json->find(kDigest);
    if (!digest || !digest->isString() || digest->text != digestOf(*json))
        return unsound(digest ? "is damaged: its values do not have the hash that it names"
                              : "is no result of a sweep, or of an older version: it names no hash of its values",
                       "make it again with sward cost")
            .at(at.string());
    return costFrom(*json, at.string());
}

Result<CostRun> mergeCosts(const std::vector<CostRun>& parts) {
    if (parts.empty()) return failed("there are no parts to join", "name the cost.json of each");
    CostRun whole = parts[0];
    whole.rows.clear(), whole.machines.clear();
    for (const CostRun& part : parts) {
        if (part.hash != whole.hash)
            return failed("the parts are of different sweeps", "run them on the same project with the same options");
        const int first = static_cast<int>(whole.machines.size());
        whole.machines.insert(whole.machines.end(), part.machines.begin(), part.machines.end());
        for (CostRow row : part.rows) row.machine += first, whole.rows.push_back(std::move(row));
    }
    std::stable_sort(whole.rows.begin(), whole.rows.end(),
                     [](const CostRow& a, const CostRow& b) { return a.index < b.index; });
    for (size_t i = 0; i < static_cast<size_t>(whole.total); ++i) {
        if (i >= whole.rows.size())
            return failed(fmt::format("row {} is in none of the parts", i), "name every part of 0/N to N-1/N");
        if (whole.rows[i].index < static_cast<int>(i))
            return failed("a row is in two parts: " + nameOf(whole.rows[i]), "name each part once");
        if (whole.rows[i].index > static_cast<int>(i))
            return failed(fmt::format("row {} is in none of the parts", i), "name every part of 0/N to N-1/N");
    }
    keepDistinct(whole);
    joinMachines(whole);
    return whole;
}

}  // namespace sward
