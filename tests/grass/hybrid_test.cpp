// The hybrid's distances by pixels: what they are in pictures of other sizes, what a sweep and a fit try.
#include "grass/hybrid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields.h"
#include "support.h"

namespace sward::test {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();

FlatField byPixels() {
    FlatField f;
    f.technique = "hybrid";
    f.hybrid.tiersBy = TiersBy::Pixels;
    f.species[0].width = 0.004f, f.species[0].height = 0.1f;
    return f;
}

TEST(TiersByPixels, ABladeIsAsWideAndGrassAsHighAsAskedWhereTheyEnd) {
    FlatField f = byPixels();
    for (const float perMetre : {200.0f, 665.0f, 4000.0f}) {
        const HybridTiers t = tiersSeen(f.asField(), perMetre);
        EXPECT_NEAR(0.004f * perMetre / t.maxGeom, 0.5f, 1e-5f);
        EXPECT_NEAR(0.1f * perMetre / t.maxBTF, 2, 1e-5f);
        EXPECT_NEAR(t.minGeom / t.maxGeom, f.hybrid.minGeom / f.hybrid.maxGeom, 1e-5f) << "the fade's share stays";
        EXPECT_NEAR(t.minBTF / t.maxBTF, f.hybrid.minBTF / f.hybrid.maxBTF, 1e-5f);
    }
    f.hybrid.tiersBy = TiersBy::Metres;
    for (const float perMetre : {200.0f, 4000.0f})
        EXPECT_EQ(tiersSeen(f.asField(), perMetre).maxGeom, f.hybrid.maxGeom);
}

TEST(TiersByPixels, TheMeanBladeIsThatOfAllBlades) {
    GrassField f;
    f.species = {Species{}, Species{}};
    f.species[0].bladesPerM2 = 3000, f.species[0].width = 0.002f, f.species[0].height = 0.1f;
    f.species[1].bladesPerM2 = 1000, f.species[1].width = 0.006f, f.species[1].height = 0.5f;
    EXPECT_NEAR(bladeSize(f).width, 0.003f, 1e-7f);
    EXPECT_NEAR(bladeSize(f).height, 0.2f, 1e-6f);
    f.species.clear();
    EXPECT_EQ(bladeSize(f).width, 0);
}

TEST(TiersByPixels, WhatNeverEndsOrIsLeftOutStaysSoAndSlicesEndBeyondBlades) {
    FlatField f = byPixels();
    f.hybrid.minGeom = f.hybrid.maxGeom = kInf;
    EXPECT_EQ(tiersSeen(f.asField(), 665).maxGeom, kInf);
    EXPECT_EQ(tiersSeen(f.asField(), 665).minGeom, kInf);
    f.hybrid.minGeom = f.hybrid.maxGeom = 0;
    EXPECT_EQ(tiersSeen(f.asField(), 665).maxGeom, 0);
    f.hybrid.minBTF = f.hybrid.maxBTF = 0;
    EXPECT_EQ(tiersSeen(f.asField(), 665).maxBTF, 0);
    FlatField low = byPixels();
    low.hybrid.slicePixels = 1000;  // nearer than blades end
    const HybridTiers t = tiersSeen(low.asField(), 665);
    EXPECT_LE(t.maxGeom, t.minBTF);
    EXPECT_LT(t.minBTF, t.maxBTF);
    low.species.clear();
    EXPECT_EQ(tiersSeen(low.asField(), 665).maxGeom, low.hybrid.maxGeom) << "nothing to be seen: the metres";
}

// Blades and their images are each other's rest at every distance, so that no blade is drawn twice or not at all.
TEST(TiersByPixels, BladesAndSlicesStillShareEveryDistance) {
    for (const float perMetre : {200.0f, 665.0f}) {
        const FieldTiers t = tiersOf(tables().techniques, byPixels().asField(), perMetre);
        EXPECT_EQ(t.blades.min, t.images.min);
        EXPECT_EQ(t.blades.inv, t.images.inv);
        EXPECT_EQ(t.slicesFrom, t.blades.min);
        EXPECT_EQ(t.slicesTo, t.flat.max);
    }
}

TEST(TiersByPixels, SweepsAndFitsTurnPixels) {
    FlatField f = byPixels();
    for (const char* name : {"hybrid", "slices"}) {
        const TechniqueRow& row = *findTechnique(tables().techniques, name);
        bool farther = false;
        for (const SettingValues& values : row.sweep(f.asField()))
            for (const std::string& v : values) {
                EXPECT_NE(v.substr(0, 7), "maxGeom") << "metres do nothing here";
                EXPECT_NE(v.substr(0, 6), "maxBTF");
                farther = farther || v == "slicePixels=1";
            }
        EXPECT_TRUE(farther) << name;
    }
    const TechniqueRow& hybrid = *findTechnique(tables().techniques, "hybrid");
    std::vector<double> knobs;
    for (const KnobRow& k : hybrid.knobs) knobs.push_back(std::string(k.name) == "near" ? 2 : k.start);
    const SettingValues turned = hybrid.turned(f.asField(), knobs);
    EXPECT_EQ(turned[0], "bladePixels=0.25") << "twice as far";
    EXPECT_EQ(turned[1], "slicePixels=2");
}

}  // namespace
}  // namespace sward::test
