// How a project's folder changes in one instant. New files are written to `.sward-save.tmp/` and flushed; renaming
// that folder to `.sward-save/` is the commit; then its files are moved into place and it is removed.
// Who finds a `.sward-save/` reads through it, and finishes the moves where it may write. A `.sward-save.tmp/` is what
// a save left behind that never came to be: the next save removes it.
// Does not: know what the files are.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/error.h"

namespace sward {

inline constexpr const char* kSaveFolder = ".sward-save";
inline constexpr const char* kSaveTempFolder = ".sward-save.tmp";

// Keeps others from saving (or, exclusive, from loading) the folder until it goes. Waits two seconds at most, then and
// where the file system has no locks goes on without: readers then rely on the commit being one rename.
class FolderLock {
  public:
    enum class Kind { Shared, Exclusive };
    FolderLock(const std::filesystem::path& dir, Kind kind);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

  private:
    int fd_ = -1;
};

// Where the current version of a file lies: in a save that is not yet moved, or in its place.
// Unsound error if `relative` leaves the folder (core/file.h, resolveInside).
Result<std::filesystem::path> currentFile(const std::filesystem::path& dir, const std::string& relative);

// A file to save: its path in the folder, and what writes it to a given place.
struct SaveFile {
    std::string path;
    std::function<Status(const std::filesystem::path&)> write;
};
// Writes all files, or none. `removed`: files to delete after the commit. The caller holds the exclusive lock and has
// called finishSave. On failure the folder is as it was.
Status commitSave(const std::filesystem::path& dir, const std::vector<SaveFile>& files,
                  const std::vector<std::string>& removed);

// Moves a committed save into place; nothing to do is no error.
Status finishSave(const std::filesystem::path& dir);

}  // namespace sward
