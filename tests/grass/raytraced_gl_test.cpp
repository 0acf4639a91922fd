// Grass by rays through slices: against blades and against the same slices as quads, in the views that break rays, and
// by what it costs.
#include "grass/raytraced.h"

#include <random>

#include "fields.h"
#include "missed.h"
#include "objects.h"
#include "pixels.h"
#include "scenes.h"
#include "support.h"
#include "techniques.h"
#include "world/view_camera.h"

namespace sward::test {
namespace {

// A dense lawn with small slices, soil that is not green.
Project meadow(Technique technique) {
    Project p = lawn();
    FlatField f = flatField(p);
    f.technique = nameOf(technique);
    f.species[0].bladesPerM2 = 3000;
    f.sliceWidth = f.farSize = 64, f.sliceHeight = 32;
    p.registry.get<Terrain>(findEntity(p, "ground"))->groundColor = {0.2f, 0.05f, 0.05f};
    return p;
}
ViewSettings raytracedView(int width = 160, int height = 120, int msaa = 4) {
    ViewSettings s;
    s.width = width, s.height = height, s.msaa = msaa;
    return s;
}
ViewCamera grazing() { return {{10, 1.2, 1}, {10, 0, 6}, 45, 0}; }
ViewCamera steep() { return {{10, 2.5, 1}, {10, 0, 4}, 40, 0}; }

std::vector<float> raytracedPicture(Renderer& r, const Project& p, const ViewCamera& camera,
                                    const ViewSettings& settings = raytracedView()) {
    const Status drawn = r.draw(p, camera, settings);
    EXPECT_TRUE(drawn) << (drawn ? "" : drawn.error().text());
    return r.readLinear();
}
std::vector<float> raytracedPicture(const Project& p, const ViewCamera& camera,
                                    const ViewSettings& settings = raytracedView()) {
    Renderer r(gpu(), tables());
    return raytracedPicture(r, p, camera, settings);
}
bool isFinite(const std::vector<float>& pixels) {
    return std::all_of(pixels.begin(), pixels.end(), [](float v) { return std::isfinite(v) && v >= 0; });
}
const PassStats& raytracedPass(const Renderer& r, const std::string& name) {
    for (const PassStats& pass : r.stats().passes)
        if (pass.name == name) return pass;
    static const PassStats none;
    ADD_FAILURE() << name << " was not drawn";
    return none;
}

TEST(Raytraced, CoversAndShinesAsTheBladesThatItStandsFor) {
    NoGlErrors errors;
    for (const ViewCamera& camera : {grazing(), steep()}) {
        const auto blades = raytracedPicture(meadow(Technique::Geometry), camera),
                   slices = raytracedPicture(meadow(Technique::Slices), camera);
        Project p = meadow(Technique::Raytraced);
        flatField(p).raytraced.steps = 16;
        const auto rays = raytracedPicture(p, camera);
        std::printf("covered: blades %.3f slices %.3f rays %.3f; bright: %.4f %.4f %.4f\n", covered(blades),
                    covered(slices), covered(rays), brightness(blades), brightness(slices), brightness(rays));
        EXPECT_NEAR(covered(rays), covered(blades), 0.12);
        EXPECT_NEAR(brightness(rays), brightness(blades), 0.25 * brightness(blades));
        EXPECT_LE(std::abs(brightness(rays) - brightness(blades)),
                  std::abs(brightness(slices) - brightness(blades)) + 0.05 * brightness(blades))
            << "no farther off than the same slices as quads";
    }
}

// Where no map says how much grows, a shorter program looks slices up; over a map that is full everywhere, the long
// one.
TEST(Raytraced, GrassThatIsWholeLooksAsAFullMapHasIt) {
    NoGlErrors errors;
    Project p = meadow(Technique::Raytraced);
    Renderer r(gpu(), tables());
    const auto whole = raytracedPicture(r, p, grazing());
    flatField(p).species[0].density = {"maps/full.png", filled({4, 4, 1, PixelType::U16}, 1)};
    const auto mapped = raytracedPicture(r, p, grazing());
    ASSERT_EQ(whole.size(), mapped.size());
    size_t unlike = 0;  // two programs: compilers may round a few last digits otherwise
    for (size_t i = 0; i < whole.size(); ++i) {
        unlike += whole[i] != mapped[i];
        EXPECT_NEAR(whole[i], mapped[i], 1.0f / 2048);
    }
    EXPECT_LE(unlike, whole.size() / 1000);
    EXPECT_GT(covered(whole), 0.5);
}

// The mean of what is beyond the last step keeps the picture of few steps near that of many; nothing keeps it less.
TEST(Raytraced, FewStepsAreAsBrightAsManyBecauseTheRestIsFilled) {
    NoGlErrors errors;
    Project p = meadow(Technique::Raytraced);
    FlatField f = flatField(p);
    f.raytraced.steps = 48;
    const auto whole = raytracedPicture(p, grazing());
    f.raytraced.steps = 2;
    const auto filled = raytracedPicture(p, grazing());
    EXPECT_NEAR(covered(filled), covered(whole), 0.05);
    EXPECT_NEAR(brightness(filled), brightness(whole), 0.12 * brightness(whole));
    f.raytraced.rest = RayRest::Nothing;
    const auto open = raytracedPicture(p, grazing());
    std::printf("bright: 48 steps %.4f, 2 filled %.4f, 2 open %.4f\n", brightness(whole), brightness(filled),
                brightness(open));
    expectMissed("light that two filled steps lack, by what two open ones do",
                 std::abs(brightness(filled) - brightness(whole)) / std::abs(brightness(open) - brightness(whole)), 0.5,
                 0.514);
}

TEST(Raytraced, FewerStepsFarAwayAreAsBrightAndCoverAsMuch) {
    NoGlErrors errors;
    const ViewCamera far{{10, 6, -30}, {10, 0, 6}, 30, 0};
    Project p = meadow(Technique::Raytraced);
    const auto by = [&](float footprint) {
        flatField(p).raytraced.footprint = footprint;
        return raytracedPicture(p, far);
    };
    const auto all = by(0), fewer = by(2), few = by(64);
    EXPECT_NE(all, fewer);
    std::printf("bright: all steps %.4f fewer %.4f one %.4f; covered: %.3f %.3f %.3f\n", brightness(all),
                brightness(fewer), brightness(few), covered(all), covered(fewer), covered(few));
    for (const auto& image : {fewer, few}) {
        EXPECT_NEAR(brightness(image) / brightness(all), 1, 0.03);
        EXPECT_NEAR(covered(image), covered(all), 0.03);
    }
}

// Tall grass as fine images of few slices have it, seen over its tips.
TEST(Raytraced, CoarseSamplingIsAsBrightAsFine) {
    NoGlErrors errors;
    const ViewCamera over{{10, 3.2, -3.2}, {10, 0, 4}, 40, 0};
    Project p = meadow(Technique::Raytraced);
    FlatField f = flatField(p);
    f.cellSize = 1, f.slices = 16, f.sliceWidth = 512, f.sliceHeight = 128, f.raytraced.footprint = 2,
    f.raytraced.steps = 6;
    f.species[0].height = 0.2f, f.species[0].bladesPerM2 = 2600, f.species[0].bend = 0.6f;
    const auto by = [&](float sharpness) {
        f.sharpness = sharpness;
        const auto image = raytracedPicture(p, over);
        std::printf("sharpness %g: covered %.4f, bright %.4f\n", double(sharpness), covered(image), brightness(image));
        return brightness(image);
    };
    const double coarse = by(0), middle = by(2), fine = by(4);
    EXPECT_NEAR(coarse / fine, 1, 0.04);  // 0.943 without factors
    EXPECT_NEAR(middle / fine, 1, 0.04);
}

TEST(Raytraced, AsMiddleTierOfTheHybridIsAsBrightAsSlices) {
    NoGlErrors errors;
    Project p = meadow(Technique::Hybrid);
    FlatField f = flatField(p);
    f.minGeom = 2, f.maxGeom = 4, f.minBTF = 8, f.maxBTF = 12;
    Renderer r(gpu(), tables());
    const double slices = brightness(raytracedPicture(r, p, grazing()));
    f.hybrid.middleTier = MiddleTier::Raytraced;
    const auto rays = raytracedPicture(r, p, grazing());
    EXPECT_NEAR(brightness(rays), slices, 0.1 * slices);
    EXPECT_GT(raytracedPass(r, "grass/raytraced").draws, 0u);
    for (const PassStats& pass : r.stats().passes) EXPECT_NE(pass.name, "grass/slices");
}

// Level ground is a node or few; rays are for no more of it than the slices reach.
TEST(Raytraced, OverLevelGroundPixelsBeyondTheMiddleTierCostNoRays) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    Project p = meadow(Technique::Hybrid);
    FlatField f = flatField(p);
    f.minGeom = 0.5f, f.maxGeom = 1, f.minBTF = 2, f.maxBTF = 3;
    f.hybrid.middleTier = MiddleTier::Raytraced;
    ViewSettings view = raytracedView();
    view.measure = true;
    ASSERT_TRUE(r.draw(p, grazing(), view));
    const uint64_t rays = raytracedPass(r, "grass/raytraced").fragments, all = raytracedPass(r, "grass/far").fragments;
    EXPECT_GT(rays, 0u);
    EXPECT_LT(rays, all / 2);
    ASSERT_TRUE(r.draw(p, ViewCamera{{10, 4, 1}, {10, 0, 4}, 40, 0}, view));
    EXPECT_EQ(raytracedPass(r, "grass/raytraced").draws, 0u) << "all of the ground is farther away";
}

// H-1 to H-5: along an axis, straight down, from on a slice, from inside the shell, and any way at all.
TEST(Raytraced, NoViewMakesAPixelThatIsNoNumber) {
    NoGlErrors errors;
    Project p = meadow(Technique::Raytraced);
    put<Wind>(p, "wind");
    Renderer r(gpu(), tables());
    const ViewSettings s = raytracedView(64, 48, 1);
    const auto sound = [&](const ViewCamera& c) {
        const auto image = raytracedPicture(r, p, c, s);
        EXPECT_TRUE(isFinite(image)) << c.eye.x << " " << c.eye.y << " " << c.eye.z;
        return image;
    };
    for (const double y : {0.02, 0.075, 0.149, 0.15, 1.0})
        for (const glm::dvec3& way : {glm::dvec3(1, 0, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 0, 1),
                                      glm::dvec3(0, 0, -1), glm::dvec3(0, -1, 0), glm::dvec3(0, 1, 0)})
            for (const double x : {10.0, 10.025, 10.5}) sound({{x, y, 10.025}, glm::dvec3(x, y, 10.025) + way, 60, 0});
    std::mt19937 random(7);
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    for (int i = 0; i < 300; ++i) {
        const glm::dvec3 eye(22 * unit() - 1, 0.4 * unit() * unit(), 22 * unit() - 1);
        sound({eye, eye + glm::dvec3(2 * unit() - 1, 1.2 * unit() - 1, 2 * unit() - 1),
               20 + 80 * static_cast<float>(unit()), 0});
    }
    // A column that looks along x shows the lawn as its neighbours do.
    const auto along = raytracedPicture(r, p, {{2, 1, 10}, {12, 0, 10}, 50, 0}, raytracedView(65, 48));
    double middle = 0, beside = 0;
    for (size_t y = 30; y < 48; ++y)
        for (size_t x : {30u, 31u, 32u, 33u, 34u})
            (x == 32 ? middle : beside) += static_cast<double>(along[3 * (y * 65 + x) + 1]);
    EXPECT_NEAR(middle / (beside / 4), 1, 0.15);
}

// How much rows of pixels differ from their neighbours in the mean, root mean square by the picture's brightness.
double rowsShow(const std::vector<float>& pixels, int width, int height) {
    std::vector<double> rows(size_t(height), 0.0);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) rows[size_t(y)] += pixels[(size_t(y) * size_t(width) + size_t(x)) * 3 + 1];
    double sum = 0, bright = 0;
    for (size_t y = 1; y + 1 < rows.size(); ++y) {
        const double off = rows[y] - 0.5 * (rows[y - 1] + rows[y + 1]);
        sum += off * off, bright += rows[y];
    }
    const double count = double(height - 2);
    return std::sqrt(sum / count) / (bright / count);
}

