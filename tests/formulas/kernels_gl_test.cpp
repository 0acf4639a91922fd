// Forms of formulas in compute shaders: the outputs that they were timed on are those of the CPU.
#include "formulas/kernels_gpu.h"

#include <gtest/gtest.h>

namespace sward {
namespace {

TEST(KernelsGl, FormsOfLightWeightsAreMeasuredInAShaderToo) {
    auto gpu = makeHeadlessGpu();
    ASSERT_TRUE(bool(gpu)) << gpu.error().text();
    const auto run =
        measureKernels({1, "light weights, eqs"}, gpu->get(), [](const std::string&, double) { return true; });
    ASSERT_TRUE(bool(run)) << run.error().text();
    ASSERT_EQ(run->rows.size(), 10u);
    EXPECT_EQ(run->renderer, (*gpu)->renderer);
    for (const KernelRow& r : run->rows) {
        EXPECT_GE(r.shaderTime.ns, 0) << r.form;
        if (r.form == "published") continue;
        EXPECT_EQ(r.shader.notFinite, 0) << r.form;
        EXPECT_LE(r.shader.largest, r.tolerance + 1e-5) << r.form;
    }
    EXPECT_EQ((*gpu)->errors, 0) << (*gpu)->lastError;
    EXPECT_TRUE((*gpu)->ledger.empty());
}

TEST(KernelsGl, AnInvocationGoesThroughInputsAndALoneStepKeepsOutputs) {
    auto gpu = makeHeadlessGpu();
    ASSERT_TRUE(bool(gpu)) << gpu.error().text();
    Kernel k;
    k.row.inputs = 2, k.row.outputs = 1;
    for (int i = 0; i < 50; ++i) k.samples.add({double(i), 1}, {double(i) + 1});
    k.forms.push_back({"sum", {nullptr, nullptr, "y[0] = x[0] + x[1];"}});
    auto bench = KernelBench::make(**gpu, k);
    ASSERT_TRUE(bool(bench)) << bench.error().text();
    EXPECT_EQ(bench->outputs(0), k.samples.want);
    EXPECT_GT(bench->seconds(0, {2, 100}), 0);
    EXPECT_GT(bench->emptySeconds({2, 100}), 0);
    k.forms[0].body.text = "y[0] = noSuchFormula(x[0]);";
    const auto faulty = KernelBench::make(**gpu, k);
    ASSERT_FALSE(bool(faulty));
    EXPECT_NE(faulty.error().text().find("noSuchFormula"), std::string::npos);
    EXPECT_EQ((*gpu)->errors, 0) << (*gpu)->lastError;
}

}  // namespace
}  // namespace sward
