// What could not be opened again is not saved, and the old state stays.
#include <gtest/gtest.h>

#include "core/json.h"
#include "core/log.h"
#include "mesh/mesh_io.h"
#include "project/project_files.h"
#include "scene/field_limits.h"
#include "tests/project/kill_save.h"
#include "tests/rows.h"
#include "tests/support.h"

namespace fs = std::filesystem;
using namespace sward;
using namespace sward::test;

namespace {
GrassField& lawnOf(Project& p) { return *p.registry.get<GrassField>(findEntity(p, "lawn")); }

class UnreadableProjects : public testing::Test {
  protected:
    void SetUp() override { ASSERT_TRUE(saveProject(p, rows())); }
    // The refusal; the project on disk is what it was.
    Error refusal() {
        const std::string before = readText(dir / "p/project.json");
        const auto saved = saveProject(p, rows());
        EXPECT_FALSE(saved);
        EXPECT_EQ(readText(dir / "p/project.json"), before);
        EXPECT_TRUE(checkProject(dir / "p", rows()).refused.empty());
        if (saved) return {};
        EXPECT_EQ(saved.error().code, ExitCode::Failed);
        EXPECT_FALSE(saved.error().remedy.empty());
        EXPECT_EQ(saved.error().line, 0) << "no line of a file that was not written";
        return saved.error();
    }
    TempDir dir;
    Project p = killState(dir / "p", false);
};
}  // namespace

TEST_F(UnreadableProjects, MoreTextThanTheReaderTakes) {
    p.name = std::string(kMaxJsonBytes, 'x');
    const Error e = refusal();
    EXPECT_EQ(e.file, (dir / "p/project.json").string());
    EXPECT_TRUE(e.message.starts_with("cannot be saved: has ")) << e.text();
    EXPECT_NE(e.message.find(fmt::format("the limit is {}", kMaxJsonBytes)), std::string::npos) << e.text();
}

TEST_F(UnreadableProjects, MoreSpeciesThanASceneTakes) {
    lawnOf(p).species.resize(kMaxSpecies + 1);
    EXPECT_EQ(refusal().message, "cannot be saved: lawn.GrassField.species: 17 species; a field may have 16");
    lawnOf(p).species.resize(kMaxSpecies);
    EXPECT_TRUE(saveProject(p, rows()));
    EXPECT_TRUE(checkProject(dir / "p", rows()).refused.empty());
}

TEST_F(UnreadableProjects, ACopyOfUnsavedWorkHoldsWhateverCanBeOpened) {
    SaveWay way;
    way.copy = true;
    p.dir = dir / "copy";
    lawnOf(p).species.resize(kMaxSpecies + 1);
    EXPECT_TRUE(saveProject(p, rows(), nullptr, way));
    EXPECT_TRUE(loadProject(p.dir, rows()));
}

TEST_F(UnreadableProjects, LongerListsThanTheReaderTakes) {
    lawnOf(p).species.resize(1025);
    EXPECT_EQ(refusal().message, "cannot be saved: lawn.GrassField.species: 1025 elements; the limit is 1024");
}

TEST_F(UnreadableProjects, TextThatIsNotUtf8) {
    lawnOf(p).species[0].name = "caf\xe9";
    EXPECT_EQ(refusal().message, "cannot be saved: lawn.GrassField.species[0].name: holds bytes that are not UTF-8");
    lawnOf(p).species[0].name = "caf\xc3\xa9";
    p.imports["lawn.GrassField.vegetation"].file = "\xff.png";
    EXPECT_EQ(refusal().message,
              "cannot be saved: imports.lawn.GrassField.vegetation.file: holds bytes that are not UTF-8");
}

TEST_F(UnreadableProjects, ObjectsBeyondTheirLimit) {
    fs::create_directories(dir / "p/models");
    writeText(dir / "p/models/big.glb", "");
    fs::resize_file(dir / "p/models/big.glb", kMaxMeshBytes + 1);  // of no blocks
    StaticMesh& mesh = *p.registry.add<StaticMesh>(*addEntity(p, "tree"), {.file = "models/big.glb"});
    const Error e = refusal();
    EXPECT_EQ(e.file, (dir / "p/models/big.glb").string());
    EXPECT_TRUE(e.message.starts_with("tree.StaticMesh.file: cannot be saved: has 2684")) << e.text();
    EXPECT_NE(e.message.find(fmt::format("the limit is {}", kMaxMeshBytes)), std::string::npos) << e.text();
    mesh.file = "models/text.glb";
    writeText(dir / "p/models/text.glb", "Hello.");
    EXPECT_TRUE(refusal().message.starts_with("tree.StaticMesh.file: cannot be saved: "));
}

// Work that is otherwise sound is not held up by a file that may still come, or that was lost since.
TEST_F(UnreadableProjects, AFileThatIsNotThereHoldsUpNoSave) {
    std::string heard;
    const int sink = addLogSink([&](LogLevel, const std::string& line) { heard += line; });
    p.registry.add<StaticMesh>(findEntity(p, "lawn"), {.file = "box.glb"});
    EXPECT_TRUE(saveProject(p, rows()));
    removeLogSink(sink);
    EXPECT_NE(heard.find("lawn.StaticMesh.file: is not there"), std::string::npos) << heard;
    writeText(dir / "p/box.glb", "");
    lawnOf(p).seed = 5;
    EXPECT_TRUE(saveProject(p, rows())) << "it was named before";
}

TEST(ReadableProjects, AFolderMayHaveAnyName) {
    TempDir dir;
    const fs::path folder = dir / "caf\xe9";
    const Result<Project> made = newProject(folder, rows());
    ASSERT_TRUE(made) << made.error().text();
    EXPECT_EQ(made->name, "caf\xef\xbf\xbd");
    EXPECT_TRUE(checkProject(folder, rows()).refused.empty());
    writeText(folder / "project.json", "{}");
    EXPECT_EQ(loadProject(folder, rows())->name, made->name) << "called after its folder";
}

TEST(ReadableProjects, AFieldTakesNoTextThatIsNotUtf8) {
    TempDir dir;
    Project p = killState(dir / "p", false);
    const Result<FieldRef> name = findField(p, rows(), "lawn.GrassField.species[0].name");
    ASSERT_TRUE(name);
    const Status set = setFieldText(*name, "caf\xe9");
    ASSERT_FALSE(set);
    EXPECT_EQ(set.error().code, ExitCode::Usage);
    EXPECT_NE(set.error().message.find("not UTF-8 from byte 4"), std::string::npos) << set.error().text();
    EXPECT_TRUE(setFieldText(*name, "caf\xc3\xa9"));
}
