// Shadows of objects lie where geometry says, on ground, blades and objects, do not swim, and cost nothing at night.
#include "fields.h"
#include "objects.h"
#include "techniques.h"
#include "world/view_camera.h"

namespace sward::test {
namespace {

const ViewCamera kAbove{{10, 16, 10.01}, {10, 0, 10}, 60, 0}, kNear{{10, 11, 9.01}, {10, 0, 9}, 75, 0};
ViewSettings large() {
    ViewSettings s;
    s.width = 320, s.height = 320;
    s.measure = true;
    return s;
}
uint64_t shadowDraws(const Renderer& r) {
    for (const PassStats& p : r.stats().passes)
        if (p.name == "objects/shadow") return p.draws;
    return 0;
}

TEST(Shadows, ACubesShadowIsAsLongAsItIsHighUnderASunAt45Degrees) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = cubeScene(dir.path);
    Renderer renderer(gpu(), tables());
    const double places[][2] = {{10, 5}, {10, 8}, {10, 7.15}, {10, 6.85}, {9.15, 8}, {8.85, 8}, {10, 8.7}, {10, 12}};
    std::vector<float> share;
    for (const bool cast : {false, true}) {
        p.registry.get<StaticMesh>(findEntity(p, "cube"))->castShadows = cast;
        ASSERT_TRUE(renderer.draw(p, kNear, large()));
        for (size_t i = 0; i < std::size(places); ++i) {
            const float light = lightAt(renderer, kNear, large(), {places[i][0], 0, places[i][1]}).y;
            cast ? void(share[i] = light / share[i]) : share.push_back(light);
        }
    }
    // The cube covers z from 9 to 11; the sun stands in the south: its shadow reaches from 9 to 7.
    EXPECT_NEAR(share[0], 1, 0.01) << "beyond the shadow";
    EXPECT_LT(share[1], 0.4) << "in it";
    EXPECT_NEAR(share[2], share[1], 0.03) << "0.15 m inside the edge";
    EXPECT_NEAR(share[3], 1, 0.03) << "0.15 m outside";
    EXPECT_NEAR(share[4], share[1], 0.03);
    EXPECT_NEAR(share[5], 1, 0.03);
    EXPECT_NEAR(share[6], share[1], 0.03) << "no light between the cube and its shadow";
    EXPECT_NEAR(share[7], 1, 0.01) << "none towards the sun";
}

// Texels of the maps lie at the same places of the terrain, wherever that stands.
TEST(Shadows, LieTheSameWhereverTheTerrainStands) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = cubeScene(dir.path);
    Renderer renderer(gpu(), tables());
    const ViewCamera slanted{{6, 4, 3}, {10, 0, 9}, 60, 0};
    ASSERT_TRUE(renderer.draw(p, slanted, large()));
    const std::vector<float> here = renderer.readLinear();
    for (const glm::dvec3 by : {glm::dvec3(10, 0, 0), glm::dvec3(-1003, 0, 77), glm::dvec3(0)}) {
        put<Transform>(p, "ground").position = by;
        p.registry.get<Transform>(findEntity(p, "cube"))->position = glm::dvec3(10, 0, 10) + by;
        ViewCamera moved = slanted;
        moved.eye += by, moved.target += by;
        ASSERT_TRUE(renderer.draw(p, moved, large()));
        const std::vector<float> there = renderer.readLinear();
        size_t differ = 0;
        for (size_t i = 0; i < here.size(); ++i) differ += here[i] != there[i];
        EXPECT_EQ(differ, 0u) << by.x << ' ' << by.y << ' ' << by.z;
    }
}

TEST(Shadows, ALitFaceIsNotShadedByItself) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = cubeScene(dir.path);
    Renderer renderer(gpu(), tables());
    const ViewCamera front{{10, 5, 17}, {10, 1, 10}, 55, 0};
    ASSERT_TRUE(renderer.draw(p, front, large()));
    const std::vector<float> shaded = renderer.readLinear();
    p.registry.get<StaticMesh>(findEntity(p, "cube"))->castShadows = false;
    ASSERT_TRUE(renderer.draw(p, front, large()));
    const std::vector<float> unshaded = renderer.readLinear();
    // Seen from the sun's side nothing is in shadow but the ground behind, which the cube hides.
    size_t differ = 0;
    for (size_t i = 0; i < shaded.size(); i += 3) differ += std::abs(shaded[i] - unshaded[i]) > 0.02f * unshaded[i];
    EXPECT_LT(differ, shaded.size() / 3 / 500) << "no acne on faces nor ground";
}

