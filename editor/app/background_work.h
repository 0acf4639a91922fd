// What is made beside the editor's frames, as the status bar tells it.
// Does not: start or end it (model/bakes.h, frame/renderer.h).
#pragma once
#include <optional>
#include <vector>

#include "core/jobs.h"
#include "model/bakes.h"
#include "model/scene_export.h"

namespace sward {

struct BackgroundWork {
    std::optional<OcclusionBake> occlusion;  // being baked
    std::optional<SceneExport> exporting;    // being written
    std::vector<JobNews> making;             // what the renderer makes beside, as of the last frame
};

}  // namespace sward
