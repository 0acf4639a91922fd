// Light from all around objects as it is drawn: against the ray-traced truth and against light as on open ground, when
// it is traced anew, and beside the pictures.
#include "frame/object_light.h"

#include <thread>

#include "core/file.h"
#include "fields.h"
#include "objects.h"
#include "pixels.h"
#include "reference/reference.h"

namespace sward::test {
namespace {

ViewSettings seen(bool background = false) {
    ViewSettings s;
    s.width = 96, s.height = 72;
    s.background = background;
    return s;
}
std::vector<float> drawnBy(Renderer& r, const Project& p, const ViewCamera& c, const ViewSettings& s = seen()) {
    const Status drawn = r.draw(p, c, s);
    EXPECT_TRUE(drawn) << (drawn ? "" : drawn.error().text());
    return r.readLinear();
}
std::vector<float> truthOf(const Project& p, const ViewCamera& c) {
    JobControl control;
    const auto scene = ReferenceScene::make(p, tables(), 0, control);
    EXPECT_TRUE(scene) << scene.error().text();
    ReferenceSettings s;
    s.width = 96, s.height = 72, s.samples = 64;
    return scene->trace(c, s, control)->color;
}
// Mean of the picture's middle, 16 x 16 pixels.
glm::vec3 middleColour(const std::vector<float>& image) {
    glm::vec3 sum(0);
    for (size_t y = 28; y < 44; ++y)
        for (size_t x = 40; x < 56; ++x) {
            const float* at = &image[(y * 96 + x) * 3];
            sum += glm::vec3(at[0], at[1], at[2]) / 256.0f;
        }
    return sum;
}
// A grey ball in the air over light ground, the sun in the south.
Project ballOver(const TempDir& dir) {
    Project p = cubeScene(dir.path);
    removeEntity(p, "cube");
    Terrain& ground = *p.registry.get<Terrain>(findEntity(p, "ground"));
    ground.size = {200, 200};
    ground.groundColor = {0.5f, 0.4f, 0.3f};
    putObject(p, "ball", {{.kind = SolidKind::Ball, .size = {1, 1, 1}, .color = {0.3f, 0.3f, 0.3f}}}, {100, 2, 100});
    return p;
}
void setLocal(Project& p) {
    p.registry.each<StaticMesh>([](Entity, StaticMesh& m) { m.bakeLight = BakeLight::Local; });
}
size_t keptFiles() {
    size_t n = 0;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(cacheDir() / "objects", none))
        n += entry.is_regular_file();
    return n;
}
double worstShare(const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 off = glm::abs(a / b - 1.0f);
    return double(std::max(off.x, std::max(off.y, off.z)));
}

TEST(ObjectLightDrawn, ABallInTheAirIsAsBrightFromBelowAndBehindAsItsTruth) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = ballOver(dir), local = snapshot(p, tables().components);
    setLocal(local);
    Renderer r(gpu(), tables()), other(gpu(), tables());
    for (const ViewCamera& c : {ViewCamera{{100, 0.3, 97.5}, {100, 1.4, 100}, 30, 0},  // from below, behind
                                ViewCamera{{100, 2.4, 95}, {100, 2, 100}, 20, 0}}) {   // its side that is turned away
        const glm::vec3 truth = middleColour(truthOf(p, c)), drawn = middleColour(drawnBy(r, p, c)),
                        open = middleColour(drawnBy(other, local, c));
        std::printf("truth %.4f %.4f %.4f drawn %.4f %.4f %.4f as on open ground %.4f %.4f %.4f\n", truth.x, truth.y,
                    truth.z, drawn.x, drawn.y, drawn.z, open.x, open.y, open.z);
        EXPECT_LT(worstShare(drawn, truth), 0.1);
        EXPECT_GT(worstShare(open, truth), 0.3) << "what it stands against must lose";
    }
}

