#include "cli/cli.h"
#include "cli/interrupt.h"
#include "core/file.h"
#include "core/json.h"
#include "exchange/glb_export.h"
#include "project/project_files.h"
#include "techniques.h"
#include "world/drawn_project.h"

namespace sward {
namespace {

std::string statsOf(const Project& p, const std::string& file, const GlbCounts& c) {
    Json j = Json::makeObject();
    j["sward"] = SWARD_VERSION;
    j["project"] = p.name;
    j["file"] = file;
    for (const auto& [name, count] : namedCounts(c)) j[name] = count;
    return writeJson(j);
}

}  // namespace

int exportSceneVerb(const ExportCommand& o) {
    if (std::filesystem::path(o.out).extension() != ".glb")
        return report(usage("a scene is written to a .glb, not to " + o.out, "name it so, or choose a --map"));
    const auto project = loadProject(o.project, tables().components);
    if (!project) return report(project.error());
    const Interruptible here;
    const GlbOptions options{o.bladesWithin, o.camera};
    Job<GlbCounts> job("export", 0, [&](JobControl& control) {
        return exportScene(DrawnProject().of(*project, tables().components), options, o.out, control);
    });
    const Result<GlbCounts> made = waitFor(job, 0);
    if (!made) return report(made.error());
    if (!o.stats.empty())
        if (Status s = writeFileAtomic(o.stats, statsOf(*project, o.out, *made)); !s) return report(s.error());
    std::printf("%s: %s\n", o.out.c_str(), countsText(*made).c_str());
    return 0;
}

}  // namespace sward
