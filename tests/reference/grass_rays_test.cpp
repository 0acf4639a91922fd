// Rays against blades: what brute force over triangles finds, on hills, in wind, under feet and where maps repeat.
#include "reference/grass_rays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "core/numerics.h"
#include "fields.h"
#include "maps/map_io.h"
#include "objects.h"
#include "reference/solids.h"
#include "scene/unique.h"
#include "support.h"
#include "tests/reference/plain_image.h"
#include "world/forces.h"
#include "world/wind.h"

namespace sward::test {
namespace {

// Blades of a patch where they stand in a cell, as thin triangles: what GrassRays finds without them.
struct BruteForce {
    Project p;
    std::vector<Triangles> triangles{1};
    size_t blades = 0;
    static constexpr double kTime = 40;  // scene seconds
    Map gusts;

    UniqueBlades own;
    Outlines outlines;

    // tiled: maps repeat, and blades have painted heights.
    explicit BruteForce(bool windy, bool tiled = false, Population population = Population::Patch,
                        float stiffness = 1) {
        p.dir = folder().path;
        Terrain t;
        t.size = {6, 6};
        Map heights({12, 12, 1, PixelType::F32});
        for (int y = 0; y < 12; ++y)
            for (int x = 0; x < 12; ++x)
                heights.set(x, y, 0,
                            0.4f * f32::hashUnit(f32::hash3(static_cast<uint32_t>(x), static_cast<uint32_t>(y), 3)) +
                                0.1f * static_cast<float>(x));
        t.height = field(heights, "maps/h.exr");
        if (tiled) t.mapSize = 5, t.heightTiling = 1.7f;
        put(p, "ground", t);
        FlatField f;
        f.cellSize = 0.75f;
        Species& s = f.species[0];
        s.bladesPerM2 = 300, s.height = 0.2f, s.width = 0.02f, s.texture = plainImage(), s.clumpStrength = 1,
        s.leanDeg = 35, s.stiffness = stiffness;
        Map density({8, 8, 1, PixelType::U8});
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x) density.set(x, y, 0, static_cast<float>((x * 5 + y * 3) % 8) / 7);
        s.density = field(density, "maps/d.png");
        Map paint({5, 5, 2, PixelType::U16});
        for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 5; ++x)
                paint.set(x, y, 0, static_cast<float>(x) / 4), paint.set(x, y, 1, static_cast<float>((x + y) % 3) / 2);
        f.orientation = field(paint, "maps/o.png");
        f.orientationTiling = 1.5f;
        f.population = population;
        if (tiled) {
            s.densityTiling = 1.3f;
            Map share({7, 7, 1, PixelType::U8});
            for (int y = 0; y < 7; ++y)
                for (int x = 0; x < 7; ++x) share.set(x, y, 0, static_cast<float>(1 + (x * 3 + y) % 5) / 5);
            f.bladeHeight = field(share, "maps/b.png");
            f.bladeHeightTiling = 2.2f;
        }
        FlatField grass = put(p, "grass", f);
        if (population == Population::Unique) own = makeUnique(grass.species[0], grass.grows, t);
        if (windy) {
            Wind wind;
            wind.strength = 0.8f, wind.gustSize = 1, wind.turbulence = 1;
            put(p, "wind", wind);
            ForceSource foot;
            foot.radius = 0.5f, foot.reach = 3;
            leaveTrack(foot, {2, 3}, {3.5, 2.5}, kTime - 5);
            put(p, "foot", foot);
            putObject(p, "block", {{.size = {1.2f, 0.3f, 0.4f}}, {.size = {0.3f, 0.3f, 1}, .at = {0, 0, 0.5f}}},
                      {4.5, 0, 1.6});
            p.registry.get<StaticMesh>(findEntity(p, "block"))->rotationDeg.y = 20;
            put<ForceSource>(p, "block").shape = ForceShape::Outline;
            Map pressed({6, 6, 4, PixelType::U8});
            for (int i = 0; i < 4; ++i) pressed.set(4, 4, i, i == 0 ? 0.9f : 0.8f);
            grass.forces = field(pressed, "maps/f.png");
            gusts = makeGusts();
        }
        for (int z = 0; z < 8; ++z)
            for (int x = 0; x < 8; ++x) addCell(*firstOf<Terrain>(p), *firstOf<GrassField>(p), x, z);
    }
    void addCell(const Terrain& t, const GrassField& f, int x, int z) {
        static const Patch patch = makePatch(f.species[0], f.cellSize, static_cast<uint32_t>(f.seed));
        const auto [first, last] = own.empty() ? std::pair<uint32_t, uint32_t>{} : own.range(x, z, 0, 1);
        const std::span<const Blade> those = own.empty() ? std::span<const Blade>(patch.blades)
                                                         : std::span(own.patch.blades).subspan(first, last - first);
        const f32::CellVersion version = own.empty() ? f32::cellVersion(x, z, static_cast<uint32_t>(f.seed))
                                                     : f32::CellVersion{glm::vec2(1), glm::vec2(0)};
        const float chance = f32::cellChance(x, z, sowingSeed(f.species[0], static_cast<uint32_t>(f.seed)));
        const f32::Sown sown = own.empty() ? patch.sown : own.patch.sown;
        for (const Blade& b : those) {
            const glm::vec2 in = f32::rootInCell(b.root, version.mirror, version.shift, f.cellSize);
            const glm::dvec2 at = glm::dvec2(x, z) * static_cast<double>(f.cellSize) + glm::dvec2(in),
                             place = at / mapExtent(t);
            if (tiledSample(f.species[0].density.map, tilingOf(t, f.species[0].densityTiling), at.x, at.y) <
                f32::thresholdIn(b.threshold, sown, chance))
                continue;
            const float share = f.bladeHeight.present()
                                    ? tiledSample(f.bladeHeight.map, tilingOf(t, f.bladeHeightTiling), at.x, at.y)
                                    : 1;
            const glm::vec4 texel =
                paintedAt(f.orientation.map, place, static_cast<double>(f.orientationTiling), false);
            f32::BladeStand stand = f32::emptyStand();
            stand.paint = f32::paintOf(texel.x, texel.y), stand.leanAtFull = leanAtFull(f.species[0]);
            stand.clump = f32::clumpValues(x, z, in, f.cellSize, f.species[0].clumpSize, static_cast<uint32_t>(f.seed));
            const glm::vec3 clumps = clumpStrengths(f.species[0]);
            stand.clumpLean = clumps.x, stand.clumpHeight = clumps.y, stand.clumpLightness = clumps.z;
            stand.tall = share;
            if (const Wind* wind = windOf(p))
                stand.wind = windLeanAt(windGlobals(*wind, glm::dvec2(x, z) * static_cast<double>(f.cellSize), kTime),
                                        gusts, in, b.dither) /
                             f.species[0].stiffness;
            glm::vec3 force = forceAt(forcesOf(p, kTime, &outlines), at);
            if (f.forces.present())
                force = f32::forceOf(force + f32::paintedForce(paintedAt(f.forces.map, place, 1, false)));
            stand.push = {force.x, force.y}, stand.press = force.z;
            const f32::BladeLean here = f32::leanOf(stand, b.facing * version.mirror);
            addBlade(b, f32::poseBlade(b.control, b.tip, b.facing, version.mirror, here.lean, here.scale),
                     {at.x, terrainHeight(t, at.x, at.y), at.y});
        }
    }
    void addBlade(const Blade& b, const f32::BladePose& pose, const glm::dvec3& root) {
        constexpr uint32_t kSteps = 32;
        Triangles& out = triangles[0];
        const uint32_t first = static_cast<uint32_t>(out.positions.size());
        for (uint32_t i = 0; i <= kSteps; ++i) {
            const f32::BladeFrame f =
                f32::bladeFrameFacing(pose.control, pose.tip, pose.facing, static_cast<float>(i) / kSteps);
            for (const float side : {-0.5f, 0.5f})
                out.positions.push_back(glm::vec3(root) + f.position + f.side * (side * b.width));
            if (i == kSteps) break;
            const uint32_t v = first + 2 * i;
            out.indices.insert(out.indices.end(), {v, v + 1, v + 2, v + 2, v + 1, v + 3});
        }
        ++blades;
    }
};

