// Known answers: where the shadow of one upright blade begins and ends, seen from straight above.
#include "fields.h"
#include "pixels.h"
#include "scene/population.h"
#include "scenes.h"
#include "techniques.h"
#include "world/view_camera.h"

namespace sward::test {
namespace {

constexpr double kTan20 = 0.36397;

// One blade 1 m high near the middle of 4 x 4 m, the sun in the east or west at 45 degrees.
Project oneBlade(float azimuthDeg) {
    Project p;
    Terrain t;
    t.size = {4, 4};
    put(p, "ground", t);
    FlatField f;
    f.cellSize = 4;
    f.minGeom = f.maxGeom = std::numeric_limits<float>::infinity();
    f.shadowMask = 0;
    Species& s = f.species[0];
    s.bladesPerM2 = 1.0f / 16;
    s.height = 1;
    s.width = 0.3f;
    s.heightVariation = s.bend = s.leanDeg = s.leanVariationDeg = s.clumpSize = 0;
    const auto suits = [&](const Blade& b) {
        return std::abs(b.facing.x) > 0.9f && std::abs(b.root.x - 2) < 0.3f;
    };  // its broad side to the light
    while (!suits(makePatch(s, f.cellSize, static_cast<uint32_t>(f.seed)).blades[0])) ++f.seed;
    put(p, "grass", f);
    put(p, "sky", Sky{});
    Light sun;
    sun.azimuthDeg = azimuthDeg;
    sun.elevationDeg = 45;
    put(p, "sun", sun);
    return p;
}
// The ground rises by 20 degrees towards +x.
void slope(Project& p) {
    Map m({64, 64, 1, PixelType::F32});
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) m.set(x, y, 0, static_cast<float>((x + 0.5) / 64 * 4 * kTan20));
    p.registry.get<Terrain>(findEntity(p, "ground"))->height = field(m);
}

struct Shadow {
    double from = 1e9, to = -1e9;  // extent along x, metres, from the picture's middle
    int pixels = 0;
    float darkest = 1;  // what is left of the ground's light
};
constexpr double kPixel = 2 * 60 * 0.0349208 / 240;  // metres: seen 4 degrees wide from 60 m
// What ground shadows change in the picture.
Shadow shadowOf(Renderer& r, Project& p) {
    ViewSettings s = small();
    s.width = s.height = 240;
    const ViewCamera c{{2, 60, 2}, {2, 0, 2}, 4, 0};
    FlatField f = flatField(p, "grass");
    f.groundShadows = true;
    EXPECT_TRUE(r.draw(p, c, s));
    const auto with = r.readLinear();
    f.groundShadows = false;
    EXPECT_TRUE(r.draw(p, c, s));
    const auto without = r.readLinear();
    Shadow out;
    for (int y = 0; y < s.height; ++y)
        for (int x = 0; x < s.width; ++x) {
            const size_t i = (static_cast<size_t>(y) * static_cast<size_t>(s.width) + static_cast<size_t>(x)) * 3;
            // Without ground shadows soil under grass has the mean shade; the blade's own shadow is darker still.
            const float left = with[i] / std::max(without[i], 1e-6f);
            out.darkest = std::min(out.darkest, left);
            if (left > 0.9f || without[i] < 1e-4f) continue;
            out.from = std::min(out.from, (s.width / 2 - x - 1) * kPixel);  // up is +z, so +x lies on the left
            out.to = std::max(out.to, (s.width / 2 - x) * kPixel);
            ++out.pixels;
        }
    return out;
}

// The shadows by the sun in the east and in the west meet at the root.
struct Lengths {
    double east, west, root;
};
Lengths lengths(Renderer& r, bool sloped) {
    Project east = oneBlade(90), west = oneBlade(270);
    if (sloped) slope(east), slope(west);
    const Shadow e = shadowOf(r, east), w = shadowOf(r, west);
    EXPECT_GT(e.pixels, 20);
    EXPECT_GT(w.pixels, 20);
    const double root = (e.to + w.from) / 2;
    EXPECT_NEAR(e.to, w.from, 0.35) << "they meet at the root, within the blade's width";
    return {root - e.from, w.to - root, root};
}

TEST(GroundShadow, IsAsLongAsTheBladeInLightFrom45Degrees) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    const auto [east, west, root] = lengths(r, false);
    EXPECT_NEAR(east, 1, 0.06);
    EXPECT_NEAR(west, 1, 0.06);
}

TEST(GroundShadow, IsLongerDownASlopeAndShorterUp) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    const auto [down, up, root] = lengths(r, true);
    EXPECT_NEAR(down, 1 / (1 - kTan20), 0.09);
    EXPECT_NEAR(up, 1 / (1 + kTan20), 0.06);
}

