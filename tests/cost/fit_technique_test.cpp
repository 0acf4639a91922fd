// What a fit turns: the grass's techniques or the forest's, the project's own first.
#include "cost/fit_technique.h"

#include "scenes.h"
#include "support.h"

namespace sward::test {
namespace {

Project wooded(bool grass) {
    Project p = lawn();
    if (!grass) removeEntity(p, "grass");
    put<Forest>(p, "trees", {.technique = ForestTechnique::Trees});
    return p;
}
std::string namesOf(const Project& p, const std::string& asked) {
    const auto found = techniquesToFit(p, tables(), asked);
    if (!found) return found.error().message;
    std::string names;
    for (const FitTechnique& t : *found) names += std::string(names.empty() ? "" : " ") + t.name();
    return names;
}

TEST(FitTechniques, AreTheGrasssWhereThereIsGrassAndTheForestsWhereNoneIsOrWhereAskedFor) {
    EXPECT_TRUE(namesOf(lawn(), "").starts_with("hybrid "));
    EXPECT_EQ(namesOf(wooded(true), "").find("forest"), std::string::npos);
    for (const auto& [grass, asked] : {std::pair{false, ""}, {true, "forest"}, {false, "forest"}})
        EXPECT_EQ(namesOf(wooded(grass), asked), "forest-trees forest-texcells forest-flat") << "its own first";
    EXPECT_EQ(namesOf(wooded(true), "forest-flat"), "forest-flat");
    EXPECT_EQ(namesOf(wooded(true), "hybrid"), "hybrid");
}

TEST(FitTechniques, WhatIsNotThereIsRefused) {
    EXPECT_EQ(namesOf(lawn(), "forest"), "the project has no forest");
    EXPECT_EQ(namesOf(wooded(false), "hybrid"), "the project has no grass");
    EXPECT_NE(namesOf(lawn(), "felt").find("no technique \"felt\""), std::string::npos);
    EXPECT_EQ(namesOf({}, ""), "the project has no grass");
}

TEST(FitTechniques, ASettingIsOfEachForestAroundItsOwnValues) {
    Project p = wooded(true);
    put<Forest>(p, "far", {.meshesTo = 20});
    put<Forest>(p, "near", {.meshesTo = 100});
    removeEntity(p, "trees");
    const FitTechnique t{nullptr, findForestTechnique("forest-texcells")};
    const std::vector<double> half{0.5, 1, 1, 1};
    const CostSetting s = turnedSetting(p, t, half);
    EXPECT_EQ(s.technique, "forest-texcells");
    EXPECT_EQ(s.text(), "far.meshesTo=10 near.meshesTo=50 silhouetteDeg=60 meshDetail=1 msaa=4");
    ViewSettings view;
    ASSERT_TRUE(applySetting(p, tables(), s, view));
    EXPECT_EQ(p.registry.get<Forest>(findEntity(p, "near"))->meshesTo, 50);
}

}  // namespace
}  // namespace sward::test
