// Which trees stand: those that density and slopes allow, each once, in every triangle that it reaches into, wherever
// the terrain lies.
#include "world/forest_stand.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "core/numerics.h"
#include "missed.h"

namespace sward {
namespace {

struct Wood {
    Terrain terrain;
    Forest rule;
    glm::dvec3 origin{0};
    Wood() { terrain.size = {200, 150}; }
    StandingForest all() const { return standingForest(rule, {&terrain, origin}); }
    void density(float value) {
        Map m({16, 16, 1, PixelType::U16});
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x) m.set(x, y, 0, value);
        rule.density = {"maps/d.png", m};
    }
    // A plane that rises along x by so many metres over the terrain.
    void plane(float rise) {
        Map m({64, 64, 1, PixelType::F32});
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) m.set(x, y, 0, rise * (static_cast<float>(x) + 0.5f) / 64);
        terrain.height = {"maps/h.exr", m};
    }
};

TEST(ForestStand, HasTheNumberThatIsAskedForWithinTheTerrain) {
    const StandingForest f = Wood().all();
    const double asked = 0.04 * 200 * 150, placed = asked * f.tiles.placed / f.tiles.asked;
    EXPECT_NEAR(f.tiles.placed / f.tiles.asked, 1, 0.1) << "of whole trees in eight tiles";
    EXPECT_NEAR(static_cast<double>(f.trees.size()), placed, 0.04 * placed);
    for (const StandingTree& t : f.trees) {
        EXPECT_TRUE(t.at.x >= 0 && t.at.x <= 200 && t.at.z >= 0 && t.at.z <= 150);
        EXPECT_EQ(t.at.y, 0);
    }
}

TEST(ForestStand, NearAPlaceAreThoseOfTheWholeListAndFewAreLookedAt) {
    Wood w;
    w.plane(60);
    w.rule.slopeDeg = {0, 30};
    w.rule.verticalScale = 1.5f;
    w.origin = {-30, 5, 12};
    for (const double x : {20.0, 20.5, 180.0, 20.0}) w.rule.placed.push_back({"", 0, {x, 30}, 1.5f, 20});
    w.rule.placed.push_back({"", 7, {20, 30}, 1, 0});  // of no species: it does not stand
    Map half({2, 1, 1, PixelType::U16});
    half.set(0, 0, 0, 1);
    half.set(1, 0, 0, 0.5f);
    w.rule.density = {"maps/d.png", half};
    const StandingForest all = w.all();
    const ForestPlaces places = forestPlaces(w.rule, {&w.terrain, w.origin});
    const auto key = [](const StandingTree& t) {
        return std::tuple(t.at.x, t.at.y, t.at.z, t.species, t.size, t.headingDeg, t.chance, t.byHand, t.upright);
    };
    std::vector<StandingTree> near;
    size_t found = 0;
    for (int i = 0; i < 400; ++i) {
        const glm::dvec2 at(-35 + 11 * (i % 20), 5 + 8.3 * (i / 20));
        const double reach = 0.2 + 0.05 * i;
        std::set<decltype(key(all.trees[0]))> asked, listed;
        const size_t looked = treesNear(places, {&w.terrain, w.origin}, at, reach, near);
        EXPECT_LT(static_cast<double>(looked), 250 + 0.15 * 3.15 * (reach + 20) * (reach + 20)) << reach;
        for (const StandingTree& t : near) asked.insert(key(t));
        EXPECT_GE(near.size(), asked.size());
        for (const StandingTree& t : all.trees)
            if (glm::length(glm::dvec2(t.at.x, t.at.z) - at) <= reach) listed.insert(key(t));
        EXPECT_TRUE(asked == listed) << i;
        found += listed.size();
    }
    EXPECT_GT(found, 1000u);
    EXPECT_EQ(treesNear(forestPlaces(w.rule, {}), {}, {0, 0}, 100, near), 0u);
}

TEST(ForestStand, EachTreeIsInATriangleAndEachTrianglesTreesStandThere) {
    const StandingForest f = Wood().all();
    std::vector<int> times(f.trees.size());
    for (const ForestTriangle& t : f.triangles)
        for (const int32_t n : t.trees)
            if (n >= 0) ++times[static_cast<size_t>(n)];
    std::set<std::pair<double, double>> places;
    for (size_t i = 0; i < times.size(); ++i) {
        EXPECT_TRUE(times[i] == 1 || times[i] == 2) << "within one tile, or across an edge of two";
        places.insert({f.trees[i].at.x, f.trees[i].at.z});
    }
    EXPECT_EQ(places.size(), f.trees.size()) << "none stands twice";
}

