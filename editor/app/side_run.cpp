#include "app/side_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <span>
#include <sstream>
#include <utility>

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

// The project as it is now, unsaved work included, with the view as a camera of that name.
Result<Project> seenFrom(const Document& doc, const std::string& camera, const FlyCamera& from) {
    Project copy = snapshot(doc.project(), doc.tables().components);
    if (findEntity(copy, camera) != kNoEntity) return copy;
    const Result<Entity> added = addEntity(copy, camera);
    if (!added) return added.error();
    const ViewCamera view = viewOf(from);
    Camera c;
    c.eye = view.eye, c.target = view.target, c.fovDeg = view.fovDeg, c.exposure = view.exposure;
    copy.registry.add<Camera>(*added, c);
    return copy;
}

void removeFolder(const fs::path& folder) {
    std::error_code ignored;
    if (!folder.empty()) fs::remove_all(folder, ignored);
}

// Image files come from the project's folder.
Status writeCopy(Project& copy, std::span<const ComponentRow> rows, const fs::path& to) {
    removeFolder(to);
    if (Status s = makeFolderOf(to); !s) return s;
    Project original;
    original.dir = std::exchange(copy.dir, to);
    const auto written = saveProject(copy, rows, original.dir.empty() ? nullptr : &original);
    return written ? Status{} : Status{written.error()};
}

// A lane does one thing after the other: what is left of a copy that was stopped is gone before the next begins.
void dropInLane(const fs::path& copy) {
    runInLane(Lane::Waited, std::make_shared<JobControl>(), [copy] { removeFolder(copy); });
}

// Removes what it wrote if it was stopped: when the program ends, what waits in the lane is not run.
Job<bool> writtenBeside(Project project, std::span<const ComponentRow> rows, const fs::path& to) {
    auto copy = std::make_shared<Project>(std::move(project));
    return Job<bool>(Lane::Waited, "copy", 0, [copy, rows, to](JobControl& control) -> Result<bool> {
        const Status written = writeCopy(*copy, rows, to);
        if (!written || control.cancelled()) removeFolder(to);
        if (!written) return written.error();
        return true;
    });
}

bool isNews(const std::string& line) { return line.find(" %  ") < 4; }

fs::path printed(const SideRun& run, const char* verb, const char* ending) {
    return run.folder / (std::string(verb) + ending);
}

void dropCopy(SideRun& run) {
    removeFolder(run.copy);
    run.copy.clear();
}

Status startChild(SideRun& run) {
    const char* verb = run.command[1].c_str();
    Result<ChildProcess> child =
        ChildProcess::start(run.command, printed(run, verb, ".out"), printed(run, verb, ".err"));
    if (!child) return child.error();
    run.child = std::move(*child);
    return {};
}

// Starts the program once its copy is there. False if that failed; `run.error` says why.
bool followCopy(SideRun& run) {
    const auto copied = run.copying.take(0);
    if (!copied) return true;
    const Status started = *copied ? startChild(run) : Status{copied->error()};
    if (!started) run.error = started.error().text();
    return bool(started);
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
    if (run.running()) return failed(std::string(verb) + " runs already", "stop it first");
    Result<Project> copy = seenFrom(p.doc, camera, p.camera);
    if (!copy) return copy.error();
    run.camera = camera;
    run.folder = sideFolder(p.doc);
    run.copy = run.folder / (std::string("project-") + verb);
    run.started = p.clock.now;
    run.news = {.since = p.clock.now};
    run.error.clear();
    run.command = {p.program, verb, run.copy.string(), "--camera", camera};
    run.command.insert(run.command.end(), args.begin(), args.end());
    run.copying = writtenBeside(std::move(*copy), p.doc.tables().components, run.copy);
    return {};
}

std::optional<int> endedRun(SideRun& run, FrameClock& clock) {
    const bool started = followCopy(run);
    const std::optional<int> code = started ? run.child.poll() : 1;
    if (!code) return {};
    dropCopy(run);
    clock.wanted = 4;
    return code;
}

std::string failureOf(const SideRun& run, const char* verb, int code) {
    if (!run.error.empty()) return run.error;
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
    const bool writing = run.copying.active();
    run.copying = {};
    run.child.stop();
    if (writing) dropInLane(std::exchange(run.copy, {}));
    dropCopy(run);
}

}  // namespace sward
