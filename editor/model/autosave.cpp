#include "model/autosave.h"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "core/file.h"
#include "core/hash.h"
#include "core/log.h"
#include "core/save_folder.h"
#include "model/document.h"
#include "project/project_files.h"

namespace fs = std::filesystem;

namespace sward {
namespace {

bool isNumber(const std::string& name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isdigit(c); });
}

// Numbered folders, newest first; complete or not.
std::vector<fs::path> numbered(const fs::path& folder) {
    std::vector<fs::path> found;
    std::error_code fault;
    for (fs::directory_iterator it(folder, fault), end; !fault && it != end; it.increment(fault))
        if (isNumber(it->path().filename().string())) found.push_back(it->path());
    std::sort(found.rbegin(), found.rend());
    return found;
}

bool complete(const fs::path& copy) {
    const Result<fs::path> file = currentFile(copy, "project.json");
    std::error_code fault;
    return file && fs::is_regular_file(*file, fault);
}

// True while a program other than this one, which wrote its number there, still runs.
bool heldByAnother(const fs::path& folder) {
    const Result<std::string> text = readFile(folder / "pid", 32);
    const long pid = text ? std::strtol(text->c_str(), nullptr, 10) : 0;
    return pid > 0 && pid != getpid() && kill(static_cast<pid_t>(pid), 0) == 0;
}

void begin(Autosave& a, const Document& doc, double now) {
    a.since = now;
    a.revision = doc.revision();
    a.mine = true;
    const std::span<const ComponentRow> rows = doc.tables().components;
    auto copy = std::make_shared<Project>(snapshot(doc.project(), rows));
    a.job = Job<fs::path>("autosave", a.revision, [copy, rows](JobControl&) { return writeAutosave(*copy, rows); });
}

void report(Autosave& a) {
    const auto done = a.job.take(a.revision);
    if (!done) return;
    if (*done)
        logInfo("unsaved work is copied to " + (**done).string());
    else
        logWarning("unsaved work could not be copied: " + done->error().text());
}

void follow(Autosave& a, const Document& doc, double now) {
    if (a.mine) forgetAutosaves(a.of);
    a.of = doc.project().dir;
    a.since = now;
    a.mine = false;
    a.found = autosavesOf(a.of);
    a.opening = !a.found.empty();
}

}  // namespace

fs::path autosaveFolder(const fs::path& dir) {
    const fs::path whole = dir.empty() ? dir : fs::absolute(dir).lexically_normal();
    const std::string name = whole.has_filename() ? whole.filename().string() : "untitled";
    return stateDir() / "autosave" / (name + "-" + hashHex(hashText(whole.string())));
}

std::vector<fs::path> autosavesOf(const fs::path& dir) {
    const fs::path folder = autosaveFolder(dir);
    if (heldByAnother(folder)) return {};
    std::vector<fs::path> found = numbered(folder);
    std::erase_if(found, [](const fs::path& copy) { return !complete(copy); });
    return found;
}

Result<fs::path> writeAutosave(const Project& p, std::span<const ComponentRow> rows) {
    const fs::path folder = autosaveFolder(p.dir);
    std::error_code fault;
    fs::create_directories(folder, fault);
    if (fault) return fileError("cannot be made", folder, fault.value());
    const std::vector<fs::path> before = numbered(folder);
    const long last = before.empty() ? 0 : std::strtol(before.front().filename().c_str(), nullptr, 10);
    Project copy = snapshot(p, rows), original;
    original.dir = p.dir;
    copy.dir = folder / fmt::format("{:04}", last + 1);
    if (Status marked = writeFileAtomic(folder / "pid", std::to_string(getpid())); !marked) return marked.error();
    const auto written = saveProject(copy, rows, p.dir.empty() ? nullptr : &original);
    if (!written) {
        fs::remove_all(copy.dir, fault);
        return written.error();
    }
    for (size_t i = kAutosavesKept - 1; i < before.size(); ++i) fs::remove_all(before[i], fault);
    return copy.dir;
}

void forgetAutosaves(const fs::path& dir) {
    std::error_code ignored;
    fs::remove_all(autosaveFolder(dir), ignored);
}

bool tickAutosave(Autosave& a, Document& doc, bool held, double now) {
    if (!a.on || !doc.isOpen()) return false;
    report(a);
    if (a.job.active()) return false;
    const bool another = a.of != doc.project().dir;
    if (another) follow(a, doc, now);
    const bool asks = another && a.opening;
    if (!doc.dirty()) {
        if (std::exchange(a.mine, false)) forgetAutosaves(a.of);
        a.since = now;
        return asks;
    }
    const bool busy = doc.stroking() || held || a.revision == doc.revision();
    if (!busy && now - a.since >= kAutosaveSeconds) begin(a, doc, now);
    return asks;
}

void endAutosave(Autosave& a) {
    if (!a.on) return;
    while (a.job.active() && !a.job.finished()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (std::exchange(a.mine, false)) forgetAutosaves(a.of);
}

}  // namespace sward
