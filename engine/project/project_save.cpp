#include "core/file.h"
#include "core/jobs.h"
#include "core/log.h"
#include "core/save_folder.h"
#include "maps/map_io.h"
#include "maps/tile_file.h"
#include "mesh/mesh_io.h"
#include "project/project_files.h"
#include "project/project_json.h"
#include "scene/map_fields.h"

namespace fs = std::filesystem;

namespace sward {
namespace {

using Rows = std::span<const ComponentRow>;

// A map and the file that it is saved to.
struct PlannedMap {
    ConstFieldRef field;
    std::string file;
    const Map* map;
};

// Fields that share a file keep it as long as they share their texels; the others, in the order of their paths, get
// files of their own.
std::vector<PlannedMap> planMaps(const Project& p, Rows rows) {
    std::vector<PlannedMap> plan;
    std::map<std::string, const Map*> taken;
    for (const ConstFieldRef& f : allMaps(p, rows)) {
        const auto& field = *static_cast<const MapField*>(f.value);
        std::string file = mapFileFor(f, field.map.info());
        for (int n = 2; taken.contains(file) && !taken[file]->sameTiles(field.map); ++n) {
            MapField unnamed;
            ConstFieldRef fresh = f;
            fresh.value = &unnamed;
            fs::path own = mapFileFor(fresh, field.map.info());
            if (n > 2) own.replace_filename(fmt::format("{}-{}{}", own.stem().string(), n, own.extension().string()));
            file = own.generic_string();
        }
        taken.emplace(file, &field.map);
        plan.push_back({f, file, &field.map});
    }
    return plan;
}

bool equalTexels(const Map& a, const Map& b) {
    if (!(a.info() == b.info())) return false;
    for (int y = 0; y < a.tilesY(); ++y)
        for (int x = 0; x < a.tilesX(); ++x)
            if (!sameTexels(*a.tile(x, y), *b.tile(x, y))) return false;
    return true;
}

// True if the file holds these texels and reading it needs no repair.
bool fileHolds(const fs::path& file, const PlannedMap& planned) {
    std::vector<std::string> repaired;
    MapWish wish = mapWish(*planned.field.row);
    wish.mayStay = true;
    const Result<Map> map = readMap(file, wish, &repaired);
    const bool oneTexel = planned.map->info().width == 1 && planned.map->info().height == 1;
    return map && repaired.size() == (oneTexel ? 1u : 0u) && equalTexels(*map, *planned.map);
}

struct Saving {
    const Project& p;
    Rows rows;
    std::vector<PlannedMap> plan;
    std::vector<PlannedMap> savedPlan =
        {};                      // of what is known to lie on disk; what it lacks is compared with the files
    Project onDisk = Project();  // without texels
    bool readable = false;       // whether there is a sound project on disk
    bool sameForm = false;       // and nothing in it stands elsewhere in today's form
    std::map<std::string, FileStamp> known = {};  // of files on disk, when savedPlan was what they hold
    std::vector<SaveFile> files = {};
    std::vector<std::string> removed = {};
    JobControl* control = nullptr;
    size_t done = 0;  // of the maps and then of the files

    // A map was compared, or a file written; false: to be left.
    bool goOn(size_t of) {
        if (control) control->setProgress(static_cast<double>(++done) / static_cast<double>(of));
        return !control || !control->cancelled();
    }
};

Error cancelledSave(const Saving& s) {
    return failed("saving was cancelled: what is on disk is as before").at(s.p.dir);
}

FileStamp stampNow(const Project& p, const std::string& name) {
    const Result<fs::path> file = currentFile(p.dir, name);
    return file ? stampOf(*file) : FileStamp();
}

// Whether the file is the one that was loaded or saved here, and not another's since.
bool isKnown(const Saving& s, const std::string& name) {
    const auto it = s.known.find(name);
    return it != s.known.end() && it->second == stampNow(s.p, name);
}

// What its file is known to hold; null if that must be looked up in the file.
const Map* knownOnDisk(const Saving& s, const PlannedMap& planned) {
    if (s.p.repairedMaps.contains(planned.file) || !isKnown(s, planned.file)) return nullptr;
    for (const PlannedMap& before : s.savedPlan)
        if (before.file == planned.file) return before.map;
    return nullptr;
}

bool mapChanged(const Saving& s, const PlannedMap& planned) {
    const fs::path file = s.p.dir / planned.file;
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored)) return true;
    const Map* before = knownOnDisk(s, planned);
    return before ? !equalTexels(*before, *planned.map) : !fileHolds(file, planned);
}

