// Grass that lies, pressed down all over, as bright by its blades as in the ray-traced truth: they shade each other,
// too.
#include "comparison.h"
#include "core/numerics.h"
#include "reference/reference.h"
#include "scenes.h"
#include "techniques.h"

namespace sward::test {
namespace {

constexpr double kLyingLimit = 0.12;  // of the truth's brightness

Project trodden() {
    Project p = designed(kMeadow, 8);
    removeEntity(p, "haze");
    p.registry.get<Sky>(findEntity(p, "sky"))->intensity = 0;
    GrassField& grass = *p.registry.get<GrassField>(findEntity(p, "grass"));
    Species& s = grass.species[0];
    s.bladesPerM2 = 5000, s.height = 0.22f, s.width = 0.006f, s.translucency = 0.6f, s.gloss = 0, s.clumpSize = 0;
    Map press({1, 1, 4, PixelType::F32});
    for (int c = 0; c < 4; ++c) press.set(0, 0, c, c < 2 ? 0.5f : 1.0f);
    grass.forces = {"maps/press.exr", std::move(press)};
    sunIn(p).azimuthDeg = 90, sunIn(p).elevationDeg = 33;
    return p;
}

TEST(PressedLight, OfBladesThatLieOnEachOtherIsTheTruths) {
    NoGlErrors errors;
    const ViewCamera camera{{4, 2, 1.5}, {4, 0, 4}, 16, 0};
    Project p = trodden();
    JobControl control;
    const auto scene = ReferenceScene::make(p, tables(), 0, control);
    ASSERT_TRUE(scene) << scene.error().text();
    ReferenceSettings s;
    s.width = 48, s.height = 36, s.samples = 32;
    const auto green = [](const std::vector<float>& image) {
        double sum = 0;
        for (size_t i = 1; i < image.size(); i += 3) sum += static_cast<double>(image[i]);
        return sum;
    };
    const double truth = green(scene->trace(camera, s, control)->color);
    for (const Technique t : {Technique::Geometry, Technique::Tessellated}) {
        grassIn(p).technique = nameOf(t);
        Renderer r(gpu(), tables());
        ASSERT_TRUE(r.draw(p, camera, sized(48, 36)));
        const double drawn = green(r.readLinear()) / truth,
                     unshaded = drawn / static_cast<double>(f32::lyingLit(4.4f));  // nearly all are blades
        printf("%s: %.3f of the truth; if none shaded another %.3f\n", nameOf(t), drawn, unshaded);
        EXPECT_NEAR(drawn, 1, kLyingLimit) << nameOf(t);
        EXPECT_GT(unshaded, 1 + kLyingLimit) << "the rival that must lose";
    }
}

}  // namespace
}  // namespace sward::test
