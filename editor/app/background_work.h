// What is made beside the editor's frames, as the status bar tells it, and what the person waits for.
// Does not: start or end it (model/bakes.h, frame/renderer.h).
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "app/film.h"
#include "app/time_left.h"
#include "app/waiting.h"
#include "core/jobs.h"
#include "model/bakes.h"
#include "model/scene_export.h"

namespace sward {

struct BackgroundWork {
    Waiting waiting;                         // what nothing else is edited during
    std::optional<OcclusionBake> occlusion;  // being baked
    std::optional<SceneExport> exporting;    // being written
    std::unique_ptr<Film> film;              // being drawn, or the screenshot
    std::vector<JobNews> making;             // what the renderer makes beside, as of the last frame
    Stopwatch baking, writing, preparing;    // of occlusion, exporting and making
};

}  // namespace sward