TEST(ObjectLightDrawn, ANarrowLaneBetweenWallsIsAsDarkAsItsTruth) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = ballOver(dir);
    std::vector<Solid> wall;
    for (int i = 0; i < 36; ++i)
        wall.push_back({.size = {1, 1, 1}, .at = {i / 3 - 5.5f, float(i % 3), 0}, .color = {0.3f, 0.3f, 0.3f}});
    putObject(p, "north", wall, {100, 0, 98.9});
    putObject(p, "south", wall, {100, 0, 101.1});
    removeEntity(p, "ball");
    Project local = snapshot(p, tables().components);
    setLocal(local);
    const ViewCamera along{{104, 1.5, 100.4}, {100, 1.3, 99.4}, 25, 0};
    Renderer r(gpu(), tables()), other(gpu(), tables());
    const glm::vec3 truth = middleColour(truthOf(p, along)), drawn = middleColour(drawnBy(r, p, along)),
                    open = middleColour(drawnBy(other, local, along));
    std::printf("truth %.4f drawn %.4f as on open ground %.4f\n", truth.y, drawn.y, open.y);
    EXPECT_LT(worstShare(drawn, truth), 0.15);
    EXPECT_GT(worstShare(open, truth), 0.5) << "what it stands against must lose";
}

// A block of 2 m, its shadow before it.
Project blockOn(const TempDir& dir) {
    Project p = ballOver(dir);
    removeEntity(p, "ball");
    putObject(p, "block", {{.size = {2, 2, 2}, .color = {0.3f, 0.3f, 0.3f}}}, {100, 0, 100});
    return p;
}
const ViewCamera kBesideBlock{{100, 2.5, 95}, {100, 0, 98.6}, 6, 0};

TEST(ObjectLightDrawn, TheGroundBesideAnObjectIsAsDarkAsItsTruth) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = blockOn(dir), local = snapshot(p, tables().components);
    setLocal(local);
    Renderer r(gpu(), tables()), other(gpu(), tables());
    for (const double off : {0.25, 0.7, 1.5}) {
        ViewCamera c = kBesideBlock;
        c.target.z = 99 - off;
        const glm::vec3 truth = middleColour(truthOf(p, c)), drawn = middleColour(drawnBy(r, p, c)),
                        open = middleColour(drawnBy(other, local, c));
        std::printf("%.2f m off: truth %.4f %.4f %.4f drawn %.4f %.4f %.4f as in the open %.4f %.4f %.4f\n", off,
                    truth.x, truth.y, truth.z, drawn.x, drawn.y, drawn.z, open.x, open.y, open.z);
        EXPECT_LT(worstShare(drawn, truth), 0.06);
        EXPECT_GT(worstShare(open, truth), 0.12) << "what it stands against must lose";
    }
}

// What grows beside an object loses the share of the sky's light that the ground loses, by every technique.
TEST(ObjectLightDrawn, GrassBesideAnObjectIsAsMuchDarkerByEveryTechnique) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = blockOn(dir);
    const auto shareOf = [&](Renderer& traced, Renderer& open) {
        Project local = snapshot(p, tables().components);
        setLocal(local);
        return middleColour(drawnBy(traced, p, kBesideBlock)).y / middleColour(drawnBy(open, local, kBesideBlock)).y;
    };
    Renderer r(gpu(), tables()), other(gpu(), tables());
    const float bare = shareOf(r, other);
    EXPECT_LT(bare, 0.85f);
    GrassField grass;
    grass.species[0].bladesPerM2 = 4000, grass.species[0].height = 0.08f;
    put(p, "grass", grass);
    FlatField field = flatField(p);
    field.sliceWidth = field.farSize = 128, field.sliceHeight = 32, field.slices = 8;
    for (const Technique t : {Technique::Geometry, Technique::Tessellated, Technique::Raytraced, Technique::Flat}) {
        field.technique = nameOf(t);
        const float share = shareOf(r, other);
        std::printf("%s: %.3f, bare ground %.3f\n", nameOf(t), double(share), double(bare));
        EXPECT_NEAR(share, bare, 0.06f) << nameOf(t);
    }
}

