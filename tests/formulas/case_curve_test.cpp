// Hard cases along their variables: ours is true wherever the slider goes, the printed form is not.
#include "formulas/case_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "formulas/hardcases.h"
#include "sources.h"

namespace sward {
namespace {

const HardCase& caseOf(const std::string& key) {
    static const std::vector<HardCase> all = hardCases();
    for (const HardCase& h : all)
        if (h.key == key) return h;
    ADD_FAILURE() << "no case " << key;
    return all.front();
}

TEST(CaseCurves, EachRowOfHardCasesHasACurveOrAReason) {
    const std::vector<HardCaseRow> rows = runHardCases(nullptr);
    const std::vector<HardCase> cases = hardCases();
    ASSERT_EQ(cases.size(), rows.size());
    std::set<std::string> keys;
    for (size_t i = 0; i < rows.size(); ++i) {
        const HardCase& h = cases[i];
        EXPECT_EQ(h.row.id, rows[i].id);
        EXPECT_EQ(h.row.name, rows[i].name);
        EXPECT_TRUE(keys.insert(h.key).second) << h.key;
        EXPECT_NE(isSwept(h), !h.curve.whyNot.empty()) << h.key << ": a curve or a reason, one of both";
        EXPECT_FALSE(h.curve.picture.empty()) << h.key;
        EXPECT_FALSE(h.curve.where.empty()) << h.key;
        if (!isSwept(h)) continue;
        EXPECT_FALSE(h.curve.variable.empty()) << h.key;
        EXPECT_FALSE(h.curve.value.empty()) << h.key;
        EXPECT_LT(h.curve.output, h.row.outputs) << h.key;
    }
}

TEST(CaseCurves, EachCurveIsOfARowOfTheTable) {
    for (const CaseCurve& c : caseCurves()) {
        size_t rows = 0;
        for (const HardCase& h : hardCases()) rows += h.row.id == c.id && (c.name.empty() || c.name == h.row.name);
        EXPECT_GT(rows, 0u) << c.id << ' ' << c.name;
    }
}

TEST(CaseCurves, EachNamesAFormulaThatStandsInItsFile) {
    for (const HardCase& h : hardCases()) {
        const auto file = std::filesystem::path(SWARD_SOURCE_DIR) / "shaders/numerics" / h.curve.source;
        bool found = false;
        for (const std::string& line : test::linesOf(file))
            found |= line.starts_with("FN ") && line.find(" " + h.curve.function + "(") != std::string::npos;
        EXPECT_TRUE(found) << h.key << ": " << file << ' ' << h.curve.function;
    }
}

TEST(CaseCurves, OursStaysWithinItsToleranceAllAlongAndInRange) {
    for (const HardCase& h : hardCases()) {
        if (!isSwept(h)) continue;
        const std::vector<CasePoint> points = sweepCase(h);
        EXPECT_GT(points.size(), 30u) << h.key;
        for (const CasePoint& p : points) {
            EXPECT_LE(p.oursError, h.row.tolerance) << h.key << " at " << p.at;
            EXPECT_EQ(outOfRange(h.row, p.ours), 0) << h.key << " at " << p.at;
        }
    }
}

TEST(CaseCurves, EveryPrintedFormFailsSomewhereAlongItsCurve) {
    for (const HardCase& h : hardCases()) {
        if (!isSwept(h) || !h.row.published) continue;
        size_t failing = 0;
        for (const CasePoint& p : sweepCase(h)) failing += !(p.publishedError <= h.row.tolerance);
        EXPECT_GT(failing, 0u) << h.key << ": the curve does not show what is hard";
    }
}

TEST(CaseCurves, TheSunAtNoonIsNoNumberAsPrintedAndOneInOurs) {
    const CasePoint noon = caseAt(caseOf("B-1"), 0);
    EXPECT_TRUE(std::isnan(noon.published[0]));
    EXPECT_TRUE(std::isnan(noon.publishedError));
    EXPECT_EQ(noon.ours, (std::vector<double>{0, 1, 0, 0, 0}));
    EXPECT_EQ(noon.oursError, 0);
    const CasePoint later = caseAt(caseOf("B-1"), 30);
    EXPECT_LT(later.publishedError, 1e-3) << "away from noon it is nearly right";
}

TEST(CaseCurves, WindIsHeldAgainstThePrintedFormInDoubleAtTheExactPlace) {
    double near = 0, far = 0;
    for (const CasePoint& p : sweepCase(caseOf("J-1"))) {
        double& worst = p.at < 100 ? near : far;
        worst = std::max(worst, p.publishedError);
        EXPECT_LT(p.oursError, 4e-6) << p.at;
    }
    EXPECT_LT(near, 1e-3);
    EXPECT_GT(far, 0.03) << "a tenth of the wind";
}

TEST(CaseCurves, AfterTenHoursTicksAreExactAndAddedTimeIsSecondsOff) {
    const CasePoint p = caseAt(caseOf("T-3"), 10);
    EXPECT_LT(p.oursError, 2e-7);
    EXPECT_GT(p.publishedError, 1e-3);
}

TEST(CaseCurves, SharesAndValuesAreEachOthersReverse) {
    for (const HardCase& h : hardCases()) {
        if (!isSwept(h)) continue;
        for (const double share : {0.1, 0.35, 0.5, 0.9, 1.0})
            EXPECT_NEAR(shareOn(h.curve, valueAt(h.curve, share)), share, 1e-9) << h.key;
        EXPECT_EQ(valueAt(h.curve, 0), h.curve.zero ? 0 : h.curve.low) << h.key;
        EXPECT_EQ(valueAt(h.curve, 1), h.curve.high) << h.key;
        EXPECT_GE(shareOn(h.curve, -1e9), 0) << h.key;
    }
}

TEST(CaseCurves, SweepsRiseHoldTheHardPointsAndKeepWholeNumbersWhole) {
    const std::vector<CasePoint> lod = sweepCase(caseOf("B-8"), 50);
    size_t hard = 0;
    for (size_t i = 0; i < lod.size(); ++i) {
        hard += lod[i].at == 10;
        if (i > 0) EXPECT_GT(lod[i].at, lod[i - 1].at);
    }
    EXPECT_EQ(hard, 1u);
    for (const CasePoint& p : sweepCase(caseOf("B-25"))) EXPECT_EQ(p.at, std::round(p.at));
    EXPECT_EQ(caseAt(caseOf("B-25"), 7.4).at, 7);
    EXPECT_EQ(caseAt(caseOf("B-1"), -3).at, 0) << "left of the axis is 0 where it has that";
    EXPECT_EQ(caseAt(caseOf("B-8"), 1e9).at, 40);
    EXPECT_EQ(sweepCase(caseOf("B-1"), 50).front().at, 0);
}

}  // namespace
}  // namespace sward
