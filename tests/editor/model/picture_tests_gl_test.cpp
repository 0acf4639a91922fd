// Accepted pictures on a new project, through the document and through the command line.
#include "model/picture_tests.h"

#include "cli/cli.h"
#include "project/project_files.h"
#include "scenes.h"
#include "support.h"

namespace sward::test {
namespace {

namespace fs = std::filesystem;

class PictureTests : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(doc.create(dir / "meadow"));
        ASSERT_TRUE(doc.setField("lawn.GrassField.species[lawn].bladesPerM2", "100"));  // pictures are quicker
        camera = picturesCamera();
        renderer = std::make_unique<Renderer>(gpu(), tables());
    }
    std::string picturesCamera() {
        for (const auto& [name, e] : doc.project().entities)
            if (doc.project().registry.get<Camera>(e)) return name;
        return {};
    }
    std::string accepted(PictureWish wish = {{{96, 64}}, {}}) {
        const auto file = acceptPicture(doc, *renderer, gpu(), camera, wish);
        EXPECT_TRUE(file) << (file ? "" : file.error().text());
        return file ? *file : "";
    }
    PictureResult check() { return checkPicture(*renderer, gpu(), doc.project(), camera); }
    void change() { ASSERT_TRUE(doc.setField(camera + ".Camera.fovDeg", "70")); }

    NoGlErrors errors;
    TempDir dir;
    Document doc{tables()};
    std::string camera;
    std::unique_ptr<Renderer> renderer;
    std::string said;  // by the command line
};

TEST_F(PictureTests, WhatWasAcceptedPassesUntilTheSceneLooksDifferent) {
    const std::string file = accepted();
    EXPECT_TRUE(fs::exists(doc.project().dir / file));
    EXPECT_EQ(picturesOf(doc.project()), std::vector<std::string>{camera});
    const PictureResult same = check();
    EXPECT_TRUE(same.pass()) << resultText(same);
    EXPECT_EQ(same.now.width, 96);
    EXPECT_EQ(same.verdict.meanOff, 0);
    change();
    const PictureResult other = check();
    EXPECT_FALSE(other.pass());
    EXPECT_NE(resultText(other).find("differs: mean off"), std::string::npos) << resultText(other);
    EXPECT_EQ(differencePicture(other).size(), size_t(96 * 64 * 3));
}

TEST_F(PictureTests, AcceptingIsOneStepAndUndoBringsTheFormerPicture) {
    const std::string first = accepted();
    change();
    const size_t steps = doc.stepsDone();
    const std::string second = accepted();
    EXPECT_NE(first, second);
    EXPECT_EQ(doc.stepsDone(), steps + 1);
    EXPECT_TRUE(check().pass());
    ASSERT_TRUE(doc.undo());
    EXPECT_EQ(acceptedPicture(doc.project(), camera)->file, first);
    EXPECT_FALSE(check().pass());
    ASSERT_TRUE(doc.undo());  // of the change
    EXPECT_TRUE(check().pass());
}

TEST_F(PictureTests, TheSamePictureIsNoStep) {
    const std::string first = accepted();
    const size_t steps = doc.stepsDone();
    EXPECT_EQ(accepted({}), first);
    EXPECT_EQ(doc.stepsDone(), steps);
}

TEST_F(PictureTests, FilesThatNothingNamesAreDroppedAndOthersStay) {
    const std::string first = accepted();
    change();
    const std::string second = accepted();
    writeText(doc.project().dir / "pictures/notes.png", "mine");
    writeText(doc.project().dir / "pictures/photo.12345.png", "mine");
    EXPECT_EQ(dropOldPictures(doc.project()), std::vector<std::string>{first});
    EXPECT_TRUE(fs::exists(doc.project().dir / second));
    EXPECT_TRUE(fs::exists(doc.project().dir / "pictures/notes.png"));
    EXPECT_TRUE(fs::exists(doc.project().dir / "pictures/photo.12345.png"));
}

TEST_F(PictureTests, AnotherSizeThanTheFilesIsToldOf) {
    accepted();
    ASSERT_TRUE(doc.setField(camera + ".AcceptedPicture.width", "80"));
    EXPECT_FALSE(check().pass());
    EXPECT_NE(resultText(check()).find("96x64, the camera asks for 80x64"), std::string::npos) << resultText(check());
}

TEST_F(PictureTests, ACopyTakesItsPicturesAlong) {
    const std::string file = accepted();
    ASSERT_TRUE(doc.saveAs(dir / "copy"));
    EXPECT_TRUE(fs::exists(dir / "copy" / file));
}

TEST_F(PictureTests, TheCommandLineKeepsItsExitCodes) {
    ASSERT_TRUE(doc.save());
    const std::string project = doc.project().dir.string(), out = (dir / "out").string();
    const auto run = [&](std::vector<std::string> more) {
        std::vector<std::string> args{"sward", "check", project, "--pictures"};
        args.insert(args.end(), more.begin(), more.end());
        std::vector<char*> argv;
        for (std::string& a : args) argv.push_back(a.data());
        testing::internal::CaptureStdout();
        testing::internal::CaptureStderr();
        const int code = runCommandLine(static_cast<int>(argv.size()), argv.data());
        said = testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr();
        gpu();  // the context is this test's again
        return code;
    };
    EXPECT_EQ(run({}), 1) << said;  // nothing is accepted yet
    EXPECT_EQ(run({"--size", "96x64"}), 2) << said;
    EXPECT_EQ(run({"--strict"}), 2) << said;
    EXPECT_EQ(run({"--accept", "--size", "96x64", "--camera", "nobody"}), 2) << said;
    EXPECT_EQ(run({"--accept", "--size", "96x64"}), 0) << said;
    EXPECT_EQ(run({"--out", out}), 0) << said;
    EXPECT_FALSE(fs::exists(out));
    ASSERT_TRUE(doc.open(project));
    change();
    ASSERT_TRUE(doc.save());
    EXPECT_EQ(run({"--out", out}), 1) << said;
    EXPECT_NE(said.find("0 of 1 pictures as accepted"), std::string::npos) << said;
    for (const char* kind : {".png", ".accepted.png", ".difference.png"})
        EXPECT_TRUE(fs::exists(out + "/" + camera + kind)) << kind;
    const std::string file = acceptedPicture(doc.project(), camera)->file;
    EXPECT_EQ(run({"--accept"}), 0) << said;
    EXPECT_NE(said.find("removed " + file), std::string::npos) << said;
    EXPECT_EQ(run({"--json"}), 0) << said;
    fs::remove_all(doc.project().dir / "pictures");
    EXPECT_EQ(run({}), 3) << said;
}

}  // namespace
}  // namespace sward::test
