// Saving when something is in the way: kills, full disks, folders that cannot be written.
#include <grp.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <set>

#include "core/jobs.h"
#include "core/save_folder.h"
#include "fields.h"
#include "maps/map_io.h"
#include "project/project_files.h"
#include "scene/project.h"
#include "tests/maps/images.h"
#include "tests/project/kill_save.h"
#include "tests/rows.h"
#include "tests/support.h"

namespace fs = std::filesystem;
using namespace sward;
using namespace sward::test;

namespace {
// Every file under dir with its bytes.
std::map<std::string, std::string> contents(const fs::path& dir) {
    std::map<std::string, std::string> out;
    for (const auto& entry : fs::recursive_directory_iterator(dir))
        out[entry.path().lexically_relative(dir).string()] = entry.is_directory() ? "" : readText(entry.path());
    return out;
}

// Root may write anywhere: become nobody. True also for those who are not root.
bool dropPrivileges() {
    if (geteuid() != 0) return true;
    return setgroups(0, nullptr) == 0 && setresgid(65534, 65534, 65534) == 0 && setresuid(65534, 65534, 65534) == 0;
}

void makeReadOnly(const fs::path& dir) {
    fs::permissions(dir.parent_path(), fs::perms(0755));
    for (const auto& entry : fs::recursive_directory_iterator(dir))
        fs::permissions(entry.path(), fs::perms(entry.is_directory() ? 0555 : 0444));
    fs::permissions(dir, fs::perms(0555));
}
void makeWritable(const fs::path& dir) {
    fs::permissions(dir, fs::perms(0755));
    for (const auto& entry : fs::recursive_directory_iterator(dir)) fs::permissions(entry.path(), fs::perms(0755));
}

// What a project is called that is loaded by a process that may not write to it.
const ChildFunctionRow kLoadUnprivileged("load-unprivileged", [](const std::vector<std::string>& args) -> std::string {
    if (!dropPrivileges()) return "cannot drop privileges";
    const std::string fault = faultOf(args.at(0));
    return fault.empty() ? loadProject(args.at(0), rows())->name : fault;
});
const ChildFunctionRow kSaveUnprivileged("save-unprivileged", [](const std::vector<std::string>& args) -> std::string {
    if (!dropPrivileges()) return "cannot drop privileges";
    const auto saved = saveProject(killState(args.at(0), true), rows());
    return saved ? "saved" : saved.error().text();
});
// Saves where no file may grow beyond a limit, as on a disk that is full.
const ChildFunctionRow kSaveWithLimit("save-with-limit", [](const std::vector<std::string>& args) -> std::string {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit bound{rlim_t(std::stoi(args.at(1))), rlim_t(std::stoi(args.at(1)))};
    const Project p = killState(args.at(0), true);
    if (setrlimit(RLIMIT_FSIZE, &bound) != 0) return "no limit";
    const auto saved = saveProject(p, rows());
    if (saved) return "saved";
    return p.name == "b" && p.registry.get<Terrain>(findEntity(p, "ground"))->height.present() ? saved.error().text()
                                                                                               : "memory changed";
});

// A project whose density map is so large that its file grows; state b has another texel and another name.
Project largeState(const fs::path& dir, const Map& density, bool b) {
    Project p;
    p.dir = dir;
    p.name = b ? "b" : "a";
    GrassField field;
    field.species[0].density = {"maps/lawn.grass.density.tif", density};
    if (b) field.species[0].density.map.set(200, 300, 0, 0.5f);
    p.registry.add<GrassField>(*addEntity(p, "lawn"), std::move(field));
    return p;
}
const Map& densityOf(const Project& p) {
    return p.registry.get<GrassField>(findEntity(p, "lawn"))->species[0].density.map;
}
// Empty if it opens as state a or b; else what is wrong. `a`: hash of state a's texels.
std::string largeFault(const fs::path& dir, uint64_t a) {
    const Result<Project> p = loadProject(dir, rows());
    if (!p) return p.error().text();
    return (p->name == "a") == (densityOf(*p).hash() == a) ? p->name : "mixed: named " + p->name;
}
const ChildFunctionRow kLoadLarge("load-large-unprivileged", [](const std::vector<std::string>& args) -> std::string {
    return dropPrivileges() ? largeFault(args.at(0), std::stoull(args.at(1))) : "cannot drop privileges";
});
// Saves states a and b in turn, by growing, until it is killed; writes a byte once it begins.
const ChildFunctionRow kGrowInTurn("grow-in-turn", [](const std::vector<std::string>& args) -> std::string {
    Result<Project> known = loadProject(args.at(0), rows());
    if (!known) return known.error().text();
    const float asInA = fullMap().at(200, 300);
    if (write(STDOUT_FILENO, ".", 1) != 1) return "nobody listens";
    for (;;) {
        const bool b = known->name == "a";
        Project next = largeState(args.at(0), densityOf(*known), b);
        if (!b) next.registry.get<GrassField>(findEntity(next, "lawn"))->species[0].density.map.set(200, 300, 0, asInA);
        next.stamps = known->stamps;
        SaveWay way;
        std::map<std::string, FileStamp> stamps;
        way.stamps = &stamps;
        if (const auto saved = saveProject(next, rows(), &*known, way); !saved) return saved.error().text();
        next.stamps = stamps;
        known = std::move(next);
    }
});
}  // namespace

