#include "cost/transitions.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/json.h"
#include "reference/reference.h"
#include "scene/components.h"
#include "scene/forest.h"
#include "world/camera_path.h"

namespace sward {

struct WalkTruth {
    std::optional<ReferenceScene> scene;  // the one that is being traced
    // Of the project, and of other blades.
    std::vector<Picture> pictures, others;
    std::vector<std::vector<float>> grass;  // of the project's
};

namespace {

constexpr int kLargestSide = 2048;

std::string pathsOf(const Project& p) {
    std::string list;
    for (const auto& [name, e] : p.entities)
        if (p.registry.get<CameraPath>(e)) list += (list.empty() ? "" : ", ") + name;
    return list.empty() ? "add an entity with a CameraPath" : "its paths: " + list;
}

double endOf(const TransitionPlan& plan, const CameraPath& path) { return plan.to > 0 ? plan.to : secondsOf(path); }

Status checkPlan(const TransitionPlan& plan, const Project& p) {
    const Entity e = findEntity(p, plan.path);
    const CameraPath* path = e == kNoEntity ? nullptr : p.registry.get<CameraPath>(e);
    if (!path) return usage("there is no path \"" + plan.path + "\"", pathsOf(p)).at(p.dir);
    if (!(secondsOf(*path) > 0))
        return usage(plan.path + ".CameraPath has no length", "give it keys at several seconds").at(p.dir);
    if (!(plan.from >= 0 && plan.from < endOf(plan, *path) && plan.to <= secondsOf(*path)))
        return usage(fmt::format("{} has no way from second {:g} to {:g}", plan.path, plan.from, endOf(plan, *path)),
                     fmt::format("it goes from 0 to {:g}", secondsOf(*path)))
            .at(p.dir);
    if (plan.pictures < 2 || plan.pictures > kMostTransitionPictures)
        return usage(fmt::format("{} pictures make no walk", plan.pictures),
                     fmt::format("2 to {}", kMostTransitionPictures));
    if (plan.width < 16 || plan.height < 16 || plan.width > kLargestSide || plan.height > kLargestSide)
        return usage(fmt::format("{} x {} is no size for it", plan.width, plan.height),
                     fmt::format("16 to {} pixels a side", kLargestSide));
    if (plan.samples < 1 || plan.samples > 1024)
        return usage(fmt::format("{} samples make no picture", plan.samples), "1 to 1024");
    return {};
}

// Other blades of the same fields, other trees of the same forests.
Project reseeded(const Project& project, const Tables& tables) {
    Project other = snapshot(project, tables.components);
    for (const auto& [name, e] : other.entities) {
        if (GrassField* f = other.registry.get<GrassField>(e)) f->seed += f->seed < 1000000 ? 1 : -1;
        if (Forest* f = other.registry.get<Forest>(e)) f->seed += f->seed < 1000000 ? 1 : -1;
    }
    return other;
}

// A picture that is held against another by the grass of the truth. Without grass no pixel counts.
Result<PicturePair> pairBy(const Picture& image, const Picture& truth, const std::vector<float>& grass) {
    if (std::any_of(grass.begin(), grass.end(), [](float g) { return g > 0; }))
        return pairPictures(image, truth, grass);
    auto pair = pairPictures(image, truth);
    if (!pair) return pair;
    std::fill(pair->weight.begin(), pair->weight.end(), 0.0f);
    pair->weightSum = 0;
    return pair;
}

// Each view's rays are its own, since metrics take the scatter of one picture for independent of the next one's; a view
// like the one before sees the same again.
uint32_t seedOf(const std::vector<ViewCamera>& views, size_t view) {
    uint32_t seed = 1;
    for (size_t i = 1; i <= view; ++i)
        seed += views[i].eye != views[i - 1].eye || views[i].target != views[i - 1].target ||
                views[i].fovDeg != views[i - 1].fovDeg;
    return seed;
}

// The next view of one of both scenes, which is made first.
Status traceInto(std::vector<Picture>& pictures, TransitionWalk& w, const Tables& tables, JobControl& control) {
    WalkTruth& t = *w.truth;
    const bool others = &pictures == &t.others;
    if (!t.scene) {
        const double time = w.plan.time;
        auto made = others ? ReferenceScene::make(reseeded(w.project, tables), tables, time, control)
                           : ReferenceScene::make(w.project, tables, time, control);
        if (!made) return made.error();
        t.scene = std::move(*made);
        return {};
    }
    ReferenceSettings s;
    s.width = w.plan.width, s.height = w.plan.height, s.samples = w.plan.samples;
    s.lighting = ReferenceLighting::Direct, s.seed = seedOf(w.views, pictures.size());
    auto truth = t.scene->trace(w.views[pictures.size()], s, control);
    if (!truth) return truth.error();
    pictures.push_back(tracedPicture(truth->width, truth->height, truth->color, truth->error));
    if (!others) t.grass.push_back(std::move(truth->grass));
    if (pictures.size() == w.views.size()) t.scene.reset();
    return {};
}

Json stepsJson(const Transitions& t) {
    Json steps = Json::makeArray();
    for (size_t i = 0; i < t.drawn.steps.size(); ++i) {
        Json step;
        step["from"] = t.seconds[i], step["to"] = t.seconds[i + 1];
        step["popping"] = t.drawn.steps[i], step["floor"] = t.floor.steps[i];
        steps.push(std::move(step));
    }
    return steps;
}

}  // namespace

Result<std::shared_ptr<TransitionWalk>> beginWalk(const Project& project, const Tables& tables,
                                                  const TransitionPlan& plan) {
    if (Status sound = checkPlan(plan, project); !sound) return sound.error();
    auto walk = std::make_shared<TransitionWalk>();
    walk->plan = plan;
    walk->truth = std::make_shared<WalkTruth>();
    walk->project = snapshot(project, tables.components);
    const CameraPath& path = *project.registry.get<CameraPath>(findEntity(project, plan.path));
    for (int i = 0; i < plan.pictures; ++i) {
        const double at = plan.from + (endOf(plan, path) - plan.from) * i / (plan.pictures - 1);
        walk->seconds.push_back(at);
        walk->views.push_back(viewOf(cameraOn(path, at)));
    }
    return walk;
}

Status drawNextOf(TransitionWalk& w, Renderer& renderer) {
    if (isDrawn(w)) return {};
    ViewSettings s;
    s.width = w.plan.width, s.height = w.plan.height, s.time = w.plan.time;
    if (Status drawn = drawSettled(renderer, w.project, w.views[w.drawn.size()], s); !drawn) return drawn;
    w.drawn.push_back(pictureOfLinear(s.width, s.height, renderer.readLinear()));
    return {};
}

bool isDrawn(const TransitionWalk& w) { return w.drawn.size() == w.views.size(); }

Status traceNextOf(TransitionWalk& w, const Tables& tables, JobControl& control) {
    if (control.cancelled()) return interruption("cancelled");
    WalkTruth& t = *w.truth;
    if (t.pictures.size() < w.views.size()) return traceInto(t.pictures, w, tables, control);
    return isTraced(w) ? Status{} : traceInto(t.others, w, tables, control);
}

bool isTraced(const TransitionWalk& w) { return w.truth->others.size() == w.views.size(); }

double tracedShare(const TransitionWalk& w) {
    const size_t done = w.truth->pictures.size() + w.truth->others.size();
    return static_cast<double>(done) / static_cast<double>(2 * w.views.size());
}

Result<Transitions> judgeWalk(const TransitionWalk& w) {
    CHECK(isDrawn(w) && isTraced(w));
    const WalkTruth& truth = *w.truth;
    const auto poppingOf = [&](const std::vector<Picture>& images) {
        return popping(w.views.size(), [&](size_t i) { return pairBy(images[i], truth.pictures[i], truth.grass[i]); });
    };
    auto drawn = poppingOf(w.drawn);
    if (!drawn) return drawn.error();
    auto floor = poppingOf(truth.others);
    if (!floor) return floor.error();
    Transitions out{w.plan, w.seconds, w.views, std::move(*drawn), std::move(*floor), 0};
    for (const std::vector<float>& grass : truth.grass)
        out.blind += std::none_of(grass.begin(), grass.end(), [](float g) { return g > 0; });
    return out;
}

size_t stepsAboveFloor(const Transitions& t) {
    size_t above = 0;
    for (size_t i = 0; i < t.drawn.steps.size(); ++i) above += t.drawn.steps[i] > t.floor.steps[i];
    return above;
}

std::string transitionsText(const Transitions& t) {
    const auto worst = static_cast<size_t>(t.drawn.worstStep);
    std::string out = fmt::format(
        "popping  {:.5f}  mean of {} steps along {}; at worst {:.5f}, from second {:.3g} to {:.3g}\nfloor    {:.5f}  "
        "of "
        "other blades; at worst {:.5f}\n{} of {} steps pop more than other blades do; in all, pictures change {:.2f} "
        "times as much as the truth\n",
        t.drawn.mean, t.drawn.steps.size(), t.plan.path, t.drawn.worst, t.seconds[worst], t.seconds[worst + 1],
        t.floor.mean, t.floor.worst, stepsAboveFloor(t), t.drawn.steps.size(), t.drawn.change);
    if (t.blind > 0) out += fmt::format("{} pictures see no grass; steps to and from them count 0\n", t.blind);
    return out;
}

std::string transitionsJson(const Transitions& t) {
    const auto worst = static_cast<size_t>(t.drawn.worstStep);
    Json j;
    j["path"] = t.plan.path, j["pictures"] = t.plan.pictures, j["samples"] = t.plan.samples;
    j["size"].push(t.plan.width), j["size"].push(t.plan.height);
    j["popping"] = t.drawn.mean, j["popping_worst"] = t.drawn.worst;
    j["popping_floor"] = t.floor.mean, j["popping_floor_worst"] = t.floor.worst;
    j["change"] = std::isfinite(t.drawn.change) ? Json(t.drawn.change) : Json();
    j["above_floor"] = static_cast<int>(stepsAboveFloor(t));
    j["worst_step"].push(t.seconds[worst]), j["worst_step"].push(t.seconds[worst + 1]);
    j["steps"] = stepsJson(t);
    return writeJson(j);
}

}  // namespace sward
