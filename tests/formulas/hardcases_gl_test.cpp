// Every formula in a compute shader against its wanted values and against the CPU's float.
#include <gtest/gtest.h>

#include <cmath>

#include "formulas/formula_gpu.h"
#include "formulas/hardcases.h"

namespace sward {
namespace {

class HardCasesGl : public testing::Test {
  protected:
    void SetUp() override {
        auto made = makeHeadlessGpu();
        ASSERT_TRUE(bool(made)) << made.error().text();
        gpu = std::move(*made);
        auto loaded = loadExpectedValues(expectedValuesFile());
        ASSERT_TRUE(bool(loaded)) << loaded.error().text();
        values = std::move(*loaded);
    }
    void TearDown() override {
        if (gpu) {
            EXPECT_EQ(gpu->errors, 0) << gpu->lastError;
        }
    }
    std::unique_ptr<Gpu> gpu;
    ExpectedValues values;
};

double gpuTolerance(const FormulaRow& row) { return row.gpuTolerance > 0 ? row.gpuTolerance : row.tolerance; }

TEST_F(HardCasesGl, EveryFormulaIsTheSameInAComputeShader) {
    for (const FormulaRow& row : formulaRows()) {
        SCOPED_TRACE(row.id + " " + row.name);
        FormulaSamples s = samplesOf(row, values);
        const auto outputs = runOnGpu(*gpu, row, row.ours, s);
        ASSERT_TRUE(bool(outputs)) << outputs.error().text();
        EXPECT_LE(largestError(row, s, *outputs), gpuTolerance(row));
        EXPECT_EQ(outOfRange(row, *outputs), 0);
        // And the CPU's float: what the scale calls an error, of both together.
        s.want = runSingle(row, row.ours, s);
        EXPECT_LE(largestError(row, s, *outputs), gpuTolerance(row) + row.tolerance);
    }
}

TEST_F(HardCasesGl, HashesLevelsAndPartitionsAreBitForBit) {
    int exact = 0;
    for (const FormulaRow& row : formulaRows()) {
        if (gpuTolerance(row) > 0) continue;
        const FormulaSamples s = samplesOf(row, values);
        const auto outputs = runOnGpu(*gpu, row, row.ours, s);
        ASSERT_TRUE(bool(outputs)) << outputs.error().text();
        EXPECT_EQ(*outputs, runSingle(row, row.ours, s)) << row.name;
        ++exact;
    }
    EXPECT_GE(exact, 10);
}

TEST_F(HardCasesGl, ShaderFaultsNameTheBody) {
    FormulaRow row = formulaRows().front();
    row.ours.text = "y[0] = noSuchFormula(x[0]);";
    const auto outputs = runOnGpu(*gpu, row, row.ours, samplesOf(row, values));
    ASSERT_FALSE(bool(outputs));
    EXPECT_NE(outputs.error().text().find("noSuchFormula"), std::string::npos);
}

TEST_F(HardCasesGl, AWrongShaderIsFound) {
    FormulaRow row = formulaRows().front();
    const FormulaSamples s = samplesOf(row, values);
    row.ours.text = "y[0] = x[0]; y[1] = x[1]; y[2] = x[2];";
    const auto outputs = runOnGpu(*gpu, row, row.ours, s);
    ASSERT_TRUE(bool(outputs));
    EXPECT_GT(largestError(row, s, *outputs), gpuTolerance(row));
}

TEST_F(HardCasesGl, TheReportPassesAndSaysWhatTheGpuDid) {
    const auto rows = runHardCases(gpu.get());
    for (const HardCaseRow& r : rows) {
        EXPECT_TRUE(r.pass) << r.id << ' ' << r.name << ": CPU " << r.oursCpu << " GPU " << r.oursGpu << r.fault;
        EXPECT_TRUE(r.hasGpu);
    }
    EXPECT_EQ(hardCasesJson(rows).find("\"ours_gpu\": null"), std::string::npos);
}

}  // namespace
}  // namespace sward
