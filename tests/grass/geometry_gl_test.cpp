#include <numeric>

#include "cost/frame_stats.h"
#include "fields.h"
#include "scenes.h"
#include "techniques.h"
#include "world/view_camera.h"

namespace sward::test {
namespace {

FlatField grassOf(Project& p) { return flatField(p, "grass"); }

const PassStats& passOf(const Renderer& r, const std::string& name) {
    for (const PassStats& p : r.stats().passes)
        if (p.name == name) return p;
    static const PassStats none;
    return none;
}

// Pixels of the tiers view that show blades (red), by half of the picture.
std::array<int, 2> redPixels(Renderer& r, Project& p, const ViewCamera& c) {
    ViewSettings s = small();
    s.mode = ViewMode::Tiers, s.counted = true;
    EXPECT_TRUE(r.draw(p, c, s));
    const auto image = r.readImage();
    std::array<int, 2> n{0, 0};
    for (int y = 0; y < s.height; ++y)
        for (int x = 0; x < s.width; ++x) {
            const size_t i = (static_cast<size_t>(y) * static_cast<size_t>(s.width) + static_cast<size_t>(x)) * 3;
            n[x >= s.width / 2] += image[i] > 90 && image[i] > 2 * image[i + 1];
        }
    return n;
}

TEST(GrassPicture, BladesAreSeenAndBareGroundHasNone) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    Project p = lawn();
    const auto full = redPixels(r, p, above());
    EXPECT_GT(full[0] + full[1], 200);
    grassOf(p).species[0].density = field(filled({8, 8, 1, PixelType::U16}, 0));
    const auto bare = redPixels(r, p, above());
    EXPECT_EQ(bare[0] + bare[1], 0);
    EXPECT_EQ(r.stats().bladesGeometry, 0u);
}

TEST(GrassPicture, AHalfPaintedMapShowsGrassOnItsHalfOnly) {
    Renderer r(gpu(), tables());
    Project p = lawn();
    grassOf(p).fade = 0;
    Map m({40, 40, 1, PixelType::U16});
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 20; ++x) m.set(x, y, 0, 1);
    grassOf(p).species[0].density = field(m);
    const auto halves = redPixels(r, p, {{10, 6, 8}, {10, 0, 10}, 55, 0});  // looking along +z: +x is on the left
    EXPECT_GT(std::max(halves[0], halves[1]), 110);
    EXPECT_LT(std::min(halves[0], halves[1]), std::max(halves[0], halves[1]) / 20);
}

TEST(GrassPicture, TheCpuCountsWhatTheShaderDraws) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    Project p = lawn();
    FlatField f = grassOf(p);
    f.technique = nameOf(Technique::Geometry);
    f.drawing.bakeLight = BakeLight::Local;  // blades are counted in any light
    f.fade = 0;
    f.species[0].segments = 1;
    f.species[0].density = field(filled({8, 8, 1, PixelType::U16}, 0.5f));
    ViewSettings s = small();
    s.measure = true;
    const ViewCamera c{{10, 30, 10}, {10, 0, 10.001}, 55, 0};  // all of it in view
    ASSERT_TRUE(r.draw(p, c, s));
    EXPECT_DOUBLE_EQ(r.stats().bladesVirtual, 200.0 * 400 * f.species[0].density.map.mean());
    const uint64_t seen = visibleBlades(p, tables(), c, s.width, s.height);
    EXPECT_NEAR(static_cast<double>(seen), 200.0 * 400 / 2, 200.0 * 400 / 255);
    // Each cell of 50 blades moves thresholds by a number of its own, so that some lie within the slack for rounding,
    // 1e-5, beyond the density: 0.8 of 80,000 in the mean. The shader leaves them out.
    EXPECT_GE(r.stats().bladesGeometry, seen);
    EXPECT_LE(r.stats().bladesGeometry, seen + 5);
    const PassStats& pass = passOf(r, "grass/geometry");
    EXPECT_GE(pass.vertices, 4 * seen) << "two rows of two vertices a blade";
    EXPECT_FALSE(r.stats().features.empty());
    // Of 200 a cell all cells have the same.
    f.species[0].bladesPerM2 = 800;
    ASSERT_TRUE(r.draw(p, c, s));
    EXPECT_EQ(r.stats().bladesGeometry, visibleBlades(p, tables(), c, s.width, s.height))
        << "constant density: the contiguous range is exactly the blades that exist";
}

