#include <sys/resource.h>

#include <chrono>

#include "cli/cli.h"
#include "cli/interrupt.h"
#include "core/file.h"
#include "core/hash.h"
#include "core/json.h"
#include "core/numerics.h"
#include "maps/map_io.h"
#include "project/project_files.h"
#include "reference/reference_part.h"
#include "techniques.h"
#include "world/view_camera.h"

namespace sward {
namespace fs = std::filesystem;

Result<std::pair<int, int>> parseShard(const std::string& text) {
    if (text.empty()) return std::pair{0, 1};
    int i = 0, n = 0;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%d/%d%c", &i, &n, &rest) != 2 || n < 1 || i < 0 || i >= n)
        return usage("\"" + text + "\" is no shard", "write I/N, I from 0 to N-1, such as 0/4");
    return std::pair{i, n};
}

namespace {

// As shaders/post/tonemap.frag.glsl shows it.
std::vector<uint8_t> toneMapped(const std::vector<float>& linear, int width) {
    std::vector<uint8_t> out(linear.size());
    for (size_t i = 0; i + 2 < linear.size(); i += 3) {
        const glm::vec3 shown = f32::srgbEncode3(
            f32::toneMapNeutral(glm::max(glm::vec3(linear[i], linear[i + 1], linear[i + 2]), glm::vec3(0))));
        const int pixel = static_cast<int>(i / 3);
        const float dither = f32::ditherOf(pixel % width, pixel / width);
        for (int c = 0; c < 3; ++c)
            out[i + static_cast<size_t>(c)] =
                static_cast<uint8_t>(std::lround(std::clamp(255 * shown[c] + dither, 0.0f, 255.0f)));
    }
    return out;
}

// The image, and its standard error beside it.
Status writeTruth(const Truth& t, const fs::path& file) {
    if (Status s = makeFolderOf(file); !s) return s;
    const fs::path error = fs::path(file).replace_extension(".error.exr");
    if (file.extension() != ".exr" && file.extension() != ".png")
        return usage("images are written as .png or .exr", "name --out so").at(file);
    const Status drawn = file.extension() == ".exr"
                             ? writeImageExr(file, t.width, t.height, 3, t.color)
                             : writeImagePng(file, t.width, t.height, 3, toneMapped(t.color, t.width));
    if (!drawn) return drawn;
    if (Status s = writeImageExr(error, t.width, t.height, 3, t.error); !s) return s;
    std::printf("%s\n%s\n", file.string().c_str(), error.string().c_str());
    return {};
}

double meanOf(const std::vector<float>& values) {
    double sum = 0;
    for (const float v : values) sum += static_cast<double>(v);
    return sum / static_cast<double>(std::max<size_t>(values.size(), 1));
}

struct TracedShot {
    const ReferenceOptions& options;
    const Project& project;
    const ReferenceScene& scene;
    ReferenceSettings settings;
    std::string camera;
    double time;
    ViewCamera view;
    // A shard's file is a part for merge, also of a picture that is one shard: whoever starts N of them need not ask.
    bool isPart() const { return !options.shard.empty(); }
};

uint64_t partHash(const TracedShot& s) {
    const ReferenceSettings& r = s.settings;
    const std::string text =
        fmt::format("{} {} {} {}x{} {} {} {} {}", hashHex(projectHash(s.project, tables().components)), s.camera,
                    s.time, r.width, r.height, r.samples, r.seed, static_cast<int>(r.lighting), r.shards);
    return hashText(text);
}

Result<Json> trace(const TracedShot& s, const fs::path& file) {
    const auto start = std::chrono::steady_clock::now();
    Job<Truth> job("reference " + s.camera, 0,
                   [&s](JobControl& control) { return s.scene.trace(s.view, s.settings, control); });
    auto truth = waitFor(job, 0, "fewer --samples or a smaller --size take less, --shard parts the work");
    if (!truth) return truth.error();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!s.isPart()) {
        if (Status st = writeTruth(*truth, file); !st) return st.error();
    } else {
        if (Status st = makeFolderOf(file); !st) return st.error();
        if (Status st = writeFileAtomic(file, encodePart({s.camera, partHash(s), s.settings, std::move(*truth)})); !st)
            return st.error();
        std::printf("%s\n", file.string().c_str());
    }
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    Json j;
    j["sward"] = SWARD_VERSION, j["project"] = s.project.name, j["camera"] = s.camera,
    j["samples"] = s.settings.samples;
    j["lighting"] = kReferenceLightings[s.settings.lighting], j["seconds"] = seconds;
    j["size"].push(s.settings.width), j["size"].push(s.settings.height);
    if (!s.isPart()) j["mean_error"] = meanOf(truth->error), j["grass"] = meanOf(truth->grass);
    j["memory"]["host_peak_bytes"] = int64_t(used.ru_maxrss) * 1024;
    return j;
}

// A shard's file is a part: FILE.part, unless --out names it.
fs::path fileOf(const ReferenceOptions& o, const Project& p, const std::string& camera, bool several,
                const ReferenceSettings& s) {
    const fs::path file = outputOf(o, p, camera, several);
    if (o.shard.empty() || (!several && !o.out.empty())) return file;
    return fs::path(file).replace_extension(fmt::format(".{}-of-{}.part", s.shard, s.shards));
}

Result<Json> traceAll(ReferenceOptions o, const Project& project, ReferenceSettings settings) {
    const auto cameras = shotNames(o, project);
    if (!cameras) return cameras.error();
    const bool film = o.fps > 0 && o.frames > 0, several = cameras->size() > 1;
    Json all = Json::makeArray();
    for (int frame = 0; frame < (film ? o.frames : 1); ++frame) {
        const double since = film ? frame / o.fps : 0, time = o.time + since;
        Job<ReferenceScene> job(
            "scene", 0, [&](JobControl& control) { return ReferenceScene::make(project, tables(), time, control); });
        auto scene = waitFor(job, 0, "fewer or shorter blades take less");
        if (!scene) return scene.error();
        for (const std::string& camera : *cameras) {
            const fs::path file =
                film ? (several ? fs::path(o.out) / camera : fs::path(o.out)) / fmt::format("frame_{:04d}.png", frame)
                     : fileOf(o, project, camera, several, settings);
            auto told = trace({o, project, *scene, settings, camera, time, shotAt(o, project, camera, since)}, file);
            if (!told) return told.error();
            all.push(std::move(*told));
        }
    }
    return all;
}

Result<ReferenceSettings> settingsOf(const ReferenceOptions& o) {
    ReferenceSettings s;
    const auto size = parseSize(o.size);
    if (!size) return size.error();
    const auto shard = parseShard(o.shard);
    if (!shard) return shard.error();
    std::tie(s.width, s.height) = *size;
    std::tie(s.shard, s.shards) = *shard;
    s.bandRows = bandRowsFor(s.height, s.shards);
    s.samples = o.samples, s.seed = o.seed;
    if (o.samples < 1 || o.samples > kMaxReferenceSamples)
        return usage(fmt::format("{} samples a pixel make no picture", o.samples),
                     fmt::format("--samples takes 1 to {}", kMaxReferenceSamples));
    if (o.lighting != "full" && o.lighting != "direct")
        return usage("there is no lighting \"" + o.lighting + "\"", "full or direct");
    s.lighting = o.lighting == "direct" ? ReferenceLighting::Direct : ReferenceLighting::Full;
    if (o.view != "final") return usage("the reference shows light alone", "leave --view out");
    if (o.frames < 0) return usage("--frames takes a number from 0");
    if (!o.shard.empty() && o.fps > 0) return usage("a film has no shards", "leave --shard or --fps out");
    return s;
}

}  // namespace

int referenceVerb(const ReferenceOptions& o) {
    const auto settings = settingsOf(o);
    if (!settings) return report(settings.error());
    const auto project = openForRendering(o);
    if (!project) return report(project.error());
    const Interruptible here;
    const auto told = traceAll(o, *project, *settings);
    if (!told) return report(told.error());
    if (o.stats.empty()) return 0;
    Json stats = told->array.front();
    if (told->array.size() > 1) stats = Json::makeObject(), stats["cameras"] = *told;
    if (Status s = writeFileAtomic(o.stats, writeJson(stats)); !s) return report(s.error());
    return 0;
}

int mergeVerb(const MergeCommand& o) {
    if (!o.parts.empty() && isCostPart(o.parts.front())) return mergeCostVerb(o);
    const auto truth = mergeParts({o.parts.begin(), o.parts.end()});
    if (!truth) return report(truth.error());
    if (Status s = writeTruth(*truth, o.out); !s) return report(s.error());
    return 0;
}

}  // namespace sward
