#include "cost/feature_switch.h"

#include <algorithm>

#include "grass/drawing.h"
#include "grass/mesh_grass_settings.h"
#include "scene/antialias.h"
#include "scene/forest.h"
#include "scene/ground_path.h"
#include "scene/map_layers.h"
#include "scene/scatter.h"

namespace sward {
namespace {

using IsRow = bool (*)(const ComponentRow&);

struct FeatureSwitch {
    Feature feature;
    IsRow component;
    const char* field = nullptr;  // null: the component is removed
    const char* off = "";
    const char* list = nullptr;  // the field is one of each element of this list
    bool ofAll = false;          // also of entities that do not ask for it themselves: they change others' maps
};

constexpr IsRow kTerrain = isRowOf<Terrain>, kField = isRowOf<GrassField>, kDrawing = isRowOf<GrassDrawing>,
                kPath = isRowOf<GroundPath>, kLight = isRowOf<Light>, kMesh = isRowOf<StaticMesh>,
                kScatter = isRowOf<Scatter>, kForest = isRowOf<Forest>, kForce = isRowOf<ForceSource>,
                kFar = isRowOf<FarLook>, kWind = isRowOf<Wind>, kWater = isRowOf<Water>, kFlowers = isRowOf<Flowers>;

constexpr FeatureSwitch kSwitches[] = {
    {Feature::TerrainMap, kTerrain, "terrainMap"},
    {Feature::TerrainMap, kPath, "tint", "0", nullptr, true},
    {Feature::TerrainBeyond, kTerrain, "beyond", "none"},
    {Feature::GrassOnMeshes, isRowOf<MeshGrass>},
    {Feature::GrassDensity, kField, "density", "", "species"},
    {Feature::GrassDensity, kPath, "grass", "0", nullptr, true},
    {Feature::GrassHeights, kField, "bladeHeight"},
    {Feature::GrassUnique, kField, "population", "patch"},
    {Feature::GrassOrientation, kField, "orientation"},
    {Feature::GrassVegetation, kField, "vegetation"},
    {Feature::GrassOcclusion, kField, "ambientOcclusion"},
    {Feature::GrassBlended, kDrawing, "transparency", "coverage"},
    {Feature::GrassClumps, kField, "clumpStrength", "0", "species"},
    {Feature::Translucency, kField, "translucency", "0", "species"},
    {Feature::Gloss, kField, "gloss", "0", "species"},
    {Feature::BladeShadows, kDrawing, "shadowMask", "0"},
    {Feature::GrassTraced, kDrawing, "bakeLight", "local"},
    {Feature::GroundShadows, kDrawing, "groundShadows", "false"},
    {Feature::Objects, kMesh, "file"},
    {Feature::ObjectLight, kMesh, "bakeLight", "local"},
    {Feature::ObjectShadows, kMesh, "castShadows", "false"},
    {Feature::ObjectShadows, kScatter, "castShadows", "false"},
    {Feature::ObjectShadows, kForest, "castShadows", "false"},
    {Feature::LampShadows, kMesh, "castShadows", "false"},
    {Feature::LampShadows, kScatter, "castShadows", "false"},
    {Feature::LampShadows, kForest, "castShadows", "false"},
    {Feature::Scatter, kScatter, "perHectare", "0"},
    {Feature::Forest, kForest, "perHectare", "0"},
    {Feature::TerrainShadows, kTerrain, "castShadows", "false"},
    {Feature::LampHills, kTerrain, "castShadows", "false"},
    {Feature::Sun, kLight, "intensity", "0"},
    {Feature::Lamps, kLight, "intensity", "0"},
    {Feature::CastingLights, kLight, "castShadows", "false"},
    {Feature::Wind, kWind, "strength", "0"},
    {Feature::Gusts, kWind, "model", "waves"},
    {Feature::Forces, kForce, "strength", "0"},
    {Feature::ForceOutlines, kForce, "shape", "object"},
    {Feature::ForceMap, kField, "forces"},
    {Feature::FarDarkening, kFar, "farDarkening", "0"},
    {Feature::FarBlur, kFar, "farBlur", "none"},
    {Feature::Temporal, isRowOf<Antialias>, "antialias", "msaa"},
    {Feature::Sky, isRowOf<Sky>, "intensity", "0"},
    {Feature::Atmosphere, isRowOf<Sky>, "model", "clear"},
    {Feature::Fog, isRowOf<Fog>, "visibility", "inf"},
    {Feature::Water, kWater},
    {Feature::WaterReflection, kWater, "reflection", "0"},
    {Feature::Flowers, kFlowers, "flowersPerM2", "0"},
    {Feature::FlowerDensity, kFlowers, "density"},
    {Feature::FlowerDensity, kPath, "flowers", "0", nullptr, true},
};

const ComponentRow& rowOf(const Tables& tables, IsRow is) {
    const auto row = std::find_if(tables.components.begin(), tables.components.end(), is);
    CHECK(row != tables.components.end());
    return *row;
}

struct Search {
    const Project& project;
    const Tables& tables;
    std::vector<SwitchStep>& steps;
};

// A map that is dropped would come back by what lies over it.
void muteLayers(const Search& s, const std::string& entity, const ConstFieldRef& map) {
    const MapLayers* over = s.project.registry.get<MapLayers>(findEntity(s.project, entity));
    if (!over) return;
    const ComponentRow& row = rowOf(s.tables, isRowOf<MapLayers>);
    const std::vector<std::string> paths = layerPaths(entity, *over);
    const size_t prefix = (entity + "." + row.name + ".").size();
    for (size_t i = 0; i < paths.size(); ++i) {
        const auto lies = findField(s.project, s.tables.components, layeredPath(entity, over->layers[i]));
        if (lies && lies->value == map.value && !over->layers[i].muted)
            s.steps.push_back({entity, &row, paths[i].substr(prefix) + ".muted", "true"});
    }
}

// A field that is not yet as it should be.
void setOff(const Search& s, const std::string& entity, const ComponentRow& row, const std::string& field,
            const char* off) {
    const auto ref = findField(s.project, s.tables.components, entity + "." + row.name + "." + field);
    CHECK(bool(ref));
    const bool isMap = ref->row->type == FieldType::Map;
    if (isMap ? static_cast<const MapField*>(ref->value)->present() : fieldText(*ref) != off)
        s.steps.push_back({entity, &row, field, off});
    if (isMap) muteLayers(s, entity, *ref);
}

void setOffInList(const Search& s, const std::string& entity, const ComponentRow& row, const FeatureSwitch& one) {
    const auto list = findField(s.project, s.tables.components, entity + "." + row.name + "." + one.list);
    CHECK(bool(list));
    for (const std::string& selector : elementSelectors(*list->row->list, list->value))
        setOff(s, entity, row, fmt::format("{}[{}].{}", one.list, selector, one.field), one.off);
}

// Settings that are absent are at their defaults.
bool holds(const Project& p, const std::string& entity, const ComponentRow& row) {
    return row.get(p.registry, findEntity(p, entity)) != nullptr;
}

void addSteps(const Search& s, const FeatureSwitch& one, const std::string& entity) {
    const ComponentRow& row = rowOf(s.tables, one.component);
    if (!holds(s.project, entity, row)) {
        const ComponentRow* owner = row.settingsOf ? findComponent(s.tables.components, row.settingsOf) : nullptr;
        if (owner && holds(s.project, entity, *owner)) s.steps.push_back({entity, &row, one.field, one.off});
        return;
    }
    if (!one.field) return s.steps.push_back({entity, &row, "", ""});
    if (one.list) return setOffInList(s, entity, row, one);
    setOff(s, entity, row, one.field, one.off);
}

}  // namespace

std::string SwitchStep::path() const {
    return entity + "." + component->name + (field.empty() ? std::string() : "." + field);
}
std::string SwitchStep::told() const {
    if (field.empty()) return "without " + path();
    return path() + " = " + (value.empty() ? "none" : value);
}

bool canBeLeftOut(Feature feature) {
    return std::any_of(std::begin(kSwitches), std::end(kSwitches),
                       [&](const FeatureSwitch& s) { return s.feature == feature; });
}

std::vector<SwitchStep> stepsWithout(const Project& painted, const Project& drawn, const Tables& tables,
                                     Feature feature) {
    std::vector<SwitchStep> steps;
    const std::vector<std::string> asking = entitiesWith(drawn.registry, tables, feature);
    if (asking.empty()) return steps;
    for (const FeatureSwitch& one : kSwitches) {
        if (one.feature != feature) continue;
        for (const auto& [name, entity] : painted.entities)
            if (one.ofAll || std::find(asking.begin(), asking.end(), name) != asking.end())
                addSteps({painted, tables, steps}, one, name);
    }
    return steps;
}

Status takeSteps(Project& p, const Tables& tables, const std::vector<SwitchStep>& steps) {
    for (const SwitchStep& step : steps) {
        const Entity e = findEntity(p, step.entity);
        if (step.field.empty()) {
            step.component->remove(p.registry, e);
            continue;
        }
        if (!step.component->get(p.registry, e)) step.component->assign(p.registry, e, nullptr);
        const auto field = findField(p, tables.components, step.path());
        if (!field) return field.error();
        if (Status s = setFieldText(*field, step.value); !s) return s;
    }
    return {};
}

}  // namespace sward