TEST(GrassPicture, CallsDoNotGrowWithTheFieldAndFlatDrawsNone) {
    Renderer r(gpu(), tables());
    uint64_t draws[2];
    for (int i = 0; i < 2; ++i) {
        Project p = lawn();
        p.registry.get<Terrain>(findEntity(p, "ground"))->size = i == 0 ? glm::dvec2(20) : glm::dvec2(640);
        ASSERT_TRUE(r.draw(p, eyeHeight(), small()));
        draws[i] = passOf(r, "grass/geometry").draws;
        if (i == 1) {
            grassOf(p).technique = nameOf(Technique::Flat);
            ASSERT_TRUE(r.draw(p, eyeHeight(), small()));
            EXPECT_EQ(passOf(r, "grass/geometry").draws, 0u);
        }
    }
    EXPECT_EQ(draws[0], draws[1]);
}

TEST(GrassPicture, IsTheSameNinetyThousandUnitsFromTheOrigin) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    Project p = lawn();
    ASSERT_TRUE(r.draw(p, eyeHeight(), small()));
    const auto here = r.readImage();
    const glm::dvec3 away{90000, 0, -90000};
    put(p, "ground", Transform{away});
    ViewCamera c = eyeHeight();
    c.eye += away;
    c.target += away;
    ASSERT_TRUE(r.draw(p, c, small()));
    const auto there = r.readImage();
    int worst = 0;
    for (size_t i = 0; i < here.size(); ++i) worst = std::max(worst, std::abs(here[i] - there[i]));
    EXPECT_LE(worst, 1);
}

TEST(GrassPicture, IsFiniteForSunsAtTheZenithTheHorizonAndBelow) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    Project p = lawn();
    for (const float elevation : {90.0f, 0.0f, 0.01f, -20.0f}) {
        p.registry.get<Light>(findEntity(p, "sun"))->elevationDeg = elevation;
        ASSERT_TRUE(r.draw(p, eyeHeight(), small()));
        for (float v : r.readLinear()) ASSERT_TRUE(std::isfinite(v) && v >= 0) << elevation;
    }
}

TEST(GrassPicture, IsTheSameWhetherBladesAreListedOneByOneOrByRanges) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    const bool software = gpu().software;
    for (const Transparency way : {Transparency::Coverage, Transparency::Blend})
        for (const int samples : {1, 4}) {
            Project p = lawn();
            FlatField f = grassOf(p);
            f.minGeom = 2, f.maxGeom = 6;
            f.transparency = way;
            ViewSettings s = small();
            s.msaa = samples;
            s.measure = true;
            std::vector<uint8_t> images[2];
            uint64_t vertices[2];
            for (const bool listed : {false, true}) {
                gpu().software = listed;
                EXPECT_TRUE(r.draw(p, eyeHeight(), s));
                images[listed] = r.readImage();
                vertices[listed] = passOf(r, "grass/geometry").vertices + passOf(r, "grass/ground-shadow").vertices;
            }
            gpu().software = software;
            EXPECT_EQ(images[0], images[1]) << samples;
            EXPECT_LT(vertices[1], vertices[0] * 2 / 3) << samples;
        }
}

TEST(GrassPicture, PaintedLeanTurnsTheBlades) {
    Renderer r(gpu(), tables());
    Project p = lawn();
    FlatField f = grassOf(p);
    f.technique = nameOf(Technique::Geometry);
    f.species[0].bladesPerM2 = 4000;
    f.species[0].leanDeg = 45;
    f.species[0].leanVariationDeg = 3;
    f.species[0].clumpSize = 0;
    double mean[2];
    for (int i = 0; i < 2; ++i) {
        Map m({4, 4, 2, PixelType::U16});
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 4; ++x) m.set(x, y, 0, 0.5f), m.set(x, y, 1, i == 0 ? 0.0f : 1.0f);
        f.orientation = field(m);
        ASSERT_TRUE(r.draw(p, {{10, 3, 4}, {10, 0, 9}, 45, 0}, small()));
        mean[i] = 0;
        for (float v : r.readLinear()) mean[i] += v;
    }
    EXPECT_GT(1 - mean[0] / mean[1], 0.05) << "towards the sun they are lighter, in truth 1.3 times";
}