TEST(ForestStand, DensityLeavesItsShare) {
    Wood w;
    w.terrain.size = {400, 400};
    const double all = static_cast<double>(w.all().trees.size());
    for (const float share : {0.0f, 0.3f, 0.8f, 1.0f}) {
        w.density(share);
        EXPECT_NEAR(static_cast<double>(w.all().trees.size()), share * all,
                    4 * std::sqrt(all * share * (1 - share)) + 1);
    }
    // What a lower density leaves stands at a higher one, too.
    w.density(0.3f);
    std::set<std::pair<double, double>> few, more;
    for (const StandingTree& t : w.all().trees) few.insert({t.at.x, t.at.z});
    w.density(0.6f);
    for (const StandingTree& t : w.all().trees) more.insert({t.at.x, t.at.z});
    for (const auto& place : few) EXPECT_TRUE(more.contains(place));
}

TEST(ForestStand, SlopesBeyondTheRangeAreBare) {
    Wood w;
    w.plane(60);  // 16.7 degrees
    w.rule.slopeDeg = {0, 20};
    EXPECT_GT(w.all().trees.size(), 1000u);
    for (const StandingTree& t : w.all().trees) EXPECT_NEAR(t.at.y, terrainHeight(w.terrain, t.at.x, t.at.z), 1e-9);
    w.rule.slopeDeg = {0, 10};
    EXPECT_LT(w.all().trees.size(), 60u) << "but for the level rims of the map";
}

TEST(ForestStand, MovesWithItsTerrain) {
    Wood w;
    const StandingForest here = w.all();
    w.origin = {90000, 3, -70000};
    const StandingForest there = w.all();
    ASSERT_EQ(here.trees.size(), there.trees.size());
    for (size_t i = 0; i < here.trees.size(); ++i)
        EXPECT_LT(glm::distance(there.trees[i].at - w.origin, here.trees[i].at), 1e-9);
}

TEST(ForestStand, AnEditMovesNothingFarAway) {
    Wood w;
    w.density(1);
    const StandingForest before = w.all();
    w.rule.density.map.set(2, 2, 0, 0);
    const StandingForest after = w.all();
    std::set<std::pair<double, double>> left;
    for (const StandingTree& t : after.trees) left.insert({t.at.x, t.at.z});
    EXPECT_LT(after.trees.size(), before.trees.size());
    for (const StandingTree& t : before.trees)
        if (t.at.x > 60 || t.at.z > 50) EXPECT_TRUE(left.contains({t.at.x, t.at.z}));
}

// Its volumes are those that were baked, and as many trees stand, each where it stood.
TEST(ForestStand, AVerticalScaleMakesTheSameTreesHigherAndNoWider) {
    Wood w;
    w.rule.placed = {{.at = {50, 60}, .size = 1.5f, .headingDeg = 30}};
    const Forest before = w.rule;
    const StandingForest once = w.all();
    w.rule.verticalScale = 2;
    const StandingForest twice = w.all();
    EXPECT_TRUE(sameTiles(before, w.rule)) << "or they would be baked again";
    EXPECT_FALSE(sameForest(before, w.rule));
    EXPECT_NE(once.hash, twice.hash);
    ASSERT_EQ(once.trees.size(), twice.trees.size());
    ASSERT_EQ(once.triangles.size(), twice.triangles.size());
    for (size_t i = 0; i < once.trees.size(); ++i) {
        EXPECT_EQ(once.trees[i].at, twice.trees[i].at);
        const glm::dmat3 low = turnOf(once.trees[i]), high = turnOf(twice.trees[i]);
        EXPECT_EQ(high[0], low[0]);
        EXPECT_EQ(high[1], 2.0 * low[1]);
        EXPECT_EQ(high[2], low[2]);
        const TreeSpecies& s = w.rule.species[0];
        EXPECT_EQ(heightOf(twice.trees[i], s), 2 * heightOf(once.trees[i], s));
    }
}

TEST(ForestStand, EachTreeIsAMeshOrAVolume) {
    Forest f;
    f.meshesTo = 50;
    StandingTree t;
    for (const float chance : {0.0f, 0.25f, 0.5f, 0.999f}) {
        t.chance = chance;
        EXPECT_TRUE(isMesh(f, t, volumesBegin(f) - 0.01));
        EXPECT_FALSE(isMesh(f, t, meshesEnd(f)));
        EXPECT_EQ(isMesh(f, t, 50), chance > 0.5f);
    }
    f.meshesTo = 0;
    EXPECT_FALSE(isMesh(f, t, 0));
    f.meshesTo = std::numeric_limits<float>::infinity();
    EXPECT_TRUE(isMesh(f, t, 1e8));
}

