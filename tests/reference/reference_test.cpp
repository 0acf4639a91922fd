// The ray-traced truth against what is known without it: furnaces, a shadow by geometry, brute force over triangles,
// statistics.
#include "reference/reference.h"

#include <gtest/gtest.h>

#include "core/file.h"
#include "core/numerics.h"
#include "maps/map_io.h"
#include "objects.h"
#include "reference/grass_rays.h"
#include "reference/reference_part.h"
#include "reference/solids.h"
#include "scene/unique.h"
#include "sky/daylight.h"
#include "sky/exposure.h"
#include "support.h"
#include "world/forces.h"
#include "world/view_camera.h"
#include "world/wind.h"

namespace sward::test {
namespace {

const TempDir& folder() {
    static const TempDir dir;
    return dir;
}
// An image of one opaque grey of reflectance 1/2, which shaders double: what it covers is all there, in its own colour.
std::string plainImage() {
    const std::string name = "plain.png";
    if (!std::filesystem::exists(folder() / name)) CHECK(writeImagePng(folder() / name, 1, 1, 4, {188, 188, 188, 255}));
    return name;
}
const float kPlain = 2 * f32::srgbDecode(188.0f / 255);

Truth traced(const Project& p, const ViewCamera& c, ReferenceSettings s) {
    JobControl control;
    auto scene = ReferenceScene::make(p, tables(), 0, control);
    EXPECT_TRUE(scene) << scene.error().text();
    if (!scene) return {};
    auto truth = scene->trace(c, s, control);
    EXPECT_TRUE(truth) << truth.error().text();
    return truth ? std::move(*truth) : Truth{};
}
ReferenceSettings sized(int width, int height, int samples) {
    ReferenceSettings s;
    s.width = width, s.height = height, s.samples = samples;
    return s;
}

// White ground under a uniform white sky.
Project furnace() {
    Project p;
    p.dir = folder().path;
    Terrain t;
    t.size = {40, 40};
    t.groundTexture = plainImage();
    t.groundColor = glm::vec3(1 / kPlain);
    put(p, "ground", t);
    Sky sky;
    sky.model = SkyModel::Uniform;
    put(p, "sky", sky);
    return p;
}
const float kSkyHere = f32::kUniformSky * kExposure;

TEST(ReferenceFurnace, WhiteGroundUnderAUniformSkyIsAsBrightAsTheSky) {
    const Truth t = traced(furnace(), {{20, 3, 20}, {20, 0, 20.5}, 55, 0}, sized(32, 24, 4));
    for (size_t i = 0; i < t.color.size(); ++i) ASSERT_NEAR(t.color[i] / kSkyHere, 1, 0.005) << "value " << i;
}

TEST(ReferenceFurnace, WhiteBladesOnWhiteGroundAreLostInIt) {
    // Light is neither made nor lost between them: what a blade hides it sends on. Paths end by chance, so the mean is
    // it.
    Project p = furnace();
    GrassField f;
    f.cellSize = 1;
    Species& s = f.species[0];
    s.bladesPerM2 = 80, s.height = 0.3f, s.width = 0.05f, s.texture = plainImage();
    s.rootColor = s.midColor = s.tipColor = glm::vec3(1 / kPlain);
    s.hueVariationDeg = s.lightnessVariation = s.clumpStrength = 0;
    put(p, "grass", f);
    const Truth t = traced(p, {{20, 3, 20}, {20, 0, 20.5}, 55, 0}, sized(32, 24, 64));
    double sum = 0, variance = 0, blades = 0;
    for (const float v : t.color) sum += static_cast<double>(v / kSkyHere) / static_cast<double>(t.color.size());
    for (const float e : t.error)
        variance += static_cast<double>(e * e) / (static_cast<double>(kSkyHere) * static_cast<double>(kSkyHere));
    for (const float g : t.grass) blades += static_cast<double>(g) / static_cast<double>(t.grass.size());
    const double error =
        std::sqrt(variance) / static_cast<double>(t.error.size()) * std::sqrt(3.0);  // channels go together
    EXPECT_GT(blades, 0.2) << "there are blades to lose";
    EXPECT_NEAR(sum, 1, std::max(0.005, 4 * error));
}

TEST(ReferenceFurnace, HalfTheLightComesBackFromGreyGround) {
    Project p = furnace();
    p.registry.get<Terrain>(findEntity(p, "ground"))->groundColor *= 0.5f;
    const Truth t = traced(p, {{20, 3, 20}, {20, 0, 20.5}, 55, 0}, sized(8, 6, 4));
    for (const float v : t.color) ASSERT_NEAR(v / kSkyHere, 0.5, 0.005);
}

// One blade every 4 x 4 m, wide and leaning, in sun from straight above.
Project oneBlade() {
    Project p = furnace();
    p.registry.get<Terrain>(findEntity(p, "ground"))->size = {12, 12};
    removeEntity(p, "sky");
    GrassField f;
    f.cellSize = 4;
    Species& s = f.species[0];
    s.bladesPerM2 = 1.0f / 16, s.height = 0.8f, s.width = 0.15f, s.texture = plainImage(), s.leanVariationDeg = 80,
    s.clumpStrength = 0;
    put(p, "grass", f);
    Light sun;
    sun.elevationDeg = 90;
    put(p, "sun", sun);
    return p;
}

TEST(ReferenceShadow, LiesWhereGeometrySays) {
    const Project p = oneBlade();
    const GrassField& f = *firstOf<GrassField>(p);
    const Patch patch = makePatch(f.species[0], f.cellSize, static_cast<uint32_t>(f.seed));
    ASSERT_EQ(patch.blades.size(), 1u);
    JobControl control;
    auto grass = GrassRays::make(p, 0, control);
    ASSERT_TRUE(grass);
    // Where it stands is the population's to say; that its shadow is the blade seen from above is geometry's.
    GrassMemory memory;
    const auto above = [&](double x, double z) { return grass->blocks({{x, 5, z}, {0, -1, 0}, 0, 5, 1}, memory); };
    const Blade& b = patch.blades[0];
    const f32::CellVersion version = f32::cellVersion(1, 1, 1);
    const f32::BladePose pose = f32::poseBlade(b.control, b.tip, b.facing, version.mirror, {0, 0}, 1);
    const glm::vec2 root = 4.0f + f32::rootInCell(b.root, version.mirror, version.shift, 4);
    const glm::vec2 along = glm::vec2(pose.facing), side(-along.y, along.x);
    float far = 0, near = 0;
    for (int i = 0; i <= 1000; ++i) {
        const glm::vec3 at = f32::bladePosition(pose.control, pose.tip, static_cast<float>(i) / 1000);
        far = std::max(far, glm::dot(glm::vec2(at.x, at.z), along)),
        near = std::min(near, glm::dot(glm::vec2(at.x, at.z), along));
    }
    ASSERT_GT(far - near, 0.2f) << "the shadow has a length";
    const auto shaded = [&](double x, double z) {
        const glm::vec2 d = glm::vec2(x, z) - root;
        return std::abs(glm::dot(d, side)) < b.width / 2 && glm::dot(d, along) > near && glm::dot(d, along) < far;
    };
    // A view of the shadow on the ground from the side that the blade does not hide.
    const glm::dvec3 middle(static_cast<double>(root.x + along.x * far / 2), 0,
                            static_cast<double>(root.y + along.y * far / 2));
    const ViewCamera c{middle + glm::dvec3(static_cast<double>(side.x) * 1.5, 2.5, static_cast<double>(side.y) * 1.5),
                       middle, 25, 0};
    ReferenceSettings s = sized(160, 120, 4);
    s.lighting = ReferenceLighting::Direct;  // in full light the sunlit ground shines back from the blade's underside
    const Truth t = traced(p, c, s);
    const glm::dmat4 back = glm::inverse(glm::dmat4(viewProjection(c, s.width, s.height)));
    const auto groundAt = [&](int x, int y) {
        const glm::dvec4 h = back * glm::dvec4(2 * (x + 0.5) / s.width - 1, 1 - 2 * (y + 0.5) / s.height, 1, 1);
        const glm::dvec3 way = glm::dvec3(h) / h.w;
        return c.eye + way * (-c.eye.y / way.y);
    };
    int inShadow = 0, wrong = 0;
    for (int y = 1; y + 1 < s.height; ++y)
        for (int x = 1; x + 1 < s.width; ++x) {
            const size_t i = static_cast<size_t>(y * s.width + x);
            if (t.grass[i] > 0) continue;
            bool any = false, all = true;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    const glm::dvec3 g = groundAt(x + dx, y + dy);
                    const bool in = shaded(g.x, g.z);
                    any |= in, all &= in;
                }
            const glm::dvec3 here = groundAt(x, y);
            if (all || !any)
                EXPECT_EQ(all, above(here.x, here.z)) << "a ray straight up meets the blade where its shadow lies";
            const bool dark = t.color[3 * i] < 0.05f;
            inShadow += all;
            wrong += all ? !dark : !any && dark;
        }
    EXPECT_GT(inShadow, 60);
    EXPECT_EQ(wrong, 0) << "farther than a pixel from the shadow's edge";
}

TEST(ReferenceSamples, FourTimesAsManyHalveTheError) {
    Project p = lawn();
    const ViewCamera c = eyeHeight();
    const auto meanError = [](const Truth& t) {
        double sum = 0;
        for (const float e : t.error) sum += static_cast<double>(e);
        return sum / static_cast<double>(t.error.size());
    };
    const double few = meanError(traced(p, c, sized(64, 48, 32))), many = meanError(traced(p, c, sized(64, 48, 128)));
    EXPECT_NEAR(few / many, 2, 0.1);
}

TEST(ReferenceSamples, TheErrorIsWhatAnotherSeedDiffersBy) {
    Project p = lawn();
    ReferenceSettings s = sized(64, 48, 32);
    const Truth a = traced(p, eyeHeight(), s);
    s.seed = 2;
    const Truth b = traced(p, eyeHeight(), s);
    double sum = 0;
    size_t n = 0;
    for (size_t i = 0; i < a.color.size(); ++i) {
        const double e2 = static_cast<double>(a.error[i] * a.error[i] + b.error[i] * b.error[i]),
                     d = static_cast<double>(a.color[i] - b.color[i]);
        if (e2 > 0) sum += d * d / e2, ++n;
    }
    EXPECT_GT(n, a.color.size() / 4);
    EXPECT_NEAR(std::sqrt(sum / static_cast<double>(n)), 1, 0.1);
    const Truth again = traced(p, eyeHeight(), s);
    EXPECT_EQ(b.color, again.color) << "the same seed gives the same image, whatever the threads do";
}

TEST(ReferenceSamples, NoneOrTooManyAreRefused) {
    JobControl control;
    auto scene = ReferenceScene::make(lawn(), tables(), 0, control);
    ASSERT_TRUE(scene);
    for (const ReferenceSettings& s :
         {sized(8, 8, 0), sized(8, 8, -1), sized(0, 8, 1), sized(8, 8, kMaxReferenceSamples + 1)}) {
        const auto t = scene->trace(eyeHeight(), s, control);
        ASSERT_FALSE(t);
        EXPECT_EQ(t.error().code, ExitCode::Usage);
    }
    control.cancel();
    EXPECT_FALSE(scene->trace(eyeHeight(), sized(64, 48, 4), control));
}

struct Parts : testing::Test {
    TempDir dir;
    Project p = lawn();
    std::filesystem::path part(int shard, int shards, const std::string& name, uint64_t of = 7) {
        ReferenceSettings s = sized(50, 37, 2);
        s.shard = shard, s.shards = shards;
        EXPECT_TRUE(writeFileAtomic(dir / name, encodePart({"eye", of, s, traced(p, eyeHeight(), s)})));
        return dir / name;
    }
};
TEST_F(Parts, MergedEqualTheWholeBitForBit) {
    const Truth whole = traced(p, eyeHeight(), sized(50, 37, 2));
    const auto merged = mergeParts({part(2, 3, "c"), part(0, 3, "a"), part(1, 3, "b")});
    ASSERT_TRUE(merged) << merged.error().text();
    EXPECT_EQ(whole.color, merged->color);
    EXPECT_EQ(whole.error, merged->error);
    EXPECT_EQ(whole.grass, merged->grass);
}
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
        GrassField f;
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
        f.population = static_cast<int>(population);
        if (tiled) {
            s.densityTiling = 1.3f;
            Map share({7, 7, 1, PixelType::U8});
            for (int y = 0; y < 7; ++y)
                for (int x = 0; x < 7; ++x) share.set(x, y, 0, static_cast<float>(1 + (x * 3 + y) % 5) / 5);
            f.bladeHeight = field(share, "maps/b.png");
            f.bladeHeightTiling = 2.2f;
        }
        GrassField& grass = put(p, "grass", f);
        if (population == Population::Unique) own = makeUnique(grass.species[0], grass, t);
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
        for (const Blade& b : those) {
            const glm::vec2 in = f32::rootInCell(b.root, version.mirror, version.shift, f.cellSize);
            const glm::dvec2 at = glm::dvec2(x, z) * static_cast<double>(f.cellSize) + glm::dvec2(in),
                             place = at / mapExtent(t);
            if (tiledSample(f.species[0].density.map, tilingOf(t, f.species[0].densityTiling), at.x, at.y) <
                b.threshold)
                continue;
            const float share = f.bladeHeight.present()
                                    ? tiledSample(f.bladeHeight.map, tilingOf(t, f.bladeHeightTiling), at.x, at.y)
                                    : 1;
            const glm::vec4 texel =
                paintedAt(f.orientation.map, place, static_cast<double>(f.orientationTiling), false);
            const f32::BladePlace here = f32::bladePlace(
                f32::paintOf(texel.x, texel.y), leanAtFull(f.species[0]),
                f32::clumpValues(x, z, in, f.cellSize, f.species[0].clumpSize, static_cast<uint32_t>(f.seed)),
                clumpStrengths(f.species[0]));
            glm::vec2 lean = here.lean;
            if (const Wind* wind = windOf(p))
                lean += windLeanAt(windGlobals(*wind, glm::dvec2(x, z) * static_cast<double>(f.cellSize), kTime), gusts,
                                   in, b.dither) /
                        f.species[0].stiffness;
            glm::vec3 force = forceAt(forcesOf(p, kTime, &outlines), at);
            if (f.forces.present())
                force = f32::forceOf(force + f32::paintedForce(paintedAt(f.forces.map, place, 1, false)));
            lean = f32::forcedLean(lean, {force.x, force.y}, force.z, b.facing * version.mirror);
            addBlade(b, f32::poseBlade(b.control, b.tip, b.facing, version.mirror, lean, here.scale * share),
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
    int hits = 0, differ = 0, rays = 0;
    for (uint32_t i = 0; i < 20000; ++i) {
        const auto number = [&](uint32_t k) { return static_cast<double>(f32::hashUnit(f32::hash3(i, k, 11))); };
        const glm::dvec3 from(6 * number(0), 1.2 * number(1) + 0.1, 6 * number(2)),
            to(6 * number(3), 0.8 * number(4), 6 * number(5));
        const Ray ray{from, glm::normalize(to - from), 0, std::numeric_limits<double>::infinity(), i};
        const auto ours = grass->closest(ray, memory);
        const auto theirs = brute->closest(glm::vec3(from), glm::vec3(ray.way), 0, 1e9f);
        ++rays;
        hits += theirs.has_value();
        differ += ours.has_value() != theirs.has_value() ||
                  (ours && std::abs(ours->t - static_cast<double>(theirs->t)) > 2e-3);
        EXPECT_EQ(ours.has_value(), grass->blocks(ray, memory)) << i;
    }
    EXPECT_GT(hits, rays / 6);
    EXPECT_LT(differ, rays / 500) << "only rays that graze an edge of a triangle";
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
