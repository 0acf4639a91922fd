// Frames of two states in turn, by one renderer or by two.
#include "cost/paired_frames.h"

#include "scenes.h"

namespace sward::test {
namespace {

Project lawnOf(float density) {
    Project p = lawn();
    p.registry.get<GrassField>(findEntity(p, "grass"))->species[0].density =
        field(filled({64, 64, 1, PixelType::U16}, density));
    return p;
}
ViewSettings tiny() {
    ViewSettings s;
    s.width = 48, s.height = 36, s.msaa = 1;
    return s;
}

// Counts, not times: ten times the blades are more in every pair, and the other way round fewer.
TEST(PairedFramesDrawn, TenTimesTheBladesAreMoreInEveryPair) {
    NoGlErrors errors;
    Renderer renderer(gpu(), tables());
    const Project before = lawnOf(0.1f), now = lawnOf(1);
    for (const bool more : {true, false}) {
        PairedFrames frames{.pairs = 3, .settles = true};
        while (!allDrawn(frames))
            ASSERT_TRUE(drawNext(frames, {{{renderer, more ? now : before}, {renderer, more ? before : now}}},
                                 eyeHeight(), tiny()));
        EXPECT_EQ(frames.drawn, 12) << "one uncounted before each";
        EXPECT_EQ(framesOf(frames), 12);
        ASSERT_EQ(frames.ms[0].size(), 3u);
        ASSERT_EQ(frames.ms[1].size(), 3u);
        const PairedDifference blades = bladesBetween(frames);
        EXPECT_EQ(blades.pairs, 3);
        EXPECT_EQ(blades.low, blades.high) << "each frame draws the same blades";
        EXPECT_GT(more ? blades.low : -blades.low, 1000);
        EXPECT_EQ(msBetween(frames).pairs, 3);
    }
}

TEST(PairedFramesDrawn, AnInterruptedPairDrawsItsUncountedFrameAgain) {
    NoGlErrors errors;
    Renderer renderer(gpu(), tables());
    const Project p = lawnOf(0.5f);
    const std::array<FrameSide, 2> sides{{{renderer, p}, {renderer, p}}};
    PairedFrames frames{.pairs = 1, .settles = true};
    interrupt(frames);
    EXPECT_EQ(frames.drawn, 0) << "nothing was drawn yet";
    ASSERT_TRUE(drawNext(frames, sides, eyeHeight(), tiny()));
    interrupt(frames);
    EXPECT_EQ(frames.drawn, 0);
    ASSERT_TRUE(drawNext(frames, sides, eyeHeight(), tiny()));
    ASSERT_TRUE(drawNext(frames, sides, eyeHeight(), tiny()));
    interrupt(frames);
    EXPECT_EQ(frames.drawn, 2) << "what was timed stays";
    EXPECT_EQ(frames.ms[0].size(), 1u);
    PairedFrames two{.pairs = 2};
    Renderer other(gpu(), tables());
    while (!allDrawn(two)) {
        ASSERT_TRUE(drawNext(two, {{{renderer, p}, {other, p}}}, eyeHeight(), tiny()));
        interrupt(two);
    }
    EXPECT_EQ(two.drawn, 4) << "renderers of their own need no uncounted frame";
}

}  // namespace
}  // namespace sward::test
