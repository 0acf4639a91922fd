// The interval of a median of paired differences, against tables of the binomial distribution.
#include "cost/paired_frames.h"

#include <gtest/gtest.h>

namespace sward {
namespace {

std::vector<double> upTo(int n) {
    std::vector<double> v;
    for (int i = 1; i <= n; ++i) v.push_back(i);
    return v;
}
PairedDifference ofFirst(int n) { return pairedDifference(upTo(n), std::vector<double>(static_cast<size_t>(n), 0)); }

TEST(PairedFrames, SevenPairsHoldTheMedianBetweenLeastAndGreatest) {
    const PairedDifference d = ofFirst(7);
    EXPECT_EQ(d.median, 4);
    EXPECT_EQ(d.low, 1);
    EXPECT_EQ(d.high, 7);
    EXPECT_EQ(d.pairs, 7);
    EXPECT_DOUBLE_EQ(d.confidence, 1 - 2 * std::exp2(-7));  // all of them on one side
}

// Known ranks of the sign test's interval: of 9 pairs the 2nd and 8th (96.1%), of 15 the 4th and 12th (96.5%), of 20
// the 6th and 15th (95.9%).
TEST(PairedFrames, MorePairsDropTheOutermost) {
    EXPECT_EQ(ofFirst(8).low, 1);
    EXPECT_EQ(ofFirst(9).low, 2);
    EXPECT_EQ(ofFirst(9).high, 8);
    EXPECT_NEAR(ofFirst(9).confidence, 0.961, 0.0005);
    EXPECT_EQ(ofFirst(15).low, 4);
    EXPECT_NEAR(ofFirst(15).confidence, 0.965, 0.0005);
    EXPECT_EQ(ofFirst(20).low, 6);
    EXPECT_EQ(ofFirst(20).high, 15);
    EXPECT_EQ(ofFirst(20).median, 10.5);
    EXPECT_NEAR(ofFirst(20).confidence, 0.959, 0.0005);
    const PairedDifference many = ofFirst(1000);
    EXPECT_GE(many.confidence, 0.95);
    EXPECT_LT(many.confidence, 0.96);
    EXPECT_LT(many.high - many.low, 70);
}

TEST(PairedFrames, FewPairsSayHowLittleIsKnown) {
    EXPECT_EQ(pairedDifference({}, {}).pairs, 0);
    EXPECT_EQ(ofFirst(1).confidence, 0);
    EXPECT_EQ(ofFirst(1).median, 1);
    EXPECT_EQ(ofFirst(2).confidence, 0.5);
    EXPECT_EQ(pairedDifference(upTo(3), upTo(5)).pairs, 3) << "as many as both have";
}

TEST(PairedFrames, PeopleReadTwoDigitsAndTheInterval) {
    EXPECT_EQ(differenceText({0.8, 0.6, 1.1, 0.98, 7}), "0.80 ms (0.60 to 1.1)");
    EXPECT_EQ(differenceText({0.8, 0.6, 1.1, 0.98, 7}, true), "+0.80 ms (0.60 to 1.1)");
    EXPECT_EQ(differenceText({-123.4, -200, 0.001, 0.98, 7}, true), "-123 ms (-200 to 0)");
    EXPECT_EQ(differenceText({0.9999, 0.9999, 9.99, 0.98, 7}), "1.0 ms (1.0 to 10)");
}

// What meets both frames of a pair alike leaves no trace, however large it is.
TEST(PairedFrames, ALoadThatComesAndGoesCancels) {
    std::vector<double> with, without;
    for (int i = 0; i < 7; ++i) {
        const double load = 100.0 * (i % 3);
        without.push_back(10 + load), with.push_back(12 + load);
    }
    const PairedDifference d = pairedDifference(with, without);
    EXPECT_EQ(d.low, 2);
    EXPECT_EQ(d.high, 2);
}

}  // namespace
}  // namespace sward
