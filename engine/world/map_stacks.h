// What maps with layers come to: a painted map at the bottom, the layers of MapLayers over it, one by one. Whoever
// reads the project as it is drawn (world/drawn_project.h) reads maps there as if there were no layers. Evaluated tile
// by tile, and again only where something changed: below a stroke, where heights changed under masks that follow them,
// all of it where a setting did or water moved. Heights come first (world/height_layers.h): what goes by slopes sees
// the ground as it stands. Does not: change the project. A project without layers is handed through: nothing is made,
// nothing is held. Cost: about 0.3 us a texel and mask of slope on one core, 10 ns a texel and layer to combine; 2
// bytes a texel and layer.
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/map_layers.h"
#include "world/layer_coverage.h"

namespace sward {

class MapStacks {
  public:
    MapStacks();
    ~MapStacks();
    MapStacks(MapStacks&&) noexcept;
    MapStacks& operator=(MapStacks&&) noexcept;

    // The project with each layered map replaced by what it comes to, and the amounts of each rule that counts by its
    // coverage; `p` itself if no layer does anything. The result holds until the next call, or as long as `p`.
    const Project& shown(const Project& p, std::span<const ComponentRow> rows);
    // Of the last call: layers that are skipped or hide everything, in the order of entities and layers.
    const std::vector<LayerNote>& notes() const;
    // Tiles that the last call evaluated, of all layers and maps.
    size_t evaluatedTiles() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace sward
