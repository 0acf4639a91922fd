// project.* of docs/scripting.md.
#include "editor/script/script_stage.h"

namespace sward {
namespace {

using test::ScriptStage;

TEST(ProjectCalls, ProjectsAreMadeSavedReopenedAndCopied) {
    ScriptStage r;
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

TEST(ProjectCalls, TemporaryFoldersGoEvenIfTheScriptFails) {
    ScriptStage r;
    EXPECT_NE(r.fault("project.new() print(project.dir()) error('x')"), "");
    ASSERT_EQ(r.printed.size(), 1u);
    EXPECT_FALSE(std::filesystem::exists(r.printed[0]));
}

}  // namespace
}  // namespace sward
