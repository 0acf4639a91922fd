// The table of contents: every component row and every effect row of the engine, side by side (techniques.cpp).
#pragma once
#include "scene/rows.h"

namespace sward {
const Tables& tables();
}
