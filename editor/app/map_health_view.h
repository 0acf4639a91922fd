// The list of what is wrong with the open project's maps, as it was when it was asked for.
// Does not: look for it (project/map_health.h) or draw it (panels/map_health.cpp).
#pragma once
#include <cstdint>
#include <vector>

#include "project/map_health.h"

namespace sward {

struct MapHealthView {
    bool open = false;
    uint64_t revision = 0;  // of the document, that the findings are of
    std::vector<MapFinding> findings;
    size_t maps = 0;  // that were looked through
};

}  // namespace sward
