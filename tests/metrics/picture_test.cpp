// Pictures that are compared: how files become such, and which pairs are refused.
#include "metrics/picture.h"

#include <cmath>

#include "metrics/pictures.h"

namespace sward::test {
namespace {

TEST(Pictures, RefuseWhatCannotBeCompared) {
    auto sizes = pairPictures(plain(8, 6, glm::vec3(0)), plain(9, 6, glm::vec3(0)));
    ASSERT_FALSE(sizes);
    EXPECT_EQ(sizes.error().code, ExitCode::Failed);
    EXPECT_NE(sizes.error().message.find("8x6 and 9x6"), std::string::npos);
    auto none = pairPictures(plain(8, 6, glm::vec3(kNoValue)), plain(8, 6, glm::vec3(0)));
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ExitCode::Failed);
    Picture linear = plain(8, 6, glm::vec3(0));
    linear.linear = true;
    EXPECT_EQ(pairPictures(linear, plain(8, 6, glm::vec3(0))).error().code, ExitCode::Unsound);
    EXPECT_FALSE(pairPictures(plain(8, 6, glm::vec3(0)), plain(8, 6, glm::vec3(0)), std::vector<float>(48, 0)));
}

TEST(Pictures, ToneMapLinearImagesFirst) {
    const Image exr{1, 1, 3, true, {4, 4, 4}};
    EXPECT_LE(pictureOf(exr, false).pixels[0].x, 1);
    EXPECT_GT(pictureOf(exr, false).pixels[0].x, 0.9);
    EXPECT_EQ(pictureOf(exr, true).pixels[0].x, 4);
    EXPECT_TRUE(std::isnan(pictureOf({1, 1, 3, true, {1, kNoValue, 1}}, false).pixels[0].x))
        << "not black by tone mapping";
}

}  // namespace
}  // namespace sward::test
