// `sward effects`: its table, its JSON, its files, and what it refuses.
#include "cli/cli.h"
#include "core/json.h"
#include "cost/effect_files.h"
#include "project/project_files.h"
#include "scenes.h"
#include "support.h"

namespace sward::test {
namespace {

struct Said {
    int code = 0;
    std::string out;
};
Said run(std::vector<std::string> args) {
    args.insert(args.begin(), "sward");
    std::vector<char*> argv;
    for (std::string& a : args) argv.push_back(a.data());
    testing::internal::CaptureStdout();
    const int code = runCommandLine(static_cast<int>(argv.size()), argv.data());
    return {code, testing::internal::GetCapturedStdout()};
}

struct EffectsVerb : testing::Test {
    TempDir dir;
    std::string project = (dir / "lawn").string();
    void save(const std::function<void(Project&)>& change) {
        Project p = lawn();
        p.dir = project;
        put(p, "eye", Camera{{2, 1.7, 2}, {10, 0, 10}});
        change(p);
        std::filesystem::create_directories(p.dir);
        const auto saved = saveProject(p, tables().components);
        ASSERT_TRUE(saved) << saved.error().text();
    }
};

TEST_F(EffectsVerb, WritesAMapAndAPictureAnEffect) {
    save([](Project&) {});
    const std::string out = (dir / "out").string();
    const Said said = run({"effects", project, "--size", "48x36", "--msaa", "1", "--pairs", "1", "--out", out, "--json",
                           "--set", "haze.Fog.visibility=20"});
    ASSERT_EQ(said.code, 0);
    EXPECT_EQ(readText(dir / "out/effects.json"), said.out) << "the same on paper and on the screen";
    const auto json = parseJson(said.out, "effects");
    ASSERT_TRUE(json) << json.error().text();
    EXPECT_EQ(json->find("seen_change_255")->number, kSeenChange);
    const auto lines = effectsFrom(*json, "eye");
    ASSERT_TRUE(lines) << lines.error().text();
    size_t fogs = 0;
    for (const EffectLine& e : *lines) {
        EXPECT_EQ(e.error, "");
        EXPECT_EQ(e.ms.pairs, 1);
        EXPECT_TRUE(std::filesystem::exists(dir / "out" / e.picture)) << e.picture;
        fogs += e.feature == Feature::Fog && e.share > 0.3;
    }
    EXPECT_EQ(fogs, 1u) << "the override holds";
    EXPECT_TRUE(std::filesystem::exists(dir / "out/eye/scene.png"));
}

TEST_F(EffectsVerb, PrintsATableAndRefusesWhatItDoesNotUnderstand) {
    save([](Project& p) { removeEntity(p, "grass"); });  // a shorter table
    const Said said = run({"effects", project, "--size", "32x24", "--msaa", "1", "--pairs", "1"});
    ASSERT_EQ(said.code, 0);
    EXPECT_NE(said.out.find("haze.Fog.visibility = inf"), std::string::npos) << said.out;
    EXPECT_EQ(run({"effects", project, "--camera", "nobody"}).code, 2);
    EXPECT_EQ(run({"effects", project, "--pairs", "0"}).code, 2);
    EXPECT_EQ(run({"effects", project, "--size", "big"}).code, 2);
    EXPECT_EQ(run({"effects", (dir / "none").string()}).code, 3);
}

}  // namespace
}  // namespace sward::test
