// Samples a pixel that the driver gives are those that Sward counts on.
#include <algorithm>

#include "frame/draw_context.h"
#include "gpu/resources.h"
#include "scenes.h"

namespace sward::test {
namespace {

TEST(Samples, AreWhatTheDriverGives) {
    NoGlErrors errors;
    EXPECT_EQ(gpu().sampleCounts.front(), 1);
    EXPECT_TRUE(std::is_sorted(gpu().sampleCounts.begin(), gpu().sampleCounts.end()));
    for (const int asked : {-1, 1, 2, 3, 4, 8, 64}) {
        const int given = gpu().samplesFor(asked);
        EXPECT_GE(given, std::min(asked, gpu().sampleCounts.back()));
        if (given == 1) continue;
        const Texture t = makeTexture2DMultisample(gpu(), "test/samples", GL_RGBA16F, 8, 8, given);
        GLint has = 0;
        glGetTextureLevelParameteriv(t.id(), 0, GL_TEXTURE_SAMPLES, &has);
        EXPECT_EQ(has, given) << asked;
    }
}

}  // namespace
}  // namespace sward::test
