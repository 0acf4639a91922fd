#include "world/camera_path.h"

#include <algorithm>
#include <cmath>

#include "core/overhauser.h"

namespace sward {
namespace {

struct Station {
    double seconds = 0;
    glm::dvec3 eye{0}, target{0};
    double fov = 0;
};
Station operator+(const Station& a, const Station& b) {
    return {a.seconds + b.seconds, a.eye + b.eye, a.target + b.target, a.fov + b.fov};
}
Station operator*(double f, const Station& a) { return {f * a.seconds, f * a.eye, f * a.target, f * a.fov}; }

std::vector<Station> stationsOf(const CameraPath& path) {
    std::vector<Station> out;
    for (const CameraKey& k : path.keys)
        out.push_back({static_cast<double>(k.seconds), k.eye, k.target, static_cast<double>(k.fovDeg)});
    std::stable_sort(out.begin(), out.end(), [](const Station& a, const Station& b) { return a.seconds < b.seconds; });
    return out;
}

// Change a second between two stations; none across a cut.
Station rate(const Station& a, const Station& b) {
    const double dt = b.seconds - a.seconds;
    return dt > 0 ? (1 / dt) * (b + -1.0 * a) : Station{};
}
// Slope at s[i]; at an end or a cut that of the one side there is.
Station slopeAt(const std::vector<Station>& s, size_t i) {
    const Station &before = s[i > 0 ? i - 1 : i], &after = s[i + 1 < s.size() ? i + 1 : i];
    return overhauserSlope(s[i].seconds - before.seconds, rate(before, s[i]), after.seconds - s[i].seconds,
                           rate(s[i], after));
}
Station between(const std::vector<Station>& s, size_t i, double seconds) {
    const double dt = s[i + 1].seconds - s[i].seconds, t = (seconds - s[i].seconds) / dt, u = 1 - t;
    return (u * u * (1 + 2 * t)) * s[i] + (t * t * (1 + 2 * u)) * s[i + 1] + (u * u * t * dt) * slopeAt(s, i) +
           (-t * t * u * dt) * slopeAt(s, i + 1);
}

}  // namespace

Camera cameraOn(const CameraPath& path, double seconds) {
    const std::vector<Station> s = stationsOf(path);
    const auto after =
        std::upper_bound(s.begin(), s.end(), seconds, [](double t, const Station& k) { return t < k.seconds; });
    const size_t i = static_cast<size_t>(after - s.begin());
    const Station at = i == 0 ? s.front() : i == s.size() ? s.back() : between(s, i - 1, seconds);
    Camera c{at.eye, at.target, static_cast<float>(std::clamp(at.fov, 1.0, 170.0)), path.exposure};
    if (glm::length(c.target - c.eye) < 1e-3) c.target = c.eye + glm::dvec3(0, 0, -1);
    return c;
}

double secondsOf(const CameraPath& path) {
    double last = 0;
    for (const CameraKey& k : path.keys) last = std::max(last, static_cast<double>(k.seconds));
    return last;
}

CameraPath cameraAlong(const GroundPath& path, const Ground& ground, double eyeHeight, double speed) {
    constexpr double kApart = 1.5, kMostKeys = 400, kAhead = 4, kLongest = 86400;
    const GroundCurve curve = groundCurve(path);
    const std::vector<CurveStation> stations = stationsOn(curve);
    const double length = stations.empty() ? 0 : stations.back().metres;
    CameraPath out;
    if (!(length > 0)) return out;
    const glm::dvec2 end = glm::normalize(stations.back().at - stations[stations.size() - 2].at);
    // Beyond the end of an open path it goes straight on; a closed one begins again.
    const auto eyeAt = [&](double metres) {
        const double along = curve.closed ? std::fmod(metres, length) : metres;
        const glm::dvec2 at = placeAlong(stations, along) + end * std::max(0.0, along - length);
        const double height = ground.terrain ? terrainHeight(*ground.terrain, at.x, at.y) : 0;
        return ground.origin + glm::dvec3(at.x, height + eyeHeight, at.y);
    };
    const int gaps = static_cast<int>(std::clamp(std::ceil(length / kApart), 1.0, kMostKeys - 1));
    const double seconds = std::min(length / speed, kLongest);
    for (int i = 0; i <= gaps; ++i) {
        const double share = static_cast<double>(i) / gaps;
        // A closed path's last key is its first.
        const double metres = curve.closed && i == gaps ? 0 : share * length;
        out.keys.push_back(
            {fmt::format("key {}", i), static_cast<float>(share * seconds), eyeAt(metres), eyeAt(metres + kAhead)});
    }
    return out;
}

}  // namespace sward