// Blades as short as slices lie apart, seen along an axis: images on straight slices show as rows (0.094 here).
TEST(Raytraced, AShortLawnShowsNoRowsOfSlices) {
    NoGlErrors errors;
    const ViewCamera along{{10, 1, 8.5}, {10, 0, 10}, 30, 0};
    const ViewSettings view = raytracedView(320, 240, 8);
    const auto pictureBy = [&](Technique technique) {
        Project p = meadow(technique);
        FlatField f = flatField(p);
        f.species[0].bladesPerM2 = 40000;
        f.species[0].height = 0.03f, f.species[0].width = 0.003f;
        f.cellSize = 0.5f, f.slices = 20;
        return raytracedPicture(p, along, view);
    };
    const double blades = rowsShow(pictureBy(Technique::Geometry), view.width, view.height),
                 rays = rowsShow(pictureBy(Technique::Raytraced), view.width, view.height);
    std::printf("rows by their neighbours: blades %.4f rays %.4f\n", blades, rays);
    EXPECT_LT(rays, 1.25 * blades);
}

TEST(Raytraced, AnEyeInTheGrassSeesGrass) {
    NoGlErrors errors;
    const Project p = meadow(Technique::Raytraced);
    const auto image = raytracedPicture(p, {{10, 0.06, 10}, {14, 0.05, 11}, 60, 0});
    const size_t pixels = image.size() / 3;
    size_t green = 0;
    for (size_t i = pixels / 2; i < pixels; ++i) green += image[3 * i + 1] > image[3 * i];
    EXPECT_GT(static_cast<double>(green) / (static_cast<double>(pixels) / 2), 0.9);
}

