// Every formula of shaders/numerics/, as C++: in float as sward::f32, in double as sward::f64. The lines are the very
// ones that the shaders include, so that what the CPU places, tests and traces is what the GPU draws. float gives the
// GPU's results up to rounding; double shows the error of the method. Does not: textures, bindings, state. Rules of the
// common subset: docs/numerics.md.
#pragma once
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

#define FN inline
#define OUT(T) T&
#define INOUT(T) T&
#define precise

#pragma GCC diagnostic push
#pragma GCC diagnostic error "-Wdouble-promotion"
#pragma GCC diagnostic error "-Wfloat-conversion"
namespace sward::f32 {
using real = float;
#include "core/numerics_builtins.h"
#include "numerics/all.h"
}  // namespace sward::f32
#pragma GCC diagnostic pop

namespace sward::f64 {
using real = double;
#include "core/numerics_builtins.h"
#include "numerics/all.h"
}  // namespace sward::f64

#undef FN
#undef OUT
#undef INOUT
#undef precise
