// Changed pixels, their picture and their order, without drawing.
#include "cost/effect_probe.h"

#include <gtest/gtest.h>

namespace sward {
namespace {

EffectFound found(uint64_t changed, double low, double median, const std::string& error = {}) {
    EffectFound e;
    e.changed = changed, e.ms.low = low, e.ms.median = median, e.error = error;
    return e;
}

TEST(EffectProbe, APixelChangesAsItsMostChangedChannel) {
    EXPECT_EQ(changesBetween({10, 20, 30, 0, 0, 0}, {10, 25, 28, 0, 0, 255}), (std::vector<uint8_t>{5, 255}));
    EXPECT_TRUE(changesBetween({}, {}).empty());
}

TEST(EffectProbe, WhatCostsUnseenComesFirstAndWhatFailedLast) {
    std::vector<EffectFound> all{found(9, 1, 2),       found(0, -1, 3),    found(9, 4, 5),
                                 found(0, 0, 0, "no"), found(0, 0.1, 0.2), found(0, 1, 2)};
    sortEffects(all);
    std::vector<double> medians;
    for (const EffectFound& e : all) medians.push_back(e.ms.median);
    EXPECT_EQ(medians, (std::vector<double>{2, 0.2, 3, 5, 2, 0}));
    EXPECT_TRUE(all[0].costsUnseen());
    EXPECT_FALSE(all[2].costsUnseen()) << "it may cost nothing";
    EXPECT_FALSE(all[5].costsUnseen());
}

TEST(EffectProbe, ThePictureShowsWhatCountsAndHowMuch) {
    EffectMap map;
    map.width = 4, map.height = 1;
    map.picture = std::vector<uint8_t>(12, 200);
    EffectFound e;
    EXPECT_TRUE(changePicture(map, e).empty()) << "it was not drawn";
    e.where = {1, 2, 33, 255};
    const std::vector<uint8_t> p = changePicture(map, e);
    const auto pixel = [&](size_t i) { return std::vector<uint8_t>(p.begin() + 3 * i, p.begin() + 3 * i + 3); };
    EXPECT_EQ(pixel(0), (std::vector<uint8_t>{100, 100, 100})) << "grey, half as bright";
    EXPECT_EQ(pixel(1), (std::vector<uint8_t>{255, 0, 0}));
    EXPECT_EQ(pixel(2), (std::vector<uint8_t>{255, 127, 0}));
    EXPECT_EQ(pixel(3), (std::vector<uint8_t>{255, 255, 0}));
}

}  // namespace
}  // namespace sward
