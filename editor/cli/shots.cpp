// Of what pictures are taken: cameras, or a way of one.
#include "cli/cli.h"
#include "model/film_plan.h"
#include "world/camera_path.h"
#include "world/view_camera.h"

namespace sward {
namespace {

constexpr double kLongestFilm = 1e6;

template <class C>
std::vector<std::string> namesWith(const Project& p) {
    std::vector<std::string> names;
    for (const auto& [name, e] : p.entities)
        if (p.registry.get<C>(e)) names.push_back(name);
    return names;
}

std::string joined(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& n : names) list += (list.empty() ? "" : ", ") + n;
    return list;
}

const CameraPath* pathNamed(const Project& p, const std::string& name) {
    const Entity e = findEntity(p, name);
    return e == kNoEntity ? nullptr : p.registry.get<CameraPath>(e);
}

}  // namespace

Result<std::vector<std::string>> cameraNames(const Project& p, const std::string& wanted) {
    const std::vector<std::string> all = namesWith<Camera>(p);
    if (wanted.empty() && !all.empty()) return all;
    if (std::find(all.begin(), all.end(), wanted) != all.end()) return std::vector<std::string>{wanted};
    const std::string remedy = all.empty() ? "add an entity with a Camera" : "its cameras: " + joined(all);
    if (wanted.empty()) return unsound("the project has no camera", remedy).at(p.dir);
    return usage("there is no camera \"" + wanted + "\"", remedy).at(p.dir);
}

Result<std::vector<std::string>> shotNames(RenderOptions& o, const Project& p) {
    if (o.path.empty()) return cameraNames(p, o.camera);
    if (!o.camera.empty()) return usage("--camera stands still, --path moves", "leave one of them out");
    const CameraPath* path = pathNamed(p, o.path);
    const std::vector<std::string> all = namesWith<CameraPath>(p);
    if (!path)
        return usage("there is no path \"" + o.path + "\"",
                     all.empty() ? "add an entity with a CameraPath" : "its paths: " + joined(all))
            .at(p.dir);
    if (path->keys.empty())
        return unsound(o.path + ".CameraPath has no keys", "add some: its inspector takes them from the view")
            .at(p.dir);
    if (o.fps <= 0) o.fps = kFilmRate;
    if (o.frames <= 0)
        o.frames = static_cast<int>(std::min(kLongestFilm, std::floor(secondsOf(*path) * o.fps + 1e-6) + 1)) - o.first;
    if (o.frames < 1) return usage(fmt::format("the path has no frame {}", o.first), "a lower --first");
    return std::vector<std::string>{o.path};
}

ViewCamera shotAt(const RenderOptions& o, const Project& p, const std::string& name, double seconds) {
    return viewOf(o.path.empty() ? *findCamera(p, name) : cameraOn(*pathNamed(p, o.path), seconds));
}

}  // namespace sward
