// Blades in the sun's light are as bright in few quads as in many, by one sample a pixel as by four, whatever chance
// sowed those that shade them, and however they are bent.
#include "comparison.h"
#include "reference/reference.h"
#include "scenes.h"
#include "techniques.h"

namespace sward::test {
namespace {

constexpr int kWide = 96, kHigh = 72;

// Bent blades on black soil in the sun alone, as techniques light them. azimuthDeg: 0: the sun is behind the eye.
Project sunnyBlades(float azimuthDeg, int seed = 1) {
    Project p = designed(kLawn, 12);
    removeEntity(p, "haze");
    p.registry.get<Terrain>(findEntity(p, "ground"))->groundColor = {0, 0, 0};
    p.registry.get<Sky>(findEntity(p, "sky"))->intensity = 0;
    sunIn(p).azimuthDeg = azimuthDeg, sunIn(p).elevationDeg = 36;
    FlatField f = grassIn(p);
    f.technique = nameOf(Technique::Tessellated);
    f.seed = seed;
    f.drawing.bakeLight = BakeLight::Local;
    f.maxDistance = 200, f.thinning = 0, f.lowerFrom = 1;
    f.beyond = Beyond::Nothing;
    Species& s = f.species[0];
    s.bladesPerM2 = 2500, s.height = 0.14f, s.width = 0.005f, s.bend = 0.5f, s.smoothness = 3, s.segments = 12;
    s.translucency = 0.6f;
    return p;
}
ViewCamera overBlades() { return {{6, 2, 1}, {6, 0, 5}, 20, 0}; }
// Mean green of a picture.
double lightSeen(const std::vector<float>& image) {
    double sum = 0;
    for (size_t i = 1; i < image.size(); i += 3) sum += static_cast<double>(image[i]);
    return 3 * sum / static_cast<double>(image.size());
}
// quad: pixels that one is long; 0: as many as the species has.
double drawnLight(Project& p, float quad, int msaa) {
    FlatField f = grassIn(p);
    f.tessellated.levelBy = quad > 0 ? LevelBy::Pixels : LevelBy::Distance;
    if (quad > 0) f.tessellated.pixelsPerQuad = quad;
    Renderer r(gpu(), tables());
    EXPECT_TRUE(r.draw(p, overBlades(), sized(kWide, kHigh, msaa)));
    return lightSeen(r.readLinear());
}

// Of the truth's light, in which blades shade each other as rays find them.
double lightOfTruths(Project& p) {
    JobControl control;
    const auto scene = ReferenceScene::make(p, tables(), 0, control);
    EXPECT_TRUE(scene) << scene.error().text();
    ReferenceSettings s;
    s.width = kWide, s.height = kHigh, s.samples = 32, s.lighting = ReferenceLighting::Direct;
    return drawnLight(p, 0, 1) / lightSeen(scene->trace(overBlades(), s, control)->color);
}

TEST(BladeLight, OfFewQuadsIsThatOfMany) {
    NoGlErrors errors;
    for (const float azimuthDeg : {0.0f, 90.0f, 180.0f}) {
        Project p = sunnyBlades(azimuthDeg);
        const double many = drawnLight(p, 0, 1);
        for (const float quad : {4.0f, 8.0f, 32.0f}) {
            const double share = drawnLight(p, quad, 1) / many;
            std::printf("sun at %.0f degrees, quads of %.0f pixels: %.3f of the light of many quads\n",
                        double(azimuthDeg), double(quad), share);
            EXPECT_NEAR(share, 1, 0.12) << azimuthDeg << ", " << quad;
        }
    }
}

TEST(BladeLight, OfSeveralSamplesAPixelIsThatOfOne) {
    NoGlErrors errors;
    Project p = sunnyBlades(0);
    for (const float quad : {0.0f, 32.0f}) {
        const double one = drawnLight(p, quad, 1);
        for (const int samples : {2, 4, 8}) {
            const double share = drawnLight(p, quad, samples) / one;
            std::printf("%d samples, quads of %.0f pixels: %.3f of the light of one sample\n", samples, double(quad),
                        share);
            EXPECT_NEAR(share, 1, 0.05) << samples << ", " << quad;
        }
    }
}

TEST(BladeLight, DoesNotHangOnTheChanceThatSowedTheMask) {
    NoGlErrors errors;
    double least = 1e9, most = 0;
    for (const int seed : {1, 2, 3, 4}) {
        Project p = sunnyBlades(145, seed);
        const double share = lightOfTruths(p);
        std::printf("seed %d: %.3f of the truth's light\n", seed, share);
        least = std::min(least, share), most = std::max(most, share);
    }
    EXPECT_LT(most - least, 0.12);
}

// Tips of those that curl hang down to the ground, and their blades stand as high among the others as ever.
TEST(BladeLight, OfBladesThatCurlIsTheTruths) {
    NoGlErrors errors;
    for (const float bend : {0.5f, 0.75f, 0.95f}) {
        Project p = sunnyBlades(90);
        grassIn(p).species[0].bend = bend;
        const double share = lightOfTruths(p);
        std::printf("bent by %.2f: %.3f of the truth's light\n", double(bend), share);
        EXPECT_NEAR(share, 1, 0.12) << bend;
    }
}

}  // namespace
}  // namespace sward::test
