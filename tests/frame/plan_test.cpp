#include "frame/plan.h"

#include <gtest/gtest.h>

#include <random>
#include <regex>

#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

void nothing(DrawContext&) {}
constexpr ProgramRow kOneProgram[] = {{"test/one", "a", "b", nullptr}};

using Names = std::vector<std::string>;

// An effect of one pass or one system; what is named later in the alphabet would come later.
Pass pass(const char* name, Stage stage, const SlotUse& uses, unsigned views = kViewMain) {
    return {name, stage, views, uses, {}, nothing};
}
EffectRow effect(const char* name, std::span<const Pass> passes, FeatureSet needs = {}) {
    return {name, needs, {}, passes, nullptr, ""};
}
EffectRow effect(const char* name, std::span<const System> systems) { return {name, {}, systems, {}, nullptr, ""}; }

Names stepNames(const FramePlan& plan) {
    Names names;
    for (const Step& s : plan.steps) names.push_back(s.name());
    return names;
}
Names planned(const std::vector<EffectRow>& effects, const FeatureSet& features = {}) {
    return stepNames(planFrame(features, kViewMain, effects));
}

TEST(Plan, AnEffectRunsOnlyIfAllItsFeaturesAreThere) {
    const Pass any[] = {pass("any", Stage::Post, {})}, sunny[] = {pass("sunny", Stage::Post, {})};
    const std::vector<EffectRow> effects = {effect("test/sunny", sunny, featureSet(Feature::Sun, Feature::Sky)),
                                            effect("test/any", any)};
    EXPECT_EQ(planned(effects), (Names{"any"}));
    EXPECT_EQ(planned(effects, featureSet(Feature::Sun)), (Names{"any"}));
    EXPECT_EQ(planned(effects, featureSet(Feature::Sun, Feature::Sky)), (Names{"any", "sunny"}));
}

TEST(Plan, OfASlotWritersComeFirstThenAppendersThenWhoChangesItThenReaders) {
    const Pass a[] = {pass("a reads", Stage::Post, {.reads = {Slot::Image}})},
               b[] = {pass("b changes", Stage::Post, {.reads = {Slot::Image}, .writes = {Slot::Image}})},
               c[] = {pass("c appends", Stage::Post, {.appends = {Slot::Image}})},
               d[] = {pass("d appends", Stage::Post, {.appends = {Slot::Image}})},
               e[] = {pass("e writes", Stage::Post, {.writes = {Slot::Image}})};
    EXPECT_EQ(planned({effect("t/a", a), effect("t/b", b), effect("t/c", c), effect("t/d", d), effect("t/e", e)}),
              (Names{"e writes", "c appends", "d appends", "b changes", "a reads"}));
}

TEST(Plan, StagesAndThenNamesDecideWhatSlotsLeaveOpen) {
    const Pass late[] = {pass("a", Stage::Sky, {})}, one[] = {pass("c", Stage::Ground, {})},
               two[] = {pass("b", Stage::Ground, {})};
    EXPECT_EQ(planned({effect("t/late", late), effect("t/one", one), effect("t/two", two)}), (Names{"b", "c", "a"}));
}

TEST(Plan, SystemsTickBeforePassesAndThoseOfAllViewsBeforeThoseOfOne) {
    const System once[] = {{"z once", {}, nothing, true}}, mine[] = {{"a mine", {}, nothing}};
    const Pass first[] = {pass("first", Stage::Simulate, {})};
    const std::vector<EffectRow> effects = {effect("t/first", first), effect("t/mine", mine), effect("t/once", once)};
    EXPECT_EQ(planned(effects), (Names{"z once", "a mine", "first"}));
    EXPECT_EQ(stepNames(planFrame({}, kViewReflection, effects)), (Names{"a mine"})) << "the main view ticked it";
}

TEST(Plan, SystemsAreOrderedByTheirSlots) {
    const System reads[] = {{"a reads", {.reads = {Slot::Lamps}}, nothing}},
                 writes[] = {{"b writes", {.writes = {Slot::Lamps}}, nothing}};
    EXPECT_EQ(planned({effect("t/a", reads), effect("t/b", writes)}), (Names{"b writes", "a reads"}));
}

TEST(Plan, WhatIsBlendedComesAfterTheSceneAndBeforeWater) {
    Pass blades = pass("blades", Stage::Blades, {});
    blades.blendedWith = featureSet(Feature::GrassBlended);
    const Pass grass[] = {blades}, sky[] = {pass("sky", Stage::Sky, {})}, water[] = {pass("water", Stage::Water, {})};
    const std::vector<EffectRow> effects = {effect("t/water", water), effect("t/sky", sky), effect("t/grass", grass)};
    EXPECT_EQ(planned(effects), (Names{"blades", "sky", "water"}));
    EXPECT_EQ(planned(effects, featureSet(Feature::GrassBlended)), (Names{"sky", "blades", "water"}));
}

