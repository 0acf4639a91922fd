// A field at night, by the light of lamps alone: as bright by each technique as the ray-traced truth.
#include <map>

#include "comparison.h"
#include "reference/reference.h"
#include "scenes.h"
#include "techniques.h"
#include "tests/missed.h"

namespace sward::test {
namespace {

constexpr int kNightWidth = 96, kNightHeight = 72;
constexpr double kLimit = 0.1;  // of the truth's brightness
const ViewCamera kCamera{{10, 1.7, 5}, {10, 0, 9}, 45, 0};

Project night(const std::vector<glm::dvec3>& lamps) {
    Project p = designed(kLawn, kLawn.side);
    for (const char* name : {"sun", "sky", "haze"}) removeEntity(p, name);
    for (size_t i = 0; i < lamps.size(); ++i) {
        const std::string name = "lamp" + std::to_string(i);
        Light l;
        l.type = LightType::Point, l.intensity = 6;
        give(p, name, l);
        p.registry.add<Transform>(findEntity(p, name), Transform{lamps[i]});
    }
    return p;
}

// Mean green below the horizon.
double meanGreenBelow(const std::vector<float>& image) {
    double sum = 0;
    const size_t pixels = image.size() / 3, first = pixels / 3;
    for (size_t i = first; i < pixels; ++i) sum += static_cast<double>(image[3 * i + 1]);
    return sum / static_cast<double>(pixels - first);
}
double drawn(Project& p, Technique technique) {
    grassIn(p).technique = nameOf(technique);
    Renderer r(gpu(), tables());
    EXPECT_TRUE(r.draw(p, kCamera, sized(kNightWidth, kNightHeight)));
    return meanGreenBelow(r.readLinear());
}
double traced(const Project& p) {
    JobControl control;
    const auto scene = ReferenceScene::make(p, tables(), 0, control);
    EXPECT_TRUE(scene) << scene.error().text();
    ReferenceSettings s;
    s.width = kNightWidth, s.height = kNightHeight, s.samples = 16;
    return meanGreenBelow(scene->trace(kCamera, s, control)->color);
}

struct Night {
    const char* name;
    std::vector<glm::dvec3> lamps;
    std::map<Technique, double> missed;  // by how much each is off where that is more than the limit, as last seen
};

TEST(LampLight, IsAsBrightByEachTechniqueAsInTheTruth) {
    NoGlErrors errors;
    const Night nights[] = {
        {"a lamp over the grass", {{10, 3, 9}}, {}},
        {"a low lamp to a side", {{14, 1, 9}}, {}},
        {"a lamp behind the eye", {{10, 2, 4}}, {{Technique::Raytraced, 0.153}}},
        {"three lamps", {{7, 2.5, 8}, {12, 3, 10}, {10, 2, 14}}, {}},
    };
    for (const Night& n : nights) {
        Project p = night(n.lamps);
        const double truth = traced(p);
        ASSERT_GT(truth, 0.001);
        for (const Technique t :
             {Technique::Geometry, Technique::Tessellated, Technique::Slices, Technique::Raytraced, Technique::Flat}) {
            const double share = drawn(p, t) / truth, off = std::abs(share - 1);
            const std::string what = std::string(n.name) + ", " + nameOf(t);
            std::printf("%s: %.3f of the truth\n", what.c_str(), share);
            if (const auto known = n.missed.find(t); known != n.missed.end())
                expectMissed(what, off, kLimit, known->second);
            else
                EXPECT_LE(off, kLimit) << what;
        }
    }
}

}  // namespace
}  // namespace sward::test
