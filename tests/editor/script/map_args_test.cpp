// Arguments of map.* that make no sense: each is refused with what would.
#include "editor/script/script_stage.h"

namespace sward {
namespace {

using test::ScriptStage;

TEST(MapArgs, WrongMapArgumentsAreRefused) {
    const std::string begin = "project.new() local d = 'density' ";
    EXPECT_FAULT(ScriptStage(), begin + "map.create{path = d, width = 0, height = 5}", "width must be a whole number");
    EXPECT_FAULT(ScriptStage(), begin + "map.create{path = d, width = 5.5, height = 5}",
                 "width must be a whole number");
    EXPECT_FAULT(ScriptStage(), begin + "map.create{path = d, width = 5}", "height is missing");
    EXPECT_FAULT(ScriptStage(), begin + "map.create{path = d, width = 5, height = 5, type = 'u12'}", "u8, u16 and f32");
    EXPECT_FAULT(ScriptStage(), begin + "map.create{path = d, width = 5, height = 5, channels = 3}",
                 "1 channels, not 3");
    EXPECT_FAULT(ScriptStage(), begin + "map.create{path = d, width = 5, height = 5, colour = 3}",
                 "no option is called colour");
    EXPECT_FAULT(ScriptStage(), begin + "map.create{path = d, width = 5, height = 5, value = 0/0}", "finite");
    EXPECT_FAULT(ScriptStage(), begin + "map.create{path = 'height', width = 5, height = 5, type = 'u8'}", "8 bits");
    EXPECT_FAULT(ScriptStage(), begin + "map.fill(d, function() return 1/0 end)", "finite number");
    EXPECT_FAULT(ScriptStage(), begin + "map.fill(d, function() end)", "finite number");
    EXPECT_FAULT(ScriptStage(), begin + "map.noise(d, {scale = 0})", "scale must lie");
    EXPECT_FAULT(ScriptStage(), begin + "map.noise(d, {scale = 1, octaves = 99})", "octaves");
    EXPECT_FAULT(ScriptStage(), begin + "map.noise(d, {scale = 1, mode = 'mix'})", "add, multiply and set");
    EXPECT_FAULT(ScriptStage(), begin + "map.blur(d, -1)", "radius");
    EXPECT_FAULT(ScriptStage(), begin + "map.curve(d, {})", "a point");
    EXPECT_FAULT(ScriptStage(), begin + "map.curve(d, {{0, 0/0}})", "finite");
    EXPECT_FAULT(ScriptStage(), begin + "map.disc(d, {x = 1, z = 1})", "radius is missing");
    EXPECT_FAULT(ScriptStage(), begin + "map.polygon(d, {points = {{1, 1}}})", "at least 3");
    EXPECT_FAULT(ScriptStage(), begin + "map.disc(d, {x = 1, z = 1, radius = 1, mode = 'xor'})", "set, add, multiply");
    EXPECT_FAULT(ScriptStage(), begin + "map.disc(d, {x = 1, z = 1, radius = 1, value = {1, 2}})", "a table of 1");
    EXPECT_FAULT(ScriptStage(), begin + "map.noise(d, {scale = 1, channels = {2}})",
                 "channels must be numbers from 1 to 1");
    EXPECT_FAULT(ScriptStage(), begin + "map.mean(d, 2)", "channels 1 to 1");
    EXPECT_FAULT(ScriptStage(), begin + "map.at('vegetation', 1, 1)", "there is no map");
}

}  // namespace
}  // namespace sward
