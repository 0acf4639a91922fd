// How Embree's user geometry meets blades: what the terrain's grass and that on meshes have in common. Included by
// reference/*.cpp only. Does not: know where blades stand.
#pragma once
#include <cmath>
#include <limits>
#include <optional>

#include "core/numerics.h"
#include "reference/embree.h"
#include "reference/surface.h"

namespace sward {

// A blade in axes in which it stands upright, and a ray in the same, relative to its root. chance: in [0, 1[; where the
// image is no more opaque, the ray goes through.
struct BladeRay {
    glm::vec3 origin, way;
    glm::vec3 control, tip;
    glm::vec2 facing;
    float width;
    const TexelGrid& image;
    float chance;
};
// The nearest place in ]near, far[ where they meet.
inline std::optional<f32::RibbonHit> bladeMetBy(const BladeRay& r, float near, float far) {
    const glm::vec2 at = f32::ribbonMeetings(r.origin, r.way, r.control, r.tip, r.facing);
    std::optional<f32::RibbonHit> found;
    for (const float v : {at.x, at.y}) {
        if (!(v >= 0 && v <= 1)) continue;
        const f32::RibbonHit h = f32::ribbonAt(r.origin, r.way, r.control, r.tip, r.facing, r.width, v);
        if (!(h.t > near && h.t < far) || std::abs(h.across) > 0.5f) continue;
        if (r.image.at(static_cast<double>(h.across) + 0.5, static_cast<double>(v), false).w <= r.chance) continue;
        found = h;
        far = h.t;
    }
    return found;
}

// Embree's callbacks for a query whose first member is a RayContext, and that keeps the number of the closest blade and
// where it was hit. Met: what a blade of this number is to the query's ray, as bladeMetBy.
template <class Query, std::optional<f32::RibbonHit> (*Met)(const Query&, uint32_t, float, float)>
void meetClosestBlade(const RTCIntersectFunctionNArguments* a) {
    if (!a->valid[0]) return;
    Query& q = *reinterpret_cast<Query*>(a->context);
    RTCRayHit& r = *reinterpret_cast<RTCRayHit*>(a->rayhit);
    const auto met = Met(q, a->primID, r.ray.tnear, r.ray.tfar);
    if (!met) return;
    q.blade = a->primID;
    q.hit = *met;
    r.ray.tfar = met->t;
    r.hit.geomID = a->geomID, r.hit.primID = a->primID;
}
template <class Query, std::optional<f32::RibbonHit> (*Met)(const Query&, uint32_t, float, float)>
void meetAnyBlade(const RTCOccludedFunctionNArguments* a) {
    if (!a->valid[0]) return;
    const Query& q = *reinterpret_cast<const Query*>(a->context);
    RTCRay& r = *reinterpret_cast<RTCRay*>(a->ray);
    if (Met(q, a->primID, r.tnear, r.tfar)) r.tfar = -std::numeric_limits<float>::infinity();
}

}  // namespace sward
