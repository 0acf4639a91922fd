// Forms of a formula in compute shaders: their outputs, and how long they take. One program a form and one that loads
// as much and computes nothing. Does not: judge or choose how much to run. Cost: 20 to 100 ms a program.
#pragma once
#include "formulas/kernels.h"
#include "gpu/program.h"

namespace sward {

// How much one dispatch evaluates: groups of kKernelGroup invocations, each of which goes through `steps` inputs.
inline constexpr int kKernelGroup = 32, kMaxKernelGroups = 2048;
struct KernelGrid {
    int groups = 1, steps = 1;
    // Evaluations of the formula in one dispatch.
    double evaluations() const { return double(groups) * kKernelGroup * steps; }
};

class KernelBench {
  public:
    // Needs a current context. Failed with the compiler's log.
    static Result<KernelBench> make(Gpu& gpu, const Kernel& kernel);
    // Outputs of form number `form` for the kernel's samples, in the order of runSingle (formulas/formula_rows.h).
    std::vector<double> outputs(size_t form);
    // Seconds of one dispatch, from an idle GPU to an idle GPU.
    double seconds(size_t form, KernelGrid grid) { return dispatch(forms_[form], grid); }
    // Seconds of a dispatch that loads the inputs and computes nothing.
    double emptySeconds(KernelGrid grid) { return dispatch(empty_, grid); }

  private:
    double dispatch(GLuint program, KernelGrid grid);
    Programs programs_;
    std::vector<GLuint> forms_;
    GLuint empty_ = 0;
    int samples_ = 0, outputs_ = 0;
    Buffer in_, out_, sums_;
};

}  // namespace sward