// A large map of which little changed makes its file grow; all else is written anew.
SaveFile fileOf(Saving& s, const PlannedMap& planned) {
    const auto goOn = [&s](const Status& written) {
        return s.goOn(s.plan.size() + s.files.size()) ? written : Status(cancelledSave(s));
    };
    SaveFile out{planned.file, [goOn, map = planned.map](const fs::path& to) { return goOn(writeMap(to, *map)); }};
    const fs::path file = s.p.dir / planned.file;
    const Map* before = knownOnDisk(s, planned);
    const bool mayWait = planned.file.starts_with("maps/");  // only there an interrupted save looks for what has grown
    if (!before || !mayWait || !worthGrowing(file, *before, *planned.map)) return out;
    out.grow = [goOn, file, before, map = planned.map](FileGrowth& growth) -> Result<HeadSwitch> {
        const std::optional<PlainTiles> tiles = tilesOf(file, map->info());
        if (!tiles) return failed("was changed by another program while it was saved", "save again").at(file);
        const Result<HeadSwitch> grown = growTiles(growth, *tiles, *before, *map);
        const Status done = goOn(grown ? Status() : Status(grown.error()));
        return done ? grown : Result<HeadSwitch>(done.error());
    };
    return out;
}

Status checkMap(const PlannedMap& planned) {
    const MapInfo& info = planned.map->info();
    const MapRow& row = *planned.field.row->map;
    const auto refuse = [&](std::string what, std::string remedy) {
        return failed(planned.field.path + ": " + std::move(what), std::move(remedy)).at(planned.file);
    };
    if (info.channels != row.channels)
        return refuse(fmt::format("has {} channels, not {}", info.channels, row.channels),
                      "make a map with the right number of channels");
    if (Status fits = checkMapLimits(planned.file, info); !fits)
        return refuse(fits.error().message, fits.error().remedy);
    if (row.kind == MapKind::Heights && info.type == PixelType::U8)
        return refuse("heights of 8 bits cannot be saved", "use 16 bits or floats");
    if (const Status inside = checkInside(planned.file); !inside)
        return refuse(inside.error().message, inside.error().remedy);
    return {};
}

// Adds the maps that changed.
Status addMaps(Saving& s) {
    for (const PlannedMap& planned : s.plan) {
        if (!s.goOn(2 * s.plan.size())) return cancelledSave(s);
        if (Status ok = checkMap(planned); !ok) return ok;
        const auto same = [&](const SaveFile& f) { return f.path == planned.file; };
        if (std::any_of(s.files.begin(), s.files.end(), same) || !mapChanged(s, planned)) continue;
        if (const auto place = resolveInside(s.p.dir, planned.file); !place) return place.error();
        s.files.push_back(fileOf(s, planned));
    }
    return {};
}

// The files that a field names: one image, or an object with what it refers to.
std::vector<std::string> filesOf(const fs::path& dir, const ConstFieldRef& f) {
    const std::string& name = *static_cast<const std::string*>(f.value);
    if (f.row->isMesh)
        if (const Result<Mesh> mesh = readMesh(dir, name)) return mesh->files;
    return {name};
}

