// Values that scripts give to fields: what is none is refused, and the old one kept.
#include <fmt/format.h>

#include "editor/script/script_stage.h"

namespace sward {
namespace {

using test::ScriptStage;

TEST(ScriptValues, AStiffnessThatIsNoneIsRefusedAndTheOldOneKept) {
    for (const char* value : {"0", "-1", "0/0", "math.huge", "0.01", "101", "'stiff'"})
        EXPECT_RUNS(fmt::format(R"(
            project.new()
            entity.set('lawn.GrassField.species[lawn].stiffness', 2)
            local done, why = pcall(entity.set, 'lawn.GrassField.species[lawn].stiffness', {})
            expect.truthy(not done)
            expect.truthy(why:find('lawn.GrassField.species[lawn].stiffness', 1, true))
            expect.equal(entity.get('lawn.GrassField.species[lawn].stiffness'), 2))",
                                value));
}

TEST(ScriptValues, TilingsThatAreNoneAreRefused) {
    for (const char* field : {"ground.Terrain.heightTiling", "ground.Terrain.terrainMapTiling",
                              "lawn.GrassField.species[lawn].densityTiling", "lawn.GrassField.bladeHeightTiling"})
        for (const char* value : {"0", "-1", "1e9", "0/0", "-math.huge", "math.huge", "'x'"})
            EXPECT_NE(ScriptStage().fault(fmt::format("project.new()\nentity.set('{}', {})", field, value)), "")
                << field << " = " << value;
}

}  // namespace
}  // namespace sward
