// Grass of which a cell has less than a blade: every technique, and the truth, shows as much of it, and half as much
// where half is painted. How many blades there are: tests/scene/population_test.cpp.
#include "core/jobs.h"
#include "fields.h"
#include "reference/grass_rays.h"
#include "scenes.h"

namespace sward::test {
namespace {

// A blade a square metre in cells of half a metre, broad and low, on red soil of 40 m; half as many where it is
// painted.
Project sparse(bool painted) {
    Project p = lawn();
    Terrain& t = *p.registry.get<Terrain>(findEntity(p, "ground"));
    t.size = {40, 40}, t.groundColor = {0.3f, 0.05f, 0.02f};
    FlatField f = flatField(p);
    Species& s = f.species[0];
    s.bladesPerM2 = 1, s.height = 0.5f, s.width = 0.3f, s.clumpStrength = 0;
    if (painted) s.density = field(filled({4, 4, 1, PixelType::U8}, 128 / 255.0f), "maps/d.png");
    f.groundShadows = false, f.fade = 0;
    f.slices = 8, f.sliceWidth = 64, f.sliceHeight = 64, f.farSize = 64;
    f.minGeom = 4, f.maxGeom = 8, f.minBTF = 90, f.maxBTF = 99, f.maxDistance = 90, f.thinning = 0;
    f.beyond = Beyond::Nothing;
    return p;
}

// How much greener than red a picture is in the mean: in proportion to what grass covers of red soil, also where it
// covers pixels in part.
double greener(const std::vector<float>& pixels) {
    double sum = 0;
    for (size_t i = 0; i < pixels.size(); i += 3)
        sum += static_cast<double>(pixels[i + 1]) - static_cast<double>(pixels[i]);
    return 3 * sum / static_cast<double>(pixels.size());
}

double coverOf(Renderer& r, Project& p, const char* technique) {
    flatField(p).technique = technique;
    ViewSettings s = small();
    s.width = 320, s.height = 240;
    double sum = 0;
    for (const glm::dvec2 at : {glm::dvec2(4, 4), glm::dvec2(20, 3), glm::dvec2(36, 20), glm::dvec2(5, 33)}) {
        const glm::dvec2 to = at + 6.0 * glm::normalize(glm::dvec2(20, 20) - at);  // no sky is seen
        EXPECT_TRUE(r.draw(p, {{at.x, 5, at.y}, {to.x, 0, to.y}, 55, 0}, s));
        sum += greener(r.readLinear()) / 4;
    }
    return sum;
}

// Share of slanted rays from above that a blade stops.
double stopped(const Project& p) {
    JobControl control;
    const auto grass = GrassRays::make(p, 0, control);
    EXPECT_TRUE(grass);
    GrassMemory memory;
    int n = 0;
    for (int z = 0; z < 400; ++z)
        for (int x = 0; x < 400; ++x)
            n += grass->blocks(
                {{0.05 + 0.1 * x, 1, 0.05 + 0.1 * z}, glm::normalize(glm::dvec3(0.6, -0.5, 0.6)), 0, 9, 1}, memory);
    return n / 160000.0;
}

TEST(SparseGrass, IsAsMuchAsIsAskedForByEveryTechniqueAndTheTruth) {
    NoGlErrors errors;
    Project whole = sparse(false), half = sparse(true), bare = sparse(false);
    flatField(bare).species[0].bladesPerM2 = 0;
    Renderer r(gpu(), tables()), other(gpu(), tables());
    const double soil = coverOf(r, bare, "geometry"), blades = coverOf(r, whole, "geometry") - soil;
    EXPECT_GT(blades, 0.001);
    for (const char* technique : {"geometry", "tessellated", "hybrid", "raytraced"}) {
        const double cover = coverOf(r, whole, technique) - soil;
        // Slices show less of blades as broad as these are, which each cuts.
        EXPECT_GT(cover / blades, 0.5) << technique;
        EXPECT_LT(cover / blades, 1.25) << technique;
        EXPECT_NEAR((coverOf(other, half, technique) - soil) / cover, 128 / 255.0, 0.1) << technique;
    }
    EXPECT_GT(stopped(whole), 0.01);
    EXPECT_NEAR(stopped(half) / stopped(whole), 128 / 255.0, 0.05);
}

// One blade in every hundredth cell; slices of empty cells are not drawn.
TEST(SparseGrass, CellsWithoutABladeCostNoSlices) {
    Project p = sparse(false);
    flatField(p).cellSize = 0.1f;
    flatField(p).technique = "slices";
    flatField(p).drawing.bakeLight = BakeLight::Local;  // counts are counted in any light
    Renderer r(gpu(), tables());
    ViewSettings s = small();
    s.measure = true;
    ASSERT_TRUE(r.draw(p, {{20, 60, 20}, {20, 0, 20.1}, 55, 0}, s));
    EXPECT_GT(r.stats().sliceQuads, 16u * 1000);
    EXPECT_LT(r.stats().sliceQuads, 16u * 2000) << "1,600 blades, 16 quads for each";
}

}  // namespace
}  // namespace sward::test
