#include "core/save_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <set>
#include <thread>

#include "core/file.h"
#include "core/log.h"

namespace fs = std::filesystem;

namespace sward {
namespace {

// In the save folder: the files to delete after the moves, one path a line.
constexpr const char* kRemovedList = ".removed";
constexpr uint64_t kMaxRemovedList = 1 << 20;

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

Status moveIntoPlace(const fs::path& dir, const std::string& file, std::set<fs::path>& touched) {
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

Status writeFiles(const fs::path& temp, const std::vector<SaveFile>& files, const std::vector<std::string>& removed) {
    std::set<fs::path> folders{temp};
    std::error_code fault;
    fs::create_directory(temp, fault);
    if (fault) return fileError("cannot be saved to", temp.parent_path(), fault.value());
    for (const SaveFile& file : files) {
        const fs::path place = temp / file.path;
        fs::create_directories(place.parent_path(), fault);
        if (fault) return fileError("cannot be made", place.parent_path(), fault.value());
        for (fs::path folder = place.parent_path(); folder != temp; folder = folder.parent_path())
            folders.insert(folder);
        if (Status s = file.write(place); !s) return s;
    }
    std::string list;
    for (const std::string& path : removed) list += path + "\n";
    if (!list.empty())
        if (Status s = writeFileSynced(temp / kRemovedList, list); !s) return s;
    for (const fs::path& folder : folders)
        if (Status s = syncPath(folder); !s) return s;
    return {};
}

}  // namespace

FolderLock::FolderLock(const fs::path& dir, Kind kind) : fd_(::open(dir.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (fd_ < 0) return;
    const int operation = (kind == Kind::Shared ? LOCK_SH : LOCK_EX) | LOCK_NB;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(2);
    while (::flock(fd_, operation) != 0 && (errno == EWOULDBLOCK || errno == EINTR) &&
           std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
}
FolderLock::~FolderLock() {
    if (fd_ >= 0) ::close(fd_);
}

Result<fs::path> currentFile(const fs::path& dir, const std::string& relative) {
    const Result<fs::path> plain = resolveInside(dir, relative);
    if (!plain || !isOwnFolder(dir / kSaveFolder)) return plain;
    const Result<fs::path> saved = resolveInside(dir, std::string(kSaveFolder) + "/" + relative);
    std::error_code ignored;
    return saved && fs::exists(*saved, ignored) ? saved : plain;
}

Status commitSave(const fs::path& dir, const std::vector<SaveFile>& files, const std::vector<std::string>& removed) {
    const fs::path temp = dir / kSaveTempFolder;
    std::error_code fault;
    fs::remove_all(temp, fault);
    if (fault) return fileError("cannot be removed", temp, fault.value());
    Status done = writeFiles(temp, files, removed);
    if (done) {
        fs::rename(temp, dir / kSaveFolder, fault);
        if (fault) done = fileError("cannot be saved to", dir, fault.value());
    }
    if (!done) {
        fs::remove_all(temp, fault);
        return done;
    }
    // From here on the new state is what every reader sees.
    Status moved = syncPath(dir);
    if (moved) moved = finishSave(dir);
    if (!moved) logWarning(moved.error().text() + "; saved, and the next save or load moves the files into place");
    return {};
}

Status finishSave(const fs::path& dir) {
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

}  // namespace sward
