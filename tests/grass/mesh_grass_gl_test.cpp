// Grass on meshes: against its ray-traced truth, against the terrain's, in the views that break rays, and what is said
// of what it cannot do.
#include "grass/mesh_grass.h"

#include <memory>
#include <random>

#include "core/log.h"
#include "fields.h"
#include "grass/mesh_grass_settings.h"
#include "mesh_grass_scenes.h"
#include "objects.h"
#include "pixels.h"
#include "project/project_files.h"
#include "reference/reference.h"
#include "scenes.h"
#include "support.h"

namespace sward::test {
namespace {

struct Box {
    int left, top, right, bottom;  // pixels
};
double green(const std::vector<float>& image, int width, const Box& in) {
    double sum = 0;
    for (int y = in.top; y < in.bottom; ++y)
        for (int x = in.left; x < in.right; ++x) sum += static_cast<double>(image[3 * size_t(y * width + x) + 1]);
    return sum / ((in.right - in.left) * (in.bottom - in.top));
}
Light& sunOf(Project& p) { return *p.registry.get<Light>(findEntity(p, "sun")); }

TEST(MeshGrass, OnAPlateIsWhatTheTerrainsIs) {
    NoGlErrors errors;
    const TempDir dir;
    for (const ViewCamera& camera :
         {ViewCamera{{10, 0.6, 8.4}, {10, 0.05, 10}, 40, 0}, ViewCamera{{10, 2, 9}, {10, 0, 10}, 40, 0}}) {
        const auto ground = meshPicture(meshMeadow(dir), camera),
                   plate = meshPicture(grassOnMesh(dir, kGrassPlate), camera);
        std::printf("covered: terrain %.3f plate %.3f; bright: %.4f %.4f\n", covered(ground), covered(plate),
                    brightness(ground), brightness(plate));
        EXPECT_NEAR(covered(plate), covered(ground), 0.06);
        EXPECT_NEAR(brightness(plate), brightness(ground), 0.1 * brightness(ground));
    }
}

TEST(MeshGrass, OnABallCoversAndShinesAsItsTruth) {
    NoGlErrors errors;
    const TempDir dir;
    const Project p = grassOnMesh(dir, kGrassBall);
    Project bald = snapshot(p, tables().components);
    bald.registry.remove<MeshGrass>(findEntity(bald, "rock"));
    for (const ViewCamera& camera : {viewOfBall(), ViewCamera{{11.5, 0.7, 11.2}, {10, 0.6, 10}, 45, 0}}) {
        const auto rays = meshPicture(p, camera), traced = meshTruth(p, camera), none = meshPicture(bald, camera);
        std::printf("covered: truth %.3f rays %.3f none %.3f; bright: %.4f %.4f %.4f\n", covered(traced), covered(rays),
                    covered(none), brightness(traced), brightness(rays), brightness(none));
        EXPECT_GT(covered(traced) - covered(none), 0.05) << "the ball is seen";
        EXPECT_NEAR(covered(rays), covered(traced), 0.06);
        EXPECT_NEAR(brightness(rays), brightness(traced), 0.12 * brightness(traced));
    }
}

// Beyond the ball's own outline nothing but grass can be green before the sky.
TEST(MeshGrass, StandsOutAgainstTheSkyAtTheOutline) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = grassOnMesh(dir, kGrassBall, {10, 5, 10});
    p.registry.get<StaticMesh>(findEntity(p, "rock"))->onGround = false;
    const ViewCamera camera{{10, 5, 8}, {10, 5.6, 10}, 45, 0};
    Project bald = snapshot(p, tables().components);
    bald.registry.remove<MeshGrass>(findEntity(bald, "rock"));
    const auto rays = meshPicture(p, camera), none = meshPicture(bald, camera), traced = meshTruth(p, camera);
    // Pixels that show sky without the grass, and no sky with it.
    const auto standing = [&](const std::vector<float>& with) {
        size_t n = 0;
        for (size_t i = 0; i < with.size(); i += 3)
            n += none[i + 2] > 1.2f * none[i + 1] * 0.8f && none[i + 2] > 0.15f && with[i + 2] < 0.6f * none[i + 2];
        return static_cast<double>(n);
    };
    std::printf("pixels of grass before the sky: truth %.0f rays %.0f\n", standing(traced), standing(rays));
    EXPECT_GT(standing(traced), 300);
    EXPECT_NEAR(standing(rays) / standing(traced), 1, 0.35);
}

// A rock's surface does not bend evenly: behind its first hump grass stands on the next one, with no sky between both.
TEST(MeshGrass, ClosesARoughOutlineAsItsTruth) {
    NoGlErrors errors;
    const TempDir dir;
    const Solid rock{.kind = SolidKind::Ball,
                     .size = {0.9f, 0.6f, 0.7f},
                     .at = {0, 0.3f, 0},
                     .rough = 0.2f,
                     .seed = 52,
                     .unwrap = true};
    const Project p = grassOnMesh(dir, rock);
    Project other = snapshot(p, tables().components);
    flatField(other).grows.seed = 77;
    for (const ViewCamera& camera :
         {ViewCamera{{10, 0.55, 8.3}, {10, 0.8, 10}, 45, 0}, ViewCamera{{8.4, 0.6, 9.2}, {10, 0.8, 10}, 45, 0}}) {
        const auto traced = meshTruth(p, camera);
        const double rays = skyExchanged(meshPicture(p, camera), traced),
                     blades = skyExchanged(meshTruth(other, camera), traced);
        std::printf("sky and grass exchanged: %.4f of the rock; by other blades of the field: %.4f\n", rays, blades);
        EXPECT_LT(rays, 2.2 * blades);  // 3.4 and 2.6 where a ray does not know where it leaves the shell
    }
}

// A ball's grass has the sun in another direction at each place: on one side its tips alone look over the horizon, on
// the other it is lit by the sky.
TEST(MeshGrass, IsLitAsItsTruthOnTheSideThatTurnsFromTheSun) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = grassOnMesh(dir, kGrassBall, {10, 5, 10});  // its shadow on the ground is far away
    p.registry.get<StaticMesh>(findEntity(p, "rock"))->onGround = false;
    sunOf(p).azimuthDeg = 150, sunOf(p).elevationDeg = 30;
    const ViewCamera camera{{10, 6.1, 8}, {10, 5.6, 10}, 45, 0};
    const auto rays = meshPicture(p, camera), traced = meshTruth(p, camera);
    for (const Box& side : {Box{48, 50, 60, 75}, Box{68, 50, 92, 75}}) {
        const double here = green(rays, 160, side), wanted = green(traced, 160, side);
        std::printf("from column %d on: green of rays %.4f, of the truth %.4f\n", side.left, here, wanted);
        EXPECT_NEAR(here / wanted, 1, 0.2);
    }
}

