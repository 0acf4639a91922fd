// Effect maps as JSON, text and pictures.
#include "cost/effect_files.h"

#include <gtest/gtest.h>

#include "maps/map_io.h"
#include "scenes.h"
#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

EffectMap mapOfTwo() {
    EffectMap map;
    map.width = 2, map.height = 1;
    map.picture = {200, 200, 200, 100, 100, 100};
    EffectFound fog;
    fog.feature = Feature::Fog;
    fog.where = {0, 9}, fog.changed = 1, fog.share = 0.5, fog.greatest = 9;
    fog.ms = {0.8, 0.6, 1.1, 0.984375, 7};
    const Project p = test::lawn();
    fog.off = stepsWithout(p, p, tables(), Feature::Fog);
    fog.alsoOff = featureSet(Feature::Gusts);
    EffectFound broken;
    broken.feature = Feature::Wind, broken.error = "too many blades";
    map.effects = {fog, broken};
    return map;
}
Json fileOf(const EffectMap& map, const std::string& folder) {
    Json j;
    j["cameras"].push(effectMapJson(map, "human", folder));
    return *parseJson(writeJson(j), "effects.json");
}

TEST(EffectFiles, WhatIsWrittenIsReadAgain) {
    const auto lines = effectsFrom(fileOf(mapOfTwo(), "human"), "human");
    ASSERT_TRUE(lines) << lines.error().text();
    ASSERT_EQ(lines->size(), 2u);
    const EffectLine& fog = lines->at(0);
    EXPECT_EQ(fog.feature, Feature::Fog);
    EXPECT_EQ(fog.changed, 1u);
    EXPECT_EQ(fog.share, 0.5);
    EXPECT_EQ(fog.greatest, 9);
    EXPECT_EQ(fog.ms.median, 0.8);
    EXPECT_EQ(fog.ms.high, 1.1);
    EXPECT_EQ(fog.ms.pairs, 7);
    EXPECT_FALSE(fog.costsUnseen);
    EXPECT_EQ(fog.off, std::vector<std::string>{"haze.Fog.visibility = inf"});
    EXPECT_EQ(fog.picture, "human/fog.png");
    EXPECT_EQ(lines->at(1).error, "too many blades");
    EXPECT_EQ(lines->at(1).picture, "") << "it was not drawn";
    EXPECT_EQ(effectsFrom(fileOf(mapOfTwo(), ""), "human")->at(0).picture, "");
}

TEST(EffectFiles, WhatIsNoEffectMapIsRefused) {
    EXPECT_FALSE(effectsFrom(Json::makeObject(), "human"));
    EXPECT_FALSE(effectsFrom(fileOf(mapOfTwo(), ""), "low")) << "it has no such camera";
    EXPECT_TRUE(
        effectsFrom(*parseJson(R"({"cameras": [{"camera": "a", "effects": [{"effect": "rain"}, 3]}]})", "f"), "a")
            ->empty())
        << "effects that are not known are left out";
}

TEST(EffectFiles, PeopleReadUnitsAndIntervals) {
    EXPECT_EQ(shareText(0, 0), "0 pixels");
    EXPECT_EQ(shareText(1, 0.0001), "< 0.1 %");
    EXPECT_EQ(shareText(99, 0.123), "12.3 %");
    const std::string text = effectMapText(mapOfTwo(), "human");
    EXPECT_NE(text.find("fog"), std::string::npos);
    EXPECT_NE(text.find("50.0 %"), std::string::npos) << text;
    EXPECT_NE(text.find("haze.Fog.visibility = inf"), std::string::npos) << text;
    EXPECT_NE(text.find("too many blades"), std::string::npos) << text;
    EXPECT_NE(text.find("98 %"), std::string::npos) << text;
}

TEST(EffectFiles, EachEffectThatWasDrawnHasAPicture) {
    const test::TempDir dir;
    ASSERT_TRUE(writeEffectPictures(mapOfTwo(), dir / "human"));
    const auto fog = readImage(dir / "human/fog.png");
    ASSERT_TRUE(fog) << fog.error().text();
    EXPECT_EQ(fog->width, 2);
    EXPECT_EQ(fog->height, 1);
    EXPECT_TRUE(std::filesystem::exists(dir / "human/scene.png"));
    EXPECT_FALSE(std::filesystem::exists(dir / "human/wind.png"));
}

}  // namespace
}  // namespace sward