// A red post half sunk in the grass: what stands before it hides it, what stands behind does not.
// Rays that come in over bare ground go on to the grass beyond it, though it lies farther than their steps reach.
TEST(Raytraced, GrassBeyondBareGroundIsSeenAcrossIt) {
    NoGlErrors errors;
    const auto picture = [](Technique technique) {
        Project p = meadow(technique);
        FlatField f = flatField(p);
        f.species[0].height = 0.4f;
        f.drawing.bakeLight = BakeLight::Local;  // coverage alone counts
        Map density({80, 80, 1, PixelType::U8});
        for (int y = 0; y < 80; ++y)
            for (int x = 0; x < 80; ++x) density.set(x, y, 0, y < 20 ? 0.0f : 1.0f);  // from 5 m on
        f.species[0].density = field(std::move(density), "maps/density.png");
        return raytracedPicture(p, {{10, 0.6, 1}, {10, 0.3, 6}, 45, 0});
    };
    const double blades = covered(picture(Technique::Geometry)), rays = covered(picture(Technique::Raytraced));
    std::printf("covered beyond 4 m of bare ground: blades %.3f rays %.3f\n", blades, rays);
    EXPECT_GT(blades, 0.05);
    EXPECT_NEAR(rays, blades, 0.1 * blades);
}

