// What the person has chosen in the outliner.
// Does not: hold what tools choose for themselves (tools/brush_book.h, tools/tier_view.h).
#pragma once
#include <string>

namespace sward {

struct Selection {
    std::string entity;     // by name; empty: none
    std::string newEntity;  // being typed in the outliner
};

}  // namespace sward
