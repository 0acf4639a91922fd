// Colours painted over grass, seen along the ground, against the ray-traced truth in the same light.
#include "comparison.h"
#include "reference/reference.h"
#include "scenes.h"
#include "techniques.h"

namespace sward::test {
namespace {

Truth truthOf(const Project& p, const ViewCamera& camera, int width, int height, int samples) {
    JobControl control;
    const auto scene = ReferenceScene::make(p, tables(), 0, control);
    EXPECT_TRUE(scene) << scene.error().text();
    ReferenceSettings s;
    s.width = width, s.height = height, s.samples = samples, s.lighting = ReferenceLighting::Direct;
    return *scene->trace(camera, s, control);
}
// A line on a pitch, along the view: far away as narrow as in the truth. With one level of detail both ways its
// brightest column had a third of the light.
TEST(PaintedGrass, LinesStaySharpAlongTheGround) {
    NoGlErrors errors;
    Project p = designed(kLawn, kLawn.side);
    for (const char* name : {"sky", "haze"}) removeEntity(p, name);
    sunIn(p).elevationDeg = 45;
    FlatField f = grassIn(p);
    f.technique = nameOf(Technique::Flat);
    constexpr int kSide = 256;
    Map paint({kSide, kSide, 4, PixelType::U8});
    std::vector<uint8_t> texels(kSide * kSide * 4, 255);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) texels[static_cast<size_t>((y * kSide + x) * 4 + 3)] = x / 2 == 64 ? 255 : 0;
    paint.writeRows(0, kSide, texels.data());
    f.vegetation = MapField{"maps/lines.png", paint};
    const ViewCamera along{{10, 1.0, 1}, {10.02, 0, 14}, 45, 0};
    const auto widthOfLine = [&](const std::vector<float>& image) {
        // In the rows where the ground is 8 to 15 m away: blue, of which grass has little.
        double sum = 0, most = 0;
        for (int x = 0; x < 256; ++x) {
            double column = 0;
            for (int y = 93; y < 108; ++y)
                column += static_cast<double>(image[static_cast<size_t>((y * 256 + x) * 3 + 2)]);
            sum += column, most = std::max(most, column);
        }
        return std::pair{sum, most};
    };
    Renderer r(gpu(), tables());
    ASSERT_TRUE(r.draw(p, along, sized(256, 192)));
    const auto drawn = widthOfLine(r.readLinear()), traced = widthOfLine(truthOf(p, along, 256, 192, 16).color);
    std::printf("blue: drawn %.2f, at most %.2f in a column; traced %.2f, %.2f\n", drawn.first, drawn.second,
                traced.first, traced.second);
    EXPECT_GT(drawn.second / drawn.first, 0.5 * traced.second / traced.first);
}

}  // namespace
}  // namespace sward::test
