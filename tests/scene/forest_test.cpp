// A Forest's fields: what they ask for, what is repaired, and what check says.
#include "scene/forest.h"

#include <gtest/gtest.h>

#include "scenes.h"
#include "techniques.h"

namespace sward::test {
namespace {

FeatureSet asked(const Forest& f) { return forestRow().features(&f); }

TEST(Forest, AsksForWhatItNeedsAndForNothingElse) {
    Forest f;
    EXPECT_TRUE(has(asked(f), Feature::Forest) && has(asked(f), Feature::ForestMeshes) &&
                has(asked(f), Feature::ForestVolumes) && has(asked(f), Feature::ObjectShadows));
    f.meshesTo = 0;
    EXPECT_FALSE(has(asked(f), Feature::ForestMeshes));
    EXPECT_FALSE(has(asked(f), Feature::ObjectShadows)) << "volumes cast none";
    f.meshesTo = std::numeric_limits<float>::infinity();
    EXPECT_TRUE(has(asked(f), Feature::ForestMeshes));
    EXPECT_FALSE(has(asked(f), Feature::ForestVolumes));
    f.castShadows = false;
    EXPECT_FALSE(has(asked(f), Feature::ObjectShadows));
    for (Forest none : {Forest{.perHectare = 0}, Forest{.species = {}}, Forest{.species = {{.share = 0}}}})
        EXPECT_FALSE(asked(none).any());
}

TEST(Forest, RangesThatRunBackwardsAreTurned) {
    Forest f;
    f.slopeDeg = {30, 10};
    f.species[0].size = {1.4, 0.5};
    EXPECT_EQ(forestRow().repair(&f).size(), 2u);
    EXPECT_EQ(f.slopeDeg, glm::dvec2(10, 30));
    EXPECT_EQ(f.species[0].size, glm::dvec2(0.5, 1.4));
}

TEST(Forest, AVerticalScaleIsAFieldThatRefusesWhatItCannotBe) {
    Project p = lawn();
    put<Forest>(p, "trees");
    const auto field = findField(p, tables().components, "trees.Forest.verticalScale");
    ASSERT_TRUE(field) << field.error().text();
    EXPECT_EQ(fieldText(*field), "1");
    for (const char* bad : {"0", "-1", "0.2", "4.1", "inf", "nan", "high"})
        EXPECT_FALSE(setFieldText(*field, bad)) << bad;
    EXPECT_EQ(fieldText(*field), "1") << "what is refused changes nothing";
    for (const char* good : {"0.25", "2", "4"}) EXPECT_TRUE(setFieldText(*field, good)) << good;
    EXPECT_EQ(p.registry.get<Forest>(findEntity(p, "trees"))->verticalScale, 4);
}

TEST(Forest, CheckSaysWhatStandsNowhereAndWhatIsTooMuch) {
    Project p = lawn();
    const auto faults = [&](const Forest& f) {
        put<Forest>(p, "trees", f);
        std::vector<ComponentFault> out;
        forestRow().check(p.registry, findEntity(p, "trees"), "trees.Forest", out);
        return out;
    };
    EXPECT_TRUE(faults({}).empty());
    const auto none = faults({.species = {{.share = 0}}});
    ASSERT_EQ(none.size(), 1u);
    EXPECT_TRUE(none[0].withoutIt);
    EXPECT_NE(none[0].message.find("trees.Forest.species"), std::string::npos);
    p.registry.get<Terrain>(findEntity(p, "ground"))->size = {30000, 30000};
    const auto many = faults({});
    ASSERT_EQ(many.size(), 1u);
    EXPECT_EQ(many[0].field, "Forest.perHectare");
}

}  // namespace
}  // namespace sward::test
