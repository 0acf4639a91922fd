#include "formulas/formula_gpu.h"

#include "gpu/program.h"

namespace sward {

Result<std::vector<double>> runOnGpu(Gpu& gpu, const FormulaRow& row, const FormulaBody& body,
                                     const FormulaSamples& samples) {
    Programs programs;
    ProgramSources sources{"formulas/formula"};
    sources.compute = "formulas/formula.comp.glsl";
    const std::string constants =
        fmt::format("#define FORMULA_INPUTS {}\n#define FORMULA_OUTPUTS {}\n#define FORMULA_BODY {}\n", row.inputs,
                    row.outputs, body.text);
    const auto program = programs.get(sources, constants);
    if (!program) return program.error();

    const std::string owner = "formulas/formula";
    const std::vector<float> inputs(samples.x.begin(), samples.x.end());
    std::vector<float> outputs(static_cast<size_t>(samples.count) * static_cast<size_t>(row.outputs));
    const Buffer in = makeBuffer(gpu, owner, inputs.size() * sizeof(float), inputs.data());
    const Buffer out = makeBuffer(gpu, owner, outputs.size() * sizeof(float), nullptr);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, in.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, out.id());
    glUseProgram(*program);
    glUniform1i(0, samples.count);
    glDispatchCompute(static_cast<GLuint>((samples.count + 31) / 32), 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(out.id(), 0, static_cast<GLsizeiptr>(outputs.size() * sizeof(float)), outputs.data());
    glUseProgram(0);
    return std::vector<double>(outputs.begin(), outputs.end());
}

}  // namespace sward
