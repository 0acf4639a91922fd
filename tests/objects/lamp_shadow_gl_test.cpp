// Shadows of objects in lamps' light lie where the ray-traced truth has them, on ground and grass of every technique,
// follow what moves, and are not there where nothing casts any.
#include "objects/lamp_shadow.h"

#include "fields.h"
#include "lamps.h"
#include "scene/scatter.h"
#include "shared/objects.h"
#include "techniques.h"

namespace sward::test {
namespace {

StaticMesh& cubeOf(Project& p) { return *p.registry.get<StaticMesh>(findEntity(p, "cube")); }
Light& lampOf(Project& p) { return *p.registry.get<Light>(findEntity(p, "lamp")); }
uint64_t lampDraws(const Renderer& r) { return drawsOf(r, "objects/lamp-shadow"); }

// Points of level ground around the cube that are seen past it from above.
std::vector<glm::dvec2> aroundTheCube() {
    std::vector<glm::dvec2> points;
    for (double x = 3; x <= 17; x += 0.25)
        for (double z = 3; z <= 17; z += 0.25)
            if (std::max(std::abs(x - 10), std::abs(z - 10)) > 1.4) points.emplace_back(x, z);
    return points;
}
void expectAsInTheTruth(Renderer& r, Project& p, double edge) {
    const ThreePictures of = threePictures(r, p, kOver, square(), cubeOf(p).castShadows);
    const auto spots = groundSpots(aroundTheCube(), edge, [](double, double) { return 0.0; });
    expectAsInTruth(compareShadows(of, kOver, square(), spots), 15, 1000);
}

TEST(LampShadows, BehindABoxItIsDarkWhereTheTruthIsDark) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = cubeAtNight(dir.path);
    Renderer r(gpu(), tables());
    const struct {
        const char* what;
        glm::dvec3 at;
    } lamps[] = {{"south of it", {10, 5, 13}},
                 {"low, at an edge of the cube of maps", {6, 1.2, 14}},
                 {"over its corner", {11.1, 4, 11.2}},
                 {"far aside", {18, 3, 8.5}}};
    for (const auto& lamp : lamps) {
        SCOPED_TRACE(lamp.what);
        p.registry.get<Transform>(findEntity(p, "lamp"))->position = lamp.at;
        expectAsInTheTruth(r, p, 0.25);
    }
}

TEST(LampShadows, ADirectionalLightBesideTheSunCastsAsTheTruthHasIt) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = cubeAtNight(dir.path);
    removeEntity(p, "lamp");
    put<Light>(p, "a-sun", {.intensity = 0});
    put<Light>(p, "moon", {.azimuthDeg = 160, .elevationDeg = 35, .intensity = 0.2f});
    Renderer r(gpu(), tables());
    expectAsInTheTruth(r, p, 0.5);  // a texel is 14 cm wide 16 m from the eye, and such a light falls far aside
    put<Light>(p, "a-sun", {.intensity = 1});
    ASSERT_TRUE(r.draw(p, kOver, square()));
    put<Light>(p, "lamp", {.type = LightType::Point});
    put<Transform>(p, "lamp", {{6, 2, 10}});
    ASSERT_TRUE(r.draw(p, kOver, square())) << "maps of both kinds, and the sun's";
    EXPECT_EQ(lampDraws(r), 6u + 1u) << "six cascades, and the one face of the cube that sees the box";
}

TEST(LampShadows, BeginAtTheFootOfWhatCastsThem) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = cubeAtNight(dir.path);
    const ViewCamera behind{{10, 4, 4}, {10, 0, 8.95}, 24, 0};
    Renderer r(gpu(), tables());
    const ThreePictures of = threePictures(r, p, behind, square(), cubeOf(p).castShadows);
    // Two texels are 2 x 2 x 6.4 m / 512 = 5 cm there, and a pixel is 17 mm wide.
    const double places[][2] = {{10, 8.95}, {9.05, 8.95}, {10.95, 8.95}};
    for (const auto& [x, z] : places)
        EXPECT_LT(greenAt(of.drawn, behind, square(), {x, 0, z}), 0.05f * greenAt(of.open, behind, square(), {x, 0, z}))
            << x << ' ' << z;
}

TEST(LampShadows, NothingShadesWhatLiesOpen) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = cubeAtNight(dir.path);
    p.registry.get<Transform>(findEntity(p, "cube"))->position = {1.2, 0, 1.2};
    Renderer r(gpu(), tables());
    for (const ViewCamera& c :
         {ViewCamera{{10, 1.7, 3}, {10, 0, 12}, 60, 0}, ViewCamera{{10, 9, 12}, {10, 0, 12.1}, 60, 0}})
        EXPECT_LE(mostShaded(r, p, c, cubeOf(p).castShadows), 1);
}

