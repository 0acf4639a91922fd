// sward effects: where each effect of a scene changes the picture, and what it costs.
#include <unistd.h>

#include "cli/cli.h"
#include "cli/cost_request.h"
#include "cli/interrupt.h"
#include "core/file.h"
#include "cost/effect_files.h"
#include "techniques.h"

namespace sward {
namespace {

namespace fs = std::filesystem;

struct CameraMap {
    std::string camera;
    EffectMap map;
};

// The share done of one camera's map as one of all.
EffectProgress partOf(const CostProgress& whole, const std::string& camera, size_t done, size_t all) {
    return [=](const std::string& what, double share) {
        return whole(camera + ": " + what, (static_cast<double>(done) + share) / static_cast<double>(all));
    };
}

Result<std::vector<CameraMap>> probeAll(const EffectOptions& o, const EffectRequest& asked, const Project& project,
                                        Gpu& gpu) {
    const auto cameras = cameraNames(project, o.camera);
    if (!cameras) return cameras.error();
    const Interruptible here;
    const CostProgress progress = costProgress();
    std::vector<CameraMap> maps;
    for (const std::string& camera : *cameras) {
        EffectRequest request = asked;
        request.camera = viewOf(*findCamera(project, camera));
        auto map =
            probeEffects(request, project, tables(), gpu, partOf(progress, camera, maps.size(), cameras->size()));
        if (!map) return map.error();
        maps.push_back({camera, std::move(*map)});
    }
    if (isatty(STDERR_FILENO)) std::fprintf(stderr, "\r\033[K");
    return maps;
}

Json toldOf(const std::vector<CameraMap>& maps, const EffectOptions& o, const Project& project, const Gpu& gpu) {
    Json j;
    j["sward"] = SWARD_VERSION, j["renderer"] = gpu.renderer, j["project"] = project.name;
    j["timing"] = "wall-finish", j["msaa"] = gpu.samplesFor(o.msaa), j["time_s"] = o.time;
    j["seen_change_255"] = kSeenChange;
    j["cameras"] = Json::makeArray();
    for (const CameraMap& m : maps) j["cameras"].push(effectMapJson(m.map, m.camera, o.out.empty() ? "" : m.camera));
    return j;
}

Status write(const std::vector<CameraMap>& maps, const Json& told, const fs::path& folder) {
    for (const CameraMap& m : maps)
        if (Status s = writeEffectPictures(m.map, folder / m.camera); !s) return s;
    return writeFileAtomic(folder / "effects.json", writeJson(told));
}

}  // namespace

int effectsVerb(const EffectOptions& o) {
    const auto size = parseSize(o.size);
    if (!size) return report(size.error());
    const auto project = openForRendering(o);
    if (!project) return report(project.error());
    auto gpu = makeHeadlessGpu();
    if (!gpu) return report(gpu.error());
    EffectRequest request;
    std::tie(request.width, request.height) = *size;
    request.msaa = o.msaa, request.time = o.time, request.pairs = o.pairs;
    const auto maps = probeAll(o, request, *project, **gpu);
    if (!maps) return report(maps.error());
    const Json told = toldOf(*maps, o, *project, **gpu);
    if (!o.out.empty())
        if (Status s = write(*maps, told, o.out); !s) return report(s.error());
    if (o.json) std::printf("%s", writeJson(told).c_str());
    for (const CameraMap& m : *maps)
        if (!o.json) std::printf("%s", effectMapText(m.map, m.camera).c_str());
    return 0;
}

}  // namespace sward
