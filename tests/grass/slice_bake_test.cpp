#include "grass/slice_bake.h"

#include <gtest/gtest.h>

#include <set>
#include <thread>

#include "core/numerics.h"

namespace sward::test {
namespace {

Rgba8 whiteImage() { return {1, 1, std::vector<uint8_t>(4, 255)}; }

// One blade in a cell of half a metre, straight and upright, its strip all there.
SliceSpec lone(uint32_t seed) {
    SliceSpec s;
    s.species.bladesPerM2 = 4;
    s.species.height = 0.3f, s.species.width = 0.1f;
    s.species.bend = s.species.leanDeg = s.species.leanVariationDeg = 0;
    s.species.rootOcclusion = 1;
    s.seed = seed;
    s.width = s.height = s.farSize = 64;
    s.slices = 5;
    s.blade = whiteImage();
    return s;
}
// A thousand blades of the default kind.
SliceSpec meadow() {
    SliceSpec s;
    s.species.bladesPerM2 = 4000;
    s.width = 64, s.height = 32, s.farSize = 64, s.slices = 4;
    s.blade = makeBladeImage(16, 64);
    return s;
}
SliceImages baked(const SliceSpec& s) {
    JobControl control;
    auto made = bakeSlices(s, control);
    EXPECT_TRUE(made);
    EXPECT_EQ(control.progress(), 1);
    return std::move(*made);
}
const Blade blade(const SliceSpec& s) { return makePatch(s.species, s.cellSize, s.seed).blades.at(0); }

// Samples that are covered, in all layers from `first` on: 16 a texel, so that bytes give their number exactly.
int samplesIn(const SliceLevel& l, size_t first, size_t layers) {
    const size_t n = static_cast<size_t>(l.width) * static_cast<size_t>(l.height);
    int sum = 0;
    for (size_t i = first * n; i < (first + layers) * n; ++i)
        sum += static_cast<int>(std::lround(l.threshold[4 * i + 1] * 16 / 255.0));
    return sum;
}
double meanOpacity(const SliceLevel& l) {
    double sum = 0;
    for (size_t i = 1; i < l.threshold.size(); i += 4) sum += l.threshold[i] / 255.0;
    return 4 * sum / static_cast<double>(l.threshold.size());
}

TEST(SliceBake, EachSampleOfABladeIsInExactlyOneSlabOfEachDirection) {
    for (uint32_t seed = 1; seed <= 8; ++seed) {
        SliceSpec whole = lone(seed), parts = lone(seed);
        whole.slices = 1;
        const SliceLevel one = baked(whole).vertical[0];
        for (const int n : {2, 5, 10, 64}) {
            parts.slices = n;
            const SliceLevel many = baked(parts).vertical[0];
            const size_t k = static_cast<size_t>(n);
            EXPECT_EQ(samplesIn(many, 0, k), samplesIn(one, 0, 1)) << "along x, seed " << seed << ", " << n << " slabs";
            EXPECT_EQ(samplesIn(many, k, k), samplesIn(one, 1, 1)) << "along z, seed " << seed << ", " << n << " slabs";
        }
    }
}

TEST(SliceBake, SlabsBeginAtTheirOwnBoundaryAndEndBeforeTheNext) {
    for (int n = 1; n <= 64; ++n)
        for (int k = 0; k < n; ++k) {
            const float at = static_cast<float>(static_cast<double>(k) / n);
            const int slab = f32::captureSlice(at, n), next = f32::captureSlice(std::nextafter(at, 1.0f), n);
            EXPECT_LE(std::abs(slab - k), at * static_cast<float>(n) < static_cast<float>(k) ? 1 : 0)
                << k << " of " << n;
            EXPECT_TRUE(next == slab || next == slab + 1);
        }
}

TEST(SliceBake, BladesThatReachOverTheSeamComeInAtTheOtherSide) {
    int crossing = 0;
    for (uint32_t seed = 1; seed <= 48; ++seed) {
        const SliceSpec s = lone(seed);
        const Blade b = blade(s);
        const f32::BladeFrame f = f32::bladeFrameFacing(b.control, b.tip, b.facing, 0.5f);
        const SliceImages images = baked(s);
        const SliceLevel& l = images.vertical[0];
        const float texel = s.cellSize / static_cast<float>(l.width) * images.top / static_cast<float>(l.height);
        for (int axis = 0; axis < 2; ++axis) {
            const float across = std::abs(axis == 0 ? f.side.z : f.side.x) * b.width;
            const float area = static_cast<float>(samplesIn(l, axis == 0 ? 0 : 5, 5)) / 16 * texel;
            EXPECT_NEAR(area, across * b.tip.y, 0.0006f)
                << "seed " << seed << ", axis " << axis << ", root " << b.root.x << " " << b.root.y;
            const float at = axis == 0 ? b.root.y : b.root.x;
            crossing += at < across / 2 || at + across / 2 > s.cellSize;
        }
    }
    EXPECT_GT(crossing, 3) << "too few blades stood at a seam to show anything";
}

TEST(SliceBake, DenseGrassCoversAsMuchAtTheSeamAsElsewhere) {
    const SliceImages images = baked(meadow());
    const SliceLevel& l = images.far[0];
    const auto column = [&](int x) {
        double sum = 0;
        for (int y = 0; y < l.height; ++y) sum += l.threshold[static_cast<size_t>(4 * (y * l.width + x) + 1)] / 255.0;
        return sum / l.height;
    };
    double all = 0;
    for (int x = 0; x < l.width; ++x) all += column(x) / l.width;
    for (const int x : {0, 1, 2, l.width - 3, l.width - 2, l.width - 1}) EXPECT_NEAR(column(x), all, 0.12) << x;
}

TEST(SliceBake, MeanOpacityIsTheSameOnEveryMip) {
    const SliceImages images = baked(meadow());
    for (const auto* levels : {&images.vertical, &images.far}) {
        ASSERT_GE(levels->size(), 7u);
        EXPECT_GT(meanOpacity(levels->front()), 0.05);
        for (const SliceLevel& l : *levels)
            EXPECT_NEAR(meanOpacity(l), meanOpacity(levels->front()), 0.01) << l.width << " x " << l.height;
    }
}

// Mean opacity that a level shows at a density.
double shown(const SliceLevel& l, int level, double density, double fade) {
    double sum = 0;
    for (size_t i = 0; i < l.threshold.size(); i += 4)
        sum += f64::texelOpacity(l.threshold[i] / 255.0, l.threshold[i + 1] / 255.0, density, fade, level,
                                 f64::sownEvenly(), 0.5);
    return 4 * sum / static_cast<double>(l.threshold.size());
}
// The greatest error over levels and densities, held against images so fine that a texel is a part of one blade.
// `mere`: the error of an opacity that is as much less as the density is.
struct CoverError {
    double ours = 0, mere = 0;
};
CoverError coverError(float bladesPerM2, float width) {
    SliceSpec s = meadow();
    s.species.bladesPerM2 = bladesPerM2, s.species.width = width;
    s.cellSize = 0.25f, s.slices = 5;
    s.width = s.farSize = 256, s.height = 64;  // as at a project's resolution
    const SliceImages images = baked(s);
    s.width = s.farSize = 512, s.height = 128;
    const SliceImages fine = baked(s);
    CoverError worst;
    for (const double density : {0.0, 0.1, 0.25, 0.4, 0.5, 0.6, 0.75, 0.9, 1.0})
        for (const auto levels : {&SliceImages::vertical, &SliceImages::far}) {
            const double blades = shown((fine.*levels)[0], 0, density, 0);
            worst.mere = std::max(worst.mere, std::abs(density * meanOpacity((fine.*levels)[0]) - blades));
            for (int l = 0; l <= 6; ++l)
                worst.ours = std::max(
                    worst.ours, std::abs(shown((images.*levels)[static_cast<size_t>(l)], l, density, 0.4) - blades));
        }
    return worst;
}

TEST(SliceBake, EachLevelShowsAtADensityWhatTheBladesThatAreThenThereCover) {
    EXPECT_LE(coverError(4000, 0.004f).ours, 0.02);
    const CoverError crowded =
        coverError(8000, 0.012f);  // six blades one behind the other: those behind a hidden one are seen
    EXPECT_GT(crowded.mere, 0.1);
    EXPECT_LE(crowded.ours, 0.08);
}

TEST(SliceBake, HiddenBladesLeaveNoOutline) {
    for (uint32_t seed = 1; seed <= 6; ++seed) {
        const SliceSpec s = lone(seed);
        const double threshold = static_cast<double>(blade(s).threshold), below = threshold - 0.02;
        if (below <= 0) continue;
        const SliceLevel l = baked(s).vertical[0];
        for (size_t i = 0; i < l.threshold.size(); i += 4)
            EXPECT_LT(f64::texelOpacity(l.threshold[i] / 255.0, l.threshold[i + 1] / 255.0, below, 0, 0,
                                        f64::sownEvenly(), 0.5),
                      1e-9)
                << "opacity " << int(l.threshold[i + 1]);
    }
}

TEST(SliceBake, ThresholdsAreExactWhereOneBladeFillsATexel) {
    for (uint32_t seed = 1; seed <= 8; ++seed) {
        const SliceSpec s = lone(seed);
        const int k = static_cast<int>(std::lround(blade(s).threshold * 255));
        const SliceLevel l = baked(s).vertical[0];
        int full = 0;
        for (size_t i = 0; i < l.threshold.size(); i += 4)
            if (l.threshold[i + 1] == 255) {
                EXPECT_EQ(l.threshold[i], k);
                ++full;
            }
        EXPECT_GT(full, 20);
    }
}

TEST(SliceBake, NumbersOfLightGiveBackTheNormalOfALoneBlade) {
    for (uint32_t seed = 1; seed <= 8; ++seed) {
        const SliceSpec s = lone(seed);
        const glm::vec2 facing = blade(s).facing;
        const SliceLevel l = baked(s).vertical[0];
        const size_t n = static_cast<size_t>(l.width) * static_cast<size_t>(l.height), half = 5 * n;
        for (size_t i = 0; i < 2 * half; ++i) {
            if (l.threshold[4 * i + 1] != 255) continue;
            const float along = i < half ? facing.x : facing.y, across = i < half ? facing.y : facing.x,
                        turn = along < 0 ? -1.0f : 1.0f;
            const auto light = [](const std::vector<uint8_t>& image, size_t at) { return image[at] / 255.0f; };
            EXPECT_NEAR(light(l.front, 4 * i), std::abs(along), 0.01f);
            EXPECT_NEAR(light(l.front, 4 * i + 2) - light(l.front, 4 * i + 3), across * turn, 0.01f);
            EXPECT_NEAR(light(l.back, 4 * i), std::abs(along), 0.01f);
            EXPECT_NEAR(light(l.back, 4 * i + 2) - light(l.back, 4 * i + 3), -across * turn, 0.01f) << "its other side";
            EXPECT_EQ(l.front[4 * i + 1], 0) << "no blade reflects light from straight behind it";
            EXPECT_LE(std::abs(l.threshold[4 * i + 2] - l.threshold[4 * i + 3]), 2) << "it stands upright";
        }
    }
}

TEST(SliceBake, ReflectanceNeverSaturates) {
    for (const glm::vec3& color : {glm::vec3(1), glm::vec3(1, 0, 0), glm::vec3(0.05f, 0.2f, 0.02f), glm::vec3(0)}) {
        SliceSpec s = meadow();
        s.species.rootColor = s.species.midColor = s.species.tipColor = color;
        s.species.hueVariationDeg = 30, s.species.lightnessVariation = 0.5f;
        const SliceImages images = baked(s);
        EXPECT_GT(images.reflectScale, 0);
        for (const auto* levels : {&images.vertical, &images.far})
            for (size_t i = 0; i < levels->front().reflectance.size(); ++i)
                if (i % 4 != 3)
                    ASSERT_LT(levels->front().reflectance[i], 255) << color.x << " " << color.y << " " << color.z;
    }
}

TEST(SliceBake, IsTheSameEachTimeAndReadsOnlyWhatItsKeySays) {
    SliceSpec s = meadow();
    const SliceImages a = baked(s);
    s.species.translucency = 1, s.species.gloss = 2, s.species.roughness = 0.1f, s.species.name = "other",
    s.species.leanDeg = 30, s.species.clumpSize = 1;
    const SliceImages b = baked(s);
    EXPECT_EQ(sliceKey(meadow()), sliceKey(s));
    for (size_t l = 0; l < a.vertical.size(); ++l) {
        EXPECT_EQ(a.vertical[l].reflectance, b.vertical[l].reflectance);
        EXPECT_EQ(a.vertical[l].threshold, b.vertical[l].threshold);
        EXPECT_EQ(a.vertical[l].front, b.vertical[l].front);
        EXPECT_EQ(a.vertical[l].back, b.vertical[l].back);
    }
}

TEST(SliceBake, TheKeyIsAnotherForEachInput) {
    const std::function<void(SliceSpec&)> changes[] = {[](SliceSpec& s) { s.species.bladesPerM2 *= 2; },
                                                       [](SliceSpec& s) { s.species.height *= 2; },
                                                       [](SliceSpec& s) { s.species.heightVariation += 0.1f; },
                                                       [](SliceSpec& s) { s.species.width *= 2; },
                                                       [](SliceSpec& s) { s.species.bend += 0.1f; },
                                                       [](SliceSpec& s) { s.species.leanVariationDeg += 1; },
                                                       [](SliceSpec& s) { s.species.hueVariationDeg += 1; },
                                                       [](SliceSpec& s) { s.species.lightnessVariation += 0.1f; },
                                                       [](SliceSpec& s) { s.species.rootColor.x += 0.1f; },
                                                       [](SliceSpec& s) { s.species.midColor.y += 0.1f; },
                                                       [](SliceSpec& s) { s.species.tipColor.z += 0.1f; },
                                                       [](SliceSpec& s) { s.species.rootOcclusion += 0.1f; },
                                                       [](SliceSpec& s) { s.cellSize *= 2; },
                                                       [](SliceSpec& s) { s.seed += 1; },
                                                       [](SliceSpec& s) { s.slices += 1; },
                                                       [](SliceSpec& s) { s.width *= 2; },
                                                       [](SliceSpec& s) { s.height *= 2; },
                                                       [](SliceSpec& s) { s.farSize *= 2; },
                                                       [](SliceSpec& s) { s.shadowMask = 32; },
                                                       [](SliceSpec& s) { s.blade.pixels[5] ^= 1; },
                                                       [](SliceSpec& s) { std::swap(s.blade.width, s.blade.height); }};
    std::set<uint64_t> keys{sliceKey(meadow())};
    for (size_t i = 0; i < std::size(changes); ++i) {
        SliceSpec s = meadow();
        changes[i](s);
        EXPECT_TRUE(keys.insert(sliceKey(s)).second) << "change " << i;
    }
}

TEST(SliceBake, ShadedBladesAreDarkerBelowAndAsBrightAtTheirTips) {
    SliceSpec s = meadow();
    s.species.bladesPerM2 = 20000, s.species.heightVariation = 0.1f;
    s.shadowMask = 32;
    const SliceLevel l = baked(s).vertical[0];
    const auto row = [&](int y) {
        double sum = 0, n = 0;
        for (int x = 0; x < l.width; ++x) {
            const size_t i = static_cast<size_t>(y * l.width + x) * 4;
            if (l.threshold[i + 1] == 0) continue;
            sum += l.front[i] / 255.0;
            ++n;
        }
        return n > 0 ? sum / n : 0;
    };
    EXPECT_LT(row(1), 0.5 * row(l.height * 3 / 4));
}

TEST(SliceBake, CancelledItGivesNothing) {
    JobControl before;
    before.cancel();
    const auto none = bakeSlices(meadow(), before);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ExitCode::Interrupted);
    SliceSpec large = meadow();
    large.species.bladesPerM2 = 40000, large.width = 1024, large.height = 256, large.slices = 32;
    JobControl during;
    std::thread person([&] {
        while (during.progress() <= 0) std::this_thread::yield();
        during.cancel();
    });
    EXPECT_FALSE(bakeSlices(large, during));
    person.join();
    EXPECT_LT(during.progress(), 1) << "it went on to the end";
}

TEST(SliceBake, WithoutBladesAllIsTransparentAndOddSizesBecomePowersOfTwo) {
    SliceSpec s = meadow();
    s.species.bladesPerM2 = 0;
    s.width = 33, s.height = 5, s.farSize = 1, s.slices = 1000;
    const SliceImages images = baked(s);
    EXPECT_EQ(images.slices, kMaxSlices);
    EXPECT_EQ(images.vertical[0].width, 64);
    EXPECT_EQ(images.vertical[0].height, 8);
    EXPECT_EQ(images.far[0].width, 1);
    EXPECT_GT(images.top, 0);
    for (const auto* levels : {&images.vertical, &images.far})
        for (const SliceLevel& l : *levels) EXPECT_EQ(meanOpacity(l), 0);
}

}  // namespace
}  // namespace sward::test
