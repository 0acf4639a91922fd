// Trees as volumes: as dense and as bright as the same trees traced ray by ray, from above and from the side; each
// where the other trees' meshes are not; none where the density leaves none.
#include "forest/texcells.h"

#include "reference/reference.h"
#include "scenes.h"
#include "world/forest_stand.h"

namespace sward::test {
namespace {

Project wood(TreeKind kind, float meshesTo, float perHectare = 400) {
    Project p = lawn();
    removeEntity(p, "grass");
    Terrain& t = *p.registry.get<Terrain>(findEntity(p, "ground"));
    t.size = {160, 160};
    t.groundColor = {0.2f, 0.05f, 0.02f};
    put<Forest>(
        p, "trees",
        {.species = {{.kind = kind, .leaves = 1500}}, .perHectare = perHectare, .distance = 3, .meshesTo = meshesTo});
    return p;
}
const ViewCamera kAir{{80, 90, 210}, {80, 0, 80}, 40, 0};
const ViewCamera kSide{{80, 7, 260}, {80, 6, 80}, 30, 0};

std::vector<float> drawn(const Project& p, const ViewCamera& c) {
    Renderer renderer(gpu(), tables());
    ViewSettings s = small();
    EXPECT_TRUE(renderer.draw(p, c, s));
    return renderer.readLinear();
}
std::vector<float> traced(const Project& p, const ViewCamera& c) {
    JobControl control;
    const auto scene = ReferenceScene::make(p, tables(), 0, control);
    EXPECT_TRUE(scene) << scene.error().text();
    ReferenceSettings settings;
    settings.width = 160, settings.height = 120, settings.samples = 16;
    const auto truth = scene->trace(c, settings, control);
    EXPECT_TRUE(truth);
    return truth->color;
}
// Mean of a picture's lower middle, where trees are.
glm::dvec3 meanOf(const std::vector<float>& pixels) {
    glm::dvec3 sum(0);
    int n = 0;
    for (size_t y = 50; y < 90; ++y)
        for (size_t x = 40; x < 120; ++x, ++n)
            for (int c = 0; c < 3; ++c)
                sum[c] += static_cast<double>(pixels[3 * (y * 160 + x) + static_cast<size_t>(c)]);
    return sum / static_cast<double>(n);
}

TEST(Texcells, AreAsBrightAsTheTruth) {
    NoGlErrors errors;
    const ViewCamera views[] = {kAir, kSide};
    for (const TreeKind kind : {TreeKind::Conifer, TreeKind::Broadleaf, TreeKind::Birch}) {
        const Project volumes = wood(kind, 0), bare = wood(kind, 0, 0);
        for (const ViewCamera& camera : views) {
            const glm::dvec3 truth = meanOf(traced(volumes, camera)), ours = meanOf(drawn(volumes, camera)),
                             none = meanOf(drawn(bare, camera));
            const double error = glm::length(ours - truth) / glm::length(truth),
                         without = glm::length(none - truth) / glm::length(truth);
            std::printf("kind %d, %s: drawn %.4f, truth %.4f, bare %.4f\n", static_cast<int>(kind),
                        &camera == &views[0] ? "air" : "side", ours.y, truth.y, none.y);
            EXPECT_LT(error, 0.3) << "kind " << static_cast<int>(kind) << (&camera == &views[0] ? " air" : " side");
            EXPECT_LT(error, 0.5 * without) << "bare ground must lose";
        }
    }
}

TEST(Texcells, AreThereWhereMeshesEndAndNowhereElse) {
    NoGlErrors errors;
    const float inf = std::numeric_limits<float>::infinity();
    // All as meshes: no volume in the plan; and a picture that the same trees as volumes come near to.
    const std::vector<float> meshes = drawn(wood(TreeKind::Birch, inf), kAir),
                             volumes = drawn(wood(TreeKind::Birch, 0), kAir),
                             both = drawn(wood(TreeKind::Birch, 160), kAir);
    const double a = meanOf(meshes).y, b = meanOf(volumes).y, c = meanOf(both).y;
    EXPECT_GT(c, 0.97 * std::min(a, b));
    EXPECT_LT(c, 1.03 * std::max(a, b)) << "trees drawn by both would be denser than by either";
}

TEST(Texcells, ADensityOfNothingDrawsNothing) {
    NoGlErrors errors;
    Renderer renderer(gpu(), tables());
    Project p = wood(TreeKind::Conifer, 0);
    ASSERT_TRUE(renderer.draw(p, kAir, small()));
    p.registry.get<Forest>(findEntity(p, "trees"))->density = field(filled({16, 16, 1, PixelType::U16}, 0));
    ASSERT_TRUE(renderer.draw(p, kAir, small()));
    EXPECT_EQ(renderer.readLinear(), drawn(wood(TreeKind::Conifer, 0, 0), kAir)) << "nor does it shade, as before";
}

TEST(Texcells, DrawTheSameFarFromTheOrigin) {
    NoGlErrors errors;
    Project p = wood(TreeKind::Broadleaf, 0);
    const std::vector<float> here = drawn(p, kAir);
    const glm::dvec3 away(90000, 0, -90000);
    put(p, "ground", Transform{away});
    ViewCamera camera = kAir;
    camera.eye += away, camera.target += away;
    const std::vector<float> there = drawn(p, camera);
    size_t off = 0;
    for (size_t i = 0; i < here.size(); ++i) off += std::abs(here[i] - there[i]) > 0.004f;
    EXPECT_LT(off, here.size() / 500);
}

// What is coarser by one level stands for the same slabs: over the fraction of a level the picture's mean moves evenly.
TEST(Texcells, NoStepWhereLevelsChange) {
    NoGlErrors errors;
    const Project p = wood(TreeKind::Conifer, 0);
    Renderer renderer(gpu(), tables());
    double least = 1e30, most = 0, before = 0, step = 0;
    for (int i = 0; i <= 24; ++i) {
        ViewSettings s = small();
        const double back = 300 * std::pow(2.2, i / 24.0);
        // The same picture from farther away through a longer lens.
        const float fov = static_cast<float>(2 * glm::degrees(std::atan(std::tan(glm::radians(12.0)) * 300 / back)));
        ASSERT_TRUE(renderer.draw(p, {{80, back * 0.7, 80 + back * 0.7}, {80, 0, 80}, fov, 0}, s));
        const double now = meanOf(renderer.readLinear()).y;
        least = std::min(least, now), most = std::max(most, now);
        if (i > 0) step = std::max(step, std::abs(now / before - 1));
        before = now;
    }
    EXPECT_LT(step, 0.02) << "from " << least << " to " << most;
}

TEST(Texcells, OddPlacesOfTheEyeGiveFinitePictures) {
    NoGlErrors errors;
    const Project p = wood(TreeKind::Conifer, 0);
    for (const ViewCamera& c :
         {ViewCamera{{80, 6, 80}, {80, 6, 0}, 55, 0}, ViewCamera{{80, 200, 80}, {80, 0, 80.001}, 55, 0},
          ViewCamera{{-50, 0.001, 80}, {80, 0.001, 80}, 55, 0}, ViewCamera{{80, 1, 80}, {80, 300, 80.5}, 55, 0}})
        for (const float x : drawn(p, c)) ASSERT_TRUE(std::isfinite(x) && x >= 0 && x < 100);
}

}  // namespace
}  // namespace sward::test
