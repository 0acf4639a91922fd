// A project: a folder with project.json and maps/, and in memory a registry of named entities.
// Does not: draw, undo, or touch the window.
// On disk as the README's "Projects on disk" says. What load does not know (components, fields) it keeps and saves.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/error.h"
#include "ecs/registry.h"
#include "scene/components.h"
#include "scene/rows.h"

namespace sward {

struct Project {
    std::string name;
    std::filesystem::path dir;             // empty: never saved
    Registry registry;
    std::map<std::string, Entity> entities;  // by Name; sorted
    std::map<std::string, std::string> unknown;  // JSON text of what load did not know, by path "entity.Component.field"
};

// A fault that load repaired or that check found. Refusals are Errors.
struct Fault {
    std::string where;    // "file:line", or PATH and texel
    std::string message;  // what was wrong, and what was done about it
};

struct LoadReport {
    std::vector<Fault> repaired;  // every one is also logged as a warning
};

// --- entities ------------------------------------------------------------------------------------------------
// A new entity; fails if the name is taken or is not of [A-Za-z0-9_-]+.
Result<Entity> addEntity(Project& p, const std::string& name);
bool removeEntity(Project& p, const std::string& name);
Entity findEntity(const Project& p, const std::string& name);  // kNoEntity if none
// A copy whose maps share tiles with p's: for playtest, background jobs and saving beside.
Project snapshot(const Project& p, std::span<const ComponentRow> rows);

// --- fields by PATH ("ground.Terrain.size", "lawn.GrassField.species[lawn].height", "species[0]") -----------
struct FieldRef {
    void* value = nullptr;      // the field itself
    const FieldRow* row = nullptr;
    const ComponentRow* component = nullptr;
    std::string entity;
    std::string path;           // canonical: list elements by name
};
// Usage error if the path names nothing; the message lists what would have fitted.
Result<FieldRef> findField(Project& p, std::span<const ComponentRow> rows, const std::string& path);
// Any unambiguous tail of a map's PATH ("density"); Usage error naming the candidates otherwise.
Result<FieldRef> findMap(Project& p, std::span<const ComponentRow> rows, const std::string& name);
// All map fields with their canonical paths, sorted; absent ones included if asked.
std::vector<FieldRef> allMaps(Project& p, std::span<const ComponentRow> rows, bool absentToo = false);
// As text: numbers in shortest form, vectors and colours as "[1, 2]", bool, enum by name, strings plain.
std::string fieldText(const FieldRef& f);
// Parses and range-checks against the hard range (Usage error naming the range, old value kept).
Status setFieldText(const FieldRef& f, const std::string& text);
// Pulls a component's cross-field rules in order (swapped or equal tier distances); says what it changed.
std::vector<std::string> repairComponent(const ComponentRow& row, void* component);

// --- files ---------------------------------------------------------------------------------------------------
// Reads the whole project: refuses (ExitCode::Unsound, with file and line, or map and texel) or repairs and reports.
Result<Project> loadProject(const std::filesystem::path& dir, std::span<const ComponentRow> rows, LoadReport* report = nullptr);
// Loads everything and goes on after a refusal where it can: all faults, refusals first.
struct CheckReport {
    std::vector<Error> refused;
    std::vector<Fault> repaired;
};
CheckReport checkProject(const std::filesystem::path& dir, std::span<const ComponentRow> rows);
// Saves atomically to p.dir: new files, fsync, one rename. Maps whose texels equal those of `saved` (or of the file)
// are not rewritten. Returns the files written, relative to the folder.
Result<std::vector<std::string>> saveProject(const Project& p, std::span<const ComponentRow> rows, const Project* saved = nullptr);
// A minimal project: one terrain, one field, a sun with its sky, a camera. Fails if dir exists and is not empty.
Result<Project> newProject(const std::filesystem::path& dir);

}  // namespace sward
