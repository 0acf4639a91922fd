// How forests are drawn, as rows of sweeps and plots.
#include "scene/forest_technique.h"

#include <gtest/gtest.h>

#include <set>

#include "fields.h"
#include "scene/technique.h"
#include "support.h"

namespace sward::test {
namespace {

TEST(ForestTechniques, EachValueOfTheFieldHasOneRowThatNoGrassIsNamedOrColouredAs) {
    std::set<ForestTechnique> values;
    std::set<uint32_t> colors;
    for (const TechniqueRow& row : tables().techniques) colors.insert(row.color);
    for (const ForestTechniqueRow& row : forestTechniques()) {
        EXPECT_TRUE(values.insert(row.technique).second) << row.name;
        EXPECT_TRUE(colors.insert(row.color).second) << row.name;
        EXPECT_EQ(row.name, std::string("forest-") + kForestTechniques[row.technique]);
        EXPECT_EQ(findTechnique(tables().techniques, row.name), nullptr);
        EXPECT_EQ(findForestTechnique(row.name), &row);
        EXPECT_EQ(&techniqueOf(Forest{.technique = row.technique}), &row);
        EXPECT_EQ(techniqueRgb(tables().techniques, row.name), row.color);
    }
    EXPECT_EQ(values.size(), kForestTechniques.size());
    EXPECT_EQ(findForestTechnique("texcells"), nullptr);
    EXPECT_EQ(techniqueRgb(tables().techniques, "felt"), std::nullopt);
}

TEST(ForestTechniques, SweepsBeginWithTheForestsOwnValues) {
    const Forest f{.meshesTo = 44, .meshDetail = 3};
    EXPECT_EQ(findForestTechnique("forest-texcells")->sweep(f).front().front(), "meshesTo=44");
    EXPECT_EQ(findForestTechnique("forest-trees")->sweep(f).front().front(), "meshDetail=3");
}

TEST(ForestTechniques, EveryTurnOfTheirKnobsIsASettingThatCanBeSet) {
    for (const ForestTechniqueRow& row : forestTechniques())
        for (const double turn : {-2.0, 0.0, 1.0}) {
            Project p;
            const Forest& f = *p.registry.add<Forest>(*addEntity(p, "wood"), {.meshDetail = 0.1f});
            std::vector<double> knobs;
            for (const KnobRow& k : row.knobs) {
                EXPECT_LE(k.least, k.most) << row.name << ", " << k.name;
                knobs.push_back(std::clamp(k.start * std::exp2(turn), k.least, k.most));
            }
            for (const std::string& value : row.turned(f, knobs)) {
                const size_t equals = value.find('=');
                if (value.starts_with("msaa=")) continue;
                const auto field = findField(p, tables().components, "wood.Forest." + value.substr(0, equals));
                ASSERT_TRUE(field) << row.name << ": " << value;
                EXPECT_TRUE(setFieldText(*field, value.substr(equals + 1))) << row.name << ": " << value;
            }
        }
    const Forest f{.meshesTo = 40, .silhouetteDeg = 60};
    const std::vector<double> twice{2, 2, 1, 1};
    EXPECT_EQ(findForestTechnique("forest-texcells")->turned(f, twice),
              (SettingValues{"meshesTo=80", "silhouetteDeg=90", "meshDetail=1", "msaa=4"}));
}

TEST(ForestTechniques, ForestsWithoutTreesAreNone) {
    Project p;
    p.registry.add<Forest>(*addEntity(p, "wood"), {});
    p.registry.add<Forest>(*addEntity(p, "bare"), {.perHectare = 0});
    ASSERT_EQ(growingForests(p).size(), 1u);
    EXPECT_EQ(growingForests(p)[0].first, "wood");
}

}  // namespace
}  // namespace sward::test
