// The accuracy panel's logic: passes summed, settings adopted, results read, programs beside the editor.
#include "editor/accuracy/accuracy.h"

#include <gtest/gtest.h>

#include <chrono>
#include <random>
#include <thread>

#include "core/file.h"
#include "editor/model/document.h"
#include "editor/tools/brush_cost.h"
#include "support.h"
#include "techniques.h"

namespace sward {
namespace {

Truth passOf(std::mt19937& random) {
    Truth t{3, 2, std::vector<float>(18), std::vector<float>(18), std::vector<float>(6)};
    for (float& v : t.color) v = std::uniform_real_distribution<float>(0, 4)(random);
    for (float& v : t.grass) v = random() % 2 ? 1.0f : 0.0f;
    return t;
}

TEST(Accuracy, PassesSummedAreTheirMeanAndItsStandardError) {
    std::mt19937 random(3);
    PassSum sum;
    std::vector<Truth> passes;
    for (int i = 0; i < 24; ++i) passes.push_back(passOf(random)), addPass(sum, passes.back());
    const Truth mean = meanOf(sum);
    ASSERT_EQ(mean.color.size(), 18u);
    double errors = 0;
    for (size_t p = 0; p < 18; ++p) {
        double m = 0, squares = 0;
        for (const Truth& t : passes) m += static_cast<double>(t.color[p]) / 24;
        for (const Truth& t : passes)
            squares += (static_cast<double>(t.color[p]) - m) * (static_cast<double>(t.color[p]) - m);
        EXPECT_NEAR(mean.color[p], m, 1e-5);
        EXPECT_NEAR(mean.error[p], std::sqrt(squares / 23 / 24), 1e-5);
        errors += std::sqrt(squares / 23 / 24) / 18;
    }
    EXPECT_NEAR(meanError(mean), errors, 1e-5);
    double grass = 0;
    for (const Truth& t : passes) grass += static_cast<double>(t.grass[4]) / 24;
    EXPECT_NEAR(mean.grass[4], grass, 1e-6);
}

TEST(Accuracy, OnePassHasNoKnownError) {
    std::mt19937 random(4);
    PassSum sum;
    addPass(sum, passOf(random));
    EXPECT_TRUE(std::isinf(meanOf(sum).error[0]));
    EXPECT_TRUE(std::isfinite(meanOf(sum).color[0]));
}

TEST(Accuracy, TheReferenceIsNoWiderThanItMayBe) {
    EXPECT_EQ(comparisonSize(480, 300), glm::ivec2(480, 300));
    EXPECT_EQ(comparisonSize(482, 300), glm::ivec2(241, 150));
    EXPECT_EQ(comparisonSize(1900, 3), glm::ivec2(475, 1));
    EXPECT_EQ(comparisonSize(1, 1), glm::ivec2(1, 1));
}

TEST(Accuracy, AdoptingIsOneUndoStepAndNamesWhatIsTheViews) {
    test::TempDir dir;
    Document doc(tables());
    ASSERT_TRUE(doc.create(dir / "p"));
    const auto value = [&](const char* name) {
        return fieldText(*findField(doc.project(), doc.tables().components, std::string("lawn.GrassField.") + name));
    };
    const std::string before = value("maxGeom");
    const CostSetting wanted = settingOf("slices", "minGeom=3 maxGeom=7 minBTF=9 maxBTF=18 msaa=1");
    EXPECT_FALSE(isPresent(doc, wanted));
    const auto left = adoptSettings(doc, wanted);
    ASSERT_TRUE(left);
    EXPECT_EQ(*left, std::vector<std::string>{"msaa=1"});
    EXPECT_EQ(value("technique"), "slices");
    EXPECT_EQ(value("maxGeom"), "7");
    EXPECT_EQ(value("maxBTF"), "18");
    EXPECT_EQ(doc.undoLabel(), "adopt settings");
    EXPECT_FALSE(isPresent(doc, wanted)) << "one sample is not what the editor draws";
    EXPECT_TRUE(isPresent(doc, settingOf("slices", "maxGeom=7 msaa=4")));
    ASSERT_TRUE(doc.undo());
    EXPECT_EQ(value("maxGeom"), before);
    EXPECT_EQ(value("technique"), "hybrid");
    EXPECT_FALSE(doc.canUndo());
}

TEST(Accuracy, SettingsThatDoNotExistChangeNothing) {
    test::TempDir dir;
    Document doc(tables());
    ASSERT_TRUE(doc.create(dir / "p"));
    EXPECT_FALSE(adoptSettings(doc, settingOf("slices", "maxGeom=7 nonsense=1")));
    EXPECT_FALSE(doc.canUndo());
    EXPECT_EQ(techniqueShown(doc), "hybrid");
    EXPECT_TRUE(settingOf("flat", "as it is").values.empty());
}

TEST(Accuracy, AFitIsReadWithWhatItGivesUp) {
    const auto fit = fitFrom(
        R"({"budget_ms": 8, "fits": true, "tried": 20, "best": {"ms": 7.5, "appearance": 0.02, "settings": "maxGeom=6"},
        "shipped": {"ms": 12, "appearance": 0.015, "settings": "maxGeom=12"}, "next_better": {"ms": 9, "appearance": 0.018, "settings": "maxGeom=8"}, "grid": null})");
    ASSERT_TRUE(fit) << fit.error().text();
    EXPECT_TRUE(fit->fits);
    EXPECT_EQ(fit->ms, 7.5);
    EXPECT_EQ(fit->settings, "maxGeom=6");
    EXPECT_EQ(fit->shippedMs, 12);
    EXPECT_EQ(fit->better, "9 ms for 0.0180: maxGeom=8");
    EXPECT_FALSE(fitFrom("{\"fits\": true}"));
    EXPECT_FALSE(fitFrom(""));
}

TEST(BrushCost, BladesUnderABrushAreThoseOfTheTexelsInItsDisc) {
    Map density({200, 160, 1, PixelType::U8});
    std::mt19937 random(9);
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x < 200; ++x) density.set(x, y, 0, static_cast<float>(random() % 256) / 255.0f);
    const MapScale scale{50, 40, false};  // texels of a quarter metre
    for (const auto& [cx, cz, radius] :
         {std::tuple{20.0, 15.0, 3.0}, {0.5, 39.0, 2.5}, {-1.0, 5.0, 0.5}, {25.1, 20.2, 0.05}}) {
        double hand = 0;
        for (int y = 0; y < 160; ++y)
            for (int x = 0; x < 200; ++x)
                if (std::hypot((x + 0.5) / 4 - cx, (y + 0.5) / 4 - cz) <= radius)
                    hand += static_cast<double>(density.at(x, y)) * 3000 / 16;
        EXPECT_NEAR(bladesInDisc(density, 3000, scale, cx, cz, radius), hand, 1e-6 * hand + 1e-9);
    }
    Map full({2000, 2000, 1, PixelType::U8});
    for (int y = 0; y < 2000; ++y)
        for (int x = 0; x < 2000; ++x) full.set(x, y, 0, 1);
    const double disc = 3.14159265 * 40 * 40;
    EXPECT_NEAR(bladesInDisc(full, 10, {100, 100, false}, 50, 50, 40), disc * 10, disc * 10 * 0.01) << "sampled";
    EXPECT_NEAR(bladesInDisc(full, 10, {10, 10, true}, 0, 0, 1), 10 * 3.14159265, 0.1) << "across the repeat's edge";
    EXPECT_NEAR(bladesInDisc({}, 10, {100, 100, false}, 50, 50, 40), disc * 10, 1e-3);
}

