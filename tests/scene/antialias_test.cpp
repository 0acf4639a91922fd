#include "scene/antialias.h"

#include <gtest/gtest.h>

#include "fields.h"
#include "scenes.h"

namespace sward::test {
namespace {

TEST(AntialiasSetting, AsksForFramesThatAddUpOnlyWhereItSaysSo) {
    Project p = lawn();
    put<Antialias>(p, "pixels");
    EXPECT_FALSE(has(sceneFeatures(p.registry, tables()), Feature::Temporal));
    EXPECT_EQ(temporalOf(p), nullptr);
    setAntialias(p, Antialiasing::Temporal);
    EXPECT_TRUE(has(sceneFeatures(p.registry, tables()), Feature::Temporal));
    ASSERT_NE(temporalOf(p), nullptr);
    EXPECT_EQ(temporalOf(p)->frames, 16);
}
TEST(AntialiasSetting, MakesAnEntityOnlyWhereNoneSaysIt) {
    Project p = lawn();
    put<Light>(p, "antialias");  // the name is taken
    const size_t before = p.entities.size();
    setAntialias(p, Antialiasing::Msaa);
    EXPECT_EQ(p.entities.size(), before);
    setAntialias(p, Antialiasing::Temporal);
    EXPECT_EQ(p.entities.size(), before + 1);
    setAntialias(p, Antialiasing::Msaa);
    EXPECT_EQ(p.entities.size(), before + 1);
    EXPECT_EQ(temporalOf(p), nullptr);
}
}  // namespace
}  // namespace sward::test
