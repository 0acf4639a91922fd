#include "scenes.h"
#include "techniques.h"
#include "world/view_camera.h"

namespace sward::test {
namespace {

Project hilly(int side, double size) {
    Project p;
    Terrain t;
    t.size = {size, size};
    Map m({side, side, 1, PixelType::F32});
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            m.set(x, y, 0, static_cast<float>(6 * std::sin(40.0 * x / side) * std::cos(37.0 * y / side)));
    t.height = field(m, "maps/h.exr");
    put(p, "ground", t);
    return p;
}

TEST(GroundPicture, HasNoCracks) {
    NoGlErrors errors;
    Renderer renderer(gpu(), tables());
    Project p = hilly(256, 400);
    ViewSettings s = small();
    s.width = 320, s.height = 240;
    s.mode = ViewMode::Normals;  // ground is never black, what shows through a crack is
    for (const ViewCamera& c :
         {ViewCamera{{200, 25, 200}, {230, 0, 215}, 55, 0}, ViewCamera{{60, 90, 60}, {120, 0, 100}, 55, 0}}) {
        ASSERT_TRUE(renderer.draw(p, c, s));
        const auto image = renderer.readImage();
        int black = 0;
        for (size_t i = 0; i < image.size(); i += 3) black += image[i] + image[i + 1] + image[i + 2] == 0;
        EXPECT_EQ(black, 0);
    }
}

TEST(GroundPicture, FlatGroundFacesExactlyUp) {
    Renderer renderer(gpu(), tables());
    Project p;
    put<Terrain>(p, "ground");
    ViewSettings s = small();
    s.mode = ViewMode::Normals;
    ASSERT_TRUE(renderer.draw(p, {{20, 5, 20}, {20, 0, 20.1}, 55, 0}, s));
    const auto image = renderer.readImage();
    for (size_t i = 0; i < image.size(); i += 3) {
        ASSERT_NEAR(image[i], 128, 1);
        ASSERT_EQ(image[i + 1], 255);
        ASSERT_NEAR(image[i + 2], 128, 1);
    }
}

TEST(GroundPicture, ATerrainMapIsBlendedByItsOpacity) {
    Renderer renderer(gpu(), tables());
    Project p;
    Terrain t;
    Map m({64, 64, 4, PixelType::U8});
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            m.set(x, y, 0, 1.0f);
            m.set(x, y, 3, x < 32 ? 0.0f : 1.0f);
        }
    t.terrainMap = field(m);
    put(p, "ground", t);
    put<Light>(p, "sun");
    ASSERT_TRUE(renderer.draw(p, {{20, 15, 20}, {20, 0, 20.01}, 55, 0}, small()));
    const auto light = renderer.readLinear();
    double red[2] = {0, 0}, green[2] = {0, 0};
    for (int y = 40; y < 80; ++y)
        for (int x = 0; x < 160; ++x) {
            if (std::abs(x - 80) < 20) continue;
            const size_t i = (static_cast<size_t>(y) * 160 + static_cast<size_t>(x)) * 3;
            red[x < 80] += light[i];
            green[x < 80] += light[i + 1];
        }
    const int map = red[0] / green[0] > red[1] / green[1] ? 0 : 1;
    EXPECT_LT(green[map], 0.05 * red[map]) << "opaque red ground is red alone";
    EXPECT_GT(green[1 - map], 0.5 * red[1 - map]) << "soil shows where the map is transparent";
}

TEST(GroundPicture, DrawCallsDoNotGrowWithTheTerrain) {
    Renderer renderer(gpu(), tables());
    uint64_t draws[2];
    int i = 0;
    for (double size : {400.0, 2000.0}) {
        Project p = hilly(64, size);
        ASSERT_TRUE(renderer.draw(p, {{size / 2, 20, size / 2}, {size, 0, size}, 55, 0}, small()));
        draws[i++] = renderer.stats().passes.front().draws;
    }
    EXPECT_EQ(draws[0], draws[1]);
}

}  // namespace
}  // namespace sward::test
