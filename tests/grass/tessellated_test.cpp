// Which blades and levels the CPU sends for tessellation: never fewer, never coarser than a blade asks for.
#include <gtest/gtest.h>

#include "core/numerics.h"
#include "fields.h"
#include "grass/cells.h"

namespace sward {
namespace {

using namespace test;

int most(const BladeLevels& l, float distance) {
    return f32::tessMost(static_cast<float>(l.smoothness), distance, l.maxDistance, l.quadsAtOneMetre, l.reach);
}

TEST(TessellatedLevels, ACellsLevelIsItsNearestBlades) {
    const BladeLevels l{6, 40, 0, 0.3f};
    EXPECT_EQ(most(l, 0), 6);
    for (float d = 0; d < 40; d += 0.37f)
        for (float farther = 0; farther < 2; farther += 0.21f)
            EXPECT_GE(most(l, d), f32::tessLevel(6, d + farther, 40)) << d;
    EXPECT_EQ(most(l, 50), 1) << "a cell that is drawn has a level";
}

TEST(TessellatedLevels, ByPixelsTheyFallWithTheDistanceAndAreFullAtTheEye) {
    const BladeLevels l{8, 40, 100, 0.3f};
    EXPECT_EQ(most(l, 0.3f), 8);
    int before = 8;
    for (float d = 0; d < 300; d += 0.5f) {
        EXPECT_LE(most(l, d), before);
        before = most(l, d);
    }
    EXPECT_EQ(before, 1);
}

TEST(TessellatedLevels, ThinningIsLinearOrByPixelsAndLoweringEndsAtTheGround) {
    EXPECT_EQ(f32::densityKept(0.8f, 0, {0.01f, 1e30f}), 0.8f);
    EXPECT_FLOAT_EQ(f32::densityKept(0.8f, 50, {0.01f, 1e30f}), 0.4f);
    EXPECT_EQ(f32::densityKept(0.8f, 500, {0.01f, 1e30f}), 0);
    const f32::Thinning byPixels{0, 8}, byBoth{0.01f, 8};
    EXPECT_EQ(f32::densityKept(0.8f, 0, byPixels), 0.8f);
    EXPECT_EQ(f32::densityKept(0.8f, 8, byPixels), 0.8f);
    EXPECT_FLOAT_EQ(f32::densityKept(0.8f, 32, byPixels), 0.2f);
    EXPECT_FLOAT_EQ(f32::densityKept(1, 5, byBoth), 0.95f);
    EXPECT_FLOAT_EQ(f32::densityKept(1, 80, byBoth), 0.1f);
    EXPECT_EQ(f32::heightKept(10, 25, 1 / 5.0f), 1);
    EXPECT_FLOAT_EQ(f32::heightKept(22.5f, 25, 1 / 5.0f), 0.5f);
    EXPECT_EQ(f32::heightKept(26, 25, 1e6f), 0);
}

// Every blade that the shader would keep is within what selectCells sends.
TEST(TessellatedLevels, ThinnedCellsSendEveryBladeThatIsLeft) {
    Terrain terrain;
    terrain.size = {30, 30};
    HeightBounds bounds;
    updateHeightBounds(bounds, terrain);
    FlatField field;
    field.technique = nameOf(Technique::Tessellated);
    field.species[0].bladesPerM2 = 400;
    field.maxDistance = 20;
    const Patch patch = makePatch(field.species[0], field.cellSize, 1);
    const glm::dvec3 eye{15, 1, 1};
    const Frustum all{};  // planes of zeros: everything is inside
    CellQuery q = cellQuery(queryOf(terrain, bounds, field, patch), {eye, all, 100});
    q.thinning = {0.75f / 20, 6};
    q.levels = {5, 20, 0, q.reach};
    uint64_t sent = 0, left = 0;
    for (const CellDraw& c : selectCells(q)) {
        EXPECT_LT(c.nearest, 20);
        sent += c.last - c.first;
        for (uint32_t i = 0; i < patch.blades.size(); ++i) {
            const glm::vec2 root = f32::rootInCell(patch.blades[i].root, c.mirror, c.shift, 0.5f);
            const float d = glm::length(glm::vec3(c.x + root.x, -1, c.z + root.y));
            const bool drawn = d < 20 && f32::geometryOpacity(f32::densityKept(1, d, q.thinning), 0,
                                                              thresholdIn(q, c, patch.blades[i]), field.fade) > 0;
            left += drawn;
            if (drawn) {
                EXPECT_TRUE(i >= c.first && i < c.last) << d;
                EXPECT_LE(f32::tessLevel(5, d, 20), c.segments);
            }
        }
    }
    EXPECT_GT(left, 1000u);
    EXPECT_LT(static_cast<double>(sent), 1.3 * static_cast<double>(left));
}

}  // namespace
}  // namespace sward