TEST(Plan, AViewWithinComesBeforeTheViewsOwnSystems) {
    const ViewRow mirror{kViewReflection, "mirrored ", {.writes = {Slot::Reflection}}, nullptr, nullptr};
    EffectRow shows{"t/mirror", {}, {}, {}, nullptr, ""};
    shows.within = &mirror;
    const System reads[] = {{"a reads", {.reads = {Slot::Reflection}}, nothing}};
    const std::vector<EffectRow> effects = {effect("t/a", reads), shows};
    EXPECT_EQ(planned(effects), (Names{"t/mirror", "a reads"}));
    EXPECT_EQ(stepNames(planFrame({}, kViewReflection, effects)), (Names{"a reads"})) << "no mirror in a mirror";
}

TEST(Plan, AStencilIsThereForWhoNeedsOne) {
    Pass needs = pass("needs", Stage::Post, {});
    needs.stencil = true;
    const Pass with[] = {needs}, without[] = {pass("none", Stage::Post, {})};
    EXPECT_TRUE(planFrame({}, kViewMain, std::vector{effect("t/with", with)}).stencil);
    EXPECT_FALSE(planFrame({}, kViewMain, std::vector{effect("t/without", without)}).stencil);
}

TEST(Plan, AViewGetsOnlyItsPasses) {
    const Pass both[] = {pass("both", Stage::Post, {}, kViewMain | kViewReflection)},
               main[] = {pass("main", Stage::Post, {})};
    const System system[] = {{"of main", {}, nothing}};
    const std::vector<EffectRow> effects = {effect("t/both", both), {"t/main", {}, system, main, nullptr, ""}};
    EXPECT_EQ(planned(effects), (Names{"of main", "both", "main"}));
    EXPECT_EQ(stepNames(planFrame({}, kViewReflection, effects)), (Names{"both"})) << "nobody there reads the system's";
}

TEST(PlanDeathTest, SlotsThatAskForACircleStopTheProgramWithTheNames) {
    const Pass a[] = {pass("one/pass", Stage::Post, {.reads = {Slot::Image}, .appends = {Slot::Forces}})},
               b[] = {pass("other/pass", Stage::Post, {.reads = {Slot::Forces}, .appends = {Slot::Image}})};
    EXPECT_DEATH(planned({effect("t/a", a), effect("t/b", b)}), "one/pass before other/pass \\(Forces\\)");
}

TEST(PlanDeathTest, AReaderOfAnEarlierStageStopsTheProgram) {
    const Pass a[] = {pass("early", Stage::Shadow, {.reads = {Slot::Image}})},
               b[] = {pass("late", Stage::Post, {.writes = {Slot::Image}})};
    EXPECT_DEATH(planned({effect("t/a", a), effect("t/b", b)}),
                 "early waits for a slot that a later stage makes; late");
}

TEST(Plan, ProgramsAreNamedOnce) {
    const Pass a[] = {{"a", Stage::Post, kViewMain, {}, kOneProgram, nothing}},
               b[] = {{"b", Stage::Post, kViewMain, {}, kOneProgram, nothing}};
    EXPECT_EQ(planFrame({}, kViewMain, std::vector{effect("t/a", a), effect("t/b", b)}).programs(),
              (Names{"test/one"}));
}

// --- the table ---------------------------------------------------------------------------------------------------

// Any scene's features are some of all; each feature is tried with all others and without them.
std::vector<FeatureSet> scenes() {
    std::vector<FeatureSet> out = {FeatureSet{}, ~FeatureSet{}};
    for (const FeatureRow& row : featureRows()) {
        out.push_back(featureSet(row.feature, Feature::Terrain, Feature::Grass));
        out.push_back(~featureSet(row.feature));
    }
    return out;
}

TEST(PlanTable, ItsOrderMeansNothing) {
    std::vector<EffectRow> rows(tables().effects.begin(), tables().effects.end());
    std::mt19937 random(7);
    for (int i = 0; i < 100; ++i) {
        std::shuffle(rows.begin(), rows.end(), random);
        const std::vector<FeatureSet> all = scenes();
        const FeatureSet& scene = all[static_cast<size_t>(i) % all.size()];
        for (const unsigned view : {kViewMain, kViewReflection}) {
            const FramePlan a = planFrame(scene, view, tables().effects), b = planFrame(scene, view, rows);
            ASSERT_EQ(stepNames(a), stepNames(b)) << "shuffle " << i;
            ASSERT_TRUE(std::equal(
                a.effects.begin(), a.effects.end(), b.effects.begin(), b.effects.end(),
                [](const EffectRow* x, const EffectRow* y) { return std::string_view(x->name) == y->name; }));
            ASSERT_EQ(a.programs(), b.programs());
        }
    }
}

