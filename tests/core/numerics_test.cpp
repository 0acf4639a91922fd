// Every row of the table of formulas against its wanted values, in float and in double; finiteness for special values.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "formulas/formula_rows.h"

namespace sward {
namespace {

const ExpectedValues& expected() {
    static const ExpectedValues values = [] {
        auto loaded = loadExpectedValues(SWARD_SOURCE_DIR "/tests/data/hard-cases-expected.json");
        EXPECT_TRUE(bool(loaded));
        return loaded ? *loaded : ExpectedValues{};
    }();
    return values;
}

std::string title(const FormulaRow& row) { return row.id + " " + row.name; }

TEST(NumericsTable, EveryRowHasSamplesOfItsShape) {
    for (const FormulaRow& row : formulaRows()) {
        SCOPED_TRACE(title(row));
        const FormulaSamples s = samplesOf(row, expected());
        EXPECT_GT(s.count, 0);
        EXPECT_EQ(s.x.size(), size_t(s.count) * size_t(row.inputs));
        EXPECT_EQ(s.want.size(), size_t(s.count) * size_t(row.outputs));
        EXPECT_EQ(s.scale.size(), s.want.size());
        for (double v : s.x) EXPECT_TRUE(std::isnan(v) || double(float(v)) == v) << v << " is no float";
    }
}

TEST(NumericsTable, FloatFormsStayWithinTheirTolerances) {
    for (const FormulaRow& row : formulaRows()) {
        const FormulaSamples s = samplesOf(row, expected());
        const auto outputs = runSingle(row, row.ours, s);
        EXPECT_LE(largestError(row, s, outputs), row.tolerance) << title(row);
        EXPECT_EQ(outOfRange(row, outputs), 0) << title(row);
    }
}

TEST(NumericsTable, DoubleFormsShowTheErrorOfTheMethodOnly) {
    for (const FormulaRow& row : formulaRows()) {
        const FormulaSamples s = samplesOf(row, expected());
        const auto outputs = runDouble(row, row.ours, s);
        EXPECT_LE(largestError(row, s, outputs), row.methodTolerance > 0 ? row.methodTolerance : 1e-12) << title(row);
        EXPECT_EQ(outOfRange(row, outputs), 0) << title(row);
    }
}

TEST(NumericsTable, PublishedFormsBreakWhereOursHold) {
    for (const FormulaRow& row : formulaRows()) {
        if (!row.published) continue;
        const FormulaSamples s = samplesOf(row, expected());
        const double error = largestError(row, s, runSingle(row, row.published, s));
        EXPECT_FALSE(error <= row.tolerance) << title(row) << ": " << error;
    }
}

TEST(NumericsTable, EveryGroupOfTheExpectedValuesIsChecked) {
    ASSERT_EQ(expected().size(), 12u);
    for (const auto& [group, records] : expected()) {
        ExpectedValues without = expected();
        without.erase(group);
        int users = 0;
        for (const FormulaRow& row : formulaRows()) users += row.samples(without).count < row.samples(expected()).count;
        EXPECT_GT(users, 0) << group;
    }
}

TEST(NumericsTable, WrongFormulasAreFound) {
    for (FormulaRow row : formulaRows()) {
        const FormulaSamples s = samplesOf(row, expected());
        auto outputs = runSingle(row, row.ours, s);
        outputs[outputs.size() / 2] = std::nan("");
        EXPECT_GT(outOfRange(row, outputs), 0) << title(row);
    }
    FormulaRow row = formulaRows().front();
    const FormulaSamples s = samplesOf(row, expected());
    row.ours.single = [](const float* x, float* y) { y[0] = x[0], y[1] = x[1], y[2] = x[2], y[3] = y[4] = 0; };
    EXPECT_GT(largestError(row, s, runSingle(row, row.ours, s)), row.tolerance);
}

TEST(NumericsTable, ExpectedValuesThatCannotBeReadAreAnError) {
    const auto missing = loadExpectedValues("/nowhere/expected.json");
    ASSERT_FALSE(bool(missing));
    EXPECT_EQ(missing.error().file, "/nowhere/expected.json");
}

// Zeros, subnormals, neighbours of 1, huge and tiny numbers of both signs.
std::vector<float> specials() {
    std::vector<float> v = {0.0f};
    for (float x :
         {1e-45f,      1e-40f, 1.17549435e-38f, 1e-30f,      1e-23f, 1e-12f, 1e-7f, 0.25f, 0.5f,   0.99999994f, 1.0f,
          1.00000012f, 3.0f,   255.0f,          16777216.0f, 1e10f,  1e18f,  1e23f, 1e30f, 3.4e38f})
        v.insert(v.end(), {x, -x});
    v.push_back(-0.0f);
    return v;
}

bool unit(float x) { return x >= 0 && x <= 1; }

TEST(NumericsFuzz, LightWeightsOfAllTriplesAreInUnitRangeAndSumToOne) {
    const auto v = specials();
    for (float x : v)
        for (float y : v)
            for (float z : v) {
                const f32::LightWeights a = f32::lightWeights({x, y, z}), b = f32::lightWeightsFast({x, y, z});
                for (const auto& w : {a, b}) {
                    ASSERT_TRUE(unit(w.xPos) && unit(w.yPos) && unit(w.zPos) && unit(w.xNeg) && unit(w.zNeg))
                        << x << ' ' << y << ' ' << z;
                    ASSERT_NEAR(w.xPos + w.yPos + w.zPos + w.xNeg + w.zNeg, 1.0f, 2.4e-7f) << x << ' ' << y << ' ' << z;
                }
            }
}

TEST(NumericsFuzz, LevelsAndOpacitiesOfAllTriplesAreInUnitRange) {
    const auto v = specials();
    for (float a : v)
        for (float b : v)
            for (float c : v) {
                ASSERT_TRUE(unit(f32::lodRamp(a, b, f32::lodInverse(b, c)))) << a << ' ' << b << ' ' << c;
                ASSERT_TRUE(unit(f32::opacityEq5(a, b, c))) << a << ' ' << b << ' ' << c;
                ASSERT_TRUE(unit(f32::opacityConserving(a, b, c))) << a << ' ' << b << ' ' << c;
                ASSERT_TRUE(unit(f32::brushWeight(a, b, c)) || a < 0) << a << ' ' << b << ' ' << c;
                ASSERT_GE(f32::tessLevel(std::min(std::abs(a), 1e6f), std::abs(b), c), 0);
                ASSERT_LE(f32::tessLevel(std::min(std::abs(a), 1e6f), std::abs(b), c), 64);
            }
}

TEST(NumericsFuzz, CorrectionsAndWrapsOfAllPairsAreInUnitRange) {
    const auto v = specials();
    for (float a : v) {
        ASSERT_GE(f32::wrapUnit(a), 0.0f) << a;
        ASSERT_LT(f32::wrapUnit(a), 1.0f) << a;
        ASSERT_TRUE(unit(f32::srgbEncode(a)) && unit(f32::srgbDecode(a))) << a;
        for (float b : v) {
            ASSERT_TRUE(unit(f32::opacityCorrected(a, b))) << a << ' ' << b;
            ASSERT_TRUE(unit(f32::correctionPow(a, b))) << a << ' ' << b;
            const glm::vec3 shown = f32::toneMapNeutral({a, b, 0.5f});
            ASSERT_TRUE(unit(shown.x) && unit(shown.y) && unit(shown.z)) << a << ' ' << b;
        }
    }
}

TEST(NumericsFuzz, UnitVectorsOfAllTriplesAreUnitOrTheFallback) {
    const auto v = specials();
    for (float x : v)
        for (float y : v)
            for (float z : v)
                ASSERT_NEAR(glm::length(f32::unitOr({x, y, z}, 1e-30f, {0, 1, 0})), 1.0f, 4e-7f)
                    << x << ' ' << y << ' ' << z;
}

}  // namespace
}  // namespace sward