// What shades the surface does not shade the grass before it, however much nearer the surface comes within a pixel.
TEST(MeshGrass, ShowsAsMuchInWidePixelsAsInFineOnes) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = grassOnMesh(dir, {.size = {4, 0.02f, 4}, .unwrap = true});
    flatField(p).species[0].bladesPerM2 = 9000, flatField(p).species[0].height = 0.12f;
    const ViewCamera camera{{10, 3, 3}, {10, 0.05, 10}, 20, 0};
    const double fine = green(meshPicture(p, camera, meshSized(320, 240)), 320, {80, 80, 240, 200}),
                 wide = green(meshPicture(p, camera, meshSized(64, 48)), 64, {16, 16, 48, 40});
    std::printf("green: %.4f, in pixels five times as wide %.4f\n", fine, wide);
    EXPECT_NEAR(wide / fine, 1, 0.08);
}

// Rays that come in over the last of a roof go on over nothing.
TEST(MeshGrass, EndsWhereItsSurfaceDoes) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = grassOnMesh(dir, {.size = {2, 0.1f, 1}, .turnDeg = {-25, 0, 0}, .unwrap = true}, {10, 5, 10});
    p.registry.get<StaticMesh>(findEntity(p, "rock"))->onGround = false;
    Map above({48, 48, 1, PixelType::U8});  // the face that looks up is the first of the second row of squares
    for (int y = 16; y < 32; ++y)
        for (int x = 0; x < 16; ++x) above.set(x, y, 0, 1);
    put(p, "rock", MeshGrass{.density = field(above)});
    Project other = snapshot(p, tables().components);
    flatField(other).grows.seed = 77;
    const ViewCamera camera{{10, 4.8, 7}, {10, 5.2, 10}, 45, 0};
    const auto traced = meshTruth(p, camera);
    const double rays = skyExchanged(meshPicture(p, camera), traced),
                 blades = skyExchanged(meshTruth(other, camera), traced);
    std::printf("sky and grass exchanged: %.4f of the roof; by other blades of the field: %.4f\n", rays, blades);
    EXPECT_LT(rays, 2.2 * blades);
}

