// Every call of docs/scripting.md, run as scripts that check themselves, and how failures are told.
#include "script/script.h"

#include <gtest/gtest.h>

#include "editor/script_stage.h"
#include "mesh/mesh_io.h"

namespace sward {
namespace {

using test::Stage;
#define EXPECT_RUNS(text) EXPECT_EQ(Stage().fault(text), "")

TEST(Script, PrintGoesToTheHostLineByLine) {
    Stage r;
    ASSERT_TRUE(r.run("print('a', 1, 2.5, nil, true)\nprint()"));
    EXPECT_EQ(r.printed, (std::vector<std::string>{"a\t1\t2.5\tnil\ttrue", ""}));
}

TEST(Script, AFailureNamesFileAndLineAndEndsWithOne) {
    Stage r;
    const Status s = r.run("local x = 1\n\nexpect.equal(x, 2, 'the count')\n");
    ASSERT_FALSE(s);
    EXPECT_EQ(s.error().code, ExitCode::Failed);
    EXPECT_EQ(s.error().line, 3);
    EXPECT_EQ(s.error().text(), (r.dir / "test.lua").string() + ":3: the count: expected 1 to equal 2");
}

TEST(Script, MeshWriteMakesAnObjectOfSolids) {
    Stage r;
    EXPECT_EQ(r.fault(R"(
        expect.equal(mesh.write("models/a.glb", {{shape = "box", size = {1, 2, 3}}, {shape = "cylinder", radius = 0.5, height = 1, top = 0, sides = 4, at = {2, 0, 0}}}), 12 + 8 + 4)
        expect.equal(mesh.write("b.glb", {{shape = "leaves", size = {1, 1, 1}, count = 10, leaf = 0.2}}), 20))"),
              "");
    EXPECT_TRUE(readMesh(r.dir.path, "models/a.glb"));
    EXPECT_FAULT(r, R"(mesh.write("c.glb", {{shape = "cone"}}))", "there are box, cylinder");
    EXPECT_FAULT(r, R"(mesh.write("c.glb", {{shape = "box", size = {1, 0, 1}}}))", "size must be above 0");
    EXPECT_FAULT(r, R"(mesh.write("c.glb", {{shape = "box", color = {2, 0, 1}}}))", "between 0 and 1");
    EXPECT_FAULT(r, R"(mesh.write("c.glb", {{shape = "box", sizes = {1, 1, 1}}}))", "no option is called sizes");
    EXPECT_FAULT(r, R"(mesh.write("c.txt", {{shape = "box"}}))", ".glb");
    EXPECT_FAULT(r, R"(mesh.write("../c.glb", {{shape = "box"}}))", "c.glb");
    EXPECT_FAULT(r, R"(mesh.write("c.glb", {}))", "no shape");
}

TEST(Script, SyntaxErrorsNameFileAndLine) {
    Stage r;
    const Status s = r.run("local x = 1\nlocal = 3\n");
    ASSERT_FALSE(s);
    EXPECT_EQ(s.error().line, 2);
    EXPECT_EQ(s.error().file, (r.dir / "test.lua").string());
    EXPECT_EQ(s.error().code, ExitCode::Failed);
}

TEST(Script, CallsThatFailKeepTheirExitCode) {
    Stage r;
    Status s = r.run("project.new()\nentity.set('camera.Camera.zoom', 1)");
    ASSERT_FALSE(s);
    EXPECT_EQ(s.error().code, ExitCode::Usage);
    EXPECT_NE(s.error().text().find("fovDeg"), std::string::npos) << s.error().text();
    test::writeText(r.dir / "broken/project.json", "{");
    s = r.run("project.open('broken')");
    ASSERT_FALSE(s);
    EXPECT_EQ(s.error().code, ExitCode::Unsound);
    s = r.run("pcall(project.open, 'broken')\nerror('mine')");
    ASSERT_FALSE(s);
    EXPECT_EQ(s.error().code, ExitCode::Failed);
    EXPECT_EQ(runScript(r.dir / "missing.lua", r.host).error().code, ExitCode::Usage);
}

TEST(Script, EveryExpectationPassesAndFails) {
    EXPECT_RUNS(
        "expect.equal(1, 1.0) expect.equal('a', 'a') expect.equal({1, {b = 2}}, {1, {b = 2}}) expect.equal(nil, nil)"
        "expect.near(1, 1.05, 0.1) expect.less(1, 2) expect.truthy(0) expect.truthy('')");
    for (const char* failing : {"expect.equal(1, 2)", "expect.equal({1}, {1, 2})", "expect.equal({1, 2}, {1})",
                                "expect.equal('1', 1)", "expect.near(1, 1.2, 0.1)", "expect.near(0/0, 1, 1)",
                                "expect.less(2, 2)", "expect.truthy(nil)", "expect.truthy(false)"})
        EXPECT_FAULT(Stage(), failing, "test.lua:1: expected");
}

TEST(Script, SortedPairsVisitsNumbersThenStringsInOrder) {
    EXPECT_RUNS(R"(
        local seen = {}
        for k, v in sortedPairs({b = 1, [10] = 2, a = 3, [2] = 4, [-1.5] = 5}) do seen[#seen + 1] = tostring(k) .. v end
        expect.equal(seen, {'-1.55', '24', '102', 'a3', 'b1'})
        for k in sortedPairs({}) do error('nothing to visit') end
        expect.truthy(not pcall(sortedPairs, {[true] = 1})))");
}

TEST(Script, ProjectsAreMadeSavedReopenedAndCopied) {
    Stage r;
    EXPECT_EQ(r.fault(R"(
        project.new('made')
        expect.equal(project.name(), 'made')
        expect.truthy(not project.dirty())
        entity.set('camera.Camera.fovDeg', 70)
        expect.truthy(project.dirty())
        expect.equal(project.save(), {'project.json'})
        expect.equal(project.save(), {})
        project.saveAs('deep/er')
        expect.equal(project.name(), 'er')
        project.open('made')
        expect.equal(entity.get('camera.Camera.fovDeg'), 70)
        local copy = project.tempCopy('made')
        project.open(copy)
        entity.set('camera.Camera.fovDeg', 20)
        project.save()
        project.open('made')
        expect.equal(entity.get('camera.Camera.fovDeg'), 70)
        print(copy)
        project.new()
        print(project.dir()))"),
              "");
    ASSERT_EQ(r.printed.size(), 2u);
    for (const std::string& temporary : r.printed) EXPECT_FALSE(std::filesystem::exists(temporary)) << temporary;
    EXPECT_TRUE(std::filesystem::exists(r.dir / "deep/er/project.json"));
}

TEST(Script, TemporaryFoldersGoEvenIfTheScriptFails) {
    Stage r;
    EXPECT_NE(r.fault("project.new() print(project.dir()) error('x')"), "");
    ASSERT_EQ(r.printed.size(), 1u);
    EXPECT_FALSE(std::filesystem::exists(r.printed[0]));
}

TEST(Script, EntitiesAreAddedReadSetAndRemoved) {
    EXPECT_RUNS(R"(
        project.new()
        expect.equal(entity.list(), {'camera', 'ground', 'haze', 'lawn', 'sky', 'sun'})
        expect.equal(entity.list('Camera'), {'camera'})
        entity.add('empty')
        expect.equal(entity.get('empty'), {})
        entity.add('meadow', {Transform = {position = {1, 2, 3}}, GrassField = {
            technique = 'flat', maxGeom = math.huge, seed = 7,
            species = {{name = 'a', height = 0.25, segments = 4}, {name = 'b', rootColor = {0.1, 0.2, 0.3}}, {name = 'c'}}}})
        expect.equal(entity.get('meadow.Transform.position'), {1, 2, 3})
        expect.equal(entity.get('meadow.Transform'), {position = {1, 2, 3}})
        expect.equal(entity.get('meadow').GrassField.technique, 'flat')
        expect.equal(entity.get('meadow.GrassField.maxGeom'), math.huge)
        expect.equal(entity.get('meadow.GrassField.seed'), 7)
        expect.equal(#entity.get('meadow.GrassField.species'), 3)
        expect.equal(entity.get('meadow.GrassField.species[a].height'), 0.25)
        expect.equal(entity.get('meadow.GrassField.species[1].rootColor'), {0.1, 0.2, 0.3})
        expect.equal(entity.get('meadow.GrassField.species[b].density'), nil)
        entity.set('meadow.GrassField.species', {{name = 'only'}})
        expect.equal(#entity.get('meadow.GrassField.species'), 1)
        entity.set('meadow.GrassField.species[only].height', '0.5')
        expect.equal(entity.get('meadow.GrassField.species[0].height'), 0.5)
        entity.set('empty.Camera', {eye = {1, 2, 3}, fovDeg = 40})
        expect.equal(entity.get('empty.Camera.fovDeg'), 40)
        entity.remove('meadow')
        expect.equal(entity.list('GrassField'), {'lawn'})
        edit.undo()
        expect.equal(entity.get('meadow.GrassField.species[only].height'), 0.5))");
}

TEST(Script, AnEntityThatCannotBeWhollyAddedIsNotAddedAtAll) {
    Stage r;
    EXPECT_EQ(r.fault(R"(
        project.new()
        for _, parts in ipairs{{GrassField = {technique = 'magic'}}, {Camera = {fovDeg = 1e9}}, {Camera = {zoom = 1}}, {Rocket = {}},
                               {GrassField = {species = {{name = 'x', height = 'tall'}}}}, {Camera = {eye = {1, 2}}}, {Camera = 5}} do
            local done, why = pcall(entity.add, 'new', parts)
            expect.truthy(not done)
            print(why)
        end
        expect.equal(#entity.list(), 6)
        expect.truthy(not edit.undo())
        expect.truthy(not project.dirty()))"),
              "");
    ASSERT_EQ(r.printed.size(), 7u);
    EXPECT_NE(r.printed[0].find("hybrid"), std::string::npos) << r.printed[0];
    EXPECT_NE(r.printed[2].find("fovDeg"), std::string::npos) << r.printed[2];
}

TEST(Script, UnknownPathsSayWhatThereIs) {
    EXPECT_FAULT(Stage(), "project.new() entity.get('camera.Camera.zoom')", "eye, target, fovDeg");
    EXPECT_FAULT(Stage(), "project.new() entity.get('nobody.Camera.eye')", "camera, ground");
    EXPECT_FAULT(Stage(), "project.new() map.mean('nonsense')", "lawn.GrassField.species[lawn].density");
    EXPECT_FAULT(Stage(), "entity.list()", "no project is open");
}

TEST(Script, CameraUseTellsTheHost) {
    Stage r;
    std::string shown;
    r.host.useCamera = [&](const std::string& name) { shown = name; };
    EXPECT_EQ(r.fault("project.new() camera.use('camera')"), "");
    EXPECT_EQ(shown, "camera");
    EXPECT_EQ(r.host.camera, "camera");
    EXPECT_FAULT(r, "camera.use('ground')", "no camera");
}

TEST(Script, MapsAreCreatedFilledAndRead) {
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

TEST(Script, MapHashFollowsTheTexels) {
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

TEST(Script, WrongMapArgumentsAreRefused) {
    const std::string begin = "project.new() local d = 'density' ";
    EXPECT_FAULT(Stage(), begin + "map.create{path = d, width = 0, height = 5}", "width must be a whole number");
    EXPECT_FAULT(Stage(), begin + "map.create{path = d, width = 5.5, height = 5}", "width must be a whole number");
    EXPECT_FAULT(Stage(), begin + "map.create{path = d, width = 5}", "height is missing");
    EXPECT_FAULT(Stage(), begin + "map.create{path = d, width = 5, height = 5, type = 'u12'}", "u8, u16 and f32");
    EXPECT_FAULT(Stage(), begin + "map.create{path = d, width = 5, height = 5, channels = 3}", "1 channels, not 3");
    EXPECT_FAULT(Stage(), begin + "map.create{path = d, width = 5, height = 5, colour = 3}",
                 "no option is called colour");
    EXPECT_FAULT(Stage(), begin + "map.create{path = d, width = 5, height = 5, value = 0/0}", "finite");
    EXPECT_FAULT(Stage(), begin + "map.create{path = 'height', width = 5, height = 5, type = 'u8'}", "8 bits");
    EXPECT_FAULT(Stage(), begin + "map.fill(d, function() return 1/0 end)", "finite number");
    EXPECT_FAULT(Stage(), begin + "map.fill(d, function() end)", "finite number");
    EXPECT_FAULT(Stage(), begin + "map.noise(d, {scale = 0})", "scale must lie");
    EXPECT_FAULT(Stage(), begin + "map.noise(d, {scale = 1, octaves = 99})", "octaves");
    EXPECT_FAULT(Stage(), begin + "map.noise(d, {scale = 1, mode = 'mix'})", "add, multiply and set");
    EXPECT_FAULT(Stage(), begin + "map.blur(d, -1)", "radius");
    EXPECT_FAULT(Stage(), begin + "map.curve(d, {})", "a point");
    EXPECT_FAULT(Stage(), begin + "map.curve(d, {{0, 0/0}})", "finite");
    EXPECT_FAULT(Stage(), begin + "map.disc(d, {x = 1, z = 1})", "radius is missing");
    EXPECT_FAULT(Stage(), begin + "map.polygon(d, {points = {{1, 1}}})", "at least 3");
    EXPECT_FAULT(Stage(), begin + "map.disc(d, {x = 1, z = 1, radius = 1, mode = 'xor'})", "set, add, multiply");
    EXPECT_FAULT(Stage(), begin + "map.disc(d, {x = 1, z = 1, radius = 1, value = {1, 2}})", "a table of 1");
    EXPECT_FAULT(Stage(), begin + "map.noise(d, {scale = 1, channels = {2}})", "channels must be numbers from 1 to 1");
    EXPECT_FAULT(Stage(), begin + "map.mean(d, 2)", "channels 1 to 1");
    EXPECT_FAULT(Stage(), begin + "map.at('vegetation', 1, 1)", "there is no map");
}

TEST(Script, AFunctionThatFailsHalfWayLeavesTheMapAsItWas) {
    EXPECT_RUNS(R"(
        project.new()
        local before = map.hash('density')
        local n = 0
        expect.truthy(not pcall(map.fill, 'density', function() n = n + 1 if n > 1000 then error('enough') end return 0 end))
        expect.equal(map.hash('density'), before)
        expect.truthy(not edit.undo()))");
}

TEST(Script, MapsAreExportedAndImported) {
    Stage r;
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
        map.create{path = 'height', width = 16, height = 16, type = 'u16', value = 0.5}
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

TEST(Script, BrushesPaintOneUndoStepAStroke) {
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
    EXPECT_FAULT(Stage(), "project.new() brush.stroke{}", "must have a point");
    EXPECT_FAULT(Stage(), "project.new() brush.stroke{{1, 0/0}}", "point 1");
    EXPECT_FAULT(Stage(), "brush.select{mode = 'spray'}", "add, subtract, set, smooth, noise");
    EXPECT_FAULT(Stage(), "brush.select{radius = -1}", "radius");
    EXPECT_FAULT(Stage(), "brush.select{radius = 0}", "above 0");
    EXPECT_FAULT(Stage(), "project.new() brush.select{map = 'nope'}", "\"nope\"");
    EXPECT_FAULT(Stage(), "brush.select{size = 1}", "no option is called size");
    EXPECT_FAULT(Stage(), "project.new() brush.select{map = 'vegetation'} brush.stroke{{1, 1}}", "no map to paint on");
}

// --- the user interface, as far as scripts see it ------------------------------------------------------------------

struct RecordingUi : UiDriver {
    std::vector<std::string> calls;
    Status click(const std::string& label) override { return note("click " + label); }
    Status set(const std::string& label, const std::string& text) override { return note("set " + label + " " + text); }
    Result<std::string> get(const std::string& label) override {
        if (label == "Brush/Radius") return std::string("2.5");
        return failed("no widget " + label);
    }
    bool exists(const std::string& label) override { return label == "Brush/Radius"; }
    Status key(const std::string& chord) override { return note("key " + chord); }
    Result<std::array<double, 4>> rect(const std::string& label) override {
        if (label == "Brush/Radius") return std::array<double, 4>{10, 20, 30.5, 40};
        return failed("no widget " + label);
    }
    Status drag(double x1, double y1, double x2, double y2, const std::string& held) override {
        return note(fmt::format("drag {} {} {} {}{}{}", x1, y1, x2, y2, held.empty() ? "" : " ", held));
    }
    Status wait(int frames) override { return note(fmt::format("wait {}", frames)); }
    Status screenshot(const std::filesystem::path& file) override {
        return note("screenshot " + file.filename().string());
    }
    Status note(const std::string& call) {
        calls.push_back(call);
        return {};
    }
};

TEST(Script, UiCallsReachTheDriver) {
    Stage r;
    RecordingUi ui;
    r.host.ui = &ui;
    EXPECT_EQ(r.fault(R"(
        ui.click('Menu/File/Save') ui.set('Brush/Radius', 3) ui.set('Brush/Mode', 'add') ui.key('ctrl+z')
        ui.drag(1, 2, 3.5, 4) ui.drag(1, 2, 3, 4, 'ctrl+shift') ui.wait(5) ui.wait() ui.screenshot('shot.png')
        expect.equal(ui.get('Brush/Radius'), '2.5')
        expect.equal({ui.rect('Brush/Radius')}, {10, 20, 30.5, 40})
        expect.truthy(ui.exists('Brush/Radius')) expect.truthy(not ui.exists('Brush/Smell')))"),
              "");
    EXPECT_EQ(ui.calls, (std::vector<std::string>{"click Menu/File/Save", "set Brush/Radius 3", "set Brush/Mode add",
                                                  "key ctrl+z", "drag 1 2 3.5 4", "drag 1 2 3 4 ctrl+shift", "wait 5",
                                                  "wait 1", "screenshot shot.png"}));
    EXPECT_FAULT(r, "ui.get('Brush/Smell')", "no widget Brush/Smell");
    EXPECT_FAULT(r, "ui.rect('Brush/Smell')", "no widget Brush/Smell");
    EXPECT_FAULT(r, "ui.wait(1e9)", "frames");
    EXPECT_FAULT(r, "ui.screenshot('/shot.png')", "scripts reach only files");
}

TEST(Script, UiCallsWithoutAWindowSaySo) {
    for (const char* call : {"ui.click('x')", "ui.set('x', 1)", "ui.get('x')", "ui.exists('x')", "ui.key('a')",
                             "ui.drag(1, 2, 3, 4)", "ui.rect('x')", "ui.wait(1)", "ui.screenshot('x.png')"})
        EXPECT_FAULT(Stage(), call, "test.lua:1: ui.* needs the editor's window");
}

TEST(ScriptConsole, KeepsItsStateAndPrintsExpressions) {
    Stage r;
    ASSERT_TRUE(r.doc.create(r.dir / "p"));
    ScriptConsole console(r.host);
    EXPECT_TRUE(console.run("x = 20"));
    EXPECT_TRUE(console.run("x + 1, 'two'"));
    EXPECT_TRUE(console.run("map.mean('density')"));
    EXPECT_TRUE(console.run("-- nothing"));
    EXPECT_EQ(r.printed, (std::vector<std::string>{"21\ttwo", "1.0"}));
    const Status s = console.run("nonsense(");
    ASSERT_FALSE(s);
    const Status t = console.run("expect.equal(1, 2)");
    ASSERT_FALSE(t);
    EXPECT_EQ(t.error().text(), "console:1: expected 1 to equal 2");
    EXPECT_TRUE(console.run("x"));
    EXPECT_EQ(r.printed.back(), "20");
}

TEST(ScriptConsole, BoundsEachLineByItself) {
    Stage r;
    r.host.limits.instructions = 1'000'000;
    ScriptConsole console(r.host);
    EXPECT_FALSE(console.run("while true do end"));
    for (int i = 0; i < 5; ++i) EXPECT_TRUE(console.run("for i = 1, 100000 do end"));
}

TEST(Script, AStrokeOnAMapThatRepeatsFallsIntoItsOneRepeat) {
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

TEST(Script, AStrokeOnMirroredHeightsRaisesTheGroundWhereItWent) {
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

TEST(Script, MapSizeSetsTheLengthThatBrushesAndShapesCover) {
    EXPECT_RUNS(R"(
        project.new()
        entity.set("ground.Terrain.size", {90000, 90000})
        entity.set("ground.Terrain.mapSize", 20)
        map.create{path = "density", width = 200, height = 200, value = 0}
        map.disc("density", {x = 5, z = 5, radius = 2})
        expect.equal(map.at("density", 5 + 20 * 4000, 5), 1)
        expect.equal(map.at("density", 15 + 20 * 4000, 5), 0))");
}

TEST(Script, HeightsOfBladesAreMadeByBlurringTheDensity) {
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
    EXPECT_FAULT(Stage(), "project.new()\nmap.copy('orientation', 'density')", "channels");
    EXPECT_FAULT(Stage(), "project.new()\nmap.export('density', 'a.png', {packed = true, range = {0, 1}})", "range");
}

TEST(Script, AStiffnessThatIsNoneIsRefusedAndTheOldOneKept) {
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

TEST(Script, TilingsThatAreNoneAreRefused) {
    for (const char* field : {"ground.Terrain.heightTiling", "ground.Terrain.terrainMapTiling",
                              "lawn.GrassField.species[lawn].densityTiling", "lawn.GrassField.bladeHeightTiling"})
        for (const char* value : {"0", "-1", "1e9", "0/0", "-math.huge", "math.huge", "'x'"})
            EXPECT_NE(Stage().fault(fmt::format("project.new()\nentity.set('{}', {})", field, value)), "")
                << field << " = " << value;
}

}  // namespace
}  // namespace sward
