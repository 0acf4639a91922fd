#include "model/scene_export.h"

#include "scene/ground_path.h"
#include "scene/map_layers.h"
#include "script/script.h"
#include "world/drawn_project.h"

namespace sward {

Result<SceneExport> startExport(const Document& document, const GlbOptions& options,
                                const std::filesystem::path& file) {
    if (!document.isOpen()) return failed("no project is open", "open or create one first");
    if (file.extension() != ".glb")
        return usage("a scene is written to a .glb", "end the name in .glb").at(file.string());
    const std::span<const ComponentRow> rows = document.tables().components;
    const Project& p = document.project();
    if (!hasLayers(p) && !firstOf<GroundPath>(p))  // else what is drawn takes its time, and is asked beside
        if (Status s = checkExport(p, options); !s) return s.error();
    const auto copy = std::make_shared<Project>(snapshot(p, rows));
    return SceneExport{file, Job<GlbCounts>("export", 0, [copy, rows, options, file](JobControl& control) {
                           return exportScene(DrawnProject().of(*copy, rows), options, file, control);
                       })};
}

std::optional<Result<GlbCounts>> finishExport(SceneExport& exporting) {
    if (!exporting.job.finished()) return {};
    std::optional<Result<GlbCounts>> made = exporting.job.take(0);
    if (!made) return interruption("the scene was not exported: it was cancelled").at(exporting.file.string());
    return made;
}

void offerExport(ScriptHost& host) {
    host.exportScene = [&host](const std::filesystem::path& file, double within,
                               const std::string& camera) -> Result<std::vector<std::pair<const char*, size_t>>> {
        GlbOptions options;
        if (within >= 0) options.bladesWithin = within;
        options.camera = camera;
        JobControl control;
        DrawnProject drawn;
        const Project& project = drawn.of(host.document.project(), host.document.tables().components);
        const Result<GlbCounts> made = exportScene(project, options, file, control);
        if (!made) return made.error();
        return namedCounts(*made);
    };
}

}  // namespace sward