void expectEqualToBruteForce(const BruteForce& all) {
    ASSERT_GT(all.blades, 2000u);
    auto brute = RayScene::make(all.triangles);
    JobControl control;
    auto grass = GrassRays::make(all.p, BruteForce::kTime, control);
    ASSERT_TRUE(brute);
    ASSERT_TRUE(grass);
    GrassMemory memory;
    int hits = 0, differ = 0;
    for (uint32_t i = 0; i < 22000; ++i) {
        const auto number = [&](uint32_t k) { return static_cast<double>(f32::hashUnit(f32::hash3(i, k, 11))); };
        const glm::dvec3 from(6 * number(0), 1.2 * number(1) + 0.1, 6 * number(2)),
            to(6 * number(3), 0.8 * number(4), 6 * number(5));
        const Ray ray{from, glm::normalize(to - from), 0, std::numeric_limits<double>::infinity(), i};
        const auto ours = grass->closest(ray, memory);
        const auto theirs = brute->closest(glm::vec3(from), glm::vec3(ray.way), 0, 1e9f);
        hits += theirs.has_value();
        differ += ours.has_value() != theirs.has_value() ||
                  (ours && std::abs(ours->t - static_cast<double>(theirs->t)) > 2e-3);
        EXPECT_EQ(ours.has_value(), grass->blocks(ray, memory)) << i;
    }
    EXPECT_GT(hits, 3333) << "enough to compare";
    EXPECT_LT(differ, 40) << "only rays that graze an edge of a triangle";
}

TEST(GrassRays, MeetWhatBruteForceMeetsOnHillsWithPaintClumpsAndDensity) { expectEqualToBruteForce(BruteForce(false)); }

TEST(GrassRays, MeetWhatBruteForceMeetsInWindAndUnderFeet) { expectEqualToBruteForce(BruteForce(true)); }