TEST(BrushCost, AStrokesBladesAreTheDifferenceOfTheMaps) {
    Map before({300, 200, 1, PixelType::U8});
    before.set(5, 5, 0, 1);
    Map now = before;
    now.set(290, 190, 0, 1), now.set(5, 5, 0, 0), now.set(6, 6, 0, 1), now.set(140, 7, 0, 0.6f);
    const MapScale scale{30, 20, false};
    EXPECT_NEAR(bladesAdded(before, now, 1000, scale), 1000 * 0.01 * 1.6, 1e-4);
    EXPECT_NEAR(bladesAdded(now, before, 1000, scale), -1000 * 0.01 * 1.6, 1e-4);
    EXPECT_EQ(bladesAdded(now, now, 1000, scale), 0);
    EXPECT_NEAR(bladesAdded({}, before, 1, {300, 200, false}), 1 - 60000, 1e-6) << "no map is density 1";
}

std::optional<int> ended(ChildProcess& child) {
    for (int i = 0; i < 1000; ++i) {
        if (const auto code = child.poll()) return code;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return {};
}

TEST(Accuracy, AProgramBesideWritesToFilesAndTellsItsEnd) {
    test::TempDir dir;
    auto child = ChildProcess::start({"/bin/sh", "-c", "echo said; echo wrong >&2; exit 3"}, dir / "out", dir / "err");
    ASSERT_TRUE(child) << child.error().text();
    EXPECT_EQ(ended(*child), 3);
    EXPECT_FALSE(child->running());
    EXPECT_EQ(*readFile(dir / "out", 100), "said\n");
    EXPECT_EQ(*readFile(dir / "err", 100), "wrong\n");
    auto missing = ChildProcess::start({"/no/such/program"}, dir / "out", dir / "err");
    ASSERT_TRUE(missing);
    EXPECT_EQ(ended(*missing), 127);
    EXPECT_FALSE(ChildProcess::start({"/bin/true"}, dir / "nowhere" / "out", dir / "err"));
}

TEST(Accuracy, StoppingAProgramEndsWhatItStartedToo) {
    test::TempDir dir;
    auto child = ChildProcess::start(
        {"/bin/sh", "-c",
         "(sleep 0.4; echo late > " + (dir / "late").string() + ") & echo up > " + (dir / "up").string() + "; wait"},
        dir / "out", dir / "err");
    ASSERT_TRUE(child);
    for (int i = 0; i < 1000 && !std::filesystem::exists(dir / "up"); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    child->stop();
    EXPECT_FALSE(child->running());
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    EXPECT_FALSE(std::filesystem::exists(dir / "late"));
}

}  // namespace
}  // namespace sward
