// A technique that is known here alone: table, fields, costs, comparison and plots find it by its row.
#include "techniques.h"

#include <gtest/gtest.h>

#include <set>

#include "accuracy/accuracy.h"
#include "cost/cost_settings.h"
#include "fields.h"
#include "scenes.h"
#include "sources.h"

namespace sward::test {
namespace {

FieldTiers nearTiers(const FieldEntity&, float) {
    FieldTiers t;
    t.blades = fadeRange(1, 3);
    return t;
}
std::vector<SettingValues> twoFades(const FieldEntity&) { return {{"fade=0.1"}, {"fade=0.3"}}; }
TechniqueRow stubble() {
    TechniqueRow row = *findTechnique(tables().techniques, nameOf(Technique::Geometry));
    row.name = "stubble", row.label = "Stubble", row.help = "blades near the eye and nothing beyond";
    row.color = 0x123456;
    row.tiers = nearTiers, row.sweep = twoFades;
    return row;
}

bool takes(const std::string& value) {
    Project p = lawn();
    const auto f = findField(p, tables().components, "grass.GrassField.technique");
    return f && setFieldText(*f, value);
}

TEST(AddedTechnique, IsInEveryTableWhileItLives) {
    const size_t before = tables().techniques.size();
    EXPECT_FALSE(takes("stubble"));
    {
        const AddedTechnique added(stubble());
        EXPECT_EQ(tables().techniques.size(), before + 1);
        EXPECT_TRUE(takes("stubble"));
        EXPECT_EQ(techniqueColor(tables().techniques, "stubble"), "#123456");
        EXPECT_NE(techniqueNames(tables().techniques).find("stubble"), std::string::npos);
        const std::vector<std::string> names = comparisonNames({}, comparedTechniques(lawn(), tables()));
        EXPECT_NE(std::find(names.begin(), names.end(), "stubble"), names.end());
        const auto swept = costSettings(lawn(), tables(), "stubble");
        ASSERT_TRUE(swept) << swept.error().text();
        EXPECT_EQ(swept->size(), 3u) << "and the project as it is";
    }
    EXPECT_EQ(tables().techniques.size(), before);
    EXPECT_FALSE(takes("stubble"));
}

TEST(AddedTechnique, NobodyButTheTwoTablesIncludesTheStemsOfTheNewestTechnique) {
    const std::filesystem::path root(SWARD_SOURCE_DIR);
    std::set<std::string> by;
    for (const std::filesystem::path& file : sources(root, {"engine", "editor"}))
        for (const std::string& line : linesOf(root / file))
            if (line.starts_with("#include \"grass/tessellated") && !file.string().starts_with("engine/grass/"))
                by.insert(file.string());
    EXPECT_EQ(by, (std::set<std::string>{"engine/effects.cpp", "engine/techniques.cpp"}));
}

}  // namespace
}  // namespace sward::test
