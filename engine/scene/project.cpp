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

}  // namespace

Result<Entity> addEntity(Project& p, const std::string& name) {
    if (!validEntityName(name))
        return usage(fmt::format("\"{}\" cannot name an entity", name), "use letters, digits, '_' and '-'");
    if (p.entities.contains(name))
        return usage(fmt::format("there is already an entity \"{}\"", name), "choose another name");
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
    copy.stamps = p.stamps;
    for (const auto& [name, entity] : p.entities) {
        const Entity twin = makeEntity(copy, name);
        for (const ComponentRow& row : rows)
            if (const void* component = row.get(p.registry, entity)) row.assign(copy.registry, twin, component);
    }
    return copy;
}

double virtualBlades(const Project& p) {
    double perM2 = 0;
    p.registry.each<GrassField>([&](Entity, const GrassField& field) {
        for (const Species& s : field.species)
            if (field.onTerrain)
                perM2 +=
                    double(s.bladesPerM2) * (s.density.present() && s.bladesPerM2 > 0 ? s.density.map.mean() : 1.0);
    });
    return perM2 * terrainArea(p);
}

double PopulationCount::of(const Project& p) {
    std::vector<Map> densities;
    std::vector<double> factors{terrainArea(p)};
    p.registry.each<GrassField>([&](Entity, const GrassField& field) {
        for (const Species& s : field.species)
            if (field.onTerrain) densities.push_back(s.density.map), factors.push_back(s.bladesPerM2);
    });
    const bool same =
        factors == factors_ && std::equal(densities.begin(), densities.end(), densities_.begin(), densities_.end(),
                                          [](const Map& a, const Map& b) { return a.sameTiles(b); });
    if (!same) count_ = virtualBlades(p);
    densities_ = std::move(densities);
    factors_ = std::move(factors);
    return count_;
}

}  // namespace sward
