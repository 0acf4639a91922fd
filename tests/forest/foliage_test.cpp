// Tables of what leaves send to the eye give what the formulas behind them do, from every side.
#include "forest/foliage.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/tree_shapes.h"

namespace sward {
namespace {

glm::vec3 towards(float elevation, float azimuth) {
    const float e = glm::radians(elevation), a = glm::radians(azimuth);
    return {std::cos(e) * std::cos(a), std::sin(e), std::cos(e) * std::sin(a)};
}

TEST(Foliage, TablesGiveWhatTheFormulasDo) {
    const Facing spruce = facingOf(growTree({.kind = TreeKind::Conifer}));
    EXPECT_GT(seenFrom(spruce, 1), 1.15f) << "its twigs lie rather level, or nothing was tested";
    for (const float height : {90.0f, 38.0f, 5.0f}) {
        const glm::vec3 sun = towards(height, 130);
        const FoliageTable table(spruce, sun);
        for (float elevation = -85; elevation < 90; elevation += 17)
            for (float azimuth = 0; azimuth < 360; azimuth += 23) {
                const glm::vec3 way = towards(elevation, azimuth);
                const FoliageLook look = table.from(way);
                EXPECT_NEAR(look.seen, seenFrom(spruce, way.y), 0.01f);
                EXPECT_NEAR(look.sky, 0.5f + 0.5f * seenRise(spruce, way.y), 0.01f);
                EXPECT_NEAR(look.sun, sentTo(spruce, sun.y, way.y, glm::dot(sun, way)), 0.02f)
                    << elevation << " " << azimuth;
                EXPECT_NEAR(look.passed, passedTo(spruce, sun.y, way.y, glm::dot(sun, way)), 0.02f)
                    << elevation << " " << azimuth;
            }
    }
}

TEST(Foliage, LeavesAloneScatterAndToBothSides) {
    const glm::vec3 color(0.1f, 0.2f, 0.05f);
    const Mesh birch = growTree({.kind = TreeKind::Birch, .leafColor = color, .barkColor = {0.6f, 0.6f, 0.6f}});
    const glm::vec3 seen = leafColor(birch);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c] / color[c], 1, 0.06f) << "tints of leaves, no bark";
    EXPECT_EQ(leafColor(Mesh{}), glm::vec3(0));
    EXPECT_EQ(scatterOf(color, 0), color);
    const glm::vec3 through = scatterOf(color, 0.5f);
    EXPECT_NEAR(through.y, 0.2f * (1 + 0.5f * 1.05f), 1e-6f);
    EXPECT_LT(scatterOf({0.9f, 0.9f, 0.9f}, 1).y, 1) << "or light among them would never end";
}

}  // namespace
}  // namespace sward
