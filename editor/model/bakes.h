// What can be baked: one row a bake, for `sward bake`, scripts and the editor's menu. Bakes that take seconds run on a
// snapshot in the background; what they give is one undo step, or lies in the cache where the renderer finds it. Does
// not: draw progress; who asks for a bake does.
#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "core/jobs.h"
#include "model/document.h"

namespace sward {

struct BakeSettings {
    int samples = 64;  // rays a texel; 1 to 65536
    int size = 0;      // texels along the longer side; 0: as it is, else the bake's own choice
};
// Told the share done now and then; false cancels.
using BakeProgress = std::function<bool(double)>;

struct BakeRow {
    const char* name;  // "ambientOcclusion": scripts' bake.NAME
    const char* flag;  // "ao": sward bake --FLAG
    const char* help;
    // Runs to the end, with the result in the document or the cache; says in a line what was made. Failed when
    // cancelled: nothing has changed then.
    Result<std::string> (*run)(Document&, const BakeSettings&, const BakeProgress&);
};
// All bakes, in the order in which `sward bake` runs them.
std::span<const BakeRow> bakeRows();
struct ScriptHost;
// Scripts of the host may bake (bake.NAME).
void offerBakes(ScriptHost& host);
// Usage error naming the range.
Status checkBakeSettings(const BakeSettings& settings);

// --- ambient occlusion of the ground (reference/occlusion.h), into the first GrassField's map
struct OcclusionBake {
    BakeSettings settings;
    Job<Map> job;
};
// Starts on a snapshot. A scene baked before comes from the cache. Fails without a Terrain or a GrassField.
Result<OcclusionBake> startOcclusion(Document& document, const BakeSettings& settings);
// Nothing while it runs. Then its end: the map is in the document as one undo step, or why not (cancelled; the scene is
// another by now).
std::optional<Status> finishOcclusion(Document& document, OcclusionBake& bake);

}  // namespace sward
