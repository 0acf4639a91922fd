// `sward compare`: exit codes, messages, files.
#include <gtest/gtest.h>

#include <random>

#include "cli/cli.h"
#include "core/json.h"
#include "core/log.h"
#include "maps/map_io.h"
#include "support.h"

namespace sward::test {
namespace {

struct Compared {
    int code = 0;
    std::string out, log;
};
Compared runCompare(std::vector<std::string> args) {
    args.insert(args.begin(), "sward");
    std::vector<char*> argv;
    for (std::string& a : args) argv.push_back(a.data());
    Compared said;
    const int sink = addLogSink([&](LogLevel, const std::string& text) { said.log += text + "\n"; });
    testing::internal::CaptureStdout();
    said.code = runCommandLine(static_cast<int>(argv.size()), argv.data());
    said.out = testing::internal::GetCapturedStdout();
    removeLogSink(sink);
    return said;
}

struct CompareVerb : testing::Test {
    TempDir dir;
    std::string png(const std::string& name, int width, int height, uint8_t value, int channels = 3) {
        EXPECT_TRUE(writeImagePng(dir / name, width, height, channels,
                                  std::vector<uint8_t>(static_cast<size_t>(width * height * channels), value)));
        return (dir / name).string();
    }
    std::string exr(const std::string& name, const std::vector<float>& rgb) {
        EXPECT_TRUE(writeImageExr(dir / name, 20, 20, 3, rgb));
        return (dir / name).string();
    }
};

TEST_F(CompareVerb, PrintsAllMetricsAsJson) {
    const Compared said = runCompare({"compare", png("a.png", 20, 20, 153), png("b.png", 20, 20, 102), "--json"});
    EXPECT_EQ(said.code, 0);
    auto j = parseJson(said.out, "compare");
    ASSERT_TRUE(j) << said.out;
    EXPECT_NEAR(j->find("rmse")->number, 0.2, 1e-6);
    EXPECT_NEAR(j->find("appearance")->number, 0.2, 1e-6);
    for (const char* key : {"appearance_sigma", "bias", "contrast", "flip", "ssim", "psnr", "ppd", "non_finite"})
        EXPECT_TRUE(j->find(key)) << key;
}
TEST_F(CompareVerb, NamesBothSizesThatDiffer) {
    const Compared said = runCompare({"compare", png("a.png", 20, 20, 1), png("b.png", 30, 10, 1)});
    EXPECT_EQ(said.code, 1);
    EXPECT_NE(said.log.find("20x20 and 30x10"), std::string::npos) << said.log;
}
// A truth that scatters by a twentieth of full light, against the even picture that it is of.
TEST_F(CompareVerb, TakesTheScatterOfRaysOffWhereItIsBesideThePicture) {
    std::vector<float> rgb, error(20 * 20 * 3, 0.05f);
    std::mt19937 random(1);
    std::normal_distribution<float> scatter(0.3f, 0.05f);
    for (int i = 0; i < 20 * 20; ++i) {
        const float v = scatter(random);
        for (int k = 0; k < 3; ++k) rgb.push_back(v);
    }
    const std::string even = exr("even.exr", std::vector<float>(20 * 20 * 3, 0.3f)), truth = exr("truth.exr", rgb);
    const auto appearanceNow = [&] {
        const auto j = parseJson(runCompare({"compare", even, truth, "--json"}).out, "compare");
        return std::pair(j->find("appearance")->number, j->find("truth_noise")->isNumber());
    };
    const auto [unknown, toldThen] = appearanceNow();
    exr("truth.error.exr", error);
    const auto [known, told] = appearanceNow();
    EXPECT_FALSE(toldThen);
    EXPECT_TRUE(told);
    EXPECT_LT(known, 0.5 * unknown);
    EXPECT_NE(runCompare({"compare", even, truth}).out.find("of the truth's rays"), std::string::npos);
    EXPECT_TRUE(writeImageExr(dir / "truth.error.exr", 10, 40, 3, error));
    const Compared said = runCompare({"compare", even, truth});
    EXPECT_EQ(said.code, 3);
    EXPECT_NE(said.log.find("10x40 standard errors of 20x20 pixels"), std::string::npos) << said.log;
}
TEST_F(CompareVerb, RefusesOtherKindsAndWhatItCannotRead) {
    EXPECT_EQ(runCompare({"compare", png("a.png", 20, 20, 1, 1), png("b.png", 20, 20, 1, 3)}).code, 3);
    writeText(dir / "broken.png", "no image");
    EXPECT_EQ(runCompare({"compare", png("a.png", 20, 20, 1), (dir / "broken.png").string()}).code, 3);
    EXPECT_EQ(
        runCompare({"compare", exr("c.exr", std::vector<float>(1200, 1)), png("a.png", 20, 20, 1), "--linear"}).code,
        3);
    EXPECT_EQ(runCompare({"compare", png("a.png", 20, 20, 1), png("b.png", 20, 20, 1), "--metric", "taste"}).code, 2);
    EXPECT_EQ(runCompare({"compare", png("a.png", 20, 20, 1), png("b.png", 20, 20, 1), "--ppd", "0"}).code, 2);
    EXPECT_EQ(
        runCompare({"compare", png("a.png", 20, 20, 1), png("b.png", 20, 20, 1), "--heatmap", (dir / "h.jpg").string()})
            .code,
        2);
}
TEST_F(CompareVerb, FailsWhereAPictureIsNotThere) {
    const std::string there = png("a.png", 20, 20, 1), gone = (dir / "none.png").string();
    for (const auto& [a, b] : {std::pair(there, gone), std::pair(gone, there)}) {
        const Compared said = runCompare({"compare", a, b});
        EXPECT_EQ(said.code, 1);
        EXPECT_NE(said.log.find("none.png: does not exist"), std::string::npos) << said.log;
    }
    EXPECT_EQ(runCompare({"compare", there, there, "--mask", gone}).code, 1);
}
TEST_F(CompareVerb, IgnoresAlpha) {
    std::vector<uint8_t> rgba;
    for (int i = 0; i < 400; ++i) rgba.insert(rgba.end(), {90, 90, 90, 7});
    ASSERT_TRUE(writeImagePng(dir / "alpha.png", 20, 20, 4, rgba));
    const Compared said = runCompare({"compare", png("a.png", 20, 20, 90), (dir / "alpha.png").string(), "--json"});
    EXPECT_EQ(parseJson(said.out, "")->find("psnr")->text, "inf");
}
TEST_F(CompareVerb, ToneMapsExrUnlessTold) {
    const std::string a = exr("a.exr", std::vector<float>(1200, 2)), b = exr("b.exr", std::vector<float>(1200, 4));
    EXPECT_LT(parseJson(runCompare({"compare", a, b, "--json"}).out, "")->find("rmse")->number, 0.1);
    EXPECT_NEAR(parseJson(runCompare({"compare", a, b, "--json", "--linear"}).out, "")->find("rmse")->number, 2, 1e-6);
}
TEST_F(CompareVerb, TellsOfPixelsThatAreNotFinite) {
    std::vector<float> bad(1200, 0.25f);
    bad[3 * (5 * 20 + 4)] = std::numeric_limits<float>::quiet_NaN();
    const Compared said =
        runCompare({"compare", exr("a.exr", bad), exr("b.exr", std::vector<float>(1200, 0.25f)), "--json"});
    EXPECT_EQ(said.code, 0);
    EXPECT_NE(said.log.find("1 pixels are not finite and were left out; the first at 4,5"), std::string::npos)
        << said.log;
    EXPECT_EQ(parseJson(said.out, "")->find("non_finite")->number, 1);
}
TEST_F(CompareVerb, WeighsByAMaskAndDrawsTheErrors) {
    std::vector<uint8_t> half(400, 0), image(1200, 100);
    for (size_t i = 0; i < 400; ++i)
        if (i % 20 < 10)
            half[i] = 255;
        else
            image[3 * i] = image[3 * i + 1] = image[3 * i + 2] = 200;
    ASSERT_TRUE(writeImagePng(dir / "mask.png", 20, 20, 1, half));
    ASSERT_TRUE(writeImagePng(dir / "a.png", 20, 20, 3, image));
    const std::string a = (dir / "a.png").string(), b = png("b.png", 20, 20, 100), heat = (dir / "heat.png").string();
    EXPECT_GT(parseJson(runCompare({"compare", a, b, "--json"}).out, "")->find("rmse")->number, 0.2);
    EXPECT_EQ(parseJson(runCompare({"compare", a, b, "--json", "--mask", (dir / "mask.png").string()}).out, "")
                  ->find("rmse")
                  ->number,
              0);
    EXPECT_EQ(runCompare({"compare", a, b, "--heatmap", heat, "--metric", "rmse"}).code, 0);
    auto map = readImage(heat);
    ASSERT_TRUE(map);
    EXPECT_EQ(map->width, 20);
    EXPECT_GT(map->pixels[3 * 15], map->pixels[3 * 5] + 0.5) << "right half differs";
    EXPECT_EQ(runCompare({"compare", a, b, "--mask", png("small.png", 5, 5, 255)}).code, 1);
}

// --- films
struct CompareFilms : CompareVerb {
    // Pictures of even grey: film(name, {1, 2}) has two.
    std::string film(const std::string& name, const std::vector<uint8_t>& values, int width = 16) {
        std::filesystem::create_directories(dir / name);
        for (size_t i = 0; i < values.size(); ++i)
            png(fmt::format("{}/frame_{:04d}.png", name, i), width, 16, values[i]);
        return (dir / name).string();
    }
};
TEST_F(CompareFilms, TellWhatPopsAndWhere) {
    const std::string truth = film("truth", {100, 100, 100, 100}), drawn = film("drawn", {120, 120, 171, 171});
    writeText(dir / "truth/frame_0000.error.exr", "no picture of the film");
    const Compared said = runCompare({"compare", drawn, truth, "--json"});
    ASSERT_EQ(said.code, 0) << said.log;
    const auto j = parseJson(said.out, "compare");
    ASSERT_TRUE(j) << said.out;
    EXPECT_EQ(j->find("pictures")->number, 4);
    EXPECT_NEAR(j->find("popping")->number, 0.2 / 3, 1e-6);
    EXPECT_NEAR(j->find("popping_worst")->number, 0.2, 1e-6);
    EXPECT_EQ(j->find("worst_step")->array[0].text, "frame_0001.png");
    EXPECT_NEAR(j->find("appearance")->number, (2 * 20 + 2 * 71) / 4.0 / 255, 1e-6);
    EXPECT_NE(runCompare({"compare", drawn, truth}).out.find("from frame_0001.png to frame_0002.png"),
              std::string::npos);
}
TEST_F(CompareFilms, RefuseWhatIsNoPairOfFilms) {
    const std::string four = film("four", {1, 2, 3, 4});
    EXPECT_NE(runCompare({"compare", four, film("three", {1, 2, 3})})
                  .log.find("frame_0003.png is in one of both folders alone"),
              std::string::npos);
    EXPECT_EQ(runCompare({"compare", four, film("wide", {1, 2, 3, 4}, 24)}).code, 1);
    EXPECT_EQ(runCompare({"compare", film("a", {1}), film("b", {1})}).code, 1) << "one picture has no step";
    EXPECT_EQ(runCompare({"compare", four, four, "--heatmap", "h.png"}).code, 2);
    EXPECT_EQ(runCompare({"compare", four, (dir / "four/frame_0000.png").string()}).code, 3);
}

}  // namespace
}  // namespace sward::test
