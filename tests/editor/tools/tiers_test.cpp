#include "editor/tools/tiers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace sward {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
const TierDistances kUsual{4, 12, 25, 40};

TEST(Tiers, ADragStopsAtItsNeighbours) {
    EXPECT_EQ(stoppedTier(kUsual, 1, 15), 15);
    EXPECT_EQ(stoppedTier(kUsual, 1, 100), 25);  // may meet the slices
    EXPECT_EQ(stoppedTier(kUsual, 1, 1), 4 + kTierGap);
    EXPECT_EQ(stoppedTier(kUsual, 2, 0), 12);
    EXPECT_EQ(stoppedTier(kUsual, 0, -5), 0);
    EXPECT_EQ(stoppedTier(kUsual, 3, 1e9), 1e6);
    EXPECT_EQ(stoppedTier(kUsual, 0, std::nan("")), 0);
    EXPECT_EQ(stoppedTier({4, kInf, kInf, kInf}, 0, 900), 900);
}

TEST(Tiers, ByPixelsAnEditSaysWhatIsSeenThere) {
    const BladeSize blades{0.004f, 0.1f};
    EXPECT_EQ(tierEdits(kUsual, TiersBy::Metres, blades, 600).size(), kTierCount);
    const std::vector<TierEdit> edits = tierEdits(kUsual, TiersBy::Pixels, blades, 600);
    ASSERT_EQ(edits.size(), kTierCount + 2);
    EXPECT_STREQ(edits[4].field, "bladePixels");
    EXPECT_NEAR(edits[4].value, 0.2, 1e-6);  // 0.004 m * 600 / 12 m
    EXPECT_NEAR(edits[5].value, 1.5, 1e-6);
    EXPECT_EQ(tierEdits({kInf, kInf, kInf, kInf}, TiersBy::Pixels, blades, 600).size(), kTierCount);
    EXPECT_EQ(tierEdits(kUsual, TiersBy::Pixels, {}, 600).size(), kTierCount) << "there is no blade to be seen";
}

TEST(Tiers, NeighboursOutOfOrderHoldNothingBack) {
    EXPECT_EQ(stoppedTier({20, 12, 5, 40}, 1, 13), 13);
    EXPECT_FALSE(tiersInOrder({20, 12, 5, 40}));
    EXPECT_EQ(stoppedTier({0, 0, 0, 40}, 1, 13), 0);  // in order, but there is no room
}

TEST(Tiers, ATypedDistancePushesTheOthersNoFartherThanItMust) {
    EXPECT_EQ(pushedTiers(kUsual, 1, 30), (TierDistances{4, 30, 30, 40}));
    EXPECT_EQ(pushedTiers(kUsual, 1, 50), (TierDistances{4, 50, 50, 50 + kTierGap}));
    EXPECT_EQ(pushedTiers(kUsual, 2, 3), (TierDistances{3 - kTierGap, 3, 3, 40}));
    EXPECT_EQ(pushedTiers(kUsual, 3, 0), (TierDistances{0, 0, 0, 0}));
    EXPECT_EQ(pushedTiers(kUsual, 1, kInf), (TierDistances{4, kInf, kInf, kInf}));
    EXPECT_EQ(pushedTiers(kUsual, 0, 5), (TierDistances{5, 12, 25, 40}));
}

TEST(Tiers, WhateverIsTypedOrDraggedTheOrderStays) {
    std::mt19937 random(5);
    const auto any = [&] { return std::pow(10.0, std::uniform_real_distribution<>(-2, 4)(random)); };
    TierDistances t = kUsual;
    for (int i = 0; i < 2000; ++i) {
        const size_t which = random() % kTierCount;
        if (i % 2)
            t = pushedTiers(t, which, i % 100 == 1 ? 0 : any());
        else
            t[which] = stoppedTier(t, which, any());
        ASSERT_TRUE(tiersInOrder(t)) << i;
    }
}

TEST(Tiers, TypingAnOrderedListInAnyOrderGivesIt) {
    const TierDistances wanted{1, 2, 2, 90};
    std::array<size_t, kTierCount> order{0, 1, 2, 3};
    do {
        TierDistances t = kUsual;
        for (const size_t i : order) t = pushedTiers(t, i, wanted[i]);
        EXPECT_EQ(t, wanted);
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Tiers, OrderingSortsAndParts) {
    EXPECT_EQ(orderedTiers({40, 4, 25, 12}), kUsual);
    const TierDistances parted = orderedTiers({5, 5, 5, 5});
    for (size_t i = 0; i < kTierCount; ++i)
        EXPECT_NEAR(parted[i], 5 + kTierGap * static_cast<double>((i + 1) / 2), 1e-9);
    EXPECT_TRUE(tiersInOrder(orderedTiers({kInf, 3, kInf, 1})));
}

TEST(Tiers, AHandMeansRoundDistances) {
    EXPECT_NEAR(roundedTier(3.4567), 3.45, 1e-9);
    EXPECT_NEAR(roundedTier(87.6543), 87.65, 1e-9);
    EXPECT_NEAR(roundedTier(432.1), 432, 1e-9);
    EXPECT_NEAR(roundedTier(4321), 4320, 1e-9);
    EXPECT_EQ(roundedTier(0), 0);
    EXPECT_EQ(roundedTier(-3), 0);
    EXPECT_EQ(roundedTier(kInf), kInf);
}

}  // namespace
}  // namespace sward
