// Rows of formulas: samples, measures of error, and what a row's outputs are held against.
#include "formulas/formula_rows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "formulas/formula_table.h"

namespace sward {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

// y = x^2, tried on what is listed.
FormulaRow square(std::vector<std::vector<double>> inputs, std::vector<std::vector<double>> want = {}) {
    return {
        .name = "square", .inputs = 1, .outputs = 1, .ours = BODY(y[0] = x[0] * x[0];),
        .samples = listed(std::move(inputs), std::move(want)), .low = 0, .high = 100
    };
}

TEST(FormulaErrors, AreRelativeRoundACircleOrOneSided) {
    EXPECT_NEAR(relativeError(11, 10, 1), 0.1, 1e-15);
    EXPECT_NEAR(relativeError(0.11, 0.1, 1), 0.01, 1e-15) << "absolute below the scale";
    EXPECT_NEAR(circleError(0.95, 0.05, 1), 0.1, 1e-15);
    EXPECT_NEAR(circleError(0.95, 0.05, 0.5), 0.2, 1e-15);
    EXPECT_EQ(excessError(3, 2, 2), 0.5);
    EXPECT_EQ(excessError(1, 2, 2), 0) << "less is fine";
    EXPECT_TRUE(std::isnan(excessError(kNoNumber, 2, 2)));
}

TEST(FormulaRows, WantedValuesAreThoseListedElseTheDoubleForms) {
    const FormulaSamples own = samplesOf(square({{3}, {4}}), {});
    EXPECT_EQ(own.want, (std::vector<double>{9, 16}));
    EXPECT_EQ(own.scale, (std::vector<double>{1, 1}));
    EXPECT_EQ(samplesOf(square({{3}}, {{7}}), {}).want, std::vector<double>{7});
    EXPECT_EQ(samplesOf(square({{0.1}}), {}).x, std::vector<double>{static_cast<double>(0.1f)}) << "inputs are floats";
}

TEST(FormulaRows, TheLargestErrorIsFoundAndWhatIsNoNumberIsOne) {
    const FormulaRow row = square({{1}, {2}, {3}}, {{1}, {4}, {kNoNumber}});
    const FormulaSamples samples = samplesOf(row, {});
    EXPECT_EQ(largestError(row, samples, {1, 4, 9}), 0) << "a wanted NaN is not compared";
    EXPECT_EQ(largestError(row, samples, {1.5, 4.25, 9}), 0.5);
    EXPECT_TRUE(std::isnan(largestError(row, samples, {1, kNoNumber, 9})));
    EXPECT_EQ(outOfRange(row, {0, 100, -1, 101, kNoNumber}), 3);
}

TEST(FormulaRows, BothFormsOfABodyRunOverAllSamples) {
    const FormulaRow row = square({{0.5}, {1.5}});
    const FormulaSamples samples = samplesOf(row, {});
    EXPECT_EQ(runSingle(row, row.ours, samples), (std::vector<double>{0.25, 2.25}));
    EXPECT_EQ(runDouble(row, row.ours, samples), (std::vector<double>{0.25, 2.25}));
}

// The row of a name, and its one sample of a group's record.
std::pair<FormulaRow, FormulaSamples> rowOf(const std::string& name, const std::string& group, ExpectedRecord record) {
    for (const FormulaRow& row : formulaRows())
        if (row.name == name) return {row, samplesOf(row, {{group, {std::move(record)}}})};
    ADD_FAILURE() << "no row " << name;
    return {};
}

TEST(FormulaRows, ALevelJustOverAWholeNumberMayBeOneLessAndNothingElse) {
    const auto passes = [](double d, double want, double got) {
        const auto [row, samples] = rowOf("tessellation level by distance", "tess_level",
                                          {{"s", {8}}, {"d", {d}}, {"dmax", {100}}, {"level", {want}}});
        return largestError(row, samples, {got}) <= row.tolerance;
    };
    const double over = static_cast<double>(99.99999237060547f);
    EXPECT_TRUE(passes(over, 1, 1));
    EXPECT_TRUE(passes(over, 1, 0));
    EXPECT_FALSE(passes(over, 1, 2)) << "one more";
    EXPECT_FALSE(passes(over, 1, 10));
    EXPECT_FALSE(passes(over, 3, 1)) << "two less";
    EXPECT_TRUE(passes(50, 4, 4));
    EXPECT_FALSE(passes(50, 4, 3)) << "a whole number is exact";
}

TEST(FormulaRows, PlacesOfASplineFarFromTheOriginMayBeHalfAStepOff) {
    const auto most = [](double at) {
        ExpectedRecord r;
        for (const char* name : {"left", "right"}) r[name] = std::vector<double>(9, at);
        r["side"] = {1, 0, 0}, r["u"] = {0.5}, r["v"] = {0.5};
        r["pos"] = std::vector<double>(3, at), r["T"] = r["B"] = r["N"] = {0, 0, 0};
        const auto [row, samples] = rowOf("frame of a blade between two splines", "spline_frames", r);
        return row.tolerance * samples.scale.at(0);
    };
    EXPECT_NEAR(most(0), 2e-6, 1e-12);
    EXPECT_NEAR(most(30), 4e-6, 1e-12);
    EXPECT_NEAR(most(90000), 0.00390625, 1e-9) << "floats lie 1/128 apart there";
}

TEST(FormulaRows, EachHasANameOfItsOwnAndABodyOfItsSize) {
    std::set<std::string> names;
    for (const FormulaRow& row : formulaRows()) {
        EXPECT_TRUE(names.insert(row.id + " " + row.name).second) << row.id << ' ' << row.name;
        EXPECT_TRUE(bool(row.ours)) << row.name;
        EXPECT_GT(row.inputs, 0) << row.name;
        EXPECT_GT(row.outputs, 0) << row.name;
        EXPECT_LE(row.low, row.high) << row.name << ": a bound that nothing meets";
    }
    EXPECT_GT(names.size(), 50u);
}

}  // namespace
}  // namespace sward
