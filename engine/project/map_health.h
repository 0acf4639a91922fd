// What is wrong with a project's maps, or looks so: texels that are no numbers, ground cut off at the end of its range,
// steps of 8 bits in finer texels, a range that is mostly unused. Each with the place where it is worst.
// Does not: change anything; know what a person meant: densities of 0 and 1 are told, and no fault.
// Cost: every texel is read once; 4096 x 4096 of 16 bits about 0.1 s.
#pragma once
#include <cstddef>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "maps/map.h"
#include "scene/project.h"

namespace sward {

class JobControl;

// How many texels of a map share a fault, and the middle of them in the tile of 128 x 128 that has most: in [0,1] of
// the map.
struct TexelFault {
    size_t count = 0;
    glm::dvec2 worst{0.5};
};
struct TexelHealth {
    size_t texels = 0;
    TexelFault notFinite;      // any channel is NaN or infinite
    TexelFault atLow, atHigh;  // of integers of one channel: at 0, at full scale
    float low = 0, high = 0;   // least and greatest finite number of the first channel, as Map::at gives it
    // Of one channel of 16 bits or floats: the distinct values, if they are 16 to 256 and lie an even step apart that
    // is at least 8 of the map's own, with stairs between them; else 0. `banded`: texels that begin a stair (a level of
    // two texels at least on each side of a step).
    int levels = 0;
    TexelFault banded;
};
// Of a map that is there.
TexelHealth healthOf(const Map& map);

enum class MapFault { NotFinite, Clipped, Banded, UnusedRange };
struct MapFinding {
    std::string map;  // PATH
    MapFault fault = MapFault::NotFinite;
    bool meant = false;   // may well be: told, but nothing that `check` notices
    std::string message;  // "3.1 % of the ground is at the end of heightRange, 100 m: it is cut off there"
    glm::dvec2 worst{0};  // metres on the terrain, of the map's first repeat
};
// Of all maps that are there, by PATH.
// `control`: told how far it is, and ends it early.
std::vector<MapFinding> mapFindings(const Project& p, std::span<const ComponentRow> rows,
                                    JobControl* control = nullptr);

}  // namespace sward
