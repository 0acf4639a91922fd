// PATHs become words, and nothing else does.
#include "ui/words.h"

#include <gtest/gtest.h>

namespace sward::ui {
namespace {

TEST(Words, PathsAreNamedByTheirElementOrEntity) {
    EXPECT_EQ(inWords("grass.GrassField.species[lawn].density"), "Lawn › density");
    EXPECT_EQ(inWords("ground.Terrain.height"), "Ground › height");
    EXPECT_EQ(inWords("grass.GrassField.ambientOcclusion"), "Grass › ambient occlusion");
    EXPECT_EQ(inWords("grass.MapLayers.layers[no grass on slopes].amounts"), "No grass on slopes › amounts");
    EXPECT_EQ(inWords("grass.MapLayers.layers[no grass on slopes]"), "No grass on slopes");
    EXPECT_EQ(inWords("way.GroundPath.points[3].at"), "Way › at");
    EXPECT_EQ(inWords("rock-2.MeshGrass.density"), "Rock-2 › density");
}

TEST(Words, ColoursAndCentresAreSpeltAsElsewhere) {
    EXPECT_EQ(inWords("a.Flowers.centerColor"), "A › centre colour");
    EXPECT_EQ(spelt("rootColor"), "rootColour");
    EXPECT_EQ(spelt("height"), "height");
}

TEST(Words, TheTextAroundThemStays) {
    EXPECT_EQ(inWords("Comb lawn.GrassField.orientation, 42 m"), "Comb Lawn › orientation, 42 m");
    EXPECT_EQ(inWords("12 set sun.Light.elevationDeg"), "12 set Sun › elevation deg");
    EXPECT_EQ(inWords("a.B.c (new)"), "A › c (new)");
    EXPECT_EQ(inWords("(a.B.c; d.E.f)"), "(A › c; D › f)");
}

TEST(Words, WhatWouldReadAlikeIsToldApart) {
    const std::vector<std::string> maps{"a.GrassField.species[lawn].density", "b.GrassField.species[lawn].density",
                                        "b.GrassField.orientation", "all", "all"};
    EXPECT_EQ(inWordsApart(maps),
              (std::vector<std::string>{"Lawn › density (a)", "Lawn › density (b)", "B › orientation", "all", "all"}));
}

TEST(Words, WhatIsNoPathIsLeftAlone) {
    for (const char* text : {"", "saved: 3 files written", "maps/lawn.density.png", "models/rock.glb", "Size: 2.5 m",
                             "see docs/scripting.md.", "e.g. The rest", "a.B", "a.B.", "a.B[0]", "lawn.GrassField",
                             "/home/e.Terrain.height/p", "x.Y.z[open"})
        EXPECT_EQ(inWords(text), text == std::string("x.Y.z[open") ? "X › z[open" : text);
}

}  // namespace
}  // namespace sward::ui
