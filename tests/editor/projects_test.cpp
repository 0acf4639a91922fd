// The sample projects and test scenes: their make.lua runs without a window and keeps what it promises.
#include <gtest/gtest.h>

#include "grass/slice_settings.h"
#include "model/bakes.h"
#include "model/scene_export.h"
#include "project/project_files.h"
#include "script/script.h"
#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

namespace fs = std::filesystem;
using test::TempDir;

// Runs a make.lua of the source tree on a copy of it in `dir`, and loads what it made.
Result<Project> make(const TempDir& dir, const std::string& place) {
    const fs::path folder = dir / fs::path(place).filename().string();
    fs::create_directories(folder);
    fs::copy_file(fs::path(SWARD_SOURCE_DIR) / place / "make.lua", folder / "make.lua",
                  fs::copy_options::overwrite_existing);
    const test::EmptyCache cache;  // what is baked is baked here, not found
    Document document(tables());
    ScriptHost host{document};
    offerBakes(host);
    offerExport(host);
    if (Status made = runScript(folder / "make.lua", host); !made) return made.error();
    const CheckReport report = checkProject(folder, tables().components);
    EXPECT_TRUE(report.refused.empty() && report.repaired.empty()) << place;
    return loadProject(folder, tables().components);
}
const Map& mapOf(Project& p, const std::string& name) {
    return static_cast<const MapField*>(findMap(p, tables().components, name)->value)->map;
}
template <class C>
const C& the(const Project& p, const std::string& entity) {
    return *p.registry.get<C>(findEntity(p, entity));
}

void expectCameras(const Project& p) {
    for (const char* name : {"whole", "human", "low"})
        EXPECT_NE(p.registry.get<Camera>(findEntity(p, name)), nullptr) << name;
}

// Every corner of the terrain is before the camera and within its picture of 4 to 3.
void expectSees(const Project& p, const Camera& c, glm::dvec2 from, glm::dvec2 to) {
    const glm::dvec3 forward = glm::normalize(c.target - c.eye), right = glm::normalize(glm::cross(forward, {0, 1, 0}));
    const glm::dvec3 up = glm::cross(right, forward);
    const double half = std::tan(glm::radians(double(c.fovDeg)) / 2);
    for (const glm::dvec2 corner : {from, glm::dvec2(to.x, from.y), to, glm::dvec2(from.x, to.y)}) {
        const glm::dvec3 d = glm::dvec3(corner.x, 0, corner.y) - c.eye;
        const double depth = glm::dot(d, forward);
        EXPECT_GT(depth, 0);
        EXPECT_LT(std::abs(glm::dot(d, right)) / depth, half * 4 / 3);
        EXPECT_LT(std::abs(glm::dot(d, up)) / depth, half);
    }
    EXPECT_FALSE(p.entities.empty());
}

struct Football {
    TempDir dir;
    Result<Project> made = make(dir, "projects/football");
    static Football& once() {
        static Football instance;
        return instance;
    }
};
// A point of the pitch, measured from its corner, in the vegetation map's channel of opacity.
float whiteAt(Project& p, double x, double z) {
    const glm::dvec2 size = the<Terrain>(p, "ground").size;
    const Map& map = mapOf(p, "vegetation");
    return map.sample((10 + x) / size.x, (10 + z) / size.y, 3);
}

TEST(SampleProjects, FootballHas627MillionBladesOnAPitchOf105By68Metres) {
    auto& made = Football::once().made;
    ASSERT_TRUE(made) << made.error().text();
    Project& p = *made;
    EXPECT_EQ(p.name, "football");
    EXPECT_NEAR(virtualBlades(p), 627e6, 627e6 * 1e-6);
    const Map& density = mapOf(p, "density");
    const glm::dvec2 size = the<Terrain>(p, "ground").size;
    EXPECT_NEAR(density.mean() * size.x * size.y, 105 * 68, 0.01);
    for (const auto& [x, z, wanted] : {std::tuple{9.9, 44.0, 0.0f},
                                       {10.1, 44.0, 1.0f},
                                       {114.9, 44.0, 1.0f},
                                       {115.1, 44.0, 0.0f},
                                       {60.0, 9.9, 0.0f},
                                       {60.0, 10.1, 1.0f},
                                       {60.0, 77.9, 1.0f},
                                       {60.0, 78.1, 0.0f}})
        EXPECT_EQ(density.sample(x / size.x, z / size.y), wanted) << x << "," << z;
    const GrassField& field = the<GrassField>(p, "turf");
    EXPECT_EQ(field.cellSize, 0.5f);
    const Species& s = field.species[0];
    EXPECT_GE(s.height * (1 - s.heightVariation), 0.025f);
    EXPECT_LE(s.height * (1 + s.heightVariation), 0.038f);
    expectCameras(p);
    expectSees(p, the<Camera>(p, "whole"), {10, 10}, {115, 78});
}

