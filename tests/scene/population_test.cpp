#include "scene/population.h"

#include <gtest/gtest.h>

#include <cstring>

#include "core/numerics.h"

namespace sward {
namespace {

Species species(float bladesPerM2) {
    Species s;
    s.bladesPerM2 = bladesPerM2;
    return s;
}

TEST(Population, APatchHoldsDensityTimesArea) {
    EXPECT_EQ(makePatch(species(2000), 0.5f, 1).blades.size(), 500u);
    EXPECT_EQ(makePatch(species(87815), 0.5f, 1).blades.size(), 21954u) << "21953.75: the last is not in every cell";
    EXPECT_EQ(makePatch(species(0), 0.5f, 1).blades.size(), 0u);
    EXPECT_EQ(makePatch(species(4), 0.5f, 1).blades.size(), 1u);
}

// Blades of 512 x 512 cells where the density is 1 or painted; by their thresholds there.
double countBlades(const Patch& p, float density, uint32_t seed) {
    uint64_t n = 0;
    for (int z = 0; z < 512; ++z)
        for (int x = 0; x < 512; ++x) {
            const float chance = f32::cellChance(x, z, seed);
            for (const Blade& b : p.blades) {
                if (f32::thresholdIn(b.threshold, p.sown, chance) > density) break;
                ++n;
            }
        }
    return static_cast<double>(n);
}

// 0.1 to 100,000 blades a m2 in cells of 0.05 to 4 m: within three deviations, of which a cell has at most half a
// blade's, and half a per cent.
TEST(Population, FieldsHaveTheirBladesHoweverFewACellHas) {
    for (const float perM2 : {0.1f, 1.0f, 2.0f, 5.9f, 37.0f, 100.0f, 250.5f, 1999.0f, 20000.3f, 100000.0f})
        for (const float size : {0.05f, 0.13f, 0.25f, 0.5f, 1.0f, 4.0f}) {
            const double expected = static_cast<double>(perM2) * static_cast<double>(size) * static_cast<double>(size);
            if (expected > 3000) continue;  // none is of few blades, and counting takes long
            const Species s = species(perM2);
            const Patch p = makePatch(s, size, 7);
            for (const float density : {1.0f, 0.5f, 0.1f}) {
                if (p.sown.step == 0 && density < 1) continue;  // as before: within one blade a cell
                const double all = expected * static_cast<double>(density) * 512 * 512,
                             share = expected * static_cast<double>(density) -
                                     std::floor(expected * static_cast<double>(density)),
                             off = std::abs(countBlades(p, density, sowingSeed(s, 7)) - all);
                const double few =
                    expected < 255 ? 0 : static_cast<double>(512 * 512);  // blades that share a threshold
                EXPECT_LE(off, 3 * 512 * std::sqrt(share * (1 - share)) + 1e-5 * all + (density < 1 ? few : 0))
                    << perM2 << " a m2, " << size << " m, density " << density;
                if (all > 40000 && expected < 255)
                    EXPECT_LE(off, 0.005 * all) << perM2 << ' ' << size << ' ' << density;
            }
        }
}

TEST(Population, WholeNumbersOfManyBladesAreTheSameInEveryCell) {
    for (const float perM2 : {512.0f, 1000.0f, 8000.0f, 80000.0f}) {
        const Patch p = makePatch(species(perM2), 0.5f, 1);
        EXPECT_EQ(p.sown.step, 0);
        EXPECT_EQ(p.blades.size(), static_cast<size_t>(perM2 / 4));
        for (const Blade& b : p.blades)
            for (const float chance : {0.0f, 0.3f, 0.999f})
                ASSERT_EQ(f32::thresholdIn(b.threshold, p.sown, chance), b.threshold);
    }
}

TEST(Population, BareGroundIsBareWhateverACellsChance) {
    for (const float perM2 : {0.1f, 1.0f, 3.0f, 40.0f, 1001.0f})
        for (const Blade& b : makePatch(species(perM2), 0.5f, 1).blades)
            for (const float chance : {0.0f, 0.5f, 0.9999999f})
                ASSERT_GT(f32::thresholdIn(b.threshold, makePatch(species(perM2), 0.5f, 1).sown, chance), 0) << perM2;
}

TEST(Population, BladesAreSortedByThresholdsOfWholeTwoHundredFiftyFifths) {
    const Patch p = makePatch(species(8000), 0.5f, 3);
    uint32_t counted = 0;
    for (size_t i = 0; i < p.blades.size(); ++i) {
        const float k = p.blades[i].threshold * 255;
        EXPECT_NEAR(k, std::round(k), 1e-4);
        EXPECT_GE(k, 0.999f);
        EXPECT_LE(k, 255.001f);
        if (i > 0) EXPECT_LE(p.blades[i - 1].threshold, p.blades[i].threshold);
    }
    for (int k = 0; k <= 255; ++k) {
        while (counted < p.blades.size() && p.blades[counted].threshold <= f32::thresholdOf(k)) ++counted;
        EXPECT_EQ(p.upTo[static_cast<size_t>(k)], counted) << k;
    }
    EXPECT_EQ(p.upTo[255], p.blades.size());
}

TEST(Population, EveryDensityKeepsItsShareOfTheBlades) {
    const Patch p = makePatch(species(8000), 0.5f, 3);
    for (int k = 0; k <= 255; ++k) EXPECT_NEAR(p.upTo[static_cast<size_t>(k)], k / 255.0 * 2000, 9) << k;
}

TEST(Population, RootsAreStratifiedAndInsideTheirCell) {
    const Patch p = makePatch(species(4 * 1024), 0.5f, 9);  // 1024 blades: 32 x 32 strata
    std::vector<int> strata(1024);
    for (const Blade& b : p.blades) {
        ASSERT_GE(b.root.x, 0);
        ASSERT_LT(b.root.x, 0.5f);
        ASSERT_GE(b.root.y, 0);
        ASSERT_LT(b.root.y, 0.5f);
        ++strata[static_cast<size_t>(b.root.y * 64) * 32 + static_cast<size_t>(b.root.x * 64)];
    }
    EXPECT_TRUE(std::all_of(strata.begin(), strata.end(), [](int n) { return n == 1; }));
}

TEST(Population, ThinnedGrassStaysSpreadOverTheCell) {
    const Patch p = makePatch(species(16000), 0.5f, 5);
    int quarter[4] = {0, 0, 0, 0};
    for (uint32_t i = 0; i < p.upTo[51]; ++i)
        ++quarter[(p.blades[i].root.x > 0.25f) + 2 * (p.blades[i].root.y > 0.25f)];
    for (int n : quarter) EXPECT_NEAR(n, p.upTo[51] / 4.0, 4 * std::sqrt(p.upTo[51] / 4.0));
}

TEST(Population, NoBladeGoesUnderTheGroundAndAllAreFinite) {
    Species s = species(20000);
    s.bend = 1;
    s.leanVariationDeg = 60;
    for (const Blade& b : makePatch(s, 0.5f, 2).blades) {
        for (float v = 0; v <= 1; v += 0.125f) {
            const f32::BladeFrame f = f32::bladeFrameFacing(b.control, b.tip, b.facing, v);
            ASSERT_GE(f.position.y, -1e-6f);
            ASSERT_NEAR(glm::length(f.normal), 1, 1e-5f);
        }
        ASSERT_NEAR(glm::length(b.facing), 1, 1e-5f);
        ASSERT_GT(b.dither, 0);
        ASSERT_LE(b.dither, 1);
    }
}

TEST(Population, TheSameSeedGivesTheSamePatchAndAnotherAnother) {
    const Patch a = makePatch(species(2000), 0.5f, 1), b = makePatch(species(2000), 0.5f, 1),
                c = makePatch(species(2000), 0.5f, 2);
    EXPECT_EQ(std::memcmp(a.blades.data(), b.blades.data(), a.blades.size() * sizeof(Blade)), 0);
    EXPECT_NE(std::memcmp(a.blades.data(), c.blades.data(), a.blades.size() * sizeof(Blade)), 0);
}

TEST(Population, ThePatchKeyChangesWithEveryFieldThatShapesIt) {
    const Species base = species(2000);
    const uint64_t key = patchKey(base, 0.5f, 1);
    EXPECT_NE(patchKey(base, 0.25f, 1), key);
    EXPECT_NE(patchKey(base, 0.5f, 2), key);
    for (float Species::*f :
         {&Species::bladesPerM2, &Species::height, &Species::heightVariation, &Species::width, &Species::bend,
          &Species::leanVariationDeg, &Species::hueVariationDeg, &Species::lightnessVariation}) {
        Species s = base;
        s.*f += 0.01f;
        EXPECT_NE(patchKey(s, 0.5f, 1), key);
    }
}

TEST(CellVersions, ABladeStandsInItsCellWhereTheCellsImageShowsIt) {
    const float size = 0.5f;
    for (int cell = 0; cell < 200; ++cell) {
        const f32::CellVersion v = f32::cellVersion(cell, 7 - cell, 3);
        for (const glm::vec2 root :
             {glm::vec2(0), glm::vec2(0.1f, 0.37f), glm::vec2(std::nextafter(size, 0.0f), 0.25f)}) {
            const glm::vec2 at = f32::rootInCell(root, v.mirror, v.shift, size),
                            back = f32::placeInPatch(at / size, v.mirror, v.shift) * size;
            ASSERT_EQ(glm::clamp(at, glm::vec2(0), glm::vec2(size)), at);
            const glm::vec2 apart = glm::abs(back - root) / size;  // but for whole cells
            EXPECT_LT(glm::length(apart - glm::round(apart)), 1e-5f);
        }
    }
}

TEST(CellVersions, AreEvenOverFifths) {
    const int n = f32::kPatchStarts;
    std::array<int, n> x{}, z{};
    for (int i = 0; i < 200; ++i)
        for (int j = 0; j < 200; ++j) {
            const f32::CellVersion v = f32::cellVersion(i, j, 9);
            const glm::vec2 k = v.shift * float(n);
            ASSERT_LT(glm::length(k - glm::round(k)), 1e-5f);
            ++x[static_cast<size_t>(std::lround(k.x))], ++z[static_cast<size_t>(std::lround(k.y))];
        }
    for (const auto& counts : {x, z})
        for (const int c : counts) EXPECT_NEAR(c, 8000, 4 * std::sqrt(8000 * 0.8));
}

TEST(Pose, ALeaningBladeKeepsItsLengthAndStaysAboveGround) {
    const Patch p = makePatch(species(2000), 0.5f, 1);
    for (const Blade& b : p.blades)
        for (const glm::vec2 lean : {glm::vec2(0), glm::vec2(0.4f, 0.1f), glm::vec2(-3, 0.2f)}) {
            const f32::BladePose pose = f32::poseBlade(b.control, b.tip, b.facing, {1, -1}, lean, 1.0f);
            EXPECT_NEAR(glm::length(pose.tip), glm::length(b.tip), 1e-6f);
            EXPECT_GE(pose.tip.y, 0);
            EXPECT_GE(pose.control.y, 0);
            EXPECT_NEAR(glm::length(pose.facing), 1, 1e-5f);
        }
}

// Mean of twice their azimuths as unit vectors: 0 where faces are spread over all ways, 1 where all lie in one plane.
float alike(std::span<const glm::vec2> facings) {
    glm::vec2 sum(0);
    for (const glm::vec2& f : facings) sum += glm::vec2(f.x * f.x - f.y * f.y, 2 * f.x * f.y);
    return glm::length(sum) / static_cast<float>(facings.size());
}

TEST(Pose, PaintLeansBladesAndLeavesTheSpreadOfTheirFaces) {
    const Patch p = makePatch(species(4000), 0.5f, 1);
    std::vector<glm::vec2> facings, reaches;
    double along = 0;
    for (const Blade& b : p.blades) {
        const f32::BladePose pose = f32::poseBlade(b.control, b.tip, b.facing, {1, 1}, {0.9f, 0}, 1.0f);
        facings.push_back(pose.facing);
        reaches.push_back(glm::normalize(glm::vec2(pose.tip.x, pose.tip.z)));
        along += static_cast<double>(pose.tip.x / glm::length(pose.tip)) / static_cast<double>(p.blades.size());
    }
    EXPECT_GT(along, 0.6) << "they lean where paint says";
    EXPECT_LT(alike(facings), 0.1f);
    EXPECT_GT(alike(reaches), 0.6f) << "faces that followed the lean would lie in one plane";
}

TEST(Pose, AWeakWindOfAnyDirectionTurnsNoFace) {
    const Patch p = makePatch(species(2000), 0.5f, 1);
    for (const Blade& b : p.blades)
        for (int i = 0; i < 16; ++i) {
            const float a = f32::kTau * static_cast<float>(i) / 16;
            const f32::BladePose pose =
                f32::poseBlade(b.control, b.tip, b.facing, {-1, 1}, 0.03f * glm::vec2(std::cos(a), std::sin(a)), 1.0f);
            ASSERT_EQ(pose.facing, glm::vec2(-b.facing.x, b.facing.y)) << i;
        }
}

TEST(Pose, StoodUpTakesThePlacesLeanOffAgain) {
    const Patch p = makePatch(species(2000), 0.5f, 1);
    for (const Blade& b : p.blades)
        for (const glm::vec2 lean : {glm::vec2(0), glm::vec2(0.4f, 0.1f), glm::vec2(-0.3f, 0.5f)}) {
            const f32::BladePose pose = f32::poseBlade(b.control, b.tip, b.facing, {1, 1}, lean, 1.0f);
            if (b.tip.y >= b.control.y)
                EXPECT_LT(glm::length(f32::stoodUp(pose.tip, pose.upright) - b.tip),
                          1e-4f * glm::length(b.tip) / std::max(pose.tip.y / glm::length(b.tip), 0.05f))
                    << lean.x;
            if (lean.x == 0) EXPECT_LT(glm::length(f32::stoodUp({1, 1, 1}, pose.upright) - glm::vec3(1)), 1e-4f);
        }
}

TEST(Pose, BladesThatNothingLeansAreAlreadyUprightHoweverTheyAreBent) {
    for (const float bend : {0.2f, 0.75f, 1.0f}) {
        Species s = species(2000);
        s.bend = bend;
        int curled = 0;
        for (const Blade& b : makePatch(s, 0.5f, 1).blades) {
            const f32::BladePose pose = f32::poseBlade(b.control, b.tip, b.facing, {1, 1}, {0, 0}, 1.0f);
            EXPECT_LT(glm::length(f32::stoodUp({1, 1, 1}, pose.upright) - glm::vec3(1)), 0.02f) << bend;
            curled += b.tip.y < 0.05f * glm::length(b.tip);
        }
        EXPECT_EQ(curled > 0, bend > 0.5f) << "tips hang down to the ground";
    }
}

// One that lies almost flat, raised by a clump or by the wind, once shot up to many times its length.
TEST(Pose, ARaisedBladeIsHardlyHigherThanItIsLong) {
    for (const float flat : {0.05f, 0.3f, 0.8f, 1.2f})
        for (const float bent : {0.5f, 0.75f, 1.0f}) {
            const glm::vec3 tip(0.3f * std::cos(flat), 0.3f * std::sin(flat), 0), control(0.05f, 0.3f * bent, 0.02f);
            for (const float lean : {-2.0f, -0.9f, -0.4f, -0.1f, 0.0f, 0.2f}) {
                const f32::BladePose pose = f32::poseBlade(control, tip, {1, 0}, {1, 1}, {lean, 0.1f}, 1.0f);
                for (int i = 0; i <= 16; ++i)
                    EXPECT_LE(f32::bladePosition(pose.control, pose.tip, static_cast<float>(i) / 16).y, 1.15f * 0.3f)
                        << flat << " " << bent << " " << lean;
            }
        }
}

TEST(Pose, NoLeanAndNoMirrorIsThePatchsOwnBlade) {
    const Patch p = makePatch(species(2000), 0.5f, 1);
    for (const Blade& b : p.blades) {
        const f32::BladePose pose = f32::poseBlade(b.control, b.tip, b.facing, {1, 1}, {0, 0}, 1.0f);
        EXPECT_LT(glm::length(pose.tip - b.tip), 1e-6f);
        EXPECT_LT(glm::length(pose.control - b.control), 1e-6f);
    }
}

}  // namespace
}  // namespace sward
