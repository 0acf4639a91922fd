#include "frame/plan.h"

#include <gtest/gtest.h>

#include "techniques.h"

namespace sward {
namespace {

void nothing(DrawContext&) {}
constexpr ProgramRow kOneProgram[] = {{"test/one", "a", "b", nullptr}};
const Pass kReader[] = {{"test/reader", Stage::Post, kViewMain, kImage, kImage, kOneProgram, nothing}};
const Pass kWriter[] = {{"test/writer", Stage::Post, kViewMain, kSceneColor, kImage | kSkyLight, {}, nothing}};
const Pass kEarly[] = {{"test/early", Stage::Ground, kViewMain, 0, kSceneColor, {}, nothing}};
const Pass kShadow[] = {{"test/shadow", Stage::Shadow, kViewShadow, 0, 0, {}, nothing}};
const EffectRow kEffects[] = {
    {"test/reader", featureSet(Feature::Sky), {}, kReader, nullptr, ""},
    {"test/writer", {}, {}, kWriter, nullptr, ""},
    {"test/early", featureSet(Feature::Sun, Feature::Sky), {}, kEarly, nullptr, ""},
    {"test/shadow", {}, {}, kShadow, nullptr, ""},
};

std::vector<std::string> passNames(const FramePlan& plan) {
    std::vector<std::string> names;
    for (const PlannedPass& p : plan.passes) names.push_back(p.pass->name);
    return names;
}

TEST(Plan, AnEffectRunsOnlyIfAllItsFeaturesAreThere) {
    EXPECT_EQ(passNames(planFrame({}, kViewMain, kEffects)), (std::vector<std::string>{"test/writer"}));
    EXPECT_EQ(passNames(planFrame(featureSet(Feature::Sun), kViewMain, kEffects)),
              (std::vector<std::string>{"test/writer"}));
    EXPECT_EQ(planFrame(featureSet(Feature::Sun, Feature::Sky), kViewMain, kEffects).effects.size(), 4u);
}

TEST(Plan, PassesAreSortedByStageAndThenWritersBeforeReaders) {
    const FramePlan plan = planFrame(featureSet(Feature::Sun, Feature::Sky), kViewMain, kEffects);
    EXPECT_EQ(passNames(plan), (std::vector<std::string>{"test/early", "test/writer", "test/reader"}))
        << "by stage; within one, who writes the image before who reads it, against the table's order";
    const Pass pure[] = {{"test/use", Stage::Post, kViewMain, kSkyLight, 0, {}, nothing}};
    const EffectRow effects[] = {{"test/use", {}, {}, pure, nullptr, ""},
                                 {"test/writer", {}, {}, kWriter, nullptr, ""}};
    EXPECT_EQ(passNames(planFrame({}, kViewMain, effects)), (std::vector<std::string>{"test/writer", "test/use"}));
}

TEST(Plan, AViewGetsOnlyItsPasses) {
    EXPECT_EQ(passNames(planFrame({}, kViewShadow, kEffects)), (std::vector<std::string>{"test/shadow"}));
}

TEST(Plan, ProgramsAreNamedOnce) {
    const EffectRow twice[] = {kEffects[0], kEffects[0]};
    EXPECT_EQ(planFrame(featureSet(Feature::Sky), kViewMain, twice).programs(), (std::vector<std::string>{"test/one"}));
}

TEST(Plan, FeatureConstantsSayOfEachFeatureWhetherItIsThere) {
    const std::string constants = featureConstants(featureSet(Feature::Sun, Feature::Sky));
    EXPECT_NE(constants.find("const bool SUN = true;\n"), std::string::npos) << constants;
    EXPECT_NE(constants.find("const bool TERRAIN_HEIGHTS = false;\n"), std::string::npos) << constants;
    EXPECT_EQ(static_cast<size_t>(std::count(constants.begin(), constants.end(), '\n')), featureRows().size());
    EXPECT_EQ(planFrame(featureSet(Feature::Sun, Feature::Sky), kViewMain, kEffects).constants, constants);
}

TEST(Plan, NamesInTheTableAreDomainAndStemAndUnique) {
    std::vector<std::string> seen;
    for (const EffectRow& e : tables().effects) {
        EXPECT_NE(std::string(e.name).find('/'), std::string::npos) << e.name;
        for (const Pass& p : e.passes) seen.push_back(p.name);
        for (const System& s : e.systems) seen.push_back(s.name);
        EXPECT_GT(std::string(e.help).size(), 10u) << e.name;
    }
    std::sort(seen.begin(), seen.end());
    EXPECT_EQ(std::adjacent_find(seen.begin(), seen.end()), seen.end());
}

}  // namespace
}  // namespace sward
