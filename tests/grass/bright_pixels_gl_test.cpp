// No pixel is brighter than the scene's lights can make it: what is interpolated over blades thinner than a pixel runs
// outside of them, hundreds of times their size. The long form, 2,000 pictures of all sample projects: bench --limits
// --filter=bright.
#include "grass/bright_pixels.h"

#include "project/project_files.h"
#include "scenes.h"

namespace sward::test {
namespace {

// The sample project tornado, of which some pixels were 25 to 2,000 times as bright as all others.
TEST(BrightPixels, OfBladesThinnerThanAPixelAreNoMoreThanTheLightsGive) {
    NoGlErrors errors;
    auto tornado = loadProject(SWARD_SOURCE_DIR "/projects/tornado", tables().components);
    ASSERT_TRUE(tornado) << tornado.error().text();
    Project& p = *tornado;
    const ViewCamera human = viewOf(*findCamera(p, "human"));
    Renderer r(gpu(), tables());
    BrightPixels found;
    lookFrom(r, p, human, -1, 1, 4, found);  // as it ships: frames add up
    ASSERT_TRUE(removeEntity(p, "antialias"));
    flatField(p).leastPixels = 0;
    for (const Transparency way : {Transparency::Coverage, Transparency::Blend}) {
        setTransparency(p, way);
        for (const int msaa : {4, 1}) lookFrom(r, p, human, -1, msaa, 4, found);
        for (uint32_t n = 0; n < 2; ++n) lookFrom(r, p, placeToLook(p, n, n), n, 4, 4, found);
    }
    EXPECT_EQ(found.frames, 9);
    EXPECT_EQ(found.pixels, 0) << "brightest: " << found.worst << " times what the lights give";
    EXPECT_GT(found.worst, 0.02) << "something is lit";
}

}  // namespace
}  // namespace sward::test
