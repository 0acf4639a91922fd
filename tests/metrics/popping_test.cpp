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

// Grass that moves: what stands still is farther from it than any other grass that moves as much, and so is what moves
// half as much.
TEST(Popping, OfTooLittleChangeIsAnErrorToo) {
    const auto moving = [](int i) { return noise(64, 64, static_cast<unsigned>(i)); };
    const auto others = [](int i) { return noise(64, 64, static_cast<unsigned>(100 + i)); };
    const auto frozen = [](int) { return noise(64, 64, 0); };
    const auto lazy = [](int i) { return noise(64, 64, static_cast<unsigned>(100 + i), 0.2f); };
    const Popping floor = *film(5, others, moving), still = *film(5, frozen, moving), half = *film(5, lazy, moving);
    EXPECT_GT(still.mean, 2 * floor.mean);
    EXPECT_GT(half.mean, 1.2 * floor.mean);
    EXPECT_LT(half.mean, still.mean);
    EXPECT_EQ(still.change, 0);
    EXPECT_NEAR(floor.change, 1, 0.05);
    EXPECT_NEAR(half.change, 0.5, 0.05);
}
// All of it gets darker where the truth gets brighter by as much: the same amount of change, the wrong way.
TEST(Popping, OfChangeTheWrongWayIsFound) {
    const auto brighter = [](int i) { return noise(32, 32, 1, 0.2f, 0.05f * static_cast<float>(i)); };
    const auto darker = [](int i) { return noise(32, 32, 1, 0.2f, -0.05f * static_cast<float>(i)); };
    EXPECT_NEAR(film(3, darker, brighter)->mean, 0.1, 1e-6);
}
// A truth whose rays scatter changes no more than the scene does.
TEST(Popping, ScatterOfTheTruthsRaysIsNoChange) {
    const auto still = [](int) { return noise(64, 64, 1, 0.2f); };
    const auto scattered = [](int i) {
        Picture p = noise(64, 64, 1, 0.2f);
        const Picture by = noise(64, 64, static_cast<unsigned>(10 + i), 0.1f);  // variance 0.1^2 / 3
        for (size_t k = 0; k < p.pixels.size(); ++k) p.pixels[k] += by.pixels[k] - 0.5f;
        p.noise.assign(p.pixels.size(), glm::vec3(0.01f / 3));
        return p;
    };
    const auto unknown = [&](int i) {
        Picture p = scattered(i);
        p.noise.clear();
        return p;
    };
    EXPECT_LT(film(4, still, scattered)->mean, 0.6 * film(4, still, unknown)->mean);
}

TEST(Popping, RefusesAPathOfOnePictureOrOfSeveralSizes) {
    EXPECT_FALSE(film(
        1, [](int) { return noise(8, 8, 1); }, [](int) { return noise(8, 8, 1); }));
    const auto grows = [](int i) { return plain(8 + i, 8, glm::vec3(0)); };
    EXPECT_FALSE(film(2, grows, grows));
}

}  // namespace
}  // namespace sward::test
