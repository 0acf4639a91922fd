#include "scene/forest.h"

#include <algorithm>
#include <cmath>

#include "scene/components.h"
#include "scene/field_rows.h"

namespace sward {
namespace {

bool isGrown(const void* species) { return static_cast<const TreeSpecies*>(species)->file.empty(); }

constexpr FieldRow kTreeSpeciesFields[] = {
    text("name", offsetof(TreeSpecies, name), "what these trees are called"),
    where(isGrown, choice("kind", &TreeSpecies::kind, offsetof(TreeSpecies, kind), kTreeKinds,
                          "what is grown: conifer, broadleaf or birch")),
    meshFile("file", offsetof(TreeSpecies, file), "a tree of your own, .glb or .gltf; none: one is grown"),
    real("share", offsetof(TreeSpecies, share), "", {0, 1e6, 0, 1}, "how many of all trees, against the other kinds"),
    real("height", offsetof(TreeSpecies, height), "m", {0.1, 150, 1, 40}, "of a tree of size 1"),
    where(isGrown, real("crown", offsetof(TreeSpecies, crown), "", {0.05, 2, 0.1, 1},
                        "width of the crown as a share of the height")),
    where(isGrown, whole("leaves", offsetof(TreeSpecies, leaves), "", {1, 100000, 200, 5000},
                         "of a tree seen from near, two triangles each")),
    where(isGrown, color("leafColor", offsetof(TreeSpecies, leafColor), kReflectance, "of leaves: share of light")),
    where(isGrown, color("barkColor", offsetof(TreeSpecies, barkColor), kReflectance, "of bark: share of light")),
    real("translucency", offsetof(TreeSpecies, translucency), "", {0, 1, 0, 1},
         "light that shines through leaves, as a share of what is reflected; bark lets none through"),
    twoReals("size", offsetof(TreeSpecies, size), "", {0.05, 10, 0.3, 2}, "factor of the height, from and to"),
    where(isGrown,
          whole("seed", offsetof(TreeSpecies, seed), "", {0, 2147483647, 0, 1000}, "another number: another tree")),
};
constexpr ListRow kTreeSpeciesList = listRow<TreeSpecies>(kTreeSpeciesFields);
constexpr FieldRow kForestTiling =
    tiling("densityTiling", offsetof(Forest, densityTiling), "repeats of the density map over the terrain's mapSize");
constexpr MapRow kForestDensity{.role = MapRole::Density, .texelsPerMetre = 1, .tiling = &kForestTiling};
constexpr FieldRow kPlacedFields[] = {
    text("name", offsetof(PlacedTree, name), "what this tree is called"),
    whole("species", offsetof(PlacedTree, species), "", {0, 63, 0, 8}, "number of the kind of tree, from 0"),
    twoReals("at", offsetof(PlacedTree, at), "m", {-1e6, 1e6, 0, 1000}, "x and z from the terrain's corner"),
    real("size", offsetof(PlacedTree, size), "", {0.05, 10, 0.3, 2}, "factor of the height"),
    real("headingDeg", offsetof(PlacedTree, headingDeg), "deg", {-360, 360, -180, 180}, "turn about the upright"),
};
constexpr ListRow kPlacedList = listRow<PlacedTree>(kPlacedFields);
constexpr FieldRow kFields[] = {
    under("Where it grows", listOf("species", offsetof(Forest, species), &kTreeSpeciesList, "the kinds of trees")),
    listOf("placed", offsetof(Forest, placed), &kPlacedList, "single trees, placed by hand"),
    real("perHectare", offsetof(Forest, perHectare), "1/ha", {0, 1e5, 0, 1500},
         "trees on 10,000 square metres at density 1; 0: none"),
    real("distance", offsetof(Forest, distance), "m", {0.1, 100, 1, 10}, "between two trunks at least"),
    map("density", offsetof(Forest, density), &kForestDensity,
        "where trees stand: share of perHectare; none: everywhere"),
    kForestTiling,
    twoReals("slopeDeg", offsetof(Forest, slopeDeg), "deg", {0, 90, 0, 90}, "slopes of the ground on which they stand"),
    real("tileSize", offsetof(Forest, tileSize), "m", {2, 500, 8, 40},
         "edge of the triangles that hold the trees; a larger one holds more different places"),
    choice(
        "variety", &Forest::variety, offsetof(Forest, variety), kTileVarieties,
        "how many different tiles there are: eight as published, or 32, which repeat less and take 4 times the memory"),
    real("verticalScale", offsetof(Forest, verticalScale), "", {0.25, 4, 0.5, 2},
         "factor of all trees' heights alone; volumes are stretched, not baked again"),
    whole("seed", offsetof(Forest, seed), "", {0, 2147483647, 0, 1000}, "another number: other places"),
    under("Distances",
          choice("technique", &Forest::technique, offsetof(Forest, technique), kForestTechniques,
                 "near trees as meshes and volumes beyond, all as meshes, or a flat picture to compare with")),
    under("Distances", distance("meshesTo", offsetof(Forest, meshesTo), {0, 1e6, 0, 300},
                                "how far trees are drawn as meshes; as volumes beyond; inf: all as meshes")),
    under("Distances", real("meshDetail", offsetof(Forest, meshDetail), "", {0.05, 1e6, 0.3, 4},
                            "factor of the distances from which meshes have fewer and larger leaves")),
    real("voxel", offsetof(Forest, voxel), "m", {0.02, 5, 0.1, 1}, "size of a volume's smallest part"),
    under(kAdvanced, choice("storage", &Forest::storage, offsetof(Forest, storage), kVolumeStorages,
                            "how volumes are stored: plain, or compressed to a quarter (BC7)")),
    under(kAdvanced, real("silhouetteDeg", offsetof(Forest, silhouetteDeg), "deg", {0, 90, 0, 90},
                          "where the ground is seen at a smaller angle, a volume's slices face the eye")),
    real("slant", offsetof(Forest, slant), "", {0.05, 20, 0.5, 4},
         "how far such a slice may rise across a tile, in heights of the forest"),
    real("stiffness", offsetof(Forest, stiffness), "", {0.1, 1000, 1, 50},
         "against the wind: the greater, the less trees sway"),
    under("Light", flag("castShadows", offsetof(Forest, castShadows), "near trees shade the ground and the grass")),
};

FeatureSet featuresOfForest(const void* component) {
    const auto& f = *static_cast<const Forest*>(component);
    if (!grows(f)) return {};
    FeatureSet s = featureSet(Feature::Forest);
    const bool meshes = meshesTo(f) > 0 || !f.placed.empty();
    if (meshes) s |= featureSet(Feature::ForestMeshes);
    if (meshes && f.castShadows) s |= featureSet(Feature::ObjectShadows, Feature::LampShadows);
    if (f.perHectare > 0 && meshesTo(f) < std::numeric_limits<float>::infinity())
        s |= featureSet(Feature::ForestVolumes);
    return s;
}

std::vector<std::string> repairForest(void* component) {
    auto& f = *static_cast<Forest*>(component);
    std::vector<std::string> said;
    const auto order = [&](glm::dvec2& r, const std::string& name) {
        if (r.x <= r.y) return;
        std::swap(r.x, r.y);
        said.push_back(name + " ran from its greater to its lesser value; they are exchanged");
    };
    order(f.slopeDeg, "slopeDeg");
    for (size_t i = 0; i < f.species.size(); ++i) order(f.species[i].size, fmt::format("species[{}].size", i));
    return said;
}

void checkForest(const Registry& registry, Entity e, const std::string& path, std::vector<ComponentFault>& faults) {
    const Forest& f = *registry.get<Forest>(e);
    const auto tell = [&](const char* field, const std::string& what, bool without = false) {
        faults.push_back({std::string("Forest.") + field, fmt::format("{}.{}: {}", path, field, what), without});
    };
    if (std::none_of(f.species.begin(), f.species.end(), stands))
        tell("species", "no species has a share: no tree stands; give one a share", true);
    registry.each<Terrain>([&](Entity, const Terrain& t) {
        const double all = static_cast<double>(f.perHectare) / 1e4 * t.size.x * t.size.y;
        if (all > kMostForestTrees)
            tell("perHectare",
                 fmt::format(
                     "{:.0f} trees are asked for on this terrain; the most are {:.0f}, and none stands; lower it", all,
                     kMostForestTrees),
                 true);
    });
}

}  // namespace

bool stands(const TreeSpecies& s) { return s.share > 0 && s.height > 0; }

float meshesTo(const Forest& f) {
    if (f.technique == ForestTechnique::Trees) return std::numeric_limits<float>::infinity();
    return f.technique == ForestTechnique::Flat ? 0 : f.meshesTo;
}

bool grows(const Forest& f) {
    return (f.perHectare > 0 || !f.placed.empty()) && std::any_of(f.species.begin(), f.species.end(), stands);
}

const ComponentRow& forestRow() {
    static const ComponentRow row = [] {
        ComponentRow r =
            componentRow<Forest>("Forest", "A forest of trees over the terrain.", kFields, featuresOfForest);
        r.repair = repairForest;
        r.check = checkForest;
        r.readByTruth = true;
        return r;
    }();
    return row;
}

}  // namespace sward
