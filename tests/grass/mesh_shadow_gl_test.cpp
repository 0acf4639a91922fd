// Shadows of grass on objects: their outlines on the ground against those of its ray-traced truth.
#include "grass/mesh_shadow.h"

#include "mesh_grass_scenes.h"

namespace sward::test {
namespace {

TEST(MeshShadow, ThinGrassLetsLightInDownToItsFeet) {
    EXPECT_EQ(shadowHeight(0), 0);
    EXPECT_EQ(shadowHeight(1), 1);
    EXPECT_EQ(shadowHeight(2), 1);
    EXPECT_LT(shadowHeight(0.1f), 0.5f);
    for (float d = 0; d < 1; d += 0.1f) EXPECT_LT(shadowHeight(d), shadowHeight(d + 0.1f));
}

// From above, of what is ground in the truth: pixels darker than half of what lies in the sun.
const ViewCamera kOverBall{{10, 9, 10.01}, {10, 0, 10}, 26, 0};
size_t shaded(const std::vector<float>& image) {
    size_t n = 0;
    for (size_t i = 0; i < image.size(); i += 3) n += image[i] < 0.5f * image[0] && image[i] > image[i + 1];
    return n;
}

double lightOnGrass(const std::vector<float>& image) {
    double sum = 0;
    for (size_t i = 0; i < image.size(); i += 3) sum += image[i + 1] > image[i] ? double(image[i + 1]) : 0;
    return sum;
}

TEST(MeshShadow, OnTheGroundIsAsLargeAsItsTruth) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = grassOnMesh(dir, kGrassBall);
    FlatField field = flatField(p);
    field.species[0].height = 0.16f;
    p.registry.get<Light>(findEntity(p, "sun"))->elevationDeg = 40;
    const double truth = double(shaded(meshTruth(p, kOverBall))), drawn = double(shaded(meshPicture(p, kOverBall)));
    Project bare = snapshot(p, tables().components);
    flatField(bare).drawing.groundShadows = false;
    const double without = double(shaded(meshPicture(bare, kOverBall)));
    std::printf("pixels in shadow: truth %.0f drawn %.0f, of the ball alone %.0f\n", truth, drawn, without);
    EXPECT_GT(truth, 400);
    EXPECT_NEAR(drawn, truth, 0.1 * truth);
    EXPECT_LT(without, 0.8 * truth) << "what it stands against must lose";
}

TEST(MeshShadow, IsThrownByALampsLightToo) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = grassOnMesh(dir, kGrassBall);
    flatField(p).species[0].height = 0.16f;
    p.registry.get<Light>(findEntity(p, "sun"))->intensity = 0;
    p.registry.get<Sky>(findEntity(p, "sky"))->intensity = 0.05f;
    put<Light>(p, "lamp", {.type = LightType::Point, .intensity = 3, .attenuation = 0.05f});
    Project bare = snapshot(p, tables().components);
    flatField(bare).drawing.groundShadows = false;
    // Seen by several of the lamp's six maps, some of which see the world in a mirror.
    for (const glm::dvec3& at :
         {glm::dvec3(8.5, 2.2, 10), glm::dvec3(11.5, 2.2, 10), glm::dvec3(10, 2.2, 8.5), glm::dvec3(10, 2.2, 11.5)}) {
        for (Project* of : {&p, &bare}) put<Transform>(*of, "lamp", {at});
        const std::vector<float> one = meshPicture(p, kOverBall), other = meshPicture(bare, kOverBall);
        const size_t with = shaded(one), without = shaded(other);
        std::printf("lamp at %.1f %.1f: pixels in shadow %zu, of the ball alone %zu\n", at.x, at.z, with, without);
        EXPECT_GT(double(with), 1.1 * double(without));
        EXPECT_GT(lightOnGrass(one), 0.9 * lightOnGrass(other)) << "sides that face the lamp would shade the grass";
    }
}

TEST(MeshShadow, LeavesTheGrassItselfInTheLight) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = grassOnMesh(dir, kGrassPlate), bare = snapshot(p, tables().components);
    flatField(bare).drawing.groundShadows = false;
    const ViewCamera c{{10, 1.4, 8}, {10, 0.05, 10}, 30, 0};
    EXPECT_EQ(meshPicture(p, c), meshPicture(bare, c));
}

TEST(MeshShadow, IsNotKeptWhereObjectsCastNone) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = grassOnMesh(dir, kGrassBall);
    Renderer r(gpu(), tables());
    const auto bytes = [&] {
        EXPECT_TRUE(r.draw(p, kOverBall, meshSized(64, 48, 1)));
        return gpu().ledger["grass/mesh-grass"];
    };
    const int64_t with = bytes();
    flatField(p).drawing.groundShadows = false;
    const int64_t without = bytes();
    EXPECT_GT(with, without);
    flatField(p).drawing.groundShadows = true;
    EXPECT_EQ(bytes(), with);
    p.registry.get<StaticMesh>(findEntity(p, "rock"))->castShadows = false;
    EXPECT_EQ(bytes(), without);
}

}  // namespace
}  // namespace sward::test