TEST(ForestStand, TreesPlacedByHandStandBesideTheOthersAndAreNoVolumes) {
    Wood w;
    w.plane(60);
    const size_t grown = w.all().trees.size();
    w.rule.placed = {{.at = {50, 60}, .size = 1.5f}, {.species = 7, .at = {10, 10}}};
    const StandingForest f = w.all();
    ASSERT_EQ(f.trees.size(), grown + 1) << "there is no eighth species";
    const StandingTree& t = f.trees.back();
    EXPECT_NEAR(t.at.y, terrainHeight(w.terrain, 50, 60), 1e-9);
    EXPECT_TRUE(isMesh(w.rule, t, 1e8));
    for (const ForestTriangle& tri : f.triangles)
        for (const int32_t n : tri.trees) EXPECT_LT(n, static_cast<int32_t>(grown));
    w.rule.perHectare = 0;
    EXPECT_EQ(w.all().trees.size(), 1u);
    EXPECT_TRUE(grows(w.rule));
}

TEST(ForestStand, TooManyAreRefusedAndNoTerrainHasNone) {
    Wood w;
    w.terrain.size = {1e5, 1e5};
    EXPECT_TRUE(w.all().trees.empty());
    EXPECT_TRUE(standingForest(w.rule, {}).trees.empty());
}

// --- repetition ------------------------------------------------------------------------------------------------------

// Seen from straight above, a texel a metre: crowns of 2 m; its mean is 0.
struct TopView {
    static constexpr int kSide = 600;
    std::vector<float> texels = std::vector<float>(size_t(kSide) * kSide);
    void crown(const glm::dvec2& at) {
        for (int z = static_cast<int>(at.y) - 3; z <= at.y + 3; ++z)
            for (int x = static_cast<int>(at.x) - 3; x <= at.x + 3; ++x)
                if (x >= 0 && z >= 0 && x < kSide && z < kSide)
                    texels[static_cast<size_t>(z * kSide + x)] +=
                        static_cast<float>(std::max(2.5 - glm::distance(at, glm::dvec2(x + 0.5, z + 0.5)), 0.0));
    }
    void centre() {
        double sum = 0;
        for (const float t : texels) sum += static_cast<double>(t);
        for (float& t : texels) t -= static_cast<float>(sum / (kSide * kSide));
    }
    // Of the picture with itself moved by so many metres; 1 at none.
    double correlation(const glm::ivec2& by) const {
        double sum = 0, square = 0;
        for (int z = std::max(0, -by.y); z < std::min(kSide, kSide - by.y); ++z)
            for (int x = std::max(0, -by.x); x < std::min(kSide, kSide - by.x); ++x) {
                const double a = static_cast<double>(texels[static_cast<size_t>(z * kSide + x)]);
                sum += a * static_cast<double>(texels[static_cast<size_t>((z + by.y) * kSide + x + by.x)]);
                square += a * a;
            }
        return sum / square;
    }
};
// The greatest correlation at a vector of the lattice, and by how many sigmas of the others it lies above their mean.
// The others lie anywhere between its vertices.
struct Peak {
    double most = -1, sigmas = 0;
};
Peak latticePeak(TopView v, double edge) {
    v.centre();
    Peak p;
    double sum = 0, squares = 0, n = 0;
    const auto moved = [&](double i, double j) {
        const f64::vec2 at = f64::fromLattice({i, j}, edge);
        return v.correlation(glm::ivec2(glm::round(glm::dvec2(at.x, at.y))));
    };
    for (int j = 0; j <= 8; ++j)
        for (int i = j == 0 ? 1 : -8; i <= 8; ++i) {
            p.most = std::max(p.most, moved(i, j));
            const uint32_t h = f32::cellHash(i, j, 1);
            const double c = moved(i + 0.25 + 0.5 * static_cast<double>(f32::hashUnit(h)),
                                   j + 0.25 + 0.5 * static_cast<double>(f32::hashUnit(f32::hash2(h, 1))));
            sum += c, squares += c * c, n += 1;
        }
    const double mean = sum / n;
    p.sigmas = (p.most - mean) / std::sqrt(squares / n - mean * mean);
    return p;
}
TopView seenFromAbove(TileVariety variety) {
    Wood w;
    w.terrain.size = {TopView::kSide, TopView::kSide};
    w.rule.variety = variety;
    TopView v;
    for (const StandingTree& t : w.all().trees) v.crown({t.at.x, t.at.z});
    return v;
}
// One tile for all that point up and one for the others.
TopView periodic() {
    const ForestTiles tiles = Wood().all().tiles;
    TopView v;
    for (int j = 0; j < 50; ++j)
        for (int i = -30; i < 50; ++i) {
            const f64::vec2 at = f64::fromLattice({double(i), double(j)}, tiles.edge);
            const auto list = [&](const std::vector<TileTree>& trees) {
                for (const TileTree& t : trees) v.crown(glm::dvec2(at.x, at.y) + t.at);
            };
            for (const EdgeFamily f : {EdgeFamily::Row, EdgeFamily::Slant, EdgeFamily::Across})
                list(tiles.across(f, 0));
            for (const bool up : {false, true}) list(tiles.within(0, up));
        }
    return v;
}

