// Options of the command line that are refused before anything is opened: exit code 2.
#include <gtest/gtest.h>

#include <filesystem>

#include "cli/cli.h"
#include "support.h"

namespace sward {
namespace {

struct Refused {
    int code = 0;
    std::string said;
};
Refused run(std::vector<std::string> args) {
    args.insert(args.begin(), "sward");
    std::vector<char*> argv;
    for (std::string& a : args) argv.push_back(a.data());
    testing::internal::CaptureStderr();
    Refused r;
    r.code = runCommandLine(static_cast<int>(argv.size()), argv.data());
    r.said = testing::internal::GetCapturedStderr();
    return r;
}

// That a verb gets as far as the project, which is none, with these options.
constexpr int kTaken = static_cast<int>(ExitCode::Unsound);

TEST(Options, SceneTimeIsFinite) {
    for (const char* verb : {"render", "reference"}) {
        for (const char* time : {"nan", "inf", "-inf", "-nan"}) {
            const Refused r = run({verb, "/no/project", "--time", time});
            EXPECT_EQ(r.code, 2) << verb << " " << time;
            EXPECT_NE(r.said.find("--time"), std::string::npos) << r.said;
        }
        EXPECT_EQ(run({verb, "/no/project", "--time", "-1.5"}).code, kTaken) << verb;
    }
    EXPECT_EQ(run({"cost", "/no/project", "--out", "/no", "--time", "nan"}).code, 2);
    EXPECT_EQ(run({"fit", "/no/project", "--budget-ms", "10", "--time", "nan"}).code, 2);
}

TEST(Options, EachSizeOfASweepIsASize) {
    const std::string lawn = (std::filesystem::path(SWARD_SOURCE_DIR) / "tests/scenes/field40").string();
    for (const char* sizes : {"64x48,0x0", "64x48,wide", ",", "64"}) {
        const Refused r = run({"cost", lawn, "--out", "/no", "--size", sizes});
        EXPECT_EQ(r.code, 2) << sizes << ": " << r.said;
    }
}

TEST(Options, SamplesAPixelAreThoseOfTheHelp) {
    for (const char* samples : {"1", "2", "4", "8"})
        EXPECT_EQ(run({"render", "/no/project", "--msaa", samples}).code, kTaken) << samples;
    for (const char* samples : {"3", "0", "-1", "16", "4.5", "many"}) {
        const Refused r = run({"render", "/no/project", "--msaa", samples});
        EXPECT_EQ(r.code, 2) << samples;
        EXPECT_NE(r.said.find("1, 2, 4 or 8"), std::string::npos) << r.said;
    }
}

TEST(Options, AFilmsRateIsAboveZero) {
    for (const char* rate : {"0", "-25", "nan", "inf"})
        for (const char* verb : {"render", "reference"}) {
            const Refused r = run({verb, "/no/project", "--frames", "2", "--out", "t", "--fps", rate});
            EXPECT_EQ(r.code, 2) << verb << " " << rate;
            EXPECT_NE(r.said.find("--fps"), std::string::npos) << r.said;
        }
    EXPECT_EQ(run({"render", "/no/project", "--frames", "2", "--out", "t", "--fps", "0.5"}).code, kTaken);
    EXPECT_EQ(run({"render", "/no/project", "--frames", "-2"}).code, 2);
}

TEST(Options, ACurveIsOfAHardCaseAndGoesToAGraphOrATable) {
    EXPECT_EQ(run({"hardcases", "--curve", "B-1", "--json"}).code, 2) << "a table has no curve";
    EXPECT_EQ(run({"hardcases", "--out", "t.png"}).code, 2) << "all cases have no graph";
    EXPECT_NE(run({"hardcases", "--curve", "B-1", "--out", "t.txt"}).said.find(".csv"), std::string::npos);
    const Refused unknown = run({"hardcases", "--curve", "Z-1"});
    EXPECT_EQ(unknown.code, 2);
    EXPECT_NE(unknown.said.find("B-1, B-1.2"), std::string::npos) << "it names those there are";
    const Refused random = run({"hardcases", "--curve", "J-3"});
    EXPECT_EQ(random.code, 1);
    EXPECT_NE(random.said.find("random"), std::string::npos) << "it says why";
}

TEST(Options, TransitionsAreOfAPathAndGoToAGraph) {
    EXPECT_NE(run({"transitions", "/no/project"}).said.find("--path"), std::string::npos);
    EXPECT_NE(run({"transitions", "/no/project", "--path", "walk", "--out", "t.csv"}).said.find(".svg"),
              std::string::npos);
    EXPECT_EQ(run({"transitions", "/no/project", "--path", "walk", "--size", "wide"}).code, 2);
    EXPECT_EQ(run({"transitions", "/no/project", "--path", "walk"}).code, kTaken);
}

TEST(Options, ACurveIsWrittenAsItsEndingSays) {
    const test::TempDir dir;
    for (const char* ending : {"png", "svg", "csv"}) {
        const auto file = dir / (std::string("noon.") + ending);
        EXPECT_EQ(run({"hardcases", "--curve", "B-1", "--out", file.string()}).code, 0);
        EXPECT_GT(std::filesystem::file_size(file), 2000u) << ending;
    }
    EXPECT_EQ(test::readText(dir / "noon.csv").substr(0, 13), "at,published,");
}

}  // namespace
}  // namespace sward
