// entity.* of docs/scripting.md.
#include "editor/script/script_stage.h"

namespace sward {
namespace {

using test::ScriptStage;

TEST(EntityCalls, EntitiesAreAddedReadSetAndRemoved) {
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

TEST(EntityCalls, AnEntityThatCannotBeWhollyAddedIsNotAddedAtAll) {
    ScriptStage r;
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

TEST(EntityCalls, UnknownPathsSayWhatThereIs) {
    EXPECT_FAULT(ScriptStage(), "project.new() entity.get('camera.Camera.zoom')", "eye, target, fovDeg");
    EXPECT_FAULT(ScriptStage(), "project.new() entity.get('nobody.Camera.eye')", "camera, ground");
    EXPECT_FAULT(ScriptStage(), "project.new() map.mean('nonsense')", "lawn.GrassField.species[lawn].density");
    EXPECT_FAULT(ScriptStage(), "entity.list()", "no project is open");
}

}  // namespace
}  // namespace sward
