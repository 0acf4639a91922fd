#include "metrics/picture_judge.h"

#include "pictures.h"

namespace sward::test {
namespace {

constexpr int kSide = 40;
Picture gray() { return plain(kSide, kSide, glm::vec3(0.5f)); }

TEST(PictureJudge, EqualPicturesPassWithoutAnyTolerance) {
    AcceptedPicture none;
    none.meanOff = none.pixelOff = none.pixelsOff = none.appearance = 0;
    const PictureVerdict v = judgePicture(pairOf(noise(kSide, kSide, 1), noise(kSide, kSide, 1)), none);
    EXPECT_TRUE(v.pass) << v.why;
    EXPECT_EQ(v.meanOff, 0);
    EXPECT_EQ(v.pixelsOff, 0);
}

TEST(PictureJudge, ALittleEverywhereIsTheMeansFault) {
    AcceptedPicture t;
    t.appearance = 1;
    const Picture brighter = plain(kSide, kSide, glm::vec3(0.5f + 2 / 255.f));
    const PictureVerdict v = judgePicture(pairOf(brighter, gray()), t);
    EXPECT_FALSE(v.pass);
    EXPECT_NEAR(v.meanOff, 2, 1e-3);
    EXPECT_EQ(v.pixelsOff, 0);
    EXPECT_NE(v.why.find("mean off"), std::string::npos) << v.why;
    t.meanOff = 2.1f;
    EXPECT_TRUE(judgePicture(pairOf(brighter, gray()), t).pass);
}

TEST(PictureJudge, MuchInFewPixelsIsCounted) {
    AcceptedPicture t;
    t.meanOff = 255, t.appearance = 1;
    Picture p = gray();
    for (int i = 0; i < 32; ++i) p.pixels[static_cast<size_t>(i) * 50].y = 1;  // 32 of 1600: 2 %
    EXPECT_NEAR(judgePicture(pairOf(p, gray()), t).pixelsOff, 2, 1e-9);
    EXPECT_FALSE(judgePicture(pairOf(p, gray()), t).pass);
    t.pixelsOff = 2;
    EXPECT_TRUE(judgePicture(pairOf(p, gray()), t).pass);
    t.pixelsOff = 1, t.pixelOff = 128;
    EXPECT_TRUE(judgePicture(pairOf(p, gray()), t).pass);
}

TEST(PictureJudge, OtherBladesOfTheSameKindPassWherePixelsMayDiffer) {
    AcceptedPicture t;
    t.meanOff = t.pixelOff = 255, t.appearance = 0.15f;
    EXPECT_TRUE(judgePicture(pairOf(noise(kSide, kSide, 1), noise(kSide, kSide, 2)), t).pass);
    const PictureVerdict paler = judgePicture(pairOf(noise(kSide, kSide, 1, 0.4f, 0.3f), noise(kSide, kSide, 2)), t);
    EXPECT_FALSE(paler.pass);
    EXPECT_NE(paler.why.find("appearance"), std::string::npos) << paler.why;
}

TEST(PictureJudge, APixelThatIsNotFiniteNeverPasses) {
    AcceptedPicture t;
    t.meanOff = t.pixelOff = 255, t.pixelsOff = 100, t.appearance = 1;
    Picture p = gray();
    p.pixels[7].x = kNoValue;
    const PictureVerdict v = judgePicture(pairOf(p, gray()), t);
    EXPECT_FALSE(v.pass);
    EXPECT_NE(v.why.find("not finite"), std::string::npos) << v.why;
}

}  // namespace
}  // namespace sward::test
