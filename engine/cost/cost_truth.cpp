#include "cost/cost_truth.h"

#include <chrono>
#include <thread>

#include "core/hash.h"
#include "maps/map_io.h"
#include "project/project_files.h"
#include "scene/forest_technique.h"
#include "world/view_camera.h"
#include "world/wind.h"

namespace sward {
namespace {
namespace fs = std::filesystem;

constexpr int kFewSamples = 4;  // of techniques with the usual multisampling
// Of other blades strips alone are traced, each a row of the largest blocks that appearance compares: a third of the
// rays, and by how much less the floor is known its own standard error says.
constexpr int kStripRows = kAppearanceBlocks[std::size(kAppearanceBlocks) - 1], kStripEvery = 3;
static_assert(kStripRows % kShardRows == 0);

// The weights that are left in the strips, and the shards of which the strips are the first; all of it, if no grass is
// in them.
std::pair<std::vector<float>, int> seedStrips(const std::vector<float>& grass, int width) {
    std::vector<float> left = grass;
    bool any = false;
    for (size_t i = 0; i < grass.size(); ++i) {
        const bool in = static_cast<int>(i) / width / kStripRows % kStripEvery == 0;
        any |= in && grass[i] > 0;
        if (!in) left[i] = 0;
    }
    return any ? std::pair(std::move(left), kStripEvery * kStripRows / kShardRows) : std::pair(grass, 1);
}

// Leaves of a forest what says which trees stand: how they are drawn is as usual.
void drawAsUsual(Forest& f) {
    const Forest usual;
    f.technique = usual.technique, f.meshesTo = usual.meshesTo, f.meshDetail = usual.meshDetail;
    f.storage = usual.storage, f.silhouetteDeg = usual.silhouetteDeg, f.slant = usual.slant;
}
// Names what the truth follows from: the project without how its grass and its forests are drawn.
uint64_t populationHash(const Project& p, const Tables& tables) {
    Project plain = snapshot(p, tables.components);
    const GrassField usual;
    for (const auto& [name, e] : plain.entities) {
        if (GrassField* f = plain.registry.get<GrassField>(e)) f->technique = usual.technique;
        if (Forest* f = plain.registry.get<Forest>(e)) drawAsUsual(*f);
        for (const ComponentRow& row : tables.components)
            if (row.settingsOf && !row.readByTruth) row.remove(plain.registry, e);
    }
    return projectHash(plain, tables.components);
}
// Where a traced picture is kept: RGB and the share of grass as one EXR, the standard errors as another beside it.
fs::path fileOf(const CostRequest& r, const Project& p, const Tables& tables, const CostView& view,
                const ReferenceSettings& s) {
    const std::string of =
        fmt::format("{} {} {}x{} {} {} {} {} {}", hashHex(populationHash(p, tables)), view.name, s.width, s.height,
                    r.time + view.since, s.samples, s.seed, static_cast<int>(s.lighting), SWARD_VERSION) +
        (s.shards > 1 ? " strips" : "") +
        (growingForests(p).empty() ? ""
         : windOf(p)               ? " swaying trees"
                                   : " trees");
    return r.folder / ("truth-" + hashHex(hashText(of)) + ".exr");
}

double meanFinite(const std::vector<float>& values) {
    double sum = 0, n = 0;
    for (const float v : values)
        if (std::isfinite(v)) sum += v, n += 1;
    return n > 0 ? sum / n : std::numeric_limits<double>::quiet_NaN();
}

Status writePicture(const fs::path& file, const Picture& p) {
    std::vector<uint8_t> rgb;
    for (const glm::vec3& c : p.pixels)
        for (int i = 0; i < 3; ++i)
            rgb.push_back(
                static_cast<uint8_t>(std::isfinite(c[i]) ? std::lround(255 * std::clamp(c[i], 0.0f, 1.0f)) : 0));
    return writeImagePng(file, p.width, p.height, 3, rgb);
}

struct Traced {
    Picture picture;
    std::vector<float> grass;
    double error = 0;
    std::string image;  // its file's name
};
Status keep(const fs::path& file, const Truth& t) {
    std::vector<float> rgba, error;
    for (size_t i = 0; i < t.grass.size(); ++i)
        rgba.insert(rgba.end(), {t.color[3 * i], t.color[3 * i + 1], t.color[3 * i + 2], t.grass[i]});
    error = t.error;
    if (Status s = writeImageExr(fs::path(file).replace_extension(".error.exr"), t.width, t.height, 3, error); !s)
        return s;
    return writeImageExr(file, t.width, t.height, 4, rgba);
}
Result<Traced> kept(const fs::path& file) {
    auto image = readImage(file, true), error = readImage(fs::path(file).replace_extension(".error.exr"), true);
    if (!image) return image.error();
    if (!error) return error.error();
    if (image->channels != 4) return unsound("is no truth of a sweep", "remove it").at(file);
    if (error->width != image->width || error->height != image->height)
        return unsound("has another size than its standard errors", "remove it").at(file);
    Traced t{tracedPicture(*image, *error, false),
             {},
             meanFinite(error->pixels),
             fs::path(file).replace_extension(".png").filename().string()};
    for (size_t i = 3; i < image->pixels.size(); i += 4) t.grass.push_back(image->pixels[i]);
    const fs::path shown = fs::path(file).replace_extension(".png");
    if (!fs::exists(shown))
        if (Status s = writePicture(shown, t.picture); !s) return s.error();
    return t;
}

// All of the picture, or with shards the strips of it.
Result<Truth> traceIn(const ReferenceScene& scene, const ViewCamera& view, ReferenceSettings s, JobControl& control) {
    if (s.shards == 1) return scene.trace(view, s, control);
    auto whole = scene.trace(view, s, control);
    for (s.shard = 1; whole && s.shard < kStripRows / kShardRows; ++s.shard) {
        const auto band = scene.trace(view, s, control);
        if (!band) return band;
        for (size_t i = 0; i < band->color.size(); ++i)
            whole->color[i] += band->color[i], whole->error[i] += band->error[i];
        for (size_t i = 0; i < band->grass.size(); ++i) whole->grass[i] += band->grass[i];
    }
    return whole;
}

// The job reads what its maker holds, so it is waited for after a cancel too.
template <class T>
Result<T> awaited(Job<T>& job, const CostProgress& progress, const std::string& what, double from, double to) {
    bool stop = false;
    while (!job.finished()) {
        if (!stop && !progress(what, from + (to - from) * job.progress())) job.cancel(), stop = true;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    auto made = job.take(0);
    if (made && !stop) return std::move(*made);
    return interruption("interrupted; what is finished is kept", "run the same command again to go on");
}

Result<Traced> traced(const CostRequest& r, const Project& p, const Tables& tables, const CostView& view,
                      ReferenceSettings s, const CostProgress& progress, const std::string& what) {
    s.width = r.width, s.height = r.height;
    const fs::path file = fileOf(r, p, tables, view, s);
    if (fs::exists(file))
        if (auto t = kept(file); t && t->picture.width == r.width && t->picture.height == r.height &&
                                 t->grass.size() == t->picture.pixels.size())
            return t;
    Job<ReferenceScene> scene(
        "scene", 0, [&](JobControl& control) { return ReferenceScene::make(p, tables, r.time + view.since, control); });
    auto made = awaited(scene, progress, what, 0, 0.05);
    if (!made) return made.error();
    Job<Truth> job("truth", 0, [&](JobControl& control) { return traceIn(*made, view.camera, s, control); });
    auto truth = awaited(job, progress, what, 0.05, 1);
    if (!truth) return truth.error();
    if (Status st = keep(file, *truth); !st) return st.error();
    return kept(file);
}

}  // namespace

Picture flatRows(const Picture& picture, const std::vector<float>& grass) {
    Picture out = picture;
    for (int y = 0; y < picture.height; ++y) {
        const size_t first = static_cast<size_t>(y) * static_cast<size_t>(picture.width),
                     end = first + static_cast<size_t>(picture.width);
        glm::vec3 sum(0);
        float weight = 0;
        for (size_t i = first; i < end; ++i)
            if (grass[i] > 0) sum += grass[i] * picture.pixels[i], weight += grass[i];
        for (size_t i = first; weight > 0 && i < end; ++i)
            out.pixels[i] = glm::mix(picture.pixels[i], sum / weight, grass[i]);
        for (size_t i = first; weight > 0 && i < end && !out.noise.empty(); ++i)
            out.noise[i] *= (1 - grass[i]) * (1 - grass[i]);
    }
    return out;
}

Result<CostTruth> costTruthAlone(const CostRequest& r, const Project& project, const Tables& tables,
                                 const CostView& view, const CostProgress& progress) {
    auto truth = traced(r, project, tables, view, r.truth, progress, view.name + ": truth");
    if (!truth) return truth.error();
    if (std::any_of(truth->grass.begin(), truth->grass.end(), [](float g) { return g > 0; }))
        return CostTruth{
            std::move(truth->picture), std::move(truth->grass), {view.name, {}, {}, {}, truth->error, truth->image}};
    return failed(view.name + " sees no grass and no forest", "choose another with --camera");
}

Result<CostTruth> costTruth(const CostRequest& r, const Project& project, const Tables& tables, const CostView& view,
                            const CostProgress& progress) {
    auto truth = costTruthAlone(r, project, tables, view, progress);
    if (!truth) return truth;
    ReferenceSettings few = r.truth;
    few.samples = std::min(kFewSamples, few.samples), few.seed += 1;
    auto sparse = traced(r, project, tables, view, few, progress, view.name + ": truth at few samples");
    if (!sparse) return sparse.error();
    sparse->picture.noise.clear();  // it is what this floor shows
    Project other = snapshot(project, tables.components);
    for (const auto& [name, e] : other.entities)
        if (GrassField* f = other.registry.get<GrassField>(e)) f->seed += f->seed < 1000000 ? 1 : -1;
    const auto [weights, shards] = seedStrips(truth->grass, r.width);
    ReferenceSettings strips = r.truth;
    strips.shards = shards;
    auto reseeded = traced(r, other, tables, view, strips, progress, view.name + ": truth of other blades");
    if (!reseeded) return reseeded.error();
    const std::tuple<Appearance*, Picture, const std::vector<float>*> floors[] = {
        {&truth->floors.seed, reseeded->picture, &weights},
        {&truth->floors.sampling, sparse->picture, &truth->grass},
        {&truth->floors.flat, flatRows(truth->picture, truth->grass), &truth->grass}};
    for (const auto& [floor, picture, by] : floors) {
        auto pair = pairPictures(picture, truth->picture, *by);
        if (!pair) return pair.error();
        *floor = appearance(*pair);
    }
    return truth;
}

}  // namespace sward