TEST(MeshGrass, SurroundsAnEyeWithinIt) {
    NoGlErrors errors;
    const TempDir dir;
    const Project p = grassOnMesh(dir, kGrassBall);
    for (const glm::dvec3& target : {glm::dvec3(10, 1.12, 12), glm::dvec3(12, 1.0, 11), glm::dvec3(9, 1.4, 9)}) {
        const ViewCamera camera{{10, 1.13, 10}, target, 60, 0};
        const auto rays = meshPicture(p, camera), traced = meshTruth(p, camera);
        std::printf("covered: truth %.3f rays %.3f; bright: %.3f %.3f\n", covered(traced), covered(rays),
                    brightness(traced), brightness(rays));
        EXPECT_GT(covered(traced), 0.1);
        EXPECT_NEAR(covered(rays), covered(traced), 0.15);
    }
}

TEST(MeshGrass, FollowsTheMapsOfItsMesh) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = grassOnMesh(dir, kGrassPlate);
    const ViewCamera camera{{10, 0.8, 8.6}, {10, 0.05, 10}, 40, 0};
    const double all = covered(meshPicture(p, camera));
    put(p, "rock", MeshGrass{.density = field(filled({16, 16, 1, PixelType::U8}, 0))});
    const double bare = covered(meshPicture(p, camera));
    put(p, "rock", MeshGrass{.density = field(filled({16, 16, 1, PixelType::U8}, 0.4f))});
    const double some = covered(meshPicture(p, camera));
    Project level = meshMeadow(dir);
    flatField(level).species[0].density = field(filled({16, 16, 1, PixelType::U8}, 0.4f));
    const double asLevel = covered(meshPicture(level, camera));
    std::printf("covered at density 1, 0.4, 0: %.3f %.3f %.3f; on level ground at 0.4: %.3f\n", all, some, bare,
                asLevel);
    EXPECT_LT(bare, 0.002);
    EXPECT_LT(some, all - 0.05);
    EXPECT_NEAR(some / asLevel, 1, 0.3);
    // Red opaque paint: no green is left.
    Map red({16, 16, 4, PixelType::U8});
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) red.set(x, y, 0, 0.7f), red.set(x, y, 3, 1);
    put(p, "rock", MeshGrass{.vegetation = field(red)});
    EXPECT_LT(covered(meshPicture(p, camera)), 0.02);
    // Leaning grass is another picture.
    Project lean = grassOnMesh(dir, kGrassPlate);
    flatField(lean).species[0].leanDeg = 45;
    const auto upright = meshPicture(lean, camera);
    put(lean, "rock", MeshGrass{.orientation = field(filled({16, 16, 2, PixelType::U16}, 0.9f))});
    EXPECT_NE(meshPicture(lean, camera), upright);
}

// Views along axes, straight down, from within the shell, from behind, at the poles and the seams.
TEST(MeshGrass, HasNoPixelThatIsNoNumberFromAnywhere) {
    NoGlErrors errors;
    const TempDir dir;
    const Project p = grassOnMesh(dir, kGrassBall);
    Renderer r(gpu(), tables());
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    int wrong = 0;
    for (int i = 0; i < 150; ++i) {
        glm::dvec3 out(unit(random), unit(random), unit(random));
        if (i < 12) out = glm::dvec3(0), out[i / 4] = i % 2 ? 1 : -1;
        out = glm::normalize(out + glm::dvec3(1e-9));
        const glm::dvec3 middle(10, 0.6, 10);
        const double far = i % 3 == 0 ? 0.52 : i % 3 == 1 ? 0.6 : 1.5;
        ViewCamera camera{middle + out * far, i % 5 == 4 ? middle + out * 3.0 : middle, 60, 0};
        if (i % 7 == 6) camera.target = camera.eye + glm::dvec3(1, 0, 0);
        const Status drawn = r.draw(p, camera, meshSized(64, 48, 1));
        ASSERT_TRUE(drawn);
        const auto pixels = r.readLinear();
        wrong += !std::all_of(pixels.begin(), pixels.end(), [](float v) { return std::isfinite(v) && v >= 0; });
    }
    EXPECT_EQ(wrong, 0);
}

TEST(MeshGrass, NeedsNoSecondBakeAndSharesImagesWithTheTerrains) {
    const TempDir dir;
    Project p = meshMeadow(dir);
    Renderer r(gpu(), tables());
    ASSERT_TRUE(r.draw(p, viewOfBall(), meshSized()));
    const auto before = gpu().ledger;
    putObject(p, "rock", {kGrassBall}, {10, 0, 10});
    put<MeshGrass>(p, "rock");
    ASSERT_TRUE(r.draw(p, viewOfBall(), meshSized()));
    for (const char* owner : {"grass/slices", "grass/far"})
        EXPECT_EQ(gpu().ledger.at(owner), before.at(owner)) << owner;
    EXPECT_GT(gpu().ledger.at("grass/mesh-grass"), 0);
}

