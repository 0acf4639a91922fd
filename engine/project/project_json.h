// project.json to and from components, by their field tables. For project_load.cpp and project_save.cpp.
// Does not: read or write any file, nor maps' texels: a MapField read here has its file but no map yet.
#pragma once
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/json.h"
#include "project/project_files.h"
#include "scene/project.h"

namespace sward {

inline constexpr size_t kMaxListElements = 1024;  // longer lists in a project file are refused

// Turns the tree of a project of format n into one of n + 1.
using Upgrade = Status (*)(Json& project);
// The steps from format 1 to today's; today's format is one more than their number.
std::span<const Upgrade> projectUpgrades();
inline constexpr int kProjectFormat = 2;
// Checks "format" (absent: 1) and brings the tree up to 1 + steps.size(). Unsound error if it is newer or no format.
Status upgradeProject(Json& project, const std::string& file, std::span<const Upgrade> steps);

// Reads all that a project file holds, and goes on after a fault: each becomes one entry in refused or repaired.
struct ProjectReader {
    std::span<const ComponentRow> rows;
    std::string file;    // named in messages
    bool repair = true;  // false: takes values as they are, to compare files
    Project project;
    std::vector<Error> refused;  // in the file's order of keys
    std::vector<Fault> repaired;

    // Fills project, refused and repaired from the file's tree; to be called once.
    void read(const Json& root);
};

// The whole tree. `files` gives the file of each map field by the field's address, where it is not the field's own.
Json projectJson(const Project& p, std::span<const ComponentRow> rows,
                 const std::map<const void*, std::string>& files = {});
// What load or check would refuse of a project, asked of the reader itself before anything is written: its text (bytes,
// UTF-8, depth), lists and paths, and, unless it is a `copy` of unsaved work, what a scene may hold
// (scene/field_limits.h). Failed error, naming project.json, the field, what it has and what it may have. Reads `text`
// (writeJson of `tree`) as load does: 60 ns a byte.
Status checkReadable(const Project& p, std::span<const ComponentRow> rows, const Json& tree, const std::string& text,
                     bool copy);
// An image or object that a field names, as load wants it: Unsound error as readMesh and checkImage give it.
Status checkNamedFile(const std::filesystem::path& dir, const FieldRow& row, const std::string& name);
// The first value that the tables do not allow (out of range, not finite), or nothing.
Status checkValues(const Project& p, std::span<const ComponentRow> rows);

// A project as it was read, with the tree that it was read from, whose lines messages name.
struct SceneToCheck {
    const Project& project;
    std::span<const ComponentRow> rows;
    const Json& root;
};
// Adds to the faults of reading those of the scene as a whole. Reads every texel of the density maps of a unique
// population.
void checkScene(const SceneToCheck& scene, CheckReport& report);

}  // namespace sward
