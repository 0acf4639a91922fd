// Projects that the editor offers while none is open: what is remembered, and of what file.
#include "app/start.h"

#include <gtest/gtest.h>

#include <fstream>

#include "support.h"

namespace sward {
namespace {

namespace fs = std::filesystem;
using test::TempDir;

fs::path project(const TempDir& dir, const std::string& name) {
    fs::create_directories(dir / name);
    std::ofstream(dir / name / "project.json") << "{}";
    return dir / name;
}

TEST(Start, RemembersTheLastProjectsTheNewestFirstAndEachOnce) {
    const TempDir dir;
    const fs::path file = dir / "state/sward/recent.txt";
    StartScreen start;
    start.keep = true;
    const fs::path a = project(dir, "a"), b = project(dir, "b");
    rememberProject(start, a, file);
    rememberProject(start, b, file);
    rememberProject(start, a, file);
    EXPECT_EQ(start.recent, (std::vector<fs::path>{a, b}));
    EXPECT_EQ(loadStart(file, {}).recent, start.recent);
    fs::remove_all(b);
    EXPECT_EQ(loadStart(file, {}).recent, (std::vector<fs::path>{a})) << "what is gone is not offered";
    for (int i = 0; i < 12; ++i) rememberProject(start, project(dir, "p" + std::to_string(i)), file);
    EXPECT_EQ(loadStart(file, {}).recent.size(), kMostRecent);
}

TEST(Start, ScriptsLeaveNoTrace) {
    const TempDir dir;
    StartScreen start;
    rememberProject(start, project(dir, "a"), dir / "recent.txt");
    EXPECT_EQ(start.recent.size(), 1u);
    EXPECT_FALSE(fs::exists(dir / "recent.txt"));
}

TEST(Start, ADamagedFileOrFolderChangesNothing) {
    const TempDir dir;
    std::ofstream(dir / "recent.txt") << "relative/path\n\0\n/nowhere/at/all\n" << std::string(1000, 'x') << "\n";
    EXPECT_TRUE(loadStart(dir / "recent.txt", dir / "nothing").recent.empty());
    std::ofstream(dir / "long.txt") << std::string(1 << 20, '/');
    EXPECT_TRUE(loadStart(dir / "long.txt", {}).recent.empty());
    fs::create_directories(dir / "samples/empty");
    const fs::path one = project(dir, "samples/one");
    EXPECT_EQ(loadStart({}, dir / "samples").samples, (std::vector<fs::path>{one}));
}

}  // namespace
}  // namespace sward
