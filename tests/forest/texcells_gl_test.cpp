// Trees as volumes: as dense and as bright as the same trees traced ray by ray, from above and from the side; each
// where the other trees' meshes are not; none where the density leaves none.
#include "forest/texcells.h"

#include "core/log.h"
#include "forest/flight.h"
#include "lamps.h"
#include "missed.h"
#include "objects.h"
#include "reference/reference.h"
#include "scenes.h"
#include "world/forest_stand.h"

namespace sward::test {
namespace {

Project wood(TreeKind kind, float meshesTo, float perHectare = 400) {
    Project p = lawn();
    removeEntity(p, "grass");
    Terrain& t = *p.registry.get<Terrain>(findEntity(p, "ground"));
    t.size = {160, 160};
    t.groundColor = {0.2f, 0.05f, 0.02f};
    put<Forest>(
        p, "trees",
        {.species = {{.kind = kind, .leaves = 1500}}, .perHectare = perHectare, .distance = 3, .meshesTo = meshesTo});
    return p;
}
const ViewCamera kAir{{80, 90, 210}, {80, 0, 80}, 40, 0};
const ViewCamera kSide{{80, 7, 260}, {80, 6, 80}, 30, 0};

std::vector<float> drawn(const Project& p, const ViewCamera& c) {
    Renderer renderer(gpu(), tables());
    ViewSettings s = small();
    EXPECT_TRUE(renderer.draw(p, c, s));
    return renderer.readLinear();
}
std::vector<float> traced(const Project& p, const ViewCamera& c) {
    JobControl control;
    const auto scene = ReferenceScene::make(p, tables(), 0, control);
    EXPECT_TRUE(scene) << scene.error().text();
    ReferenceSettings settings;
    settings.width = 160, settings.height = 120, settings.samples = 16;
    const auto truth = scene->trace(c, settings, control);
    EXPECT_TRUE(truth);
    return truth->color;
}
// Mean of a picture's lower middle, where trees are.
glm::dvec3 meanOf(const std::vector<float>& pixels) {
    glm::dvec3 sum(0);
    int n = 0;
    for (size_t y = 50; y < 90; ++y)
        for (size_t x = 40; x < 120; ++x, ++n)
            for (int c = 0; c < 3; ++c)
                sum[c] += static_cast<double>(pixels[3 * (y * 160 + x) + static_cast<size_t>(c)]);
    return sum / static_cast<double>(n);
}

TEST(Texcells, AreAsBrightAsTheTruth) {
    NoGlErrors errors;
    const ViewCamera views[] = {kAir, kSide};
    for (const TreeKind kind : {TreeKind::Conifer, TreeKind::Broadleaf, TreeKind::Birch}) {
        const Project volumes = wood(kind, 0), bare = wood(kind, 0, 0);
        for (const ViewCamera& camera : views) {
            const glm::dvec3 truth = meanOf(traced(volumes, camera)), ours = meanOf(drawn(volumes, camera)),
                             none = meanOf(drawn(bare, camera));
            const double error = glm::length(ours - truth) / glm::length(truth),
                         without = glm::length(none - truth) / glm::length(truth);
            std::printf("kind %d, %s: drawn %.4f, truth %.4f, bare %.4f\n", static_cast<int>(kind),
                        &camera == &views[0] ? "air" : "side", ours.y, truth.y, none.y);
            EXPECT_LT(error, 0.3) << "kind " << static_cast<int>(kind) << (&camera == &views[0] ? " air" : " side");
            EXPECT_LT(error, 0.5 * without) << "bare ground must lose";
        }
    }
}

// Conifers in the sun alone on ground that rises towards it by so much (m a metre), seen along its way from above.
// Green light of volumes and of the truth.
glm::dvec2 onSlope(float rise, double from) {
    Project p = wood(TreeKind::Conifer, 0);
    for (const char* name : {"sky", "haze"}) removeEntity(p, name);
    Light& sun = *p.registry.get<Light>(findEntity(p, "sun"));
    sun.azimuthDeg = 0, sun.elevationDeg = 38;
    Terrain& ground = *p.registry.get<Terrain>(findEntity(p, "ground"));
    ground.groundColor = glm::vec3(0);
    Map m({64, 64, 1, PixelType::F32});
    for (int z = 0; z < 64; ++z)
        for (int x = 0; x < 64; ++x) m.set(x, z, 0, rise * (80 - 160 * (static_cast<float>(z) + 0.5f) / 64));
    ground.height = field(m, "maps/slope.exr");
    const ViewCamera eye{{80, 150, from}, {80, 0, 80}, 40, 0};
    return {meanOf(drawn(p, eye)).y, meanOf(traced(p, eye)).y};
}

// Uphill trees stand higher, in the sun's way or below it: by as much as in the truth slopes are brighter or darker
// than level ground. By the level forest's shares alone slopes that face away would be brighter by half, seen from the
// sun.
TEST(Texcells, OnSlopesTheSunChangesAsInTheTruth) {
    NoGlErrors errors;
    for (const double from : {0.0, 160.0}) {  // with the sun, against it
        const glm::dvec2 level = onSlope(0, from);
        for (const float rise : {-0.5f, 0.45f}) {
            const glm::dvec2 here = onSlope(rise, from), times = here / level;
            std::printf("ground that rises %.2f towards the sun, against level ground: drawn %.3f, truth %.3f\n",
                        static_cast<double>(rise), times.x, times.y);
            EXPECT_NEAR(times.x / times.y, 1, 0.2) << rise << " from " << from;
        }
    }
}

// Low suns behind the trees: what is seen of leaves is lit by what shines through them.
TEST(Texcells, GlowAgainstTheSunAsTheTruthDoesByVolumesAndByMeshes) {
    NoGlErrors errors;
    const ViewCamera eye{{80, 10, 215}, {80, 6, 80}, 40, 0};
    const auto scene = [](TreeKind kind, float meshesTo, float translucency) {
        Project p = wood(kind, meshesTo);
        p.registry.get<Forest>(findEntity(p, "trees"))->species[0].translucency = translucency;
        Light& sun = *p.registry.get<Light>(findEntity(p, "sun"));
        sun.azimuthDeg = 0, sun.elevationDeg = 22;
        return p;
    };
    for (const TreeKind kind : {TreeKind::Conifer, TreeKind::Broadleaf, TreeKind::Birch}) {
        const double truth = meanOf(traced(scene(kind, 0, 0.8f), eye)).y,
                     dull = meanOf(traced(scene(kind, 0, 0), eye)).y;
        const double volumes = meanOf(drawn(scene(kind, 0, 0.8f), eye)).y,
                     meshes = meanOf(drawn(scene(kind, 400, 0.8f), eye)).y,
                     without = meanOf(drawn(scene(kind, 0, 0), eye)).y;
        std::printf(
            "kind %d: truth %.4f, volumes %.4f, meshes %.4f; of leaves that let nothing through %.4f and %.4f\n",
            static_cast<int>(kind), truth, volumes, meshes, dull, without);
        EXPECT_GT(truth, 1.1 * dull) << "or nothing was tested";
        EXPECT_NEAR(volumes / truth, 1, 0.1);
        if (kind == TreeKind::Conifer)
            expectMissed("meshes of conifers against the sun, brighter than the truth by", meshes / truth - 1, 0.1,
                         0.115);
        else
            EXPECT_NEAR(meshes / truth, 1, 0.1);
    }
}

// The wood at night over black ground.
Project woodAtNight(TreeKind kind, float meshesTo) {
    Project p = wood(kind, meshesTo);
    for (const char* name : {"sun", "sky", "haze"}) removeEntity(p, name);
    p.registry.get<Terrain>(findEntity(p, "ground"))->groundColor = glm::vec3(0);
    return p;
}
void putMoon(Project& p) {
    put<Light>(p, "a-sun", {.intensity = 0});
    put<Light>(p, "moon", {.azimuthDeg = 150, .elevationDeg = 35, .intensity = 0.2f});
}
double allGreenOf(const std::vector<float>& pixels) {
    double sum = 0;
    for (size_t i = 1; i < pixels.size(); i += 3) sum += static_cast<double>(pixels[i]);
    return sum;
}

TEST(Texcells, AreAsBrightInLampsLightAsMeshesAndNearlyAsTheTruth) {
    NoGlErrors errors;
    const ViewCamera eye{{80, 10, 215}, {80, 6, 80}, 40, 0};
    const std::pair<const char*, void (*)(Project&)> lights[] = {
        {"a lamp before the wood",
         [](Project& p) {
             putLamp(p, "lamp", {80, 8, 172}, {.intensity = 20, .attenuation = 0.02f});
         }},
        {"a lamp over it",
         [](Project& p) {
             putLamp(p, "lamp", {80, 22, 140}, {.intensity = 40, .attenuation = 0.02f});
         }},
        {"a moon", putMoon}};
    const std::pair<const char*, TreeKind> kinds[] = {
        {"conifers", TreeKind::Conifer}, {"broadleaves", TreeKind::Broadleaf}, {"birches", TreeKind::Birch}};
    for (const auto& [trees, kind] : kinds)
        for (const auto& [light, putLight] : lights) {
            const std::string what = std::string(trees) + ", " + light;
            Project far = woodAtNight(kind, 0), near = woodAtNight(kind, 400);
            putLight(far), putLight(near);
            const double truth = allGreenOf(tracedLight(far, eye, small(), 6)), volumes = allGreenOf(drawn(far, eye)),
                         meshes = allGreenOf(drawn(near, eye));
            std::printf("%s: volumes %.3f of the truth, meshes %.3f\n", what.c_str(), volumes / truth, meshes / truth);
            EXPECT_GT(truth, 10) << what;
            EXPECT_NEAR(volumes / meshes, 1, 0.15) << what;
            if (what == "conifers, a lamp over it")  // what is farther off on the way than crowns are wide counts not
                expectMissed(what, std::abs(volumes / truth - 1), 0.25, 0.358);
            else
                EXPECT_NEAR(volumes / truth, 1, 0.25) << what;
        }
}

TEST(Texcells, LeaveTheLightOfLampsOnTheGroundBelowThem) {
    NoGlErrors errors;
    const ViewCamera down{{80, 40, 80.1}, {80, 0, 80}, 30, 0};
    Project p = woodAtNight(TreeKind::Conifer, 0);
    p.registry.get<Terrain>(findEntity(p, "ground"))->groundColor = {0.2f, 0, 0};  // trees are not red alone
    put<Light>(p, "lamp", {.type = LightType::Point, .intensity = 20, .attenuation = 0.02f, .castShadows = false});
    put<Transform>(p, "lamp", {{80, 14, 80}});
    Forest& f = *p.registry.get<Forest>(findEntity(p, "trees"));
    f.perHectare = 100;
    const std::vector<float> under = drawn(p, down);
    f.perHectare = 0;
    const std::vector<float> bare = drawn(p, down);
    int ground = 0;
    for (size_t i = 0; i < bare.size(); i += 3) {
        if (under[i + 1] > 0) continue;
        ++ground;
        EXPECT_NEAR(under[i] / bare[i], 1, 0.01f) << i / 3;
    }
    EXPECT_GT(ground, 3000);
    EXPECT_LT(ground, 18000) << "or no tree is there";
}

// Black ground beside a wood, seen from above in thick haze: all that is seen of it is the haze, shaded or not.
TEST(Texcells, ShadeTheGroundAndNotTheHazeBeforeIt) {
    NoGlErrors errors;
    const auto strip = [](float perHectare, const glm::vec3& soil) {
        Project p = wood(TreeKind::Conifer, 0, perHectare);
        p.registry.get<Fog>(findEntity(p, "haze"))->visibility = 500;
        p.registry.get<Terrain>(findEntity(p, "ground"))->groundColor = soil;
        Map m({16, 16, 1, PixelType::U16});
        for (int z = 0; z < 16; ++z)
            for (int x = 0; x < 16; ++x) m.set(x, z, 0, z < 8 ? 1.0f : 0.0f);
        p.registry.get<Forest>(findEntity(p, "trees"))->density = field(m, "maps/trees.png");
        return drawn(p, {{80, 90, 86.5}, {80, 0, 86.501}, 1, 0});
    };
    const auto off = [](const std::vector<float>& a, const std::vector<float>& b) {
        float most = 0;
        for (size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
        return most;
    };
    const float shaded = off(strip(400, {0.5f, 0.5f, 0.5f}), strip(0, {0.5f, 0.5f, 0.5f})),
                haze = off(strip(400, {0, 0, 0}), strip(0, {0, 0, 0}));
    std::printf("shade takes %.4f of bright ground, %.4f of black\n", static_cast<double>(shaded),
                static_cast<double>(haze));
    EXPECT_GT(shaded, 0.005f) << "the place lies in the shade";
    EXPECT_LT(haze, 0.15f * shaded);
}

TEST(Texcells, AreThereWhereMeshesEndAndNowhereElse) {
    NoGlErrors errors;
    const float inf = std::numeric_limits<float>::infinity();
    // All as meshes: no volume in the plan; and a picture that the same trees as volumes come near to.
    const std::vector<float> meshes = drawn(wood(TreeKind::Birch, inf), kAir),
                             volumes = drawn(wood(TreeKind::Birch, 0), kAir),
                             both = drawn(wood(TreeKind::Birch, 160), kAir);
    const double a = meanOf(meshes).y, b = meanOf(volumes).y, c = meanOf(both).y;
    EXPECT_GT(c, 0.97 * std::min(a, b));
    EXPECT_LT(c, 1.03 * std::max(a, b)) << "trees drawn by both would be denser than by either";
}

TEST(Texcells, ADensityOfNothingDrawsNothing) {
    NoGlErrors errors;
    Renderer renderer(gpu(), tables());
    Project p = wood(TreeKind::Conifer, 0);
    ASSERT_TRUE(renderer.draw(p, kAir, small()));
    p.registry.get<Forest>(findEntity(p, "trees"))->density = field(filled({16, 16, 1, PixelType::U16}, 0));
    ASSERT_TRUE(renderer.draw(p, kAir, small()));
    EXPECT_EQ(renderer.readLinear(), drawn(wood(TreeKind::Conifer, 0, 0), kAir)) << "nor does it shade, as before";
}

TEST(Texcells, DrawTheSameFarFromTheOrigin) {
    NoGlErrors errors;
    Project p = wood(TreeKind::Broadleaf, 0);
    const std::vector<float> here = drawn(p, kAir);
    const glm::dvec3 away(90000, 0, -90000);
    put(p, "ground", Transform{away});
    ViewCamera camera = kAir;
    camera.eye += away, camera.target += away;
    const std::vector<float> there = drawn(p, camera);
    size_t off = 0;
    for (size_t i = 0; i < here.size(); ++i) off += std::abs(here[i] - there[i]) > 0.004f;
    EXPECT_LT(off, here.size() / 500);
}

// What is coarser by one level stands for the same slabs: over the fraction of a level the picture's mean moves evenly.
TEST(Texcells, NoStepWhereLevelsChange) {
    NoGlErrors errors;
    const Project p = wood(TreeKind::Conifer, 0);
    Renderer renderer(gpu(), tables());
    double least = 1e30, most = 0, before = 0, step = 0;
    for (int i = 0; i <= 24; ++i) {
        ViewSettings s = small();
        const double back = 300 * std::pow(2.2, i / 24.0);
        // The same picture from farther away through a longer lens.
        const float fov = static_cast<float>(2 * glm::degrees(std::atan(std::tan(glm::radians(12.0)) * 300 / back)));
        ASSERT_TRUE(renderer.draw(p, {{80, back * 0.7, 80 + back * 0.7}, {80, 0, 80}, fov, 0}, s));
        const double now = meanOf(renderer.readLinear()).y;
        least = std::min(least, now), most = std::max(most, now);
        if (i > 0) step = std::max(step, std::abs(now / before - 1));
        before = now;
    }
    EXPECT_LT(step, 0.02) << "from " << least << " to " << most;
}

TEST(Texcells, OddPlacesOfTheEyeGiveFinitePictures) {
    NoGlErrors errors;
    const Project p = wood(TreeKind::Conifer, 0);
    for (const ViewCamera& c :
         {ViewCamera{{80, 6, 80}, {80, 6, 0}, 55, 0}, ViewCamera{{80, 200, 80}, {80, 0, 80.001}, 55, 0},
          ViewCamera{{-50, 0.001, 80}, {80, 0.001, 80}, 55, 0}, ViewCamera{{80, 1, 80}, {80, 300, 80.5}, 55, 0}})
        for (const float x : drawn(p, c)) ASSERT_TRUE(std::isfinite(x) && x >= 0 && x < 100);
}

TEST(Texcells, WhereMeshesEndPicturesChangeNoMoreAndNoLessThanOfMeshesAlone) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    const Restless seen = flightToVolumes(r, 6);
    std::printf("pixels %.2f means %.2f, in all %.2f and %.2f times\n", seen.pixels, seen.means, seen.pixelsTimes,
                seen.meansTimes);
    EXPECT_TRUE(seen.isLikeBlades());
}

TEST(Texcells, FlownOverTheyChangeAsTheTruthDoes) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    for (const Flight& f : kFlights) {
        const auto t = flight(r, tables(), f, 9);
        ASSERT_TRUE(t) << t.error().text();
        const double seen = Flown::popping(t->seen), frozen = Flown::popping(t->frozen);
        std::printf("%s: popping %.2f of other trees', one that stands still %.2f; change %.2f\n", f.name, seen, frozen,
                    t->seen.drawn.change);
        EXPECT_LT(seen, 1.25) << f.name;
        EXPECT_GT(frozen, 1.25) << "the measure would accept a flight that stands still";
    }
}

// Slices have one sample a pixel; what stands before them keeps the smooth edges of its own samples.
TEST(Texcells, WhatStandsBeforeThemKeepsItsSmoothEdge) {
    NoGlErrors errors;
    const TempDir dir;
    const auto scene = [&](bool post, float perHectare) {
        Project p = wood(TreeKind::Broadleaf, 0, perHectare);
        p.dir = dir.path;
        if (post)
            putObject(p, "post", {{.size = {3, 30, 3}, .turnDeg = {0, 0, 11}, .color = {0.9f, 0.05f, 0.05f}}},
                      {80, -3, 225});
        return drawn(p, kSide);
    };
    const std::vector<float> both = scene(true, 400), forest = scene(false, 400), post = scene(true, 0),
                             none = scene(false, 0);
    double off = 0, apart = 0;
    int edges = 0;
    for (size_t y = 45; y < 65; ++y) {
        // What the post's side looks like in this row: there, the forest changes nothing.
        size_t inside = 3 * (y * 160);
        for (size_t i = 3 * y * 160; i < 3 * (y + 1) * 160; i += 3)
            if (std::abs(post[i] - none[i]) > std::abs(post[inside] - none[inside])) inside = i;
        for (size_t i = 3 * y * 160; i < 3 * (y + 1) * 160; i += 3) {
            const double share = static_cast<double>((post[i] - none[i]) / (post[inside] - none[i]));
            if (!(share > 0.2 && share < 0.8)) continue;
            off += static_cast<double>(both[i]) -
                   glm::mix(static_cast<double>(forest[i]), static_cast<double>(post[inside]), share);
            apart += static_cast<double>(post[inside] - forest[i]);
            ++edges;
        }
    }
    EXPECT_GT(edges, 10);
    EXPECT_LT(std::abs(off), 0.1 * std::abs(apart)) << "of " << edges << " pixels at its edges";
}

struct Counted {
    double vertices = 0, fragments = 0, bytes = 0;
};
// Of the volumes alone, seen from above: what is in the picture lies within the lesser terrain.
Counted countedOn(double side) {
    Project p = wood(TreeKind::Conifer, 0);
    p.registry.get<Terrain>(findEntity(p, "ground"))->size = {side, side};
    const auto before = gpu().ledger["forest/texcells"];
    Renderer renderer(gpu(), tables());
    ViewSettings s = small();
    s.measure = true;
    EXPECT_TRUE(renderer.draw(p, {{101, 140, 101}, {101, 0, 101.1}, 40, 0}, s));
    Counted c;
    for (const PassStats& pass : renderer.stats().passes)
        if (pass.name == "forest/texcells")
            c.vertices += static_cast<double>(pass.vertices), c.fragments += static_cast<double>(pass.fragments);
    c.bytes = static_cast<double>(gpu().ledger["forest/texcells"] - before);
    return c;
}

TEST(Texcells, AForestOfTwentyFiveTimesTheAreaTakesNoMore) {
    NoGlErrors errors;
    const Counted small = countedOn(202), large = countedOn(1010);
    std::printf("vertices %.0f and %.0f, fragments %.0f and %.0f, bytes %.0f and %.0f\n", small.vertices,
                large.vertices, small.fragments, large.fragments, small.bytes, large.bytes);
    ASSERT_GT(small.fragments, 10000);
    EXPECT_LE(large.vertices, 1.05 * small.vertices);
    EXPECT_LE(large.fragments, 1.05 * small.fragments);
    // A volume's bytes are the same; of the shade map, which grows up to its most texels a side, there are more.
    EXPECT_LE(large.bytes, 1.05 * small.bytes);
}

// What users may ask for. Each gives a picture of finite light, and what cannot be is said.
std::string saidOf(const Project& p, const ViewCamera& c) {
    std::string said;
    const int sink = addLogSink([&](LogLevel, const std::string& line) { said += line + "\n"; });
    for (const float x : drawn(p, c)) EXPECT_TRUE(std::isfinite(x) && x >= 0);
    removeLogSink(sink);
    return said;
}
Forest& forestIn(Project& p) { return *p.registry.get<Forest>(findEntity(p, "trees")); }

TEST(Texcells, CliffsAreCountedAndSaid) {
    NoGlErrors errors;
    Project p = wood(TreeKind::Conifer, 0);
    forestIn(p).slopeDeg = {0, 90};
    Map m({64, 64, 1, PixelType::F32});
    for (int z = 0; z < 64; ++z)
        for (int x = 0; x < 64; ++x) m.set(x, z, 0, x < 32 ? 0.0f : 3000.0f);
    p.registry.get<Terrain>(findEntity(p, "ground"))->height = field(m, "maps/height.exr");
    EXPECT_NE(saidOf(p, kAir).find("tiles lie on cliffs"), std::string::npos);
    EXPECT_EQ(saidOf(wood(TreeKind::Conifer, 0), kAir), "");
}

TEST(Texcells, GroundOfNoAreaGivesAPicture) {
    NoGlErrors errors;
    Project p = wood(TreeKind::Conifer, 0);
    for (const glm::dvec2 size : {glm::dvec2(0.001, 160), glm::dvec2(160, 0.001), glm::dvec2(0.001, 0.001)}) {
        p.registry.get<Terrain>(findEntity(p, "ground"))->size = size;
        saidOf(p, kAir);
    }
}

TEST(Texcells, EnormousTreesAreDrawn) {
    NoGlErrors errors;
    Project p = wood(TreeKind::Broadleaf, 0, 60);
    forestIn(p).species[0].height = 150;
    forestIn(p).species[0].size = {1, 3};
    saidOf(p, kAir);
}

TEST(Texcells, WhatFindsNoRoomInATileIsSaid) {
    NoGlErrors errors;
    Project p =
        wood(TreeKind::Conifer, std::numeric_limits<float>::infinity(), 6000);  // told before any volume is made
    forestIn(p).distance = 8;
    EXPECT_NE(saidOf(p, kAir).find("trees find room"), std::string::npos);
}

TEST(Texcells, TreesOfAFileNeedNoMaterialAndMayHaveAMillionTriangles) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = wood(TreeKind::Conifer, 0, 100);
    p.dir = dir.path;
    Mesh mesh;
    for (int i = 0; i < 1000; ++i)
        for (int k = 0; k < 1000; ++k) {
            const float x = static_cast<float>(i - 500) / 250, z = static_cast<float>(k - 500) / 250;
            const uint32_t first = static_cast<uint32_t>(mesh.vertices.size());
            for (const glm::vec3& at : {glm::vec3(x, 4, z), glm::vec3(x, 4.02f, z), glm::vec3(x + 0.004f, 4, z)})
                mesh.vertices.push_back({at, {0, 0, 1}, {}});
            for (uint32_t c = 0; c < 3; ++c) mesh.indices.push_back(first + c);
        }
    mesh.parts = {{0, static_cast<uint32_t>(mesh.indices.size())}};
    updateBounds(mesh);
    writeText(dir / "leaves.glb", *encodeGlb(mesh));
    forestIn(p).species[0].file = "leaves.glb";
    EXPECT_EQ(saidOf(p, kAir).find("not drawn"), std::string::npos);
    EXPECT_NE(drawn(p, kAir), drawn(wood(TreeKind::Conifer, 0, 0), kAir));
    writeText(dir / "leaves.glb", "glTF, but broken");
    EXPECT_NE(saidOf(p, kAir).find("leaves.glb"), std::string::npos);
}

}  // namespace
}  // namespace sward::test
