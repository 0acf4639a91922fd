// The rows of all components, which loading, saving and checking of projects ask for.
#pragma once
#include <span>

#include "techniques.h"

namespace sward {

inline std::span<const ComponentRow> rows() { return tables().components; }

}  // namespace sward
