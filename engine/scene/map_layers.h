// Layers over the maps of an entity: a painted map stays as it was painted, and what is drawn is it and the layers over
// it. Beside any component with maps of amounts (density, blade height, ambient occlusion) or colours (the ground's,
// the blades'), and over the heights. Does not: evaluate anything (world/map_stacks.h, world/height_layers.h), nor
// touch maps that repeat.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "core/enum_names.h"
#include "maps/map.h"
#include "scene/project.h"
#include "scene/rows.h"

namespace sward {

// What a mask goes by; what each measures and in which unit: maskRows() (world/layer_masks.h), in this order.
enum class MaskBy { Slope, Height, Noise, Water, Object, Path };
inline constexpr auto kMaskBys = enumNames<MaskBy>("slope", "height", "noise", "water", "object", "path");

// Where a layer counts: 1 from `from` to `to`, falling over `falloff` beyond both ends to 0.
struct MapMask {
    std::string name = "mask";
    MaskBy by = MaskBy::Slope;
    float from = 0, to = 35;  // in the unit of what it goes by
    float falloff = 0;        // likewise
    bool invert = false;      // 1 outside, 0 inside
    float size = 3;           // metres of the noise's spots
    int seed = 1;             // of the noise
    std::string object;       // the entity whose distance counts: an object, or a path
};

// Where a layer's amounts come from; layerKindRows() (world/map_stacks.h), in this order.
enum class LayerKind { Rule, Image, Painted, Path };
inline constexpr auto kLayerKinds = enumNames<LayerKind>("rule", "image", "painted", "path");

// How a layer's amount b changes what lies below, a; the result is kept in [0, 1]. Over heights both are metres, and
// nothing is kept: a rule's b is `high`, and its masks say where; an image's goes from `low` to `high`; a path's is the
// ground below at its middle and `low` more. Over colours `replace` lays `color`, as opaque as b; `multiply`,
// `subtract` and `minimum` change the opacity of what lies below (world/layered_tiles.h).
enum class LayerOperation { Multiply, Add, Subtract, Replace, Minimum, Maximum };
inline constexpr auto kLayerOperations =
    enumNames<LayerOperation>("multiply", "add", "subtract", "replace", "minimum", "maximum");

struct MapLayer {
    std::string name = "layer";
    std::string map;  // that it lies over, within its entity: "GrassField.species[lawn].density"
    LayerKind kind = LayerKind::Rule;
    bool muted = false;  // it is kept and does nothing
    float opacity = 1;   // share of its effect
    LayerOperation operation = LayerOperation::Multiply;
    bool invert = false;                   // its amounts are taken from 1
    std::vector<MapMask> masks;            // of a rule: they are multiplied; none: 1 everywhere
    glm::vec3 color{0.54f, 0.39f, 0.19f};  // reflectance that it lays, over colours alone: sand
    float low = 0, high = 1;               // metres, over heights alone
    std::string path;                      // of a path: the entity that has it
    MapField amounts;                      // of an image or painted layer: one channel, over the whole terrain
};

// The layers of all maps of an entity; of one map the first lies lowest.
struct MapLayers {
    std::vector<MapLayer> layers;
};

ComponentRow mapLayersRow();

// The PATHs of an entity's layers, in their order: "lawn.MapLayers.layers[no grass on slopes]".
std::vector<std::string> layerPaths(const std::string& entity, const MapLayers& of);
// The PATH of the map that a layer of this entity lies over.
std::string layeredPath(const std::string& entity, const MapLayer& layer);
// Whether a project may be opened without the map's file: a layer that lost it is skipped, and keeps its name.
bool mayBeMissing(const ConstFieldRef& map);
// Whether any map has a layer. Looks at no field of any other component.
bool hasLayers(const Project& p);

}  // namespace sward