TEST(Raytraced, HidesWhatStandsBehindIt) {
    NoGlErrors errors;
    const TempDir folder;
    const auto red = [&](Technique technique, double z, RayVisibility visibility = RayVisibility::Depth) {
        Project p = meadow(technique);
        p.dir = folder.path;
        flatField(p).raytraced.visibility = visibility;
        if (technique == Technique::Flat) flatField(p).species[0].bladesPerM2 = 0;
        putObject(p, "post", {{.size = {0.3, 0.2, 0.3}, .color = {0.9f, 0, 0}}}, {10, 0, z});
        const auto image = raytracedPicture(p, {{10, 0.5, 6}, {10, 0.05, 10}, 30, 0});
        double n = 0;
        for (size_t i = 0; i < image.size(); i += 3) n += image[i] > 3 * image[i + 1];
        return n;
    };
    const double bare = red(Technique::Flat, 9), blades = red(Technique::Geometry, 9),
                 rays = red(Technique::Raytraced, 9), ended = red(Technique::Raytraced, 9, RayVisibility::Scene);
    std::printf("pixels of the post: over bare ground %.0f, among blades %.0f, among rays %.0f, ended by it %.0f\n",
                bare, blades, rays, ended);
    for (const double n : {rays, ended}) {
        EXPECT_GT(n, 0);
        EXPECT_LT(n, 0.9 * bare);
        EXPECT_NEAR(n, blades, 0.15 * bare);
    }
    EXPECT_NE(rays, ended);
}

