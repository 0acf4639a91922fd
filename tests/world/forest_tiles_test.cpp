// The tiles of a forest, eight or 32: they fit everywhere, trees keep their distance however tiles are laid, and no
// place near an edge is favoured.
#include "world/forest_tiles.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/numerics.h"

namespace sward {
namespace {

glm::dvec2 metres(const glm::dvec2& uv, double edge) {
    const f64::vec2 at = f64::fromLattice({uv.x, uv.y}, edge);
    return {at.x, at.y};
}

TEST(ForestTiles, OneOfTheStoredFitsEveryTriangleAndAllAreUsedAlike) {
    for (const int colors : {2, 4}) {
        std::map<std::pair<int, bool>, int> used;
        for (int j = -32; j < 32; ++j)
            for (int i = -32; i < 32; ++i)
                for (const bool up : {false, true}) {
                    const ForestTile t = tileAt(i, j, up, 5, colors);
                    EXPECT_EQ(t.colors, storedTile(t.cell, up, colors).colors) << i << " " << j;
                    ++used[{t.cell, up}];
                }
        const double each = 8192.0 / (2 * colors * colors);
        ASSERT_EQ(used.size(), static_cast<size_t>(2 * colors * colors));
        for (const auto& [tile, count] : used) EXPECT_NEAR(count, each, 5 * std::sqrt(each));
    }
}

// So hardware wraps them: what lies beside a stored tile is of the colour of the edge between.
TEST(ForestTiles, TheStoredFitEachOtherRoundTheirEdges) {
    for (const int n : {2, 4})
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                const ForestTile up = storedTile(x + n * y, true, n);
                EXPECT_EQ(up.colors[0], storedTile(x + n * ((y + n - 1) % n), false, n).colors[0]);
                EXPECT_EQ(up.colors[1], storedTile((x + n - 1) % n + n * y, false, n).colors[1]);
                EXPECT_EQ(up.colors[2], storedTile(x + n * y, false, n).colors[2]);
            }
}

TEST(ForestTiles, TrianglesBesideAnEdgeAgreeOnItsColour) {
    for (int j = -20; j < 20; ++j)
        for (int i = -20; i < 20; ++i) {
            for (const int n : {2, 4}) {
                const ForestTile up = tileAt(i, j, true, 3, n);
                EXPECT_EQ(up.colors[0], tileAt(i, j - 1, false, 3, n).colors[0]);
                EXPECT_EQ(up.colors[1], tileAt(i - 1, j, false, 3, n).colors[1]);
                EXPECT_EQ(up.colors[2], tileAt(i, j, false, 3, n).colors[2]);
            }
        }
}

// The paper draws each edge's colour by itself: half of all triangles then have none of its eight tiles.
TEST(ForestTiles, ColoursDrawnEdgeByEdgeWouldLoseToThese) {
    int without = 0, all = 0;
    for (int j = 0; j < 64; ++j)
        for (int i = 0; i < 64; ++i) {
            const auto color = [&](uint32_t family) { return f32::hash3(uint32_t(i), uint32_t(j), family) & 1u; };
            without += (color(0) + color(1) + color(2)) % 2;  // a triangle that points up
            ++all;
        }
    EXPECT_NEAR(static_cast<double>(without) / all, 0.5, 0.04);
}

// All trees of a patch of the lattice, in metres.
std::vector<glm::dvec2> laid(const ForestTiles& tiles, int side) {
    std::vector<glm::dvec2> out;
    const auto add = [&](const std::vector<TileTree>& list, int i, int j) {
        for (const TileTree& t : list) out.push_back(metres({i, j}, tiles.edge) + t.at);
    };
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const ForestTile up = tileAt(i, j, true, 9, tiles.colors), down = tileAt(i, j, false, 9, tiles.colors);
            add(tiles.within(up.cell, true), i, j);
            add(tiles.within(down.cell, false), i, j);
            for (const EdgeFamily f : {EdgeFamily::Row, EdgeFamily::Slant, EdgeFamily::Across})
                add(tiles.across(f, up.colors[static_cast<size_t>(f)]), i, j);
        }
    return out;
}

