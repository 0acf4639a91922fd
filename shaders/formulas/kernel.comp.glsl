// Evaluates a form of a formula many times: each invocation goes through `steps` inputs, from its own on, and keeps the
// sum of all inputs and outputs. With one step the outputs themselves are kept too. Defined ahead of this:
// FORMULA_INPUTS, FORMULA_OUTPUTS and FORMULA_BODY, which reads x[] and writes y[] (engine/formulas/kernels_gpu.cpp).
#include "numerics/all.h"
#include "numerics/glsl.h"

layout(local_size_x = 32) in;
layout(std430, binding = 0) readonly buffer Inputs { float allInputs[]; };
layout(std430, binding = 1) writeonly buffer Outputs { float allOutputs[]; };
layout(std430, binding = 2) writeonly buffer Sums { float allSums[]; };
layout(location = 0) uniform int sampleCount;
layout(location = 1) uniform int steps;

void main() {
    int self = int(gl_GlobalInvocationID.x);
    int current = self % sampleCount;
    real x[FORMULA_INPUTS];
    real y[FORMULA_OUTPUTS];
    real total = 0.0;
    for (int turn = 0; turn < steps; turn++) {
        for (int i = 0; i < FORMULA_INPUTS; i++) {
            x[i] = allInputs[current * FORMULA_INPUTS + i];
            total += x[i];  // or a form that leaves out an input would load less than the empty one
        }
        for (int i = 0; i < FORMULA_OUTPUTS; i++) y[i] = 0.0;
        { FORMULA_BODY }
        for (int i = 0; i < FORMULA_OUTPUTS; i++) total += y[i];
        current = current + 1 < sampleCount ? current + 1 : 0;
    }
    allSums[self] = total;
    if (steps == 1 && self < sampleCount)
        for (int i = 0; i < FORMULA_OUTPUTS; i++) allOutputs[self * FORMULA_OUTPUTS + i] = y[i];
}
