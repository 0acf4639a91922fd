// The tessellated field: the same blades as geometry's, by stages or strips; levels, thinning, extreme settings.
#include "bare_triangles.h"
#include "cost/frame_stats.h"
#include "fields.h"
#include "gl_counts.h"
#include "grass/comparison.h"
#include "project/project_files.h"
#include "scenes.h"
#include "techniques.h"
#include "world/view_camera.h"

namespace sward::test {
namespace {

FlatField grassOf(Project& p) { return flatField(p, "grass"); }

// A lawn whose soil is shaded alike under every technique; all blades, to beyond the ground's end.
Project lawnBy(Technique technique) {
    Project p = lawn();
    p.registry.get<Terrain>(findEntity(p, "ground"))->size = {10, 10};
    FlatField f = grassOf(p);
    f.technique = nameOf(technique);
    f.groundShadows = false;
    f.maxDistance = 200;
    f.thinning = 0;
    f.lowerFrom = 1;
    f.beyond = Beyond::Nothing;
    return p;
}
std::vector<uint8_t> pictureOf(Renderer& r, Project& p, const ViewCamera& c = eyeHeight(),
                               const ViewSettings& s = small()) {
    const Status drawn = r.draw(p, c, s);
    EXPECT_TRUE(drawn) << (drawn ? "" : drawn.error().text());
    return r.readImage();
}
// Share of pixels of which a channel differs by more than 8 of 255.
double differing(const std::vector<uint8_t>& a, const std::vector<uint8_t>& b) {
    size_t n = 0;
    for (size_t i = 0; i < a.size(); i += 3)
        n += std::abs(a[i] - b[i]) > 8 || std::abs(a[i + 1] - b[i + 1]) > 8 || std::abs(a[i + 2] - b[i + 2]) > 8;
    return 3.0 * static_cast<double>(n) / static_cast<double>(a.size());
}
double meanOf(const std::vector<uint8_t>& a) {
    double sum = 0;
    for (const uint8_t v : a) sum += v;
    return sum / static_cast<double>(a.size());
}
uint64_t verticesOf(Renderer& r, Project& p, const ViewCamera& c = eyeHeight()) {
    ViewSettings s = small();
    s.measure = true;
    EXPECT_TRUE(r.draw(p, c, s));
    for (const PassStats& pass : r.stats().passes)
        if (pass.name == "grass/tessellated") return pass.vertices;
    return 0;
}
Map waves(const MapInfo& info) {
    Map m(info);
    for (int y = 0; y < info.height; ++y)
        for (int x = 0; x < info.width; ++x)
            for (int c = 0; c < info.channels; ++c)
                m.set(x, y, c, 0.5f + 0.4f * std::sin(static_cast<float>(x + 2 * y + 3 * c) * 0.7f));
    return m;
}
// Every map that the population or its look follows.
void paint(Project& p) {
    FlatField f = grassOf(p);
    f.species[0].density = field(waves({32, 32, 1, PixelType::U16}));
    f.orientation = field(waves({16, 16, 2, PixelType::U16}));
    f.vegetation = field(waves({16, 16, 4, PixelType::U8}));
    f.ambientOcclusion = field(waves({16, 16, 1, PixelType::U8}));
    p.registry.get<Terrain>(findEntity(p, "ground"))->height = field(waves({16, 16, 1, PixelType::F32}));
    f.species[0].leanDeg = 30;
}

TEST(Tessellated, StripsAndStagesDrawTheSamePicture) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    for (const bool painted : {false, true})
        for (const LevelBy by : {LevelBy::Distance, LevelBy::Pixels}) {
            Project p = lawnBy(Technique::Tessellated);
            if (painted) paint(p);
            FlatField f = grassOf(p);
            f.levelBy = by;
            f.maxDistance = 20, f.thinning = 0.5f, f.lowerFrom = 0.7f;
            for (const int samples : {1, 4}) {
                ViewSettings view = small();
                view.msaa = samples;
                f.tessellation = Tessellation::Stages;
                const auto stages = pictureOf(r, p, eyeHeight(), view);
                f.tessellation = Tessellation::Strips;
                const double share = differing(pictureOf(r, p, eyeHeight(), view), stages);
                RecordProperty(fmt::format("{}-{}-{}", painted ? "painted" : "plain", kLevelsBy[f.levelBy], samples),
                               fmt::format("{:.5f}", share));
                EXPECT_LE(share, 0.001) << samples << " samples, " << (painted ? "painted, by " : "by ") << " "
                                        << kLevelsBy[f.levelBy];
            }
        }
}

TEST(Tessellated, TheBladesAreGeometrys) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    for (const bool painted : {false, true}) {
        Project geometry = lawnBy(Technique::Geometry), tessellated = lawnBy(Technique::Tessellated);
        if (painted) paint(geometry), paint(tessellated);
        const auto a = pictureOf(r, geometry);
        for (const Tessellation way : {Tessellation::Stages, Tessellation::Strips}) {
            grassOf(tessellated).tessellation = way;
            const auto b = pictureOf(r, tessellated);
            EXPECT_NEAR(meanOf(a), meanOf(b), 0.01 * meanOf(a)) << painted;
            const std::vector<bool> all(a.size() / 3, true);
            EXPECT_LT(blockDistance(blocksOf(a, 160, all), blocksOf(b, 160, all)), 0.01) << painted;
        }
    }
}