TEST(LampShadows, LieOnGrassOfEveryTechniqueAndOnFlowers) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = cubeAtNight(dir.path);
    FlatField f;
    f.species[0].bladesPerM2 = 1500, f.species[0].width = 0.03f, f.species[0].height = 0.15f;
    put(p, "grass", f);
    ViewSettings s = square();
    s.measure = false;
    const auto lightIn = [&](const std::vector<float>& pixels, double z0, double z1) {
        double sum = 0;
        for (double x = 9.4; x <= 10.6; x += 0.1)
            for (double z = z0; z <= z1; z += 0.1) sum += static_cast<double>(greenAt(pixels, kOver, s, {x, 0.1, z}));
        return sum;
    };
    const auto expectShade = [&](const std::string& what) {
        Renderer r(gpu(), tables());
        cubeOf(p).castShadows = false;
        const std::vector<float> open = drawnLight(r, p, kOver, s);
        cubeOf(p).castShadows = true;
        const std::vector<float> shaded = drawnLight(r, p, kOver, s);
        const double dark = lightIn(shaded, 7.2, 8.4) / lightIn(open, 7.2, 8.4),
                     lit = lightIn(shaded, 3, 5) / lightIn(open, 3, 5);
        std::printf("%s: %.4f of the light in the shadow, %.4f beyond it\n", what.c_str(), dark, lit);
        EXPECT_GT(lightIn(open, 7.2, 8.4), 0.01) << what;
        EXPECT_LT(dark, 0.1) << what;
        EXPECT_NEAR(lit, 1, 0.002) << what;
    };
    for (const Technique t : {Technique::Hybrid, Technique::Geometry, Technique::Slices, Technique::Flat,
                              Technique::Tessellated, Technique::Raytraced}) {
        flatField(p).technique = nameOf(t);
        expectShade(nameOf(t));
    }
    removeEntity(p, "grass");
    put<Flowers>(p, "flowers", {.flowersPerM2 = 60});
    expectShade("flowers");
}

TEST(LampShadows, OfALampThatDoesNotCastAreNotThereAtAll) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = cubeAtNight(dir.path);
    lampOf(p).castShadows = false;
    Renderer r(gpu(), tables());
    const auto drawn = [&] {
        EXPECT_TRUE(r.draw(p, kOver, square()));
        return r.readImage();
    };
    const std::vector<uint8_t> as = drawn();
    cubeOf(p).castShadows = false;
    EXPECT_EQ(as, drawn()) << "byte for byte";
    const auto there = [&] { return has(sceneFeatures(p.registry, tables()), Feature::LampShadows); };
    EXPECT_FALSE(there());
    cubeOf(p).castShadows = true;
    EXPECT_FALSE(there());
    EXPECT_EQ(gpu().ledger.count("objects/lamp-shadow"), 0u);
    for (const std::string& name : r.programNames()) EXPECT_NE(name, "objects/lamp-shadow");
    EXPECT_NE(r.explain(p, false).find("lamp-shadows: no StaticMesh, no Scatter and no Forest casts shadows, or no"),
              std::string::npos);
    lampOf(p).castShadows = true;
    EXPECT_TRUE(there());
    drawn();
    EXPECT_EQ(gpu().ledger.at("objects/lamp-shadow"), 6 * 4 * 512 * 512 + int64_t(sizeof(LampShadowGlobals)));
    EXPECT_NE(r.explain(p, false).find("lamp-shadows  (because of cube)"), std::string::npos);
    lampOf(p).intensity = 0;
    drawn();
    EXPECT_EQ(gpu().ledger.count("objects/lamp-shadow"), 0u) << "given back";
}

TEST(LampShadows, AreDrawnAnewOnlyWhereSomethingMoved) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = cubeAtNight(dir.path);
    Renderer r(gpu(), tables());
    const auto draws = [&](const ViewCamera& c) {
        EXPECT_TRUE(r.draw(p, c, square()));
        return lampDraws(r);
    };
    EXPECT_GT(draws(kOver), 0u);
    ViewCamera moved = kOver;
    moved.eye.x += 3, moved.target.x += 3;
    EXPECT_EQ(draws(moved), 0u) << "the eye";
    ASSERT_LT(lightAt(r, moved, square(), {10, 0, 8}).y, 0.05f * lightAt(r, moved, square(), {10, 0, 5}).y);
    p.registry.get<Transform>(findEntity(p, "cube"))->position.x += 4;
    EXPECT_GT(draws(moved), 0u) << "the cube";
    EXPECT_GT(lightAt(r, moved, square(), {10, 0, 8}).y, 0.5f * lightAt(r, moved, square(), {10, 0, 5}).y);
    EXPECT_LT(lightAt(r, moved, square(), {14.4, 0, 8.4}).y, 0.05f * lightAt(r, moved, square(), {10, 0, 8}).y);
    lampOf(p).color = {1, 0.2f, 0.2f};
    EXPECT_EQ(draws(moved), 0u) << "its colour";
    p.registry.get<Transform>(findEntity(p, "lamp"))->position.z = 6;
    EXPECT_GT(draws(moved), 0u) << "the lamp";
    EXPECT_LT(lightAt(r, moved, square(), {14.8, 0, 11.4}).x, 0.05f * lightAt(r, moved, square(), {10, 0, 8}).x);
}