// As many tiles as 64 forests have: each edge and tile of one that a hash chooses. `turned`: no more tiles than one
// forest has, but what stands within each is turned by thirds, as a hash has it.
TopView ofManyTiles(bool turned) {
    std::vector<ForestTiles> all;
    for (int seed = 0; seed < (turned ? 1 : 64); ++seed) {
        Forest rule;
        rule.seed = seed;
        all.push_back(forestTiles(rule));
    }
    const double edge = all[0].edge;
    TopView v;
    for (int j = -2; j < 48; ++j)
        for (int i = -30; i < 42; ++i)
            for (uint32_t part = 0; part < 5; ++part) {
                const uint32_t h = f32::hash2(f32::cellHash(i, j, 9), part);
                const ForestTiles& tiles = all[h % all.size()];
                const bool up = part != 4;
                const ForestTile tile = tileAt(i, j, up, 9, tiles.colors);
                const f64::vec2 at = f64::fromLattice({double(i), double(j)}, edge),
                                centre = f64::fromLattice(f64::vec2(up ? 1.0 / 3 : 2.0 / 3), edge);
                const double turn = turned && part > 2 ? glm::radians(120.0 * (h % 3)) : 0;
                const glm::dmat2 way(std::cos(turn), std::sin(turn), -std::sin(turn), std::cos(turn));
                for (const TileTree& t : part < 3 ? tiles.across(static_cast<EdgeFamily>(part), tile.colors[part])
                                                  : tiles.within(tile.cell, up))
                    v.crown(glm::dvec2(at.x + centre.x, at.y + centre.y) +
                            way * (t.at - glm::dvec2(centre.x, centre.y)));
            }
    return v;
}

// What no number of tiles hides, since no tree stands across their corners; nor do tiles that are turned, since edges
// have most of the trees.
TEST(ForestStand, ManyMoreTilesOrTurnedOnesWouldNotHideTheLattice) {
    const Peak many = latticePeak(ofManyTiles(false), 16), turned = latticePeak(ofManyTiles(true), 16);
    std::printf("64 times as many tiles: %.3f (%.1f sigma); tiles in three turns: %.3f (%.1f)\n", many.most,
                many.sigmas, turned.most, turned.sigmas);
    EXPECT_LT(many.most, 0.1);
    EXPECT_GT(many.sigmas, 4);
    EXPECT_GT(turned.most, 0.15);
    EXPECT_GT(turned.sigmas, 4);
}

TEST(ForestStand, SeenFromAboveItsLatticeIsHiddenBesideAPeriodicOnes) {
    const Peak wild = latticePeak(seenFromAbove(TileVariety::ThirtyTwo), 16),
               eight = latticePeak(seenFromAbove(TileVariety::Eight), 16), tame = latticePeak(periodic(), 16);
    std::printf("greatest correlation at the lattice: 32 tiles %.3f (%.1f sigma), eight %.3f (%.1f), one %.3f (%.1f)\n",
                wild.most, wild.sigmas, eight.most, eight.sigmas, tame.most, tame.sigmas);
    EXPECT_GT(tame.sigmas, 4) << "it is seen where there is one";
    EXPECT_LT(wild.most, eight.most);
    EXPECT_LT(eight.most, tame.most);
    test::expectMissed("the lattice in a view of a forest from above, in sigmas", wild.sigmas, 4, 13.5);
}

}  // namespace
}  // namespace sward