TEST(Tessellated, BladesAreAsFineAsTheirDistanceAsks) {
    Renderer r(gpu(), tables());
    Project p = lawnBy(Technique::Tessellated);
    FlatField f = grassOf(p);
    f.tessellation = Tessellation::Strips;
    f.maxDistance = 1e5f;                    // so that all are near
    f.species[0].width = 0.2f;               // and none is plain
    f.drawing.bakeLight = BakeLight::Local;  // vertices are counted, no light is seen
    uint64_t one = 0;
    for (const int level : {1, 3, 5}) {
        f.species[0].smoothness = level;
        const uint64_t vertices = verticesOf(r, p);
        if (level == 1) one = vertices;
        const double rows = static_cast<double>(one) / 2 * (level + 1);
        EXPECT_GE(static_cast<double>(vertices), rows) << "level " << level;
        EXPECT_LT(static_cast<double>(vertices), 1.06 * rows) << "level " << level << ": a driver shades a few twice";
    }
    EXPECT_GT(one, 5000u);
    f.species[0].smoothness = 3;
    f.maxDistance = 14;
    const uint64_t falling = verticesOf(r, p);
    EXPECT_LT(falling, one * 2);
    EXPECT_GT(falling, one);
    f.species[0].smoothness = 64;
    EXPECT_GT(verticesOf(r, p), 4 * falling);
    pictureOf(r, p);
}

TEST(Tessellated, BeyondTheGreatestDistanceNoBladeIsDrawn) {
    Renderer r(gpu(), tables());
    Project p = lawnBy(Technique::Tessellated), bare = lawnBy(Technique::Tessellated);
    grassOf(bare).species[0].density = field(filled({4, 4, 1, PixelType::U16}, 0));
    grassOf(p).species[0].density = field(filled({4, 4, 1, PixelType::U16}, 1));
    ViewSettings tiers = small();
    tiers.mode = ViewMode::Tiers;
    const ViewCamera high{{5, 9, 5}, {5, 0, 5.01}, 55, 0};
    for (const Tessellation way : {Tessellation::Stages, Tessellation::Strips}) {
        grassOf(p).tessellation = way;
        grassOf(p).maxDistance = 8.5f;
        EXPECT_EQ(pictureOf(r, p, high, tiers), pictureOf(r, bare, high, tiers));
        grassOf(p).maxDistance = 50;
        EXPECT_GT(differing(pictureOf(r, p, high, tiers), pictureOf(r, bare, high, tiers)), 0.05);
    }
}

TEST(Tessellated, ThinnedBladesCoverAsMuchByTheirWidth) {
    Renderer r(gpu(), tables());
    Project p = lawnBy(Technique::Tessellated);
    FlatField f = grassOf(p);
    f.species[0].clumpSize = 0;
    f.fade = 0;
    f.maxDistance = 30;
    ViewSettings overdraw = small();
    overdraw.mode = ViewMode::Overdraw;
    overdraw.measure = true;
    const ViewCamera c{{5, 9, 5}, {5, 0, 6}, 55, 0};  // all at about a third of the distance
    const auto covers = [&](float thinning, bool widening) {
        f.thinning = thinning, f.widening = widening;
        return meanOf(pictureOf(r, p, c, overdraw));
    };
    f.species[0].bladesPerM2 = 0;
    const double bare = covers(0, true);
    f.species[0].bladesPerM2 = 200;
    const double none = covers(0, true);
    const uint64_t all = r.stats().bladesGeometry;
    EXPECT_NEAR(covers(0.9f, true) - bare, none - bare, 0.15 * (none - bare));
    EXPECT_LT(covers(0.9f, false) - bare, 0.9 * (none - bare));
    EXPECT_LT(r.stats().bladesGeometry, all);
}

