// How a project's folder changes in one instant. New files are written to `.sward-save.tmp/` and flushed; renaming
// that folder to `.sward-save/` is the commit; then its files are moved into place and it is removed.
// A large file may instead grow at its end before the commit (core/file_growth.h); what lies in `.sward-save/` is then
// the one number that makes the new end count, and moving is to write it.
// Who finds a `.sward-save/` reads through it, and finishes the moves where it may write. A `.sward-save.tmp/` is what
// a save left behind that never came to be: the next save removes it.
// Two locks (core/file_lock.h) keep this apart. Who saves holds the one of `.sward-saving` from before it looks at the
// folder until after the moves, so that saves come one after the other. Who reads holds the folder's own, shared; who
// moves files holds it exclusively, which is short. Where a file system has no locks, all go on without: then a reader
// relies on the commit being one rename, and nothing keeps two savers apart.
// Does not: know what the files are.
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/file_growth.h"
#include "core/file_lock.h"

namespace sward {

inline constexpr const char* kSaveFolder = ".sward-save";
inline constexpr const char* kSaveTempFolder = ".sward-save.tmp";
inline constexpr const char* kSaveLockFile = ".sward-saving";
inline constexpr double kLockWaitSeconds = 30;  // for others to have done, if nothing else is said

// The right to save to a folder, while this lives.
class SaveLock {
  public:
    // Waits while another saves there, and says so after a second. Failed error, naming the folder and who saves, if
    // that takes longer.
    static Result<SaveLock> take(const std::filesystem::path& dir, double waitSeconds = kLockWaitSeconds);
    ~SaveLock();
    SaveLock(SaveLock&&) = default;
    SaveLock& operator=(SaveLock&&) = delete;

  private:
    SaveLock() = default;
    std::filesystem::path file_;
    FileLock lock_;
};
// A lock on the folder itself: to read it, shared; to move files, exclusive. Waits and fails as SaveLock::take does.
Result<FileLock> lockFolder(const std::filesystem::path& dir, LockKind kind, double waitSeconds = kLockWaitSeconds);

// Where the current version of a file lies: in a save that is not yet moved, or in its place.
// Unsound error if `relative` leaves the folder (core/file.h, resolveInside).
Result<std::filesystem::path> currentFile(const std::filesystem::path& dir, const std::string& relative);

// The number that is to make the new end of a file count, if a save that is not yet moved has made it grow.
std::optional<HeadSwitch> pendingSwitch(const std::filesystem::path& dir, const std::string& relative);

// A file to save: its path in the folder, and what writes it to a given place; or what makes the one that is there grow
// (mayGrow says whether it can).
struct SaveFile {
    std::string path;
    std::function<Status(const std::filesystem::path&)> write;
    std::function<Result<HeadSwitch>(FileGrowth&)> grow = {};
};
// Writes all files, or none. `removed`: files to delete after the commit. The caller holds the SaveLock and has called
// finishSave; those who read are waited for as lockFolder does. On failure the folder is as it was, and the error names
// the file's own place in it.
Status commitSave(const std::filesystem::path& dir, const std::vector<SaveFile>& files,
                  const std::vector<std::string>& removed, double waitSeconds = kLockWaitSeconds);

// Moves a committed save into place, once nobody reads; nothing to do is no error.
Status finishSave(const std::filesystem::path& dir, double waitSeconds = kLockWaitSeconds);

}  // namespace sward
