// Layers over a map, edited: each call is one undo step. Does not: evaluate layers (world/map_stacks.h), nor draw.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "model/document.h"
#include "project/import.h"
#include "scene/map_layers.h"

namespace sward {

// The map that a stack is of: `mapPath` itself, or, where that is a layer's own amounts, the one that it lies over.
std::string stackedMap(const Project& p, const std::string& mapPath);

// What that map's channels mean; of none amounts.
MapKind kindUnder(const Document& document, const std::string& mapPath);

struct LayerOf {
    std::string path;  // "lawn.MapLayers.layers[not steep]"
    const MapLayer* layer = nullptr;
};
// Over this map, the lowest first. They hold until the project changes.
std::vector<LayerOf> layersOver(const Project& p, const std::string& mapPath);

// Who sculpts sees the layers over the heights, and changes the ground below them: in a few words ("below 2 layers")
// how many that do something lie over this map; empty if none, or if the map is no heights.
std::string sculptsBelow(const Document& document, const std::string& mapPath);
// What that means.
inline constexpr const char* kSculptsBelow =
    "Brushes, Place Heights and Add Pond sculpt the ground below these layers; what is seen is that and the layers "
    "over "
    "it. To sculpt over them: Add painted, and Paint on it.";

// On top of the others. A rule begins with a mask of slopes, a painted layer with amounts of 1: it changes nothing.
// Over heights a rule begins with a noise of a metre, over colours with what is steep; there a painted layer begins
// with amounts of 0. A path's takes the scene's first.
Status addLayer(Document& document, const std::string& mapPath, LayerKind kind);
// With the last one goes the entity's MapLayers, so that nothing is left in the file.
Status removeLayer(Document& document, const std::string& layerPath);
// One place up (or down) among the layers of its map; nothing at the end of them.
Status moveLayer(Document& document, const std::string& layerPath, bool up);
// Reads an image file into an image layer; remembered as imports are (project/import.h). Over heights a picture of
// floats is metres: its least and greatest become the layer's `low` and `high`, in the same step.
Status importLayer(Document& document, const std::string& layerPath, const std::filesystem::path& file,
                   const ImportOptions& options);

}  // namespace sward