// Cook, Halstead, Planck and Ryu 2007: where blades are thinner than a share of a pixel.
TEST(Tessellated, BladesOfAtLeastSomePixelsAreFewerAndCoverAsMuch) {
    Renderer r(gpu(), tables());
    Project p = lawnBy(Technique::Tessellated);
    FlatField f = grassOf(p);
    f.species[0].clumpSize = 0;
    f.fade = 0;
    ViewSettings overdraw = small();
    overdraw.mode = ViewMode::Overdraw;
    overdraw.measure = true;
    const ViewCamera c{{5, 12, -22}, {5, 0, 5}, 22, 0};
    const auto covers = [&](float leastPixels) {
        f.leastPixels = leastPixels;
        return meanOf(pictureOf(r, p, c, overdraw));
    };
    f.species[0].bladesPerM2 = 0;
    const double bare = covers(0);
    f.species[0].bladesPerM2 = 4000;
    const double all = covers(0) - bare;
    const uint64_t blades = r.stats().bladesGeometry;
    for (const bool stages : {true, false}) {
        f.tessellation = stages ? Tessellation::Stages : Tessellation::Strips;
        EXPECT_NEAR(covers(1) - bare, all, 0.1 * all);
        EXPECT_LT(2 * r.stats().bladesGeometry, blades);
        f.widening = false;
        EXPECT_LT(covers(1) - bare, 0.6 * all);  // what they lack is seen
        f.widening = true;
    }
    covers(1e-6f);
    EXPECT_EQ(r.stats().bladesGeometry, blades);
}

TEST(Tessellated, EveryViewShowsBlades) {
    Renderer r(gpu(), tables());
    for (const Tessellation way : {Tessellation::Stages, Tessellation::Strips})
        for (const ViewMode mode : {ViewMode::Tiers, ViewMode::Overdraw, ViewMode::Normals, ViewMode::Density}) {
            Project p = lawnBy(Technique::Tessellated), bare = lawnBy(Technique::Tessellated);
            grassOf(p).tessellation = way;
            grassOf(bare).maxDistance = 0.1f;
            // Blended blades lie over the ground; others hide it, so that a pixel counts one of both.
            if (mode == ViewMode::Overdraw) grassOf(p).transparency = grassOf(bare).transparency = Transparency::Blend;
            ViewSettings s = small();
            s.mode = mode;
            EXPECT_GT(differing(pictureOf(r, p, eyeHeight(), s), pictureOf(r, bare, eyeHeight(), s)), 0.05)
                << kViewModes[mode];
        }
}

TEST(Tessellated, IsFiniteForBladesOfNoSizeAndExtremeSettings) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    const std::function<void(const FlatField&)> extremes[] = {
        [](const FlatField& f) { f.species[0].height = 0; },
        [](const FlatField& f) { f.species[0].width = 0; },
        [](const FlatField& f) {
            f.species[0].bend = 2, f.species[0].leanDeg = 90, f.species[0].leanVariationDeg = 90;
        },
        [](const FlatField& f) { f.thinning = 1, f.lowerFrom = 0; },
        [](const FlatField& f) { f.leastPixels = 1; },
        [](const FlatField& f) { f.leastPixels = 1, f.species[0].width = 0; },
        [](const FlatField& f) { f.maxDistance = 0.1f; },
        [](const FlatField& f) { f.maxDistance = 1e6f, f.species[0].smoothness = 64, f.species[0].bladesPerM2 = 20; },
        [](const FlatField& f) {
            f.levelBy = LevelBy::Pixels, f.pixelsPerQuad = 0.5f, f.species[0].smoothness = 16,
            f.species[0].bladesPerM2 = 20;
        },
    };
    for (const auto& extreme : extremes)
        for (const Tessellation way : {Tessellation::Stages, Tessellation::Strips}) {
            Project p = lawnBy(Technique::Tessellated);
            grassOf(p).tessellation = way;
            extreme(grassOf(p));
            ASSERT_TRUE(r.draw(p, {{5, 0.1, 5}, {5, 0.05, 7}, 55, 0}, small()));  // among the blades
            for (const float v : r.readLinear()) ASSERT_TRUE(std::isfinite(v) && v >= 0) << &extreme - extremes;
        }
}

