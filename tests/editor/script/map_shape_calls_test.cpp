// Shapes drawn into maps by scripts.
#include "editor/script/script_stage.h"

namespace sward {
namespace {

using test::ScriptStage;

TEST(MapShapeCalls, MapSizeSetsTheLengthThatBrushesAndShapesCover) {
    EXPECT_RUNS(R"(
        project.new()
        entity.set("ground.Terrain.size", {90000, 90000})
        entity.set("ground.Terrain.mapSize", 20)
        map.create{path = "density", width = 200, height = 200, value = 0}
        map.disc("density", {x = 5, z = 5, radius = 2})
        expect.equal(map.at("density", 5 + 20 * 4000, 5), 1)
        expect.equal(map.at("density", 15 + 20 * 4000, 5), 0))");
}

}  // namespace
}  // namespace sward
