#include "app/side_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "app/frame_clock.h"
#include "app/time_left.h"
#include "core/file.h"
#include "core/hash.h"
#include "model/document.h"
#include "project/project_files.h"
#include "tools/camera_control.h"
#include "world/view_camera.h"

namespace fs = std::filesystem;

namespace sward {
namespace {

constexpr double kLookSeconds = 0.5;

// Unsaved work included, and the view as a camera of that name; image files come from the project's folder.
Status writeCopy(const Document& doc, const fs::path& to, const std::string& camera, const FlyCamera& from) {
    std::error_code fault;
    fs::remove_all(to, fault);
    if (Status s = makeFolderOf(to); !s) return s;
    Project copy = snapshot(doc.project(), doc.tables().components), original;
    original.dir = copy.dir;
    copy.dir = to;
    if (findEntity(copy, camera) == kNoEntity) {
        const Result<Entity> added = addEntity(copy, camera);
        if (!added) return added.error();
        const ViewCamera view = viewOf(from);
        Camera c;
        c.eye = view.eye, c.target = view.target, c.fovDeg = view.fovDeg, c.exposure = view.exposure;
        copy.registry.add<Camera>(*added, c);
    }
    const auto written = saveProject(copy, doc.tables().components, original.dir.empty() ? nullptr : &original);
    return written ? Status{} : Status{written.error()};
}

bool isNews(const std::string& line) { return line.find(" %  ") < 4; }

fs::path printed(const SideRun& run, const char* verb, const char* ending) {
    return run.folder / (std::string(verb) + ending);
}

void dropCopy(SideRun& run) {
    std::error_code ignored;
    if (!run.copy.empty()) fs::remove_all(run.copy, ignored);
    run.copy.clear();
}

Status start(SideRun& run, const MeasureParts& p, const char* verb, const std::vector<std::string>& more) {
    if (Status s = writeCopy(p.doc, run.copy, run.camera, p.camera); !s) return s;
    std::vector<std::string> args{p.program, verb, run.copy.string(), "--camera", run.camera};
    args.insert(args.end(), more.begin(), more.end());
    Result<ChildProcess> child = ChildProcess::start(args, printed(run, verb, ".out"), printed(run, verb, ".err"));
    if (!child) return child.error();
    run.child = std::move(*child);
    return {};
}

}  // namespace

std::optional<RunNews> newsFrom(const std::string& text) {
    std::optional<RunNews> news;
    std::string line;
    for (std::istringstream in(text); std::getline(in, line);)
        if (isNews(line))
            news =
                RunNews{.what = line.substr(line.find(" %  ") + 4), .share = std::strtod(line.c_str(), nullptr) / 100};
    return news;
}

std::string newsText(const RunNews& news, double now) {
    if (news.what.empty()) return fmt::format("starts, {:.0f} s", std::max(now - news.since, 0.0));
    const std::string left = timeLeft(news.share, now - news.since);
    return fmt::format("{:.0f} %{}{}: {}", 100 * news.share, left.empty() ? "" : ", ", left, news.what);
}

fs::path sideFolder(const Document& doc) {
    return stateDir() / "cost" / hashHex(projectHash(doc.project(), doc.tables().components));
}

Status launchRun(SideRun& run, const MeasureParts& p, const char* verb, const std::string& camera,
                 const std::vector<std::string>& args) {
    if (!p.doc.isOpen()) return failed("no project is open", "open or create one first");
    if (run.child.running()) return failed(std::string(verb) + " runs already", "stop it first");
    run.camera = camera;
    run.folder = sideFolder(p.doc);
    run.copy = run.folder / (std::string("project-") + verb);
    run.started = p.clock.now;
    run.news = {.since = p.clock.now};
    run.error.clear();
    const Status started = start(run, p, verb, args);
    if (!started) dropCopy(run);
    return started;
}

std::optional<int> endedRun(SideRun& run, FrameClock& clock) {
    const std::optional<int> code = run.child.poll();
    if (!code) return {};
    dropCopy(run);
    clock.wanted = 4;
    return code;
}

std::string failureOf(const SideRun& run, const char* verb, int code) {
    const Result<std::string> text = readFile(printed(run, verb, ".err"), 1 << 20);
    std::string line, said;
    for (std::istringstream in(text ? *text : ""); std::getline(in, line);)
        if (!line.empty() && !isNews(line)) said = line;
    return said.empty() ? fmt::format("sward {} ended with exit code {}", verb, code) : said;
}

bool followNews(SideRun& run, const char* verb, double now) {
    if (!run.child.running() || now - run.news.read < kLookSeconds) return false;
    run.news.read = now;
    const Result<std::string> text = readFile(printed(run, verb, ".err"), 1 << 20);
    std::optional<RunNews> told = text ? newsFrom(*text) : std::nullopt;
    if (!told || (told->what == run.news.what && told->share == run.news.share)) return false;
    if (told->share >= run.news.share && !run.news.what.empty())
        told->since = run.news.since;
    else
        told->since = now;  // another part
    told->read = now;
    run.news = std::move(*told);
    return true;
}

void stopRun(SideRun& run) {
    run.child.stop();
    dropCopy(run);
}

}  // namespace sward
