// Of what pictures are taken: a share of a film.
#include <gtest/gtest.h>

#include "cli/cli.h"
#include "scenes.h"

namespace sward::test {
namespace {

TEST(Shots, AFilmBeginsWithTheFrameThatIsAskedFor) {
    Project p;
    CameraPath path;
    path.keys.resize(2);
    path.keys[1].seconds = 4;
    put(p, "way", path);
    RenderOptions o;
    o.path = "way", o.fps = 2;
    ASSERT_TRUE(shotNames(o, p));
    EXPECT_EQ(o.frames, 9) << "both ends";
    o.frames = 0, o.first = 6;
    ASSERT_TRUE(shotNames(o, p));
    EXPECT_EQ(o.frames, 3) << "6, 7 and 8";
    o.frames = 0, o.first = 9;
    const auto none = shotNames(o, p);
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().text().find("no frame 9"), std::string::npos);
}

}  // namespace
}  // namespace sward::test
