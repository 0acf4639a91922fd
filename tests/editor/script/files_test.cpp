// Files that scripts cannot reach.
#include "editor/script/cage.h"

namespace sward {
namespace {

namespace fs = std::filesystem;
using test::Cage;
using test::says;

TEST(ScriptFiles, FilesOutsideAreOutOfReach) {
    Cage c;
    ASSERT_EQ(c.fault("project.new('p') map.export('density', 'ok.png') map.export('density', 'p/ok.png')"), "");
    EXPECT_TRUE(fs::exists(c.dir / "inside/p/ok.png"));
    ASSERT_EQ(c.fault("map.export('density', 'new/folder/ok.png')"), "") << "folders are made";
    fs::copy_file(c.dir / "inside/ok.png", c.dir / "outside.png");
    const std::string outside = (c.dir / "outside.png").string(), refusal = "scripts reach only files";
    EXPECT_TRUE(says(c.fault("map.import('density', '" + outside + "')"), refusal));
    EXPECT_TRUE(says(c.fault("map.import('density', '../outside.png')"), refusal));
    EXPECT_TRUE(says(c.fault("map.import('density', 'p/../../outside.png')"), refusal));
    EXPECT_TRUE(says(c.fault("map.export('density', '../new.png')"), refusal));
    EXPECT_TRUE(says(c.fault("map.export('density', '../other/new.png')"), refusal));
    EXPECT_TRUE(says(c.fault("map.export('density', '/tmp/sward-escape.png')"), refusal));
    EXPECT_TRUE(says(c.fault("project.new('../other')"), refusal));
    EXPECT_TRUE(says(c.fault("project.saveAs('../other')"), refusal));
    EXPECT_FALSE(fs::exists(c.dir / "other"));
    EXPECT_FALSE(fs::exists(c.dir / "new.png"));
}

TEST(ScriptFiles, AnEmptyNameIsNoFolder) {
    Cage c;
    ASSERT_EQ(c.fault("project.new('p')"), "");
    for (const char* call :
         {"project.saveAs('')", "project.new('')", "map.export('density', '')", "map.import('density', '')"})
        EXPECT_TRUE(says(c.fault(call), "an empty name is no file")) << call;
    EXPECT_FALSE(fs::exists(c.dir / "inside/project.json"));
    EXPECT_FALSE(fs::exists(c.dir / "inside/maps"));
}

TEST(ScriptFiles, SymbolicLinksCountAsWhereTheyLead) {
    Cage c;
    ASSERT_EQ(c.fault("project.new('p') map.export('density', 'ok.png')"), "");
    fs::rename(c.dir / "inside/ok.png", c.dir / "outside.png");
    fs::create_symlink(c.dir / "outside.png", c.dir / "inside/link.png");
    fs::create_symlink(c.dir / "nowhere.png", c.dir / "inside/dangling.png");
    fs::create_directory_symlink(c.dir.path, c.dir / "inside/up");
    const std::string refusal = "scripts reach only files";
    EXPECT_TRUE(says(c.fault("map.import('density', 'link.png')"), refusal));
    EXPECT_TRUE(says(c.fault("map.export('density', 'link.png')"), refusal));
    EXPECT_TRUE(says(c.fault("map.export('density', 'dangling.png')"), refusal));
    EXPECT_TRUE(says(c.fault("map.export('density', 'up/new.png')"), refusal));
    EXPECT_TRUE(says(c.fault("project.new('up/other')"), refusal));
    EXPECT_FALSE(fs::exists(c.dir / "nowhere.png"));
    EXPECT_FALSE(fs::exists(c.dir / "new.png"));
}

TEST(ScriptFiles, AProjectElsewhereMayBeOpenedAndCopiedButNotAnyFolder) {
    Cage c;
    ASSERT_EQ(c.fault("project.new('p') project.saveAs('q')"), "");
    fs::rename(c.dir / "inside/q", c.dir / "q");
    const std::string q = "'" + (c.dir / "q").string() + "'";
    EXPECT_EQ(c.fault("project.open(" + q + ") map.export('density', project.dir() .. '/new.png')"), "");
    EXPECT_EQ(c.fault("project.open(project.tempCopy(" + q + ")) project.save()"), "");
    EXPECT_TRUE(says(c.fault("project.tempCopy('/etc')"), "no project"));
    EXPECT_TRUE(says(c.fault("project.open('/etc')"), "project.json"));
    EXPECT_TRUE(says(c.fault("project.tempCopy('nowhere')"), "no such project"));
}

TEST(ScriptFiles, TempCopyTakesNoLinksAlong) {
    Cage c;
    ASSERT_EQ(c.fault("project.new('p')"), "");
    test::writeText(c.dir / "secret", "s");
    fs::create_symlink(c.dir / "secret", c.dir / "inside/p/link");
    std::string copy;
    c.host.print = [&](const std::string& line) { copy = line; };
    bool linked = true;
    c.host.useCamera = [&](const std::string&) { linked = fs::exists(fs::path(copy) / "link"); };
    ASSERT_EQ(c.fault("local c = project.tempCopy('p') print(c) project.open(c) camera.use('camera')"), "");
    EXPECT_FALSE(linked);
}

}  // namespace
}  // namespace sward
