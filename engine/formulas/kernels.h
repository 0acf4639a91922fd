// What the formulas cost: each with every form it has (published, ours, the cheaper ones), how far each is from the
// double version over one set of inputs, and how long an evaluation takes on the CPU and in a compute shader. Inputs:
// the row's own samples, which are the hard points or a sweep with them, and for formulas over a continuous domain some
// thousand more (kernel_domains.cpp); the same on every machine. Times: of evaluations in float, one after the other
// over the inputs, less those of a kernel that loads as much and computes nothing; the forms of a formula in turn,
// round by round, so that a change of the machine's load meets all alike; a round keeps the least of nine tries, so
// that another program's turn is not counted. On the CPU a form is called through a pointer, as the empty one is:
// nothing is inlined or vectorised. In shaders wall clock with one finish a dispatch. Does not: judge (hardcases.h
// does). Cost: 128 forms at 5 rounds take 5 s on the CPU, 25 s more with a software GPU.
#pragma once
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/json.h"
#include "formulas/formula_rows.h"
#include "gpu/gpu.h"

namespace sward {

struct KernelForm {
    std::string name;  // "published", "ours", or which of several
    FormulaBody body;
    double tolerance = std::numeric_limits<double>::infinity();  // of its float form; infinite: none is promised
};
// A formula with its forms; row: its case, name, numbers of inputs and outputs, and measure of error.
struct Kernel {
    FormulaRow row;
    std::vector<KernelForm> forms;  // at least two
    FormulaSamples samples;
};
// Every formula that has more than one form, in the order of the table of formulas.
std::vector<Kernel> kernels(const ExpectedValues& values);
// More inputs for the row so named; without wanted values. Empty: the row's own are all.
FormulaSamples kernelDomain(const FormulaRow& row);

// Of one form. An input of which an output is not finite, and a finite one is wanted, counts as not finite and in no
// error.
struct KernelError {
    double largest = 0;         // not-a-number if no input gave finite outputs
    int notFinite = 0;          // inputs
    std::vector<double> at;     // the input of the largest error; empty: no error
    std::vector<double> fails;  // the first input that is not finite; empty: none
};
// Errors of one form against the kernel's samples. outputs: of runSingle, or of KernelBench::outputs.
KernelError kernelError(const Kernel& kernel, const std::vector<double>& outputs);

// Not-a-number: not taken.
struct KernelTime {
    double ns = std::numeric_limits<double>::quiet_NaN();      // median, at least 0
    double spread = std::numeric_limits<double>::quiet_NaN();  // half of what lies between the quartiles
    double times = std::numeric_limits<double>::quiet_NaN();   // of the formula's cheapest form; none where that one
                                                               // cannot be told from nothing
};
struct KernelRow {
    std::string id, formula, form;
    int inputs = 0;  // how many were tried
    double tolerance = std::numeric_limits<double>::infinity();
    KernelError cpu, shader;  // shader: meaningless without a GPU
    KernelTime cpuTime, shaderTime;
};
struct KernelRun {
    std::string renderer;  // empty: no GPU
    int rounds = 0;
    std::vector<KernelRow> rows;
};

struct KernelRequest {
    int rounds = 5;
    std::string only;  // formulas whose name contains this; empty: all
};
// What is being measured and which share is done; false stops.
using KernelProgress = std::function<bool(const std::string& what, double share)>;

// gpu may be null: CPU only. Errors: Unsound, expected values that cannot be read; Failed, a shader that does not
// compile; Interrupted.
Result<KernelRun> measureKernels(const KernelRequest& request, Gpu* gpu, const KernelProgress& progress);

// --- as files
// A heading a formula and an aligned line a form.
std::string kernelText(const KernelRun& run);
// A line a form; what was not taken is empty, inputs are numbers parted by spaces.
inline constexpr const char* kKernelColumns =
    "case,formula,form,inputs,tolerance,error,error_at,not_finite,not_finite_at,ns_cpu,ns_cpu_spread,times_cpu,error_"
    "shader,"
    "not_finite_shader,ns_shader,ns_shader_spread,times_shader";
std::string kernelCsv(const KernelRun& run);
// {"sward", "renderer", "rounds", "rows": [...]} with the columns' names; what was not taken is null.
Json kernelJson(const KernelRun& run);

}  // namespace sward
