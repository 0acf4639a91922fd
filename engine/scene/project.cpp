#include "scene/project.h"

namespace fs = std::filesystem;

namespace sward {
namespace {

bool validEntityName(const std::string& name) {
    const auto allowed = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; };
    return !name.empty() && std::all_of(name.begin(), name.end(), allowed);
}

double terrainArea(const Project& p) {
    for (const auto& [name, entity] : p.entities)
        if (const auto* t = p.registry.get<Terrain>(entity)) return t->size.x * t->size.y;
    return 0;
}

Entity makeEntity(Project& p, const std::string& name) {
    const Entity e = p.registry.create();
    p.registry.add<Name>(e, {name});
    p.entities[name] = e;
    return e;
}

// A lawn of 40 x 40 m to begin with. Its density map is there, all ones, so that it can be painted at once.
Project emptyProject(const fs::path& dir) {
    Project p;
    p.dir = dir;
    p.name = dir.has_filename() ? dir.filename().string() : dir.parent_path().filename().string();
    Map density({256, 256, 1, PixelType::U16});
    const std::vector<uint16_t> row(256, 65535);
    for (int y = 0; y < 256; ++y) density.writeRows(y, 1, row.data());
    GrassField field;
    field.species[0].name = "lawn";
    field.species[0].bladesPerM2 = 2000;
    field.species[0].density = {"maps/lawn.lawn.density.png", std::move(density)};
    p.registry.add<Terrain>(makeEntity(p, "ground"));
    p.registry.add<GrassField>(makeEntity(p, "lawn"), std::move(field));
    p.registry.add<Light>(makeEntity(p, "sun"));
    p.registry.add<Sky>(makeEntity(p, "sky"));
    p.registry.add<Fog>(makeEntity(p, "haze"));
    p.registry.add<Camera>(makeEntity(p, "camera"));
    return p;
}

}  // namespace

Result<Entity> addEntity(Project& p, const std::string& name) {
    if (!validEntityName(name))
        return Error{ExitCode::Usage,
                     fmt::format("\"{}\" cannot name an entity", name),
                     {},
                     0,
                     0,
                     "use letters, digits, '_' and '-'"};
    if (p.entities.contains(name))
        return Error{ExitCode::Usage,      fmt::format("there is already an entity \"{}\"", name), {}, 0, 0,
                     "choose another name"};
    return makeEntity(p, name);
}

bool removeEntity(Project& p, const std::string& name) {
    const auto it = p.entities.find(name);
    if (it == p.entities.end()) return false;
    p.registry.destroy(it->second);
    p.entities.erase(it);
    return true;
}

Entity findEntity(const Project& p, const std::string& name) {
    const auto it = p.entities.find(name);
    return it == p.entities.end() ? kNoEntity : it->second;
}

Project snapshot(const Project& p, std::span<const ComponentRow> rows) {
    Project copy;
    copy.name = p.name;
    copy.dir = p.dir;
    copy.unknown = p.unknown;
    copy.imports = p.imports;
    copy.repairedMaps = p.repairedMaps;
    for (const auto& [name, entity] : p.entities) {
        const Entity twin = makeEntity(copy, name);
        for (const ComponentRow& row : rows)  // get() takes a mutable registry, but only reads it
            if (const void* component = row.get(const_cast<Registry&>(p.registry), entity))
                row.assign(copy.registry, twin, component);
    }
    return copy;
}

double virtualBlades(const Project& p) {
    double perM2 = 0;
    p.registry.each<GrassField>([&](Entity, const GrassField& field) {
        for (const Species& s : field.species)
            perM2 += double(s.bladesPerM2) * (s.density.present() && s.bladesPerM2 > 0 ? s.density.map.mean() : 1.0);
    });
    return perM2 * terrainArea(p);
}

Result<Project> newProject(const fs::path& dir) {
    std::error_code fault;
    const bool existed = fs::exists(dir, fault);
    if (existed && (!fs::is_directory(dir, fault) || !fs::is_empty(dir, fault)))
        return Error{
            ExitCode::Failed, "exists and is not an empty folder", dir.string(), 0, 0, "name a new or an empty folder"};
    Project p = emptyProject(dir);
    if (auto saved = saveProject(p, sharedComponentRows()); !saved) {
        if (!existed) fs::remove_all(dir, fault);
        return saved.error();
    }
    return p;
}

}  // namespace sward