TEST(GroundShadow, OfALampPointsAwayFromItAndEndsWhereItsRaysDo) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    const double root = lengths(r, false).root;
    Project p = oneBlade(90);
    removeEntity(p, "sun");
    Light lamp;
    lamp.type = LightType::Point;
    lamp.attenuation = 0;
    put(p, "lamp", lamp);
    put(p, "lamp", Transform{{2 + root + 2, 3, 2}});  // 2 m beside and 2 m above the tip
    const Shadow s = shadowOf(r, p);
    EXPECT_NEAR(root - s.from, 1, 0.06);
    put(p, "lamp", Transform{{2 + root - 1, 2, 2}});
    EXPECT_NEAR(shadowOf(r, p).to - root, 1, 0.06);
    put(p, "lamp", Transform{{2 + root + 1, 0.5, 2}});  // lower than the tip
    EXPECT_LE(root - shadowOf(r, p).from, 2) << "no farther than the picture, faded before its longest";
}

TEST(GroundShadow, UnderTheZenithIsOnlyUnderTheBladeAndOnTheHorizonThereIsNone) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    Project p = oneBlade(90);
    Light& sun = *p.registry.get<Light>(findEntity(p, "sun"));
    sun.elevationDeg = 90;
    EXPECT_LT(shadowOf(r, p).pixels, 25);
    for (const float below : {0.0f, -1.0f, -30.0f}) {
        sun.elevationDeg = below;
        EXPECT_EQ(shadowOf(r, p).pixels, 0) << below;
    }
    sun.elevationDeg = 45;
    sun.castShadows = false;
    EXPECT_EQ(shadowOf(r, p).pixels, 0);
}

// Soil between blades, all of them drawn one by one: half a pixel of the coarse picture is as wide as three, one of the
// fine picture narrower than one.
double lightOfLawn(Renderer& r, int times) {
    Project p = lawn();
    FlatField f = flatField(p, "grass");
    f.technique = nameOf(Technique::Geometry);
    f.shadowMask = 0;
    ViewSettings s;
    s.width = 96 * times, s.height = 72 * times, s.msaa = 4;
    EXPECT_TRUE(r.draw(p, {{10, 9, 5}, {10, 0, 10}, 50, 0}, s));
    return brightness(r.readLinear());
}
// Each drawn in the coarse picture, too, they differ by 0.008; thinned and not widened by 0.08.
TEST(GroundShadow, ThoseThatStandForOthersTakeAsMuchLight) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    const double coarse = lightOfLawn(r, 1), fine = lightOfLawn(r, 8);
    printf("light of the lawn %.4f, where each blade has its shadow %.4f\n", coarse, fine);
    EXPECT_NEAR(coarse / fine, 1, 0.02);
}

// By how much shadows change any colour of a lawn in thick haze, at most; soil: what it reflects. Blades reflect
// nothing.
float shadowsChange(Renderer& r, Technique technique, float soil) {
    std::vector<float> seen[2];
    for (const bool shadows : {false, true}) {
        Project p = lawn();
        p.registry.get<Fog>(findEntity(p, "haze"))->visibility = 30;
        p.registry.get<Terrain>(findEntity(p, "ground"))->groundColor = glm::vec3(soil);
        FlatField f = flatField(p);
        f.technique = nameOf(technique), f.groundShadows = shadows;
        f.sliceWidth = f.farSize = 64, f.sliceHeight = 32;
        f.species[0].rootColor = f.species[0].midColor = f.species[0].tipColor = glm::vec3(0);
        EXPECT_TRUE(r.draw(p, {{10, 2.5, 1}, {10, 0, 4}, 40, 0}, small()));
        seen[shadows] = r.readLinear();
    }
    float most = 0;
    for (size_t i = 0; i < seen[0].size(); ++i) most = std::max(most, std::abs(seen[1][i] - seen[0][i]));
    return most;
}
// The haze between the eye and the soil is none of what lies in the shadow.
TEST(GroundShadow, TakesNoneOfTheHazesLight) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    for (const Technique technique : {Technique::Geometry, Technique::Tessellated, Technique::Raytraced}) {
        const float black = shadowsChange(r, technique, 0), grey = shadowsChange(r, technique, 0.2f);
        printf("%s: shadows change black soil by %.5f, grey soil by %.5f\n", nameOf(technique), black, grey);
        EXPECT_LT(black, 0.001f);
        EXPECT_GT(grey, 0.02f);
    }
}

}  // namespace
}  // namespace sward::test
