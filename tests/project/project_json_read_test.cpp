// Old formats of project.json, brought up to date.
#include <gtest/gtest.h>

#include "project/project_json.h"

namespace sward {
namespace {

TEST(ProjectFormats, StepsBringAnOldProjectUpInOrder) {
    const Upgrade steps[] = {
        [](Json& p) -> Status {
            p["name"] = Json(p.find("title")->text);
            p.object.erase("title");
            return {};
        },
        [](Json& p) -> Status {
            p["name"] = Json(p.find("name")->text + "!");
            return {};
        },
    };
    Json old = *parseJson(R"({"format": 1, "title": "park"})", "p");
    ASSERT_TRUE(upgradeProject(old, "p", steps));
    EXPECT_EQ(old.find("name")->text, "park!");
    EXPECT_EQ(old.find("format")->text, "3");
    Json newer = *parseJson(R"({"format": 2, "name": "park"})", "p");
    ASSERT_TRUE(upgradeProject(newer, "p", steps));
    EXPECT_EQ(newer.find("name")->text, "park!");
    Json newest = *parseJson(R"({"format": 4})", "p");
    EXPECT_FALSE(upgradeProject(newest, "p", steps));
    EXPECT_EQ(projectUpgrades().size() + 1, size_t(kProjectFormat));
}

}  // namespace
}  // namespace sward
