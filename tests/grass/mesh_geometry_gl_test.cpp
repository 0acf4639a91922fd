// Blades drawn one by one on meshes: against their ray-traced truth and against rays through slices, where both meet,
// and what is not drawn.
#include "grass/mesh_geometry.h"

#include "core/log.h"
#include "grass/on_mesh.h"
#include "mesh_grass_scenes.h"

namespace sward::test {
namespace {

Project bladesOnMesh(const TempDir& dir, const Solid& solid, Technique technique = Technique::Geometry,
                     const glm::dvec3& at = {10, 0, 10}) {
    Project p = grassOnMesh(dir, solid, at);
    flatField(p).technique = nameOf(technique);
    return p;
}
uint64_t bladesDrawn(Renderer& r, const Project& p, const ViewCamera& camera) {
    EXPECT_TRUE(r.draw(p, camera, meshSized(64, 48, 1)));
    return r.stats().bladesGeometry;
}
double meanDifference(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0;
    for (size_t i = 0; i < a.size(); ++i) sum += std::abs(static_cast<double>(a[i] - b[i]));
    return sum / static_cast<double>(a.size());
}

TEST(MeshGeometry, ShinesAsItsTruth) {
    NoGlErrors errors;
    const TempDir dir;
    const Project p = bladesOnMesh(dir, kGrassBall);
    for (const ViewCamera& camera : {viewOfBall(), ViewCamera{{11.5, 0.7, 11.2}, {10, 0.6, 10}, 45, 0}}) {
        const auto blades = meshPicture(p, camera), traced = meshTruth(p, camera);
        std::printf("covered: truth %.3f blades %.3f; bright: %.4f %.4f\n", covered(traced), covered(blades),
                    brightness(traced), brightness(blades));
        EXPECT_NEAR(covered(blades), covered(traced), 0.06);
        EXPECT_NEAR(brightness(blades), brightness(traced), 0.12 * brightness(traced));
    }
}

// Pixel by pixel, from near: both have the same blades.
TEST(MeshGeometry, StandsBladeByBladeWhereItsTruthDoes) {
    NoGlErrors errors;
    const TempDir dir;
    const Project p = bladesOnMesh(dir, kGrassBall), rays = bladesOnMesh(dir, kGrassBall, Technique::Raytraced);
    Project other = snapshot(p, tables().components);
    flatField(other).grows.seed = 77;
    const ViewCamera camera{{10.7, 1.2, 10.6}, {10.2, 0.9, 10.2}, 30, 0};
    const auto traced = meshTruth(p, camera);
    const double blades = meanDifference(meshPicture(p, camera), traced),
                 slices = meanDifference(meshPicture(rays, camera), traced),
                 others = meanDifference(meshTruth(other, camera), traced);
    std::printf("off the truth: blades %.4f, rays %.4f, other blades %.4f\n", blades, slices, others);
    EXPECT_LT(blades, 0.7 * others);
    EXPECT_LT(blades, 0.75 * slices);
}

TEST(MeshGeometry, StandsOutAgainstTheSkyWhereItsTruthDoes) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = bladesOnMesh(dir, kGrassBall, Technique::Geometry, {10, 5, 10});
    p.registry.get<StaticMesh>(findEntity(p, "rock"))->onGround = false;
    const ViewCamera camera{{10, 6.0, 9.2}, {10, 6.13, 10}, 30, 0};
    const auto traced = meshTruth(p, camera);
    const double blades = skyExchanged(meshPicture(p, camera), traced);
    flatField(p).technique = nameOf(Technique::Raytraced);
    const double rays = skyExchanged(meshPicture(p, camera), traced);
    flatField(p).grows.seed = 77;
    const double others = skyExchanged(meshTruth(p, camera), traced);
    std::printf("sky and grass exchanged: blades %.4f, rays %.4f, other blades %.4f\n", blades, rays, others);
    EXPECT_LT(blades, 0.8 * others);
    EXPECT_LT(blades, 0.8 * rays);
}

// In the middle of the range in which blades give way to rays there is as much grass as before and behind it.
TEST(MeshGeometry, GivesWayToRaysWithoutAGap) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = bladesOnMesh(dir, {.size = {6, 0.02f, 6}, .unwrap = true}, Technique::Hybrid);
    const ViewCamera camera{{10, 1.6, 8}, {10, 0.05, 10}, 30, 0};
    const auto at = [&](float from, float to) {
        flatField(p).minGeom = from, flatField(p).maxGeom = to;
        return meshPicture(p, camera);
    };
    const auto blades = at(20, 30), half = at(1, 4.2f), rays = at(0, 0.1f);
    std::printf("covered: blades %.3f, both %.3f, rays %.3f; bright: %.4f, %.4f, %.4f\n", covered(blades),
                covered(half), covered(rays), brightness(blades), brightness(half), brightness(rays));
    EXPECT_GT(meanDifference(half, blades), 0.1 * meanDifference(rays, blades));
    EXPECT_GT(meanDifference(half, rays), 0.1 * meanDifference(rays, blades));
    EXPECT_GT(covered(half), std::min(covered(blades), covered(rays)) - 0.03);
    EXPECT_LT(covered(half), std::max(covered(blades), covered(rays)) + 0.03);
    EXPECT_NEAR(brightness(half), 0.5 * (brightness(blades) + brightness(rays)), 0.08 * brightness(blades));
}