TEST(PlanTable, EverySceneHasAPlan) {
    for (const FeatureSet& scene : scenes())
        for (const unsigned view : {kViewMain, kViewReflection}) planFrame(scene, view, tables().effects);
    EXPECT_GT(planFrame(~FeatureSet{}, kViewMain, tables().effects).steps.size(), 40u);
}

TEST(PlanTable, ASlotThatIsReadIsFilledAndNoTwoMakeIt) {
    SlotSet read, filled, made;
    for (const Step& s : planFrame(~FeatureSet{}, kViewMain, tables().effects).steps) {
        const SlotUse& u = s.uses();
        const SlotSet makes = u.writes.without(u.reads);
        EXPECT_FALSE((makes & made).any()) << s.name() << " makes " << slotNames(makes & made) << " as another does";
        EXPECT_FALSE((u.appends & (u.reads | u.writes)).any()) << s.name();
        read = read | u.reads, filled = filled | u.writes | u.appends, made = made | makes;
    }
    EXPECT_EQ(slotNames(read.without(filled)), "") << "read, and filled by nobody";
    EXPECT_EQ(slotNames(filled.without(read | SlotSet{Slot::Image})), "") << "filled for nobody but the screen";
}

// Which slot a member of SharedResources is; `ground` is there before the first step.
const std::map<std::string, std::string> kSlotOf = {{"masks", "Masks"},
                                                    {"traced", "Traced"},
                                                    {"grown", "Grown"},
                                                    {"forests", "Forests"},
                                                    {"objectLight", "ObjectLight"},
                                                    {"groundMesh", "GroundNodes"},
                                                    {"grass", "Grass"},
                                                    {"bounds", "Ground"},
                                                    {"heights", "Ground"},
                                                    {"soil", "Grass"},
                                                    {"casters", "Casters"},
                                                    {"castersHash", "Casters"},
                                                    {"forceTarget", "ForceList"},
                                                    {"reflections", "Reflection"},
                                                    {"sampleShift", "SampleShift"},
                                                    {"lights", "Lamps"},
                                                    {"lampPlaces", "Lamps"},
                                                    {"air", "Air"},
                                                    {"skyTilt", "SkyLight"},
                                                    {"ground", ""}};

// All that the effects do to slots whose rows stand in a file.
std::string slotsIn(const std::string& source) {
    SlotSet used;
    for (const EffectRow& e : tables().effects) {
        if (source.find("\"" + std::string(e.name) + "\"") == std::string::npos) continue;
        const auto add = [&](const SlotUse& u) { used = used | u.reads | u.writes | u.appends; };
        for (const System& s : e.systems) add(s.uses);
        for (const Pass& p : e.passes) add(p.uses);
        if (e.within) add(e.within->uses);
    }
    return ", " + slotNames(used) + ",";
}

TEST(PlanTable, WhatAStemTakesFromOthersItsRowsSay) {
    static const std::regex member(R"(ctx\.shared\.(\w+))");
    int found = 0;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::filesystem::path(SWARD_SOURCE_DIR) / "engine")) {
        if (entry.path().extension() != ".cpp") continue;
        const std::string source = test::readText(entry.path()), slots = slotsIn(source);
        if (source.find("static const EffectRow row{") == std::string::npos) continue;
        for (std::sregex_iterator it(source.begin(), source.end(), member), end; it != end; ++it, ++found) {
            const auto slot = kSlotOf.find((*it)[1].str());
            ASSERT_NE(slot, kSlotOf.end()) << "no slot is named for shared." << (*it)[1].str();
            if (!slot->second.empty())
                EXPECT_NE(slots.find(", " + slot->second + ","), std::string::npos)
                    << entry.path().filename() << " uses " << it->str() << ", and no row of it says " << slot->second;
        }
    }
    EXPECT_GT(found, 50);
}

TEST(PlanTable, NeitherPlannerNorRendererKnowsAFeature) {
    for (const char* file : {"plan.cpp", "plan.h", "renderer.cpp", "renderer.h", "draw_context.h"})
        EXPECT_EQ(test::readText(std::filesystem::path(SWARD_SOURCE_DIR) / "engine/frame" / file).find("Feature::"),
                  std::string::npos)
            << file;
}

TEST(Plan, FeatureConstantsSayOfEachFeatureWhetherItIsThere) {
    const std::string constants = featureConstants(featureSet(Feature::Sun, Feature::Sky));
    EXPECT_NE(constants.find("const bool SUN = true;\n"), std::string::npos) << constants;
    EXPECT_NE(constants.find("const bool TERRAIN_HEIGHTS = false;\n"), std::string::npos) << constants;
    EXPECT_EQ(static_cast<size_t>(std::count(constants.begin(), constants.end(), '\n')), featureRows().size());
    EXPECT_EQ(planFrame(featureSet(Feature::Sun, Feature::Sky), kViewMain, {}).constants, constants);
}

TEST(PlanTable, NamesAreDomainAndStemAndUnique) {
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
