// edit.* and camera.* of docs/scripting.md.
#include "editor/script/script_stage.h"

namespace sward {
namespace {

using test::ScriptStage;

TEST(EditCalls, CameraUseTellsTheHost) {
    ScriptStage r;
    std::string shown;
    r.host.useCamera = [&](const std::string& name) { shown = name; };
    EXPECT_EQ(r.fault("project.new() camera.use('camera')"), "");
    EXPECT_EQ(shown, "camera");
    EXPECT_EQ(r.host.camera, "camera");
    EXPECT_FAULT(r, "camera.use('ground')", "no camera");
}

TEST(EditCalls, UndoAndRedoSayWhetherThereWasAStep) {
    EXPECT_RUNS(R"(
        project.new()
        expect.equal(edit.undo(), false)
        entity.add('hedge')
        expect.equal(edit.undo(), true)
        expect.equal(edit.undo(), false)
        expect.equal(#entity.list(), 6)
        expect.equal(edit.redo(), true)
        expect.equal(edit.redo(), false)
        expect.equal(#entity.list(), 7))");
}

}  // namespace
}  // namespace sward
