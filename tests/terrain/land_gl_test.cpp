// The land beyond the terrain as drawn: no seam, no gap, the truth's, and nothing of it where no terrain asks.
#include <cmath>

#include "reference/reference.h"
#include "scenes.h"
#include "world/land.h"

namespace sward::test {
namespace {

Project hills(LandBeyond beyond) {
    Project p;
    Terrain t;
    t.size = {100, 100};
    t.beyond = beyond;
    Map m({64, 64, 1, PixelType::F32});
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) m.set(x, y, 0, static_cast<float>(3 * std::sin(0.3 * x) * std::cos(0.25 * y)));
    t.height = field(m, "maps/h.exr");
    put(p, "ground", t);
    put<Light>(p, "sun", {.azimuthDeg = 200, .elevationDeg = 40});
    put<Sky>(p, "sky");
    put<Fog>(p, "haze", {.visibility = 1500});
    return p;
}
// A border of 8 m of one colour around a middle that has soil's own, under transparent white.
MapField bordered() {
    Map m({100, 100, 4, PixelType::U8});
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x) {
            const bool inside = x >= 8 && x < 92 && y >= 8 && y < 92;
            for (int c = 0; c < 3; ++c) m.set(x, y, c, inside || c == 0 ? 1.0f : 0.2f);
            m.set(x, y, 3, inside ? 0.0f : 1.0f);
        }
    return field(m, "maps/border.png");
}
ViewCamera whole() { return {{-40, 40, -50}, {50, 0, 50}, 60, 0}; }

TEST(LandPicture, LeavesNoGapBetweenTheTerrainAndTheHorizon) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    ViewSettings s = small();
    s.width = 320, s.height = 240, s.mode = ViewMode::Normals;  // ground is never black, what shows through a gap is
    for (const LandBeyond beyond : {LandBeyond::Extend, LandBeyond::Fade}) {
        Project p = hills(beyond);
        p.registry.remove<Fog>(findEntity(p, "haze"));
        for (const ViewCamera& c : {whole(), ViewCamera{{95, 6, 95}, {130, 0, 120}, 55, 0}}) {
            ASSERT_TRUE(r.draw(p, c, s));
            const auto image = r.readImage();
            const int sky = static_cast<int>(image.size() / 3) / 2;  // rows from the middle on look down
            int black = 0;
            for (size_t i = static_cast<size_t>(sky) * 3; i < image.size(); i += 3)
                black += image[i] + image[i + 1] + image[i + 2] == 0;
            EXPECT_EQ(black, 0);
        }
    }
}

TEST(LandPicture, IsAsTheTruthHasIt) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    for (const std::string ground : {"hills", "level", "with a border"}) {
        Project p = hills(LandBeyond::Fade);
        Terrain& t = *p.registry.get<Terrain>(findEntity(p, "ground"));
        if (ground != "hills") t.height = {};
        if (ground == "with a border") t.terrainMap = bordered();
        ViewSettings s = small();
        s.width = 96, s.height = 64;
        ASSERT_TRUE(r.draw(p, whole(), s));
        const std::vector<float> drawn = r.readLinear();
        JobControl control;
        auto scene = ReferenceScene::make(p, tables(), 0, control);
        ASSERT_TRUE(scene);
        ReferenceSettings rs;
        rs.width = 96, rs.height = 64, rs.samples = 16;
        rs.lighting = ReferenceLighting::Direct;
        const auto truth = scene->trace(whole(), rs, control);
        ASSERT_TRUE(truth);
        double off = 0, light = 0;
        for (size_t i = 0; i < drawn.size(); ++i)
            off += std::abs(double(drawn[i]) - double(truth->color[i])), light += double(truth->color[i]);
        EXPECT_LT(off / light, 0.02) << ground;
    }
}

// Along a line across the edge no pixel differs from its neighbour as an edge would.
TEST(LandPicture, HasNoSeamAtTheTerrainsEdge) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    const Project p = hills(LandBeyond::Fade), cut = hills(LandBeyond::None);
    ViewSettings s = small();
    s.width = 64, s.height = 128;
    const ViewCamera down{{50, 60, 100}, {50, 0, 100.01}, 30, 0};
    const auto step = [&](const Project& project) {
        EXPECT_TRUE(r.draw(project, down, s));
        const std::vector<float> light = r.readLinear();
        double most = 0;
        for (size_t y = 56; y < 72; ++y) {
            double above = 0, below = 0;
            for (size_t x = 0; x < 64 * 3; ++x)
                above += double(light[(y - 2) * 64 * 3 + x]), below += double(light[(y + 2) * 64 * 3 + x]);
            most = std::max(most, std::abs(below / above - 1));
        }
        return most;
    };
    EXPECT_LT(step(p), 0.1);
    EXPECT_GT(step(cut), 2 * step(p)) << "else there is nothing to hide";
}

TEST(LandPicture, WithoutItTheGroundDrawsAsManyNodesAsBefore) {
    NoGlErrors errors;
    Renderer r(gpu(), tables());
    const auto nodes = [&](const Project& p) {
        EXPECT_TRUE(r.draw(p, whole(), small()));
        for (const PassStats& pass : r.stats().passes)
            if (pass.name == "terrain/ground") return pass.instances;
        return decltype(PassStats{}.instances){};
    };
    const auto none = nodes(hills(LandBeyond::None)), fade = nodes(hills(LandBeyond::Fade));
    EXPECT_GT(none, 0u);
    EXPECT_GT(fade, none);
    EXPECT_LT(fade, none + 200) << "20 km of it are some nodes more";
    EXPECT_NE(r.explain(hills(LandBeyond::Fade), false).find("\nterrain-beyond  (because of ground)"),
              std::string::npos);
    EXPECT_NE(r.explain(hills(LandBeyond::None), false).find("terrain-beyond: Terrain.beyond is"), std::string::npos);
}

}  // namespace
}  // namespace sward::test
