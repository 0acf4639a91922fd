#include "tools/rings.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sward {
namespace {

constexpr double kTurn = 6.283185307179586;
constexpr double kOnTop = 1.5;  // pixels between rings that a hand cannot tell apart

// How far along a direction from the centre the ground is `distance` away: fixed-point steps towards the root, halved
// where they would swing.
std::optional<double> radiusTowards(const HeightAt& heightAt, const glm::dvec3& centre, double distance, double dx,
                                    double dz) {
    double radius = distance;
    for (int i = 0; i < 6; ++i) {
        const double y = heightAt(centre.x + dx * radius, centre.z + dz * radius) - centre.y;
        const double next = std::sqrt(std::max(distance * distance - y * y, 0.0));
        radius = i < 2 ? next : (radius + next) / 2;
    }
    const double y = heightAt(centre.x + dx * radius, centre.z + dz * radius) - centre.y;
    if (std::abs(std::hypot(radius, y) - distance) > 0.02 * distance + 0.05) return std::nullopt;
    return radius;
}

// Nearest point of a segment, as a share of it.
double nearestShare(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
    const glm::dvec2 d = b - a;
    const double length2 = glm::dot(d, d);
    return length2 > 0 ? std::clamp(glm::dot(p - a, d) / length2, 0.0, 1.0) : 0;
}

RingHit nearestOf(const ScreenRing& ring, const glm::dvec2& pointer) {
    RingHit best;
    best.pixels = std::numeric_limits<double>::max();
    for (size_t i = 0; i < ring.size(); ++i) {
        const auto &a = ring[i], &b = ring[(i + 1) % ring.size()];
        if (!a || !b) continue;
        const double share = nearestShare(*a, *b, pointer);
        const glm::dvec2 at = *a + (*b - *a) * share;
        const double pixels = glm::length(pointer - at);
        if (pixels < best.pixels) best = {{}, at, static_cast<double>(i) + share, pixels};
    }
    return best;
}

}  // namespace

std::vector<std::optional<glm::dvec3>> ringPoints(const HeightAt& heightAt, const glm::dvec3& centre, double distance,
                                                  int count) {
    std::vector<std::optional<glm::dvec3>> points(static_cast<size_t>(std::max(count, 0)));
    if (!(distance > 0) || !std::isfinite(distance)) return points;
    for (int i = 0; i < count; ++i) {
        const double a = kTurn * i / count, dx = std::cos(a), dz = std::sin(a);
        const std::optional<double> radius = radiusTowards(heightAt, centre, distance, dx, dz);
        if (!radius) continue;
        const double x = centre.x + dx * *radius, z = centre.z + dz * *radius;
        points[static_cast<size_t>(i)] = glm::dvec3(x, heightAt(x, z), z);
    }
    return points;
}

bool hiddenByGround(const HeightAt& heightAt, const glm::dvec3& eye, const glm::dvec3& point, double slack) {
    constexpr int kSteps = 24;
    for (int i = 1; i < kSteps; ++i) {
        const glm::dvec3 at = eye + (point - eye) * (static_cast<double>(i) / kSteps);
        if (heightAt(at.x, at.z) > at.y + slack) return true;
    }
    return false;
}

std::optional<RingHit> pickRing(std::span<const ScreenRing> rings, const glm::dvec2& pointer, double tolerance) {
    std::vector<RingHit> near(rings.size());
    for (size_t i = 0; i < rings.size(); ++i) near[i] = nearestOf(rings[i], pointer);
    double least = std::numeric_limits<double>::max();
    for (const RingHit& hit : near) least = std::min(least, hit.pixels);
    if (!(least <= tolerance)) return std::nullopt;
    RingHit hit;
    for (size_t i = 0; i < near.size(); ++i) {
        if (near[i].pixels > least + kOnTop) continue;
        if (hit.rings.empty()) hit = near[i];
        hit.rings.push_back(i);
    }
    return hit;
}

size_t ringMeant(const RingHit& hit, double now, double wanted) {
    return wanted < now ? hit.rings.front() : hit.rings.back();
}

std::optional<glm::dvec2> ringLabel(const ScreenRing& ring, const glm::dvec2& low, const glm::dvec2& high, double x) {
    std::optional<glm::dvec2> best;
    double cost = std::numeric_limits<double>::max();
    for (const std::optional<glm::dvec2>& p : ring) {
        if (!p || p->x < low.x || p->x > high.x || p->y < low.y || p->y > high.y) continue;
        const double mine = std::abs(p->x - x) - 0.2 * p->y;
        if (mine < cost) cost = mine, best = p;
    }
    return best;
}

}  // namespace sward
