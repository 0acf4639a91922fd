// Runs rows of the table of formulas in compute shaders: the GPU's answer to the inputs that the CPU was asked.
// Does not: judge. Cost: compiling one small program a row, 20 to 100 ms each.
#pragma once
#include "formulas/formula_rows.h"
#include "gpu/gpu.h"

namespace sward {

// The outputs of every sample, as runSingle gives them. Needs a current context. Failed with the compiler's log, whose
// lines name the files of shaders/numerics/.
Result<std::vector<double>> runOnGpu(Gpu& gpu, const FormulaRow& row, const FormulaBody& body,
                                     const FormulaSamples& samples);

}  // namespace sward
