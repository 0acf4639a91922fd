// Light from blade to blade as it is traced and kept. That pictures are as bright as the truth for it: LightByView.
#include "reference/traced_light.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/log.h"
#include "support.h"

namespace sward::test {
namespace {

TracedSpec denseSpec() {
    TracedSpec spec;
    Species& s = spec.species.species;
    s.name = "dense", s.bladesPerM2 = 8000, s.height = 0.08f, s.width = 0.004f;
    spec.species.cellSize = 0.25f;
    spec.species.shadowMask = 64;
    spec.species.blade = makeBladeImage(32, 128);
    return spec;
}
TracedSpec coloured(float reflectance, float translucency) {
    TracedSpec spec = denseSpec();
    Species& s = spec.species.species;
    s.rootColor = s.midColor = s.tipColor = glm::vec3(reflectance);
    s.hueVariationDeg = s.lightnessVariation = 0;
    s.translucency = translucency;
    return spec;
}
TracedTable tableOf(const TracedSpec& spec, int rays = 160) {
    JobControl control;
    const auto table = traceTable(spec, rays, control);
    EXPECT_TRUE(table) << table.error().text();
    return table ? *table : TracedTable{};
}
double meanQuotient(const TracedTable& t) {
    double local = 0, full = 0;
    for (const auto& view : t.direct)
        for (const TracedSums& s : view) local += s.local.y, full += s.full.y;
    return full / local;
}
double skyQuotient(const TracedTable& t, size_t view) { return t.sky[view].full.y / t.sky[view].local.y; }

TEST(TracedLightOf, BlackBladesSendNoLightToEachOtherAndBrightOnesDo) {
    // As many rays as are sent for pictures: under steep light the soil gets up to 0.99 of what comes half as high.
    const TracedTable dark = tableOf(coloured(0.02f, 0)), bright = tableOf(coloured(0.45f, 0.9f), 4000);
    // Of dark blades what is left is that the mask is a mean: what is lit is a little less or more than it says.
    EXPECT_NEAR(meanQuotient(dark), 1, 0.15);
    EXPECT_GT(meanQuotient(bright), 1.25 * meanQuotient(dark));
    EXPECT_GT(skyQuotient(bright, 2), 1.25 * skyQuotient(dark, 2));
    EXPECT_GT(bright.soilSky, dark.soilSky) << "what shines through blades comes down, too";
    for (size_t i = 0; i < bright.soilScattered.size(); ++i)
        EXPECT_GT(bright.soilScattered[i], 4 * dark.soilScattered[i]) << i;
    const auto ofBright = fitTraced(bright).parts.fill, ofDark = fitTraced(dark).parts.fill;
    for (size_t i = 0; i < TRACED_LIGHTS; ++i) {
        const size_t soil = TRACED_HEIGHTS * i, middle = soil + 1;
        EXPECT_GT(ofBright[middle].y, 4 * ofDark[middle].y) << i;
        EXPECT_GT(ofBright[middle].y, ofBright[soil].y) << "light comes from above, " << i;
    }
}

// All of a lawn's direct light, over all views and lights.
double sentByAll(const TracedTable& t) {
    double sum = 0;
    for (size_t view = 0; view < t.direct.size(); ++view)
        for (const TracedSums& s : t.direct[view]) sum += s.full.y / t.met[view];
    return sum;
}
TEST(TracedLightOf, BrighterBladesAreBrighterAsRecollisionSays) {
    const TracedTable dark = tableOf(coloured(0.05f, 0), 320), bright = tableOf(coloured(0.8f, 0), 320);
    const float again = fitTraced(dark).recollision;
    EXPECT_GT(again, 0.1f);
    const double want = 16 * double(f32::paintScatters(glm::vec3(0.05f), glm::vec3(0.8f), 0, again).y),
                 got = sentByAll(bright) / sentByAll(dark);
    std::printf("  recollision %.3f: blades 16 times as bright send %.2f times as much, foretold %.2f\n", double(again),
                got, want);
    EXPECT_NEAR(got / want, 1, 0.1);
    EXPECT_GT(std::abs(got / 16 - 1), 0.2) << "colour alone is the rival";
    TracedSpec sparse = coloured(0.05f, 0);
    sparse.species.species.bladesPerM2 = 400;
    EXPECT_LT(fitTraced(tableOf(sparse)).recollision, 0.7f * again) << "few others are met";
}

TEST(TracedLightOf, WhatLooksAlongTheLightSeesWhatIsLit) {
    const TracedTable t = tableOf(coloured(0.02f, 0), 320);
    const auto quotient = [&](size_t turn) {
        const TracedSums& s = t.direct[2][2 * kTracedTurns + turn];  // both 21 degrees up
        return s.full.y / s.local.y;
    };
    EXPECT_GT(quotient(0), 1.1 * quotient(4));
}

// Per unit of the sky's tilt, of what the lawn has under an even sky.
double tiltQuotient(const TracedTable& t, size_t view) { return t.tilt[view].full.y / t.sky[view].full.y; }
TEST(TracedLightOf, UprightBladesHaveMoreOfASkyThatIsBrightAtTheHorizonTheMoreTheyStandFree) {
    TracedSpec sparse = coloured(0.1f, 0);
    sparse.species.species.bladesPerM2 = 400;
    const TracedTable free = tableOf(sparse), among = tableOf(coloured(0.1f, 0));
    EXPECT_GT(tiltQuotient(free, 1), 0.05) << "a wall has 0.24";
    EXPECT_LT(tiltQuotient(among, 1), tiltQuotient(free, 1)) << "others hide the horizon";
    EXPECT_LT(among.soilTilt, 0.1 * among.soilSky) << "light comes down to the soil from above";
}

// Blades that lean towards the light show the eye above it their undersides; those that lean away, their lit faces.
TEST(TracedLightOf, LeaningGrassIsTracedWhereItIsAskedForAndTellsWhichWayItLeans) {
    TracedSpec spec = coloured(0.2f, 0);
    EXPECT_EQ(tableOf(spec).lean, 0);
    spec.leans = true, spec.species.species.leanDeg = 30;
    const TracedTable t = tableOf(spec);
    EXPECT_NEAR(t.lean, std::tan(glm::radians(30.0f)), 1e-5f);
    const LeaningShows shows = fitTraced(t).leaning;
    const auto sends = [&](float lean, size_t direction) {
        const float terms[] = {1, std::cos(lean), std::sin(lean), std::cos(2 * lean), std::sin(2 * lean)};
        float sum = 0;
        for (size_t k = 0; k < kTracedLeans; ++k) sum += terms[k] * shows.direct[k][direction].y;
        return sum;
    };
    const size_t view = 3, light = 3, behindTheEye = (view * kTracedLights + light) * kTracedTurns;
    EXPECT_GT(sends(3.14f, behindTheEye), 1.1f * sends(0, behindTheEye));
    TracedSpec plain = spec;
    plain.leans = false;
    EXPECT_NE(tracedKey(plain), tracedKey(spec));
}

TEST(TracedLightOf, IsTheSameEachTime) {
    const TracedTable a = tableOf(denseSpec(), 48), b = tableOf(denseSpec(), 48);
    for (size_t view = 0; view < kTracedViews; ++view) {
        EXPECT_EQ(a.sky[view].full, b.sky[view].full);
        for (size_t i = 0; i < a.direct[view].size(); ++i) EXPECT_EQ(a.direct[view][i].full, b.direct[view][i].full);
    }
    EXPECT_EQ(a.soilSky, b.soilSky);
}

TEST(TracedLightOf, ATableThatIsAPolynomialIsFittedByIt) {
    TracedFactors want;
    for (size_t i = 0; i < want.direct.size(); ++i)
        want.direct[i] = glm::vec3(i % TRACED_TERMS == 0 ? 1.0f : 0.03f * float(i % TRACED_TERMS % 5));
    want.sky = {glm::vec3(1.8f), glm::vec3(-0.6f), glm::vec3(0.1f)}, want.ground = {glm::vec3(0.2f), {}, glm::vec3(1)};
    TracedTable t;
    for (int v = 0; v < kTracedViews; ++v) {
        const float y = kViewSines[v], level = std::sqrt(1 - y * y);
        for (int l = 0; l < kTracedLights; ++l)
            for (int k = 0; k < kTracedTurns; ++k) {
                const float ly = kLightSines[l], across = std::sqrt(1 - ly * ly);
                const glm::vec3 towards(across * std::cos(kTurns[k]), ly, across * std::sin(kTurns[k]));
                t.direct[size_t(v)][size_t(l * kTracedTurns + k)] = {
                    glm::dvec3(2), glm::dvec3(2.0f * tracedDirect(want, {level, y, 0}, towards))};
            }
        t.sky[size_t(v)] = {glm::dvec3(3), glm::dvec3(3.0f * tracedRise(want.sky, y))};
        t.ground[size_t(v)] = {glm::dvec3(3), glm::dvec3(3.0f * tracedRise(want.ground, y))};
    }
    t.met.fill(2);
    const TracedShows shows = fitTraced(t).shows;
    EXPECT_NEAR(shows.sky[1].y, 1.5f * tracedRise(want.sky, kViewSines[1]).y, 1e-5f) << "the mean of what two rays saw";
    const TracedFactors got = fitTraced(t).blades;
    for (const glm::vec3& eye : {glm::vec3(0.8f, 0.6f, 0), glm::vec3(0, 1, 0)})
        for (const glm::vec3& light : {glm::vec3(0.8f, 0.6f, 0), glm::normalize(glm::vec3(-1, 1, 1))})
            EXPECT_NEAR(tracedDirect(got, eye, light).y, tracedDirect(want, eye, light).y, 0.02f);
    EXPECT_NEAR(tracedRise(got.sky, 0.5f).y, tracedRise(want.sky, 0.5f).y, 0.005f);
    EXPECT_NEAR(tracedRise(got.ground, 0.5f).y, tracedRise(want.ground, 0.5f).y, 0.005f);
}

TEST(TracedLightOf, IsKeptAndADamagedFileIsMadeAnew) {
    const TempDir folder;
    TracedSpec spec = denseSpec();
    spec.species.species.bladesPerM2 = 400;  // it is the sooner made
    JobControl control;
    const auto made = tracedLight(folder.path, spec, control);
    ASSERT_TRUE(made) << made.error().text();
    std::filesystem::path file;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path))
        if (entry.is_regular_file()) file = entry.path();
    ASSERT_FALSE(file.empty());
    EXPECT_LT(std::filesystem::file_size(file), 12288u);
    {
        std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
        bytes.seekp(17).put('x');
    }
    const auto again = tracedLight(folder.path, spec, control);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->blades.direct, made->blades.direct);
    EXPECT_EQ(again->shows.direct, made->shows.direct);
    TracedSpec other = spec;
    other.species.species.gloss += 0.1f;
    EXPECT_NE(tracedKey(other), tracedKey(spec));
    other = spec;
    other.species.species.tipColor.y += 0.1f;
    EXPECT_NE(tracedKey(other), tracedKey(spec));
    other = spec;
    other.species.slices = 5;
    EXPECT_EQ(tracedKey(other), tracedKey(spec)) << "its slices are not read";
}

TEST(TracedLightOf, OfLeaningGrassIsKeptWhole) {
    const TempDir folder;
    TracedSpec spec = coloured(0.2f, 0);
    spec.leans = true, spec.species.species.leanDeg = 30, spec.species.species.bladesPerM2 = 400;
    JobControl control;
    const auto made = tracedLight(folder.path, spec, control), again = tracedLight(folder.path, spec, control);
    ASSERT_TRUE(made && again);
    EXPECT_GT(made->leaning.lean, 0);
    EXPECT_EQ(again->leaning.direct, made->leaning.direct);
    EXPECT_EQ(again->leaning.sky, made->leaning.sky);
    EXPECT_EQ(again->soilSky, made->soilSky);
}

TEST(TracedLightOf, EndsWhenItIsCancelled) {
    const TempDir folder;
    JobControl control;
    control.cancel();
    EXPECT_FALSE(tracedLight(folder.path, denseSpec(), control));
    EXPECT_TRUE(std::filesystem::is_empty(folder.path));
}

}  // namespace
}  // namespace sward::test
