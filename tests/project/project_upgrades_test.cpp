// Projects of the first form: they open as they were, and are saved in the form of today.
#include <gtest/gtest.h>

#include "fields.h"
#include "project/project_json.h"
#include "support.h"

namespace sward::test {
namespace {

constexpr const char* kOld = R"({"format": 1, "entities": {
  "ground": {"Terrain": {}},
  "lawn": {"GrassField": {"technique": "tessellated", "seed": 7, "minGeom": 3, "maxGeom": "inf", "slices": 12,
    "fade": 0.25, "maxDistance": 33, "farBlur": "gaussian", "scent": 1, "species": [{"name": "clover"}]}}}})";

TEST(ProjectUpgrades, FieldsOfTheFirstFormArriveInTheirComponents) {
    TempDir dir;
    writeText(dir / "p/project.json", kOld);
    auto p = loadProject(dir / "p", tables().components);
    ASSERT_TRUE(p) << p.error().text();
    const auto check = [](Project& project) {
        const FlatField f = flatField(project, "lawn");
        EXPECT_EQ(f.technique, "tessellated");
        EXPECT_EQ(f.seed, 7);
        EXPECT_EQ(f.minGeom, 3);
        EXPECT_TRUE(std::isinf(f.maxGeom));
        EXPECT_EQ(f.slices, 12);
        EXPECT_EQ(f.fade, 0.25f);
        EXPECT_EQ(f.maxDistance, 33);
        EXPECT_EQ(f.farBlur, FarBlur::Gaussian);
        EXPECT_EQ(f.species[0].name, "clover");
    };
    ASSERT_TRUE(saveProject(*p, tables().components));
    check(*p);
    const std::string saved = readText(dir / "p/project.json");
    const auto json = parseJson(saved, "p");
    ASSERT_TRUE(json);
    EXPECT_EQ(json->find("format")->text, "2");
    const Json& lawn = *json->find("entities")->find("lawn");
    EXPECT_EQ(lawn.find("GrassField")->find("minGeom"), nullptr) << saved;
    EXPECT_EQ(lawn.find("HybridTiers")->find("minGeom")->text, "3") << saved;
    EXPECT_NE(saved.find("\"scent\""), std::string::npos) << "what nobody knows stays";
    auto again = loadProject(dir / "p", tables().components);
    ASSERT_TRUE(again) << again.error().text();
    check(*again);
    ASSERT_TRUE(saveProject(*again, tables().components));
    EXPECT_EQ(readText(dir / "p/project.json"), saved) << "the second save changes nothing";
}

TEST(ProjectUpgrades, SettingsThatAreAllDefaultsAreNotSaved) {
    TempDir dir;
    writeText(dir / "p/project.json", R"({"format": 1, "entities": {"lawn": {"GrassField": {"seed": 2}}}})");
    auto p = loadProject(dir / "p", tables().components);
    ASSERT_TRUE(p) << p.error().text();
    flatField(*p, "lawn");  // all of them are there now
    ASSERT_TRUE(saveProject(*p, tables().components));
    EXPECT_EQ(readText(dir / "p/project.json").find("HybridTiers"), std::string::npos);
}

}  // namespace
}  // namespace sward::test
