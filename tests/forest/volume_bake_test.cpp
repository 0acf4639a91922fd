// A forest's volume: it takes as much light as the leaves' area asks, its pyramid is what its slabs add up to, and
// light through even air follows Beer's law.
#include "forest/volume_bake.h"

#include <gtest/gtest.h>

#include "core/numerics.h"

namespace sward {
namespace {

Forest pines() {
    Forest f;
    f.species = {{.name = "pine", .leaves = 800}};
    return f;
}
std::vector<Mesh> meshesOf(const Forest& f) {
    std::vector<Mesh> out;
    for (const TreeSpecies& s : f.species) out.push_back(*treeMesh(".", s));
    return out;
}
double areaOf(const Mesh& m) {
    double sum = 0;
    const std::vector<float> shares = leafShares(m);
    for (size_t i = 0; i < m.indices.size(); i += 3) {
        const auto at = [&](size_t n) { return glm::dvec3(m.vertices[m.indices[i + n]].position); };
        sum += 0.5 * static_cast<double>(shares[i / 3]) * glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
    }
    return sum;
}

TEST(ForestVolume, HoldsHalfTheAreaOfAllLeavesAndAQuarterOfTrunks) {
    const Forest f = pines();
    const ForestTiles tiles = forestTiles(f);
    const std::vector<Mesh> meshes = meshesOf(f);
    const ForestVolume v = bakeForest(tiles, meshes, 0.5);
    double want = 0;
    const auto add = [&](const std::vector<TileTree>& list, double times) {
        for (const TileTree& t : list)
            want += times * 0.5 * areaOf(meshes[t.species]) * double(t.size) * double(t.size);
    };
    for (const auto& family : tiles.onEdge)
        for (const auto& color : family) add(color, tiles.colors);
    for (const auto& cell : tiles.inside)
        for (const auto& tile : cell) add(tile, 1);
    const double part = std::pow(v.texel(), 2) * 0.8660254037844386;
    double sum = 0;
    for (const glm::vec4& t : v.levels[0]) sum -= std::log1p(-std::min(double(t.w), 1 - 1e-7)) * part;
    EXPECT_GT(want, 100);
    EXPECT_NEAR(sum / want, 1, 1e-3);
    double air = 0;
    for (const float e : v.air.extinction)
        air += double(e) * std::pow(v.cells * v.edge / v.air.side, 2) * 0.8660254037844386 * v.height / v.air.layers;
    EXPECT_LT(air, want) << "leaves in clumps take less than leaves that are spread";
    EXPECT_GT(air, 0.4 * want);
}

TEST(ForestVolume, EachLevelIsWhatItsSlabsAddUpTo) {
    const Forest f = pines();
    const ForestVolume v = bakeForest(forestTiles(f), meshesOf(f), 0.5);
    const size_t slab = static_cast<size_t>(v.side) * static_cast<size_t>(v.side);
    ASSERT_EQ(v.levels.size(), static_cast<size_t>(std::log2(v.layers)) + 1);
    double worst = 0;
    for (size_t i = 0; i < slab; ++i) {
        glm::dvec4 c(0);
        for (size_t l = 0; l < static_cast<size_t>(v.layers); ++l) {
            const glm::dvec4 over(v.levels[0][l * slab + i]);
            c = over + c * (1 - over.w);
        }
        for (int k = 0; k < 4; ++k) worst = std::max(worst, std::abs(c[k] - double(v.levels.back()[i][k])));
        for (int k = 0; k < 3; ++k)
            EXPECT_LE(v.levels.back()[i][k], v.levels.back()[i].w * 1.0001f) << "colour above opacity";
    }
    EXPECT_LT(worst, 2e-6);
}

TEST(ForestVolume, EachTexelBelongsToTheTreeThatFillsIt) {
    // One tree: what is opaque is its own everywhere.
    Forest f = pines();
    f.perHectare = 365;
    const ForestTiles tiles = forestTiles(f);
    const ForestVolume v = bakeForest(tiles, meshesOf(f), 0.25);
    const std::vector<glm::vec4>& all = v.levels.back();
    size_t far = 0, filled = 0;
    for (int y = 0; y < v.side; ++y)
        for (int x = 0; x < v.side; ++x) {
            const size_t i = static_cast<size_t>(y * v.side + x);
            if (all[i].w < 0.02f) continue;
            ++filled;
            EXPECT_LT(v.slots[i], kTreeSlots);
            const double u = v.cells * (x + 0.5) / v.side, w = v.cells * (y + 0.5) / v.side;
            const int cx = static_cast<int>(u), cy = static_cast<int>(w);
            const bool up = u - cx + w - cy <= 1;
            const int slot = v.slots[i];
            const f64::vec2 at = f64::fromLattice({u - cx, w - cy}, v.edge);
            glm::dvec2 root;
            if (slot < kMostInside) {
                root = tiles.within(cx + v.cells * cy, up)[static_cast<size_t>(slot)].at;
            } else {
                const int family = (slot - kMostInside) / kMostOnEdge;
                const std::array<int, 3> colors = storedTile(cx + v.cells * cy, up, v.cells).colors;
                const glm::ivec2 owner = edgeOwner(0, 0, up, static_cast<EdgeFamily>(family));
                const f64::vec2 shift = f64::fromLattice({owner.x, owner.y}, v.edge);
                root = tiles
                           .across(static_cast<EdgeFamily>(family),
                                   colors[static_cast<size_t>(family)])[static_cast<size_t>((slot - kMostInside) %
                                                                                            kMostOnEdge)]
                           .at +
                       glm::dvec2(shift.x, shift.y);
            }
            far += glm::distance(root, glm::dvec2(at.x, at.y)) > tiles.circle + 0.5;
        }
    EXPECT_GT(filled, 1000u);
    EXPECT_LT(static_cast<double>(far), 0.005 * static_cast<double>(filled));
}

TEST(ForestVolume, LightThroughEvenAirFollowsBeersLaw) {
    ForestAir air{16, 32, 10, 8, {}};
    air.extinction.assign(16 * 16 * 32, 0.3f);
    for (const double elevation : {90.0, 45.0, 20.0}) {
        const double s = std::sin(glm::radians(elevation)), c = std::cos(glm::radians(elevation));
        const std::vector<float> light = lightThrough(air, {c * 0.6, s, c * 0.8}).past;
        for (const int layer : {0, 16, 31}) {
            const double above = 8 - (layer + 0.5) * 0.25;
            EXPECT_NEAR(light[static_cast<size_t>(layer) * 256 + 37], std::exp(-0.3 * above / s), 0.02) << elevation;
        }
    }
    EXPECT_NEAR(lightThrough(air, {0, -1, 0}).past[37], std::exp(-0.3 * 0.125), 0.02) << "from below";
    const auto sky = skyThrough(air);
    EXPECT_GT(sky[0][31 * 256], 0.8f);
    EXPECT_LT(sky[0][0], 0.15f);
    EXPECT_GT(sky[1][0], 0.8f);
}

TEST(ForestVolume, PastItsOwnTreeAloneMoreLightComes) {
    ForestAir air{16, 32, 10, 8, {}};
    air.extinction.assign(16 * 16 * 32, 0.3f);
    for (int i = 0; i < 256; ++i) air.owners.push_back(static_cast<uint16_t>(i % 16 / 8));
    const glm::dvec3 low(0.8, 0.6, 0);
    const LightShares both = lightThrough(air, low);
    double least = 1, most = 0;
    for (size_t i = 0; i < both.past.size(); ++i) {
        EXPECT_GE(both.pastOwn[i], both.past[i]);
        least = std::min(least, double(both.pastOwn[i] - both.past[i]));
        most = std::max(most, double(both.pastOwn[i] - both.past[i]));
    }
    EXPECT_NEAR(least, 0, 1e-6) << "under its top nothing else is in the way";
    EXPECT_GT(most, 0.1);
    air.owners.clear();
    const LightShares one = lightThrough(air, low);
    EXPECT_EQ(one.past, one.pastOwn);
    EXPECT_EQ(one.past, both.past);
}

TEST(ForestVolume, OnSlopesOthersTakeMoreOrLessOfTheSunAndTheOwnTreeAsMuch) {
    ForestAir air{16, 32, 10, 8, {}};
    air.extinction.assign(16 * 16 * 32, 0.3f);
    for (int i = 0; i < 256; ++i) air.owners.push_back(static_cast<uint16_t>(i % 16 / 8));
    const glm::dvec3 way(0.8, 0.6, 0);
    const LightShares level = lightThrough(air, way);
    const std::vector<float> same = lightPastOthers(air, way, 1), away = lightPastOthers(air, way, 0.5),
                             towards = lightPastOthers(air, way, 2);
    double darker = 0, brighter = 0;
    for (size_t i = 0; i < same.size(); ++i) {
        EXPECT_NEAR(same[i] * level.pastOwn[i], level.past[i], 1e-5f);
        EXPECT_LE(away[i], same[i] + 1e-6f);
        EXPECT_GE(towards[i], same[i] - 1e-6f);
        darker = std::max(darker, double(same[i] - away[i]));
        brighter = std::max(brighter, double(towards[i] - same[i]));
    }
    EXPECT_GT(darker, 0.1);
    EXPECT_GT(brighter, 0.1);
    // In air of others alone the way out is as much longer as the sun comes down less steeply.
    air.owners.assign(256, 0);
    air.owners[37] = 1;
    air.extinction.assign(16 * 16 * 32, 0.02f);
    const size_t low = 37;
    EXPECT_NEAR(std::log(lightPastOthers(air, way, 0.5)[low]) / std::log(lightPastOthers(air, way, 1)[low]), 2, 0.15);
}

TEST(ForestVolume, LevelLeavesTakeMoreLightFromAboveThanFromTheSide) {
    ForestAir air{16, 32, 10, 8, {}};
    air.extinction.assign(16 * 16 * 32, 0.1f);
    const float even = lightThrough(air, {0, 1, 0}).past[37];
    air.facing.fill(0), air.facing.back() = 1;
    EXPECT_NEAR(std::log(lightThrough(air, {0, 1, 0}).past[37]) / std::log(even), 2, 0.1);
    EXPECT_GT(lightThrough(air, {0.99, 0.141, 0}).past[37], 0.1f);
}

TEST(ForestVolume, EmptyAirTakesNothing) {
    ForestAir air{8, 8, 10, 8, std::vector<float>(8 * 8 * 8, 0)};
    for (const glm::dvec3 way : {glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 0), glm::dvec3(0.6, -0.8, 0)})
        for (const float s : lightThrough(air, way).past) EXPECT_EQ(s, 1);
}

}  // namespace
}  // namespace sward
