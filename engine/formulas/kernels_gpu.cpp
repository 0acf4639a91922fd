#include "formulas/kernels_gpu.h"

#include <algorithm>
#include <chrono>

namespace sward {
namespace {

Result<GLuint> programOf(Programs& programs, const FormulaRow& row, const char* body) {
    ProgramSources sources{"formulas/kernel"};
    sources.compute = "formulas/kernel.comp.glsl";
    return programs.get(sources,
                        fmt::format("#define FORMULA_INPUTS {}\n#define FORMULA_OUTPUTS {}\n#define FORMULA_BODY {}\n",
                                    row.inputs, row.outputs, body));
}

int groupsOf(int invocations) { return (invocations + kKernelGroup - 1) / kKernelGroup; }

}  // namespace

Result<KernelBench> KernelBench::make(Gpu& gpu, const Kernel& kernel) {
    KernelBench bench;
    const FormulaRow& row = kernel.row;
    for (const KernelForm& form : kernel.forms) {
        const auto program = programOf(bench.programs_, row, form.body.text);
        if (!program) return program.error();
        bench.forms_.push_back(*program);
    }
    const auto empty = programOf(bench.programs_, row, ";");
    if (!empty) return empty.error();
    bench.empty_ = *empty;
    bench.samples_ = kernel.samples.count;
    bench.outputs_ = row.outputs;

    const std::string owner = "formulas/kernel";
    const std::vector<float> inputs(kernel.samples.x.begin(), kernel.samples.x.end());
    const size_t invocations = size_t(std::max(groupsOf(bench.samples_), kMaxKernelGroups)) * kKernelGroup;
    bench.in_ = makeBuffer(gpu, owner, inputs.size() * sizeof(float), inputs.data());
    bench.out_ = makeBuffer(gpu, owner, size_t(bench.samples_) * size_t(row.outputs) * sizeof(float), nullptr);
    bench.sums_ = makeBuffer(gpu, owner, invocations * sizeof(float), nullptr);
    return bench;
}

std::vector<double> KernelBench::outputs(size_t form) {
    dispatch(forms_[form], {groupsOf(samples_), 1});
    std::vector<float> outputs(size_t(samples_) * size_t(outputs_));
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(out_.id(), 0, static_cast<GLsizeiptr>(outputs.size() * sizeof(float)), outputs.data());
    return std::vector<double>(outputs.begin(), outputs.end());
}

double KernelBench::dispatch(GLuint program, KernelGrid grid) {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, in_.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, out_.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, sums_.id());
    glUseProgram(program);
    glUniform1i(0, samples_);
    glUniform1i(1, grid.steps);
    glFinish();
    const auto start = std::chrono::steady_clock::now();
    glDispatchCompute(static_cast<GLuint>(grid.groups), 1, 1);
    glFinish();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    glUseProgram(0);
    return seconds;
}

}  // namespace sward
