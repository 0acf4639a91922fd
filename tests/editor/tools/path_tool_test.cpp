#include "tools/path_tool.h"

#include <gtest/gtest.h>

#include "project/project_json.h"

namespace sward {
namespace {

GroundPath line() {
    GroundPath p;
    p.points = {{"", {0, 0}}, {"", {4, 0}}, {"", {8, 0}}};
    return p;
}

TEST(PathTool, APathGoesOnAtTheEndThatIsChosen) {
    EXPECT_EQ(nextPoint(line(), std::nullopt), 3u);
    EXPECT_EQ(nextPoint(line(), 2), 3u);
    EXPECT_EQ(nextPoint(line(), 1), 3u);
    EXPECT_EQ(nextPoint(line(), 0), 0u) << "before its beginning";
    GroundPath closed = line();
    closed.closed = true;
    EXPECT_EQ(nextPoint(closed, 0), 3u) << "a closed one has no beginning";
    GroundPath one;
    one.points = {{"", {0, 0}}};
    EXPECT_EQ(nextPoint(one, 0), 1u);
}
TEST(PathTool, PointsComeAndGoWhereTheyAreMeant) {
    const GroundPath more = withPoint(line(), 1, {2.00049, 1.23456});
    ASSERT_EQ(more.points.size(), 4u);
    EXPECT_EQ(more.points[1].at, glm::dvec2(2, 1.235)) << "to the millimetre";
    EXPECT_EQ(withoutPoint(more, 1), line());
    EXPECT_EQ(chosenAfterRemoval(line(), 2), 1u);
    EXPECT_EQ(chosenAfterRemoval(line(), 0), 0u);
    EXPECT_EQ(chosenAfterRemoval({}, 0), std::nullopt);
}
TEST(PathTool, APathFitsIntoAProjectFile) { EXPECT_LE(kMostPathPoints, kMaxListElements); }

}  // namespace
}  // namespace sward
