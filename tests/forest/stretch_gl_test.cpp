// Forests with a vertical scale, as volumes and as meshes: as bright and as high against the sky as the same trees
// traced, by the limits that hold for those of scale 1, from the same volumes.
#include "forest/stretch.h"

#include "lamps.h"
#include "reference/reference.h"
#include "scenes.h"
#include "world/forest_stand.h"

namespace sward::test {
namespace {

constexpr size_t kWidth = 160, kHeight = 120;

Forest& treesOf(Project& p) { return *p.registry.get<Forest>(findEntity(p, "trees")); }
Project stretchedWood(TreeKind kind, float meshesTo, float verticalScale, float perHectare = 400) {
    Project p = lawn();
    removeEntity(p, "grass");
    Terrain& t = *p.registry.get<Terrain>(findEntity(p, "ground"));
    t.size = {160, 160};
    t.groundColor = {0.2f, 0.05f, 0.02f};
    put<Forest>(p, "trees",
                {.species = {{.kind = kind, .leaves = 1500}},
                 .perHectare = perHectare,
                 .distance = 3,
                 .verticalScale = verticalScale,
                 .meshesTo = meshesTo});
    return p;
}
const ViewCamera kFromTheAir{{80, 90, 210}, {80, 0, 80}, 40, 0};
// Its horizon lies in the picture's middle.
const ViewCamera kFromTheSide{{80, 7, 260}, {80, 7, 80}, 30, 0};

std::vector<float> pictureAt(const Project& p, const ViewCamera& c, double time = 0) {
    Renderer renderer(gpu(), tables());
    ViewSettings s = small();
    s.time = time;
    EXPECT_TRUE(renderer.draw(p, c, s));
    return renderer.readLinear();
}
std::vector<float> truthOf(const Project& p, const ViewCamera& c, double time = 0) {
    JobControl control;
    const auto scene = ReferenceScene::make(p, tables(), time, control);
    EXPECT_TRUE(scene) << scene.error().text();
    ReferenceSettings settings;
    settings.width = kWidth, settings.height = kHeight, settings.samples = 16;
    return scene->trace(c, settings, control)->color;
}
// Mean of a picture's lower middle, where trees are.
glm::dvec3 meanLight(const std::vector<float>& pixels) {
    glm::dvec3 sum(0);
    for (size_t y = 50; y < 90; ++y)
        for (size_t x = 40; x < 120; ++x)
            for (int c = 0; c < 3; ++c)
                sum[c] += static_cast<double>(pixels[3 * (y * kWidth + x) + static_cast<size_t>(c)]);
    return sum / (40.0 * 80.0);
}
// Pixels over the horizon in which something else than the sky is seen.
int coverOf(const std::vector<float>& pixels, const std::vector<float>& bare) {
    int n = 0;
    for (size_t i = 0; i < 3 * kWidth * (kHeight / 2 - 2); i += 3)
        n += std::abs(pixels[i] - bare[i]) + std::abs(pixels[i + 2] - bare[i + 2]) > 0.04f;
    return n;
}
const std::pair<const char*, TreeKind> kKinds[] = {{"conifers", TreeKind::Conifer},
                                                   {"broadleaves", TreeKind::Broadleaf}};

TEST(StretchedForest, IsAsBrightAsTheTruthByVolumesAndByMeshes) {
    NoGlErrors errors;
    for (const auto& [kind, of] : kKinds)
        for (const ViewCamera* camera : {&kFromTheAir, &kFromTheSide}) {
            const glm::dvec3 none = meanLight(pictureAt(stretchedWood(of, 0, 1, 0), *camera));
            for (const float scale : {0.5f, 2.0f}) {
                const glm::dvec3 truth = meanLight(truthOf(stretchedWood(of, 0, scale), *camera)),
                                 volumes = meanLight(pictureAt(stretchedWood(of, 0, scale), *camera)),
                                 meshes = meanLight(pictureAt(stretchedWood(of, 400, scale), *camera));
                const std::string what =
                    fmt::format("{}, {}, scale {:.1f}", kind, camera == &kFromTheAir ? "air" : "side", scale);
                std::printf("%s: truth %.4f, volumes %.4f, meshes %.4f, bare %.4f\n", what.c_str(), truth.y, volumes.y,
                            meshes.y, none.y);
                const double error = glm::length(volumes - truth) / glm::length(truth),
                             without = glm::length(none - truth) / glm::length(truth);
                EXPECT_LT(error, 0.3) << what;
                EXPECT_LT(error, 0.5 * without) << what << ": bare ground must lose";
                EXPECT_NEAR(meshes.y / truth.y, 1, 0.3) << what;
            }
        }
}

TEST(StretchedForest, StandsAsHighAgainstTheSkyAsTheTruth) {
    NoGlErrors errors;
    for (const auto& [kind, of] : kKinds) {
        const std::vector<float> bare = pictureAt(stretchedWood(of, 0, 1, 0), kFromTheSide),
                                 sky = truthOf(stretchedWood(of, 0, 1, 0), kFromTheSide);
        int lower = -1;
        for (const float scale : {0.5f, 1.0f, 2.0f}) {
            const int truth = coverOf(truthOf(stretchedWood(of, 0, scale), kFromTheSide), sky),
                      volumes = coverOf(pictureAt(stretchedWood(of, 0, scale), kFromTheSide), bare),
                      meshes = coverOf(pictureAt(stretchedWood(of, 400, scale), kFromTheSide), bare);
            std::printf("%s, scale %.1f: pixels against the sky: truth %d, volumes %d, meshes %d\n", kind,
                        static_cast<double>(scale), truth, volumes, meshes);
            if (truth > 200) EXPECT_NEAR(static_cast<double>(volumes) / truth, 1, 0.1) << kind << " " << scale;
            if (truth > 200) EXPECT_NEAR(static_cast<double>(meshes) / truth, 1, 0.1) << kind << " " << scale;
            EXPECT_GT(truth, lower + 500 * (scale > 0.5f)) << "or the truth knows of no scale";
            lower = truth;
        }
    }
}

// What stands twice as high leans by as much a metre: its top moves twice as far.
TEST(StretchedForest, LeansInTheTruthAsItIsDrawn) {
    NoGlErrors errors;
    const ViewCamera side{{80, 12, 150}, {80, 12, 80}, 30, 0};
    Project calm = stretchedWood(TreeKind::Broadleaf, 400, 2, 0), bare = stretchedWood(TreeKind::Broadleaf, 400, 2, 0);
    treesOf(calm).placed = {{.at = {80, 80}}};
    Project windy = snapshot(calm, tables().components);
    put<Wind>(windy, "wind", {.strength = 2, .azimuthDeg = 90, .turbulence = 0.2f});
    const auto middle = [&](const std::vector<float>& pixels, const std::vector<float>& sky) {
        double sum = 0, at = 0;
        for (size_t i = 0; i < kWidth * (kHeight / 2 - 2); ++i)
            if (std::abs(pixels[3 * i + 2] - sky[3 * i + 2]) > 0.04f) sum += 1, at += static_cast<double>(i % kWidth);
        EXPECT_GT(sum, 50) << "a crown in the picture's upper half";
        return at / sum;
    };
    const std::vector<float> sky = pictureAt(bare, side), tracedSky = truthOf(bare, side);
    const double upright = middle(pictureAt(calm, side), sky);
    EXPECT_NEAR(upright, middle(truthOf(calm, side), tracedSky), 1);
    double farthest = 0;
    for (const double time : {0.0, 3.0, 7.0}) {
        const double ours = middle(pictureAt(windy, side, time), sky),
                     truth = middle(truthOf(windy, side, time), tracedSky);
        std::printf("at %.0f s: drawn %.2f, truth %.2f, upright %.2f\n", time, ours, truth, upright);
        EXPECT_NEAR(ours, truth, 1);
        farthest = std::max(farthest, std::abs(truth - upright));
    }
    EXPECT_GT(farthest, 3) << "or this shows nothing";
}

// Lamps' light goes the baked ways, too.
TEST(StretchedForest, IsAsBrightInALampsLightAsItsMeshes) {
    NoGlErrors errors;
    const ViewCamera eye{{80, 10, 215}, {80, 6, 80}, 40, 0};
    for (const auto& [kind, of] : kKinds)
        for (const float scale : {0.5f, 2.0f}) {
            const auto green = [&](float meshesTo) {
                Project p = stretchedWood(of, meshesTo, scale);
                for (const char* name : {"sun", "sky", "haze"}) removeEntity(p, name);
                p.registry.get<Terrain>(findEntity(p, "ground"))->groundColor = glm::vec3(0);
                putLamp(p, "lamp", {80, 8, 172}, {.intensity = 20, .attenuation = 0.02f});
                double sum = 0;
                const std::vector<float> pixels = pictureAt(p, eye);
                for (size_t i = 1; i < pixels.size(); i += 3) sum += static_cast<double>(pixels[i]);
                return sum;
            };
            const double volumes = green(0), meshes = green(400);
            std::printf("%s, scale %.1f: volumes %.3f of meshes' light\n", kind, static_cast<double>(scale),
                        volumes / meshes);
            EXPECT_GT(meshes, 10) << kind;
            EXPECT_NEAR(volumes / meshes, 1, 0.15) << kind << " " << scale;
        }
}

// Changed while it is drawn, it comes to what it is from the start; and no volume is baked or kept a second time.
TEST(StretchedForest, FollowsItsScaleWithoutAnotherBake) {
    NoGlErrors errors;
    Renderer renderer(gpu(), tables());
    Project p = stretchedWood(TreeKind::Birch, 160, 1);
    ASSERT_TRUE(renderer.draw(p, kFromTheAir, small()));
    const std::vector<float> once = renderer.readLinear();
    const auto bytes = gpu().ledger["forest/texcells"];
    treesOf(p).verticalScale = 2;
    ASSERT_TRUE(renderer.draw(p, kFromTheAir, small()));
    EXPECT_EQ(renderer.readLinear(), pictureAt(stretchedWood(TreeKind::Birch, 160, 2), kFromTheAir));
    EXPECT_NE(renderer.readLinear(), once);
    const auto stretched = gpu().ledger["forest/texcells"];
    EXPECT_LT(static_cast<double>(stretched), 1.05 * static_cast<double>(bytes)) << "but for what a view lists";
    treesOf(p).verticalScale = 1;
    ASSERT_TRUE(renderer.draw(p, kFromTheAir, small()));
    EXPECT_EQ(renderer.readLinear(), once);
}

TEST(StretchedForest, LeastAndGreatestScalesGiveFinitePictures) {
    NoGlErrors errors;
    for (const float scale : {0.25f, 4.0f})
        for (const float meshesTo : {0.0f, 400.0f})
            for (const ViewCamera& c : {kFromTheAir, ViewCamera{{80, 6, 80}, {80, 6, 0}, 55, 0},
                                        ViewCamera{{-50, 0.001, 80}, {80, 0.001, 80}, 55, 0}})
                for (const float x : pictureAt(stretchedWood(TreeKind::Conifer, meshesTo, scale), c))
                    ASSERT_TRUE(std::isfinite(x) && x >= 0 && x < 100);
}

}  // namespace
}  // namespace sward::test
