#include "world/lights.h"

#include "scene/project.h"

namespace sward {
namespace {
constexpr double kTau = 6.283185307179586;

double angleOf(const Light& light, double seconds) {
    return glm::radians(double(light.azimuthDeg)) + kTau * turnOf(light, seconds);
}
}  // namespace

const Light* sunLight(const Project& project) {
    const Entity e = sunEntity(project.registry);
    return e == kNoEntity ? nullptr : project.registry.get<Light>(e);
}

double turnOf(const Light& light, double seconds) {
    if (!(light.orbitSeconds > 0)) return 0;
    const double turns = seconds / light.orbitSeconds;
    return turns - std::floor(turns);
}

glm::vec3 directionTo(const Light& light, double seconds) {
    const double a = angleOf(light, seconds), e = glm::radians(double(light.elevationDeg));
    return {std::sin(a) * std::cos(e), std::sin(e), -std::cos(a) * std::cos(e)};
}

glm::dvec3 placeOf(const Light& light, const glm::dvec3& centre, double seconds) {
    const double a = angleOf(light, seconds);
    return centre + double(light.orbitRadius) * glm::dvec3(std::sin(a), 0, -std::cos(a));
}

}  // namespace sward