TEST(MeshGrass, KeepsNothingOfASunThatIsRemoved) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = grassOnMesh(dir, kGrassBall);
    const auto bytes = [&](Renderer& r) {
        EXPECT_TRUE(r.draw(p, viewOfBall(), meshSized()));
        return gpu().ledger.at("grass/mesh-grass");
    };
    auto had = std::make_unique<Renderer>(gpu(), tables());
    const auto with = bytes(*had);
    p.registry.remove<Light>(findEntity(p, "sun"));
    const auto without = bytes(*had);
    had = nullptr;  // what it holds is in the ledger, too
    Renderer never(gpu(), tables());
    EXPECT_EQ(without, bytes(never)) << "as much as where no sun has been";
    EXPECT_LT(without, with);
}

TEST(MeshGrass, OfAFieldThatLeavesTheTerrainReadsNoneOfItsMaps) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = meshMeadow(dir);
    FlatField f = flatField(p);
    f.drawing.bakeLight = BakeLight::Local;  // what it reads is in the ledger in any light
    f.species[0].density = field(filled({16, 16, 1, PixelType::U8}, 0.8f), "maps/d.png");
    f.vegetation = field(filled({16, 16, 4, PixelType::U8}, 0.4f), "maps/v.png");
    f.orientation = field(filled({16, 16, 2, PixelType::U16}, 0.8f), "maps/o.png");
    putObject(p, "rock", {kGrassBall}, {10, 0, 10});
    put<MeshGrass>(p, "rock");
    Renderer r(gpu(), tables());
    ASSERT_TRUE(r.draw(p, viewOfBall(), meshSized(64, 48, 1)));
    f.grows.onTerrain = false;
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(r.draw(p, viewOfBall(), meshSized(64, 48, 1)));
    EXPECT_FALSE(gpu().ledger.contains("grass/vegetation") && gpu().ledger.at("grass/vegetation") > 0);
}

TEST(MeshGrass, SaysWhatItFollowsAndThatOnlyTechniquesOfBladesChangeIt) {
    const TempDir dir;
    Project p = grassOnMesh(dir, kGrassBall);
    put<Wind>(p, "wind");
    put<ForceSource>(p, "stone");
    put(p, "stone", Transform{{10, 0, 8}});
    Renderer r(gpu(), tables());
    ASSERT_TRUE(r.draw(p, viewOfBall(), meshSized()));
    const std::string told = r.explain(p, false);
    EXPECT_NE(told.find("rays through slices, but for blades that are drawn one by one"), std::string::npos) << told;
    EXPECT_NE(told.find("grass on meshes is not pressed"), std::string::npos) << told;
    EXPECT_EQ(told.find("grass/far:"), std::string::npos) << "nothing grows on the terrain";
    const auto rays = meshPicture(p, viewOfBall(), meshSized(64, 48, 1));
    for (const char* technique : kTechniqueNames) {
        flatField(p).technique = technique;
        const bool blades = technique == nameOf(Technique::Hybrid) || technique == nameOf(Technique::Geometry);
        EXPECT_EQ(meshPicture(p, viewOfBall(), meshSized(64, 48, 1)) == rays, !blades) << technique;
    }
}

TEST(MeshGrass, OnAMeshWithoutTextureCoordinatesIsRefusedByCheckAndToldOnceWhenDrawn) {
    NoGlErrors errors;
    const TempDir dir;
    Solid ball = kGrassBall;
    ball.unwrap = false;
    Project p = grassOnMesh(dir, ball);
    ASSERT_TRUE(saveProject(p, tables().components));
    const CheckReport report = checkProject(dir.path, tables().components);
    ASSERT_EQ(report.refused.size(), 1u);
    EXPECT_NE(report.refused[0].text().find("rock.glb has no texture coordinates"), std::string::npos);
    Renderer r(gpu(), tables());
    ASSERT_TRUE(r.draw(p, viewOfBall(), meshSized()));
    ASSERT_TRUE(r.draw(p, viewOfBall(), meshSized()));
    // Half of it: a part that is unwrapped beside one that is not.
    putObject(p, "rock", {kGrassBall, {.size = {0.2f, 1.4f, 0.2f}}}, {10, 0, 10});
    ASSERT_TRUE(saveProject(p, tables().components));
    const CheckReport half = checkProject(dir.path, tables().components);
    EXPECT_TRUE(half.refused.empty());
    ASSERT_EQ(half.noticed.size(), 1u);
    EXPECT_NE(half.noticed[0].message.find("12 of rock.glb's triangles"), std::string::npos) << half.noticed[0].message;
}

}  // namespace
}  // namespace sward::test
