// What the layers over a map make of one of its tiles: a row for each kind of map that can have layers.
// Amounts are combined as operations say. Colours are covered: a layer lays its colour where it counts (`replace`), or
// takes the opacity of what lies below (`multiply`, `subtract`, `minimum`). Does not: evaluate layers
// (world/layer_coverage.h), nor know heights (world/height_layers.h). Cost: 10 ns a texel and layer of amounts, 0.1 us
// a texel that a colour is laid on.
// Source of covering: T. Porter and T. Duff, Compositing Digital Images, 1984 ("over"), in linear light.
#pragma once
#include <string>
#include <vector>

#include "scene/map_layers.h"
#include "world/tile_numbers.h"

namespace sward {

// A layer that counts, and how much of it there is where: one channel, of the map's width and height.
struct LayerOver {
    const MapLayer* layer;
    const Map* coverage;
};

struct LayeredKind {
    MapKind kind;
    // Why a layer cannot lie over such a map, and what to do; nothing if it can.
    Status (*fits)(const MapLayer&);
    // What to say of a layer that counts and is 0 everywhere; empty if nothing.
    std::string (*zeroSays)(const MapLayer&);
    // A tile of what comes out, as readTile() gives it: the painted one (an empty map: as if nothing was painted) and
    // the layers over it, the lowest first.
    void (*combine)(const Map& painted, const std::vector<LayerOver>& layers, TilePlace at, Numbers& out);
};
// Null for a kind of map that layers do not lie over here.
const LayeredKind* layeredKind(MapKind kind);

// A colour in linear light laid over one of a map (sRGB, its opacity last), as opaque as `share`, above 0.
glm::vec4 laidOver(const glm::vec4& below, const glm::vec3& color, float share);

}  // namespace sward
