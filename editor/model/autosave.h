// Numbered copies of unsaved work, whole projects in $XDG_STATE_HOME/sward/autosave/NAME-HASH/NNNN, outside the
// project. They go once the work is saved or given up by its owner; those of a program that ended otherwise are offered
// on the next start. Does not: touch the project's folder, nor copy while a stroke or a drag is on. Cost: the copy is
// made in the background from a snapshot that shares its maps' tiles.
#pragma once
#include <filesystem>
#include <vector>

#include "core/jobs.h"
#include "scene/project.h"

namespace sward {

inline constexpr double kAutosaveSeconds = 300;  // of unsaved work
inline constexpr size_t kAutosavesKept = 3;      // of a project, the newest

// Where the copies of a project lie that is in `dir`.
std::filesystem::path autosaveFolder(const std::filesystem::path& dir);
// The complete copies, newest first; none while another running program makes them.
std::vector<std::filesystem::path> autosavesOf(const std::filesystem::path& dir);
// Writes the next one and drops what is older than the newest few. Returns its folder. On failure the others stay.
Result<std::filesystem::path> writeAutosave(const Project& p, std::span<const ComponentRow> rows);
// All copies of a project go.
void forgetAutosaves(const std::filesystem::path& dir);

class Document;
struct Autosave {
    bool on = false;           // a person's editor; not tests and scripts
    std::filesystem::path of;  // folder of the project that the rest is about
    double since = 0;          // seconds: since when there is work that no copy holds
    uint64_t revision = 0;     // of the last copy
    bool mine = false;         // there are copies of what is being edited now
    Job<std::filesystem::path> job;
    std::vector<std::filesystem::path> found;  // another run's, offered; empty: no question is open
    bool opening = false;
};
// Now and then, with the time in seconds: begins a copy when one is due, and looks for another run's when a project was
// opened. `held`: a drag is on, so that nothing is copied now. True if a question is to be asked now.
bool tickAutosave(Autosave& autosave, Document& document, bool held, double now);
// The person left the program in order: waits for a copy under way; nothing is to be offered next time.
void endAutosave(Autosave& autosave);

}  // namespace sward