TEST(Shadows, BladesAndObjectsInTheShadowAreDarker) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = cubeScene(dir.path);
    putObject(p, "slab", {{.size = {0.5f, 0.2f, 0.5f}, .color = {0.1f, 0.1f, 0.1f}}}, {10, 0, 8});
    Renderer renderer(gpu(), tables());
    ASSERT_TRUE(renderer.draw(p, kAbove, large()));
    const float slabDark = lightAt(renderer, kAbove, large(), {10, 0.2, 8}).y,
                slabLit = lightAt(renderer, kAbove, large(), {10, 2, 10}).y;
    EXPECT_LT(slabDark, 0.5f * slabLit) << "the slab lies in the cube's shadow";
    FlatField f;
    f.technique = nameOf(Technique::Geometry);
    f.species[0].bladesPerM2 = 300;
    f.species[0].width = 0.06f;
    f.species[0].height = 0.2f;
    put(p, "grass", f);
    ASSERT_TRUE(renderer.draw(p, kAbove, large()));
    EXPECT_LT(lightAt(renderer, kAbove, large(), {10.6, 0.1, 7.6}).y,
              0.6f * lightAt(renderer, kAbove, large(), {10.6, 0.1, 5}).y);
}

TEST(Shadows, EdgesStayWhileTheEyeMoves) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = cubeScene(dir.path);
    Renderer renderer(gpu(), tables());
    std::vector<float> seen;
    for (int step = 0; step < 5; ++step) {
        ViewCamera c = kAbove;
        c.eye.x += 0.0037 * step, c.target.x += 0.0037 * step;  // not a multiple of a texel
        ASSERT_TRUE(renderer.draw(p, c, large()));
        seen.push_back(lightAt(renderer, c, large(), {10.013, 0, 7.02}).y);
    }
    const auto [low, high] = std::minmax_element(seen.begin(), seen.end());
    EXPECT_LT(*high - *low, 0.12f * *high) << "within what the grid of pixels alone makes";
}

TEST(Shadows, MapsAreDrawnOnlyWhenSomethingMoved) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = cubeScene(dir.path);
    Renderer renderer(gpu(), tables());
    ASSERT_TRUE(renderer.draw(p, kAbove, large()));
    EXPECT_GT(shadowDraws(renderer), 0u);
    ViewCamera turned = kAbove;
    turned.target.x += 1;
    ASSERT_TRUE(renderer.draw(p, turned, large()));
    EXPECT_EQ(shadowDraws(renderer), 0u) << "turning the view moves nothing";
    turned.eye.x += 1;
    ASSERT_TRUE(renderer.draw(p, turned, large()));
    EXPECT_EQ(shadowDraws(renderer), 0u) << "nor does a step within the maps";
    turned.eye.x += 2;
    ASSERT_TRUE(renderer.draw(p, turned, large()));
    EXPECT_EQ(shadowDraws(renderer), 1u) << "a longer one leaves the nearest alone";
    p.registry.get<Transform>(findEntity(p, "cube"))->position.x += 1;
    ASSERT_TRUE(renderer.draw(p, turned, large()));
    EXPECT_GT(shadowDraws(renderer), 0u);
    EXPECT_EQ(shadowDraws(renderer), 3u);
    EXPECT_LT(lightAt(renderer, turned, large(), {11.7, 0, 8}).y,
              0.6f * lightAt(renderer, turned, large(), {9, 0, 8}).y);
}

TEST(Shadows, TheSunAtTheHorizonOrBelowMakesNoWork) {
    NoGlErrors errors;
    const TempDir dir;
    for (const float elevation : {0.0f, -10.0f}) {
        Project p = cubeScene(dir.path);
        p.registry.get<Light>(findEntity(p, "sun"))->elevationDeg = elevation;
        Renderer renderer(gpu(), tables());
        ASSERT_TRUE(renderer.draw(p, kAbove, large()));
        EXPECT_EQ(shadowDraws(renderer), 0u);
    }
}

TEST(Shadows, NeedASunAndACaster) {
    const TempDir dir;
    Project p = cubeScene(dir.path);
    const auto shadows = [&] { return has(sceneFeatures(p.registry, tables()), Feature::ObjectShadows); };
    EXPECT_TRUE(shadows());
    p.registry.get<StaticMesh>(findEntity(p, "cube"))->castShadows = false;
    EXPECT_FALSE(shadows());
    p.registry.get<StaticMesh>(findEntity(p, "cube"))->castShadows = true;
    p.registry.remove<Light>(findEntity(p, "sun"));
    EXPECT_FALSE(shadows());
    Renderer renderer(gpu(), tables());
    EXPECT_NE(renderer.explain(p, false).find(
                  "object-shadows: no StaticMesh, no Scatter and no Forest casts shadows, or no Light"),
              std::string::npos);
}

}  // namespace
}  // namespace sward::test
