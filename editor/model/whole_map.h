// What is done to a whole map at once: fill, clear, invert. Each is one undo step; a map that is not there is made
// first. Does not: paint (brushes/brush.h). Cost: filling and clearing make a few tiles, whatever the map's size;
// inverting reads every tile that differs from the others, about 10 ms for 4096 x 4096 texels of 16 bits.
#pragma once
#include <string>

#include "brushes/brush.h"
#include "model/document.h"

namespace sward {

// Everywhere what the brush lays: amounts its value, colours its colour with the value as opacity, directions its
// angle. Heights and forces cannot be filled (usage).
Status fillMap(Document& document, const BrushSettings& brush);
// Amounts 0, heights 0 m, colours of opacity 0 (kept as they are else), no direction, no force.
Status clearMap(Document& document, const std::string& mapPath);
// Amounts 1 - a; colours keep theirs and have the opacity 1 - a; directions and pushes turn round. Heights cannot be
// inverted (usage).
Status invertMap(Document& document, const std::string& mapPath);

// Something that grows, added so that it grows nowhere until its density is painted: an element of a list as
// addListElement makes it, or a component, with density maps of zeros. One undo step. What has no density: as the
// document adds it.
Status addUnpainted(Document& document, const std::string& listPath);
Status addComponentUnpainted(Document& document, const std::string& entity, const std::string& component);
// Whether a map is one that nothing has been painted on since it was made so.
bool unpainted(const Map& map);

// A texel in [0, 1] as it becomes, channel by channel.
using TexelChange = void (*)(float* texel);
// The map with each texel changed; equal tiles stay one.
Map changedTexels(const Map& map, TexelChange change);
// A map of one value everywhere; value[c] as Map::set takes it.
Map uniformMap(const MapInfo& info, const glm::vec4& value);

}  // namespace sward
