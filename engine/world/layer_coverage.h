// How much of a layer there is at each texel: its masks multiplied, an image's or a painted map's amounts, or the
// weight of a path. Kept from call to call, and evaluated again only where something changed. Does not: combine layers
// (world/map_stacks.h, world/height_layers.h). Cost: about 0.3 us a texel and mask of slope on one core.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "scene/map_layers.h"
#include "world/layer_masks.h"
#include "world/tile_numbers.h"

namespace sward {

// What a person must know of a layer.
struct LayerNote {
    std::string layer;     // its PATH: "lawn.MapLayers.layers[no grass on slopes]"
    std::string message;   // what is the matter, and what to do
    bool skipped = false;  // it does nothing until then; else it does what it says, which is surely not meant
};

struct LayerKindRow {
    const char* help;  // what a new one is for
    bool ownMap;       // it has amounts of its own, which can be painted or imported
};
// By LayerKind.
std::span<const LayerKindRow> layerKindRows();

// What the evaluation of layers on one ground shares.
struct LayerScene {
    MaskScene masks;
    std::string of;               // the terrain's size and what its heights mean
    Map heights;                  // as they were at the last call
    std::vector<MapBox> changed;  // where they have changed since
    size_t evaluated = 0;         // tiles
};
// Takes the ground, with a terrain or none, and where its heights have changed since the last call.
void lookAt(LayerScene& scene, const Project& p, const Ground& ground);

// A layer's amounts on the texels of the map that it lies over.
struct Coverage {
    Map map;
    std::string of;  // its settings and what its masks go by
    Map source;      // of an image or painted layer
    bool zero = false;
};
// Evaluates what is not up to date, on a map of `wanted` (one channel). Fails, with what a person must know, where the
// layer goes by something that is not there; the coverage is then to be made anew.
Status updateCoverage(Coverage& c, LayerScene& scene, const MapLayer& layer, const MapInfo& wanted);

// a b, a + b, a - b, b, the lesser, the greater.
float combined(LayerOperation operation, float below, float amount);

}  // namespace sward
