#include "scene/scatter.h"

#include <algorithm>

#include "scene/components.h"
#include "scene/field_rows.h"

namespace sward {
namespace {

constexpr FieldRow kMeshFields[] = {
    text("name", offsetof(ScatterMesh, name), "what this mesh is called"),
    meshFile("file", offsetof(ScatterMesh, file), "object to scatter: .glb or .gltf in the project's folder"),
    real("share", offsetof(ScatterMesh, share), "", {0, 1e6, 0, 1}, "how many of all are this one, against the others"),
};
constexpr ListRow kMeshList = listRow<ScatterMesh>(kMeshFields);
constexpr FieldRow kScatterTiling =
    tiling("densityTiling", offsetof(Scatter, densityTiling), "repeats of the density map over the terrain's mapSize");
constexpr MapRow kScatterDensity{.role = MapRole::Density, .texelsPerMetre = 4, .tiling = &kScatterTiling};

constexpr FieldRow kFields[] = {
    listOf("meshes", offsetof(Scatter, meshes), &kMeshList, "what stands there"),
    real("perHectare", offsetof(Scatter, perHectare), "1/ha", {0, 1e6, 0, 2000},
         "objects on 10,000 square metres at density 1; 0: none"),
    map("density", offsetof(Scatter, density), &kScatterDensity,
        "where they stand: share of perHectare; none: everywhere"),
    kScatterTiling,
    real("distance", offsetof(Scatter, distance), "m", {0, 1000, 0, 20},
         "between two of them at least, from middle to middle"),
    twoReals("slopeDeg", offsetof(Scatter, slopeDeg), "deg", {0, 90, 0, 90},
             "slopes of the ground on which they stand"),
    twoReals("heights", offsetof(Scatter, heights), "m", {-1e5, 1e5, -100, 1000},
             "heights of the ground between which they stand"),
    twoReals("size", offsetof(Scatter, size), "", {0.001, 1000, 0.1, 5}, "factor of their size, from and to"),
    twoReals("headingDeg", offsetof(Scatter, headingDeg), "deg", {-360, 360, -180, 180},
             "turn about the upright, from and to"),
    real("alignToGround", offsetof(Scatter, alignToGround), "", kShare,
         "0: they stand upright; 1: as the ground leans"),
    flag("keepOffPaths", offsetof(Scatter, keepOffPaths), "none stands on a path"),
    flag("keepOffObjects", offsetof(Scatter, keepOffObjects),
         "none stands where an object that was placed by hand meets the ground"),
    where([](const void* s) { return keepsOff(*static_cast<const Scatter*>(s)); },
          real("gap", offsetof(Scatter, gap), "m", {0, 1000, 0, 5},
               "that stays free beside paths and objects, to the middle of what is scattered")),
    flag("castShadows", offsetof(Scatter, castShadows), "they shade the ground, the grass and other objects"),
    whole("seed", offsetof(Scatter, seed), "", {0, 2147483647, 0, 1000}, "another number: other places"),
};

FeatureSet featuresOfScatter(const void* component) {
    const auto& s = *static_cast<const Scatter*>(component);
    if (!scatters(s)) return {};
    const FeatureSet all = featureSet(Feature::Scatter);
    return s.castShadows ? all | featureSet(Feature::ObjectShadows, Feature::LampShadows) : all;
}

std::vector<std::string> repairScatter(void* component) {
    auto& s = *static_cast<Scatter*>(component);
    std::vector<std::string> said;
    const auto order = [&](glm::dvec2& r, const char* name) {
        if (r.x <= r.y) return;
        std::swap(r.x, r.y);
        said.push_back(std::string(name) + " ran from its greater to its lesser value; they are exchanged");
    };
    order(s.slopeDeg, "slopeDeg"), order(s.heights, "heights"), order(s.size, "size");
    order(s.headingDeg, "headingDeg");
    return said;
}

void checkScatter(const Registry& registry, Entity e, const std::string& path, std::vector<ComponentFault>& faults) {
    const Scatter& s = *registry.get<Scatter>(e);
    const auto tell = [&](const char* field, const std::string& what, bool without = false) {
        faults.push_back({std::string("Scatter.") + field, fmt::format("{}.{}: {}", path, field, what), without});
    };
    if (std::none_of(s.meshes.begin(), s.meshes.end(), isScattered))
        tell("meshes", "no mesh has a file and a share: nothing is scattered; choose a file", true);
    const double asked = static_cast<double>(s.perHectare) / 1e4, apart = static_cast<double>(s.distance),
                 most = apart > 0 ? kDensestScatter / (apart * apart) : asked;
    if (asked > most)
        tell("distance", fmt::format("at {} m from each other {:.0f} objects a hectare find room where {} are asked "
                                     "for; lower perHectare or distance",
                                     s.distance, most * 1e4, s.perHectare));
    registry.each<Terrain>([&](Entity, const Terrain& t) {
        const double all = asked * t.size.x * t.size.y;
        if (all > kMostScattered)
            tell(
                "perHectare",
                fmt::format("{:.0f} objects are asked for on this terrain; the most are {:.0f}, and none is scattered; "
                            "lower it",
                            all, kMostScattered),
                true);
    });
}

}  // namespace

bool isScattered(const ScatterMesh& mesh) { return !mesh.file.empty() && mesh.share > 0; }

bool keepsOff(const Scatter& s) { return s.keepOffPaths || s.keepOffObjects; }

bool scatters(const Scatter& s) {
    return s.perHectare > 0 && std::any_of(s.meshes.begin(), s.meshes.end(), isScattered);
}

const ComponentRow& scatterRow() {
    static const ComponentRow row = [] {
        ComponentRow r = componentRow<Scatter>("Scatter", "Objects scattered over the terrain by a rule.", kFields,
                                               featuresOfScatter);
        r.repair = repairScatter;
        r.check = checkScatter;
        return r;
    }();
    return row;
}

}  // namespace sward
