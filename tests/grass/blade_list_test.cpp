#include "grass/blade_list.h"

#include <gtest/gtest.h>

#include <set>

#include "core/numerics.h"
#include "fields.h"

namespace sward {
namespace {

using namespace test;

struct ListedField {
    Terrain terrain;
    FlatField grass;
    Patch patch;
    HeightBounds bounds;
    Frustum frustum = frustumOf(viewProjection({{10, 1.7, 10}, {16, 0, 15}, 55, 0}, 320, 240));
    glm::dvec3 eye{10, 1.7, 10};

    ListedField() {
        terrain.size = {20, 20};
        Species& s = grass.species[0];
        s.bladesPerM2 = 2000, s.height = 0.2f, s.segments = 4;
        grass.minGeom = 2, grass.maxGeom = 5;
        patch = makePatch(s, grass.cellSize, 1);
        Map m({40, 40, 1, PixelType::U16});
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 40; ++x)
                m.set(x, y, 0,
                      0.4f + 0.6f * f32::hashUnit(f32::hash2(static_cast<uint32_t>(x), static_cast<uint32_t>(y))));
        s.density = {"maps/d.png", m};
    }
    CellQuery query() const { return cellQuery(queryOf(terrain, bounds, grass, patch), {eye, frustum, 400}); }
};
using Seen = std::set<std::pair<uint32_t, uint32_t>>;  // cell, blade

// Blades of the cells that are opaque enough to be seen, in view or about to reach into it.
template <class Least>
Seen mustBeListed(const CellQuery& q, const Least& least, const std::vector<CellDraw>& cells) {
    Seen out;
    for (uint32_t c = 0; c < cells.size(); ++c)
        for (uint32_t i = cells[c].first; i < cells[c].last; ++i) {
            const Blade& b = q.patch.blades[i];
            const glm::vec2 root = f32::rootInCell(b.root, cells[c].mirror, cells[c].shift, 0.5f);
            const glm::vec3 at(cells[c].x + root.x, -q.eye.y, cells[c].z + root.y);
            const float density =
                q.density->sample((cells[c].cellX * 0.5 + root.x) / 20, (cells[c].cellZ * 0.5 + root.y) / 20);
            const float opacity = f32::geometryOpacity(density, f32::lodRamp(glm::length(at), q.range.min, q.range.inv),
                                                       thresholdIn(q, cells[c], b), q.fade);
            if (opacity > 0 && opacity >= least(b) &&
                q.frustum.touches(at - glm::vec3(q.reach, 0, q.reach), at + q.reach))
                out.emplace(c, i);
        }
    return out;
}
Seen listed(const BladeList& list, int segments) {
    Seen out;
    for (const DrawCommand& c : list.commands)
        for (uint32_t i = 0; i < c.count; ++i)
            out.emplace(c.baseInstance, list.indices[c.firstIndex + i] / (2 * static_cast<uint32_t>(segments + 1)));
    return out;
}

TEST(BladeList, HoldsEveryBladeThatIsSeenAndFewOthers) {
    const ListedField f;
    const CellQuery q = f.query();
    const std::vector<CellDraw> cells = selectCells(q);
    uint64_t inRanges = 0;
    for (const CellDraw& c : cells) inRanges += c.last - c.first;
    for (const int samples : {1, 4}) {
        const PixelCoverage shown{.samples = samples};
        const BladeList list = listBlades({q, q.reach, shown}, cells);
        const Seen needed = mustBeListed(
                       q, [&](const Blade&b) { return leastShown(b, shown); }, cells),
                   there = listed(list, q.segments);
        EXPECT_EQ(list.blades, there.size()) << "none twice";
        EXPECT_TRUE(std::includes(there.begin(), there.end(), needed.begin(), needed.end()));
        EXPECT_GT(needed.size(), 1000u);
        EXPECT_LT(there.size(), needed.size() * 21 / 20) << "what rounding may decide";
        EXPECT_LT(there.size(), samples == 1 ? inRanges / 2 : inRanges * 3 / 4);
    }
}

// At 5 m half a pixel is as wide as three blades.
TEST(BladeList, OfShadowsItHoldsThoseThatStandForOthers) {
    const ListedField f;
    CellQuery q = f.query();
    q.pixelsPerMetre = 200;
    const std::vector<CellDraw> cells = selectCells(q);
    const Seen all = mustBeListed(
                   q, [](const Blade&b) { return b.dither; }, cells),
               shown = listed(listBlades({q, q.reach, {}, 1, true}, cells), q.segments);
    size_t needed = 0;
    for (const auto& [c, i] : all) {
        const Blade& b = f.patch.blades[i];
        const glm::vec2 root = f32::rootInCell(b.root, cells[c].mirror, cells[c].shift, 0.5f);
        const float distance = glm::length(glm::vec3(cells[c].x + root.x, -q.eye.y, cells[c].z + root.y));
        const float many = f32::shadowsOfOne(b.width, distance / q.pixelsPerMetre);
        if (!(f32::shadowWidening(
                  many, f32::shadowChance(std::bit_cast<uint32_t>(b.dither), cells[c].cellX, cells[c].cellZ)) > 0))
            continue;
        ++needed;
        EXPECT_TRUE(shown.contains({c, i})) << "cell " << c << ", blade " << i;
    }
    EXPECT_GT(needed, all.size() / 4);
    EXPECT_LT(needed, all.size() * 2 / 3);
    EXPECT_LT(static_cast<double>(shown.size()), 1.1 * static_cast<double>(needed) + 50);
}

TEST(BladeList, MoreSamplesShowMoreOfWhatFades) {
    const ListedField f;
    const auto least = [&](const PixelCoverage& shown) {
        double sum = 0;
        for (const Blade& b : f.patch.blades) sum += leastShown(b, shown);
        return sum / static_cast<double>(f.patch.blades.size());
    };
    EXPECT_NEAR(least({.samples = 1}), 1.0 / 2, 0.05) << "the mean of the least of n random numbers is 1 / (n + 1)";
    EXPECT_NEAR(least({.samples = 4}), 1.0 / 5, 0.03);
    EXPECT_NEAR(least({.samples = 8}), 1.0 / 9, 0.03);
    EXPECT_LT(least({.way = Transparency::Blend}), 0.005);
}

// Frames that add up take turns with the blades that fade: over all of them, each is there as often as it is opaque.
TEST(BladeList, FramesThatAddUpListEachBladeAsOftenAsItIsOpaque) {
    const ListedField f;
    for (size_t i = 0; i < f.patch.blades.size(); i += 37)
        for (const float opacity : {0.1f, 0.5f, 0.9f}) {
            int frames = 0;
            for (uint32_t shift = 0; shift < 256; ++shift)
                frames += leastShown(f.patch.blades[i], {.shift = shift}) <= opacity;
            EXPECT_NEAR(frames, 256 * opacity, 1) << "blade " << i;
        }
}

TEST(BladeList, AddStripCoversTheFirstRowsOfTheBladesVertices) {
    for (int segments = 1; segments <= 5; ++segments)
        for (int quads = 1; quads <= segments; ++quads) {
            std::vector<uint32_t> indices;
            addStrip(indices, 3, quads, segments);
            ASSERT_EQ(indices.size(), 6u * static_cast<size_t>(quads));
            const uint32_t base = 3 * 2 * static_cast<uint32_t>(segments + 1);
            EXPECT_EQ(indices.front(), base);
            EXPECT_EQ(indices.back(), base + 2 * static_cast<uint32_t>(quads) + 1);
            for (size_t i = 6; i < indices.size(); i += 6) EXPECT_EQ(indices[i], indices[i - 4]) << "quads meet";
            std::vector<uint32_t> pointed;
            addStrip(pointed, 3, quads, segments, true);
            indices.resize(indices.size() - 3);
            EXPECT_EQ(pointed, indices) << "all but the triangle that has no width";
        }
}

}  // namespace
}  // namespace sward
