#include "terrain/lod.h"

#include <gtest/gtest.h>

namespace sward {
namespace {

// Everything is in view.
Frustum everySide() {
    Frustum f;
    f.planes.fill(glm::vec4(0, 0, 0, 1));
    return f;
}

Terrain hills(int side, double size) {
    Terrain t;
    t.size = {size, size};
    Map m({side, side, 1, PixelType::F32});
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const double u = (x + 0.5) / side, v = (y + 0.5) / side;
            m.set(x, y, 0, static_cast<float>(8 * std::sin(20 * u) * std::cos(17 * v)));
        }
    t.height = {"maps/h.exr", m};
    return t;
}

int covering(const std::vector<TerrainNode>& nodes, double x, double z) {
    int n = 0;
    for (const TerrainNode& node : nodes) {
        const double side = kNodeQuads * node.spacing;
        n += x >= node.place.x && x < node.place.x + side && z >= node.place.y && z < node.place.y + side;
    }
    return n;
}

TEST(TerrainLod, EveryPointOfTheGroundIsInExactlyOneNode) {
    const Terrain t = hills(128, 300);
    HeightBounds bounds;
    updateHeightBounds(bounds, t);
    for (const glm::dvec3 eye :
         {glm::dvec3(150, 3, 150), glm::dvec3(-40, 30, 10), glm::dvec3(0, 2, 0), glm::dvec3(299, 200, 150)}) {
        const auto nodes = selectNodes(t, terrainLod(t), bounds, eye, everySide());
        for (double x = 0.3; x < 300; x += 7.7)
            for (double z = 0.3; z < 300; z += 7.7) ASSERT_EQ(covering(nodes, x, z), 1) << x << " " << z;
    }
}

// Where levels meet, the finer one has morphed fully and the coarser one not yet: no crack whatever the heights.
TEST(TerrainLod, VerticesAgreeWhereLevelsMeet) {
    const Terrain t = hills(128, 300);
    HeightBounds bounds;
    updateHeightBounds(bounds, t);
    int borders = 0;
    for (const glm::dvec3 eye : {glm::dvec3(150, 3, 150), glm::dvec3(20, 40, 70)}) {
        const auto nodes = selectNodes(t, terrainLod(t), bounds, eye, everySide());
        const double above = std::max(eye.y - bounds.high, 0.0);
        const auto morph = [&](const TerrainNode& n, double x, double z) {
            const double d = std::sqrt((x - eye.x) * (x - eye.x) + (z - eye.z) * (z - eye.z) + above * above);
            return std::clamp((d - n.morphFrom) * n.morphInv, 0.0, 1.0);
        };
        for (const TerrainNode& a : nodes)
            for (const TerrainNode& b : nodes) {
                const double sideA = kNodeQuads * a.spacing, edge = a.place.x + sideA;
                if (b.spacing <= a.spacing || std::abs(edge - b.place.x) > 1e-6) continue;  // b is coarser, right of a
                for (int i = 0; i <= kNodeQuads; ++i) {
                    const double z = a.place.y + i * a.spacing;
                    if (z < b.place.y || z > b.place.y + kNodeQuads * b.spacing || z > 300 || edge > 300) continue;
                    ++borders;
                    EXPECT_FLOAT_EQ(b.spacing, 2 * a.spacing) << "levels that meet differ by one";
                    EXPECT_DOUBLE_EQ(morph(a, edge, z), 1.0) << edge << " " << z;
                    EXPECT_DOUBLE_EQ(morph(b, edge, z), 0.0) << edge << " " << z;
                }
            }
    }
    EXPECT_GT(borders, 100);
}

TEST(TerrainLod, LevelGroundIsFourNodesWhateverItsSize) {
    for (const double size : {3.0, 40.0, 1000.0, 25000.0}) {
        Terrain t;
        t.size = {size, 0.7 * size};
        EXPECT_EQ(selectNodes(t, terrainLod(t), {}, {0.3 * size, 1.7, 0.3 * size}, everySide()).size(), 4u) << size;
    }
}

// Where all land is a plane to within a pixel, more of it is next to nothing; nearer nothing changes.
TEST(TerrainLod, LandThatIsAPlaneToTheEyeTakesFewNodes) {
    Terrain t = hills(128, 300);
    t.mapSize = 300, t.heightTiling = 2;
    std::array<size_t, 2> all{}, few{};
    for (size_t i = 0; i < 2; ++i) {
        t.size = glm::dvec2(i == 0 ? 4000 : 90000);
        HeightBounds bounds;
        updateHeightBounds(bounds, t);
        TerrainLod lod = terrainLod(t);
        const glm::dvec3 eye(150, 3, 150);
        const auto fine = selectNodes(t, lod, bounds, eye, everySide());
        lod.plainFrom = 1500;
        const auto nodes = selectNodes(t, lod, bounds, eye, everySide());
        all[i] = fine.size(), few[i] = nodes.size();
        for (double x = 0.3; x < t.size.x; x += t.size.x / 61)
            for (double z = 0.3; z < t.size.y; z += t.size.y / 67) ASSERT_EQ(covering(nodes, x, z), 1) << x << " " << z;
        for (const TerrainNode& n : fine)
            if (glm::length(n.corner) + 1.5f * kNodeQuads * n.spacing < 1500)
                EXPECT_TRUE(std::any_of(nodes.begin(), nodes.end(), [&](const TerrainNode& k) {
                    return k.corner == n.corner && k.place == n.place && k.spacing == n.spacing &&
                           k.morphFrom == n.morphFrom && k.morphInv == n.morphInv;
                }));
    }
    EXPECT_GT(all[1], all[0] + 100);
    EXPECT_LE(few[1], few[0] + 3 * 5 + 4) << "three beside each level more";
    EXPECT_LT(few[0], all[0]);
}

// Nodes near enough to be seen through haze are the same in a field of any size; beyond, only what stands before the
// sky is drawn.
TEST(TerrainLod, LandThatHazeHidesIsNotDrawn) {
    const auto nodesOf = [](double size, double hidden, double peak) {
        Terrain t = hills(128, 256);
        t.mapSize = 256, t.heightTiling = 1;
        t.size = {size, size};
        if (peak > 0) t.mapSize = 0, t.height.map.set(120, 120, 0, static_cast<float>(peak));
        HeightBounds bounds;
        updateHeightBounds(bounds, t);
        TerrainLod lod = terrainLod(t);
        lod.hidden = hidden;
        return selectNodes(t, lod, bounds, {1200, 10, 1200}, everySide());
    };
    const auto far = [](const TerrainNode& n) {
        const double side = kNodeQuads * static_cast<double>(n.spacing);
        return std::hypot(std::max({static_cast<double>(n.corner.x), -n.corner.x - side, 0.0}),
                          std::max({static_cast<double>(n.corner.y), -n.corner.y - side, 0.0}));
    };
    const auto some = nodesOf(2560, 1000, 0), many = nodesOf(80 * 256, 1000, 0), all = nodesOf(80 * 256, 1e30, 0);
    EXPECT_EQ(some.size(), many.size());
    EXPECT_GT(all.size(), many.size());
    for (const TerrainNode& n : many) EXPECT_LE(far(n), 1000);
    const auto mountain = nodesOf(80 * 256, 1000, 3000);
    EXPECT_TRUE(std::any_of(mountain.begin(), mountain.end(), [&far](const TerrainNode& n) { return far(n) > 1000; }));
}

TEST(TerrainLod, AFinerMapCostsNoMoreTriangles) {
    const Frustum view = frustumOf(viewProjection({{100, 6, 100}, {300, 0, 300}, 55, 0}, 640, 480));
    size_t nodes[2];
    int i = 0;
    for (int side : {512, 4096}) {
        const Terrain t = hills(side, 600);
        HeightBounds bounds;
        updateHeightBounds(bounds, t);
        nodes[i++] = selectNodes(t, terrainLod(t), bounds, {100, 6, 100}, view).size();
    }
    const double ratio = static_cast<double>(nodes[1]) / static_cast<double>(nodes[0]);
    EXPECT_LT(ratio, 1.1);
    EXPECT_GT(ratio, 1 / 1.1);
}

TEST(HeightBounds, ContainEverySampledHeight) {
    const Terrain t = hills(77, 90);
    HeightBounds bounds;
    updateHeightBounds(bounds, t);
    for (double x = 0; x <= 90; x += 1.7)
        for (double z = 0; z <= 90; z += 1.3) {
            const auto [low, high] = bounds.over(t.size, x, z, x, z);
            const double h = terrainHeight(t, x, z);
            EXPECT_GE(h, low - 1e-4);
            EXPECT_LE(h, high + 1e-4);
        }
}

TEST(HeightBounds, FlatGroundIsExactlyAtZero) {
    Terrain t;
    HeightBounds bounds;
    updateHeightBounds(bounds, t);
    EXPECT_EQ(bounds.low, 0);
    EXPECT_EQ(bounds.high, 0);
    EXPECT_EQ(terrainHeight(t, 3, 4), 0);
}

}  // namespace
}  // namespace sward
