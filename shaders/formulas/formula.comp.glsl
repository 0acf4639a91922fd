// Runs one row of the table of formulas on every sample. Defined ahead of this: FORMULA_INPUTS, FORMULA_OUTPUTS and
// FORMULA_BODY, which reads x[] and writes y[] (engine/formulas/formula_gpu.cpp).
#include "numerics/all.h"
#include "numerics/glsl.h"

layout(local_size_x = 32) in;
layout(std430, binding = 0) readonly buffer Inputs { float allInputs[]; };
layout(std430, binding = 1) writeonly buffer Outputs { float allOutputs[]; };
layout(location = 0) uniform int sampleCount;

void main() {
    int at = int(gl_GlobalInvocationID.x);
    if (at >= sampleCount) return;
    real x[FORMULA_INPUTS];
    real y[FORMULA_OUTPUTS];
    for (int i = 0; i < FORMULA_INPUTS; i++) x[i] = allInputs[at * FORMULA_INPUTS + i];
    for (int i = 0; i < FORMULA_OUTPUTS; i++) y[i] = 0.0;
    { FORMULA_BODY }
    for (int i = 0; i < FORMULA_OUTPUTS; i++) allOutputs[at * FORMULA_OUTPUTS + i] = y[i];
}
