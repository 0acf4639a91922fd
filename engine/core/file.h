// Files: reading with a limit, writing so that a kill or a full disk leaves the old file, and the user's folders.
// Does not: know what is in a file.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/error.h"

namespace sward {

// Unsound error that says what it is, if the path leads to anything but a file of bytes or to nothing: a folder, a
// FIFO, a socket, a device. Opens nothing.
Status checkRegular(const std::filesystem::path& file);
// Unsound error that names both, if there are more bytes than the limit.
Status checkLength(uint64_t bytes, uint64_t limit);
// The whole file. Unsound error if it cannot be read, is no regular file, or has more than `limit` bytes
// (nothing is read then).
Result<std::string> readFile(const std::filesystem::path& file, uint64_t limit);

// Tells a file from one that took its place: a save makes a new one, or a large one longer. All zero if there is none.
struct FileStamp {
    uint64_t number = 0, bytes = 0;  // of the file in its file system; its length
    int64_t changedNs = 0;           // when its bytes last changed
    bool operator==(const FileStamp&) const = default;
};
// Of the file as it is on disk now.
FileStamp stampOf(const std::filesystem::path& file);

// Writes beside the file, flushes to the disk, renames over it, and flushes the folder: at any instant the file is
// as before or as after. On failure the old file stays and nothing is left beside it.
Status writeFileAtomic(const std::filesystem::path& file, std::string_view bytes);
// Creates or overwrites in place and flushes to the disk; for files that nobody reads yet.
Status writeFileSynced(const std::filesystem::path& file, std::string_view bytes);
// Flushes a file's bytes, or a folder's entries, to the disk.
Status syncPath(const std::filesystem::path& path);
// A name in the same folder for the file while it is being written; ends in ".part". Unique to this process and call.
std::filesystem::path partPath(const std::filesystem::path& file);
// The folder that the file is to be in, with those above it; nothing to do if it is there.
Status makeFolderOf(const std::filesystem::path& file);
// "Verb FILE: reason" from errno-like codes, with a remedy for a full disk and for missing permissions.
Error fileError(const std::string& verb, const std::filesystem::path& file, int errorNumber);

// $XDG_CACHE_HOME/sward, else $HOME/.cache/sward; without a home a folder of the user's own under the temporary
// folder. An XDG path that is not absolute is ignored, as its specification demands. Not created.
std::filesystem::path cacheDir();
// $XDG_STATE_HOME/sward, else $HOME/.local/state/sward; fallback as cacheDir.
std::filesystem::path stateDir();

// Whether a path stays inside whatever folder it is taken to, by its name alone: unsound error if it is empty, absolute
// or contains "..". No file is looked at.
Status checkInside(const std::string& relative);
// `relative` as a path inside `root`. Unsound error if it is empty, absolute, contains "..", or leads out of the
// root over a symbolic link. Need not exist.
Result<std::filesystem::path> resolveInside(const std::filesystem::path& root, const std::string& relative);

}  // namespace sward
