// Trees as meshes: those nearer than meshesTo, each once, with fewer triangles farther away.
#include "forest/trees.h"

#include "lamps.h"
#include "missed.h"
#include "reference/reference.h"
#include "scenes.h"
#include "world/forest_stand.h"

namespace sward::test {
namespace {

Project wood(float meshesTo) {
    Project p = lawn();
    removeEntity(p, "grass");
    p.registry.get<Terrain>(findEntity(p, "ground"))->size = {120, 120};
    put<Forest>(p, "trees", {.species = {{.leaves = 1500}}, .meshesTo = meshesTo, .castShadows = false});
    return p;
}
const PassStats* passNamed(const Renderer& r, const std::string& name) {
    for (const PassStats& p : r.stats().passes)
        if (p.name == name) return &p;
    return nullptr;
}
ViewSettings measured() {
    ViewSettings s = small();
    s.measure = true;
    return s;
}
const ViewCamera kAbove{{60, 160, 61}, {60, 0, 60}, 80, 0};  // sees all of the terrain

TEST(ForestTrees, AreDrawnWhereVolumesAreNot) {
    NoGlErrors errors;
    Renderer renderer(gpu(), tables());
    for (const float to : {120.0f, 165.0f, 1000.0f}) {
        const Project p = wood(to);
        const Forest& f = *p.registry.get<Forest>(findEntity(p, "trees"));
        size_t near = 0;
        const StandingForest all = standingForest(f, findGround(p));
        for (const StandingTree& t : all.trees) near += isMesh(f, t, glm::distance(t.at, kAbove.eye));
        ASSERT_TRUE(renderer.draw(p, kAbove, measured()));
        const PassStats* pass = passNamed(renderer, "forest/trees");
        ASSERT_TRUE(pass);
        EXPECT_EQ(pass->instances, 4 * near) << "of bark and three tints, at " << to;
    }
}

// Middle of a tree's crown along the picture, by the share of each pixel that it covers.
double middleOf(const std::vector<float>& shares) {
    double sum = 0, at = 0;
    for (size_t y = 0; y < 60; ++y)
        for (size_t x = 0; x < 160; ++x) {
            const double share = static_cast<double>(shares[y * 160 + x]);
            sum += share, at += share * (static_cast<double>(x) + 0.5);
        }
    EXPECT_GT(sum, 50) << "a crown in the picture's upper half";
    return at / sum;
}
std::vector<float> tracedShares(const Project& p, const ViewCamera& c, double time) {
    JobControl control;
    const auto scene = ReferenceScene::make(p, tables(), time, control);
    EXPECT_TRUE(scene);
    ReferenceSettings s;
    s.width = 160, s.height = 120, s.samples = 8;
    s.lighting = ReferenceLighting::Direct;
    return scene->trace(c, s, control)->grass;
}
std::vector<float> drawnShares(const Project& p, const ViewCamera& c, double time) {
    Renderer renderer(gpu(), tables());
    ViewSettings s = small();
    s.time = time;
    const auto picture = [&](const Project& shown) {
        EXPECT_TRUE(renderer.draw(shown, c, s));
        return renderer.readLinear();
    };
    Project bare = snapshot(p, tables().components);
    bare.registry.get<Forest>(findEntity(bare, "trees"))->placed.clear();
    const std::vector<float> with = picture(p), without = picture(bare);
    std::vector<float> out;
    for (size_t i = 0; i < with.size(); i += 3) out.push_back(std::abs(with[i] - without[i]) > 0.02f ? 1.0f : 0.0f);
    return out;
}

TEST(ForestTrees, LeanInTheTruthAsTheyAreDrawn) {
    NoGlErrors errors;
    const ViewCamera side{{60, 6, 100}, {60, 6, 60}, 30, 0};
    Project calm = wood(60);
    Forest& f = *calm.registry.get<Forest>(findEntity(calm, "trees"));
    f.perHectare = 0;
    f.placed = {{.at = {60, 60}}};
    const double upright = middleOf(tracedShares(calm, side, 0));
    EXPECT_NEAR(middleOf(drawnShares(calm, side, 0)), upright, 1);
    Project windy = snapshot(calm, tables().components);
    put<Wind>(windy, "wind", {.strength = 8, .azimuthDeg = 90, .turbulence = 0.2f});
    double farthest = 0;
    for (const double time : {0.0, 3.0, 7.0}) {
        const double drawn = middleOf(drawnShares(windy, side, time)),
                     truth = middleOf(tracedShares(windy, side, time));
        std::printf("at %.0f s: drawn %.2f, truth %.2f, upright %.2f\n", time, drawn, truth, upright);
        EXPECT_NEAR(drawn, truth, 1);
        farthest = std::max(farthest, std::abs(truth - upright));
    }
    EXPECT_GT(farthest, 6) << "or this shows nothing";
    // In a calm rays meet what they met without Wind, to the last bit.
    windy.registry.get<Wind>(findEntity(windy, "wind"))->strength = 0;
    EXPECT_EQ(tracedShares(windy, side, 3), tracedShares(calm, side, 0));
}

double meanGreen(const std::vector<float>& pixels) {
    double sum = 0;
    for (size_t i = 1; i < pixels.size(); i += 3) sum += static_cast<double>(pixels[i]);
    return 3 * sum / static_cast<double>(pixels.size());
}

TEST(ForestTrees, AreLitThroughTheAirOfTheVolumes) {
    NoGlErrors errors;
    const ViewCamera within{{60, 2, 96}, {62, 4, 60}, 60, 0};
    const auto scene = [](float meshesTo) {
        Project p = wood(meshesTo);
        Forest& f = *p.registry.get<Forest>(findEntity(p, "trees"));
        f.castShadows = true;
        f.species[0].kind = TreeKind::Broadleaf;
        return p;
    };
    const auto green = [&](float meshesTo) {
        Renderer renderer(gpu(), tables());
        EXPECT_TRUE(renderer.draw(scene(meshesTo), within, small()));
        return meanGreen(renderer.readLinear());
    };
    JobControl control;
    const auto rays = ReferenceScene::make(scene(60), tables(), 0, control);
    ASSERT_TRUE(rays);
    ReferenceSettings settings;
    settings.width = 160, settings.height = 120, settings.samples = 16;
    const double truth = meanGreen(rays->trace(within, settings, control)->color);
    const double lit = green(60), open = green(std::numeric_limits<float>::infinity());
    std::printf("green: truth %.4f, through the air %.4f, in the open %.4f\n", truth, lit, open);
    EXPECT_LT(std::abs(lit - truth), 0.5 * std::abs(open - truth)) << "meshes without volumes know no canopy";
}

// Mean green light of what a tree alone sends against the sun: most of what is seen of it is lit from all around.
double againstTheSun(const std::vector<float>& shares, const std::vector<float>& pixels) {
    double sum = 0, count = 0;
    for (size_t i = 0; i < shares.size(); ++i)
        if (shares[i] > 0.99f) sum += static_cast<double>(pixels[3 * i + 1]), count += 1;
    EXPECT_GT(count, 300) << "pixels";
    return sum / count;
}

TEST(ForestTrees, LightFromAllAroundComesAsItDoesInTheTruth) {
    NoGlErrors errors;
    const ViewCamera side{{60, 4, 80}, {60, 6, 60}, 40, 0};
    const std::pair<const char*, TreeKind> kinds[] = {
        {"conifer", TreeKind::Conifer}, {"broadleaf", TreeKind::Broadleaf}, {"birch", TreeKind::Birch}};
    for (const auto& [kind, of] : kinds) {
        Project p = wood(std::numeric_limits<float>::infinity());
        removeEntity(p, "haze");
        Light& sun = *p.registry.get<Light>(findEntity(p, "sun"));
        sun.azimuthDeg = 0, sun.elevationDeg = 35;
        Forest& f = *p.registry.get<Forest>(findEntity(p, "trees"));
        f.species = {{.kind = of, .leaves = 1500}};
        f.perHectare = 0, f.placed = {{.at = {60, 60}}}, f.castShadows = true;
        JobControl control;
        const auto rays = ReferenceScene::make(p, tables(), 0, control);
        ASSERT_TRUE(rays);
        ReferenceSettings settings;
        settings.width = 160, settings.height = 120, settings.samples = 32;
        const auto truth = rays->trace(side, settings, control);
        ASSERT_TRUE(truth);
        Renderer renderer(gpu(), tables());
        ASSERT_TRUE(renderer.draw(p, side, small()));
        const double share =
            againstTheSun(truth->grass, renderer.readLinear()) / againstTheSun(truth->grass, truth->color);
        std::printf("%s: %.3f of the truth\n", kind, share);
        // Its shadow lies on the ground before it, which counts as lit.
        if (of == TreeKind::Conifer)
            expectMissed(std::string(kind) + " against the sun", std::abs(share - 1), 0.2, 0.3);
        else
            EXPECT_NEAR(share, 1, 0.2) << kind;
    }
}

// One tree at night on black ground, with a lamp.
Project treeAtNight(const TreeSpecies& species, const glm::dvec3& lamp) {
    Project p = wood(std::numeric_limits<float>::infinity());
    for (const char* name : {"sun", "sky", "haze"}) removeEntity(p, name);
    p.registry.get<Terrain>(findEntity(p, "ground"))->groundColor = glm::vec3(0);
    Forest& f = *p.registry.get<Forest>(findEntity(p, "trees"));
    f.species = {species};
    f.perHectare = 0;
    f.placed = {{.at = {60, 60}}};
    f.castShadows = true;
    putLamp(p, "lamp", lamp, {.intensity = 20, .attenuation = 0.02f});
    return p;
}

TEST(ForestTrees, AreAsBrightInLampsLightAsInTheTruth) {
    NoGlErrors errors;
    const ViewCamera side{{60, 4, 80}, {60, 6, 60}, 45, 0};
    const struct {
        const char* what;
        glm::dvec3 at;
    } lamps[] = {{"before it", {64, 6, 72}}, {"to a side", {70, 3, 60}}, {"behind it", {58, 5, 50}}};
    const std::pair<const char*, TreeKind> kinds[] = {
        {"conifer", TreeKind::Conifer}, {"broadleaf", TreeKind::Broadleaf}, {"birch", TreeKind::Birch}};
    ViewSettings s = small();
    s.width = 96, s.height = 96;
    for (const auto& [kind, of] : kinds)
        for (const auto& lamp : lamps) {
            Project p = treeAtNight({.kind = of, .leaves = 1500}, lamp.at);
            Renderer r(gpu(), tables());
            const double truth = meanGreen(tracedLight(p, side, s, 16)),
                         share = meanGreen(drawnLight(r, p, side, s)) / truth;
            const std::string what = std::string(kind) + ", a lamp " + lamp.what;
            std::printf("%s: %.3f of the truth\n", what.c_str(), share);
            EXPECT_GT(truth, 1e-3) << what;
            if (what == "conifer, a lamp behind it")  // a texel is wider than a needle
                expectMissed(what, std::abs(share - 1), 0.15, 0.332);
            else
                EXPECT_NEAR(share, 1, 0.15) << what;
        }
}

TEST(ForestTrees, CastShadowsThatAreSeenWhereTheyThemselvesAreNot) {
    NoGlErrors errors;
    Project p = wood(std::numeric_limits<float>::infinity());
    Forest& f = *p.registry.get<Forest>(findEntity(p, "trees"));
    f.perHectare = 0;
    f.placed = {{.at = {60, 60}}};
    Light& sun = *p.registry.get<Light>(findEntity(p, "sun"));
    sun.azimuthDeg = 0, sun.elevationDeg = 18;
    const ViewCamera beside{{60, 1.5, 83}, {60, 0, 84.5}, 25, 0};  // looks away from the tree, at its shadow
    const auto green = [&](bool casts) {
        f.castShadows = casts;
        Renderer r(gpu(), tables());
        EXPECT_TRUE(r.draw(p, beside, measured()));
        const PassStats* seen = passNamed(r, "forest/trees");
        EXPECT_TRUE(!seen || seen->instances == 0);
        return meanGreen(r.readLinear());
    };
    const double open = green(false), shaded = green(true);
    std::printf("ground by a tree: in the open %.4f, in its shadow %.4f\n", open, shaded);
    EXPECT_LT(shaded, 0.85 * open);
}

// Which trees cast shadows is the same for the view and its mirror, wherever it looks.
TEST(ForestTrees, ShadowMapsAreKeptWhileTheViewTurnsAndByWhatWaterMirrors) {
    NoGlErrors errors;
    Renderer renderer(gpu(), tables());
    Project p = wood(50);
    p.registry.get<Forest>(findEntity(p, "trees"))->castShadows = true;
    put<Water>(p, "lake", {.level = 0.5f, .reflection = 1});
    const auto draws = [&](const glm::dvec3& eye, double turn) {
        EXPECT_TRUE(renderer.draw(p, {eye, eye + glm::dvec3(std::sin(turn), -0.1, std::cos(turn)), 60}, measured()));
        EXPECT_TRUE(passNamed(renderer, "mirrored forest/trees")) << "there is a mirror";
        const PassStats *own = passNamed(renderer, "objects/shadow"),
                        *mirrored = passNamed(renderer, "mirrored objects/shadow");
        return own->draws + (mirrored ? mirrored->draws : 0);
    };
    const glm::dvec3 eye(60, 2.3, 60);
    EXPECT_GT(draws(eye, 0), 10u);
    EXPECT_EQ(draws(eye, 0), 0u);
    EXPECT_EQ(draws(eye, 2), 0u) << "turned";
    EXPECT_GT(draws(eye + glm::dvec3(40, 0, 0), 2), 10u) << "others are near";
}

TEST(ForestTrees, TakeFewerTrianglesFarAway) {
    NoGlErrors errors;
    Renderer renderer(gpu(), tables());
    const Project p = wood(std::numeric_limits<float>::infinity());
    const auto verticesATree = [&](double height) {
        EXPECT_TRUE(renderer.draw(p, {{60, height, 61}, {60, 0, 60}, 100, 0}, measured()));
        const PassStats* pass = passNamed(renderer, "forest/trees");
        return static_cast<double>(pass->vertices) / static_cast<double>(pass->instances);
    };
    const double near = verticesATree(16), far = verticesATree(150);
    EXPECT_LT(far, 0.6 * near) << "bark stays as it is";
}

TEST(ForestTrees, KeepTheirLeavesAsFarAsMeshDetailSays) {
    NoGlErrors errors;
    Renderer renderer(gpu(), tables());
    Project p = wood(std::numeric_limits<float>::infinity());
    const auto vertices = [&](float detail) {
        p.registry.get<Forest>(findEntity(p, "trees"))->meshDetail = detail;
        EXPECT_TRUE(renderer.draw(p, kAbove, measured()));
        return passNamed(renderer, "forest/trees")->vertices;
    };
    const auto all = vertices(1e6f), usual = vertices(1), least = vertices(0.05f);
    EXPECT_GT(all, 2 * usual);
    EXPECT_GE(usual, least);
}

}  // namespace
}  // namespace sward::test