// The shadow of a post as tall grass shows it: on what a ray sees, not where the ray comes in over it.
TEST(Raytraced, AThinShadowLiesOnTheBladesThatAreSeen) {
    NoGlErrors errors;
    const TempDir folder;
    // By the post's shadow: between the picture in which it casts one and that in which it does not.
    const auto darkened = [&](Technique technique) {
        Project p = meadow(technique);
        p.dir = folder.path;
        flatField(p).species[0].height = 0.3f;
        putObject(p, "post", {{.size = {0.12, 2, 0.12}, .color = {0.1f, 0.1f, 0.1f}}}, {11.2, 0, 8});
        Light& sun = *p.registry.get<Light>(findEntity(p, "sun"));
        sun.azimuthDeg = 120, sun.elevationDeg = 35;  // across the picture
        const ViewCamera over{{10, 1.8, 4.5}, {10, 0, 8}, 50, 0};
        const auto shaded = raytracedPicture(p, over);
        p.registry.get<StaticMesh>(findEntity(p, "post"))->castShadows = false;
        const auto lit = raytracedPicture(p, over);
        std::vector<double> blocks(16 * 12);  // of 10 x 10 pixels
        for (size_t i = 0; i < lit.size(); ++i)
            blocks[i / 3 % 160 / 10 + 16 * (i / 3 / 160 / 10)] += double(lit[i] - shaded[i]);
        return blocks;
    };
    const auto blades = darkened(Technique::Geometry), rays = darkened(Technique::Raytraced);
    double both = 0, byBlades = 0, byRays = 0;
    for (size_t i = 0; i < rays.size(); ++i)
        both += std::max(std::min(rays[i], blades[i]), 0.0), byBlades += blades[i], byRays += rays[i];
    std::printf("shadow of a post: on rays %.3f of that on blades, %.3f of it there\n", byRays / byBlades,
                both / byBlades);
    EXPECT_NEAR(byRays / byBlades, 1, 0.25);
    EXPECT_GT(both / byBlades, 0.7);
}

TEST(Raytraced, LooksAtAsManyPixelsHoweverManySlicesThereAre) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    ViewSettings s = raytracedView();
    s.measure = true;
    std::vector<uint64_t> fragments;
    for (const int slices : {16, 64, 256}) {
        Project p = meadow(Technique::Raytraced);
        flatField(p).slices = slices;
        flatField(p).sliceWidth = 32, flatField(p).sliceHeight = 16;
        raytracedPicture(r, p, grazing(), s);
        fragments.push_back(raytracedPass(r, "grass/raytraced").fragments);
    }
    // Drivers that count after the depth test leave out what rays of the same pass hide: a few, by where these end.
    for (const uint64_t n : fragments)
        EXPECT_NEAR(static_cast<double>(n), static_cast<double>(fragments[0]),
                    0.005 * static_cast<double>(fragments[0]));
}