TEST(GrassRays, MeetWhatBruteForceMeetsAmongStiffBladesAndSoftOnes) {
    expectEqualToBruteForce(BruteForce(true, false, Population::Patch, 0.7f));
    expectEqualToBruteForce(BruteForce(true, false, Population::Unique, 4));
}

TEST(GrassRays, MeetWhatBruteForceMeetsWhereMapsRepeatAndBladesAreLow) {
    expectEqualToBruteForce(BruteForce(false, true));
}

TEST(GrassRays, MeetWhatBruteForceMeetsAmongUniqueBlades) {
    expectEqualToBruteForce(BruteForce(true, true, Population::Unique));
}

TEST(GrassRays, BoundsHoldEveryBladeOfTheirClass) {
    Species s;
    s.bladesPerM2 = 400, s.leanVariationDeg = 30;
    const Patch patch = makePatch(s, 1, 3);
    for (uint32_t i = 0; i < 4000; ++i) {
        const Blade& b = patch.blades[i % patch.blades.size()];
        const auto number = [&](uint32_t k) { return 2 * f32::hashUnit(f32::hash3(i, k, 5)) - 1; };
        const glm::vec2 mean(2 * number(0), 2 * number(1));
        const float spread = 0.5f * std::abs(number(2)), scale = 0.3f * std::abs(number(3));
        const auto [low, high] = leaningBounds(b, mean, spread, scale);
        const float turn = f32::kPi * number(4), far = spread * std::sqrt(std::abs(number(5)));
        const f32::BladePose pose =
            f32::poseBlade(b.control, b.tip, b.facing, {1, 1}, mean + far * glm::vec2(std::cos(turn), std::sin(turn)),
                           1 + scale * number(6));
        for (int v = 0; v <= 8; ++v)
            for (const float side : {-0.5f, 0.5f}) {
                const f32::BladeFrame f =
                    f32::bladeFrameFacing(pose.control, pose.tip, pose.facing, static_cast<float>(v) / 8);
                const glm::vec3 at = f.position + f.side * (side * b.width);
                EXPECT_TRUE(glm::all(glm::lessThanEqual(low, at)) && glm::all(glm::lessThanEqual(at, high)))
                    << i << " " << v;
            }
    }
}

TEST(Ribbon, RaysAimedAtABladeMeetItThere) {
    int missed = 0;
    for (uint32_t i = 0; i < 20000; ++i) {
        const auto number = [&](uint32_t k) { return 2 * f32::hashUnit(f32::hash3(i, k, 9)) - 1; };
        const float turn = f32::kPi * number(0), v = 0.5f + 0.5f * number(1), across = 0.49f * number(2), width = 0.02f;
        const glm::vec2 facing(std::cos(turn), std::sin(turn));
        const glm::vec3 control(0.1f * number(3), 0.15f, 0.1f * number(4)),
            tip(0.2f * number(5), 0.25f, 0.2f * number(6));
        const f32::BladeFrame f = f32::bladeFrameFacing(control, tip, facing, v);
        const glm::vec3 aim = f.position + f.side * (across * width),
                        from = glm::normalize(glm::vec3(number(7), number(8), number(9))) * 2.0f;
        const glm::vec3 way = glm::normalize(aim - from);
        if (std::abs(way.x * facing.x + way.z * facing.y) + std::abs(way.y) < 0.05f)
            continue;  // along the blade's side: no shadow to meet
        const glm::vec2 at = f32::ribbonMeetings(from, way, control, tip, facing);
        const float nearest = std::abs(at.x - v) < std::abs(at.y - v) ? at.x : at.y;
        // A ray along the curve's tangent meets it over a stretch; its place in space still agrees.
        const f32::RibbonHit h = f32::ribbonAt(from, way, control, tip, facing, width, nearest);
        missed += !(glm::length(from + way * h.t - aim) < 2e-3f);
    }
    EXPECT_LT(missed, 20) << "only rays that touch the curve and no more";
}

TEST(Ribbon, RootsKeepTheirDigits) {
    // One root a millionth of the other: the plain formula loses half of its digits.
    const f64::vec2 exact = f64::ribbonRoots(1, -1000.001, 1);
    const f32::vec2 ours = f32::ribbonRoots(1, -1000.001f, 1);
    EXPECT_NEAR(ours.x / exact.x, 1, 1e-6);
    EXPECT_NEAR(ours.y / exact.y, 1, 1e-6);
    EXPECT_NEAR(static_cast<double>((1000.001f - std::sqrt(1000.001f * 1000.001f - 4)) / 2) / exact.x, 1, 0.5);
    EXPECT_GT(std::abs(static_cast<double>((1000.001f - std::sqrt(1000.001f * 1000.001f - 4)) / 2) / exact.x - 1), 1e-3)
        << "the baseline that loses";
    EXPECT_EQ(f32::ribbonRoots(0, 2, -1).x, 0.5f) << "a straight blade";
    EXPECT_GT(f32::ribbonRoots(1, 0, 1).x, 1) << "no meeting";
}

}  // namespace
}  // namespace sward::test
