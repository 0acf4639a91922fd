// Maps that repeat and blades of painted height, as pictures: each held against the same scene said in another way.
#include <gtest/gtest.h>

#include "fields.h"
#include "grass/cells.h"
#include "grass/comparison.h"
#include "scenes.h"
#include "techniques.h"
#include "world/ground.h"

namespace sward {
namespace {

using namespace test;

Terrain& groundIn(Project& p) { return *p.registry.get<Terrain>(findEntity(p, "ground")); }

Map patches(int side, PixelType type) {
    Map m({side, side, 1, type});
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) m.set(x, y, 0, (x / 5 + y / 7) % 2 ? 0.95f : 0.15f);
    return m;
}
Map laidOut(const Map& m, int n, bool mirrored) {
    const MapInfo& info = m.info();
    Map out({info.width * n, info.height * n, info.channels, info.type});
    const auto inside = [&](int i, int side) { return mirrored && (i / side) % 2 ? side - 1 - i % side : i % side; };
    for (int y = 0; y < info.height * n; ++y)
        for (int x = 0; x < info.width * n; ++x)
            for (int c = 0; c < info.channels; ++c)
                out.set(x, y, c, m.at(inside(x, info.width), inside(y, info.height), c));
    return out;
}

Project fieldOf(Technique technique) {
    Project p = lawn();
    FlatField f = grassIn(p);
    f.technique = nameOf(technique);
    f.minGeom = 3, f.maxGeom = 5, f.minBTF = 7, f.maxBTF = 9;
    f.slices = 5, f.sliceWidth = 64, f.sliceHeight = 32, f.farSize = 64;
    return p;
}
std::vector<uint8_t> drawn(Project& p) {
    ViewSettings s;
    s.width = 160, s.height = 100, s.msaa = 4;
    Renderer renderer(gpu(), tables());
    const Status done = renderer.draw(p, {{3, 1.7, 3}, {11, 0, 10}, 55, 0}, s);
    EXPECT_TRUE(done) << done.error().text();
    return renderer.readImage();
}
// Mean difference by channel, of 255.
double differs(const std::vector<uint8_t>& a, const std::vector<uint8_t>& b) {
    double sum = 0;
    for (size_t i = 0; i < a.size(); ++i) sum += std::abs(int(a[i]) - int(b[i]));
    return a.size() == b.size() ? sum / static_cast<double>(a.size()) : 255;
}
constexpr Technique kAll[] = {Technique::Hybrid, Technique::Geometry, Technique::Slices, Technique::Flat,
                              Technique::Tessellated};

// The same maps, repeated by their tiling or texel by texel; edges of the terrain are out of the picture.
TEST(MapTiling, ARepeatedMapIsThePictureOfTheMapLaidOut) {
    const NoGlErrors noErrors;
    const Map density = patches(20, PixelType::U16), share = patches(24, PixelType::U8);
    Map hills({16, 16, 1, PixelType::F32}), soil({16, 16, 4, PixelType::U8});
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
            hills.set(x, y, 0, 0.02f * static_cast<float>(x + y));
            for (int c = 0; c < 4; ++c) soil.set(x, y, c, static_cast<float>((x * (c + 2) + y) % 16) / 15);
        }
    for (const Technique technique : kAll) {
        Project once = fieldOf(technique), tiled = fieldOf(technique), plain = fieldOf(technique);
        for (Project* p : {&once, &tiled, &plain}) {
            const bool repeats = p == &tiled;
            const int n = repeats || p == &plain ? 1 : 4;
            Terrain& t = groundIn(*p);
            FlatField f = grassIn(*p);
            t.height = field(laidOut(hills, n, true), "maps/h.exr");
            t.terrainMap = field(laidOut(soil, n, false), "maps/s.png");
            f.species[0].density = field(laidOut(density, n, false), "maps/d.png");
            f.bladeHeight = field(laidOut(share, n, false), "maps/b.png");
            if (repeats) t.heightTiling = t.terrainMapTiling = f.species[0].densityTiling = f.bladeHeightTiling = 4;
        }
        const auto want = drawn(once), got = drawn(tiled), wrong = drawn(plain);
        EXPECT_LT(differs(want, got), 0.35) << "technique " << nameOf(technique);
        EXPECT_GT(differs(want, wrong), 2) << "the maps show";
    }
}

TEST(MapTiling, MapSizeIsATilingOfTheSameLength) {
    Project a = fieldOf(Technique::Hybrid), b = fieldOf(Technique::Hybrid);
    for (Project* p : {&a, &b}) {
        grassIn(*p).species[0].density = field(patches(20, PixelType::U16), "maps/d.png");
        grassIn(*p).species[0].densityTiling = p == &a ? 4 : 1;
        groundIn(*p).mapSize = p == &a ? 0 : 5;
    }
    EXPECT_LT(differs(drawn(a), drawn(b)), 0.05);
}

TEST(MapTiling, AFieldTwentyTimesAsLargeIsTheSamePictureWhereTheSameIsSeen) {
    Project a = fieldOf(Technique::Tessellated), b = fieldOf(Technique::Tessellated);
    for (Project* p : {&a, &b}) {
        grassIn(*p).species[0].density = field(patches(20, PixelType::U16), "maps/d.png");
        groundIn(*p).mapSize = 5;
        groundIn(*p).size = p == &a ? glm::dvec2(200) : glm::dvec2(4000);
        p->registry.get<Fog>(findEntity(*p, "haze"))->visibility = 60;  // what lies beyond both
    }
    EXPECT_LT(differs(drawn(a), drawn(b)), 0.5);
}