TEST(LampShadows, EveryOneOfEightLampsThrowsItsOwn) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = cubeAtNight(dir.path);
    removeEntity(p, "lamp");
    for (int i = 0; i < MAX_LIGHTS; ++i) {
        const double a = i * 6.283185307 / MAX_LIGHTS;
        putLamp(p, "lamp" + std::to_string(i), {10 + 4 * std::cos(a), 4, 10 + 4 * std::sin(a)},
                {.intensity = 4, .attenuation = 0.1f});
    }
    Renderer r(gpu(), tables());
    const ThreePictures of = threePictures(r, p, kOver, square(), cubeOf(p).castShadows);
    int shaded = 0;
    float off = 0;
    for (const glm::dvec2& place : aroundTheCube()) {
        const glm::dvec3 at(place.x, 0, place.y);
        const float truth = greenAt(of.truth, kOver, square(), at), open = greenAt(of.open, kOver, square(), at);
        shaded += truth < 0.9f * open;
        off = std::max(off, std::abs(greenAt(of.drawn, kOver, square(), at) - truth) / open);
    }
    EXPECT_GT(shaded, 250);
    EXPECT_LT(off, 0.1f) << "edges included: none is of more than two lamps";
}

// Points of three faces of the cube, 0.15 m and more from its edges.
std::vector<Spot> onTheCube(double beside) {
    struct Face {
        glm::dvec3 middle, right, up;
    };
    const Face faces[] = {
        {{10, 1, 11}, {1, 0, 0}, {0, 1, 0}}, {{9, 1, 10}, {0, 0, 1}, {0, 1, 0}}, {{10, 2, 10}, {1, 0, 0}, {0, 0, 1}}};
    std::vector<Spot> spots;
    for (const auto& [middle, right, up] : faces)
        for (double x = -0.8; x <= 0.81; x += 0.1)
            for (double y = -0.8; y <= 0.81; y += 0.1) {
                const glm::dvec3 at = middle + right * x + up * y;
                spots.push_back({at, {at + right * beside, at - right * beside, at + up * beside, at - up * beside}});
            }
    return spots;
}
const ViewCamera kAside{{7, 4, 16}, {10, 1, 10.5}, 36, 0};  // sees the cube from the south, the west and above
// A board between the lamp and the cube, as wide as this.
void putBoard(Project& p, const glm::dvec3& at, float side) {
    putObject(p, "board", {{.size = {side, side, 0.05f}}}, at);
    p.registry.get<StaticMesh>(findEntity(p, "board"))->onGround = false;
}
StaticMesh& boardOf(Project& p) { return *p.registry.get<StaticMesh>(findEntity(p, "board")); }

TEST(LampsOnObjects, ABoxIsLitAsInTheTruthAndDarkBehindAnother) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = cubeAtNight(dir.path);
    Renderer r(gpu(), tables());
    const struct {
        const char* what;
        glm::dvec3 at, board;
        int dark, lit;
    } lamps[] = {{"before it", {12, 3.5, 14}, {11, 1.9, 12.5}, 30, 250},
                 {"near it", {9.7, 2.8, 12.2}, {9.8, 1.8, 11.6}, 30, 250},
                 {"low, to the west", {5, 1, 11.5}, {7, 0.8, 10.9}, 8, 250},
                 {"far and high", {16, 12, 18}, {12, 5, 13}, 15, 250}};
    for (const auto& lamp : lamps) {
        SCOPED_TRACE(lamp.what);
        p.registry.get<Transform>(findEntity(p, "lamp"))->position = lamp.at;
        putBoard(p, lamp.board, 0.7f);
        const ThreePictures of = threePictures(r, p, kAside, square(), boardOf(p).castShadows);
        expectAsInTruth(compareShadows(of, kAside, square(), onTheCube(0.1)), lamp.dark, lamp.lit);
    }
}