// Images and objects that a "save as" finds missing come along from the old folder.
Status addFiles(Saving& s, const fs::path& from) {
    std::set<std::string> names;
    for (const ConstFieldRef& f : allFiles(s.p, s.rows))
        for (std::string& name : filesOf(from, f)) names.insert(std::move(name));
    for (const std::string& name : names) {
        const Result<fs::path> place = resolveInside(s.p.dir, name), source = currentFile(from, name);
        if (!place) return place.error();
        if (!source) return source.error();
        std::error_code ignored;
        if (fs::exists(*place, ignored)) continue;
        s.files.push_back({name, [file = *source](const fs::path& to) -> Status {
                               const Result<std::string> bytes = readFile(file, kMaxMapBytes);
                               return bytes ? writeFileSynced(to, *bytes) : Status(bytes.error());
                           }});
    }
    return {};
}

// What lies in the folder now, as far as it can be read.
void readOnDisk(Saving& s) {
    const fs::path file = s.p.dir / "project.json";
    Result<Json> json = readJson(file);
    if (!json || !json->isObject()) return;
    Json before = *json;
    if (!upgradeProject(*json, file.string(), projectUpgrades())) return;
    before["format"] = Json(kProjectFormat);
    s.sameForm = writeJson(before) == writeJson(*json);
    ProjectReader reader;
    reader.rows = s.rows;
    reader.file = file.string();
    reader.repair = false;
    reader.read(*json);
    s.readable = reader.refused.empty();
    s.onDisk = std::move(reader.project);
}

// What load would refuse of a file is refused, unless the project on disk names it as well: then it is as it was. One
// that is not there yet may come, and work is not held up for it; that is said.
Status checkNewFile(const Saving& s, const ConstFieldRef& f, const fs::path& from) {
    const std::string& name = *static_cast<const std::string*>(f.value);
    const auto isIn = [&](const fs::path& dir) {
        const Result<fs::path> file = currentFile(dir, name);
        std::error_code ignored;
        return file && fs::exists(*file, ignored);
    };
    const bool isHere = isIn(s.p.dir);
    if (!isHere && (from.empty() || !isIn(from))) {
        logWarning(fmt::format("{}: {}: is not there, and the project opens only once it is", (s.p.dir / name).string(),
                               f.path));
        return {};
    }
    const Status sound = checkNamedFile(isHere ? s.p.dir : from, *f.row, name);
    if (sound) return {};
    const Error& e = sound.error();
    return failed(f.path + ": cannot be saved: " + e.message,
                  e.remedy.empty() ? "name another file, or none" : e.remedy)
        .at((s.p.dir / name).string());
}

Status checkNewFiles(const Saving& s, const fs::path& from) {
    std::set<std::string> before;
    for (const ConstFieldRef& f : allFiles(s.onDisk, s.rows)) before.insert(*static_cast<const std::string*>(f.value));
    for (const ConstFieldRef& f : allFiles(s.p, s.rows))
        if (before.insert(*static_cast<const std::string*>(f.value)).second)
            if (Status ok = checkNewFile(s, f, from); !ok) return ok;
    return {};
}

// Adds project.json if it says anything else than the one on disk, whatever its layout, or that is of an older form.
Status addProjectJson(Saving& s, bool copy) {
    std::map<const void*, std::string> names;
    for (const PlannedMap& planned : s.plan) names[planned.field.value] = planned.file;
    const Json tree = projectJson(s.p, s.rows, names);
    const std::string text = writeJson(tree);
    if (s.readable && s.sameForm) {
        if (s.onDisk.name.empty()) s.onDisk.name = s.p.name;  // it was taken from the folder
        if (writeJson(projectJson(s.onDisk, s.rows)) == text) return {};
    }
    if (Status ok = checkReadable(s.p, s.rows, tree, text, copy); !ok) return ok;
    s.files.push_back({"project.json", [text](const fs::path& to) { return writeFileSynced(to, text); }});
    return {};
}

