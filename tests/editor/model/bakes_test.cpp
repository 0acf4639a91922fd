// What is baked comes as one undo step, the same each time, and not at all when cancelled or stale.
#include "model/bakes.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "cli/cli.h"
#include "mesh/mesh_io.h"
#include "mesh/mesh_shapes.h"
#include "script/script.h"
#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

// A new project with a box on it; the cache in a folder of the test's own.
struct Bench {
    test::TempDir dir;
    test::EmptyCache cache;
    Document doc{tables()};
    std::string field;
    Bench() {
        EXPECT_TRUE(doc.create(dir / "p"));
        const Solid box{.size = {4, 3, 4}};
        test::writeText(dir / "p/box.glb", *encodeGlb(makeMesh({&box, 1})));
        EXPECT_TRUE(doc.addEntity("box"));
        EXPECT_TRUE(doc.addComponent("box", "StaticMesh"));
        EXPECT_TRUE(doc.setField("box.StaticMesh.file", "box.glb"));
        EXPECT_TRUE(doc.setField("box.StaticMesh.bakeLight", "local"));  // others darken the ground by themselves
        EXPECT_TRUE(doc.addComponent("box", "Transform"));
        EXPECT_TRUE(doc.setField("box.Transform.position", "[10, 0, 10]"));
        for (const auto& [name, e] : doc.project().entities)
            if (doc.project().registry.get<GrassField>(e)) field = name;
    }
    const GrassField& grass() { return *doc.project().registry.get<GrassField>(findEntity(doc.project(), field)); }
    const Map& map() { return grass().ambientOcclusion.map; }
};
const BakeProgress kGoOn = [](double) { return true; };
const BakeSettings kSmall{16, 40};

const BakeRow& rowOf(const std::string& name) {
    return *std::find_if(bakeRows().begin(), bakeRows().end(), [&](const BakeRow& r) { return r.name == name; });
}

TEST(Bakes, AmbientOcclusionIsOneUndoStepAndTheSameEachTime) {
    Bench b;
    ASSERT_TRUE(b.doc.setField(b.field + ".GrassField.ambientOcclusionTiling", "3"));
    std::vector<double> told;
    const BakeRow& row = rowOf("ambientOcclusion");
    ASSERT_TRUE(row.run(b.doc, kSmall, [&](double share) {
        told.push_back(share);
        return true;
    }));
    ASSERT_FALSE(b.map().empty());
    EXPECT_EQ(b.map().info().width, 40);
    EXPECT_EQ(b.map().at(10, 10), 0) << "under the box";
    EXPECT_EQ(b.grass().ambientOcclusionTiling, 1) << "the map is made for its place";
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_EQ(told.back(), 1);
    const uint64_t hash = b.map().hash();
    EXPECT_EQ(b.doc.undoLabel(), "bake ambient occlusion");
    EXPECT_TRUE(b.doc.undo());
    EXPECT_TRUE(b.map().empty());
    EXPECT_EQ(b.grass().ambientOcclusionTiling, 3);
    ASSERT_TRUE(row.run(b.doc, kSmall, kGoOn));
    EXPECT_EQ(b.map().hash(), hash) << "from the cache";
    std::filesystem::remove_all(b.cache.path());
    ASSERT_TRUE(row.run(b.doc, kSmall, kGoOn));
    EXPECT_EQ(b.map().hash(), hash) << "made again";
}

TEST(Bakes, CancelledOrOvertakenBakesChangeNothing) {
    Bench b;
    const BakeRow& row = rowOf("ambientOcclusion");
    const auto cancelled = row.run(b.doc, {256, 400}, [](double) { return false; });
    ASSERT_FALSE(cancelled);
    EXPECT_NE(cancelled.error().text().find("cancelled"), std::string::npos);
    EXPECT_TRUE(b.map().empty());
    auto bake = startOcclusion(b.doc, kSmall);
    ASSERT_TRUE(bake);
    ASSERT_TRUE(b.doc.setField("box.Transform.position", "[12, 0, 10]"));
    std::optional<Status> end;
    while (!(end = finishOcclusion(b.doc, *bake))) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    EXPECT_FALSE(*end) << "the box stands elsewhere by now";
    EXPECT_TRUE(b.map().empty());
}

