// The settings of a sweep: which there are, and how one is laid on a project.
#include "cost/cost_settings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "fields.h"
#include "scene/antialias.h"
#include "scene/forest_technique.h"
#include "techniques.h"

namespace sward::test {
namespace {

Project grassy() {
    Project p;
    p.registry.add<GrassField>(*addEntity(p, "meadow"), {});
    return p;
}

TEST(CostSettings, EachAppliesToAProjectAndNoneIsThereTwice) {
    const Project p = grassy();
    auto all = costSettings(p, tables());
    ASSERT_TRUE(all);
    EXPECT_GE(all->size(), 35u);
    std::set<std::string> texts;
    for (const CostSetting& s : *all) {
        Project copy = snapshot(p, tables().components);
        ViewSettings view;
        const Status done = applySetting(copy, tables(), s, view);
        EXPECT_TRUE(done) << s.technique << " " << s.text() << ": " << done.error().text();
        const FlatField f = flatField(copy, "meadow");
        EXPECT_EQ(f.technique, s.technique);
        EXPECT_LE(f.minGeom, f.maxGeom) << s.text();
        EXPECT_LE(f.minBTF, f.maxBTF) << s.text();
        EXPECT_TRUE(texts.insert(s.technique + " " + s.text()).second) << s.text();
    }
    for (const TechniqueRow& row : tables().techniques) {
        const auto settings =
            std::count_if(all->begin(), all->end(), [&](const CostSetting& s) { return s.technique == row.name; });
        EXPECT_GE(settings, 1) << row.name;
        EXPECT_LE(settings, 32) << row.name << ": a sweep takes minutes, not hours";
    }
}

TEST(CostSettings, AskedForOneTechniqueGiveThatAlone) {
    auto flat = costSettings(grassy(), tables(), "flat");
    ASSERT_TRUE(flat);
    EXPECT_EQ(flat->size(), 4u) << "and the project as it is";
    EXPECT_EQ(costSettings(grassy(), tables(), "felt").error().code, ExitCode::Usage);
    EXPECT_EQ(costSettings(Project{}, tables()).error().code, ExitCode::Unsound);
    Project p = grassy();
    ViewSettings view;
    EXPECT_EQ(applySetting(p, tables(), {"hybrid", {"msaa=0"}}, view).error().code, ExitCode::Usage);
    EXPECT_EQ(applySetting(p, tables(), {"hybrid", {"maxGeom=far"}}, view).error().code, ExitCode::Usage);
    EXPECT_EQ(applySetting(p, tables(), {"hybrid", {"felt=1"}}, view).error().code, ExitCode::Usage);
}

TEST(CostSettings, BeginWithTheProjectAsItShips) {
    Project p = grassy();
    flatField(p, "meadow").technique = "slices";
    const auto one = costSettings(p, tables());
    ASSERT_TRUE(one);
    EXPECT_EQ(one->front().technique, "slices");
    EXPECT_EQ(one->front().text(), kAsItIs);
    EXPECT_EQ(std::count_if(one->begin(), one->end(), [](const CostSetting& s) { return s.text() == kAsItIs; }), 1);
    p.registry.add<GrassField>(*addEntity(p, "verge"), {});
    EXPECT_EQ(ownTechniques(p), "slices+hybrid");
    const auto two = costSettings(p, tables());
    ASSERT_TRUE(two);
    ViewSettings view;
    ASSERT_TRUE(applySetting(p, tables(), two->front(), view));
    EXPECT_EQ(ownTechniques(p), "slices+hybrid") << "each keeps its own";
}

TEST(CostSettings, WhatDrawsNoLessThanASlowOneIsTakenForSlow) {
    const CostSetting slow{"hybrid", {"maxGeom=5", "maxBTF=9", "msaa=1"}};
    EXPECT_TRUE(drawsNoLess(slow, slow));
    EXPECT_TRUE(drawsNoLess({"hybrid", {"maxGeom=5", "maxBTF=20", "msaa=4"}}, slow));
    EXPECT_TRUE(drawsNoLess({"hybrid", {"maxGeom=inf", "maxBTF=9", "msaa=1"}}, slow));
    EXPECT_FALSE(drawsNoLess({"hybrid", {"maxGeom=4.9", "maxBTF=20", "msaa=4"}}, slow));
    EXPECT_FALSE(drawsNoLess({"hybrid", {"maxGeom=9", "maxBTF=9"}}, slow)) << "says nothing of samples";
    EXPECT_FALSE(drawsNoLess({"geometry", {"maxGeom=5", "maxBTF=9", "msaa=1"}}, slow));
    EXPECT_FALSE(drawsNoLess({"hybrid", {"sharpness=2", "msaa=4"}}, {"hybrid", {"sharpness=1", "msaa=4"}}))
        << "what sharpness costs is not known";
}

TEST(CostSettings, EachFieldIsSweptAroundItsOwnValues) {
    Project p = grassy();
    p.registry.add<GrassField>(*addEntity(p, "verge"), {});
    HybridTiers far;
    far.minGeom *= 2, far.maxGeom *= 2, far.minBTF *= 2, far.maxBTF *= 2;
    p.registry.add<HybridTiers>(findEntity(p, "verge"), far);
    auto all = costSettings(p, tables(), "hybrid");
    ASSERT_TRUE(all);
    for (const CostSetting& s : *all) {
        Project copy = snapshot(p, tables().components);
        ViewSettings view;
        ASSERT_TRUE(applySetting(copy, tables(), s, view)) << s.text();
        flatField(copy, "meadow"), flatField(copy, "verge");  // makes what is absent, which moves what is there
        const FlatField meadow = flatField(copy, "meadow"), verge = flatField(copy, "verge");
        EXPECT_NEAR(verge.maxGeom / meadow.maxGeom, 2, 1e-3f) << s.text();
        EXPECT_EQ(verge.sharpness, meadow.sharpness) << s.text();
    }
    EXPECT_EQ(costSettings(p, tables(), "flat")->at(1).text(), "msaa=1") << "what is common is said once";
}

TEST(CostSettings, AForestsTechniquesStandBesideThoseOfGrass) {
    Project p = grassy();
    const size_t grassAlone = costSettings(p, tables())->size();
    p.registry.add<Forest>(*addEntity(p, "wood"), {.meshesTo = 40});
    p.registry.add<Forest>(*addEntity(p, "copse"), {.meshesTo = 20});
    const auto all = costSettings(p, tables());
    ASSERT_TRUE(all);
    EXPECT_EQ(all->front().technique, "hybrid") << "as it is, by its grass";
    std::set<std::string> drawnBy;
    for (const CostSetting& s : *all) {
        const ForestTechniqueRow* row = findForestTechnique(s.technique);
        if (!row) continue;
        drawnBy.insert(s.technique);
        Project copy = snapshot(p, tables().components);
        ViewSettings view;
        ASSERT_TRUE(applySetting(copy, tables(), s, view)) << s.text();
        for (const auto& [name, forest] : growingForests(copy)) EXPECT_EQ(forest->technique, row->technique) << name;
        EXPECT_EQ(flatField(copy, "meadow").technique, "hybrid") << s.text();
    }
    EXPECT_EQ(drawnBy, (std::set<std::string>{"forest-texcells", "forest-trees", "forest-flat"}));
    const auto volumes = costSettings(p, tables(), "forest-texcells");
    ASSERT_TRUE(volumes);
    EXPECT_EQ(all->size(), grassAlone + volumes->size() - 1 + costSettings(p, tables(), "forest-trees")->size() - 1 +
                               costSettings(p, tables(), "forest-flat")->size() - 1);
    EXPECT_EQ(costSettings(p, tables(), "forest")->size(), 1 + all->size() - grassAlone);
    EXPECT_EQ(volumes->at(1).text(), "copse.meshesTo=20 wood.meshesTo=40 msaa=4") << "around each one's own";
    removeEntity(p, "wood"), removeEntity(p, "copse");
    EXPECT_EQ(costSettings(p, tables(), "forest-flat").error().code, ExitCode::Unsound);
}

TEST(CostSettings, AForestAloneIsSweptByItsOwnTechniques) {
    Project p;
    p.registry.add<Forest>(*addEntity(p, "wood"), {.technique = ForestTechnique::Flat});
    EXPECT_EQ(ownTechniques(p), "forest-flat");
    const auto all = costSettings(p, tables());
    ASSERT_TRUE(all);
    EXPECT_EQ(all->front().technique, "forest-flat");
    EXPECT_EQ(all->front().text(), kAsItIs);
    for (const CostSetting& s : *all) EXPECT_TRUE(findForestTechnique(s.technique)) << s.technique;
    EXPECT_EQ(costSettings(p, tables(), "hybrid").error().code, ExitCode::Unsound);
}

TEST(CostSettings, AValueIsForEveryFieldOrForOne) {
    Project p = grassy();
    p.registry.add<GrassField>(*addEntity(p, "verge"), {});
    ViewSettings view;
    ASSERT_TRUE(applySetting(p, tables(), {"hybrid", {"maxGeom=7", "verge.maxGeom=9"}}, view));
    EXPECT_EQ(flatField(p, "meadow").maxGeom, 7);
    EXPECT_EQ(flatField(p, "verge").maxGeom, 9);
    EXPECT_FALSE(drawsNoLess({"hybrid", {"verge.maxGeom=9"}}, {"hybrid", {"meadow.maxGeom=8"}}));
    EXPECT_TRUE(drawsNoLess({"hybrid", {"verge.maxGeom=9"}}, {"hybrid", {"verge.maxGeom=8"}}));
}

TEST(CostSettings, FramesThatAddUpAreTriedByEveryTechnique) {
    Project p = grassy();
    const auto all = costSettings(p, tables());
    ASSERT_TRUE(all);
    for (const TechniqueRow& row : tables().techniques)
        EXPECT_TRUE(std::ranges::any_of(*all, [&](const CostSetting& s) {
            return s.technique == row.name && s.values == SettingValues{kTemporalSetting};
        })) << row.name;
    ViewSettings view;
    ASSERT_TRUE(applySetting(p, tables(), {"geometry", {kTemporalSetting}}, view));
    EXPECT_NE(temporalOf(p), nullptr);
    ASSERT_TRUE(applySetting(p, tables(), {"geometry", {"antialias=msaa"}}, view));
    EXPECT_EQ(temporalOf(p), nullptr);
    ASSERT_TRUE(applySetting(p, tables(), {"geometry", {kTemporalSetting}}, view));
    ASSERT_TRUE(applySetting(p, tables(), {"geometry", {"msaa=4"}}, view));
    EXPECT_EQ(temporalOf(p), nullptr) << "so many in one frame";
    EXPECT_EQ(view.msaa, 4);
    const Status wrong = applySetting(p, tables(), {"geometry", {"antialias=fxaa"}}, view);
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().code, ExitCode::Usage);
}

TEST(CostSettings, AroundFramesThatAddUpAreOthersThatDo) {
    Project p = grassy();
    setAntialias(p, Antialiasing::Temporal);
    const auto all = costSettings(p, tables());
    ASSERT_TRUE(all);
    std::map<std::string, int> withOthers;
    for (const CostSetting& s : *all) {
        Project copy = snapshot(p, tables().components);
        ViewSettings view;
        ASSERT_TRUE(applySetting(copy, tables(), s, view)) << s.text();
        const bool oneSample = std::ranges::count(s.values, "msaa=1") == 1;
        if (s.values == SettingValues{"msaa=4"})
            EXPECT_EQ(++withOthers[s.technique], 1) << s.technique;
        else
            EXPECT_EQ(temporalOf(copy) == nullptr, oneSample) << s.technique << " " << s.text();
        EXPECT_EQ(std::ranges::count_if(
                      *all, [&](const CostSetting& o) { return o.technique == s.technique && o.values == s.values; }),
                  1)
            << s.technique << " " << s.text();
    }
    for (const TechniqueRow& row : tables().techniques) {
        EXPECT_EQ(withOthers[row.name], 1) << row.name;
        EXPECT_LE(std::ranges::count(*all, std::string(row.name), &CostSetting::technique), 33)
            << row.name << " and as it is";
    }
}

}  // namespace
}  // namespace sward::test
