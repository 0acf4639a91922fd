// Shadows of hills: a ridge hides the sun as far as its height and the sun's say.
#include "terrain/shade.h"

#include "objects.h"
#include "techniques.h"
#include "world/view_camera.h"

namespace sward::test {
namespace {

// Level but for a wall 4 m high over columns 60 to 63 of 128, 1 m a column.
HeightGrid wall() {
    HeightGrid g{128, 96, std::vector<float>(128 * 96, 0.0f)};
    for (int z = 0; z < 96; ++z)
        for (int x = 60; x < 64; ++x) g.metres[static_cast<size_t>(z) * 128 + static_cast<size_t>(x)] = 4;
    return g;
}
glm::vec3 sunAt(float azimuthDeg, float elevationDeg) {
    const float a = glm::radians(azimuthDeg), e = glm::radians(elevationDeg);
    return {std::sin(a) * std::cos(e), std::sin(e), -std::cos(a) * std::cos(e)};
}

TEST(HillShadows, TheShadowsHeightFallsWithTheDistanceFromTheRidge) {
    const HeightGrid hidden = hiddenHeights(wall(), {128, 96}, sunAt(90, 30));  // from the east
    const float slope = std::tan(glm::radians(30.0f));
    for (int x = 40; x < 60; ++x) {
        const float expected = 4 - slope * static_cast<float>(60 - x);
        EXPECT_NEAR(hidden.metres[50 * 128 + static_cast<size_t>(x)], std::max(expected, -slope), 1e-3f) << x;
    }
    EXPECT_LT(hidden.metres[50 * 128 + 70], 0) << "towards the sun nothing is hidden";
}

TEST(HillShadows, EveryDirectionGivesTheSameShadowOfARoundHill) {
    HeightGrid hill{129, 129, std::vector<float>(129 * 129)};
    for (int z = 0; z < 129; ++z)
        for (int x = 0; x < 129; ++x)
            hill.metres[static_cast<size_t>(z) * 129 + static_cast<size_t>(x)] =
                10 * std::exp(-static_cast<float>((x - 64) * (x - 64) + (z - 64) * (z - 64)) / 60.0f);
    for (float azimuth = 0; azimuth < 360; azimuth += 15) {
        const glm::vec3 sun = sunAt(azimuth, 20);
        const HeightGrid hidden = hiddenHeights(hill, {129, 129}, sun);
        const glm::vec2 away = -glm::normalize(glm::vec2(sun.x, sun.z)) * 20.0f;
        const size_t at =
            static_cast<size_t>(std::lround(64 + away.y)) * 129 + static_cast<size_t>(std::lround(64 + away.x));
        EXPECT_NEAR(hidden.metres[at], 2.93, 0.25) << azimuth;  // the highest of 10 exp(-u^2 / 60) - (20 - u) tan 20
    }
}

TEST(HillShadows, GroundBehindARidgeIsDarkAndLevelGroundIsNot) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = cubeScene(dir.path);
    removeEntity(p, "cube");
    Terrain& t = *p.registry.get<Terrain>(findEntity(p, "ground"));
    t.groundColor = glm::vec3(0.1f);
    t.height = field(Map({128, 128, 1, PixelType::F32}), "maps/height.exr");
    for (int z = 60; z < 64; ++z)
        for (int x = 0; x < 128; ++x) t.height.map.set(x, z, 0, 2);
    Renderer renderer(gpu(), tables());
    ViewSettings s = small();
    const ViewCamera above{{10, 16, 10.01}, {10, 0, 10}, 60, 0};
    ASSERT_TRUE(renderer.draw(p, above, s));
    const float without = lightAt(renderer, above, s, {10, 0, 8.4}).y;
    t.castShadows = true;
    ASSERT_TRUE(renderer.draw(p, above, s));
    // The ridge stands at z from 9.4 to 10, 2 m high; the sun in the south at 45 degrees: dark from 9.4 to 8 at least.
    EXPECT_LT(lightAt(renderer, above, s, {10, 0, 8.4}).y, 0.5f * without);
    EXPECT_NEAR(lightAt(renderer, above, s, {10, 0, 6}).y / without, 1, 0.1);
    EXPECT_NEAR(lightAt(renderer, above, s, {10, 0, 13}).y / without, 1, 0.1);
}

}  // namespace
}  // namespace sward::test
