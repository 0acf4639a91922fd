#include "world/lights.h"

#include <gtest/gtest.h>

#include "scene/project.h"
#include "techniques.h"

namespace sward::test {
namespace {

Project withLights(std::initializer_list<std::pair<const char*, Light>> lights) {
    Project p;
    for (const auto& [name, light] : lights) p.registry.add<Light>(*addEntity(p, name), light);
    return p;
}
Light point() {
    Light l;
    l.type = LightType::Point;
    return l;
}
Light dark() {
    Light l;
    l.intensity = 0;
    return l;
}

TEST(Lights, TheFirstDirectionalLightByNameIsTheSunAndAllOthersAreLamps) {
    const auto features = [](const Project& p) { return sceneFeatures(p.registry, tables().components); };
    const Project one = withLights({{"m", {}}});
    EXPECT_TRUE(has(features(one), Feature::Sun));
    EXPECT_FALSE(has(features(one), Feature::Lamps));
    const Project p = withLights({{"m", {}}, {"z", {}}, {"a", point()}});
    EXPECT_EQ(sunLight(p), p.registry.get<Light>(findEntity(p, "m")));
    EXPECT_EQ(entitiesWith(p.registry, tables().components, Feature::Sun), (std::vector<std::string>{"m"}));
    EXPECT_EQ(entitiesWith(p.registry, tables().components, Feature::Lamps), (std::vector<std::string>{"a", "z"}));
    const Project lanterns = withLights({{"a", point()}});
    EXPECT_EQ(sunLight(lanterns), nullptr);
    EXPECT_FALSE(has(features(lanterns), Feature::Sun));
    const Project night = withLights({{"a", dark()}, {"b", {}}});
    EXPECT_FALSE(has(features(night), Feature::Sun)) << "the sun is off, not another one";
    EXPECT_TRUE(has(features(night), Feature::Lamps));
}

TEST(Lights, MoveAsEvenlyAfterThirtyDaysAsAtOnce) {
    Light l = point();
    l.orbitRadius = 3;
    l.orbitSeconds = 7;
    const glm::dvec3 centre(5, 1, -2);
    const double month = 30 * 86400.0, whole = std::floor(month / 7) * 7;
    for (double t : {0.0, 0.5, 3.4, 6.99}) {
        EXPECT_LT(glm::length(placeOf(l, centre, t) - placeOf(l, centre, t + whole)), 1e-5) << t;
        EXPECT_NEAR(glm::length(placeOf(l, centre, t) - centre), 3, 1e-12);
    }
    const double step = glm::length(placeOf(l, centre, month + 1 / 60.0) - placeOf(l, centre, month));
    EXPECT_NEAR(step, 2 * 3.14159265358979 * 3 / 7 / 60, 0.01 * step);
    for (double t : {-1e9, -0.1, 0.0, 1e12}) {
        EXPECT_GE(turnOf(l, t), 0);
        EXPECT_LE(turnOf(l, t), 1);
    }
    l.orbitSeconds = 0;
    EXPECT_EQ(placeOf(l, centre, 0), placeOf(l, centre, 1e6));
}

TEST(Lights, ADirectionalLightTurnsOnceInItsTime) {
    Light l;
    l.azimuthDeg = 90;  // east, +x
    l.elevationDeg = 30;
    l.orbitSeconds = 60;
    const auto expectNear = [](const glm::vec3& a, const glm::vec3& b) { EXPECT_LT(glm::length(a - b), 1e-6f); };
    const float c = std::sqrt(0.75f);
    expectNear(directionTo(l, 0), {c, 0.5f, 0});
    expectNear(directionTo(l, 15), {0, 0.5f, c});
    expectNear(directionTo(l, 30), {-c, 0.5f, 0});
    expectNear(directionTo(l, 600), {c, 0.5f, 0});
}

}  // namespace
}  // namespace sward::test
