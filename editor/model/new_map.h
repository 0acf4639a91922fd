// Maps that are not there yet: how large a new one is and what it holds, so that making it changes nothing that is
// seen. Does not: put it into a project; Document does.
#pragma once
#include <string>

#include "scene/project.h"

namespace sward {

// Power-of-two sides, 256 to 4096: eight texels a metre for densities and forces, four for what varies more slowly.
MapInfo newMapInfo(const Project& p, const ConstFieldRef& map);
// One channel: 1 everywhere, what an absent density or openness means. Directions and forces: none. Colours:
// transparent. Heights: level.
Map newMap(const Project& p, const ConstFieldRef& map);
// "512 x 512 texels, 8 a metre, 0.5 MB"
std::string describeNewMap(const Project& p, const ConstFieldRef& map);

}  // namespace sward
