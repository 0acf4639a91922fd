#include "grass/appearance.h"

#include <gtest/gtest.h>

namespace sward::test {
namespace {

Rgba8 whiteBlade() { return {1, 1, std::vector<uint8_t>(4, 255)}; }

Look lookOf(const Species& s, const Patch& p) {
    Look look;
    uint64_t madeFrom = 0;
    updateLook(look, madeFrom, s, p, 1, whiteBlade());
    return look;
}
Look lookOf(const Species& s) { return lookOf(s, makePatch(s, 0.5f, 1)); }

// Upright blades of equal height that all face x, one way or the other.
Look facingX() {
    Species s;
    s.clumpSize = 0, s.rootOcclusion = 1;
    s.rootColor = s.midColor = s.tipColor = {0.1f, 0.2f, 0.05f};
    Patch p;
    for (int i = 0; i < 64; ++i) {
        Blade b{};
        b.width = 0.01f, b.threshold = 0.5f, b.lightness = 1;
        b.control = {0, 0.1f, 0}, b.tip = {0, 0.2f, 0};
        b.facing = {i % 2 ? 1.0f : -1.0f, 0};
        p.blades.push_back(b);
    }
    return lookOf(s, p);
}

// Their images: on slices across x they face whoever sees them; slices across z have them edge on.
DrawnImages imagesFacingX() {
    DrawnImages out;
    const SliceTexel texel{{0.1f, 0.2f, 0.05f}, 1, 1, {1, 0, 0, 0}, {1, 0, 0, 0}};
    for (SliceRows& level : out.standing.levels) level[0].fill({{texel}, 1, 1});
    out.standing.top = 0.2f, out.stand.apart = 0.05f;
    out.far.fill({{texel.color, 1, 1, {}, 0, 0}});
    out.shown = shownShares(out.standing, out.stand);
    return out;
}
DrawnImages imagesOf(const Species& s) {
    SliceSpec spec;
    spec.species = s;
    spec.slices = 4, spec.width = 32, spec.height = 16, spec.farSize = 32;
    spec.blade = whiteBlade();
    JobControl control;
    return drawnImagesOf(*bakeSlices(spec, control), true, SliceSets::Each, {.apart = 0.125f});
}
Gains gainsFor(const Species& s, const FieldLight& light) { return gainsOf(lookOf(s), light, imagesOf(s)); }

FieldLight lit(const glm::vec3& direction, LightWeighting weighting, const glm::vec3& ambient = glm::vec3(0)) {
    FieldLight l;
    l.sky = ambient, l.ground = ambient;
    l.suns = {{glm::normalize(direction), {3, 2.5f, 2}}};
    l.weighting = weighting;
    return l;
}
constexpr LightWeighting kForms[] = {LightWeighting::Cosine, LightWeighting::Atan,    LightWeighting::Poly9,
                                     LightWeighting::Poly7,  LightWeighting::Poly5,   LightWeighting::Poly3,
                                     LightWeighting::Linear, LightWeighting::Squares, LightWeighting::Published};
const glm::vec3 kHard[] = {{1, 0, 0},
                           {-1, 0, 0},
                           {0, 1, 0},
                           {0, -1, 0},
                           {0, 0, 1},
                           {0, 0, -1},
                           {1, 1, 0},
                           {0, 1, -1},
                           {-1, 0, 1},
                           {1, -1, 1},
                           {0.6f, -0.1f, 0.3f},
                           {1e-7f, 1, 0},
                           {1, 1e-7f, 0},
                           {1e-20f, 1, -1e-20f},
                           {-0.0f, 1, 0.0f},
                           {0, 0, 0},
                           {3e-19f, 4e-19f, 1e-19f}};

TEST(Appearance, GainsAreOneWhereSlicesAreExact) {
    const Look look = facingX();
    for (const LightWeighting form : {LightWeighting::Cosine, LightWeighting::Atan, LightWeighting::Poly9})
        for (const glm::vec3& light : {glm::vec3(1, 0, 0), glm::vec3(-1, 0, 0)}) {
            const Gains g = gainsOf(look, lit(light, form), imagesFacingX());
            for (const int view : {0, LOOK_AZIMUTHS / 2}) {  // level, from where the light comes and from behind
                const glm::vec3& gain = g.slices[static_cast<size_t>(view)];
                const bool dark = (light.x > 0) != (view == 0);  // no light on either: nothing to compare
                if (!dark) EXPECT_NEAR(gain.y, 1, 0.03f) << static_cast<int>(form) << " view " << view;
            }
        }
    const Gains ambient = gainsOf(look, {.sky = glm::vec3(1), .ground = glm::vec3(1)}, imagesFacingX());
    for (int azimuth = 0; azimuth < LOOK_AZIMUTHS; ++azimuth)
        if (azimuth % (LOOK_AZIMUTHS / 2) != LOOK_AZIMUTHS / 4)  // edge-on nothing is seen
            EXPECT_NEAR(ambient.slices[static_cast<size_t>(azimuth)].y, 1, 0.03f) << azimuth;
}

TEST(Appearance, CosineFormIsExactForLightFromAnywhereOnOneBlade) {
    const Look look = facingX();
    for (const glm::vec3& light : {glm::vec3(1, 0.5f, 0), glm::vec3(1, 2, 0.5f), glm::vec3(0.3f, 0.4f, -1)}) {
        EXPECT_NEAR(gainsOf(look, lit(light, LightWeighting::Cosine), imagesFacingX()).slices[0].y, 1, 0.03f)
            << light.y;
        EXPECT_GT(gainsOf(look, lit({1, 1, 0}, LightWeighting::Atan), imagesFacingX()).slices[0].y, 1.2f)
            << "interpolated, it is too dark between the images";
    }
}

TEST(Appearance, GainsAreFiniteForLightsAnywhere) {
    Species s;
    s.translucency = 0.5f;
    const Look look = lookOf(s);
    const DrawnImages images = imagesOf(s);
    for (const LightWeighting form : kForms)
        for (const glm::vec3& direction : kHard) {
            if (glm::length(direction) < 1e-10f) continue;
            FieldLight l = lit(direction, form, glm::vec3(0.3f));
            l.translucency = 0.5f, l.gloss = 1, l.lean = 0.3f;
            const Gains g = gainsOf(look, l, images);
            for (const auto* gains : {&g.slices, &g.far})
                for (const glm::vec3& v : *gains)
                    for (int c = 0; c < 3; ++c) {
                        ASSERT_TRUE(std::isfinite(v[c])) << "form " << static_cast<int>(form) << ", light "
                                                         << direction.x << " " << direction.y << " " << direction.z;
                        ASSERT_GT(v[c], 0);
                    }
        }
}

// Between fewer blades one sees further down, where they are dark; where all are of one colour, only what they shade
// changes.
TEST(Appearance, ThinGrassShowsMoreOfWhatStandsLow) {
    Species s;
    s.bladesPerM2 = 3000, s.height = 0.4f, s.hueVariationDeg = s.lightnessVariation = 0;
    const size_t low = LOOK_AZIMUTHS;  // a view from a little over the horizon
    const auto thinByFull = [&] {
        FieldLight l{.sky = glm::vec3(1), .ground = glm::vec3(1)};
        l.painted = true;
        const Gains g = gainsFor(s, l);
        return g.thin[low].y / g.far[low].y;
    };
    s.rootColor = s.midColor = s.tipColor = glm::vec3(0.2f), s.rootOcclusion = 0;
    const float plain = thinByFull();
    s.rootColor = glm::vec3(0.02f), s.midColor = glm::vec3(0.1f);
    EXPECT_LT(thinByFull(), 0.85f * plain);
    FieldLight unpainted{.sky = glm::vec3(1), .ground = glm::vec3(1)};
    EXPECT_EQ(gainsFor(s, unpainted).thin[low], glm::vec3(1)) << "nobody asks for it";
}

// Where roots are dark, what is seen from the side is brighter than an image from above; paint, which knows no roots,
// is not. A white texture doubles all colours, paint among them (whiteBlade).
TEST(Appearance, PaintIsAsBrightAsBladesThatArePainted) {
    Species s;
    s.bladesPerM2 = 3000, s.height = 0.4f, s.hueVariationDeg = s.lightnessVariation = 0;
    FieldLight l{.sky = glm::vec3(1), .ground = glm::vec3(1)};
    const size_t low = LOOK_AZIMUTHS;
    EXPECT_EQ(gainsFor(s, l).paintAbove[low], glm::vec3(1)) << "nobody asks for it";
    l.tinted = true;
    s.rootColor = s.midColor = s.tipColor = {0.1f, 0.2f, 0.05f};
    const Gains even = gainsFor(s, l);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(even.paintAbove[low][c], 2, 0.1) << c;
        EXPECT_NEAR(even.paintAcross[low][c], 2, 0.1) << c;
    }
    s.rootColor = s.midColor = 0.2f * s.tipColor;
    const Gains dark = gainsFor(s, l);
    EXPECT_LT(dark.paintAbove[low].y, 1.8f);
    EXPECT_NEAR(dark.far[low].y * dark.paintAbove[low].y, even.far[low].y * even.paintAbove[low].y, 0.02f);
}

TEST(Appearance, ASpeciesWithoutBladesHasASoundLook) {
    Species s;
    s.bladesPerM2 = 0;
    const Look look = lookOf(s);
    EXPECT_EQ(look.across, 0);
    EXPECT_FLOAT_EQ(lightLeft(look, 0.5f), 1);
    for (const glm::vec3& v : gainsFor(s, lit({1, 1, 0}, LightWeighting::Atan)).slices) EXPECT_TRUE(std::isfinite(v.x));
}

TEST(Appearance, PaintTowardsTheLightAndAwayFromItChangesBrightnessOppositely) {
    FieldLight l = lit({1, 0.7f, 0}, LightWeighting::Cosine, glm::vec3(0.2f));
    l.lean = 0.5f;
    Species s;
    s.bend = 0, s.leanDeg = 25, s.leanVariationDeg = 0;
    const Gains g = gainsFor(s, l);
    float most = 0;
    for (size_t view = 0; view < LOOK_VIEWS; ++view) {
        const float change = std::abs(g.leans[0][view].y) * l.lean;
        most = std::max(most, change);
        EXPECT_LE(change, 0.9f);
    }
    EXPECT_GT(most, 0.02f) << "painted lean along the light changes nothing";
    l.lean = 0;
    EXPECT_EQ(gainsFor(s, l).leans[0][0], glm::vec3(0)) << "nothing is painted";
}

// Leaves of two colours, of which a lean shows other parts: each colour changes by its own share.
TEST(Appearance, ALeanChangesEachColourByItself) {
    FieldLight l = lit({1, 0.7f, 0}, LightWeighting::Cosine, glm::vec3(0.2f));
    l.lean = 0.5f, l.gloss = 1;
    Species s;
    s.rootColor = s.midColor = s.tipColor = {0.05f, 0.1f, 0.01f};
    const Gains g = gainsFor(s, l);
    float apart = 0;
    for (const auto& lean : g.leans)
        for (const glm::vec3& share : lean) apart = std::max(apart, std::abs(share.z - share.y));
    EXPECT_GT(apart, 0.1f) << "the highlight is white, the leaf hardly blue";
}

// Paths have seen grass that leans along x from all around: what a lean any way comes to is read by its angle to the
// eye.
TEST(Appearance, ALeanIsWhatPathsHaveSeenOfIt) {
    TracedLight traced;
    traced.shows.direct.fill(glm::vec3(0.2f)), traced.shows.sky.fill(glm::vec3(0.1f));
    LeaningShows& leaning = traced.leaning;
    leaning.lean = 0.5f;
    const float terms[] = {0.25f, 0.06f, -0.04f, 0.03f, 0.02f};
    for (size_t k = 0; k < kTracedLeans; ++k) leaning.direct[k].fill(glm::vec3(terms[k]));
    leaning.sky[0].fill(glm::vec3(0.15f));
    const BladeShade shade{.rows = {1.0f}};
    FieldLight l = lit({0.3f, 1, 0.8f}, LightWeighting::Cosine, glm::vec3(0.5f));
    l.traced = &traced, l.shade = &shade, l.lean = 0.5f;
    const Gains g = gainsFor({}, l);
    const float sun = 2.5f, sky = 0.5f, upright = sun * 0.2f + sky * 0.1f;
    for (const size_t azimuth : {0, 1, 3, 6})
        for (const float way : {0.0f, 0.9f, 2.5f, 4.2f}) {
            const size_t view = azimuth + 3 * LOOK_AZIMUTHS;
            const float eye = 6.2831853f / LOOK_AZIMUTHS * static_cast<float>(azimuth), angle = way - eye,
                        side = std::cos(eye) * 0.8f - std::sin(eye) * 0.3f < 0 ? -1.0f : 1.0f;  // the sun's
            const float want = sun * (terms[0] + terms[1] * std::cos(angle) + side * terms[2] * std::sin(angle) +
                                      terms[3] * std::cos(2 * angle) + side * terms[4] * std::sin(2 * angle)) +
                               sky * 0.15f;
            const float x = 0.5f * std::cos(way), z = 0.5f * std::sin(way);
            const float factors[] = {x, z, x * x, z * z, x * z};
            float got = 1;
            for (size_t k = 0; k < std::size(factors); ++k) got += factors[k] * g.leans[k][view].y;
            EXPECT_NEAR(got, want / upright, 0.01f) << "eye " << eye << ", lean " << way;
        }
}

TEST(Appearance, LightLeftIsAShareAndLessTheDenserAndTheLowerTheLight) {
    Species thin, thick;
    thin.bladesPerM2 = 200, thick.bladesPerM2 = 8000;
    const Look a = lookOf(thin), b = lookOf(thick);
    float before = 0;
    for (const float sine : {-1.0f, 0.0f, 0.1f, 0.2f, 0.4f, 0.7f, 1.0f}) {
        for (const Look* look : {&a, &b}) {
            EXPECT_GE(lightLeft(*look, sine), 0);
            EXPECT_LE(lightLeft(*look, sine), 1);
        }
        EXPECT_LT(lightLeft(b, sine), lightLeft(a, sine));
        EXPECT_GE(lightLeft(b, sine), before);
        before = lightLeft(b, sine);
    }
}

TEST(Appearance, ALookIsMadeAnewOnlyWhenItsInputsChange) {
    Species s;
    const Patch p = makePatch(s, 0.5f, 1);
    Look look;
    uint64_t madeFrom = 0;
    updateLook(look, madeFrom, s, p, 1, whiteBlade());
    const uint64_t first = madeFrom;
    look.height = 42;
    updateLook(look, madeFrom, s, p, 1, whiteBlade());
    EXPECT_EQ(look.height, 42) << "nothing changed";
    s.tipColor.y += 0.1f;
    updateLook(look, madeFrom, s, p, 1, whiteBlade());
    EXPECT_NE(madeFrom, first);
    EXPECT_NE(look.height, 42);
}

float fifth(const glm::vec4& w) { return 1 - (w.x + w.y + w.z + w.w); }

TEST(LightWeighting, EveryFormIsFiniteAndSharesOutOneAtHardPoints) {
    for (const LightWeighting form : kForms)
        for (const glm::vec3& light : kHard) {
            const float noise = form == LightWeighting::Published ? 5e-4f : 3e-7f;
            const glm::vec4 w = imageWeights(light, form);
            for (const float share : {w.x, w.y, w.z, w.w, fifth(w)}) {
                EXPECT_GE(share, -noise) << static_cast<int>(form) << ": " << light.x << " " << light.y << " "
                                         << light.z;
                EXPECT_LE(share, 1 + noise);
            }
        }
}

TEST(LightWeighting, FormsAgreeWithinWhatTheyCost) {
    const std::pair<LightWeighting, float> errors[] = {
        {LightWeighting::Cosine, 1e-6f},  {LightWeighting::Poly9, 4e-5f},    {LightWeighting::Poly7, 3e-4f},
        {LightWeighting::Poly5, 2e-3f},   {LightWeighting::Poly3, 1.7e-2f},  {LightWeighting::Linear, 6e-2f},
        {LightWeighting::Squares, 0.18f}, {LightWeighting::Published, 4e-4f}};
    for (int i = 0; i < 600; ++i) {
        const float turn = 2.399963f * static_cast<float>(i), y = (static_cast<float>(i) + 0.5f) / 600,
                    r = std::sqrt(1 - y * y);
        const glm::vec3 light(r * std::cos(turn), y, r * std::sin(turn));
        if (std::min(std::abs(light.x), std::abs(light.z)) < 1e-2f) continue;
        const glm::vec4 exact = imageWeights(light, LightWeighting::Atan);
        for (const auto& [form, most] : errors) {
            const glm::vec4 w = imageWeights(light, form);
            for (int c = 0; c < 4; ++c)
                EXPECT_NEAR(w[c], exact[c], most)
                    << static_cast<int>(form) << " light " << light.x << " " << light.y << " " << light.z;
        }
    }
}

TEST(LightWeighting, LightOnAnAxisIsThatAxisAlone) {
    for (const LightWeighting form : kForms) {
        EXPECT_NEAR(imageWeights({1, 0, 0}, form).x, 1, 1e-6f);
        EXPECT_NEAR(imageWeights({0, 1, 0}, form).y, 1, 1e-6f);
        EXPECT_NEAR(imageWeights({0, 0, 1}, form).z, 1, 1e-6f);
        EXPECT_NEAR(imageWeights({-1, 0, 0}, form).w, 1, 1e-6f);
        EXPECT_NEAR(fifth(imageWeights({0, 0, -1}, form)), 1, 1e-6f);
        EXPECT_NEAR(imageWeights({0, -1, 0}, form).y, 1, 1e-6f) << "the nadir counts as the zenith";
    }
}

}  // namespace
}  // namespace sward::test
