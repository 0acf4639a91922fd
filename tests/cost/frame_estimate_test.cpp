#include "cost/frame_estimate.h"

#include <gtest/gtest.h>

#include "scene/project.h"
#include "techniques.h"

namespace sward {
namespace {

// A level field of 60 x 60 m with so many blades a square metre, seen from a corner.
Project meadow(const char* technique, float bladesPerM2) {
    Project p;
    p.name = "meadow";
    Terrain t;
    t.size = {60, 60};
    p.registry.add<Terrain>(*addEntity(p, "ground"), t);
    GrassField f;
    f.technique = technique;
    f.cellSize = 0.5f;
    f.species[0].bladesPerM2 = bladesPerM2;
    f.species[0].height = 0.05f;
    p.registry.add<GrassField>(*addEntity(p, "turf"), f);
    return p;
}
ViewCamera view() { return {{1, 1.7, 1}, {20, 0, 20}, 55, 0}; }
FrameEstimate estimate(const Project& p) { return estimateFrame(p, tables(), view(), 320, 240); }
std::string told(const Project& p) { return longFrameText(p, tables(), view(), 320, 240, "human"); }

TEST(FrameEstimate, CountsWhatTheViewWouldSubmit) {
    const Project p = meadow("geometry", 20000);
    const FrameEstimate e = estimate(p);
    ASSERT_EQ(e.fields.size(), 1u);
    EXPECT_EQ(e.fields[0].entity, "turf");
    EXPECT_EQ(e.fields[0].technique, "geometry");
    EXPECT_EQ(e.fields[0].blades, submittedBlades(p, tables(), view(), 320, 240));
    EXPECT_NEAR(e.seconds, static_cast<double>(e.fields[0].blades) * kSecondsABlade, 1e-9);
    EXPECT_GT(e.fields[0].blades, 20'000'000u);
    EXPECT_LT(e.fields[0].blades, 72'000'000u) << "more than there are";
}

TEST(FrameEstimate, ALongFrameSaysWhatToChangeAndThatIsShort) {
    Project p = meadow("geometry", 20000);
    const std::string text = told(p);
    EXPECT_NE(text.find("human: about "), std::string::npos) << text;
    EXPECT_NE(text.find("turf draws "), std::string::npos) << text;
    const std::string path = "turf.GrassField.technique";
    const size_t at = text.rfind(path + "=");
    ASSERT_NE(at, std::string::npos) << text;
    auto field = findField(p, tables().components, path);
    ASSERT_TRUE(field);
    ASSERT_TRUE(setFieldText(*field, text.substr(at + path.size() + 1)));
    EXPECT_LT(estimate(p).seconds, kLongFrame);
    EXPECT_EQ(told(p), "");
}

TEST(FrameEstimate, NothingIsSaidOfWhatIsShort) {
    EXPECT_EQ(told(meadow("geometry", 100)), "");
    EXPECT_EQ(told(meadow("hybrid", 20000)), "");
    EXPECT_FALSE(mayBeLong(meadow("geometry", 1000)));
    EXPECT_TRUE(mayBeLong(meadow("geometry", 20000)));
}

}  // namespace
}  // namespace sward
