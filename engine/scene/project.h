// A project in memory: a registry of named entities. On disk: project/project_files.h.
// Does not: draw, undo, read or write files.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/file.h"
#include "ecs/registry.h"
#include "scene/components.h"
#include "scene/rows.h"

namespace sward {

// How a map came in: what importMap was told, kept as "imports" in project.json, so that the next import and export
// of the same map need not be told again.
struct MapImport {
    std::string file;  // the name of the file, without its folder
    bool flip = false;
    std::optional<std::pair<double, double>> range;
    bool operator==(const MapImport&) const = default;
};

struct Project {
    std::string name;
    std::filesystem::path dir;  // empty: never saved
    Registry registry;
    std::map<std::string, Entity> entities;  // by Name; sorted
    // JSON text of what load did not know, by path "entity.Component.field" ("." in front of what is no entity's).
    // '%', '.', '[' and ']' within a name are written %25, %2e, %5b, %5d.
    std::map<std::string, std::string> unknown;
    std::map<std::string, MapImport> imports;  // by the map's PATH
    std::set<std::string> repairedMaps;        // files whose texels load repaired; saving writes them
    std::map<std::string, FileStamp> stamps;   // of project.json and map files, as load found or saving left them
};

// The component of a kind that the first entity by name holds; null if none does.
template <class C>
const C* firstOf(const Project& p) {
    for (const auto& [name, e] : p.entities)
        if (const C* c = p.registry.get<C>(e)) return c;
    return nullptr;
}

// The name of the entity that holds this component of the project; empty if none does. Looks through them all.
template <class C>
std::string entityOf(const Project& p, const C& component) {
    for (const auto& [name, e] : p.entities)
        if (p.registry.get<C>(e) == &component) return name;
    return {};
}

// The population of all fields: sum over species of bladesPerM2 * mean density * area of the terrain (the first by
// name; none: 0). Reads every texel of the density maps: about 5 ms for 4096 x 4096.
double virtualBlades(const Project& p);
// virtualBlades, counted anew only when what it is a product of has changed.
class PopulationCount {
  public:
    double of(const Project& p);

  private:
    std::vector<Map> densities_;
    std::vector<double> factors_;
    double count_ = 0;
};

// --- entities ------------------------------------------------------------------------------------------------
// A new entity; fails if the name is taken or is not of [A-Za-z0-9_-]+.
Result<Entity> addEntity(Project& p, const std::string& name);
bool removeEntity(Project& p, const std::string& name);
Entity findEntity(const Project& p, const std::string& name);  // kNoEntity if none
// A copy whose maps share tiles with p's: for playtest, background jobs and saving beside.
Project snapshot(const Project& p, std::span<const ComponentRow> rows);

// --- fields by PATH ("ground.Terrain.size", "lawn.GrassField.species[lawn].height", "species[0]") -----------
template <class Void>
struct BasicFieldRef {
    Void* value = nullptr;  // the field itself
    const FieldRow* row = nullptr;
    const ComponentRow* component = nullptr;
    std::string entity;
    std::string path;  // canonical: list elements by name
    // What may be changed may be read.
    operator BasicFieldRef<const void>() const requires(!std::is_const_v<Void>) {
        return {value, row, component, entity, path};
    }
};
using FieldRef = BasicFieldRef<void>;             // of a project that is changed
using ConstFieldRef = BasicFieldRef<const void>;  // of one that is read
// Usage error if the path names nothing; the message lists what would have fitted. List elements go by name, or by
// number from 0 where no element has that name; canonical paths take the number where names are empty or repeat.
Result<FieldRef> findField(Project& p, std::span<const ComponentRow> rows, const std::string& path);
Result<ConstFieldRef> findField(const Project& p, std::span<const ComponentRow> rows, const std::string& path);
// The number of the element of a list field that a name or number selects. Usage error listing the elements.
Result<size_t> findElement(const ConstFieldRef& list, const std::string& selector);
// Any unambiguous tail of a map's PATH ("density"), among those present first, then among the absent;
// Usage error naming the candidates otherwise.
Result<FieldRef> findMap(Project& p, std::span<const ComponentRow> rows, const std::string& name);
Result<ConstFieldRef> findMap(const Project& p, std::span<const ComponentRow> rows, const std::string& name);
// All map fields with their canonical paths, sorted; absent ones included if asked.
std::vector<FieldRef> allMaps(Project& p, std::span<const ComponentRow> rows, bool absentToo = false);
std::vector<ConstFieldRef> allMaps(const Project& p, std::span<const ComponentRow> rows, bool absentToo = false);
// All fields that name a file (FieldRow::isFile: images and objects) and are not empty.
std::vector<ConstFieldRef> allFiles(const Project& p, std::span<const ComponentRow> rows);
// Where texels of a map are saved that has no file yet or whose file's format cannot hold them:
// "maps/entity.species.map.ext", ext png, exr for F32, or tif where they are kept in tiles (maps/tile_file.h); a large
// PNG stays one. Keeps the folder and stem of the file it has.
std::string mapFileFor(const ConstFieldRef& map, const MapInfo& texels);
// As text: numbers in shortest form, vectors and colours as "[1, 2]", bool, enum by name, strings plain.
std::string fieldText(const ConstFieldRef& f);
// Parses and range-checks against the hard range (Usage error naming the range, old value kept). Lists cannot be set;
// a map only to "" (none): texels come by importMap.
Status setFieldText(const FieldRef& f, const std::string& text);
// Pulls a component's cross-field rules in order (swapped or equal tier distances); says what it changed.
std::vector<std::string> repairComponent(const ComponentRow& row, void* component);

}  // namespace sward
