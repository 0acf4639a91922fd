// map.* of docs/scripting.md that make, read, fill, import and export maps.
#include "editor/script/script_stage.h"

namespace sward {
namespace {

using test::ScriptStage;

TEST(MapCalls, MapsAreCreatedFilledAndRead) {
    EXPECT_RUNS(R"(
        project.new()
        local density = 'lawn.GrassField.species[lawn].density'
        map.create{path = density, width = 40, height = 20, type = 'u16', value = 0.25}
        expect.near(map.mean('density'), 0.25, 1e-5)
        local w, h, c, t = map.size('density')
        expect.equal({w, h, c, t}, {40, 20, 1, 'u16'})
        map.fill('density', function(x, z) return x / 40 end)     -- metres: the ground has 40
        expect.near(map.at('density', 20, 5), 0.5, 1e-4)
        expect.near(map.mean(density), 0.5, 1e-4)
        map.fill('density', 1)
        expect.equal(map.mean('density'), 1)
        expect.truthy(not map.exists('vegetation'))
        map.create{path = 'vegetation', width = 8, height = 8, type = 'u8', value = {0.2, 0.4, 0.6, 1}}
        expect.truthy(map.exists('vegetation'))
        local r, g, b, a = map.at('vegetation', 3, 3)
        expect.near(g, 0.4, 0.003)
        expect.near(map.mean('vegetation', 3), 0.6, 0.003)
        map.fill('vegetation', function(x, z) return 0, 1, x / 40, 1 end)
        expect.near(map.mean('vegetation', 3), 0.5, 0.01)
        expect.equal(#map.hash('density'), 16)
        map.create{path = 'height', width = 4, height = 4, value = -3.5}
        expect.equal(map.mean('height'), -3.5)
        edit.undo()
        expect.truthy(not map.exists('height')))");
}

TEST(MapCalls, HeightsOfSixteenBitsAreMetres) {
    EXPECT_RUNS(R"(
        project.new()
        entity.set('ground.Terrain.heightRange', {-2, 6})
        map.create{path = 'height', width = 64, height = 64, type = 'u16'}
        expect.near(map.at('height', 3, 3), 0, 1e-4)
        map.fill('height', 4)
        expect.near(map.mean('height'), 4, 1e-4)
        map.disc('height', {x = 10, z = 10, radius = 4, mode = 'add', value = 1.5})
        expect.near(map.at('height', 10, 10), 5.5, 1e-3)
        expect.near(map.at('height', 30, 30), 4, 1e-4)
        map.noise('height', {scale = 5, amount = 0.25, seed = 3, mode = 'set'})
        expect.less(map.mean('height'), 0.25)
        expect.less(0, map.mean('height'))
        map.curve('height', {{0, -1}, {0.25, 3}})
        expect.less(-1.001, map.at('height', 12, 12))
        map.fill('height', function(x, z) return x / 10 end)
        expect.near(map.at('height', 25, 5), 2.5, 0.01)
        map.fill('height', 99)                                  -- beyond the range: cut
        expect.near(map.mean('height'), 6, 1e-4)
        local w, h, c, t = map.size('height')
        expect.equal(t, 'u16'))");
}

// What a call leaves as it was keeps its bits, however narrow the range is beside its own height.
TEST(MapCalls, HeightsThatAreNotTouchedKeepTheirBits) {
    EXPECT_RUNS(R"(
        project.new()
        entity.set('ground.Terrain.heightRange', {0, 1})
        map.create{path = 'height', width = 300, height = 300, type = 'u16'}
        map.noise('height', {scale = 9, amount = 1, seed = 1, mode = 'set'})
        entity.set('ground.Terrain.heightRange', {8000, 8001})
        local before = map.hash('height')
        map.disc('height', {x = 20, z = 20, radius = 0, value = 8000.5})
        expect.equal(map.hash('height'), before))");
}

TEST(MapCalls, MapHashFollowsTheTexels) {
    EXPECT_RUNS(R"(
        project.new()
        local before = map.hash('density')
        brush.select{map = 'density', mode = 'subtract', radius = 2}
        brush.stroke{{10, 10}, {12, 14}}
        local after = map.hash('density')
        expect.truthy(before ~= after)
        edit.undo() expect.equal(map.hash('density'), before)
        edit.redo() expect.equal(map.hash('density'), after)
        project.save() project.open(project.dir())
        expect.equal(map.hash('density'), after))");
}

TEST(MapCalls, AFunctionThatFailsHalfWayLeavesTheMapAsItWas) {
    EXPECT_RUNS(R"(
        project.new()
        local before = map.hash('density')
        local n = 0
        expect.truthy(not pcall(map.fill, 'density', function() n = n + 1 if n > 1000 then error('enough') end return 0 end))
        expect.equal(map.hash('density'), before)
        expect.truthy(not edit.undo()))");
}

TEST(MapCalls, MapsAreExportedAndImported) {
    ScriptStage r;
    EXPECT_EQ(r.fault(R"(
        project.new()
        map.fill('density', function(x, z) return z / 40 end)
        local hash = map.hash('density')
        map.export('density', 'out.png')
        map.fill('density', 0)
        map.import('density', 'out.png')
        expect.equal(map.hash('density'), hash)
        map.import('density', 'out.png', {flip = true})
        expect.near(map.at('density', 20, 10), 0.75, 0.01)
        edit.undo()
        expect.equal(map.hash('density'), hash)
        map.create{path = 'height', width = 16, height = 16, type = 'u16', value = 5}
        map.export('height', 'h.png')
        map.import('height', 'h.png', {range = {-2, 6}})
        expect.equal(entity.get('ground.Terrain.heightRange'), {-2, 6})
        edit.undo()
        expect.equal(entity.get('ground.Terrain.heightRange'), {0, 10}))"),
              "");
    EXPECT_FAULT(r, "map.import('density', 'missing.png')", "missing.png");
    test::writeText(r.dir / "no.png", "no image");
    EXPECT_FAULT(r, "map.import('density', 'no.png')", "no.png");
}

TEST(MapCalls, HeightsOfBladesAreMadeByBlurringTheDensity) {
    EXPECT_RUNS(R"(
        project.new()
        map.fill("density", 0)
        map.rect("density", {x0 = 10, z0 = 10, x1 = 30, z1 = 30})
        map.copy("bladeHeight", "density")
        map.blur("bladeHeight", 3)
        expect.equal(map.at("bladeHeight", 20, 20), 1)
        local edge = map.at("bladeHeight", 10, 20)
        expect.less(edge, 0.6)
        expect.less(0.4, edge)
        expect.equal(map.at("bladeHeight", 2, 2), 0)
        map.export("density", "both.png", {packed = true})
        local density, height = map.hash("density"), map.hash("bladeHeight")
        map.fill("density", 1)
        entity.set("lawn.GrassField.bladeHeight", nil)
        map.import("density", "both.png", {packed = true})
        expect.equal(map.hash("density"), density)
        expect.equal(map.hash("bladeHeight"), height)
        edit.undo()
        expect.equal(map.mean("density"), 1)
        expect.equal(map.exists("bladeHeight"), false))");
    EXPECT_FAULT(ScriptStage(), "project.new()\nmap.copy('orientation', 'density')", "channels");
    EXPECT_FAULT(ScriptStage(), "project.new()\nmap.export('density', 'a.png', {packed = true, range = {0, 1}})",
                 "range");
}

}  // namespace
}  // namespace sward
