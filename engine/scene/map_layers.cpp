#include "scene/map_layers.h"

#include "scene/field_rows.h"

namespace sward {
namespace {

constexpr Range kMeasure{-1e6, 1e6, 0, 90};

constexpr FieldRow reach(const char* name, size_t offset, Range r, const char* help) {
    FieldRow row = real(name, offset, "", r, help);
    row.allowInf = true;
    return row;
}

constexpr FieldRow kMaskFields[] = {
    text("name", offsetof(MapMask, name), "what this mask is called"),
    choice("by", &MapMask::by, offsetof(MapMask, by), kMaskBys,
           "what it goes by: slope in degrees, height in metres, noise from 0 to 1, distance to water, an object or a "
           "path in "
           "metres"),
    reach("from", offsetof(MapMask, from), kMeasure, "it is 1 from here on ..."),
    reach("to", offsetof(MapMask, to), kMeasure, "... to here; inf: without end"),
    real("falloff", offsetof(MapMask, falloff), "", {0, 1e6, 0, 20}, "how far beyond both ends it falls to 0"),
    flag("invert", offsetof(MapMask, invert), "0 inside and 1 outside instead"),
    real("size", offsetof(MapMask, size), "m", {0.01, 1e5, 0.5, 30}, "of the noise's spots"),
    whole("seed", offsetof(MapMask, seed), "", {0, 2147483647, 0, 1000}, "another number: another noise"),
    entityName("object", offsetof(MapMask, object),
               "the entity whose distance counts, where it goes by an object or a path"),
};
constexpr ListRow kMaskList = listRow<MapMask>(kMaskFields);

constexpr Range kMetres{-1e5, 1e5, -20, 50};
constexpr MapRow kAmounts{.texelsPerMetre = 4, .least = "0", .most = "1"};
constexpr FieldRow kLayerFields[] = {
    text("name", offsetof(MapLayer, name), "what this layer is called"),
    text("map", offsetof(MapLayer, map), "the map of this entity that it lies over: GrassField.species[lawn].density"),
    choice(
        "kind", &MapLayer::kind, offsetof(MapLayer, kind), kLayerKinds,
        "where its amounts come from: rule: its masks, image: an imported map, painted: a map of its own, path: along "
        "one"),
    flag("muted", offsetof(MapLayer, muted), "it is kept and does nothing"),
    real("opacity", offsetof(MapLayer, opacity), "", kShare, "share of its effect"),
    choice("operation", &MapLayer::operation, offsetof(MapLayer, operation), kLayerOperations,
           "how its amounts change what lies below"),
    flag("invert", offsetof(MapLayer, invert), "its amounts are taken from 1"),
    listOf("masks", offsetof(MapLayer, masks), &kMaskList, "where a rule counts: they are multiplied"),
    color("color", offsetof(MapLayer, color), kReflectance, "over colours: what it lays, as reflectance"),
    real("low", offsetof(MapLayer, low), "m", kMetres,
         "over heights: what an amount of 0 stands for; of a path: how far it lies over the ground along its middle"),
    real("high", offsetof(MapLayer, high), "m", kMetres, "over heights: what an amount of 1 stands for"),
    entityName("path", offsetof(MapLayer, path), "the entity whose path it goes along"),
    map("amounts", offsetof(MapLayer, amounts), &kAmounts, "amounts of an image or painted layer, over the terrain"),
};
constexpr ListRow kLayerList = listRow<MapLayer>(kLayerFields);
constexpr FieldRow kFields[] = {
    listOf("layers", offsetof(MapLayers, layers), &kLayerList, "of one map the first lies lowest"),
};

std::vector<std::string> repairMasks(void* component) {
    std::vector<std::string> said;
    for (MapLayer& layer : static_cast<MapLayers*>(component)->layers)
        for (MapMask& mask : layer.masks) {
            if (!(mask.from > mask.to)) continue;
            std::swap(mask.from, mask.to);
            said.push_back(fmt::format("mask \"{}\" of layer \"{}\": from lay above to; they are swapped now",
                                       mask.name, layer.name));
        }
    return said;
}

}  // namespace

ComponentRow mapLayersRow() {
    ComponentRow row = componentRow<MapLayers>("MapLayers", "Layers over the maps of the entity.", kFields,
                                               [](const void*) { return FeatureSet{}; });
    row.repair = repairMasks;
    return row;
}

std::vector<std::string> layerPaths(const std::string& entity, const MapLayers& of) {
    std::vector<std::string> paths;
    for (const std::string& selector : elementSelectors(kLayerList, &of.layers))
        paths.push_back(fmt::format("{}.MapLayers.layers[{}]", entity, selector));
    return paths;
}

std::string layeredPath(const std::string& entity, const MapLayer& layer) { return entity + "." + layer.map; }

bool mayBeMissing(const ConstFieldRef& map) { return isRowOf<MapLayers>(*map.component); }

bool hasLayers(const Project& p) {
    bool any = false;
    p.registry.each<MapLayers>([&](Entity, const MapLayers& of) { any |= !of.layers.empty(); });
    return any;
}

}  // namespace sward
