// A picture of heights that is being laid over a rectangle of the ground: shown there, until it is accepted.
// Does not: draw (panels/height_placing.cpp) or change the project (model/map_import.h).
#pragma once
#include <string>

#include "model/map_import.h"

namespace sward {

struct HeightPlacing {
    std::string file;  // empty: nothing is being placed
    Map source;
    HeightPlace place;
    std::string error;
};

}  // namespace sward