TEST(SampleProjects, FootballIsMownInTwentyStripesThatLeanInTurn) {
    auto& made = Football::once().made;
    ASSERT_TRUE(made) << made.error().text();
    const Map& lean = mapOf(*made, "orientation");
    for (int i = 0; i < 20; ++i) {
        const double x = 10 + (i + 0.5) * 5.25;
        const float along = lean.sample(x / 125, 0.5, 1) - 0.5f;
        EXPECT_GT(i % 2 == 0 ? along : -along, 0.4f) << "stripe " << i;
        EXPECT_NEAR(lean.sample(x / 125, 0.5, 0), 0.5f, 1e-3f);
    }
}

TEST(SampleProjects, FootballIsLinedByTheLawsOfTheGame) {
    auto& made = Football::once().made;
    ASSERT_TRUE(made) << made.error().text();
    Project& p = *made;
    const double halfLine = 0.06, middle = 52.5, axis = 34;
    struct Point {
        double x, z;
    };
    const std::vector<Point> white = {
        {halfLine, 20},
        {105 - halfLine, 20},
        {30, halfLine},
        {30, 68 - halfLine},  // the frame
        {middle, 10},
        {middle, axis},
        {middle + 9.15 - halfLine, axis},
        {middle, axis - 9.15 + halfLine},  // the centre
        {16.5 - halfLine, 20},
        {105 - 16.5 + halfLine, 20},
        {8, axis - 20.16 + halfLine},
        {8, axis + 20.16 - halfLine},  // penalty areas
        {5.5 - halfLine, 30},
        {105 - 5.5 + halfLine, 30},
        {3, axis - 9.16 + halfLine},
        {3, axis + 9.16 - halfLine},  // goal areas
        {11, axis},
        {94, axis},
        {11 + 9.15 - halfLine, axis},
        {94 - 9.15 + halfLine, axis},  // spots and their arcs
        {0.664, 0.664},
        {104.336, 0.664},
        {0.664, 67.336},
        {104.336, 67.336},  // corners, at 45 degrees
    };
    for (const Point& w : white) EXPECT_GT(whiteAt(p, w.x, w.z), 0.8f) << w.x << "," << w.z;
    const std::vector<Point> green = {{0.2, 20},
                                      {30, 0.2},
                                      {middle + 0.2, 10},
                                      {middle + 9.15 + 0.1, axis},
                                      {16.5 + 0.1, 20},
                                      {16.5 - 0.22, 20},
                                      {11 + 9.15 + 0.1, axis},
                                      {9, 25},
                                      {5.5 + 0.1, 30},
                                      {0.4, 0.4},
                                      {1.1, 1.1},
                                      {11 - 9.15 + halfLine, axis}};
    for (const Point& g : green)
        EXPECT_LT(whiteAt(p, g.x, g.z), 0.45f) << g.x << "," << g.z;  // worn grass is tinted a little
    const Map& ground = mapOf(p, "terrainMap");
    EXPECT_GT(ground.sample((10 + middle) / 125, 20.0 / 88, 3), 0.8f);  // lines are on the soil too
    EXPECT_LT(ground.sample((10 + middle + 1) / 125, 20.0 / 88, 3), 0.1f);
}

