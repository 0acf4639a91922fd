// The terrain's heights with the layers of its MapLayers over them, in metres: rules lift or level where their masks
// are, images and painted layers add their relief, paths level the ground across them. Each layer sees the ground as
// those below leave it: a mask of slopes over an image counts the image's slopes. Evaluated tile by tile, where a
// stroke, a layer or a path changed something. Does not: touch heights that are mirrored (said), nor change the
// project. Cost: as layers of amounts (world/map_stacks.h), and 8 bytes a texel and layer; a path asks twice where it
// lies.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "world/layer_coverage.h"

namespace sward {

// The PATH of the heights of the scene's terrain: "ground.Terrain.height"; empty without one.
std::string heightsPath(const Project& p);
// Gives the terrain of `to` these heights, floats in metres.
void setLayeredHeights(Project& to, const Map& metres);

class HeightLayers {
  public:
    HeightLayers();
    ~HeightLayers();
    HeightLayers(HeightLayers&&) noexcept;
    HeightLayers& operator=(HeightLayers&&) noexcept;

    // Metres as the layers leave them, floats at the size of the painted map (or of a new one where none is painted);
    // null if no layer over the heights does anything. Valid until the next call.
    const Map* shown(const Project& p);
    // Of the last call: layers that are skipped or do nothing, the lowest first.
    const std::vector<LayerNote>& notes() const;
    // Of the last call: how much of each layer there is where, by its PATH; floats from 0 to 1.
    std::map<std::string, Map> coverages() const;
    // Tiles that the last call evaluated.
    size_t evaluatedTiles() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// Whether there are layers over the heights that may do something.
bool hasHeightLayers(const Project& p);
// The project standing on these heights, floats in metres, with the layers over its own taken off: for hands and feet,
// what is picked, placed and walked on.
Project standingOn(const Project& p, const Map& heights, std::span<const ComponentRow> rows);
// On those that layers leave; none where no layer over the heights does anything.
std::optional<Project> standingOnLayers(HeightLayers& layers, const Project& p, std::span<const ComponentRow> rows);

}  // namespace sward
