// Scattered objects: drawn where the rule puts them, counted, shading, as the ray-traced truth has them.
#include "scene/scatter.h"

#include "objects.h"
#include "reference/solids.h"
#include "techniques.h"
#include "world/placement.h"
#include "world/scatter.h"

namespace sward::test {
namespace {

const PassStats* scatterPass(const Renderer& r, const std::string& name) {
    for (const PassStats& p : r.stats().passes)
        if (p.name == name) return &p;
    return nullptr;
}

// The cube's file, scattered; the entity itself is gone.
Project cubes(const std::filesystem::path& dir, const Scatter& rule) {
    Project p = cubeScene(dir);
    removeEntity(p, "cube");
    put<Scatter>(p, "cubes", rule);
    return p;
}
Scatter rule() { return {.meshes = {{"cube", "cube.glb"}}, .perHectare = 500, .distance = 3, .size = {0.3, 0.5}}; }
ViewSettings measuredScatter() {
    ViewSettings s = small();
    s.measure = true;
    return s;
}

TEST(ScatteredObjects, AreDrawnByInstancesOfOneDraw) {
    NoGlErrors errors;
    const TempDir dir;
    const Project p = cubes(dir.path, rule());
    const size_t there = scatterOver(rule(), findGround(p)).objects.size();
    ASSERT_GT(there, 8u);
    Renderer renderer(gpu(), tables());
    ASSERT_TRUE(renderer.draw(p, {{10, 30, 11}, {10, 0, 10}, 55, 0}, measuredScatter()));
    ASSERT_TRUE(scatterPass(renderer, "objects/scatter"));
    EXPECT_EQ(scatterPass(renderer, "objects/scatter")->draws, 1u);
    EXPECT_EQ(scatterPass(renderer, "objects/scatter")->instances, there);
    EXPECT_EQ(scatterPass(renderer, "objects/mesh"), nullptr) << "no StaticMesh is there";
    EXPECT_EQ(scatterPass(renderer, "objects/shadow")->instances, 3 * there) << "in every map";
}

TEST(ScatteredObjects, LookAsTheSameObjectsOneByOne) {
    NoGlErrors errors;
    const TempDir dir;
    Project one = cubes(dir.path, rule());
    Project many = cubeScene(dir.path);
    removeEntity(many, "cube");
    int n = 0;
    for (const ScatteredObject& o : scatterOver(rule(), findGround(one)).objects) {
        const std::string name = fmt::format("cube-{}", n++);
        // Scattered ones have no traced light.
        put<StaticMesh>(many, name,
                        {.file = "cube.glb",
                         .rotationDeg = degreesOf(glm::dmat3(o.turn)),
                         .scale = o.scale,
                         .bakeLight = BakeLight::Local});
        put<Transform>(many, name, {o.at});
    }
    const ViewCamera camera{{10, 6, 24}, {10, 0, 10}, 55, 0};
    Renderer a(gpu(), tables()), b(gpu(), tables());
    ASSERT_TRUE(a.draw(one, camera, small()));
    ASSERT_TRUE(b.draw(many, camera, small()));
    const std::vector<uint8_t> x = a.readImage(), y = b.readImage();
    size_t off = 0;
    for (size_t i = 0; i < x.size(); ++i) off += std::abs(x[i] - y[i]) > 8;
    EXPECT_LT(off, x.size() / 500);
    Project none = cubes(dir.path, {.meshes = {{"cube", "cube.glb"}}, .perHectare = 0});
    ASSERT_TRUE(b.draw(none, camera, small()));
    const std::vector<uint8_t> bare = b.readImage();
    size_t changed = 0;
    for (size_t i = 0; i < x.size(); ++i) changed += std::abs(x[i] - bare[i]) > 8;
    EXPECT_GT(changed, x.size() / 50) << "they are in the picture";
}

TEST(ScatteredObjects, AreMetByRays) {
    const TempDir dir;
    const Project p = cubes(dir.path, rule());
    const auto solids = Solids::make(p, 0, JobControl{});
    ASSERT_TRUE(solids);
    for (const ScatteredObject& o : scatterOver(rule(), findGround(p)).objects) {
        Ray down{glm::dvec3(o.at.x, 10, o.at.z), {0, -1, 0}};
        const auto met = solids->closest(down);
        ASSERT_TRUE(met);
        EXPECT_EQ(met->met, Met::Object);
        EXPECT_NEAR(met->at.y, 2 * static_cast<double>(o.scale), 1e-4) << "the cube's upper face";
        EXPECT_NEAR(static_cast<double>(met->face.y), 1, 1e-5);
        EXPECT_TRUE(solids->blocks(down));
    }
    Scatter shadowless = rule();
    shadowless.castShadows = false;
    const Project other = cubes(dir.path, shadowless);
    const auto light = Solids::make(other, 0, JobControl{});
    ASSERT_TRUE(light);
    const glm::dvec3 at = scatterOver(shadowless, findGround(other)).objects[0].at;
    EXPECT_FALSE(light->blocks({at + glm::dvec3(0, 10, 0), {0, -1, 0}}));
}

TEST(ScatteredObjects, AMissingFileIsToldAndTheRestIsDrawn) {
    NoGlErrors errors;
    const TempDir dir;
    Scatter both = rule();
    both.meshes.push_back({"gone", "gone.glb"});
    const Project p = cubes(dir.path, both);
    Renderer renderer(gpu(), tables());
    ASSERT_TRUE(renderer.draw(p, {{10, 30, 11}, {10, 0, 10}, 55, 0}, measuredScatter()));
    const uint64_t drawn = scatterPass(renderer, "objects/scatter")->instances;
    EXPECT_GT(drawn, 0u);
    EXPECT_LT(drawn, scatterOver(both, findGround(p)).objects.size());
    EXPECT_FALSE(Solids::make(p, 0, JobControl{})) << "the truth does not leave anything out";
}

TEST(ScatteredObjects, LeaveNothingBehind) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = cubeScene(dir.path);
    Renderer renderer(gpu(), tables());
    ASSERT_TRUE(renderer.draw(p, above(), small()));
    const std::vector<std::string> programs = renderer.programNames();
    const auto ledger = gpu().ledger;
    EXPECT_EQ(ledger.count("objects/scatter"), 0u);
    put<Scatter>(p, "cubes", rule());
    ASSERT_TRUE(renderer.draw(p, above(), small()));
    EXPECT_GT(gpu().ledger["objects/scatter"], 0);
    EXPECT_NE(renderer.programNames(), programs);
    removeEntity(p, "cubes");
    ASSERT_TRUE(renderer.draw(p, above(), small()));
    EXPECT_EQ(renderer.programNames(), programs);
    EXPECT_EQ(gpu().ledger, ledger);
}

}  // namespace
}  // namespace sward::test