TEST(Raytraced, OneSetOfImagesForBothAxesTakesHalfTheMemoryAndLooksAlike) {
    NoGlErrors errors;
    for (const Technique technique : {Technique::Slices, Technique::Raytraced})
        for (const ViewCamera& camera : {grazing(), steep()}) {
            Project p = meadow(technique);
            Renderer r(gpu(), tables());
            const auto each = raytracedPicture(r, p, camera);
            const auto eachBytes = gpu().ledger.at("grass/slices");
            flatField(p).sliced.sets = SliceSets::Shared;
            const auto shared = raytracedPicture(r, p, camera);
            EXPECT_LT(static_cast<double>(gpu().ledger.at("grass/slices")) / static_cast<double>(eachBytes), 0.55);
            EXPECT_NE(each, shared);
            std::printf("covered: %.3f, shared %.3f; bright: %.4f, %.4f\n", covered(each), covered(shared),
                        brightness(each), brightness(shared));
            EXPECT_NEAR(covered(shared), covered(each), 0.05);
            EXPECT_NEAR(brightness(shared), brightness(each), 0.08 * brightness(each));
        }
}

TEST(Raytraced, LeansWithTheWindAndStillDoesAfterAMonth) {
    NoGlErrors errors;
    Project p = meadow(Technique::Raytraced);
    put<Wind>(p, "wind", {.strength = 0.8f});
    Renderer r(gpu(), tables());
    const auto at = [&](double time) {
        ViewSettings s = raytracedView();
        s.time = time;
        return raytracedPicture(r, p, grazing(), s);
    };
    const double month = 30 * 86400.0;
    EXPECT_NE(at(0), at(0.5));
    EXPECT_NE(at(month), at(month + 1.0 / 60));
    EXPECT_TRUE(isFinite(at(month)));
    EXPECT_EQ(at(0.5), at(0.5));
}

TEST(Raytraced, EverySettingAtItsEndsMakesASoundPicture) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    for (const int steps : {1, 64})
        for (const float share : {0.0f, 1.0f})
            for (const RayRest rest : {RayRest::Mean, RayRest::Opaque, RayRest::Nothing})
                for (const RayVisibility visibility : {RayVisibility::Depth, RayVisibility::Scene}) {
                    Project p = meadow(Technique::Raytraced);
                    FlatField f = flatField(p);
                    f.raytraced = {.steps = steps,
                                   .footprint = 64 * share,
                                   .cutOff = 0.5f + 0.5f * share,
                                   .depthAt = share,
                                   .rest = rest,
                                   .visibility = visibility,
                                   .maxDistance = share > 0 ? std::numeric_limits<float>::infinity() : 0.1f};
                    EXPECT_TRUE(isFinite(raytracedPicture(r, p, grazing(), raytracedView(64, 48))));
                }
}

TEST(Raytraced, OnASlopeCoversAsOnTheLevel) {
    NoGlErrors errors;
    const auto hill = [](Technique technique) {
        Project p = meadow(technique);
        Map m({64, 64, 1, PixelType::F32});
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                m.set(x, y, 0, 0.4f * std::sin(0.3f * static_cast<float>(x)) + 0.05f * static_cast<float>(y));
        p.registry.get<Terrain>(findEntity(p, "ground"))->height = field(m);
        return p;
    };
    const ViewCamera camera{{10, 4, 1}, {10, 0.5, 5}, 40, 0};
    const double flat = covered(raytracedPicture(meadow(Technique::Raytraced), camera)) /
                        covered(raytracedPicture(meadow(Technique::Geometry), camera));
    const double hilly = covered(raytracedPicture(hill(Technique::Raytraced), camera)) /
                         covered(raytracedPicture(hill(Technique::Geometry), camera));
    EXPECT_NEAR(hilly, flat, 0.15);
}

}  // namespace
}  // namespace sward::test
