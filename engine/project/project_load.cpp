#include <atomic>

#include "core/file.h"
#include "core/jobs.h"
#include "core/log.h"
#include "core/save_folder.h"
#include "core/utf8.h"
#include "maps/map_io.h"
#include "maps/tile_file.h"
#include "mesh/mesh_io.h"
#include "project/project_files.h"
#include "project/project_json.h"
#include "scene/map_fields.h"
#include "scene/map_layers.h"

namespace fs = std::filesystem;

namespace sward {
namespace {

// A map file to read, once for all the fields that want the same of it.
struct MapLoad {
    std::string file;  // relative
    MapWish wish;
    std::vector<FieldRef> fields;
    Result<Map> map = Map();
    std::vector<std::string> repaired;
    FileStamp stamp = {};
};

struct Loading {
    fs::path dir;
    ProjectReader reader;
    Json root;
    bool soundJson = false;
    JobControl* control = nullptr;

    bool cancelled() const { return control && control->cancelled(); }
};

// The folder may also be named by its project.json.
fs::path projectFolder(const fs::path& given) {
    std::error_code ignored;
    if (given.filename() == "project.json" && fs::is_regular_file(given, ignored))
        return given.has_parent_path() ? given.parent_path() : ".";
    return given;
}

void readProjectJson(Loading& l) {
    const auto refuse = [&](Error e) { l.reader.refused.push_back(std::move(e)); };
    std::error_code ignored;
    if (!fs::is_directory(l.dir, ignored))
        return refuse(unsound("is no folder with a project", "check the path, or make one with `sward new`").at(l.dir));
    const Result<fs::path> file = currentFile(l.dir, "project.json");
    if (!file) return refuse(file.error());
    l.reader.file = (l.dir / "project.json").string();
    l.reader.project.stamps["project.json"] = stampOf(*file);
    const Result<std::string> text = readFile(*file, kMaxJsonBytes);
    if (!text) {
        Error e = text.error();
        e.file = l.reader.file;
        return refuse(std::move(e));
    }
    Result<Json> json = parseJson(*text, l.reader.file);
    if (!json) return refuse(json.error());
    if (Status s = upgradeProject(*json, l.reader.file, projectUpgrades()); !s) return refuse(s.error());
    l.soundJson = true;
    l.reader.read(*json);
    l.root = std::move(*json);
    if (l.reader.project.name.empty())
        l.reader.project.name = utf8Text(fs::absolute(l.dir, ignored).filename().string());
}

bool sameWish(const MapWish& a, const MapWish& b) { return a.channels == b.channels && a.isHeight == b.isHeight; }

std::vector<MapLoad> mapsToLoad(Loading& l) {
    std::vector<MapLoad> loads;
    for (const FieldRef& f : allMaps(l.reader.project, l.reader.rows, true)) {
        const std::string& file = static_cast<const MapField*>(f.value)->file;
        if (file.empty()) continue;
        MapLoad load;
        load.file = file;
        load.wish = mapWish(*f.row);
        const auto same = std::find_if(loads.begin(), loads.end(),
                                       [&](const MapLoad& o) { return o.file == file && sameWish(o.wish, load.wish); });
        MapLoad& target = same == loads.end() ? loads.emplace_back(std::move(load)) : *same;
        target.fields.push_back(f);
    }
    return loads;
}

void readOne(const Loading& l, MapLoad& load) {
    if (fs::path(load.file).extension() ==
        ".r16") {  // its size stands in another file, and the two cannot change in one instant
        load.map = unsound("a project's maps are PNG, EXR or TIFF", "import the R16 file into the map");
        return;
    }
    const Result<fs::path> file = currentFile(l.dir, load.file);
    if (file) load.stamp = stampOf(*file);
    load.wish.mayStay = true;
    if (const auto grown = pendingSwitch(l.dir, load.file)) load.wish.directory = grown->after;
    load.map = file ? readMap(*file, load.wish, &load.repaired) : Result<Map>(file.error());
}

// Whether the project can do without a file that is not there.
bool isSpared(const Loading& l, const MapLoad& load) {
    std::error_code ignored;
    const Result<fs::path> file = currentFile(l.dir, load.file);
    return std::all_of(load.fields.begin(), load.fields.end(), mayBeMissing) && file && !fs::exists(*file, ignored);
}

// Hands the texels out, or says what is wrong, naming the map and its file's place in the project.
void takeOne(Loading& l, MapLoad& load) {
    const std::string path = load.fields[0].path;
    if (!load.map && isSpared(l, load)) {
        l.reader.repaired.push_back(
            {(l.dir / load.file).string(), path + ": the file is not there; the layer does nothing until it is back"});
        return;
    }
    if (!load.map) {
        Error e = load.map.error();
        e.message = path + ": " + e.message;
        if (e.file.empty() || fs::path(e.file).extension() != ".json") e.file = (l.dir / load.file).string();
        l.reader.refused.push_back(std::move(e));
        return;
    }
    for (const FieldRef& f : load.fields) static_cast<MapField*>(f.value)->map = *load.map;
    for (const std::string& said : load.repaired)
        l.reader.repaired.push_back({(l.dir / load.file).string(), path + ": " + said});
    l.reader.project.stamps[load.file] = load.stamp;
    if (!load.repaired.empty()) l.reader.project.repairedMaps.insert(load.file);
}

void loadMaps(Loading& l) {
    std::vector<MapLoad> loads = mapsToLoad(l);
    std::atomic<size_t> done = 0;
    parallelFor(loads.size(), [&](size_t i) {
        if (!l.cancelled()) readOne(l, loads[i]);
        if (l.control) l.control->setProgress(static_cast<double>(++done) / static_cast<double>(loads.size() + 1));
    });
    if (l.cancelled()) return;  // said by loadProject
    for (MapLoad& load : loads) takeOne(l, load);
    for (const FieldRef& f :
         allMaps(l.reader.project, l.reader.rows, true)) {  // a field is empty exactly when its file is
        auto& field = *static_cast<MapField*>(f.value);
        if (!field.present() && !mayBeMissing(f)) field.file.clear();
    }
}

// The renderer reads the images and objects that fields name; what it could not read is refused here, once a file.
void checkFiles(Loading& l) {
    std::set<std::string> seen;
    for (const ConstFieldRef& f : allFiles(l.reader.project, l.reader.rows)) {
        const std::string& name = *static_cast<const std::string*>(f.value);
        if (!seen.insert((f.row->isMesh ? "m:" : "i:") + name).second || l.cancelled()) continue;
        const Status s = checkNamedFile(l.dir, *f.row, name);
        if (s) continue;
        Error e = s.error();
        e.message = f.path + ": " + e.message;
        if (e.line == 0) e.file = (l.dir / name).string();
        l.reader.refused.push_back(std::move(e));
    }
}

// Large maps are opened, not read; here they are, once a file.
void checkTexels(Loading& l) {
    std::set<std::string> seen;
    for (const ConstFieldRef& f : allMaps(std::as_const(l.reader.project), l.reader.rows)) {
        const auto& field = *static_cast<const MapField*>(f.value);
        if (!seen.insert(field.file).second) continue;
        const Status s = checkTiles(field.map);
        if (s) continue;
        Error e = s.error();
        e.message = f.path + ": " + e.message;
        l.reader.refused.push_back(std::move(e));
    }
}

// `everything`: goes on to the maps when project.json has faults.
Loading load(const fs::path& given, std::span<const ComponentRow> rows, bool everything,
             JobControl* control = nullptr) {
    Loading l;
    l.control = control;
    l.dir = projectFolder(given);
    l.reader.rows = rows;
    if (Status s = finishSave(l.dir, 0); !s) logInfo(s.error().text() + "; read as it is");
    const Result<FileLock> lock = lockFolder(l.dir, LockKind::Shared);
    if (!lock) {
        l.reader.refused.push_back(lock.error());
        return l;
    }
    readProjectJson(l);
    l.reader.project.dir = l.dir;
    if (!l.reader.refused.empty() && !(everything && l.soundJson)) return l;
    loadMaps(l);
    checkFiles(l);
    return l;
}

}  // namespace

Status checkNamedFile(const fs::path& dir, const FieldRow& row, const std::string& name) {
    if (row.isMesh) {
        const Result<Mesh> mesh = readMesh(dir, name);
        return mesh ? Status() : Status(mesh.error());
    }
    const Result<fs::path> file = currentFile(dir, name);
    return file ? checkImage(*file) : Status(file.error());
}

namespace {
Result<Project> projectOf(Loading l, LoadReport* report) {
    if (l.cancelled()) return failed("reading was cancelled").at(l.dir);
    if (!l.reader.refused.empty()) return l.reader.refused.front();
    for (const Fault& f : l.reader.repaired) logWarning(f.where + ": " + f.message);
    if (report) report->repaired = std::move(l.reader.repaired);
    return std::move(l.reader.project);
}
}  // namespace

Result<Project> loadProject(const fs::path& dir, std::span<const ComponentRow> rows, LoadReport* report) {
    return projectOf(load(dir, rows, false), report);
}
Result<Project> loadProject(const fs::path& dir, std::span<const ComponentRow> rows, JobControl& control) {
    return projectOf(load(dir, rows, false, &control), nullptr);
}

CheckReport checkProject(const fs::path& dir, std::span<const ComponentRow> rows) {
    Loading l = load(dir, rows, true);
    checkTexels(l);
    CheckReport report{std::move(l.reader.refused), std::move(l.reader.repaired), {}};
    if (l.soundJson) checkScene({l.reader.project, rows, l.root}, report);
    return report;
}

}  // namespace sward
