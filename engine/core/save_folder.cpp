#include "core/save_folder.h"

#include <cerrno>
#include <chrono>
#include <set>
#include <thread>

#include "core/file.h"
#include "core/json.h"
#include "core/log.h"

namespace fs = std::filesystem;

namespace sward {
namespace {

// In the save folder: the files to delete after the moves, one path a line.
constexpr const char* kRemovedList = ".removed";
// No list is longer: each of its files was named in a project.json.
constexpr uint64_t kMaxRemovedList = kMaxJsonBytes;
constexpr double kSilentWaitSeconds = 1;
constexpr std::string_view kSwitchEnding = ".sward-switch";  // behind the name of a file that has grown

// A link in its place is none of ours: following it would move someone else's files.
bool isOwnFolder(const fs::path& path) {
    std::error_code ignored;
    return fs::is_directory(fs::symlink_status(path, ignored));
}

std::vector<std::string> filesUnder(const fs::path& root, std::error_code& fault) {
    std::vector<std::string> out;
    for (fs::recursive_directory_iterator it(root, fault), end; !fault && it != end; it.increment(fault))
        if (!it->is_directory()) out.push_back(it->path().lexically_relative(root).generic_string());
    return out;
}

// Makes the new end of a file count. One that is gone has nothing to be made of.
Status switchGrown(const fs::path& dir, const std::string& file) {
    const Result<fs::path> grown = resolveInside(dir, file.substr(0, file.size() - kSwitchEnding.size()));
    if (!grown) return grown.error();
    const Result<HeadSwitch> to = readSwitch(dir / kSaveFolder / file);
    if (!to) return to.error();
    std::error_code fault;
    return fs::exists(*grown, fault) || fault ? switchHead(*grown, *to) : Status();
}

bool isSwitch(const std::string& file) { return file.starts_with("maps/") && file.ends_with(kSwitchEnding); }

Status moveIntoPlace(const fs::path& dir, const std::string& file, std::set<fs::path>& touched) {
    if (isSwitch(file)) return switchGrown(dir, file);
    const Result<fs::path> target = resolveInside(dir, file);
    if (!target) return target.error();
    std::error_code fault;
    fs::create_directories(target->parent_path(), fault);
    fs::rename(dir / kSaveFolder / file, *target, fault);
    if (fault && fault.value() != ENOENT) return fileError("cannot be moved into place", *target, fault.value());
    touched.insert(target->parent_path());
    return {};
}

// Only maps are ever removed, whatever the list says.
Status removeListed(const fs::path& dir) {
    const fs::path list = dir / kSaveFolder / kRemovedList;
    std::error_code ignored;
    if (!fs::exists(list, ignored)) return {};
    const Result<std::string> text = readFile(list, kMaxRemovedList);
    if (!text) return text.error();
    for (size_t i = 0; i < text->size();) {
        const size_t end = std::min(text->find('\n', i), text->size());
        const std::string file = text->substr(i, end - i);
        if (const auto path = resolveInside(dir, file); path && file.starts_with("maps/")) fs::remove(*path, ignored);
        i = end + 1;
    }
    return {};
}

// What fails on the way names the place that it was meant for, not the one where nobody will find it.
Error meantFor(const fs::path& place, Error fault) {
    if (fault.file.find(kSaveTempFolder) != std::string::npos) fault.file = place.string();
    return fault;
}

// Makes a file grow, and writes to `place` what makes its new end count.
Status growFile(const fs::path& dir, const SaveFile& file, const fs::path& place, std::vector<FileGrowth>& grown) {
    Result<FileGrowth> growth = FileGrowth::begin(dir / file.path);
    if (!growth) return growth.error();
    const FileGrowth& added = grown.emplace_back(std::move(*growth));
    const Result<HeadSwitch> to = file.grow(grown.back());
    if (!to) return to.error();
    if (Status s = added.flush(); !s) return s;
    return writeSwitch(place.string() + std::string(kSwitchEnding), *to);
}

Status writeFiles(const fs::path& dir, const std::vector<SaveFile>& files, const std::vector<std::string>& removed,
                  std::vector<FileGrowth>& grown) {
    const fs::path temp = dir / kSaveTempFolder;
    std::set<fs::path> folders{temp};
    std::error_code fault;
    fs::create_directory(temp, fault);
    if (fault) return fileError("cannot be saved to", dir, fault.value());
    for (const SaveFile& file : files) {
        const fs::path place = temp / file.path;
        fs::create_directories(place.parent_path(), fault);
        if (fault) return fileError("cannot be made", (dir / file.path).parent_path(), fault.value());
        for (fs::path folder = place.parent_path(); folder != temp; folder = folder.parent_path())
            folders.insert(folder);
        const Status made = file.grow ? growFile(dir, file, place, grown) : file.write(place);
        if (!made) return meantFor(dir / file.path, made.error());
    }
    std::string list;
    for (const std::string& path : removed) list += path + "\n";
    if (!list.empty())
        if (Status s = writeFileSynced(temp / kRemovedList, list); !s) return meantFor(dir, s.error());
    for (const fs::path& folder : folders)
        if (Status s = syncPath(folder); !s) return meantFor(dir, s.error());
    return {};
}

// Tries again until it is not Busy; what is Absent is done without. `what` they do that are waited for, and where.
Status waitFor(const std::function<LockTry()>& tryLock, const fs::path& dir, const fs::path& locked, const char* what,
               double seconds) {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    const auto waited = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
    bool said = false;
    while (tryLock() == LockTry::Busy) {
        if (waited() >= seconds)
            return failed(fmt::format("is being {} by {}; {:g} s were waited", what, lockHolder(locked), seconds),
                          "nothing was changed; try again when it is done, or end it if it hangs")
                .at(dir);
        if (!said && waited() >= kSilentWaitSeconds) {
            said = true;
            logWarning(fmt::format("{}: is being {} by {}; waiting for it, up to {:g} s", dir.string(), what,
                                   lockHolder(locked), seconds));
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return {};
}

Status moveAll(const fs::path& dir) {
    const fs::path pending = dir / kSaveFolder;
    if (!isOwnFolder(pending)) return {};
    std::error_code fault;
    const std::vector<std::string> files = filesUnder(pending, fault);
    if (fault && fault.value() != ENOENT) return fileError("cannot be read", pending, fault.value());
    std::set<fs::path> touched{dir};
    for (const std::string& file : files)
        if (file != kRemovedList)
            if (Status s = moveIntoPlace(dir, file, touched); !s) return s;
    for (const fs::path& folder : touched)
        if (Status s = syncPath(folder); !s) return s;
    if (Status s = removeListed(dir); !s) return s;
    fs::remove_all(pending, fault);
    if (fault) return fileError("cannot be removed", pending, fault.value());
    return syncPath(dir);
}

// The rename that makes the new state current, and the moves.
Status makeCurrent(const fs::path& dir, double waitSeconds) {
    const Result<FileLock> lock = lockFolder(dir, LockKind::Exclusive, waitSeconds);
    if (!lock) return lock.error();
    std::error_code fault;
    fs::rename(dir / kSaveTempFolder, dir / kSaveFolder, fault);
    if (fault) return fileError("cannot be saved to", dir, fault.value());
    // From here on the new state is what every reader sees.
    Status moved = syncPath(dir);
    if (moved) moved = moveAll(dir);
    if (!moved) logWarning(moved.error().text() + "; saved, and the next save or load moves the files into place");
    return {};
}

}  // namespace

Result<SaveLock> SaveLock::take(const fs::path& dir, double waitSeconds) {
    SaveLock save;
    save.file_ = dir / kSaveLockFile;
    const auto tryLock = [&] { return save.lock_.tryFile(save.file_); };
    if (Status s = waitFor(tryLock, dir, save.file_, "saved", waitSeconds); !s) return s.error();
    return save;
}
SaveLock::~SaveLock() {
    std::error_code ignored;
    if (lock_.held()) fs::remove(file_, ignored);
}

Result<FileLock> lockFolder(const fs::path& dir, LockKind kind, double waitSeconds) {
    FileLock lock;
    const auto tryLock = [&] { return lock.tryFolder(dir, kind); };
    const char* what = kind == LockKind::Shared ? "saved" : "read";
    if (Status s = waitFor(tryLock, dir, dir, what, waitSeconds); !s) return s.error();
    return lock;
}

Result<fs::path> currentFile(const fs::path& dir, const std::string& relative) {
    const Result<fs::path> plain = resolveInside(dir, relative);
    if (!plain || !isOwnFolder(dir / kSaveFolder)) return plain;
    const Result<fs::path> saved = resolveInside(dir, std::string(kSaveFolder) + "/" + relative);
    std::error_code ignored;
    return saved && fs::exists(*saved, ignored) ? saved : plain;
}

std::optional<HeadSwitch> pendingSwitch(const fs::path& dir, const std::string& relative) {
    if (!isOwnFolder(dir / kSaveFolder)) return {};
    const Result<fs::path> saved =
        resolveInside(dir, std::string(kSaveFolder) + "/" + relative + std::string(kSwitchEnding));
    std::error_code ignored;
    if (!saved || !fs::exists(*saved, ignored)) return {};
    const Result<HeadSwitch> to = readSwitch(*saved);
    return to ? std::optional(*to) : std::nullopt;
}

Status commitSave(const fs::path& dir, const std::vector<SaveFile>& files, const std::vector<std::string>& removed,
                  double waitSeconds) {
    const fs::path temp = dir / kSaveTempFolder;
    std::error_code fault;
    fs::remove_all(temp, fault);
    if (fault) return fileError("cannot be removed", temp, fault.value());
    std::vector<FileGrowth> grown;
    Status done = writeFiles(dir, files, removed, grown);
    if (done) done = makeCurrent(dir, waitSeconds);
    if (done) return done;
    fs::remove_all(temp, fault);
    if (!isOwnFolder(dir / kSaveFolder))  // else the commit was made, though the file system told otherwise
        for (FileGrowth& g : grown) g.undo();
    return done;
}

Status finishSave(const fs::path& dir, double waitSeconds) {
    if (!isOwnFolder(dir / kSaveFolder)) return {};
    const Result<FileLock> lock = lockFolder(dir, LockKind::Exclusive, waitSeconds);
    return lock ? moveAll(dir) : Status(lock.error());
}

}  // namespace sward
