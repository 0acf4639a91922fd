// The table of contents: every component row and every effect row of the engine, side by side (techniques.cpp).
#pragma once
#include "scene/rows.h"

namespace sward {
// All rows; made once, the same for the whole run.
const Tables& tables();
}  // namespace sward
