// Popping along a path: what it counts, and what not.
#include "metrics/popping.h"

#include <functional>

#include "metrics/pictures.h"

namespace sward::test {
namespace {

Result<Popping> film(size_t pictures, const std::function<Picture(int)>& image,
                     const std::function<Picture(int)>& truth) {
    return popping(pictures, [&](size_t i) -> Result<PicturePair> {
        return pairOf(image(static_cast<int>(i)), truth(static_cast<int>(i)));
    });
}

TEST(Popping, OfWhatChangesAsTheTruthDoesIsZero) {
    const auto truth = [](int i) { return noise(32, 32, static_cast<unsigned>(i)); };
    const auto brighter = [](int i) { return noise(32, 32, static_cast<unsigned>(i), 0.4f, 0.05f); };
    EXPECT_NEAR(film(4, truth, truth)->mean, 0, 1e-9);
    EXPECT_NEAR(film(4, brighter, truth)->mean, 0, 1e-6) << "a constant error does not pop";
}

TEST(Popping, OfAStepIsFoundWhereItIsAndAsLargeAsItIs) {
    const auto still = [](int) { return noise(32, 32, 1, 0.2f); };
    const auto pops = [](int i) { return noise(32, 32, 1, 0.2f, i >= 3 ? 0.1f : 0); };
    const Popping p = *film(6, pops, still);
    EXPECT_EQ(p.worstStep, 2);
    EXPECT_NEAR(p.worst, 0.1, 1e-6);
    EXPECT_NEAR(p.mean, 0.02, 1e-6);
}

TEST(Popping, OfContrastThatSnapsIsSeenToo) {
    const auto still = [](int) { return noise(32, 32, 1, 0.3f); };
    const auto snaps = [](int i) { return noise(32, 32, 1, i == 0 ? 0.3f : 0.1f); };
    EXPECT_GT(film(2, snaps, still)->mean, 0.05);
}

TEST(Popping, RefusesAPathOfOnePictureOrOfSeveralSizes) {
    EXPECT_FALSE(film(
        1, [](int) { return noise(8, 8, 1); }, [](int) { return noise(8, 8, 1); }));
    const auto grows = [](int i) { return plain(8 + i, 8, glm::vec3(0)); };
    EXPECT_FALSE(film(2, grows, grows));
}

}  // namespace
}  // namespace sward::test
