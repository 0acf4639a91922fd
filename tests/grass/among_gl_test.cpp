// Low grass in a gap of tall grass, under a low sun: as dark as in the ray-traced truth; and crests as high as their
// grass.
#include "comparison.h"
#include "missed.h"
#include "reference/reference.h"
#include "scenes.h"
#include "techniques.h"

namespace sward::test {
namespace {

constexpr int kPixels = 48;
constexpr double kSide = 8;
const ViewCamera kIntoTheGap{{4, 2.2, 4}, {4, 0, 4.01}, 11, 0};

// Tall grass with a gap of 0.6 m along z through the middle, where a few stand.
Species tallGrass() {
    Species s;
    s.name = "tall", s.bladesPerM2 = 700, s.height = 0.7f, s.width = 0.016f, s.bend = 0.1f, s.clumpSize = 0;
    Map m({80, 80, 1, PixelType::F32});
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 80; ++x) m.set(x, y, 0, x >= 37 && x < 43 ? 0.05f : 1.0f);
    s.density = {"maps/gap.png", std::move(m)};
    return s;
}
Species lowGrass() {
    Species s;
    s.name = "low", s.bladesPerM2 = 9000, s.height = 0.08f, s.width = 0.006f, s.leanDeg = 45, s.clumpSize = 0;
    return s;
}
// In one field or in two, which know nothing of each other.
Project gap(bool together) {
    Project p;
    Terrain ground;
    ground.size = {kSide, kSide};
    give(p, "ground", ground);
    FlatField f;
    f.species = {lowGrass()};
    if (together) f.species.push_back(tallGrass());
    put(p, "grass", f);
    if (!together) {
        FlatField other;
        other.species = {tallGrass()};
        put(p, "others", other);
    }
    Light sun;
    sun.azimuthDeg = 90, sun.elevationDeg = 25;
    give(p, "sun", sun);
    return p;
}

double greenOf(const std::vector<float>& image) {
    double sum = 0;
    for (size_t i = 1; i < image.size(); i += 3) sum += static_cast<double>(image[i]);
    return sum / static_cast<double>(image.size() / 3);
}
double drawnGap(Project p, Technique technique) {
    for (const auto& [name, entity] : fieldsOf(p))
        p.registry.get<GrassField>(findEntity(p, name))->technique = nameOf(technique);
    Renderer r(gpu(), tables());
    EXPECT_TRUE(r.draw(p, kIntoTheGap, sized(kPixels, kPixels)));
    return greenOf(r.readLinear());
}

TEST(AmongGl, AGapInTallGrassIsAsDarkAsInTheTruth) {
    NoGlErrors errors;
    JobControl control;
    const Project p = gap(true);
    const auto scene = ReferenceScene::make(p, tables(), 0, control);
    ASSERT_TRUE(scene) << scene.error().text();
    ReferenceSettings s;
    s.width = s.height = kPixels, s.samples = 32;
    const double truth = greenOf(scene->trace(kIntoTheGap, s, control)->color);
    for (const Technique t : {Technique::Geometry, Technique::Tessellated}) {
        const double together = drawnGap(gap(true), t), apart = drawnGap(gap(false), t);
        printf("%-12s %.4f, truth %.4f; of two fields, which do not shade each other, %.4f\n", nameOf(t), together,
               truth, apart);
        EXPECT_LE(std::abs(together - truth), 0.15 * (apart - truth)) << nameOf(t);
        EXPECT_GT(apart, 5 * truth) << nameOf(t) << ": the rival that must lose";
    }
}

// Black grass of a quarter of its density on bright soil, under the sun alone: what is seen is soil, and what the
// blades leave of its light. Leaves' area is in proportion to the density, and so is the logarithm of the light, not
// the light.
TEST(AmongGl, SoilUnderThinGrassIsAsDarkAsInTheTruth) {
    NoGlErrors errors;
    const ViewCamera aside{{4, 9, -16}, {4, 0, 4}, 12, 0};
    Project p;
    Terrain ground;
    ground.size = {kSide, kSide}, ground.groundColor = {0.5f, 0.5f, 0.5f};
    give(p, "ground", ground);
    FlatField f;
    Species& s = f.species[0];
    s.bladesPerM2 = 4000, s.height = 0.3f, s.width = 0.0065f;
    s.rootColor = s.midColor = s.tipColor = {0, 0, 0};
    f.sliceWidth = 512, f.sliceHeight = 128, f.farSize = 512;
    s.density = {"maps/thin.png", filled({8, 8, 1, PixelType::F32}, 0.25f)};
    put(p, "grass", f);
    Light sun;
    sun.azimuthDeg = 60, sun.elevationDeg = 40;
    give(p, "sun", sun);
    JobControl control;
    const auto scene = ReferenceScene::make(p, tables(), 0, control);
    ASSERT_TRUE(scene) << scene.error().text();
    ReferenceSettings settings;
    settings.width = settings.height = kPixels, settings.samples = 16;
    const double truth = greenOf(scene->trace(aside, settings, control)->color);
    EXPECT_GT(truth, 0.01);
    for (const Technique t : {Technique::Flat, Technique::Raytraced, Technique::Tessellated}) {
        for (const auto& [name, entity] : fieldsOf(p))
            p.registry.get<GrassField>(findEntity(p, name))->technique = nameOf(t);
        Renderer r(gpu(), tables());
        ASSERT_TRUE(r.draw(p, aside, sized(kPixels, kPixels)));
        const double drawn = greenOf(r.readLinear());
        printf("%-12s %.3f of the truth's soil\n", nameOf(t), drawn / truth);
        if (t == Technique::Raytraced)
            expectMissed("soil between thin blades, seen by rays", std::abs(drawn / truth - 1), 0.12, 0.582);
        else
            EXPECT_NEAR(drawn / truth, 1, 0.12) << nameOf(t);
    }
}

// Rows of pixels from the top of the picture down to where a column first shows grass, in the mean.
double rowsOfSky(const std::vector<float>& image, int width) {
    const int height = static_cast<int>(image.size()) / 3 / width;
    double sum = 0;
    for (int x = 0; x < width; ++x) {
        int y = 0;
        while (y < height && image[static_cast<size_t>(3 * (y * width + x)) + 1] <
                                 1.5f * image[static_cast<size_t>(3 * (y * width + x)) + 2])
            ++y;
        sum += y;
    }
    return sum / width;
}

TEST(AmongGl, ACrestIsAsHighAsItsGrassWhereverTheFlatTierStandsForIt) {
    NoGlErrors errors;
    Project p = designed(kMeadow, 80);
    removeEntity(p, "haze");
    Species& tall = p.registry.get<GrassField>(findEntity(p, "grass"))->species[0];
    tall.height = 1, tall.width = 0.02f;
    Map hill({80, 80, 1, PixelType::F32});  // up to 3 m at 60 m along z, then down
    for (int z = 0; z < 80; ++z)
        for (int x = 0; x < 80; ++x)
            hill.set(x, z, 0, z < 60 ? 0.05f * static_cast<float>(z) : 3 - 0.2f * static_cast<float>(z - 60));
    p.registry.get<Terrain>(findEntity(p, "ground"))->height = {"maps/hill.exr", std::move(hill)};
    const ViewCamera camera{{40, 2.5, 5}, {40, 3, 60}, 8, 0};
    ReferenceSettings s;
    s.width = 96, s.height = 72, s.samples = 8;
    JobControl control;
    const auto scene = ReferenceScene::make(p, tables(), 0, control);
    ASSERT_TRUE(scene) << scene.error().text();
    const double truth = rowsOfSky(scene->trace(camera, s, control)->color, s.width);
    const double metre = static_cast<double>(pixelsPerMetre(camera, s.height)) / 55;  // pixels, on the crest
    grassIn(p).technique = "flat";
    Renderer r(gpu(), tables());
    ASSERT_TRUE(r.draw(p, camera, sized(s.width, s.height)));
    const double drawn = rowsOfSky(r.readLinear(), s.width);
    printf("rows of sky %.2f, of the truth %.2f; a metre there is %.2f\n", drawn, truth, metre);
    EXPECT_NEAR(drawn, truth, 0.25 * metre);
}

}  // namespace
}  // namespace sward::test
