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

TEST(ForestTechniques, ForestsWithoutTreesAreNone) {
    Project p;
    p.registry.add<Forest>(*addEntity(p, "wood"), {});
    p.registry.add<Forest>(*addEntity(p, "bare"), {.perHectare = 0});
    ASSERT_EQ(growingForests(p).size(), 1u);
    EXPECT_EQ(growingForests(p)[0].first, "wood");
}

}  // namespace
}  // namespace sward::test
