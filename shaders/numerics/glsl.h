// Glue that makes the formulas of shaders/numerics/ GLSL. Include it first, then the formulas that are used.
// The C++ counterpart is engine/core/numerics.h.
#define FN
#define real float
#define OUT(T) out T
#define INOUT(T) inout T
