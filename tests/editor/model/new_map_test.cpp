// New maps: their sides are powers of two, and making one changes nothing that is seen.
#include "model/new_map.h"

#include <gtest/gtest.h>

#include "model/document.h"
#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

struct NewMapStage {
    test::TempDir dir;
    Document doc{tables()};
    NewMapStage() { EXPECT_TRUE(doc.create(dir / "p")); }
    Map made(const std::string& path) {
        const auto f = findField(doc.project(), tables().components, path);
        EXPECT_TRUE(f) << path;
        return newMap(doc.project(), *f);
    }
};

TEST(NewMap, IsAPowerOfTwoWithinItsBounds) {
    NewMapStage s;
    for (const auto& [size, side] : {std::pair{"[40, 40]", 512}, {"[1, 1]", 256}, {"[9000, 9000]", 4096}}) {
        ASSERT_TRUE(s.doc.setField("ground.Terrain.size", size));
        const Map map = s.made("lawn.GrassField.species[lawn].density");
        EXPECT_EQ(map.info().width, side) << size;
        EXPECT_EQ(map.info().height, side) << size;
    }
}

TEST(NewMap, HoldsWhatItsAbsenceMeans) {
    NewMapStage s;
    EXPECT_EQ(s.made("lawn.GrassField.species[lawn].density").mean(), 1);
    const Map directions = s.made("lawn.GrassField.orientation"), colours = s.made("lawn.GrassField.vegetation");
    EXPECT_NEAR(static_cast<double>(directions.at(3, 3, 0)), 0.5, 0.01) << "no direction";
    EXPECT_EQ(colours.at(3, 3, 3), 0) << "transparent";
}

TEST(NewMap, IsDescribedBySizeFinenessAndMemory) {
    NewMapStage s;
    const auto f = findField(s.doc.project(), tables().components, "lawn.GrassField.species[lawn].density");
    ASSERT_TRUE(f);
    EXPECT_TRUE(describeNewMap(s.doc.project(), *f).starts_with("512 x 512 texels, 12.8 a metre, "))
        << describeNewMap(s.doc.project(), *f);
}

}  // namespace
}  // namespace sward
