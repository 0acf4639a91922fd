// An effect turned off by one step, and back by one undo.
#include "model/effect_edits.h"

#include "cost/effect_probe.h"
#include "everything.h"
#include "project/project_files.h"
#include "techniques.h"
#include "world/drawn_project.h"

namespace sward::test {
namespace {

struct EffectEdits : testing::Test {
    TempDir dir;
    Document doc{tables()};
    void SetUp() override {
        Project p = everything();
        p.dir = dir / "all";
        std::filesystem::create_directories(p.dir);
        std::filesystem::copy_file(objectsFolder() / "cube.glb", p.dir / "cube.glb");
        const auto saved = saveProject(p, tables().components);
        ASSERT_TRUE(saved) << saved.error().text();
        ASSERT_TRUE(doc.open(p.dir));
    }
    FeatureSet features() const {
        DrawnProject drawn;
        return sceneFeatures(drawn.of(doc.project(), tables().components).registry, tables());
    }
};

TEST_F(EffectEdits, EachIsOneStepThatOneUndoTakesBack) {
    const uint64_t before = projectHash(doc.project(), tables().components);
    const std::vector<Feature> all = effectsOf(doc.project(), tables());
    ASSERT_GT(all.size(), 20u);
    for (const Feature f : all) {
        const Status off = turnOff(doc, f);
        ASSERT_TRUE(off) << off.error().text();
        EXPECT_FALSE(has(features(), f)) << featureName(f);
        EXPECT_EQ(doc.undoLabel(), std::string("turn off ") + featureName(f));
        EXPECT_EQ(doc.stepsDone(), 1u);
        ASSERT_TRUE(doc.undo());
        EXPECT_EQ(projectHash(doc.project(), tables().components), before) << featureName(f);
        EXPECT_FALSE(doc.dirty()) << featureName(f);
    }
}

TEST_F(EffectEdits, WhatIsNotThereOrCannotGoIsRefused) {
    ASSERT_TRUE(turnOff(doc, Feature::Fog));
    EXPECT_FALSE(turnOff(doc, Feature::Fog)) << "it is off already";
    EXPECT_FALSE(turnOff(doc, Feature::Terrain));
    EXPECT_EQ(doc.stepsDone(), 1u);
    Document none(tables());
    EXPECT_FALSE(turnOff(none, Feature::Fog));
}

}  // namespace
}  // namespace sward::test
