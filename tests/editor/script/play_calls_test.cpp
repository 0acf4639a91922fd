// play.* as scripts see it; tests/scripts/play.lua walks through a sample project.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "editor/script/script_stage.h"
#include "playtest/playtest.h"

namespace sward {
namespace {

using test::ScriptStage;

TEST(ScriptPlay, StartsStepsHashesAndStops) {
    ScriptStage r;
    EXPECT_EQ(r.fault(R"(
        project.new()
        play.start { at = { 20, 20 }, time = 100 }
        expect.equal(play.state().tick, 6000)
        play.input { move = { x = 0, y = 1 }, look = { 90, -5 } }
        play.step(60)
        local s, hash = play.state(), play.hash()
        expect.less(20.5, s.walker.x)
        expect.near(s.walker.z, 20, 1e-9)
        expect.near(s.walker.yaw, 90, 1e-9)
        expect.near(s.time, 101, 1e-9)
        expect.equal(#s.contacts, 1)
        expect.equal(#hash, 16)
        play.pause(true)
        expect.truthy(play.state().paused)
        play.step()
        expect.truthy(play.hash() ~= hash)
        play.stop()
        expect.equal(play.state(), nil)
        play.stop()
        play.start { at = { 20, 20 }, time = 100 }
        play.input { move = { 0, 1 }, look = { 90, -5 } }
        for i = 1, 60 do play.step() end
        expect.equal(play.hash(), hash, "one by one as all at once"))"),
              "");
    EXPECT_NE(r.doc.play(), nullptr);
}

TEST(ScriptPlay, CallsThatMakeNoSenseAreRefused) {
    ScriptStage r;
    EXPECT_FAULT(r, "play.start()", "no project is open");
    EXPECT_FAULT(r, "project.new() play.step()", "nothing is played");
    EXPECT_FAULT(r, "project.new() play.start() play.start()", "play.stop()");
    r.doc.stopPlay();
    EXPECT_FAULT(r, "project.new() play.start() play.step(0.5)", "whole number");
    r.doc.stopPlay();
    EXPECT_FAULT(r, "project.new() play.start() play.input { move = { 0, 0 / 0 } }", "move must be {x, y}");
    r.doc.stopPlay();
    EXPECT_FAULT(r, "project.new() play.start() play.input { turn = 3 }", "no option is called turn");
    r.doc.stopPlay();
    EXPECT_FAULT(r, "project.new() play.start() play.input { look = 3 }", "look must be {yaw, pitch}");
    r.doc.stopPlay();
    EXPECT_FAULT(r, "project.new() play.start { at = { 1 } }", "at must be {x, z}");
    for (const char* off : {"{ 500, -500 }", "{ -0.1, 20 }", "{ 20, 40.1 }"})
        EXPECT_FAULT(r, fmt::format("project.new() play.start {{ at = {} }}", off),
                     "x goes from 0 to 40, z from 0 to 40");
    for (const char* on : {"{ 0, 0 }", "{ 40, 40 }"})
        EXPECT_EQ(r.fault(fmt::format("project.new() play.start {{ at = {} }} play.stop()", on)), "");
    EXPECT_FAULT(r,
                 "project.new() entity.remove('ground') entity.add('ground', {Terrain = {}, Transform = {position = "
                 "{100, 0, 200}}}) play.start { at = { 20, 20 } }",
                 "x goes from 100 to 140, z from 200 to 240");
    r.host.limits.instructions /= 100;  // steps until then take seconds
    EXPECT_FAULT(r, "project.new() play.start() while true do play.step(100000) end", "instructions");
}

TEST(ScriptPlay, WhileItIsPlayedEveryChangeSaysWhyNot) {
    ScriptStage r;
    ASSERT_EQ(r.fault("project.new() entity.set('sun.Light.elevationDeg', 10) play.start()"), "");
    for (const char* call :
         {"project.save()", "project.new()", "project.saveAs('q')", "edit.undo()", "edit.redo()", "entity.add('x', {})",
          "entity.remove('sun')", "entity.set('sun.Light.elevationDeg', 1)", "map.fill('density', 0)",
          "brush.select{map = 'density', radius = 2} brush.stroke{{1, 1}}"})
        EXPECT_FAULT(r, call, "play.stop()");
    r.doc.stopPlay();
    EXPECT_EQ(r.fault("expect.truthy(edit.undo())"), "");
}

}  // namespace
}  // namespace sward
