// Hard cases as the editor judges and shows them, without a GPU.
#include "app/hardcase_run.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/frame_clock.h"

namespace sward {
namespace {

struct HardCaseRuns : testing::Test {
    void look(int frames) {
        for (int i = 0; i < frames; ++i) {
            run.looked = true;
            followHardCases(run, nullptr, clock);
        }
    }
    size_t place(const std::string& key) const {
        for (size_t i = 0; i < run.cases.size(); ++i)
            if (run.cases[i].key == key) return i;
        ADD_FAILURE() << "no case " << key;
        return 0;
    }
    HardCaseRun run;
    FrameClock clock;
};

TEST_F(HardCaseRuns, NothingIsMadeUntilSomebodyLooks) {
    followHardCases(run, nullptr, clock);
    EXPECT_TRUE(run.cases.empty());
    look(1);
    EXPECT_FALSE(run.cases.empty());
    EXPECT_EQ(run.results.size(), 1u) << "one row a frame";
    followHardCases(run, nullptr, clock);
    EXPECT_EQ(run.results.size(), 1u) << "nobody looks";
}

TEST_F(HardCaseRuns, EachRowIsJudgedAsTheTableDoes) {
    look(1);
    look(static_cast<int>(run.cases.size()));
    EXPECT_FALSE(judging(run));
    const std::vector<HardCaseRow> table = runHardCases(nullptr);
    ASSERT_EQ(run.results.size(), table.size());
    for (size_t i = 0; i < table.size(); ++i) {
        EXPECT_EQ(run.results[i].name, table[i].name);
        EXPECT_EQ(run.results[i].pass, table[i].pass);
        EXPECT_EQ(run.results[i].oursCpu, table[i].oursCpu);
    }
    clock.wanted = 0;
    look(1);
    EXPECT_EQ(clock.wanted, 0) << "nothing is left to do";
}

TEST_F(HardCaseRuns, TheSliderBeginsWherePrintedFormsAreWorstAndMoves) {
    look(1);
    EXPECT_EQ(run.here.at, 0) << "noon";
    EXPECT_TRUE(std::isnan(run.here.published[0]));
    moveCase(run, 45);
    EXPECT_EQ(run.here.at, 45);
    EXPECT_TRUE(std::isfinite(run.here.published[0]));
    moveCase(run, 1e9);
    EXPECT_EQ(run.here.at, 90);
}

TEST_F(HardCaseRuns, AnotherCaseIsSweptOnceAndWhatHasNoCurveIsEmpty) {
    look(1);
    showCase(run, place("B-8"));
    moveCase(run, 3);
    EXPECT_EQ(run.here.at, 0) << "not before it is made";
    look(1);
    EXPECT_EQ(run.here.at, 10) << "no number where the range is empty";
    EXPECT_NE(run.source.find("lodWeightsPublished"), std::string::npos);
    showCase(run, place("J-3"));
    look(1);
    EXPECT_TRUE(run.points.empty());
    moveCase(run, 1);
    EXPECT_TRUE(run.here.ours.empty());
    showCase(run, 100000);
    EXPECT_EQ(run.shown, place("J-3")) << "there is no such case";
}

}  // namespace
}  // namespace sward
