// The effect map in the editor: a program beside it measures, its lines come into the tab, a click turns one off.
#include "app/effect_run.h"

#include "editor/editor_fixture.h"
#include "maps/map_io.h"

namespace sward::test {
namespace {

// In the place of `sward effects`: puts what it is to have measured where it is told to.
constexpr const char* kProgram =
    "#!/bin/sh\necho \"$@\" > \"$0.args\"\nfor out; do :; done\nmkdir -p \"$out\"\ncp -r \"$0.result/.\" \"$out\"\n";

std::string resultFor(const std::string& camera) {
    return R"({"cameras": [{"camera": ")" + camera + R"(", "effects": [
        {"effect": "grass-clumps", "changed_pixels": 0, "changed_share": 0, "greatest_change_255": 1, "costs_unseen": true,
         "cost_ms": {"median": 1.5, "low": 1, "high": 2, "confidence": 0.984, "pairs": 7}, "picture": "clumps.png",
         "off": [{"path": "lawn.GrassField.species[lawn].clumpStrength", "told": "clumps = 0"}]},
        {"effect": "sky", "changed_pixels": 900, "changed_share": 0.9, "greatest_change_255": 99, "costs_unseen": false,
         "cost_ms": {"median": 4, "low": 3, "high": 5, "confidence": 0.984, "pairs": 7}, "off": []}]}]})";
}

class EffectRunEditor : public EditorFixture {
  protected:
    void SetUp() override {
        EditorFixture::SetUp();
        setenv("XDG_STATE_HOME", (dir / "state").c_str(), 1);
        const std::filesystem::path program = dir / "effects";
        writeText(program, kProgram);
        std::filesystem::permissions(program, std::filesystem::perms::owner_all);
        writeText(dir / "effects.result/effects.json", resultFor(accuracyCamera(doc, app->view.camera)));
        ASSERT_TRUE(writeImagePng(dir / "effects.result/clumps.png", 4, 3, 3, std::vector<uint8_t>(36, 77)));
        app->effects.program = program.string();
        app->layout.tab = "Effects";
        ok(ui->wait(3));
    }
    void TearDown() override {
        unsetenv("XDG_STATE_HOME");
        EditorFixture::TearDown();
    }
    void measure() {
        ok(ui->click("Effects/Measure"));
        waitUntil([&] { return !app->effects.running() && !app->effects.effects.empty(); });
        ok(ui->wait(3));
    }
};

TEST_F(EffectRunEditor, AClickTurnsOffWhatCostsUnseenAndOneUndoBringsItBack) {
    measure();
    EXPECT_EQ(app->effects.error, "");
    EXPECT_EQ(get("Effects/grass-clumps/Changes"), "0 pixels");
    EXPECT_EQ(get("Effects/grass-clumps/Cost"), "1.5 ms (1.0 to 2.0)");
    EXPECT_EQ(get("Effects/sky/Changes"), "90.0 %");
    EXPECT_EQ(app->effects.picture.width, 4) << "where the first one changes pixels";
    EXPECT_NE(app->messages.status.find("2 effects measured, 1 of them unseen"), std::string::npos)
        << app->messages.status;
    const std::string strength = "lawn.GrassField.species[lawn].clumpStrength", before = field(strength);
    ASSERT_NE(before, "0");
    ok(ui->click("Effects/grass-clumps/Turn Off"));
    ok(ui->wait(2));
    EXPECT_EQ(field(strength), "0");
    EXPECT_EQ(doc.stepsDone(), 1u);
    EXPECT_FALSE(ui->exists("Effects/grass-clumps/Turn Off")) << "it is off";
    EXPECT_TRUE(ui->exists("Effects/sky/Turn Off"));
    EXPECT_NE(get("Effects/State").find("has changed since"), std::string::npos);
    ok(ui->key("ctrl+z"));
    ok(ui->wait(2));
    EXPECT_EQ(field(strength), before);
    EXPECT_FALSE(doc.canUndo());
    EXPECT_TRUE(ui->exists("Effects/grass-clumps/Turn Off"));
}

TEST_F(EffectRunEditor, ItMeasuresTheShownViewAtTheViewportsSizeAndSaysWhyItFails) {
    measure();
    const std::string args = readText(dir / "effects.args"), camera = accuracyCamera(doc, app->view.camera);
    const glm::ivec2 size = app->effects.size;
    EXPECT_NE(args.find("--camera " + camera), std::string::npos) << args;
    EXPECT_NE(args.find("--size " + std::to_string(size.x) + "x" + std::to_string(size.y)), std::string::npos) << args;
    EXPECT_LE(size.x, app->hand.rect.w);
    app->effects.program = "/bin/false";
    ok(ui->click("Effects/Measure"));
    waitUntil([&] { return !app->effects.running(); });
    EXPECT_NE(app->effects.error.find("exit code 1"), std::string::npos) << app->effects.error;
    EXPECT_TRUE(app->effects.effects.empty());
}

TEST_F(EffectRunEditor, StopEndsTheProgramAndAnotherProjectDropsWhatWasMeasured) {
    measure();
    ASSERT_FALSE(app->effects.effects.empty());
    const std::filesystem::path slow = dir / "slow";
    writeText(slow, "#!/bin/sh\nexec sleep 600\n");
    std::filesystem::permissions(slow, std::filesystem::perms::owner_all);
    app->effects.program = slow.string();
    ok(ui->click("Effects/Measure"));
    EXPECT_TRUE(app->effects.running());
    ok(ui->click("Effects/Stop"));
    EXPECT_FALSE(app->effects.running());
    EXPECT_TRUE(app->effects.copy.empty());
    ASSERT_TRUE(doc.create(dir / "other"));
    ok(ui->wait(3));
    EXPECT_TRUE(app->effects.dir.empty());
}

TEST(EffectRun, ASoftwareRendererMeasuresSmallerPictures) {
    EXPECT_EQ(effectSize(1200, 800, false), glm::ivec2(1200, 800));
    EXPECT_EQ(effectSize(1200, 800, true), glm::ivec2(300, 200));
    EXPECT_EQ(effectSize(320, 2, true), glm::ivec2(320, 2));
    EXPECT_EQ(effectSize(0, -3, true), glm::ivec2(1, 1));
}

}  // namespace
}  // namespace sward::test