TEST(MeshGeometry, DrawsWhatIsNearInViewAndNotBehindItsMesh) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = bladesOnMesh(dir, kGrassBall, Technique::Hybrid);
    flatField(p).minGeom = 3, flatField(p).maxGeom = 4;
    Renderer r(gpu(), tables());
    const uint64_t near = bladesDrawn(r, p, viewOfBall());
    EXPECT_GT(near, 3000u);
    EXPECT_LT(near, 13000u) << "15,700 stand on the ball, of which half lie behind it";
    EXPECT_EQ(bladesDrawn(r, p, {{10, 1.1, 8}, {10, 1.1, 0}, 45, 0}), 0u) << "behind the eye";
    EXPECT_EQ(bladesDrawn(r, p, {{10, 3, 0}, {10, 0.6, 10}, 45, 0}), 0u) << "beyond maxGeom";
    // Blades that are narrower than half a pixel stand for each other.
    flatField(p).technique = nameOf(Technique::Geometry);
    EXPECT_LT(bladesDrawn(r, p, {{10, 3, 0}, {10, 0.6, 10}, 45, 0}), near / 4);
}

// A roof whose grass looks away from the eye shows its tips over the ridge.
TEST(MeshGeometry, StandsOverARidge) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = bladesOnMesh(dir, {.size = {2, 0.1f, 1}, .turnDeg = {-25, 0, 0}, .unwrap = true}, Technique::Geometry,
                             {10, 5, 10});
    p.registry.get<StaticMesh>(findEntity(p, "rock"))->onGround = false;
    Map above({48, 48, 1, PixelType::U8});  // the face that looks up is the first of the second row of squares
    for (int y = 16; y < 32; ++y)
        for (int x = 0; x < 16; ++x) above.set(x, y, 0, 1);
    put(p, "rock", MeshGrass{.density = field(above)});
    const ViewCamera behind{{10, 5.1, 12}, {10, 5.25, 10}, 40, 0};
    Renderer r(gpu(), tables());
    EXPECT_GT(bladesDrawn(r, p, behind), 1000u);
    const auto traced = meshTruth(p, behind), blades = meshPicture(p, behind);
    put(p, "rock", MeshGrass{.density = field(filled({8, 8, 1, PixelType::U8}, 0))});
    const auto bare = meshPicture(p, behind);
    // Pixels of sky that grass hides.
    const auto hidden = [&](const std::vector<float>& with) {
        size_t n = 0;
        for (size_t i = 2; i < with.size(); i += 3) n += bare[i] > 0.2f && with[i] < 0.6f * bare[i];
        return static_cast<double>(n);
    };
    std::printf("pixels of grass over the ridge: truth %.0f, blades %.0f\n", hidden(traced), hidden(blades));
    EXPECT_GT(hidden(traced), 50);
    EXPECT_NEAR(hidden(blades) / hidden(traced), 1, 0.35);
}

