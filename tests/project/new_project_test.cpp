// A new project: what it holds, and where it is not made.
#include <gtest/gtest.h>

#include <set>

#include "project/project_files.h"
#include "scene/project.h"
#include "techniques.h"
#include "tests/rows.h"
#include "tests/support.h"

namespace sward::test {
namespace {

namespace fs = std::filesystem;
Project loaded(const fs::path& dir) {
    Result<Project> p = loadProject(dir, rows());
    EXPECT_TRUE(p) << (p ? "" : p.error().text());
    return p ? std::move(*p) : Project();
}

TEST(NewProject, HasGroundGrassSunSkyHazeAndACamera) {
    TempDir dir;
    ASSERT_TRUE(newProject(dir / "park", rows()));
    Project p = loaded(dir / "park");
    EXPECT_EQ(p.name, "park");
    const std::set<std::string> names{"camera", "ground", "haze", "lawn", "sky", "sun"};
    std::set<std::string> found;
    for (const auto& [name, entity] : p.entities) found.insert(name);
    EXPECT_EQ(found, names);
    EXPECT_DOUBLE_EQ(virtualBlades(p), 4000.0 * 40 * 40);
    const FeatureSet expected = featureSet(
        Feature::Terrain, Feature::Grass, Feature::GrassDensity, Feature::GrassClumps, Feature::GrassGeometry,
        Feature::GrassSlices, Feature::GrassFar, Feature::BladeShadows, Feature::GroundShadows, Feature::GrassTraced,
        Feature::Sun, Feature::CastingLights, Feature::Sky, Feature::Atmosphere, Feature::TerrainBeyond, Feature::Fog);
    EXPECT_EQ(sceneFeatures(p.registry, tables()), expected);
}

TEST(NewProject, IsNotMadeWhereThereAreFiles) {
    TempDir dir;
    writeText(dir / "park/letter.txt", "dear");
    const Result<Project> p = newProject(dir / "park", rows());
    ASSERT_FALSE(p);
    EXPECT_EQ(p.error().code, ExitCode::Failed);
    EXPECT_EQ(std::distance(fs::directory_iterator(dir / "park"), {}), 1);
}

}  // namespace
}  // namespace sward::test