TEST(ObjectLightDrawn, FollowsTheLightsStrengthWithoutTracingAnewAndItsPlaceByTracing) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = ballOver(dir);
    const ViewCamera c{{100, 0.3, 97.5}, {100, 1.4, 100}, 30, 0};
    Renderer r(gpu(), tables());
    const glm::vec3 once = middleColour(drawnBy(r, p, c));
    const size_t files = keptFiles();
    EXPECT_GE(files, 1u);
    p.registry.get<Light>(findEntity(p, "sun"))->intensity *= 2;
    p.registry.get<Sky>(findEntity(p, "sky"))->intensity *= 2;
    EXPECT_LT(worstShare(middleColour(drawnBy(r, p, c)), 2.0f * once), 0.01);
    EXPECT_EQ(keptFiles(), files);
    // Onto the ground, and back: the picture is that of who never saw it elsewhere.
    const std::vector<float> before = drawnBy(r, p, c);
    p.registry.get<Transform>(findEntity(p, "ball"))->position.y = 1.2;
    const std::vector<float> low = drawnBy(r, p, c);
    Renderer fresh(gpu(), tables());
    EXPECT_EQ(low, drawnBy(fresh, p, c));
    EXPECT_GT(keptFiles(), files);
    p.registry.get<Transform>(findEntity(p, "ball"))->position.y = 2;
    EXPECT_EQ(drawnBy(r, p, c), before);
}

TEST(ObjectLightDrawn, IsTracedBesideThePicturesAndLeavesNothing) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = ballOver(dir), local = snapshot(p, tables().components);
    setLocal(local);
    p.registry.get<Light>(findEntity(p, "sun"))->azimuthDeg =
        local.registry.get<Light>(findEntity(local, "sun"))->azimuthDeg = 100;  // of no other test
    const ViewCamera c{{100, 0.3, 97.5}, {100, 1.4, 100}, 30, 0};
    Renderer r(gpu(), tables()), never(gpu(), tables());
    const std::vector<float> open = drawnBy(never, local, c);
    EXPECT_EQ(drawnBy(r, p, c, seen(true)), open) << "nothing is waited for";
    ASSERT_FALSE(r.jobs().empty());
    EXPECT_EQ(r.jobs()[0].label, "light around objects");
    for (int i = 0; i < 600 && !r.jobs().empty(); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        drawnBy(r, p, c, seen(true));
    }
    EXPECT_TRUE(r.jobs().empty());
    Renderer waiting(gpu(), tables());
    EXPECT_EQ(drawnBy(r, p, c, seen(true)), drawnBy(waiting, p, c));
    setLocal(p);
    EXPECT_EQ(drawnBy(r, p, c), open);
    EXPECT_EQ(drawnBy(waiting, p, c), open);
    EXPECT_FALSE(gpu().ledger.contains("objects/light"));
}

TEST(ObjectLightDrawn, AKeptFileThatIsDamagedIsMadeAnew) {
    NoGlErrors errors;
    const TempDir dir;
    Project p = ballOver(dir);
    p.registry.get<Light>(findEntity(p, "sun"))->azimuthDeg = 140;  // of no other test
    const ViewCamera c{{100, 0.3, 97.5}, {100, 1.4, 100}, 30, 0};
    std::set<std::filesystem::path> there;
    std::error_code none;
    for (const auto& e : std::filesystem::directory_iterator(cacheDir() / "objects", none)) there.insert(e.path());
    Renderer r(gpu(), tables());
    const std::vector<float> right = drawnBy(r, p, c);
    int damaged = 0;
    for (const auto& e : std::filesystem::directory_iterator(cacheDir() / "objects")) {
        if (there.contains(e.path())) continue;
        std::string bytes = readText(e.path());
        bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 0x55);
        writeText(e.path(), bytes);
        ++damaged;
    }
    if (there.empty()) EXPECT_EQ(damaged, 1);
    Renderer again(gpu(), tables());
    EXPECT_EQ(drawnBy(again, p, c), right);
}

}  // namespace
}  // namespace sward::test
