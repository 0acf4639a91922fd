// Numbered copies of unsaved work, whole projects in $XDG_STATE_HOME/sward/autosave/NAME-HASH/NNNN, outside the
// project. Who makes them holds a lock in their folder while it lives (core/file_lock.h); another that edits the same
// project takes NAME-HASH-2, and so on. They go once the work is saved or given up by its owner; those whose lock
// nobody holds any more are offered on the next start, whatever ended their program. Does not: touch the project's
// folder, nor copy while a stroke or a drag is on. Cost: the copy is made in the background from a snapshot that shares
// its maps' tiles.
#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "core/error.h"
#include "core/file_lock.h"
#include "core/jobs.h"
#include "scene/project.h"

namespace sward {

inline constexpr double kAutosaveSeconds = 60;  // of unsaved work; longer where copies take long:
inline constexpr double kAutosaveShare = 0.1;   // of the time at most, for making copies
inline constexpr size_t kAutosavesKept = 3;     // of a folder, the newest
inline constexpr int kAutosaveFolders = 16;     // of a project: editors that run at once, and work not yet taken back

// Where the copies of a project lie that is in `dir`: its first folder, for its first editor.
std::filesystem::path autosaveFolder(const std::filesystem::path& dir, int number = 1);
// The complete copies in all its folders, newest first; none of those that another makes who lives.
std::vector<std::filesystem::path> autosavesOf(const std::filesystem::path& dir);
// A folder for copies of one's own, with its lock: one without copies that are still to be offered. Nothing if all are
// taken. Where the state folder has no locks, none is held.
struct AutosavePlace {
    std::filesystem::path folder;
    FileLock lock;
};
std::optional<AutosavePlace> takeAutosavePlace(const std::filesystem::path& dir);
// Writes the next copy to a folder and drops what is older than the newest few. Returns its folder. On failure the
// others stay.
Result<std::filesystem::path> writeAutosave(const Project& p, std::span<const ComponentRow> rows,
                                            const std::filesystem::path& folder);
// All copies of a project go that nobody makes now.
void forgetAutosaves(const std::filesystem::path& dir);

class Document;
struct Autosave {
    bool on = false;           // a person's editor; not tests and scripts
    std::filesystem::path of;  // folder of the project that the rest is about
    double since = 0;          // seconds: since when there is work that no copy holds
    uint64_t revision = 0;     // of the last copy
    AutosavePlace mine;        // of the copies of what is being edited now; its lock is held while there may be some
    Job<std::filesystem::path> job;
    double began = 0;                          // seconds: when it was
    double wait = kAutosaveSeconds;            // seconds of unsaved work until the next copy
    std::vector<std::filesystem::path> found;  // another run's, offered; empty: no question is open
    bool opening = false;
};
// The offered copy was taken over: its folder is one's own from now on, and goes once the work is saved or given up.
void adoptAutosave(Autosave& autosave, const std::filesystem::path& copy);
// Now and then, with the time in seconds: begins a copy when one is due, and looks for another run's when a project was
// opened. `held`: a drag is on, so that nothing is copied now. True if a question is to be asked now.
bool tickAutosave(Autosave& autosave, Document& document, bool held, double now);
// The person left the program in order: waits for a copy under way; nothing is to be offered next time.
void endAutosave(Autosave& autosave);

}  // namespace sward