TEST(MeshGeometry, FollowsItsMapsAsIfPlantedAnew) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = bladesOnMesh(dir, kGrassBall);
    Renderer r(gpu(), tables());
    const ViewCamera above{{10, 2.4, 9.4}, {10, 0.6, 10}, 30, 0};  // no sky, which is greener than red
    const auto drawn = [&] {
        EXPECT_TRUE(r.draw(p, above, meshSized(96, 72, 1)));
        const auto here = r.readLinear();
        EXPECT_EQ(here, meshPicture(p, above, meshSized(96, 72, 1)));
        return here;
    };
    const auto all = drawn();
    put(p, "rock", MeshGrass{.density = field(filled({8, 8, 1, PixelType::U8}, 0.3f))});
    const auto thin = drawn();
    EXPECT_LT(covered(thin), covered(all) - 0.02);
    Map red({8, 8, 4, PixelType::U8});
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) red.set(x, y, 0, 0.7f), red.set(x, y, 3, 1);
    put(p, "rock", MeshGrass{.vegetation = field(red)});
    EXPECT_LT(covered(drawn()), 0.02);
    put(p, "rock", MeshGrass{.orientation = field(filled({8, 8, 2, PixelType::U16}, 0.9f))});
    EXPECT_NE(drawn(), all);
    put(p, "rock", MeshGrass{.uvLength = 1.5f});
    EXPECT_NE(drawn(), all);
    put<MeshGrass>(p, "rock");
    p.registry.get<StaticMesh>(findEntity(p, "rock"))->scale = 1.2f;
    EXPECT_NE(drawn(), all);
}

TEST(MeshGeometry, LeavesTooManyToTheRaysAndSaysSo) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = bladesOnMesh(dir, kGrassPlate, Technique::Hybrid);
    flatField(p).drawing.bakeLight = BakeLight::Local;  // where they are drawn is the same in any light
    flatField(p).species[0].bladesPerM2 = static_cast<float>(1.1 * kMostDrawnOnMesh / (20 * 20));  // on both sides
    std::string said;
    const int sink = addLogSink([&](LogLevel, const std::string& text) { said += text + "\n"; });
    testing::internal::CaptureStderr();
    Renderer r(gpu(), tables());
    EXPECT_EQ(bladesDrawn(r, p, viewOfBall()), 0u);
    testing::internal::GetCapturedStderr();
    removeLogSink(sink);
    EXPECT_GT(covered(r.readLinear()), 0.1) << "by rays";
    EXPECT_NE(
        said.find("rock.MeshGrass: 2.2 million blades would stand there: above 1 million they are drawn by rays alone"),
        std::string::npos)
        << said;
}

TEST(MeshGeometry, HasNoPixelThatIsNoNumberFromAnywhere) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = bladesOnMesh(dir, kGrassBall);
    put<Wind>(p, "wind");
    Renderer r(gpu(), tables());
    int wrong = 0;
    for (int i = 0; i < 60; ++i) {
        glm::dvec3 out(std::cos(2.4 * i), std::cos(1.7 * i), std::sin(2.4 * i));
        if (i < 6) out = glm::dvec3(0), out[i / 2] = i % 2 ? 1 : -1;
        const glm::dvec3 middle(10, 0.6, 10);
        const double far = i % 3 == 0 ? 0.52 : i % 3 == 1 ? 0.6 : 1.5;
        const ViewCamera camera{middle + glm::normalize(out) * far, middle, 60, 0};
        ASSERT_TRUE(r.draw(p, camera, meshSized(48, 36, i % 2 ? 1 : 4)));
        const auto pixels = r.readLinear();
        wrong += !std::all_of(pixels.begin(), pixels.end(), [](float v) { return std::isfinite(v) && v >= 0; });
    }
    EXPECT_EQ(wrong, 0);
}

TEST(MeshGeometry, GoesWithItsBladesWhenTheTechniqueHasNone) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = bladesOnMesh(dir, kGrassBall);
    Renderer r(gpu(), tables());
    ASSERT_TRUE(r.draw(p, viewOfBall(), meshSized(64, 48, 1)));
    EXPECT_GT(gpu().ledger.at("grass/mesh-geometry"), 48 * 10'000);
    EXPECT_NE(r.explain(p, false).find("near blades on objects are drawn one by one"), std::string::npos);
    flatField(p).technique = nameOf(Technique::Flat);
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(r.draw(p, viewOfBall(), meshSized(64, 48, 1)));
    EXPECT_FALSE(gpu().ledger.contains("grass/mesh-geometry") && gpu().ledger.at("grass/mesh-geometry") > 0);
    EXPECT_EQ(r.stats().bladesGeometry, 0u);
}

}  // namespace
}  // namespace sward::test
