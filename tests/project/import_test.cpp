// Maps that are imported and exported: orientation, range, type.
#include "project/import.h"

#include <gtest/gtest.h>

#include "maps/map_io.h"
#include "project/project_files.h"
#include "scene/project.h"
#include "tests/maps/images.h"
#include "tests/rows.h"
#include "tests/support.h"

namespace sward::test {
namespace {

namespace fs = std::filesystem;
// Ground and a meadow of two species.
Project meadow() {
    Project p;
    p.registry.add<Terrain>(*addEntity(p, "ground"));
    GrassField field;
    field.species.resize(2);
    field.species[0].name = "lawn";
    field.species[1].name = "weeds";
    p.registry.add<GrassField>(*addEntity(p, "meadow"), std::move(field));
    return p;
}
GrassField& grassOf(Project& p) { return *p.registry.get<GrassField>(findEntity(p, "meadow")); }

TEST(Imports, FlipAndRangeAreRememberedAndServeTheExport) {
    TempDir dir;
    Map heights({3, 2, 1, PixelType::U16});
    heights.set(0, 0, 0, 1);
    ASSERT_TRUE(writeMap(dir / "dem.png", heights));
    Project p = meadow();
    p.dir = dir / "p";
    ASSERT_TRUE(importMap(p, rows(), "height", dir / "dem.png", {true, std::pair(-5.0, 95.0)}));
    const auto& terrain = *p.registry.get<Terrain>(findEntity(p, "ground"));
    EXPECT_EQ(terrain.height.map.at(0, 1), 1.0f) << "flipped";
    EXPECT_EQ(terrain.heightRange, glm::dvec2(-5, 95));
    EXPECT_EQ(terrain.height.file, "maps/ground.height.png");
    ASSERT_TRUE(saveProject(p, rows()));
    Project again = std::move(*loadProject(dir / "p", rows()));
    EXPECT_EQ(again.imports, p.imports);
    EXPECT_EQ(again.imports.at("ground.Terrain.height"), (MapImport{"dem.png", true, std::pair(-5.0, 95.0)}));
    ASSERT_TRUE(exportMap(again, rows(), "height", dir / "out.png"));
    EXPECT_EQ(readMap(dir / "out.png", {})->hash(), heights.hash()) << "out as it came in";
    ASSERT_TRUE(exportMap(again, rows(), "height", dir / "out.exr"));
    EXPECT_EQ(readMap(dir / "out.exr", {})->at(0, 0), 95.0f) << "floats in metres";
    ASSERT_TRUE(exportMap(again, rows(), "height", dir / "out.r16"));
    EXPECT_EQ(sidecarRange(dir / "out.r16"), (std::pair<double, double>(-5, 95)));
    ASSERT_TRUE(importMap(again, rows(), "height", dir / "dem.png"));
    EXPECT_EQ(again.registry.get<Terrain>(findEntity(again, "ground"))->height.map.at(0, 1), 1.0f)
        << "flipped as before";
}

TEST(Imports, OtherMapsTakeTheirOwnType) {
    TempDir dir;
    Map floats({2, 1, 1, PixelType::F32});
    floats.set(0, 0, 0, 50);
    floats.set(1, 0, 0, 200);
    ASSERT_TRUE(writeMap(dir / "d.exr", floats));
    Project p = meadow();
    ASSERT_TRUE(importMap(p, rows(), "[lawn].density", dir / "d.exr", {{}, std::pair(0.0, 100.0)}));
    const Map& map = grassOf(p).species[0].density.map;
    EXPECT_EQ(map.info().type, PixelType::U16);
    EXPECT_NEAR(map.at(0, 0), 0.5f, 1e-5);
    EXPECT_EQ(map.at(1, 0), 1.0f) << "beyond the range: clamped";
}

TEST(Imports, AFailureChangesNothing) {
    TempDir dir;
    ASSERT_TRUE(writeMap(dir / "m8.png", patternMap({4, 4, 1, PixelType::U8})));
    ASSERT_TRUE(writeMap(dir / "m16.png", patternMap({4, 4, 1, PixelType::U16})));
    Project p = meadow();
    EXPECT_EQ(importMap(p, rows(), "height", dir / "m8.png").error().code, ExitCode::Unsound);
    EXPECT_EQ(importMap(p, rows(), "none", dir / "m8.png").error().code, ExitCode::Usage);
    EXPECT_EQ(importMap(p, rows(), "vegetation", dir / "m8.png").error().message, "has 1 channel, not 4");
    EXPECT_EQ(importMap(p, rows(), "height", dir / "m16.png", {{}, std::pair(5.0, 5.0)}).error().code, ExitCode::Usage);
    EXPECT_EQ(importMap(p, rows(), "height", dir / "m16.png", {{}, std::pair(-1e9, 5.0)}).error().code,
              ExitCode::Usage);
    EXPECT_TRUE(allMaps(p, rows()).empty());
    EXPECT_TRUE(p.imports.empty());
    EXPECT_EQ(exportMap(p, rows(), "height", dir / "out.png").error().code, ExitCode::Usage);
    EXPECT_FALSE(fs::exists(dir / "out.png"));
}

}  // namespace
}  // namespace sward::test