struct Park {
    TempDir dir;
    Result<Project> made = make(dir, "projects/park");
    static Park& once() {
        static Park instance;
        return instance;
    }
};
TEST(SampleProjects, ParkRollsAndIsBareOnItsPathsAndPonds) {
    auto& made = Park::once().made;
    ASSERT_TRUE(made) << made.error().text();
    Project& p = *made;
    expectCameras(p);
    expectSees(p, the<Camera>(p, "whole"), {0, 0}, {120, 120});
    const Map &height = mapOf(p, "height"), &lawn = mapOf(p, "species[lawn].density"),
              &meadow = mapOf(p, "species[meadow].density");
    EXPECT_EQ(height.info().type, PixelType::F32);
    float low = 1e9f, high = -1e9f;
    for (int y = 0; y < height.info().height; ++y)
        for (int x = 0; x < height.info().width; ++x)
            low = std::min(low, height.at(x, y)), high = std::max(high, height.at(x, y));
    EXPECT_GT(high - low, 2);
    EXPECT_LT(high - low, 6);
    for (const auto& [x, z] : {std::pair{38.0, 44.0}, {84.0, 82.0}, {48.0, 62.0}, {62.0, 68.0}, {98.0, 56.0}}) {
        EXPECT_EQ(lawn.sample(x / 120, z / 120), 0) << x << "," << z;
        EXPECT_EQ(meadow.sample(x / 120, z / 120), 0) << x << "," << z;
    }
    EXPECT_GT(lawn.mean(), 0.6);
    EXPECT_GT(meadow.mean(), 0.08);
    EXPECT_GT(meadow.sample(90.0 / 120, 27.0 / 120), 0.2f);
    for (const char* name : {"human", "low"}) {
        const Camera& c = the<Camera>(p, name);
        const double above = c.eye.y - height.sample(c.eye.x / 120, c.eye.z / 120);
        EXPECT_NEAR(above, name == std::string("human") ? 1.7 : 0.28, 0.05) << name;
    }
}

TEST(SampleProjects, Field40HasAThousandBladesASquareMetreAndOneCamera) {
    const TempDir dir;
    Result<Project> made = make(dir, "tests/scenes/field40");
    ASSERT_TRUE(made) << made.error().text();
    EXPECT_EQ(virtualBlades(*made), 1.6e6);
    EXPECT_EQ(made->registry.count<Camera>(), 1u);
    EXPECT_NEAR(the<Camera>(*made, "eye").eye.y, 1.7, 0.01);
}

// Makes a project over `first`, as the build does; its maps are those that `first` had.
void expectTheSameMapsAgain(const std::string& project, const TempDir& dir, Result<Project>& first, size_t count) {
    const auto hashes = [](Project& p) {
        std::vector<uint64_t> all;
        for (const FieldRef& f : allMaps(p, tables().components))
            all.push_back(static_cast<const MapField*>(f.value)->map.hash());
        return all;
    };
    ASSERT_TRUE(first) << first.error().text();
    const std::vector<uint64_t> expected = hashes(*first);
    Result<Project> again = make(dir, project);
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ(expected, hashes(*again));
    EXPECT_EQ(expected.size(), count);
}
TEST(SampleProjects, MakingAProjectAgainGivesTheSameMaps) {
    TempDir dir;
    Result<Project> first = make(dir, "projects/lawn");
    expectTheSameMapsAgain("projects/lawn", dir, first, 4);
}
TEST(SampleProjects, MakingAParkAgainGivesTheSameMaps) {
    expectTheSameMapsAgain("projects/park", Park::once().dir, Park::once().made, 7);
}

TEST(SampleProjects, LawnHasEightByEightPatchesOfSixteenAndOfThirtyTwoSlicesAndIsRayTraced) {
    TempDir dir;
    Result<Project> made = make(dir, "projects/lawn");
    ASSERT_TRUE(made) << made.error().text();
    Project& p = *made;
    for (const auto& [entity, slices] : {std::pair{"grass", 16}, {"turf", 32}}) {
        const GrassField& field = the<GrassField>(p, entity);
        EXPECT_EQ(field.technique, "raytraced");
        EXPECT_EQ(the<Terrain>(p, "ground").size.x / static_cast<double>(field.cellSize), 8);
        EXPECT_EQ(the<GrassSlices>(p, entity).slices, slices);
    }
    EXPECT_EQ(mapOf(p, "species[turf].density").sample(4.7 / 8, 4.5 / 8), 1) << "the bed of turf";
    EXPECT_EQ(mapOf(p, "species[meadow].density").sample(4.7 / 8, 4.5 / 8), 0) << "where no other grass grows";
    expectCameras(p);
}

}  // namespace
}  // namespace sward