TEST(ForestTiles, TreesKeepTheirDistanceHoweverTilesAreLaid) {
    for (const int seed : {1, 2, 3, 4, 5, 6}) {
        Forest f;
        f.seed = seed;
        f.distance = 3;
        const ForestTiles tiles = forestTiles(f);
        const std::vector<glm::dvec2> all = laid(tiles, 20);
        double least = 1e30;
        for (size_t i = 0; i < all.size(); ++i)
            for (size_t k = i + 1; k < all.size(); ++k)
                if (std::abs(all[i].y - all[k].y) < 4) least = std::min(least, glm::distance(all[i], all[k]));
        EXPECT_GE(least, 3 - 1e-9) << "seed " << seed;
        EXPECT_LT(least, 4) << "or nothing was tested";
    }
}

TEST(ForestTiles, AreAsDenseAsTheyWereAskedToBe) {
    for (const float perHectare : {50.0f, 200.0f, 365.0f}) {
        double placed = 0, asked = 0;
        for (int seed = 0; seed < 20; ++seed) {
            Forest f;
            f.perHectare = perHectare;
            f.seed = seed;
            const ForestTiles t = forestTiles(f);
            placed += t.placed, asked += t.asked;
        }
        EXPECT_NEAR(placed / asked, 1, 0.05) << perHectare;
    }
}

// Trees by their distance from the nearest edge of a tile, as shares of what an even spread has there.
TEST(ForestTiles, NoPlaceNearAnEdgeIsFavoured) {
    std::array<double, 3> found{}, even{};
    for (int seed = 0; seed < 60; ++seed) {
        Forest f;
        f.seed = seed;
        f.distance = 2.6f;
        f.species[0].crown = 0.2f;
        const ForestTiles tiles = forestTiles(f);
        const double height = tiles.edge * 0.8660254037844386;
        const auto band = [&](const glm::dvec2& at) {
            const f64::vec2 uv = f64::toLattice({at.x, at.y}, tiles.edge);
            const double u = uv.x - std::floor(uv.x), v = uv.y - std::floor(uv.y);
            const double d = (u + v <= 1 ? std::min({u, v, 1 - u - v}) : std::min({1 - u, 1 - v, u + v - 1})) * height;
            return static_cast<size_t>(std::min(d / (height / 9), 2.0));
        };
        for (const glm::dvec2& t : laid(tiles, 8)) ++found[band(t)];
        for (int k = 0; k < 4000; ++k)
            ++even[band(
                {f32::hashUnit(f32::hash2(77, 2 * k)) * 100.0f, f32::hashUnit(f32::hash2(77, 2 * k + 1)) * 100.0f})];
    }
    const double trees = found[0] + found[1] + found[2], places = even[0] + even[1] + even[2];
    for (size_t b = 0; b < 3; ++b) EXPECT_NEAR(found[b] / trees / (even[b] / places), 1, 0.12) << "band " << b;
}

TEST(ForestTiles, CirclesCrossOneEdgeAtMost) {
    Forest f;
    f.perHectare = 300;
    for (int seed = 0; seed < 10; ++seed) {
        f.seed = seed;
        const ForestTiles t = forestTiles(f);
        for (const auto& family : t.onEdge)
            for (const auto& color : family)
                for (const TileTree& tree : color)
                    for (int i = -1; i <= 2; ++i)
                        for (int j = -1; j <= 2; ++j)
                            EXPECT_GT(glm::distance(tree.at, metres({i, j}, t.edge)), t.circle)
                                << "a corner lies in a circle";
        for (const auto& list : t.inside)
            for (const auto& tile : list) EXPECT_LE(tile.size(), static_cast<size_t>(kMostInside));
    }
}

}  // namespace
}  // namespace sward
