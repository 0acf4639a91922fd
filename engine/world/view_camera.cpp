#include "world/view_camera.h"

#include "world/ground.h"

namespace sward {

const Camera* findCamera(const Project& p, const std::string& name) {
    for (const auto& [n, e] : p.entities)
        if (const Camera* c = p.registry.get<Camera>(e); c && (name.empty() || n == name)) return c;
    return nullptr;
}

ViewCamera viewOf(const Camera& c) { return {c.eye, c.target, c.fovDeg, c.exposure}; }

std::optional<glm::dvec3> pickGround(const Project& p, const ViewCamera& c, int width, int height, double px,
                                     double py) {
    return pickGround(findGround(p), c, width, height, px, py);
}

std::optional<glm::dvec3> pickGround(const Ground& ground, const ViewCamera& c, int width, int height, double px,
                                     double py) {
    if (!ground.terrain || width <= 0 || height <= 0) return {};
    const glm::dvec3 forward = glm::normalize(c.target - c.eye);
    const glm::dvec3 up = std::abs(forward.y) > 0.9999 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, up));
    const double t = std::tan(glm::radians(static_cast<double>(c.fovDeg)) / 2);
    const glm::dvec3 dir = glm::normalize(forward + right * ((2 * px / width - 1) * t * width / height) +
                                          glm::cross(right, forward) * ((1 - 2 * py / height) * t));
    const glm::dvec3 eye = c.eye - ground.origin;
    // March with steps that grow with distance, then bisect the step that went below.
    const auto above = [&](double s) {
        const glm::dvec3 q = eye + dir * s;
        return q.y - terrainHeight(*ground.terrain, q.x, q.z);
    };
    const double far = 4 * (ground.terrain->size.x + ground.terrain->size.y + std::abs(eye.y));
    double a = 0, b = 0;
    for (double s = 0.05; s < far; s += std::max(0.05, s * 0.02)) {
        a = b, b = s;
        if (above(s) <= 0) break;
    }
    if (above(b) > 0) return {};
    for (int i = 0; i < 40; ++i) (above((a + b) / 2) > 0 ? a : b) = (a + b) / 2;
    const glm::dvec3 hit = eye + dir * b;
    if (hit.x < 0 || hit.z < 0 || hit.x > ground.terrain->size.x || hit.z > ground.terrain->size.y) return {};
    return ground.origin + glm::dvec3(hit.x, terrainHeight(*ground.terrain, hit.x, hit.z), hit.z);
}

}  // namespace sward