TEST(Saving, ThirtyKillsWhileALargeMapGrowsLeaveOneStateOrTheOther) {
    TempDir dir;
    ASSERT_TRUE(saveProject(largeState(dir / "p", fullMap(), false), rows()));
    const uint64_t bytes = fs::file_size(dir / "p/maps/lawn.grass.density.tif"), hashA = fullMap().hash();
    std::mt19937 random(1);
    std::set<std::string> seen;
    for (int i = 0; i < 30; ++i) {
        const Child child = startChild("grow-in-turn", {(dir / "p").string()});
        char begun = 0;
        ASSERT_EQ(read(child.output, &begun, 1), 1);
        std::this_thread::sleep_for(std::chrono::microseconds(random() % 40'000));
        kill(child.pid, SIGKILL);
        EXPECT_EQ(finishChild(child), "the child crashed") << "it could not save";
        seen.insert(largeFault(dir / "p", hashA));
    }
    EXPECT_EQ(seen, (std::set<std::string>{"a", "b"}));
    EXPECT_GT(fs::file_size(dir / "p/maps/lawn.grass.density.tif"), bytes) << "nothing grew";
}

TEST(Saving, ALargeMapsFileGrowsByWhatChanged) {
    TempDir dir;
    const fs::path file = dir / "p/maps/lawn.grass.density.tif";
    ASSERT_TRUE(saveProject(largeState(dir / "p", fullMap(), false), rows()));
    const Result<Project> a = loadProject(dir / "p", rows());
    ASSERT_TRUE(a);
    const FileStamp before = stampOf(file);
    Project b = largeState(dir / "p", densityOf(*a), true);
    b.stamps = a->stamps;
    const auto saved = saveProject(b, rows(), &*a);
    ASSERT_TRUE(saved) << saved.error().text();
    EXPECT_EQ(*saved, (std::vector<std::string>{"maps/lawn.grass.density.tif", "project.json"}));
    const FileStamp after = stampOf(file);
    EXPECT_EQ(after.number, before.number) << "another file took its place";
    EXPECT_GT(after.bytes, before.bytes);
    EXPECT_LT(after.bytes, before.bytes + 32768);
    EXPECT_FALSE(fs::exists(dir / "p/.sward-save"));
    EXPECT_EQ(densityOf(*loadProject(dir / "p", rows())).hash(), densityOf(b).hash());
    EXPECT_EQ(densityOf(*a).hash(), fullMap().hash()) << "what was loaded before is as it was";
    EXPECT_TRUE(checkProject(dir / "p", rows()).refused.empty());
    EXPECT_TRUE(saveProject(b, rows(), &b)->empty()) << "nothing changed since";
}

TEST(Saving, ALargeMapElsewhereInTheProjectIsWrittenAnew) {
    TempDir dir;
    Project a = largeState(dir / "p", fullMap(), false);
    a.registry.get<GrassField>(findEntity(a, "lawn"))->species[0].density.file = "land/density.tif";
    ASSERT_TRUE(saveProject(a, rows()));
    const Result<Project> known = loadProject(dir / "p", rows());
    Project b = largeState(dir / "p", densityOf(*known), true);
    b.registry.get<GrassField>(findEntity(b, "lawn"))->species[0].density.file = "land/density.tif";
    ASSERT_TRUE(saveProject(b, rows(), &*known));
    EXPECT_EQ(densityOf(*loadProject(dir / "p", rows())).hash(), densityOf(b).hash());
}

TEST(Saving, AFileThatHasGrownCountsFromTheCommitOn) {
    TempDir dir;
    const std::string name = "maps/lawn.grass.density.tif", pending = ".sward-save/" + name + ".sward-switch";
    ASSERT_TRUE(saveProject(largeState(dir / "p", fullMap(), false), rows()));
    const Result<Project> a = loadProject(dir / "p", rows());
    const uint64_t hashA = fullMap().hash();
    const std::string head = readText(dir / "p" / name).substr(0, 8), jsonA = readText(dir / "p/project.json");
    ASSERT_TRUE(saveProject(largeState(dir / "p", densityOf(*a), true), rows(), &*a));
    const std::string grown = readText(dir / "p" / name), jsonB = readText(dir / "p/project.json");
    // As a kill before the commit leaves it: the end is there and nothing refers to it.
    const std::string uncommitted = head + grown.substr(8);
    writeText(dir / "p" / name, uncommitted), writeText(dir / "p/project.json", jsonA);
    EXPECT_EQ(largeFault(dir / "p", hashA), "a");
    // And as one between the commit and the moves leaves it.
    const auto number = [](const std::string& h) {
        return unsigned(uint8_t(h[4])) | unsigned(uint8_t(h[5])) << 8 | unsigned(uint8_t(h[6])) << 16 |
               unsigned(uint8_t(h[7])) << 24;
    };
    writeText(dir / "p" / pending, fmt::format(R"({{"at": 4, "before": {}, "after": {}, "size": {}}})", number(head),
                                               number(grown.substr(0, 8)), grown.size()));
    writeText(dir / "p/.sward-save/project.json", jsonB);
    makeReadOnly(dir / "p");
    EXPECT_EQ(runChild("load-large-unprivileged", {(dir / "p").string(), std::to_string(hashA)}), "b")
        << "read through where nothing may be written";
    makeWritable(dir / "p");
    EXPECT_EQ(largeFault(dir / "p", hashA), "b");
    EXPECT_EQ(readText(dir / "p" / name), grown) << "the reader finished the save";
    EXPECT_FALSE(fs::exists(dir / "p/.sward-save"));
    // The map is put back from a copy before anybody finished the save: it lacks what was added.
    writeText(dir / "p" / pending, fmt::format(R"({{"at": 4, "before": {}, "after": {}, "size": {}}})", number(head),
                                               number(grown.substr(0, 8)), grown.size()));
    writeText(dir / "p/.sward-save/project.json", jsonB);
    writeText(dir / "p" / name, uncommitted.substr(0, uncommitted.size() / 2 * 2 - 65536));
    const std::string said = largeFault(dir / "p", hashA);
    EXPECT_NE(said.find("interrupted save"), std::string::npos) << said;
    EXPECT_TRUE(fs::exists(dir / "p" / pending)) << "and stays for who has the whole file";
}

TEST(Saving, AFailedSaveTakesBackWhatItAddedToALargeMap) {
    TempDir dir;
    const fs::path file = dir / "p/maps/lawn.grass.density.tif";
    ASSERT_TRUE(saveProject(largeState(dir / "p", fullMap(), false), rows()));
    const Result<Project> a = loadProject(dir / "p", rows());
    const FileStamp before = stampOf(file);
    Project b = largeState(dir / "p", densityOf(*a), true);
    JobControl control;
    control.cancel();
    EXPECT_FALSE(saveProject(b, rows(), &*a, {}, &control));
    EXPECT_TRUE(stampOf(file) == before);
    // The other map of the same save cannot be written.
    auto& field = *b.registry.get<GrassField>(findEntity(b, "lawn"));
    field.vegetation = {"maps/z\0.png", Map({32, 32, 4, PixelType::U8})};
    field.vegetation.file = "maps/" + std::string(300, 'z') + ".png";
    const auto saved = saveProject(b, rows(), &*a);
    ASSERT_FALSE(saved);
    EXPECT_TRUE(stampOf(file) == before) << "nothing is left of it, and its time is as before";
    EXPECT_EQ(largeFault(dir / "p", fullMap().hash()), "a");
}

void expectOneStateOrTheOther(int kills) {
    TempDir dir;
    std::string why;
    EXPECT_EQ(killSaveLoop(kills, dir / "p", &why), 0) << why;
    fs::remove_all(dir / "p/.sward-save");
    EXPECT_EQ(faultOf(dir / "p"), "");
}
TEST(Saving, TenKillsLeaveOneStateOrTheOther) { expectOneStateOrTheOther(10); }
TEST(Saving, FiftyKillsLeaveOneStateOrTheOther) { expectOneStateOrTheOther(50); }

TEST(Saving, AKillBeforeTheCommitLeavesTheOldState) {
    TempDir dir;
    ASSERT_TRUE(saveProject(killState(dir / "p", false), rows()));
    writeText(dir / "p/.sward-save.tmp/project.json", "{\"name\": \"half");
    EXPECT_EQ(faultOf(dir / "p"), "");
    EXPECT_EQ(loadProject(dir / "p", rows())->name, "a");
    ASSERT_TRUE(saveProject(killState(dir / "p", true), rows()));
    EXPECT_FALSE(fs::exists(dir / "p/.sward-save.tmp")) << "the next save clears it away";
}

TEST(Saving, AKillAfterTheCommitLeavesTheNewStateWhateverWasMoved) {
    TempDir dir;
    ASSERT_TRUE(saveProject(killState(dir / "b", true), rows()));
    const std::vector<std::string> files{"project.json", "maps/ground.height.exr", "maps/lawn.grass.density.png",
                                         "maps/lawn.vegetation.png"};
    for (size_t moved = 0; moved <= files.size(); ++moved) {
        fs::remove_all(dir / "p");
        ASSERT_TRUE(saveProject(killState(dir / "p", false), rows()));
        for (size_t i = 0; i < files.size(); ++i)
            writeText((i < moved ? dir / "p" : dir / "p/.sward-save") / files[i], readText(dir / "b" / files[i]));
        fs::create_directories(dir / "p/.sward-save");
        EXPECT_EQ(faultOf(dir / "p"), "") << moved;
        EXPECT_EQ(loadProject(dir / "p", rows())->name, "b") << moved;
        EXPECT_FALSE(fs::exists(dir / "p/.sward-save")) << "the reader finished the moves";
        EXPECT_EQ(contents(dir / "p"), contents(dir / "b"));
    }
}

TEST(Saving, APendingSaveIsReadThroughWhereNothingMayBeWritten) {
    TempDir dir;
    ASSERT_TRUE(saveProject(killState(dir / "p", false), rows()));
    ASSERT_TRUE(saveProject(killState(dir / "b", true), rows()));
    fs::rename(dir / "b", dir / "p/.sward-save");
    makeReadOnly(dir / "p");
    const std::string said = runChild("load-unprivileged", {(dir / "p").string()});
    EXPECT_EQ(said, "b");
    EXPECT_TRUE(fs::exists(dir / "p/.sward-save/project.json"));
    makeWritable(dir / "p");
}

TEST(Saving, AReadOnlyProjectLoadsAndSavingItFailsWithoutATrace) {
    TempDir dir;
    ASSERT_TRUE(saveProject(killState(dir / "p", false), rows()));
    const auto before = contents(dir / "p");
    makeReadOnly(dir / "p");
    EXPECT_EQ(runChild("load-unprivileged", {(dir / "p").string()}), "a");
    const std::string said = runChild("save-unprivileged", {(dir / "p").string()});
    EXPECT_NE(said.find("Permission denied"), std::string::npos) << said;
    EXPECT_NE(said.find("check who may read and write it"), std::string::npos) << said;
    EXPECT_EQ(said.find(".sward"), std::string::npos) << said;
    makeWritable(dir / "p");
    EXPECT_EQ(contents(dir / "p"), before);
}

TEST(Saving, AFullDiskFailsWithoutATrace) {
    TempDir dir;
    ASSERT_TRUE(saveProject(killState(dir / "p", false), rows()));
    const auto before = contents(dir / "p");
    for (const int limit : {0, 100, 300, 700}) {
        const std::string said = runChild("save-with-limit", {(dir / "p").string(), std::to_string(limit)});
        EXPECT_NE(said.find("cannot be written"), std::string::npos) << said;
        EXPECT_TRUE(said.starts_with((dir / "p/").string())) << said;
        EXPECT_EQ(said.find(".sward"), std::string::npos) << "the file's own place is named: " << said;
        EXPECT_EQ(contents(dir / "p"), before) << "limit " << limit;
    }
}

TEST(Saving, MapsOfRemovedComponentsGoAfterTheCommit) {
    TempDir dir;
    Project p = killState(dir / "p", true);
    ASSERT_TRUE(saveProject(p, rows()));
    writeText(dir / "p/maps/notes.txt", "mine");
    ASSERT_TRUE(fs::exists(dir / "p/maps/ground.height.exr"));
    p.registry.remove<Terrain>(findEntity(p, "ground"));
    ASSERT_TRUE(saveProject(p, rows()));
    EXPECT_FALSE(fs::exists(dir / "p/maps/ground.height.exr"));
    EXPECT_TRUE(fs::exists(dir / "p/maps/lawn.vegetation.png"));
    EXPECT_TRUE(fs::exists(dir / "p/maps/notes.txt")) << "what no project named is not touched";
    EXPECT_TRUE(loadProject(dir / "p", rows()));
}

TEST(Saving, APendingSaveCannotReachOutOfTheProject) {
    TempDir dir;
    ASSERT_TRUE(saveProject(killState(dir / "p", false), rows()));
    writeText(dir / "outside/keep.txt", "mine");
    fs::create_symlink(dir / "outside", dir / "p/elsewhere");
    writeText(dir / "p/.sward-save/elsewhere/keep.txt", "theirs");
    writeText(dir / "p/.sward-save/.removed", "maps/../../outside/keep.txt\nproject.json\n");
    EXPECT_FALSE(finishSave(dir / "p"));
    EXPECT_EQ(readText(dir / "outside/keep.txt"), "mine");
    EXPECT_TRUE(fs::exists(dir / "p/project.json"));
    fs::remove_all(dir / "p/.sward-save");
    fs::create_symlink(dir / "outside", dir / "p/.sward-save");
    EXPECT_TRUE(loadProject(dir / "p", rows()));
    EXPECT_TRUE(fs::exists(dir / "outside/keep.txt")) << "a link is no pending save";
}

TEST(Saving, SaveAsBringsImagesAlong) {
    TempDir dir;
    Project p = killState(dir / "p", false);
    fs::create_directories(dir / "p");
    ASSERT_TRUE(writeImagePng(dir / "p/blade.png", 1, 1, 4, {1, 2, 3, 4}));
    flatField(p, "lawn").species[0].texture = "blade.png";
    ASSERT_TRUE(saveProject(p, rows()));
    const Project before = snapshot(p, rows());
    p.dir = dir / "q/r";
    const auto saved = saveProject(p, rows(), &before);
    ASSERT_TRUE(saved) << saved.error().text();
    EXPECT_EQ(saved->size(), 4u);
    EXPECT_TRUE(loadProject(dir / "q/r", rows()));
    EXPECT_EQ(readText(dir / "q/r/blade.png"), readText(dir / "p/blade.png"));
}

TEST(Saving, WhatCannotBeLoadedIsNotSaved) {
    TempDir dir;
    Project p = killState(dir / "p", true);
    ASSERT_TRUE(saveProject(p, rows()));
    const auto before = contents(dir / "p");
    flatField(p, "lawn").minGeom = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NE(saveProject(p, rows()).error().message.find("lawn.HybridTiers.minGeom"), std::string::npos);
    flatField(p, "lawn").minGeom = 4;
    p.registry.get<Terrain>(findEntity(p, "ground"))->height.map = patternMap({8, 8, 1, PixelType::U8});
    EXPECT_NE(saveProject(p, rows()).error().message.find("8 bits"), std::string::npos);
    p.registry.get<Terrain>(findEntity(p, "ground"))->height.map = patternMap({8, 8, 2, PixelType::U16});
    EXPECT_NE(saveProject(p, rows()).error().message.find("2 channels"), std::string::npos);
    EXPECT_EQ(contents(dir / "p"), before);
    p.dir.clear();
    EXPECT_FALSE(saveProject(p, rows()));
}
