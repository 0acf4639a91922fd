// The open project's scene into a .glb, on a snapshot in the background: editing goes on meanwhile.
// Does not: ask for the file, nor draw progress.
#pragma once
#include <filesystem>
#include <optional>

#include "core/jobs.h"
#include "exchange/glb_export.h"
#include "model/document.h"

namespace sward {

struct SceneExport {
    std::filesystem::path file;
    Job<GlbCounts> job;
    bool cancelled = false;  // the person did it
};
// Starts it. Failed error without an open project; Usage error if `file` does not end in .glb; what checkExport
// refuses.
Result<SceneExport> startExport(const Document& document, const GlbOptions& options, const std::filesystem::path& file);
// Nothing while it runs. Then what was written, or why not (cancelled: no file was touched).
std::optional<Result<GlbCounts>> finishExport(SceneExport& exporting);

struct ScriptHost;
// Scripts of the host may export (project.export).
void offerExport(ScriptHost& host);

}  // namespace sward