TEST(Bakes, SettingsOutOfRangeAndScenesWithoutAFieldAreRefused) {
    Bench b;
    for (const BakeSettings& bad :
         {BakeSettings{0, 0}, BakeSettings{70000, 0}, BakeSettings{16, -1}, BakeSettings{16, 9000}})
        EXPECT_EQ(startOcclusion(b.doc, bad).error().code, ExitCode::Usage);
    ASSERT_TRUE(b.doc.removeEntity(b.field));
    EXPECT_EQ(startOcclusion(b.doc, kSmall).error().code, ExitCode::Unsound);
}

TEST(Bakes, ScriptsAndTheCommandLineBakeTheSameMap) {
    Bench b;
    ASSERT_TRUE(b.doc.save());
    ScriptHost host{b.doc};
    offerBakes(host);
    test::writeText(b.dir / "bake.lua",
                    "bake.ambientOcclusion{samples=16, size=40}\nexpect.less(map.mean('ambientOcclusion'), "
                    "1)\nexpect.truthy(not pcall(bake.ambientOcclusion, {size=1.5}))");
    const Status ran = runScript(b.dir / "bake.lua", host);
    ASSERT_TRUE(ran) << ran.error().text();
    const std::string folder = (b.dir / "p").string();
    EXPECT_EQ(bakeVerb({folder, {"ao"}, 16, 40}), 0);
    EXPECT_EQ(bakeVerb({folder, {}, 0, 0}), 2);
    EXPECT_EQ(bakeVerb({(b.dir / "none").string(), {}, 16, 0}), 3);
    Document other(tables());
    ASSERT_TRUE(other.open(folder));
    EXPECT_EQ(
        other.project().registry.get<GrassField>(findEntity(other.project(), b.field))->ambientOcclusion.map.hash(),
        b.map().hash());
}

// Ten times fewer texels than a project's own.
void smallSlices(Bench& b) {
    for (const char* set : {"sliceWidth=32", "sliceHeight=16", "farSize=32"}) {
        const std::string text = set;
        const size_t at = text.find('=');
        ASSERT_TRUE(b.doc.setField(b.field + ".GrassField." + text.substr(0, at), text.substr(at + 1)));
    }
}

TEST(Bakes, SlicesLieInTheCacheAndThoseThatAreThereAreNotMadeAgain) {
    Bench b;
    smallSlices(b);
    const auto made = rowOf("slices").run(b.doc, kSmall, kGoOn);
    ASSERT_TRUE(made) << made.error().text();
    EXPECT_NE(made->find("MB"), std::string::npos) << *made;
    EXPECT_EQ(made->find("cached"), std::string::npos) << *made;
    const std::filesystem::path folder = b.cache.path() / "sward/slices";
    const auto files = [&] {
        return std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator());
    };
    EXPECT_EQ(files(), 1);
    const auto again = rowOf("slices").run(b.doc, kSmall, kGoOn);
    ASSERT_TRUE(again);
    EXPECT_NE(again->find("cached already"), std::string::npos) << *again;
    EXPECT_EQ(files(), 1);
    ASSERT_TRUE(b.doc.setField(b.field + ".GrassField.technique", "geometry"));
    EXPECT_EQ(*rowOf("slices").run(b.doc, kSmall, kGoOn), "nothing is drawn as slices");
}

TEST(Bakes, CancelledSlicesLeaveNoFile) {
    Bench b;
    const auto cancelled = rowOf("slices").run(b.doc, kSmall, [](double) { return false; });
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().code, ExitCode::Interrupted);
    std::error_code none;
    for (const auto& file : std::filesystem::recursive_directory_iterator(b.cache.path(), none))
        EXPECT_FALSE(file.is_regular_file()) << file.path();
}

}  // namespace
}  // namespace sward