// Light of the lower half of the picture, without sky, with the sun at an azimuth; the camera looks along +x and +z.
double lightWithSunAt(Renderer& r, Project& p, float azimuthDeg) {
    Light& sun = *p.registry.get<Light>(findEntity(p, "sun"));
    sun.azimuthDeg = azimuthDeg;
    sun.elevationDeg = 20;
    EXPECT_TRUE(r.draw(p, eyeHeight(), small()));
    const auto light = r.readLinear();
    double sum = 0;
    for (size_t i = light.size() * 2 / 3; i < light.size(); ++i) sum += light[i];
    return sum;
}

TEST(GrassPicture, AgainstTheSunTranslucentAndWaxyBladesShineMore) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    Project plain = lawn(), thin = lawn(), waxy = lawn();
    for (Project* p : {&plain, &thin, &waxy}) grassOf(*p).species[0].bladesPerM2 = 2000;
    grassOf(thin).species[0].translucency = 1;
    grassOf(waxy).species[0].gloss = 1;
    const float against = 135, behind = 315;
    const double before = lightWithSunAt(r, plain, against), with = lightWithSunAt(r, plain, behind);
    EXPECT_GT(lightWithSunAt(r, thin, against), 1.1 * before);
    EXPECT_GT(lightWithSunAt(r, waxy, against), 1.1 * before);
    EXPECT_GT(lightWithSunAt(r, thin, against) / before, lightWithSunAt(r, thin, behind) / with);
    EXPECT_GT(lightWithSunAt(r, waxy, against) / before, lightWithSunAt(r, waxy, behind) / with);
}

TEST(GrassPicture, BladesShadeBladesByDensityAndOnlyInLightThatCasts) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    const auto light = [&](float perM2, bool casts, int texels) {
        Project p = lawn();
        Species& s = grassOf(p).species[0];
        s.bladesPerM2 = perM2;
        grassOf(p).drawing.bakeLight = BakeLight::Local;
        s.rootOcclusion = 1;  // so that only the mask darkens
        grassOf(p).groundShadows = false;
        grassOf(p).shadowMask = texels;
        p.registry.get<Light>(findEntity(p, "sun"))->castShadows = casts;
        EXPECT_TRUE(r.draw(p, above(), small()));
        return r.readLinear();
    };
    const auto sum = [](const std::vector<float>& v) { return std::accumulate(v.begin(), v.end(), 0.0); };
    EXPECT_EQ(light(2000, false, 64), light(2000, true, 0))
        << "without a mask, and without light that casts, the picture is the same";
    const double sparse = sum(light(50, true, 64)) / sum(light(50, true, 0)),
                 dense = sum(light(2000, true, 64)) / sum(light(2000, true, 0));
    EXPECT_LT(dense, 0.9);
    EXPECT_LT(dense, sparse - 0.05);
    EXPECT_LE(sparse, 1.0);
}

TEST(GrassPicture, OverdrawCountsFragments) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    Project p = lawn();
    flatField(p, "grass").transparency = Transparency::Blend;  // else the ground is not lit under blades
    ViewSettings s = small();
    s.mode = ViewMode::Overdraw;
    ASSERT_TRUE(r.draw(p, above(), s));
    const auto light = r.readLinear();
    float most = 0, least = 1e9f;
    for (size_t i = 0; i < light.size(); i += 3) most = std::max(most, light[i]), least = std::min(least, light[i]);
    EXPECT_GT(most, 1.9f / 32) << "somewhere a blade lies over the ground";
    EXPECT_NEAR(least, 1.0f / 32, 1e-3f) << "and somewhere only the ground is drawn";
}

}  // namespace
}  // namespace sward::test
