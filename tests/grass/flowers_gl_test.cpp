// Flowers: how many are drawn, that they cover what the ray-traced truth says, and that nothing sound or unsound breaks
// them.
#include "core/numerics.h"
#include "fields.h"
#include "frame/flower_image.h"
#include "maps/map_io.h"
#include "objects.h"
#include "reference/reference.h"
#include "scene/antialias.h"
#include "techniques.h"
#include "world/view_camera.h"

namespace sward::test {
namespace {

constexpr int kBedWidth = 120, kBedHeight = 90;

// Black ground under red flowers with red stems, so that red is what they cover.
Project bed() {
    Project p;
    Terrain t;
    t.size = {12, 12};
    t.groundColor = {0, 0, 0};
    put(p, "ground", t);
    put<Flowers>(p, "bed",
                 {.flowersPerM2 = 20,
                  .headSize = 0.12f,
                  .color = {0.9f, 0, 0},
                  .secondColor = {0.9f, 0, 0},
                  .centerColor = {0.9f, 0, 0},
                  .stemColor = {0.9f, 0, 0}});
    put<Sky>(p, "sky", {.model = SkyModel::Uniform});
    return p;
}
Flowers& flowersIn(Project& p) { return *p.registry.get<Flowers>(findEntity(p, "bed")); }
ViewCamera over() { return {{6, 2.2, 1}, {6, 0, 5}, 50, 0}; }
ViewSettings settings() {
    ViewSettings s;
    s.width = kBedWidth, s.height = kBedHeight;
    return s;
}
std::vector<float> drawn(Project& p, const ViewCamera& c = over()) {
    Renderer r(gpu(), tables());
    const Status done = r.draw(p, c, settings());
    EXPECT_TRUE(done) << (done ? "" : done.error().text());
    return r.readLinear();
}
double meanRed(const std::vector<float>& image) {
    double sum = 0;
    for (size_t i = 0; i < image.size(); i += 3) sum += static_cast<double>(image[i]);
    return sum / (static_cast<double>(image.size()) / 3);
}

std::vector<float> traced(const Project& p, const ViewCamera& c) {
    JobControl control;
    auto scene = ReferenceScene::make(p, tables(), 0, control);
    EXPECT_TRUE(scene);
    ReferenceSettings s;
    s.width = kBedWidth, s.height = kBedHeight, s.samples = 32, s.lighting = ReferenceLighting::Direct;
    return scene->trace(c, s, control)->color;
}

TEST(Flowers, CoverAsMuchAsInTheRayTracedTruth) {
    NoGlErrors errors;
    Project p = bed();
    flowersIn(p).maxDistance = 1000;  // none left out
    put<Wind>(p, "wind");
    const std::vector<float> picture = drawn(p), truth = traced(p, over());
    EXPECT_GT(meanRed(truth), 0.02);
    EXPECT_NEAR(meanRed(picture) / meanRed(truth), 1, 0.06);
    // And at the same places: of blocks of 10 x 10 pixels.
    for (int by = 0; by + 30 <= kBedHeight; by += 30)
        for (int bx = 0; bx + 30 <= kBedWidth; bx += 30) {
            double a = 0, b = 0;
            for (int y = by; y < by + 30; ++y)
                for (int x = bx; x < bx + 30; ++x) {
                    const size_t i = 3 * (static_cast<size_t>(y) * kBedWidth + static_cast<size_t>(x));
                    a += static_cast<double>(picture[i]), b += static_cast<double>(truth[i]);
                }
            EXPECT_NEAR(a / 900, b / 900, 0.03 + 0.15 * b / 900) << bx << " " << by;
        }
}

// Where a head is a quarter of a pixel, a sixteenth of the flowers stands for all; and stems, of which only the middle
// of their image is anything, do not turn into boards.
TEST(Flowers, CoverAsMuchFarAway) {
    NoGlErrors errors;
    const ViewCamera far{{6, 22, -40}, {6, 0, 5}, 10, 0};
    for (const bool stems : {false, true}) {
        Project p = bed();
        Flowers& f = flowersIn(p);
        f.maxDistance = 1000, f.headSize = 0.035f, f.flowersPerM2 = 60;
        if (!stems) f.stemColor = {0, 0, 0};
        put<Antialias>(p, "antialias", {.antialias = Antialiasing::Temporal});
        Renderer r(gpu(), tables());
        for (int frame = 0; frame < 64; ++frame) ASSERT_TRUE(r.draw(p, far, settings()));
        const double picture = meanRed(r.readLinear()), truth = meanRed(traced(p, far));
        EXPECT_GT(truth, 0.002);
        EXPECT_NEAR(picture / truth, 1, 0.1) << (stems ? "with stems" : "heads");
        std::printf("far flowers %s: %.3f of the truth\n", stems ? "with stems" : "heads", picture / truth);
    }
}

TEST(Flowers, GrowWhereTheMapSays) {
    NoGlErrors errors;
    Project p = bed();
    const auto red = [&] { return meanRed(drawn(p)); };
    const auto with = [&](const MapField& density, float tiling) {
        flowersIn(p).density = density;
        flowersIn(p).densityTiling = tiling;
        return red();
    };
    const MapInfo info{64, 64, 1, PixelType::U16};
    const double all = red(), none = with(field(filled(info, 0)), 1);
    Project bare = bed();
    removeEntity(bare, "bed");
    EXPECT_EQ(none, meanRed(drawn(bare)));
    const double half = with(field(filled(info, 0.5f)), 1);
    EXPECT_NEAR((half - none) / (all - none), 0.55, 0.12);  // they hide each other less
    Map stripes(info);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) stripes.set(x, y, 0, y < 32 ? 1.0f : 0.0f);
    EXPECT_LT(with(field(stripes), 1), all);                                  // the far half is bare
    EXPECT_NEAR((with(field(stripes), 16) - none) / (half - none), 1, 0.15);  // stripes of 0.4 m
}

// A painted press lays down the flowers of the entity whose field it is painted for, drawn and traced; another field's
// does not.
TEST(Flowers, StandAmongTheGrassOfTheirOwnEntity) {
    NoGlErrors errors;
    Map press({4, 4, 4, PixelType::U8});
    for (int i = 0; i < 16; ++i) press.set(i % 4, i / 4, 2, 1), press.set(i % 4, i / 4, 3, 1);
    enum class Pressed { None, First, Own };
    const auto scene = [&](Pressed which) {
        Project p = bed();
        FlatField grass;
        grass.technique = nameOf(Technique::Geometry);
        grass.species[0].bladesPerM2 = 4;
        grass.drawing.bakeLight = BakeLight::Local;  // it is black
        grass.species[0].rootColor = grass.species[0].midColor = grass.species[0].tipColor = {0, 0, 0};
        if (which == Pressed::First) grass.forces = field(press, "maps/press.png");
        put(p, "among", grass);
        grass.forces = {};
        if (which == Pressed::Own) grass.forces = field(press, "maps/press.png");
        put(p, "bed", grass);
        return p;
    };
    const auto drawnRed = [&](Pressed which) {
        Project p = scene(which);
        return meanRed(drawn(p));
    };
    const auto tracedRed = [&](Pressed which) {
        JobControl control;
        auto of = ReferenceScene::make(scene(which), tables(), 0, control);
        EXPECT_TRUE(of);
        ReferenceSettings s;
        s.width = kBedWidth, s.height = kBedHeight, s.samples = 8, s.lighting = ReferenceLighting::Direct;
        return meanRed(of->trace(over(), s, control)->color);
    };
    const double standing = drawnRed(Pressed::None), stands = tracedRed(Pressed::None);
    EXPECT_NEAR(drawnRed(Pressed::First) / standing, 1, 0.02);
    EXPECT_NEAR(tracedRed(Pressed::First) / stands, 1, 0.02);
    EXPECT_GT(std::abs(drawnRed(Pressed::Own) / standing - 1), 0.1);
    EXPECT_GT(std::abs(tracedRed(Pressed::Own) / stands - 1), 0.1);
}

TEST(Flowers, ThinOutWithoutPopping) {
    NoGlErrors errors;
    Project p = bed();
    flowersIn(p).maxDistance = 7;
    double last = -1, worst = 0, mean = 0;
    for (int i = 0; i <= 20; ++i) {  // the eye backs away by a centimetre a picture
        ViewCamera c = over();
        c.eye.z -= 0.01 * i, c.target.z -= 0.01 * i;
        const double now = meanRed(drawn(p, c));
        if (last >= 0) worst = std::max(worst, std::abs(now - last));
        last = now, mean += now / 21;
    }
    EXPECT_LT(worst, 0.04 * mean);
}

TEST(Flowers, NoValueOfAnyFieldBreaksThePicture) {
    NoGlErrors errors;
    Project p = bed();
    Flowers& f = flowersIn(p);
    const auto sound = [&](const char* what) {
        for (const float v : drawn(p)) ASSERT_TRUE(std::isfinite(v) && v >= 0) << what;
    };
    f.height = 0, sound("no height");
    f.height = 20, f.heightVariation = 1, sound("tall");
    f.headSize = 5, sound("huge");
    f.flowersPerM2 = 1000, f.headSize = 0.01f, f.height = 0.1f, f.maxDistance = 3, sound("dense");
    f.flowersPerM2 = 1e-6f, sound("hardly any");
    f.maxDistance = 0.1f, sound("only here");
    f.texture = "nowhere.png", sound("an image that is not there");
    f.seed = 2147483647, sound("the last seed");
    f.flowersPerM2 = std::numeric_limits<float>::quiet_NaN(), sound("not a number");
    f.flowersPerM2 = 0, sound("none");
}

TEST(Flowers, AnImageOfOnesOwnIsShownHeadUp) {
    NoGlErrors errors;
    const TempDir folder;
    std::vector<uint8_t> pixels;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 8; ++x)
            pixels.insert(pixels.end(),
                          {static_cast<uint8_t>(y < 8 ? 255 : 0), 0, static_cast<uint8_t>(y < 8 ? 0 : 255), 255});
    ASSERT_TRUE(writeImagePng(folder / "two.png", 8, 16, 4, pixels));
    Project p = bed();
    p.dir = folder.path;
    flowersIn(p).texture = "two.png";
    flowersIn(p).color = flowersIn(p).secondColor = {1, 1, 1};
    const FlowerImage image = flowerImage(p, flowersIn(p));
    EXPECT_FALSE(image.made);
    EXPECT_EQ(image.headShare, 0.5f);
    const std::vector<float> picture = drawn(p);
    double red = 0, blue = 0;
    for (size_t i = 0; i < picture.size(); i += 3)
        red += static_cast<double>(picture[i]), blue += static_cast<double>(picture[i + 2]);
    EXPECT_GT(red, 0);
    EXPECT_GT(blue, 0);
}

TEST(Flowers, TheMadeImageHasAHeadAStemAndNothingAtItsSides) {
    const Rgba8 i = makeFlowerImage(64, 160);
    const auto alpha = [&](int x, int y) {
        return static_cast<int>(i.pixels[(static_cast<size_t>(y) * 64 + static_cast<size_t>(x)) * 4 + 3]);
    };
    EXPECT_EQ(alpha(32, 32), 255);
    EXPECT_EQ(alpha(0, 0), 0);
    EXPECT_EQ(alpha(63, 90), 0);
    EXPECT_EQ(alpha(32, 150), 255);
    double head = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) head += alpha(x, y) / 255.0;
    EXPECT_GT(head / 4096, 0.4);
    EXPECT_LT(head / 4096, 0.75);
}

}  // namespace
}  // namespace sward::test
