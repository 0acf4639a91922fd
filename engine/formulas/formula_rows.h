// The table of formulas: one row a formula, whose body is written once and runs in float, in double and on the GPU.
// Tests and `sward hardcases` read the same rows. Does not: run anything on the GPU (formulas/formula_gpu.h does).
#pragma once
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "core/numerics.h"
#include "formulas/expected_values.h"

namespace sward {

// A body reads x[0..inputs) and writes y[0..outputs), calling formulas of shaders/numerics/.
struct FormulaBody {
    void (*single)(const float* x, float* y) = nullptr;
    void (*twice)(const double* x, double* y) = nullptr;
    const char* text = "";  // the body's lines, for a compute shader
    // False where a row has no such body.
    explicit operator bool() const { return single != nullptr; }
};

// What a body is tried on: `count` times `inputs` numbers, each exactly a float, and `outputs` wanted ones. A wanted
// NaN is not compared. scale: the unit of each error, 1 where errors are absolute.
struct FormulaSamples {
    int count = 0;
    std::vector<double> x;
    std::vector<double> want;
    std::vector<double> scale;
    // Rounds the inputs to float.
    void add(const std::vector<double>& in, const std::vector<double>& out, const std::vector<double>& units = {});
};

// |got - want| / scale, or another measure of the row's own.
using FormulaError = double (*)(double got, double want, double scale);

struct FormulaRow {
    std::string id = "";  // of the hard case, as "B-1"; empty: no hard case, but CPU and GPU must still agree
    std::string name;     // what is computed
    int inputs = 0;
    int outputs = 0;
    FormulaBody ours;
    FormulaBody published = {};  // may be missing
    // Wanted values come from the file, or from the double form of `ours` where the sampler leaves `want` empty.
    std::function<FormulaSamples(const ExpectedValues&)> samples;
    double tolerance = 0;        // of the float form
    double gpuTolerance = 0;     // of the GPU; 0: the same
    double methodTolerance = 0;  // of the double form: the method's own error; 0: 1e-12
    double low = -1e300;         // every output lies in [low, high]
    double high = 1e300;
    FormulaError error = nullptr;  // nullptr: the absolute difference in units of scale
};

// All rows, hard cases in the order of their ids.
std::vector<FormulaRow> formulaRows();

// The row's samples with every wanted value filled in.
FormulaSamples samplesOf(const FormulaRow& row, const ExpectedValues& values);

// The largest error of outputs against the samples; NaN if an output is NaN where a number is wanted.
double largestError(const FormulaRow& row, const FormulaSamples& samples, const std::vector<double>& outputs);
// How many outputs are not finite or outside [low, high].
int outOfRange(const FormulaRow& row, const std::vector<double>& outputs);

// Outputs of a body for all samples, `outputs` numbers a sample one after the other: in float, widened to double.
std::vector<double> runSingle(const FormulaRow& row, const FormulaBody& body, const FormulaSamples& samples);
// The outputs computed in double.
std::vector<double> runDouble(const FormulaRow& row, const FormulaBody& body, const FormulaSamples& samples);

}  // namespace sward
