#include "forest/slicing.h"

#include <algorithm>
#include <cmath>

#include "core/numerics.h"
#include "world/forest_ground.h"

namespace sward {
namespace {

constexpr double kSlabPixels = 0.9;  // of a slab's height, where it lies at its tile's distance
constexpr double kLeastSeen = 0.35;  // of a slab's height that counts, straight from above
constexpr double kFadeDeg = 4;       // to both sides of Forest::silhouetteDeg
constexpr double kLevelBand = 0.03;  // sine to both sides of the horizon within which two tilts are there

f64::vec3 upwards(const glm::dvec3& v) { return f64::vec3(v.x, v.z, v.y); }

}  // namespace

std::vector<Prism> prismsOf(const ForestHere& here) {
    std::vector<Prism> out;
    const StandingForest& f = *here.stand;
    for (const ForestTriangle& t : f.triangles) {
        Prism p;
        p.corner = groundUnder(f, t, *here.terrain);
        p.centre = (p.corner[0] + p.corner[1] + p.corner[2]) / 3.0;
        const glm::dvec3 o = p.corner[0];
        p.usable = mayStandOver(p.corner);
        const glm::dvec3 n = glm::cross(p.corner[2] - o, p.corner[1] - o);
        if (p.usable) p.normal = glm::normalize(n), p.slope = std::hypot(n.x, n.z) / std::abs(n.y);
        out.push_back(p);
    }
    return out;
}

double planeAt(const Prism& p, const glm::dvec3& at) {
    const glm::dvec3 to = at - p.corner[0];
    return p.corner[0].y - (p.normal.x * to.x + p.normal.z * to.z) / p.normal.y;
}

Slicing regularSlices(const Prism& p, const Reach& r, const glm::dvec3& eye, double slab) {
    Slicing s;
    s.begin.fill(r.low);
    s.count = std::clamp(static_cast<int>(std::ceil((r.high - r.low) / slab)), 1, kMostSlices);
    s.reach = std::max(s.count * slab, r.high - r.low);
    const double above = eye.y - planeAt(p, eye) - r.low;
    s.below = std::clamp(static_cast<int>(std::floor(above / slab)), 0, s.count);
    return s;
}

Slicing flatSlice(const Prism& p, const Reach& r, const glm::dvec3& eye) {
    Slicing s;
    s.begin.fill(r.low);
    s.count = 1;
    s.reach = r.high - r.low;
    s.below = eye.y > planeAt(p, eye) + 0.5 * (r.low + r.high) ? 1 : 0;
    return s;
}

Slicing tiltedSlices(const Prism& p, const Reach& r, const glm::dvec3& view, double slant, double slab) {
    const double high = r.high - r.low;
    const glm::dvec3 o = p.corner[0];
    const f64::Tilt t = f64::tiltOf(upwards(p.corner[0] - o), upwards(p.corner[1] - o), upwards(p.corner[2] - o),
                                    upwards(view), slant * high, high, 1 / slab);
    Slicing s;
    s.tilted = true;
    for (int k = 0; k < 3; ++k) s.begin[static_cast<size_t>(k)] = r.low + t.offset[k];
    s.reach = high + t.rise;
    s.count = f64::sliceCount(t.count, kMostSlices);
    s.below = view.y < 0 ? s.count : 0;
    return s;
}

SliceShares sliceShares(double silhouetteDeg, const glm::dvec3& normal, const glm::dvec3& view) {
    const double sine = std::min(std::abs(glm::dot(normal, view)), 1.0);
    const double silhouette = glm::smoothstep(-kFadeDeg, kFadeDeg, silhouetteDeg - glm::degrees(std::asin(sine)));
    const double below = glm::smoothstep(-kLevelBand, kLevelBand, view.y);
    return {1 - silhouette, silhouette * (1 - below), silhouette * below};
}

double levelAt(double slab, double last, double distance, double pixelAt1m, double sine) {
    const double seen = std::max(std::sqrt(std::max(1 - sine * sine, 0.0)), kLeastSeen);
    const double pixels = distance * pixelAt1m * kSlabPixels / (slab * seen);
    return std::clamp(std::log2(std::max(pixels, 1e-9)), 0.0, std::max(last - 1, 0.0) + 0.999);
}

}  // namespace sward
