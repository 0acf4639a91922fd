// Flowers as rays meet them.
#include "reference/flower_rays.h"

#include <gtest/gtest.h>

#include "reference/standing.h"

namespace sward::test {
namespace {

TEST(FlowerRays, ARayThatLeavesAFlowerDoesNotMeetItOnceMore) {
    Project p;
    Terrain t;
    t.size = {4, 4};
    p.registry.add<Terrain>(*addEntity(p, "ground"), t);
    p.registry.add<Flowers>(*addEntity(p, "daisies"), Flowers{.flowersPerM2 = 1});
    JobControl control;
    const auto rays = FlowerRays::make(p, 0, control);
    ASSERT_TRUE(rays) << rays.error().text();
    const auto standing = standingFlowers(p, 0, control);
    ASSERT_TRUE(standing);
    int met = 0, again = 0;
    for (const StandingFlower& one : *standing) {
        const glm::dvec3 head(one.root + one.stem), eye = head + glm::dvec3(0.2, 1, 0.1);
        const auto seen = rays->closest({eye, glm::normalize(head - eye)});
        if (!seen || seen->flower == kNoFlower) continue;
        ++met;
        Ray out{seen->at + 1e-4 * glm::dvec3(seen->face), glm::normalize(glm::dvec3(1, 0.2, 0.3))};
        again += rays->closest(out).has_value();  // it turned to this ray
        out.left = seen->flower;
        const auto next = rays->closest(out);
        EXPECT_TRUE(!next || next->flower != seen->flower);
    }
    EXPECT_GT(met, 5);
    EXPECT_GT(again, 0) << "without its number it would be met";
}

}  // namespace
}  // namespace sward::test