TEST(Tessellated, AFieldsSizeCostsNothing) {
    Renderer r(gpu(), tables());
    uint64_t vertices[2], blades[2];
    int64_t bytes[2];
    for (int i = 0; i < 2; ++i) {
        const double side = i == 0 ? 2000 : 90000;
        Project p = lawnBy(Technique::Tessellated);
        p.registry.get<Terrain>(findEntity(p, "ground"))->size = {side, side};
        grassOf(p).maxDistance = 15;
        grassOf(p).species[0].bladesPerM2 = 40;
        vertices[i] = verticesOf(r, p, {{900, 1.7, 900}, {910, 0, 910}, 55, 0});
        blades[i] = r.stats().bladesGeometry;
        bytes[i] = gpu().ledger["grass/tessellated"];
    }
    EXPECT_EQ(vertices[0], vertices[1]);
    EXPECT_EQ(blades[0], blades[1]);
    EXPECT_EQ(bytes[0], bytes[1]);
    EXPECT_GT(blades[0], 1000u);
}

TEST(Tessellated, IsTheSameNinetyThousandUnitsFromTheOrigin) {
    Renderer r(gpu(), tables());
    Project p = lawnBy(Technique::Tessellated);
    const auto here = pictureOf(r, p);
    const glm::dvec3 away{90000, 0, -90000};
    put(p, "ground", Transform{away});
    ViewCamera c = eyeHeight();
    c.eye += away, c.target += away;
    const auto there = pictureOf(r, p, c);
    int worst = 0;
    for (size_t i = 0; i < here.size(); ++i) worst = std::max(worst, std::abs(here[i] - there[i]));
    EXPECT_LE(worst, 1);
}

// Of 416,025 blades that are thinner than a pixel most meet no sample, and half meet one's row and column only. Half as
// many again may be submitted as meet one: a rasteriser may move corners by a 64th of a pixel.
TEST(Tessellated, OnlyTrianglesThatMeetASampleAreSubmitted) {
    NoGlErrors errors;
    auto p = loadProject(std::filesystem::path(SWARD_SOURCE_DIR) / "tests/scenes/plain", tables().components);
    ASSERT_TRUE(p) << p.error().text();
    // What auto takes on a software renderer.
    p->registry.get<TessellatedBlades>(findEntity(*p, "grass"))->tessellation = Tessellation::Strips;
    const ViewCamera eye = viewOf(*findCamera(*p, "eye"));
    const ViewSettings s = sized(640, 480, 1);
    Renderer r(gpu(), tables());
    const auto submitted = [&] {
        EXPECT_TRUE(r.draw(*p, eye, s));  // compiles
        return counted(GL_CLIPPING_INPUT_PRIMITIVES_ARB, [&] { EXPECT_TRUE(r.draw(*p, eye, s)); });
    };
    const BareTriangles bare = bareTriangles(*p, eye, {s.width, s.height}, 0);
    const uint64_t all = submitted();
    EXPECT_EQ(bare.blades, 416025u);
    EXPECT_GT(r.stats().bladesGeometry, 390000u);
    removeEntity(*p, "grass");
    const uint64_t blades = all - submitted();
    std::printf("%zu triangles, the boxes of %zu meet a sample, %zu do so themselves; submitted: %zu\n",
                bare.of[kAll].size(), bare.of[kBoxes].size(), bare.of[kExact].size(), size_t{blades});
    EXPECT_GE(static_cast<double>(blades), 0.97 * static_cast<double>(bare.of[kExact].size()));
    EXPECT_LE(static_cast<double>(blades), 1.5 * static_cast<double>(bare.of[kExact].size()));
}

// Bare ground lies beyond the last blade as published; else the horizontal slice takes over while blades get lower.
TEST(Tessellated, GrassGoesOnBeyondTheLastBlade) {
    Renderer r(gpu(), tables());
    const auto greenFar = [&](Beyond beyond) {
        Project p = lawnBy(Technique::Tessellated);
        p.registry.get<Terrain>(findEntity(p, "ground"))->size = {200, 200};
        FlatField f = grassOf(p);
        f.maxDistance = 6, f.lowerFrom = 0.7f, f.beyond = beyond;
        f.species[0].bladesPerM2 = 1000;
        f.sliceWidth = f.sliceHeight = f.farSize = 32;
        const ViewCamera away{{100, 1.7, 100}, {130, 0, 130}, 40};
        const auto picture = pictureOf(r, p, away);
        double green = 0;
        int n = 0;
        const ViewSettings s = small();
        for (int y = s.height / 2; y < s.height * 2 / 3; ++y)  // below the horizon, beyond the last blade
            for (int x = 0; x < s.width; ++x, ++n) {
                const uint8_t* c = &picture[3 * static_cast<size_t>(y * s.width + x)];
                green += c[1] - c[0];
            }
        return green / n;
    };
    const double bare = greenFar(Beyond::Nothing), grown = greenFar(Beyond::Slice);
    EXPECT_LT(bare, 2) << "soil is not green";
    EXPECT_GT(grown, bare + 5);
}

}  // namespace
}  // namespace sward::test
