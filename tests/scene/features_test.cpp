// The table of features: complete, in the order of the bits, each with what people and shaders call it.
#include "scene/features.h"

#include <gtest/gtest.h>

#include <set>

#include "grass/grass_fields.h"
#include "scene/components.h"
#include "techniques.h"

namespace sward {
namespace {

TEST(FeatureRows, HoldEveryFeatureOnceAndInTheOrderOfItsBits) {
    ASSERT_EQ(featureRows().size(), static_cast<size_t>(Feature::Count));
    for (size_t i = 0; i < featureRows().size(); ++i) EXPECT_EQ(featureRows()[i].feature, static_cast<Feature>(i));
}

TEST(FeatureRows, SayEverythingOfEachAndNothingTwice) {
    std::set<std::string> names, constants, texts;
    for (const FeatureRow& row : featureRows()) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_TRUE(constants.insert(featureConstant(row.feature)).second) << row.name;
        EXPECT_TRUE(texts.insert(row.help).second && texts.insert(row.absent).second) << row.name;
        EXPECT_EQ(std::string(row.name).find_first_not_of("abcdefghijklmnopqrstuvwxyz-"), std::string::npos)
            << row.name;
        EXPECT_GT(std::string(row.help).size(), 5u) << row.name;
        EXPECT_GT(std::string(row.absent).size(), 5u) << row.name;
    }
    EXPECT_STREQ(featureConstant(Feature::TerrainHeights), "TERRAIN_HEIGHTS");
    EXPECT_STREQ(featureName(Feature::ForceMap), "force-map");
}

TEST(FeatureRows, AComponentAsksForWhatIsOfAFieldOrForWhatIsOfTheScene) {
    EXPECT_TRUE(has(fieldFeatures(), Feature::GrassDensity) && has(fieldFeatures(), Feature::Translucency));
    EXPECT_FALSE(has(fieldFeatures(), Feature::Wind) || has(fieldFeatures(), Feature::Terrain));
    for (const ComponentRow& row : tables().components) {
        const FeatureSet asked = row.features(row.defaults());
        EXPECT_TRUE((asked & fieldFeatures()).none() || (asked & ~fieldFeatures()).none()) << row.name;
    }
}

}  // namespace
}  // namespace sward
