// Heights of blades from the density: lower towards edges, and only from a density that is there.
#include "model/blade_height.h"

#include <gtest/gtest.h>

#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

TEST(BladeHeight, BladesAreLowerTowardsTheEdgesOfWhereTheyGrowInOneStep) {
    test::TempDir dir;
    Document doc(tables());
    ASSERT_TRUE(doc.create(dir / "p"));
    const std::string density = "lawn.GrassField.species[lawn].density";
    Map half({512, 512, 1, PixelType::U8});  // 40 m: grass grows in the east
    for (int y = 0; y < 512; ++y)
        for (int x = 256; x < 512; ++x) half.set(x, y, 0, 1);
    ASSERT_TRUE(doc.setMap(density, std::move(half), "half"));
    ASSERT_TRUE(heightFromDensity(doc, density));
    const auto f = findField(doc.project(), tables().components, "lawn.GrassField.bladeHeight");
    ASSERT_TRUE(f);
    const Map& heights = static_cast<const MapField*>(f->value)->map;
    EXPECT_EQ(heights.sample(0.75, 0.5, 0), 1) << "far from any edge";
    EXPECT_EQ(heights.sample(0.25, 0.5, 0), 0);
    EXPECT_NEAR(static_cast<double>(heights.sample(0.5, 0.5, 0)), 0.5, 0.1) << "at the edge";
    ASSERT_TRUE(doc.undo());
    EXPECT_EQ(doc.undoLabel(), "half");
}

TEST(BladeHeight, WhatIsNoDensityOrIsNotThereIsRefused) {
    test::TempDir dir;
    Document doc(tables());
    ASSERT_TRUE(doc.create(dir / "p"));
    for (const char* path : {"lawn.GrassField.orientation", "lawn.GrassField.maxGeom", "nobody.GrassField.density"}) {
        const Status s = heightFromDensity(doc, path);
        ASSERT_FALSE(s) << path;
        EXPECT_EQ(s.error().code, ExitCode::Usage) << path;
    }
    EXPECT_FALSE(doc.canUndo());
}

}  // namespace
}  // namespace sward
