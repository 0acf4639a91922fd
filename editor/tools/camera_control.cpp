#include "tools/camera_control.h"

#include "world/view_camera.h"

#include <cmath>

namespace sward {
namespace {

constexpr double kRadiansPerPixel = 0.0045;
constexpr double kMaxPitch = 89 * 3.14159265358979 / 180;

glm::dvec3 rightOf(const FlyCamera& c) { return {std::cos(c.yaw), 0, std::sin(c.yaw)}; }

}  // namespace

glm::dvec3 forwardOf(const FlyCamera& c) {
    return {std::sin(c.yaw) * std::cos(c.pitch), std::sin(c.pitch), -std::cos(c.yaw) * std::cos(c.pitch)};
}

glm::dvec3 pivotOf(const FlyCamera& c) { return c.eye + forwardOf(c) * c.distance; }

FlyCamera flyFrom(const ViewCamera& view) {
    FlyCamera c;
    c.eye = view.eye;
    c.fovDeg = view.fovDeg;
    c.exposure = view.exposure;
    const glm::dvec3 d = view.target - view.eye;
    const double length = glm::length(d);
    if (!(length > 0)) return c;
    c.distance = length;
    c.yaw = std::atan2(d.x, -d.z);
    c.pitch = std::clamp(std::asin(d.y / length), -kMaxPitch, kMaxPitch);
    return c;
}

ViewCamera viewOf(const FlyCamera& c) { return {c.eye, pivotOf(c), c.fovDeg, c.exposure}; }

void look(FlyCamera& c, double dx, double dy) {
    c.yaw = std::remainder(c.yaw + dx * kRadiansPerPixel, 2 * 3.14159265358979);
    c.pitch = std::clamp(c.pitch - dy * kRadiansPerPixel, -kMaxPitch, kMaxPitch);
}

void orbit(FlyCamera& c, double dx, double dy) {
    const glm::dvec3 pivot = pivotOf(c);
    look(c, dx, dy);
    c.eye = pivot - forwardOf(c) * c.distance;
}

void fly(FlyCamera& c, glm::dvec3 direction, double seconds) {
    const double length = glm::length(direction);
    if (!(length > 0)) return;
    const glm::dvec3 d = direction / std::max(length, 1.0);
    c.eye += (rightOf(c) * d.x + glm::dvec3(0, 1, 0) * d.y + forwardOf(c) * d.z) * (c.speed * seconds);
}

void changeSpeed(FlyCamera& c, double notches) { c.speed = std::clamp(c.speed * std::pow(1.2, notches), 0.1, 500.0); }

void dolly(FlyCamera& c, glm::dvec3 target, double notches) {
    const double share = 1 - std::pow(0.9, notches);  // negative notches back away
    const glm::dvec3 step = (target - c.eye) * share;
    if (glm::length(target - c.eye - step) < 0.05) return;
    c.eye += step;
    c.distance = std::max(0.05, c.distance * (1 - share));
}

void pan(FlyCamera& c, double dx, double dy, double height) {
    const double metresPerPixel = 2 * c.distance * std::tan(c.fovDeg * 3.14159265358979 / 360) / std::max(height, 1.0);
    const glm::dvec3 up = glm::cross(rightOf(c), forwardOf(c));
    c.eye += (up * dy - rightOf(c) * dx) * metresPerPixel;
}

void focus(FlyCamera& c, glm::dvec3 point, double distance) {
    c.distance = std::max(distance, 0.05);
    c.eye = point - forwardOf(c) * c.distance;
}

}  // namespace sward
