// What the species panel keeps between frames. Does not: draw (panels/species.cpp).
#pragma once
#include <string>

namespace sward {

struct SpeciesPalette {
    std::string preset;          // the chosen row of speciesPresets(); empty: none
    std::string field, species;  // the entity and the species whose looks buttons change
};

}  // namespace sward
