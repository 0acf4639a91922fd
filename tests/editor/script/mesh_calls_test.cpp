// mesh.* of docs/scripting.md.
#include "editor/script/script_stage.h"
#include "mesh/mesh_io.h"

namespace sward {
namespace {

using test::ScriptStage;

TEST(MeshCalls, MeshWriteMakesAnObjectOfSolids) {
    ScriptStage r;
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

}  // namespace
}  // namespace sward
