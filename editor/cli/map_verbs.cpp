#include "cli/cli.h"
#include "core/log.h"
#include "project/packed_map.h"
#include "project/project_files.h"
#include "techniques.h"

namespace sward {
namespace {

// "LOW,HIGH", finite and rising.
Result<std::pair<double, double>> parseRange(const std::string& text) {
    double low = 0, high = 0;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%lf,%lf%c", &low, &high, &rest) != 2 || !std::isfinite(low) ||
        !std::isfinite(high) || !(low < high))
        return usage("\"" + text + "\" is no range", "write LOW,HIGH with LOW below HIGH, such as 0,250");
    return std::pair{low, high};
}

}  // namespace

int importVerb(const ImportCommand& o) {
    ImportOptions options;
    if (o.flip) options.flip = true;
    if (!o.range.empty()) {
        auto range = parseRange(o.range);
        if (!range) return report(range.error());
        options.range = *range;
    }
    auto project = loadProject(o.project, tables().components);
    if (!project) return report(project.error());
    std::vector<std::string> repaired;
    if (o.packed && options.range) return report(usage("a packed map has no range", "leave out --range"));
    const auto read = o.packed ? importPacked : importMap;
    if (Status s = read(*project, tables().components, o.map, o.file, options, &repaired); !s) return report(s.error());
    for (const std::string& r : repaired) logWarning(o.file + ": " + r);
    auto written = saveProject(*project, tables().components);
    if (!written) return report(written.error());
    for (const std::string& f : *written) std::printf("%s\n", (std::filesystem::path(o.project) / f).string().c_str());
    return 0;
}

int exportVerb(const ExportCommand& o) {
    if (o.map.empty()) return exportSceneVerb(o);
    auto project = loadProject(o.project, tables().components);
    if (!project) return report(project.error());
    ImportOptions options;
    if (o.flip) options.flip = true;
    if (Status s = (o.packed ? exportPacked : exportMap)(*project, tables().components, o.map, o.out, options); !s)
        return report(s.error());
    std::printf("%s\n", o.out.c_str());
    return 0;
}

}  // namespace sward
