// Presets and whole species: each edit one undo step, within a field's limits.
#include "model/species_presets.h"

#include <gtest/gtest.h>

#include <set>

#include "model/field_walk.h"
#include "scene/field_limits.h"
#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

class SpeciesPresets : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(doc.create(dir / "p"));
        before = snapshot(doc.project(), tables().components);
    }
    const GrassField& field() { return *doc.project().registry.get<GrassField>(findEntity(doc.project(), "lawn")); }
    bool asBefore() { return sameProject(doc.project(), before, tables().components); }
    test::TempDir dir;
    Document doc{tables()};
    Project before;
};

TEST_F(SpeciesPresets, EachHasANameOfItsOwnAndAnImageThatIsThere) {
    std::set<std::string> names;
    for (const SpeciesPreset& p : speciesPresets()) {
        names.insert(p.name);
        if (p.image) EXPECT_TRUE(std::filesystem::exists(presetFolder() / p.image)) << p.image;
        EXPECT_EQ(findPreset(p.name), &p);
    }
    EXPECT_EQ(names, (std::set<std::string>{"heather", "lawn", "meadow", "pitch", "reed", "straw", "wheat"}));
    EXPECT_EQ(findPreset("moss"), nullptr);
}

TEST_F(SpeciesPresets, OneIsAddedUnpaintedWithItsImageInOneStep) {
    ASSERT_EQ(*addPreset(doc, "lawn", *findPreset("wheat")), "wheat");
    ASSERT_EQ(*addPreset(doc, "lawn", *findPreset("lawn")), "lawn2");
    ASSERT_EQ(field().species.size(), 3u);
    EXPECT_EQ(field().species[1].texture, "images/ear.png");
    EXPECT_TRUE(std::filesystem::exists(dir / "p" / "images" / "ear.png"));
    EXPECT_EQ(field().species[1].density.map.mean(), 0) << "it grows where it is painted";
    EXPECT_EQ(field().species[2].bladesPerM2, findPreset("lawn")->make().bladesPerM2);
    ASSERT_TRUE(doc.undo());
    ASSERT_TRUE(doc.undo());
    EXPECT_TRUE(asBefore());
}

TEST_F(SpeciesPresets, OneAppliedKeepsNameAndPlace) {
    const uint64_t grows = field().species[0].density.map.hash();
    ASSERT_TRUE(applyPreset(doc, "lawn", "lawn", *findPreset("heather")));
    EXPECT_EQ(field().species[0].name, "lawn");
    EXPECT_EQ(field().species[0].height, findPreset("heather")->make().height);
    EXPECT_EQ(field().species[0].texture, "images/spike.png");
    EXPECT_EQ(field().species[0].density.map.hash(), grows);
    ASSERT_TRUE(doc.undo());
    EXPECT_TRUE(asBefore());
    EXPECT_FALSE(applyPreset(doc, "lawn", "nobody", *findPreset("heather")));
    EXPECT_FALSE(applyPreset(doc, "sun", "lawn", *findPreset("heather")));
    EXPECT_FALSE(doc.canUndo());
}

TEST_F(SpeciesPresets, ACopyGrowsWhereItsOriginalDoesUntilOneIsPainted) {
    ASSERT_EQ(*duplicateSpecies(doc, "lawn", "lawn"), "lawn2");
    ASSERT_EQ(*duplicateSpecies(doc, "lawn", "lawn2"), "lawn3");
    EXPECT_TRUE(field().species[1].density.map.sameTiles(field().species[0].density.map));
    ASSERT_TRUE(doc.save());
    Document again(tables());
    ASSERT_TRUE(again.open(dir / "p"));
    EXPECT_EQ(again.project().registry.get<GrassField>(findEntity(again.project(), "lawn"))->species[1].name, "lawn2");
    while (field().species.size() < kMaxSpecies) ASSERT_TRUE(duplicateSpecies(doc, "lawn", "lawn"));
    const auto full = duplicateSpecies(doc, "lawn", "lawn");
    ASSERT_FALSE(full);
    EXPECT_NE(full.error().text().find("16 species"), std::string::npos) << full.error().text();
}

}  // namespace
}  // namespace sward