TEST(LampsOnObjects, NoObjectShadesItsOwnLitSide) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = cubeAtNight(dir.path);
    Renderer r(gpu(), tables());
    // A ball whose middle is 1 m high.
    putObject(p, "cube", {{.kind = SolidKind::Ball, .size = {1, 1, 1}, .at = {0, 1, 0}}}, {10, 0, 10});
    std::vector<Spot> spots;
    for (int i = 0; i < 24; ++i)
        for (int k = 1; k < 16; ++k) {
            const auto on = [&](double dx, double dy) {
                const double turn = (i + dx) * 6.283185307 / 24, rise = (k + dy) * 3.141592654 / 16;
                return glm::dvec3(10 + std::sin(rise) * std::cos(turn), 1 + std::cos(rise),
                                  10 + std::sin(rise) * std::sin(turn));
            };
            const glm::dvec3 at = on(0, 0);
            if (glm::dot(glm::normalize(at - glm::dvec3(10, 1, 10)), glm::normalize(kAside.eye - at)) > 0.3)
                spots.push_back({at, {on(0.3, 0), on(-0.3, 0), on(0, 0.3), on(0, -0.3)}});
        }
    for (const glm::dvec3& at : {glm::dvec3(12, 3.5, 14), glm::dvec3(8, 2, 11.5), glm::dvec3(5, 1, 11.5),
                                 glm::dvec3(2, 14, 19), glm::dvec3(10.5, 2.3, 10)}) {
        SCOPED_TRACE(at.x);
        p.registry.get<Transform>(findEntity(p, "lamp"))->position = at;
        const ThreePictures of = threePictures(r, p, kAside, square(), cubeOf(p).castShadows);
        expectAsInTruth(compareShadows(of, kAside, square(), spots), -1, 20);
    }
}

// Where a ray meets a face of the cube of maps in a corner, texels slant to what faces it.
TEST(LampsOnObjects, ABoardInACornerOfAMapIsLitEvenly) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = cubeAtNight(dir.path);
    Renderer r(gpu(), tables());
    const glm::dvec3 middle(10, 3, 10), n = glm::normalize(glm::dvec3(1, 1, 1)),
                                        right = glm::normalize(glm::dvec3(1, 0, -1)), up = glm::cross(n, right);
    putObject(p, "cube", {{.size = {2, 2, 0.02f}, .turnDeg = {-35.2644f, 45, 0}}}, middle);
    cubeOf(p).onGround = false;
    std::vector<Spot> spots;
    for (double x = -0.8; x <= 0.81; x += 0.1)
        for (double y = 0.2; y <= 1.81; y += 0.1) {
            const glm::dvec3 at = middle + right * x + up * y;
            spots.push_back({at, {at, at, at, at}});
        }
    const ViewCamera before{middle + n * 4.0 + right, middle + up, 40, 0};
    for (const double away : {1.0, 3.0, 9.0})
        for (const double aside : {0.0, 0.5}) {
            p.registry.get<Transform>(findEntity(p, "lamp"))->position = middle + up + (n + right * aside) * away;
            const ThreePictures of = threePictures(r, p, before, square(), cubeOf(p).castShadows);
            expectAsInTruth(compareShadows(of, before, square(), spots), -1, 280);
        }
}

TEST(LampsOnObjects, ADirectionalLightBesideTheSunLightsThemAsInTheTruth) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = cubeAtNight(dir.path);
    removeEntity(p, "lamp");
    put<Light>(p, "a-sun", {.intensity = 0});
    put<Light>(p, "moon", {.azimuthDeg = 155, .elevationDeg = 30, .intensity = 0.2f});
    putBoard(p, {10.7, 1.5, 12.6}, 1);
    Renderer r(gpu(), tables());
    const ThreePictures of = threePictures(r, p, kAside, square(), boardOf(p).castShadows);
    expectAsInTruth(compareShadows(of, kAside, square(), onTheCube(0.2)), 15, 250);
}

TEST(LampsOnObjects, ScatteredOnesAndLampsThatCastNoShadows) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = cubeAtNight(dir.path);
    p.registry.get<Terrain>(findEntity(p, "ground"))->groundColor = glm::vec3(0);
    Renderer r(gpu(), tables());
    const auto expectTruth = [&](const char* what) {
        const auto green = [](const std::vector<float>& pixels) {
            double sum = 0;
            for (size_t i = 1; i < pixels.size(); i += 3) sum += static_cast<double>(pixels[i]);
            return sum;
        };
        const double truth = green(tracedLight(p, kAside, square(), 16));
        EXPECT_GT(truth, 10) << what;
        EXPECT_NEAR(green(drawnLight(r, p, kAside, square())) / truth, 1, 0.05) << what;
    };
    lampOf(p).castShadows = false;
    expectTruth("a lamp that casts none");
    removeEntity(p, "cube");
    put<Scatter>(p, "cubes", {.meshes = {{"cube", "cube.glb"}}, .perHectare = 500, .distance = 3, .size = {0.3, 0.5}});
    expectTruth("scattered, without shadows");
    lampOf(p).castShadows = true;
    expectTruth("scattered");
}

}  // namespace
}  // namespace sward::test
