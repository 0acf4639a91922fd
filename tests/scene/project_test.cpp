// Projects in memory and on disk: entities, new, save, load, what is rewritten and what is not.
#include "scene/project.h"

#include <gtest/gtest.h>

#include <set>

#include "maps/map_io.h"
#include "project/project_files.h"
#include "techniques.h"
#include "tests/rows.h"
#include "tests/support.h"

namespace fs = std::filesystem;
using namespace sward;
using sward::test::readText;
using sward::test::TempDir;
using sward::test::writeText;

namespace {
Project made(const fs::path& dir) {
    Result<Project> p = newProject(dir, tables().components);
    EXPECT_TRUE(p) << (p ? "" : p.error().text());
    return std::move(*p);
}
Project loaded(const fs::path& dir) {
    Result<Project> p = loadProject(dir, rows());
    EXPECT_TRUE(p) << (p ? "" : p.error().text());
    return p ? std::move(*p) : Project();
}
std::vector<std::string> savedFiles(const Project& p, const Project* before = nullptr) {
    Result<std::vector<std::string>> files = saveProject(p, rows(), before);
    EXPECT_TRUE(files) << (files ? "" : files.error().text());
    return files ? *files : std::vector<std::string>{"failed"};
}
Map& densityOf(Project& p) { return static_cast<MapField*>(findMap(p, rows(), "density")->value)->map; }
using Files = std::vector<std::string>;
}  // namespace

TEST(Project, SavingWhatWasLoadedRewritesNothing) {
    TempDir dir;
    made(dir / "p");
    const Project p = loaded(dir / "p");
    EXPECT_EQ(savedFiles(p), Files{});
    EXPECT_EQ(savedFiles(p, &p), Files{});
}

TEST(Project, SavingAfterOneStrokeRewritesOneMap) {
    TempDir dir;
    Project p = made(dir / "p");
    const Project before = snapshot(p, rows());
    densityOf(p).set(3, 4, 0, 0.25f);
    EXPECT_EQ(savedFiles(p, &before), Files{"maps/lawn.lawn.density.png"});
    Project again = loaded(dir / "p");
    EXPECT_EQ(densityOf(again).hash(), densityOf(p).hash());
}

TEST(Project, AStrokeThatWasUndoneRewritesNothing) {
    TempDir dir;
    Project p = made(dir / "p");
    const Project before = snapshot(p, rows());
    densityOf(p).set(3, 4, 0, 0.25f);
    densityOf(p).set(3, 4, 0, 1);
    EXPECT_EQ(savedFiles(p, &before), Files{});
    EXPECT_EQ(savedFiles(p), Files{});
}

TEST(Project, AChangedFieldRewritesTheProjectFileOnly) {
    TempDir dir;
    Project p = made(dir / "p");
    const Project before = snapshot(p, rows());
    ASSERT_TRUE(setFieldText(*findField(p, rows(), "sun.Light.elevationDeg"), "12.5"));
    EXPECT_EQ(savedFiles(p, &before), Files{"project.json"});
    const Project again = loaded(dir / "p");
    EXPECT_EQ(again.registry.get<Light>(findEntity(again, "sun"))->elevationDeg, 12.5f);
}

TEST(Project, AHandWrittenFileKeepsItsLayoutUntilSomethingChanges) {
    TempDir dir;
    const std::string text = "{\"format\":1,\n\"entities\":{\"cam\":{\"Camera\":{\"fovDeg\":40}}}}";
    writeText(dir / "p/project.json", text);
    Project p = loaded(dir / "p");
    EXPECT_EQ(p.name, "p");
    EXPECT_EQ(savedFiles(p), Files{});
    EXPECT_EQ(readText(dir / "p/project.json"), text);
    ASSERT_TRUE(setFieldText(*findField(p, rows(), "cam.Camera.fovDeg"), "41"));
    EXPECT_EQ(savedFiles(p), Files{"project.json"});
    const std::string once = readText(dir / "p/project.json");
    fs::remove(dir / "p/project.json");
    EXPECT_EQ(savedFiles(p), Files{"project.json"});
    EXPECT_EQ(readText(dir / "p/project.json"), once);
}

TEST(EntityOf, NamesWhoHoldsAComponent) {
    Project p;
    p.registry.add<Wind>(*addEntity(p, "a"));
    p.registry.add<Wind>(*addEntity(p, "b"));
    EXPECT_EQ(entityOf(p, *p.registry.get<Wind>(findEntity(p, "b"))), "b");
    EXPECT_EQ(entityOf(p, Wind{}), "") << "one that no entity holds";
}
