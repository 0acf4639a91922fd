#include "model/autosave.h"

#include <fmt/format.h>

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

// The same without those that were not written to their end.
std::vector<fs::path> completeIn(const fs::path& folder) {
    std::vector<fs::path> found = numbered(folder);
    std::erase_if(found, [](const fs::path& copy) { return !complete(copy); });
    return found;
}

fs::path lockOf(const fs::path& folder) { return folder / "lock"; }

// Whether somebody who lives makes copies there. Looking must not make the folder.
bool isHeld(const fs::path& folder) {
    std::error_code ignored;
    FileLock lock;
    return fs::exists(lockOf(folder), ignored) && lock.tryFile(lockOf(folder)) == LockTry::Busy;
}

// The folder goes while its lock is held, so that nobody takes what is being removed.
void removePlace(AutosavePlace& place) {
    std::error_code ignored;
    if (!place.folder.empty()) fs::remove_all(place.folder, ignored);
    place = {};
}

void begin(Autosave& a, const Document& doc, double now) {
    a.since = a.began = now;
    a.revision = doc.revision();
    if (a.mine.folder.empty())
        if (auto place = takeAutosavePlace(a.of)) a.mine = std::move(*place);
    if (a.mine.folder.empty()) {
        logWarning(
            fmt::format("{}: unsaved work is not copied: its {} folders hold work that others left or do now; "
                        "open the project again, and recover it or throw it away",
                        autosaveFolder(a.of).string(), kAutosaveFolders));
        return;
    }
    const std::span<const ComponentRow> rows = doc.tables().components;
    auto copy = std::make_shared<Project>(snapshot(doc.project(), rows));
    a.job = Job<fs::path>("autosave", a.revision, [copy, rows, folder = a.mine.folder](JobControl&) {
        return writeAutosave(*copy, rows, folder);
    });
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
    removePlace(a.mine);
    a.of = doc.project().dir;
    a.since = now;
    a.found = autosavesOf(a.of);
    a.opening = !a.found.empty();
}

}  // namespace

fs::path autosaveFolder(const fs::path& dir, int number) {
    const fs::path whole = dir.empty() ? dir : fs::absolute(dir).lexically_normal();
    const std::string name = whole.has_filename() ? whole.filename().string() : "untitled";
    const std::string which = number > 1 ? fmt::format("-{}", number) : "";
    return stateDir() / "autosave" / (name + "-" + hashHex(hashText(whole.string())) + which);
}

std::vector<fs::path> autosavesOf(const fs::path& dir) {
    std::vector<std::pair<fs::file_time_type, fs::path>> found;
    std::error_code ignored;
    for (int i = 1; i <= kAutosaveFolders; ++i) {
        const fs::path folder = autosaveFolder(dir, i);
        if (isHeld(folder)) continue;
        for (const fs::path& copy : completeIn(folder)) found.push_back({fs::last_write_time(copy, ignored), copy});
    }
    std::sort(found.rbegin(), found.rend());
    std::vector<fs::path> copies;
    for (auto& [time, copy] : found) copies.push_back(std::move(copy));
    return copies;
}

std::optional<AutosavePlace> takeAutosavePlace(const fs::path& dir) {
    for (int i = 1; i <= kAutosaveFolders; ++i) {
        AutosavePlace place{autosaveFolder(dir, i), {}};
        std::error_code fault;
        fs::create_directories(place.folder, fault);
        if (place.lock.tryFile(lockOf(place.folder)) != LockTry::Busy && completeIn(place.folder).empty()) return place;
    }
    return std::nullopt;
}

Result<fs::path> writeAutosave(const Project& p, std::span<const ComponentRow> rows, const fs::path& folder) {
    std::error_code fault;
    fs::create_directories(folder, fault);
    if (fault) return fileError("cannot be made", folder, fault.value());
    const std::vector<fs::path> before = numbered(folder);
    const long last = before.empty() ? 0 : std::strtol(before.front().filename().c_str(), nullptr, 10);
    Project copy = snapshot(p, rows), original;
    original.dir = p.dir;
    copy.dir = folder / fmt::format("{:04}", last + 1);
    SaveWay way;
    way.copy = true;
    const auto written = saveProject(copy, rows, p.dir.empty() ? nullptr : &original, way);
    if (!written) {
        fs::remove_all(copy.dir, fault);
        return written.error();
    }
    for (size_t i = kAutosavesKept - 1; i < before.size(); ++i) fs::remove_all(before[i], fault);
    return copy.dir;
}

void forgetAutosaves(const fs::path& dir) {
    for (int i = 1; i <= kAutosaveFolders; ++i) {
        AutosavePlace place{autosaveFolder(dir, i), {}};
        std::error_code ignored;
        if (fs::exists(place.folder, ignored) && place.lock.tryFile(lockOf(place.folder)) != LockTry::Busy)
            removePlace(place);
    }
}

void adoptAutosave(Autosave& a, const fs::path& copy) {
    removePlace(a.mine);
    AutosavePlace place{copy.parent_path(), {}};
    if (place.lock.tryFile(lockOf(place.folder)) != LockTry::Busy)
        a.mine = std::move(place);  // else another took it over
}

bool tickAutosave(Autosave& a, Document& doc, bool held, double now) {
    if (!a.on || !doc.isOpen()) return false;
    const bool copying = a.job.active();
    report(a);
    if (a.job.active()) return false;
    if (copying) a.wait = std::max(kAutosaveSeconds, (now - a.began) / kAutosaveShare);
    const bool another = a.of != doc.project().dir;
    if (another) follow(a, doc, now);
    const bool asks = another && a.opening;
    if (!doc.dirty()) {
        removePlace(a.mine);
        a.since = now;
        return asks;
    }
    const bool busy = doc.stroking() || held || a.revision == doc.revision();
    if (!busy && now - a.since >= a.wait) begin(a, doc, now);
    return asks;
}

void endAutosave(Autosave& a) {
    if (!a.on) return;
    while (a.job.active() && !a.job.finished()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    removePlace(a.mine);
}

}  // namespace sward
