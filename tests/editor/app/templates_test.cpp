// Templates: each makes a sound project of the size and relief that were asked for, or leaves nothing.
#include "app/templates.h"

#include <gtest/gtest.h>

#include "core/resources.h"
#include "project/project_files.h"
#include "support.h"
#include "techniques.h"
#include "world/ground.h"
#include "world/view_camera.h"

namespace sward {
namespace {

namespace fs = std::filesystem;

std::vector<ProjectTemplate> shipped() { return projectTemplates(resource("projects/templates")); }

TEST(Templates, ThoseThatAreShippedHaveTitlesHelpAndPictures) {
    std::vector<std::string> names;
    for (const ProjectTemplate& t : shipped()) {
        names.push_back(t.name);
        EXPECT_NE(t.title, "");
        EXPECT_NE(t.help, "");
        EXPECT_TRUE(fs::exists(t.script.parent_path() / t.picture)) << t.picture << ": run tools/pictures.sh";
    }
    EXPECT_EQ(names, (std::vector<std::string>{"field", "hills", "pitch", "pond"}));
}

void expectSound(const ProjectTemplate& t, float size, float relief) {
    const test::TempDir dir;
    const fs::path to = dir / t.name;
    const Status made = makeProject(tables(), to, t, {t.name, size, relief});
    ASSERT_TRUE(made) << t.name << ": " << made.error().text();
    const CheckReport report = checkProject(to, tables().components);
    EXPECT_TRUE(report.refused.empty() && report.repaired.empty() && report.noticed.empty()) << t.name;
    const auto p = loadProject(to, tables().components);
    const Terrain& ground = *firstOf<Terrain>(*p);
    EXPECT_EQ(ground.size, glm::dvec2(size));
    HeightBounds bounds;
    updateHeightBounds(bounds, ground);
    if (relief > 0) EXPECT_GT(bounds.high - bounds.low, relief * 0.3f) << t.name;
    if (relief > 0) EXPECT_LT(bounds.high - bounds.low, relief * 1.5f + 6) << t.name;
    EXPECT_GT(virtualBlades(*p), 100 * size) << t.name;
    const Camera& c = *findCamera(*p, "");
    EXPECT_GT(c.eye.y, terrainHeight(ground, c.eye.x, c.eye.z)) << t.name << " looks out of the ground";
}
TEST(Templates, EachMakesASoundSmallProject) {
    for (const ProjectTemplate& t : shipped()) expectSound(t, 20, t.relief);
}
TEST(Templates, EachMakesASoundProjectOfAnySizeAndRelief) {
    for (const ProjectTemplate& t : shipped()) expectSound(t, t.size, t.relief), expectSound(t, 200, 8);
}

TEST(Templates, AScriptThatFailsLeavesNothingBehind) {
    const test::TempDir dir;
    test::writeText(dir / "t" / "bad.lua", "-- Bad: it fails.\n-- 30 m, 2 m of relief\nmap.blur('nothing', 1)\n");
    test::writeText(dir / "t" / "untitled.lua", "local x = 1\n");
    const std::vector<ProjectTemplate> found = projectTemplates(dir / "t");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].size, 30);
    EXPECT_EQ(found[0].relief, 2);
    const Status made = makeProject(tables(), dir / "p", found[0], {"bad", 30, 2});
    ASSERT_FALSE(made);
    EXPECT_NE(made.error().text().find("bad.lua:3"), std::string::npos) << made.error().text();
    EXPECT_FALSE(fs::exists(dir / "p"));
    EXPECT_FALSE(makeProject(tables(), dir / "p", found[0], {"bad", 1, 2}));
    EXPECT_FALSE(makeProject(tables(), dir / "p", found[0], {"bad", 30, -1}));
    EXPECT_FALSE(fs::exists(dir / "p"));
    test::writeText(dir / "full" / "mine.txt", "x");
    EXPECT_FALSE(makeProject(tables(), dir / "full", found[0], {"bad", 30, 2}));
    EXPECT_EQ(test::readText(dir / "full" / "mine.txt"), "x") << "what was there stays";
}

}  // namespace
}  // namespace sward