TEST(BladeHeight, BladesOfNoHeightLeaveThePictureOfBareGround) {
    const NoGlErrors noErrors;
    for (const Technique technique : kAll) {
        Project flat = fieldOf(technique), bare = fieldOf(technique), grown = fieldOf(technique);
        grassIn(flat).bladeHeight = field(filled({4, 4, 1, PixelType::U8}, 0), "maps/b.png");
        grassIn(bare).species[0].density = field(filled({4, 4, 1, PixelType::U16}, 0), "maps/d.png");
        const auto ground = drawn(bare);
        EXPECT_LT(differs(drawn(flat), ground), 0.05) << "technique " << nameOf(technique);
        EXPECT_GT(differs(drawn(grown), ground), 2);
    }
}

TEST(BladeHeight, AFullMapChangesNothing) {
    for (const Technique technique : kAll) {
        Project full = fieldOf(technique), none = fieldOf(technique);
        grassIn(full).bladeHeight = field(filled({4, 4, 1, PixelType::U8}, 1), "maps/b.png");
        EXPECT_LT(differs(drawn(full), drawn(none)), 0.02) << "technique " << nameOf(technique);
    }
}

// Half of the height by the map is the picture of a species half as high, where that is drawn blade by blade.
TEST(BladeHeight, HalfTheHeightIsASpeciesOfHalfTheHeight) {
    for (const Technique technique : {Technique::Geometry, Technique::Tessellated}) {
        Project mapped = fieldOf(technique), low = fieldOf(technique), high = fieldOf(technique);
        for (Project* p : {&mapped, &low, &high})
            grassIn(*p).beyond = Beyond::Nothing, grassIn(*p).shadowMask = 0, grassIn(*p).groundShadows = false;
        grassIn(mapped).bladeHeight = field(filled({4, 4, 1, PixelType::F32}, 0.5f), "maps/b.exr");
        grassIn(low).species[0].height *= 0.5f;
        const auto want = drawn(low);
        EXPECT_LT(differs(drawn(mapped), want), 1.0) << "technique " << nameOf(technique);
        EXPECT_GT(differs(drawn(high), want), 2.0);
    }
}

double meanOf(const std::vector<uint8_t>& a) {
    double sum = 0;
    for (const uint8_t v : a) sum += v;
    return sum / static_cast<double>(a.size());
}

// Other blades of the same kind: not the same picture, but as bright, and as many blades.
TEST(UniqueBlades, AreDrawnByGeometryAndTessellatedInsteadOfThePatch) {
    const NoGlErrors noErrors;
    for (const Technique technique : {Technique::Geometry, Technique::Tessellated, Technique::Hybrid}) {
        Project patch = fieldOf(technique), unique = fieldOf(technique);
        for (Project* p : {&patch, &unique}) {
            grassIn(*p).species[0].density = field(patches(20, PixelType::U16), "maps/d.png");
            grassIn(*p).fade = 0;
        }
        grassIn(unique).population = Population::Unique;
        const auto a = drawn(patch), b = drawn(unique);
        EXPECT_GT(differs(a, b), 1) << "technique " << nameOf(technique);
        EXPECT_NEAR(meanOf(a), meanOf(b), 1.5) << "technique " << nameOf(technique);
    }
}

TEST(UniqueBlades, RangesForAGpuAndListsForASoftwareRendererAreOnePicture) {
    const NoGlErrors noErrors;
    Project p = fieldOf(Technique::Geometry);
    grassIn(p).population = Population::Unique;
    grassIn(p).species[0].density = field(patches(20, PixelType::U16), "maps/d.png");
    const auto lists = drawn(p);
    const bool software = gpu().software;
    gpu().software = false;
    const auto ranges = drawn(p);
    gpu().software = software;
    EXPECT_EQ(differs(lists, ranges), 0);
}

TEST(UniqueBlades, FollowThePaintedDensityAndGoWithTheirPopulation) {
    Project p = fieldOf(Technique::Geometry);
    FlatField f = grassIn(p);
    f.population = Population::Unique;
    f.species[0].density = field(filled({40, 40, 1, PixelType::U16}, 1), "maps/d.png");
    Renderer renderer(gpu(), tables());
    const auto picture = [&] {
        EXPECT_TRUE(renderer.draw(p, eyeHeight(), small()));
        return renderer.readImage();
    };
    const auto full = picture();
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) f.species[0].density.map.set(x, y, 0, 0);
    const auto bare = picture();
    EXPECT_GT(differs(full, bare), 1);
    EXPECT_EQ(renderer.stats().bladesGeometry, 0u);
    f.population = Population::Patch;
    EXPECT_LT(differs(picture(), bare), 0.02);
}

TEST(UniqueBlades, BeyondMemoryNothingIsDrawnAndTheErrorSaysWhy) {
    Project p = fieldOf(Technique::Geometry);
    grassIn(p).population = Population::Unique;
    groundIn(p).size = {5000, 5000};
    Renderer renderer(gpu(), tables());
    const Status refused = renderer.draw(p, eyeHeight(), small());
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ExitCode::Unsound);
    groundIn(p).size = {20, 20};
    EXPECT_TRUE(renderer.draw(p, eyeHeight(), small())) << "what is mended is drawn";
}

TEST(UniqueBlades, ExplainSaysThatSlicesRepeatThePatch) {
    Project p = fieldOf(Technique::Hybrid);
    grassIn(p).population = Population::Unique;
    Renderer renderer(gpu(), tables());
    EXPECT_NE(renderer.explain(p, false).find("slices are images of one patch"), std::string::npos);
    grassIn(p).technique = nameOf(Technique::Geometry);
    EXPECT_EQ(renderer.explain(p, false).find("slices are images of one patch"), std::string::npos);
}

}  // namespace
}  // namespace sward
