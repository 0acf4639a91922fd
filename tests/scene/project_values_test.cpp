// Fields as text: what each type takes and refuses.
#include <gtest/gtest.h>

#include "scene/project.h"
#include "tests/rows.h"

namespace sward {
namespace {

// Ground and a meadow of two species.
Project valuesMeadow() {
    Project p;
    p.registry.add<Terrain>(*addEntity(p, "ground"));
    GrassField field;
    field.species.resize(2);
    field.species[0].name = "lawn";
    field.species[1].name = "weeds";
    p.registry.add<GrassField>(*addEntity(p, "meadow"), std::move(field));
    return p;
}

TEST(FieldValues, AreSetFromTextAndKeepTheirValueWhenThatIsWrong) {
    Project p = valuesMeadow();
    const auto set = [&](const char* path, const char* text) {
        return bool(setFieldText(*findField(p, rows(), path), text));
    };
    const auto get = [&](const char* path) { return fieldText(*findField(p, rows(), path)); };
    EXPECT_TRUE(set("meadow.GrassField.maxGeom", " inf "));
    EXPECT_EQ(get("meadow.GrassField.maxGeom"), "inf");
    EXPECT_TRUE(set("meadow.GrassField.technique", "flat"));
    EXPECT_FALSE(set("meadow.GrassField.technique", "magic"));
    EXPECT_EQ(get("meadow.GrassField.technique"), "flat");
    for (const char* text : {"[30, 20.5]", "30, 20.5", "30 20.5"})
        EXPECT_TRUE(set("ground.Terrain.size", text)) << text;
    EXPECT_EQ(get("ground.Terrain.size"), "[30, 20.5]");
    for (const char* text : {"30", "[1, 2, 3]", "[1, x]", "[1, -2]", ""})
        EXPECT_FALSE(set("ground.Terrain.size", text)) << text;
    EXPECT_EQ(get("ground.Terrain.size"), "[30, 20.5]");
    EXPECT_TRUE(set("meadow.GrassField.species[lawn].segments", "4"));
    EXPECT_FALSE(set("meadow.GrassField.species[lawn].segments", "4.5"));
    EXPECT_TRUE(set("meadow.GrassField.species[lawn].stiffness", "2.5"));
    for (const char* text : {"0", "-1", "0.04", "101", "nan", "inf", "stiff", ""})
        EXPECT_FALSE(set("meadow.GrassField.species[lawn].stiffness", text)) << text;
    EXPECT_EQ(get("meadow.GrassField.species[lawn].stiffness"), "2.5");
    EXPECT_FALSE(set("meadow.GrassField.species", "x"));
    EXPECT_FALSE(set("ground.Terrain.groundTexture", "../soil.png"));
    EXPECT_FALSE(set("ground.Terrain.height", "maps/x.exr")) << "texels come by import";
    EXPECT_TRUE(set("ground.Terrain.height", ""));
}

}  // namespace
}  // namespace sward
