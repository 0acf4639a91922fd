// The ray-traced truth against what is known without it: furnaces, a shadow by geometry, statistics. Rays against
// blades: grass_rays_test.cpp.
#include "reference/reference.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "core/file.h"
#include "core/numerics.h"
#include "fields.h"
#include "maps/map_io.h"
#include "objects.h"
#include "reference/grass_rays.h"
#include "reference/reference_part.h"
#include "sky/daylight.h"
#include "sky/exposure.h"
#include "support.h"
#include "techniques.h"
#include "tests/reference/plain_image.h"
#include "world/view_camera.h"

namespace sward::test {
namespace {

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
    FlatField f;
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
    FlatField f;
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

// A picture of one block that would take minutes: who cancels it does not wait for the block, and sees how far it is.
TEST(ReferenceSamples, CancellingWaitsForNoWholeBlock) {
    JobControl control;
    auto scene = ReferenceScene::make(lawn(), tables(), 0, control);
    ASSERT_TRUE(scene);
    std::thread tracing([&] { EXPECT_FALSE(scene->trace(eyeHeight(), sized(8, 8, kMaxReferenceSamples), control)); });
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    const double share = control.progress();
    control.cancel();
    const auto asked = std::chrono::steady_clock::now();
    tracing.join();
    EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::seconds(2));
    EXPECT_LT(share, 0.9) << "else nothing was tried";
}

struct Parts : testing::Test {
    TempDir dir;
    Project p = lawn();
    int bandRows = kShardRows;
    std::filesystem::path part(int shard, int shards, const std::string& name, uint64_t of = 7) {
        ReferenceSettings s = sized(50, 37, 2);
        s.shard = shard, s.shards = shards, s.bandRows = bandRows;
        EXPECT_TRUE(writeFileAtomic(dir / name, encodePart({"eye", of, s, traced(p, eyeHeight(), s)})));
        return dir / name;
    }
};
TEST_F(Parts, MergedEqualTheWholeBitForBit) {
    const Truth whole = traced(p, eyeHeight(), sized(50, 37, 2));
    for (const int rows : {kShardRows, 3, 1}) {
        bandRows = rows;
        const auto merged = mergeParts({part(2, 3, "c"), part(0, 3, "a"), part(1, 3, "b")});
        ASSERT_TRUE(merged) << merged.error().text();
        EXPECT_EQ(whole.color, merged->color) << "bands of " << rows;
        EXPECT_EQ(whole.error, merged->error) << "bands of " << rows;
        EXPECT_EQ(whole.grass, merged->grass) << "bands of " << rows;
    }
}

}  // namespace
}  // namespace sward::test
