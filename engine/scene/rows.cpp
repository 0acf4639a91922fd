#include "scene/rows.h"

namespace sward {

const ComponentRow* findComponent(std::span<const ComponentRow> rows, std::string_view name) {
    for (const ComponentRow& row : rows)
        if (name == row.name) return &row;
    return nullptr;
}

}  // namespace sward