void addRemoved(Saving& s) {
    std::set<std::string> missing;  // files of layers that were not there to be read, and may be back
    for (const ConstFieldRef& f : allMaps(s.p, s.rows, true))
        if (const auto& field = *static_cast<const MapField*>(f.value); !field.present()) missing.insert(field.file);
    for (const ConstFieldRef& f : allMaps(std::as_const(s.onDisk), s.rows, true)) {
        const std::string& file = static_cast<const MapField*>(f.value)->file;
        const bool kept = missing.contains(file) || std::any_of(s.plan.begin(), s.plan.end(),
                                                                [&](const PlannedMap& m) { return m.file == file; });
        if (!file.empty() && !kept && file.starts_with("maps/")) s.removed.push_back(file);
    }
}

std::map<std::string, FileStamp> stampsNow(const Saving& s) {
    std::map<std::string, FileStamp> stamps{{"project.json", stampNow(s.p, "project.json")}};
    for (const PlannedMap& planned : s.plan) stamps[planned.file] = stampNow(s.p, planned.file);
    return stamps;
}

// Another saved between; its project is replaced whole, and nobody shall wonder where it went.
void sayWhatIsReplaced(const Saving& s) {
    if (std::any_of(s.known.begin(), s.known.end(), [&](const auto& file) { return !isKnown(s, file.first); }))
        logWarning(fmt::format("{}: another program saved it since it was opened here; this save replaces that state",
                               s.p.dir.string()));
}

Result<std::vector<std::string>> saveLocked(Saving& s, const fs::path& from, const SaveWay& way) {
    if (Status ok = finishSave(s.p.dir, way.waitSeconds); !ok) return ok.error();
    readOnDisk(s);
    if (Status ok = addProjectJson(s, way.copy); !ok) return ok.error();
    if (Status ok = way.copy ? Status() : checkNewFiles(s, from); !ok) return ok.error();
    if (Status ok = addMaps(s); !ok) return ok.error();
    if (!from.empty())
        if (Status ok = addFiles(s, from); !ok) return ok.error();
    addRemoved(s);
    std::vector<std::string> written;
    for (const SaveFile& f : s.files) written.push_back(f.path);
    std::sort(written.begin(), written.end());
    if (!written.empty()) {
        sayWhatIsReplaced(s);
        if (Status ok = commitSave(s.p.dir, s.files, s.removed, way.waitSeconds); !ok) return ok.error();
    }
    if (way.stamps) *way.stamps = stampsNow(s);
    return written;
}

}  // namespace

std::map<std::string, FileStamp> changedOutside(const Project& p) {
    std::map<std::string, FileStamp> changed;
    for (const auto& [name, stamp] : p.stamps)
        if (const FileStamp now = stampNow(p, name); !(now == stamp) && !(now == FileStamp())) changed[name] = now;
    return changed;
}

Result<std::vector<std::string>> saveProject(const Project& p, Rows rows, const Project* saved, const SaveWay& way) {
    return saveProject(p, rows, saved, way, nullptr);
}

Result<std::vector<std::string>> saveProject(const Project& p, Rows rows, const Project* saved, const SaveWay& way,
                                             JobControl* control) {
    if (p.dir.empty()) return failed("the project has no folder yet", "save it to a new folder");
    if (Status ok = checkValues(p, rows); !ok) return ok.error();
    std::error_code fault;
    const bool existed = fs::exists(p.dir, fault);
    fs::create_directories(p.dir, fault);
    if (fault) return fileError("cannot be made", p.dir, fault.value());
    const bool sameFolder = saved && saved->dir == p.dir;
    Saving s{.p = p, .rows = rows, .plan = planMaps(p, rows), .control = control};
    if (sameFolder) s.savedPlan = planMaps(*saved, rows), s.known = saved->stamps;
    auto result = [&]() -> Result<std::vector<std::string>> {
        const Result<SaveLock> lock = SaveLock::take(p.dir, way.waitSeconds);
        if (!lock) return lock.error();
        return saveLocked(s, saved && !sameFolder ? saved->dir : fs::path(), way);
    }();
    if (!result && !existed) fs::remove(p.dir, fault);
    return result;
}

}  // namespace sward
