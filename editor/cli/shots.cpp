// Of what pictures are taken: cameras, or a way of one.
#include "cli/cli.h"
#include "world/camera_path.h"
#include "world/view_camera.h"

namespace sward {
namespace {

constexpr double kFilmRate = 25;  // pictures a second of a path, where none is given
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
    return Error{wanted.empty() ? ExitCode::Unsound : ExitCode::Usage,
                 wanted.empty() ? "the project has no camera" : "there is no camera \"" + wanted + "\"",
                 p.dir.string(),
                 0,
                 0,
                 all.empty() ? "add an entity with a Camera" : "its cameras: " + joined(all)};
}

Result<std::vector<std::string>> shotNames(RenderOptions& o, const Project& p) {
    if (o.path.empty()) return cameraNames(p, o.camera);
    if (!o.camera.empty())
        return Error{ExitCode::Usage, "--camera stands still, --path moves", "", 0, 0, "leave one of them out"};
    const CameraPath* path = pathNamed(p, o.path);
    const std::vector<std::string> all = namesWith<CameraPath>(p);
    if (!path)
        return Error{ExitCode::Usage,
                     "there is no path \"" + o.path + "\"",
                     p.dir.string(),
                     0,
                     0,
                     all.empty() ? "add an entity with a CameraPath" : "its paths: " + joined(all)};
    if (path->keys.empty())
        return Error{ExitCode::Unsound,
                     o.path + ".CameraPath has no keys",
                     p.dir.string(),
                     0,
                     0,
                     "add some: its inspector takes them from the view"};
    if (o.fps <= 0) o.fps = kFilmRate;
    if (o.frames <= 0)
        o.frames = static_cast<int>(std::min(kLongestFilm, std::floor(secondsOf(*path) * o.fps + 1e-6) + 1));
    return std::vector<std::string>{o.path};
}

ViewCamera shotAt(const RenderOptions& o, const Project& p, const std::string& name, double seconds) {
    return viewOf(o.path.empty() ? *findCamera(p, name) : cameraOn(*pathNamed(p, o.path), seconds));
}

}  // namespace sward
