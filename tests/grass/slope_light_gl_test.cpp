// Grass on a hillside as bright by each technique as the ray-traced truth, whether it faces the sun or not.
#include <fmt/format.h>

#include <map>

#include "comparison.h"
#include "reference/reference.h"
#include "scenes.h"
#include "techniques.h"
#include "tests/missed.h"

namespace sward::test {
namespace {

constexpr double kSlopeSide = 8;
constexpr double kSlopeLimit = 0.1;  // of the truth's brightness

// Grass that lets soil be seen, on ground that rises so far a metre along z; the sun from low z, or from high z.
Project hillside(double slope, bool faces) {
    Project p = designed(kMeadow, kSlopeSide);
    removeEntity(p, "haze");
    p.registry.get<Sky>(findEntity(p, "sky"))->intensity = 0;
    Map rise({64, 64, 1, PixelType::F32});
    for (int z = 0; z < 64; ++z)
        for (int x = 0; x < 64; ++x) rise.set(x, z, 0, static_cast<float>(slope * (z + 0.5) / 64 * kSlopeSide));
    p.registry.get<Terrain>(findEntity(p, "ground"))->height = {"maps/rise.exr", std::move(rise)};
    Species& s = p.registry.get<GrassField>(findEntity(p, "grass"))->species[0];
    s.bladesPerM2 = 2000, s.height = 0.2f, s.width = 0.006f, s.translucency = 0.6f, s.clumpSize = 0;
    sunIn(p).azimuthDeg = faces ? 0 : 180, sunIn(p).elevationDeg = 33;
    return p;
}
// Across the slope, down to its middle.
ViewCamera aside(double slope) {
    const double high = slope * kSlopeSide / 2;
    return {{1.5, high + 1.5, 4}, {4, high, 4}, 20, 0};
}
double greenOf(const std::vector<float>& image) {
    double sum = 0;
    for (size_t i = 1; i < image.size(); i += 3) sum += static_cast<double>(image[i]);
    return sum / static_cast<double>(image.size() / 3);
}
double drawnSlope(double slope, bool faces, Technique technique) {
    Project p = hillside(slope, faces);
    grassIn(p).technique = nameOf(technique);
    Renderer r(gpu(), tables());
    EXPECT_TRUE(r.draw(p, aside(slope), sized(48, 36)));
    return greenOf(r.readLinear());
}

struct Hillside {
    bool faces;                          // the sun
    std::map<Technique, double> missed;  // by how much each is off where that is more than the limit, as last seen
};

TEST(SlopeLight, IsTheTruthsByEachTechniqueWhereGroundFacesTheSunAndWhereNot) {
    NoGlErrors errors;
    const double slope = 0.25;
    std::map<Technique, double> level;
    for (const Hillside& h : {Hillside{true, {{Technique::Raytraced, 0.124}}}, {false, {{Technique::Slices, 0.135}}}}) {
        const Project p = hillside(slope, h.faces);
        JobControl control;
        const auto scene = ReferenceScene::make(p, tables(), 0, control);
        ASSERT_TRUE(scene) << scene.error().text();
        ReferenceSettings s;
        s.width = 48, s.height = 36, s.samples = 32;
        const double truth = greenOf(scene->trace(aside(slope), s, control)->color);
        for (const Technique t :
             {Technique::Geometry, Technique::Tessellated, Technique::Slices, Technique::Raytraced, Technique::Flat}) {
            const double drawn = drawnSlope(slope, h.faces, t) / truth, flat = drawnSlope(0, h.faces, t) / truth;
            const std::string what =
                fmt::format("ground that {} the sun, {}", h.faces ? "faces" : "turns from", nameOf(t));
            printf("%s: %.3f of the truth; on level ground %.3f\n", what.c_str(), drawn, flat);
            if (const auto known = h.missed.find(t); known != h.missed.end())
                expectMissed(what, std::abs(drawn - 1), kSlopeLimit, known->second);
            else
                EXPECT_NEAR(drawn, 1, kSlopeLimit) << what;
            level[t] += std::abs(flat - 1) / 2;
        }
    }
    for (const auto& [t, off] : level) EXPECT_GT(off, 2 * kSlopeLimit) << nameOf(t) << ": the rival that must lose";
}

}  // namespace
}  // namespace sward::test
