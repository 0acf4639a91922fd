// Exporting in the background, and from scripts.
#include "model/scene_export.h"

#include <gtest/gtest.h>

#include <thread>

#include "exchange/glb_check.h"
#include "script/script.h"
#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

Result<GlbCounts> ended(SceneExport& e) {
    while (true) {
        if (auto end = finishExport(e)) return std::move(*end);
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

struct Desk {
    test::TempDir dir;
    Document doc{tables()};
    Desk() {
        EXPECT_TRUE(doc.create(dir / "p"));
        EXPECT_TRUE(doc.setField("ground.Terrain.size", "[8, 8]"));
        EXPECT_TRUE(doc.setField("lawn.GrassField.species[0].bladesPerM2", "50"));
    }
};

TEST(SceneExport, WritesTheSceneAsItWasWhenItBegan) {
    Desk d;
    auto exporting = startExport(d.doc, {}, d.dir / "scene.glb");
    ASSERT_TRUE(exporting);
    ASSERT_TRUE(d.doc.setField("lawn.GrassField.species[0].bladesPerM2", "0"));
    const auto made = ended(*exporting);
    ASSERT_TRUE(made) << made.error().text();
    EXPECT_GT(made->blades, 1000u);
    EXPECT_EQ(*checkGlb(test::readText(d.dir / "scene.glb")), *made);
}

TEST(SceneExport, CancelledItTouchesNoFile) {
    Desk d;
    test::writeText(d.dir / "scene.glb", "older");
    auto exporting = startExport(d.doc, {}, d.dir / "scene.glb");
    ASSERT_TRUE(exporting);
    exporting->job.cancel();
    EXPECT_FALSE(ended(*exporting));
    EXPECT_EQ(test::readText(d.dir / "scene.glb"), "older");
    EXPECT_FALSE(startExport(d.doc, {}, d.dir / "scene.obj"));
}

TEST(SceneExport, ScriptsGetTheCounts) {
    Desk d;
    ScriptHost host{d.doc};
    host.folder = d.dir.path;
    offerExport(host);
    ScriptConsole console(host);
    const Status run = console.run(
        "local n = project.export('scene.glb', {within = 2}); expect.less(n.blades, 700); expect.less(100, n.blades); "
        "expect.equal(n.cameras, 1); expect.less(n.blades, project.export('all.glb').blades)");
    EXPECT_TRUE(run) << run.error().text();
    EXPECT_FALSE(console.run("project.export('scene.gltf')"));
    EXPECT_FALSE(console.run("project.export('/nowhere/scene.glb')")) << "outside of its folders";
}

}  // namespace
}  // namespace sward
