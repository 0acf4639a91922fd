// A project on disk: a folder with project.json and maps/, as the README's "Projects on disk" says.
// What load does not know (components, fields) it keeps and saves. Does not: know any component but by its field table.
#pragma once
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/save_folder.h"
#include "scene/project.h"

namespace sward {

class JobControl;

// A fault that load repaired or that check found. Refusals are Errors.
struct Fault {
    std::string where;    // "file:line", or PATH and texel
    std::string message;  // what was wrong, and what was done about it
};

struct LoadReport {
    std::vector<Fault> repaired;  // every one is also logged as a warning
};

// Reads the whole project: refuses (ExitCode::Unsound, with file and line, or map and texel) or repairs and reports.
Result<Project> loadProject(const std::filesystem::path& dir, std::span<const ComponentRow> rows,
                            LoadReport* report = nullptr);
// The same for who wants to know how far it is, and may end it early with an error.
Result<Project> loadProject(const std::filesystem::path& dir, std::span<const ComponentRow> rows, JobControl& control);
// Loads everything and goes on after a refusal where it can: all faults, refusals first.
struct CheckReport {
    std::vector<Error> refused;
    std::vector<Fault> repaired;
    std::vector<Fault> noticed;  // allowed, but surely not meant
};
// Reads as loadProject does; changes no file.
CheckReport checkProject(const std::filesystem::path& dir, std::span<const ComponentRow> rows);
// How to save.
struct SaveWay {
    double waitSeconds = kLockWaitSeconds;  // for another that saves or reads the project
    bool copy = false;  // of unsaved work: may break what only `check` refuses, and name files that cannot be read
    std::map<std::string, FileStamp>* stamps = nullptr;  // gets Project::stamps as saving leaves them
};
// Saves atomically to p.dir: new files, fsync, one rename (save_folder.h). Maps whose texels equal those of `saved`
// are not rewritten while their files are still those that `saved` knows (Project::stamps), nor those whose texels
// equal the file's; nothing at all is written if nothing changed. Returns the files written, relative to the folder,
// sorted. If `saved` lies in another folder ("save as"), image files that p names are copied from there. Fields that
// share a file but no longer their texels get files of their own. Maps that the folder's project.json named and p does
// not are deleted after the commit. Afterwards the folder holds p, whoever else saved there since p was loaded; that is
// said. Fails, with the old project on disk unchanged: disk full, read-only folder, another that does not get done
// saving, a value out of its range, and whatever load or check would refuse of what would be written (checkReadable) or
// of images and objects that are named anew; one that is not there is only warned of.
Result<std::vector<std::string>> saveProject(const Project& p, std::span<const ComponentRow> rows,
                                             const Project* saved = nullptr, const SaveWay& way = {});
// The same for who wants to know how far it is, and may cancel it until all files are written beside the old ones.
Result<std::vector<std::string>> saveProject(const Project& p, std::span<const ComponentRow> rows, const Project* saved,
                                             const SaveWay& way, JobControl* control);
// Of project.json and the map files that p was loaded from or saved to: those that another program changed since, as
// they are now; not those that are gone, which a save brings back.
std::map<std::string, FileStamp> changedOutside(const Project& p);
// A minimal project, saved to dir: one terrain, one field with a density map to paint on, sun, sky, haze, a camera.
// Fails if dir exists and is not empty; leaves nothing behind then.
Result<Project> newProject(const std::filesystem::path& dir, std::span<const ComponentRow> rows);

// Names all that a project is: its fields, its maps' texels, its files' bytes; not its folder. Reads every texel.
uint64_t projectHash(const Project& p, std::span<const ComponentRow> rows);

}  // namespace sward
