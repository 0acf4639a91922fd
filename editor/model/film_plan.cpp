#include "model/film_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "world/camera_path.h"

namespace sward {
namespace {

namespace fs = std::filesystem;

const CameraPath* pathOf(const FilmPlan& plan, const Project& p) {
    const Entity e = plan.path.empty() ? kNoEntity : findEntity(p, plan.path);
    return e == kNoEntity ? nullptr : p.registry.get<CameraPath>(e);
}

double lengthOf(const FilmPlan& plan, const Project& p) {
    const CameraPath* path = pathOf(plan, p);
    return plan.seconds > 0 ? plan.seconds : path ? std::max(secondsOf(*path) - plan.from, 0.0) : 0;
}

bool isPicture(const fs::path& file) { return file.extension() == ".png" || file.extension() == ".exr"; }

// What a film alone needs.
Status checkWay(const FilmPlan& plan, const Project& p) {
    if (plan.format != "png" && plan.format != "exr")
        return usage("\"" + plan.format + "\" is no format of pictures", "png or exr");
    if (!(plan.fps > 0) || plan.fps > 1000)
        return usage(fmt::format("{:g} pictures a second cannot be", plan.fps), "above 0, up to 1000");
    if (!std::isfinite(plan.from) || !(plan.seconds >= 0))
        return usage("that time cannot be", "a beginning and a length in seconds, not below 0");
    const CameraPath* path = pathOf(plan, p);
    if (!plan.path.empty() && (!path || path->keys.empty()))
        return usage("\"" + plan.path + "\" has no CameraPath with keys", "choose another, or the view");
    if (!(lengthOf(plan, p) > 0))
        return usage("the film has no length", path ? "begin before the path's end" : "say how many seconds");
    if (lengthOf(plan, p) * plan.fps > kMostFilmFrames)
        return usage(fmt::format("{:.0f} pictures are too many", lengthOf(plan, p) * plan.fps),
                     fmt::format("at most {:.0f}: make it shorter or slower", kMostFilmFrames));
    return {};
}

}  // namespace

int framesOf(const FilmPlan& plan, const Project& p) {
    if (!plan.film) return 1;
    return static_cast<int>(std::floor(std::min(lengthOf(plan, p) * plan.fps, kMostFilmFrames) + 1e-6)) + 1;
}

fs::path fileOf(const FilmPlan& plan, int i) {
    return plan.film ? plan.out / fmt::format("frame_{:04d}.{}", i, plan.format) : plan.out;
}

double secondOf(const FilmPlan& plan, int i) { return plan.from + (plan.film ? i / plan.fps : 0); }

ViewCamera viewIn(const FilmPlan& plan, const Project& p, const ViewCamera& view, int i) {
    const CameraPath* path = plan.film ? pathOf(plan, p) : nullptr;
    return path ? viewOf(cameraOn(*path, secondOf(plan, i))) : view;
}

Status checkFilm(const FilmPlan& plan, const Project& p) {
    if (plan.width < 1 || plan.height < 1 || plan.width > kLargestPicture || plan.height > kLargestPicture)
        return usage(fmt::format("{} x {} is no size", plan.width, plan.height),
                     fmt::format("1 to {} pixels a side", kLargestPicture));
    if (plan.out.empty()) return usage("no place is named", plan.film ? "type a folder" : "type a file");
    std::error_code fault;
    const fs::path in = plan.out.parent_path();
    if (!in.empty() && !fs::is_directory(in, fault)) return usage("there is no such folder").at(in.string());
    if (plan.film) {
        if (Status way = checkWay(plan, p); !way) return way;
        if (fs::exists(plan.out, fault) && !fs::is_directory(plan.out, fault))
            return usage("this is a file", "name a folder for the film").at(plan.out.string());
        if (fs::exists(fileOf(plan, 0), fault))
            return usage("there is a film here already", "name another folder").at(plan.out.string());
        return {};
    }
    if (!isPicture(plan.out)) return usage("pictures are .png or .exr", "end the name so").at(plan.out.string());
    if (fs::exists(plan.out, fault)) return usage("it is there already", "name another file").at(plan.out.string());
    return {};
}

std::vector<std::string> filmPaths(const Project& p) {
    std::vector<std::string> names;
    for (const auto& [name, e] : p.entities)
        if (const CameraPath* path = p.registry.get<CameraPath>(e); path && !path->keys.empty()) names.push_back(name);
    return names;
}

fs::path freePictureName(const FilmPlan& plan, const Project& p) {
    const fs::path in = p.dir.empty() ? fs::current_path() : p.dir.parent_path();
    std::error_code fault;
    for (int i = 1;; ++i) {
        const std::string number = i > 1 ? fmt::format("-{}", i) : "";
        const fs::path name = in / (p.name + (plan.film ? "-film" + number : number + ".png"));
        if (!fs::exists(name, fault)) return name;
    }
}

}  // namespace sward
