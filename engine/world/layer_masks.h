// What masks of layers measure of the scene, one row a kind: slope, height, noise, distance to water, to an object, to
// a path. Places are metres relative to the terrain's corner. Does not: know maps or texels (world/map_stacks.h).
// Accuracy: a slope is the rise over two texels of the height map; distance to water is that of a raster of at most
// 1024 cells a side (docs/maps.md), to an object that to its outline as seen from above (mesh/footprint.h).
#pragma once
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "mesh/footprint.h"
#include "scene/ground_path.h"
#include "scene/map_layers.h"
#include "world/ground.h"

namespace sward {

// Distances to the scene's water over the terrain, measured anew when level or ground has changed.
struct WaterDistances {
    std::vector<uint8_t> wet;   // by cell, rows along x
    std::vector<float> metres;  // to the nearest wet cell's middle; infinity where the scene has none
    int width = 0, height = 0;  // cells
    double cell = 0;            // metres
    uint64_t version = 0;       // another number: other distances
    Map heights;                // that it was made of, and what else: levels and places, size, scale, tiling
    std::string of;
};
struct ObjectOutline {
    std::string of;  // file, its version, turn
    std::shared_ptr<const Footprint> footprint;
};

// The scene as masks see it, and what they keep from call to call.
struct MaskScene {
    const Project* project = nullptr;
    Ground ground;  // with a terrain
    WaterDistances water;
    std::map<std::string, ObjectOutline> outlines;  // by entity
};

// What a mask measures at a place.
using Measure = std::function<float(double x, double z)>;

struct MaskRow {
    const char* unit;
    double softMin, softMax;  // of the sliders of from and to
    bool followsHeights;      // what it measures at a place changes where the heights there do
    // Fails, with what a person must know, where what it goes by is not in the scene. The result holds until the scene
    // changes.
    Result<Measure> (*measure)(MaskScene&, const MapMask&);
    // What it measures by beside the mask's fields and the heights: another text, other values. Null: by nothing.
    std::string (*inputs)(MaskScene&, const MapMask&);
};
// By MaskBy.
std::span<const MaskRow> maskRows();

// The path of an entity, with points. Fails, with what a person must know, where there is none.
Result<const GroundPath*> pathNamed(const MaskScene& scene, const std::string& entity);
// All that its place goes by: another text, another path.
std::string pathText(const MaskScene& scene, const std::string& entity);

// 1 from mask.from to mask.to, falling straight to 0 over its falloff beyond; inverted if it says so.
float maskShare(const MapMask& mask, float measured);

}  // namespace sward
