// brush.* of docs/scripting.md, by the kind of map.
#include "editor/script/script_stage.h"

namespace sward {
namespace {

using test::ScriptStage;

TEST(BrushCalls, BrushesPaintOneUndoStepAStroke) {
    EXPECT_RUNS(R"(
        project.new()
        brush.select{map = 'density', mode = 'set', radius = 3, value = 0.5, falloff = 0}
        brush.stroke{{20, 20}, {30, 20}}
        expect.near(map.at('density', 25, 20), 0.5, 1e-4)
        expect.equal(map.at('density', 25, 30), 1)
        brush.select{mode = 'subtract', radius = 1, strength = 0.25}
        brush.stroke{{10, 10}}
        expect.near(map.at('density', 10, 10), 0.75, 0.01)
        expect.truthy(edit.undo()) expect.truthy(edit.undo()) expect.truthy(not edit.undo())
        expect.equal(map.mean('density'), 1)
        expect.truthy(edit.redo())
        brush.select{mode = 'noise', radius = 5, seed = 3} brush.stroke{{20, 20}}
        brush.select{mode = 'smooth', radius = 5} brush.stroke{{20, 20}, {20, 20}}
        brush.select{mode = 'add', radius = 50} brush.stroke{{20, 20}}
        expect.equal(map.mean('density'), 1))");
    EXPECT_FAULT(ScriptStage(), "project.new() brush.stroke{}", "must have a point");
    EXPECT_FAULT(ScriptStage(), "project.new() brush.stroke{{1, 0/0}}", "point 1");
    EXPECT_FAULT(ScriptStage(), "brush.select{mode = 'spray'}", "add, subtract, set, smooth, noise");
    EXPECT_FAULT(ScriptStage(), "brush.select{radius = -1}", "radius");
    EXPECT_FAULT(ScriptStage(), "brush.select{radius = 0}", "above 0");
    EXPECT_FAULT(ScriptStage(), "project.new() brush.select{map = 'nope'}", "\"nope\"");
    EXPECT_FAULT(ScriptStage(), "brush.select{size = 1}", "no option is called size");
    EXPECT_FAULT(ScriptStage(), "project.new() brush.select{map = 'vegetation'} brush.stroke{{1, 1}}",
                 "no map to paint on");
}

TEST(BrushCalls, AStrokeOnAMapThatRepeatsFallsIntoItsOneRepeat) {
    EXPECT_RUNS(R"(
        project.new()
        entity.set("ground.Terrain.size", {40, 40})
        entity.set("lawn.GrassField.species[lawn].densityTiling", 4)
        map.create{path = "density", width = 100, height = 100, value = 0}
        brush.select{map = "density", mode = "set", radius = 1, strength = 1, value = 1, falloff = 0}
        brush.stroke{{30, 25}}
        for _, at in ipairs{{0, 5}, {10, 15}, {30, 25}, {40, 35}, {29.5, 25}, {9.5, 5}} do
            expect.equal(map.at("density", at[1], at[2]), 1, at[1] .. ", " .. at[2])
        end
        expect.equal(map.at("density", 25, 25), 0)
        local before = map.hash("density")
        edit.undo()
        expect.equal(map.mean("density"), 0)
        edit.redo()
        expect.equal(map.hash("density"), before))");
}

TEST(BrushCalls, AStrokeOnMirroredHeightsRaisesTheGroundWhereItWent) {
    EXPECT_RUNS(R"(
        project.new()
        entity.set("ground.Terrain.size", {40, 40})
        entity.set("ground.Terrain.heightTiling", 4)
        map.create{path = "height", width = 100, height = 100, value = 0}
        brush.select{map = "height", mode = "set", radius = 1, strength = 1, value = 2, falloff = 0}
        brush.stroke{{13, 5}}
        for _, x in ipairs{7, 13, 27, 33} do expect.near(map.at("height", x, 5), 2, 1e-5) end
        expect.equal(map.at("height", 3, 5), 0)
        brush.stroke{{10, 5}}
        expect.near(map.at("height", 10.4, 5), 2, 1e-5)
        expect.near(map.at("height", 9.6, 5), 2, 1e-5))");
}

TEST(BrushCalls, HeightsAreSculptedInMetres) {
    EXPECT_RUNS(R"(
        project.new()
        local function at(x, z) return map.at("height", x, z) end
        brush.select{map = "height", mode = "raise", radius = 5, value = 3, falloff = 0.5}
        brush.stroke{{10, 10}}
        expect.near(at(10, 10), 3, 1e-4)
        expect.equal(at(30, 30), 0)
        local raised = map.hash("height")
        brush.select{map = "height", mode = "lower", radius = 5, value = 1, strength = 0.5}
        brush.stroke{{10, 10}}
        expect.near(at(10, 10), 2.5, 1e-4)
        edit.undo()
        expect.equal(map.hash("height"), raised)
        brush.select{map = "height", mode = "flatten", radius = 2}
        brush.stroke{{10, 10}, {20, 10}}
        expect.near(at(20, 10), 3, 1e-3)
        brush.select{map = "height", mode = "flatten", radius = 2, value = -4}
        brush.stroke{{20, 10}}
        expect.near(at(20, 10), -4, 1e-4)
        edit.undo() edit.undo()
        brush.select{map = "height", mode = "ramp", radius = 2}
        brush.stroke{{10, 10}, {30, 10}}
        expect.near(at(20, 10), 1.5, 0.02)
        for _, mode in ipairs{"noise", "smooth", "erode"} do
            local before = map.hash("height")
            brush.select{map = "height", mode = mode, radius = 8, value = 0.5, bumpSize = 3, talus = 20, water = 1, seed = 2}
            brush.stroke{{10, 10}, {14, 12}}
            expect.truthy(map.hash("height") ~= before, mode)
            edit.undo()
            expect.equal(map.hash("height"), before)
        end)");
    EXPECT_NE(
        ScriptStage().fault("brush.select{map = 'height', mode = 'erode', radius = 1, talus = 95}").find("talus angle"),
        std::string::npos);
    EXPECT_NE(ScriptStage().fault("brush.select{map = 'height', mode = 'raise', radius = 0}").find("radius"),
              std::string::npos);
}

TEST(BrushCalls, DirectionsAreCombedAndLaidTowardsAnAngle) {
    EXPECT_EQ(ScriptStage().fault(R"(
        project.new()
        map.create{path = 'orientation', width = 160, height = 160, type = 'u16', value = 0.5}
        local empty = map.hash('orientation')
        brush.select{map = 'orientation', mode = 'comb', radius = 2}
        brush.stroke{{10, 10}} expect.equal(map.hash('orientation'), empty)
        brush.stroke{{10, 10}, {30, 10}}
        local x, z = map.at('orientation', 20, 10)
        expect.near(x, 1, 1e-3) expect.near(z, 0.5, 1e-3)
        brush.select{map = 'orientation', mode = 'direction', angle = 180, strength = 0.5, radius = 2}
        brush.stroke{{20, 20}}
        x, z = map.at('orientation', 20, 20)
        expect.near(x, 0.5, 1e-3) expect.near(z, 0.75, 1e-3)
        edit.undo() edit.undo() expect.equal(map.hash('orientation'), empty))"),
              "");
    EXPECT_FAULT(ScriptStage(), "project.new() brush.select{mode = 'comb'} brush.stroke{{1, 1}, {2, 2}}",
                 "does not paint amounts");
    EXPECT_FAULT(ScriptStage(),
                 "project.new() map.create{path = 'orientation', width = 8, height = 8} brush.select{map = "
                 "'orientation'} brush.stroke{{1, 1}}",
                 "does not paint directions");
}

TEST(BrushCalls, ColoursAreLaidErasedAndSmoothed) {
    EXPECT_EQ(ScriptStage().fault(R"(
        project.new()
        for _, name in ipairs {'terrainMap', 'vegetation'} do
            map.create{path = name, width = 160, height = 160, type = 'u8', value = 0}
            local empty = map.hash(name)
            brush.select{map = name, mode = 'add', radius = 2, falloff = 0, value = 0.8, color = {0.9, 0.8, 0.1}}
            brush.stroke{{10, 10}, {30, 10}}
            local r, g, b, a = map.at(name, 20, 10)
            expect.near(r, 0.9, 0.01) expect.near(g, 0.8, 0.01) expect.near(b, 0.1, 0.01) expect.near(a, 0.8, 0.01)
            brush.select{map = name, mode = 'smooth', radius = 4}
            brush.stroke{{20, 12}}
            r, g, b, a = map.at(name, 20, 12)
            expect.near(r, 0.9, 0.01) expect.less(0.1, a) expect.less(a, 0.7)
            brush.select{map = name, mode = 'subtract', radius = 5}
            brush.stroke{{20, 10}}
            r, g, b, a = map.at(name, 20, 10)
            expect.near(r, 0.9, 0.01) expect.equal(a, 0)
            for i = 1, 3 do expect.truthy(edit.undo()) end
            expect.equal(map.hash(name), empty)
        end)"),
              "");
    const std::string begin = "project.new() map.create{path = 'vegetation', width = 8, height = 8} ";
    EXPECT_FAULT(ScriptStage(), begin + "brush.select{map = 'vegetation', mode = 'comb'} brush.stroke{{1, 1}, {2, 2}}",
                 "use add, subtract, set, smooth or noise");
    EXPECT_FAULT(ScriptStage(), "brush.select{color = {0.5, 0.5}}", "three numbers");
    EXPECT_FAULT(ScriptStage(), "brush.select{color = {0.5, 0.5, 2}}", "three numbers");
    EXPECT_FAULT(ScriptStage(), "brush.select{color = {0.5, 0.5, -0.5}}", "not between 0 and 1");
}

TEST(BrushCalls, ForcesArePressedAlongTheStrokeAndLiftedAgain) {
    EXPECT_EQ(ScriptStage().fault(R"(
        project.new()
        map.create{path = 'forces', width = 160, height = 160, value = {0.5, 0.5, 0, 0}}
        local empty = map.hash('forces')
        brush.select{map = 'forces', mode = 'press', radius = 2}
        brush.stroke{{10, 10}, {30, 10}}
        local x, z, press, share = map.at('forces', 20, 10)
        expect.near(x, 1, 1e-2) expect.near(z, 0.5, 1e-2) expect.near(press, 1, 1e-2) expect.near(share, 1, 1e-2)
        brush.select{map = 'forces', mode = 'subtract', strength = 1, radius = 3}
        brush.stroke{{20, 10}}
        x, z, press, share = map.at('forces', 20, 10)
        expect.equal(share, 0)
        edit.undo() edit.undo() expect.equal(map.hash('forces'), empty)
        brush.select{map = 'forces', mode = 'press', radius = 3, strength = 0.5}  -- a click pushes apart
        brush.stroke{{20, 20}}
        x, z, press, share = map.at('forces', 21, 20)
        expect.less(0.8, x) expect.near(z, 0.5, 0.1) expect.near(share, 0.5, 0.02)
        x = map.at('forces', 19, 20) expect.less(x, 0.2)
        edit.undo() expect.equal(map.hash('forces'), empty))"),
              "");
    EXPECT_FAULT(ScriptStage(),
                 "project.new() map.create{path = 'forces', width = 8, height = 8} brush.select{map = 'forces', mode = "
                 "'comb'} brush.stroke{{1, 1}, {2, 2}}",
                 "does not paint forces");
    EXPECT_FAULT(ScriptStage(), "project.new() brush.select{map = 'forces', mode = 'press'} brush.stroke{{1, 1}}",
                 "no map to paint on");
}

TEST(BrushCalls, EraseTakesEverySpeciesInOneStep) {
    EXPECT_EQ(ScriptStage().fault(R"(
        project.new()
        entity.set('lawn.GrassField.species', {{name = 'lawn'}, {name = 'clover'}})
        map.create{path = 'species[lawn].density', width = 64, height = 64, value = 1}
        brush.select{map = 'species[lawn].density', radius = 3, falloff = 0}
        brush.erase{{20, 20}, {24, 20}}
        for _, name in ipairs{'lawn', 'clover'} do
            expect.near(map.at('species[' .. name .. '].density', 22, 20), 0, 1e-3)
            expect.near(map.at('species[' .. name .. '].density', 5, 5), 1, 1e-3)
        end
        edit.undo()
        expect.truthy(not map.exists('lawn.GrassField.species[clover].density'))
        expect.near(map.at('species[lawn].density', 22, 20), 1, 1e-3)
        entity.remove('lawn'))"),
              "");
    EXPECT_FAULT(ScriptStage(), "project.new() entity.remove('lawn') brush.erase{{1, 1}}", "no grass to erase");
}

TEST(BrushCalls, ShapesImprintMirrorAndSeveralMaps) {
    EXPECT_RUNS(R"(
        project.new()
        brush.select{map = 'density', mode = 'subtract', radius = 4, shape = 'square'}
        brush.stroke{{10, 10}}
        expect.near(map.at('density', 13.5, 13.5), 0, 1e-4)
        expect.equal(map.at('density', 15, 10), 1)
        brush.select{map = 'height', mode = 'imprint', radius = 4, value = 3, shape = 'square', mirror = 'xz'}
        brush.stroke{{10, 10}}
        for _, x in ipairs{10, 30} do for _, z in ipairs{10, 30} do
            expect.near(map.at('height', x, z), 3, 1e-4)
        end end
        expect.equal(map.at('height', 20, 20), 0)
        brush.select{map = 'height', mode = 'imprint', radius = 4, value = 3, shape = 'square', blend = 'maximum',
            base = 1, falloff = 0}
        brush.stroke{{10, 10}}
        expect.near(map.at('height', 10, 10), 4, 1e-4)
        map.create{path = 'vegetation', width = 64, height = 64, value = 0}
        map.create{path = 'terrainMap', width = 64, height = 64, value = 0}
        brush.select{map = {'vegetation', 'terrainMap'}, mode = 'add', radius = 5, color = {1, 0, 0}}
        brush.stroke{{20, 20}}
        expect.near(map.at('vegetation', 20, 20, 4), 1, 0.02)
        expect.near(map.at('terrainMap', 20, 20, 4), 1, 0.02)
        edit.undo()
        expect.equal(map.at('vegetation', 20, 20, 4), 0)
        expect.equal(map.at('terrainMap', 20, 20, 4), 0)
        brush.select{mode = 'add', radius = 3, shape = 'cracks', shapeTurn = 'random', shapeAngle = 30})");
    EXPECT_FAULT(ScriptStage(), "brush.select{shape = 'nowhere.png'}", "nowhere.png");
    EXPECT_FAULT(ScriptStage(), "brush.select{shapeTurn = 'left'}", "\"fixed\", \"random\", \"along\"");
    EXPECT_FAULT(ScriptStage(), "brush.select{mirror = 'y'}", "mirror");
    EXPECT_FAULT(ScriptStage(), "brush.select{blend = 'times'}", "\"replace\"");
    EXPECT_FAULT(ScriptStage(), "brush.select{map = {1}}", "must name maps");
    EXPECT_FAULT(ScriptStage(), "brush.select{shape = '/etc/passwd'}", "own folder");
}

}  // namespace
}  // namespace sward
