#include "tools/gizmo.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sward {
namespace {

constexpr double kArm = 84;       // pixels from the pivot to an arrow's tip
constexpr double kRing = 70;      // radius of rings
constexpr double kSizeRing = 58;  // of the one that scales
constexpr double kMiddle = 9;     // of the disc in the middle
constexpr double kPlaneLow = 22, kPlaneHigh = 40;
constexpr double kReach = 8;  // pixels from a line at which the pointer is on it
constexpr int kRingPoints = 64;
constexpr double kParallel = 0.035;                     // sine of two degrees
constexpr double kFarthestTimes = 50;                   // times as far as the pivot
constexpr double kLeastScale = 0.01, kMostScale = 100;  // factors of one drag
constexpr glm::dvec3 kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1}, kNone{0};

constexpr GizmoPart kParts[] = {
    {"move free", GizmoMode::Move, GizmoShape::Free, kNone}, {"move yz", GizmoMode::Move, GizmoShape::Plane, kX},
    {"move xz", GizmoMode::Move, GizmoShape::Plane, kY},     {"move xy", GizmoMode::Move, GizmoShape::Plane, kZ},
    {"move x", GizmoMode::Move, GizmoShape::Axis, kX},       {"move y", GizmoMode::Move, GizmoShape::Axis, kY},
    {"move z", GizmoMode::Move, GizmoShape::Axis, kZ},       {"turn x", GizmoMode::Turn, GizmoShape::Ring, kX},
    {"turn y", GizmoMode::Turn, GizmoShape::Ring, kY},       {"turn z", GizmoMode::Turn, GizmoShape::Ring, kZ},
    {"scale", GizmoMode::Scale, GizmoShape::Size, kNone},
};

bool any(std::span<const HandleKind> kinds, std::initializer_list<HandleKind> of) {
    return std::any_of(kinds.begin(), kinds.end(),
                       [&](HandleKind k) { return std::find(of.begin(), of.end(), k) != of.end(); });
}

// Two unit vectors that span the plane, (a, b, normal) right-handed.
std::pair<glm::dvec3, glm::dvec3> across(const glm::dvec3& normal) {
    if (normal == kX) return {kY, kZ};
    return normal == kY ? std::pair{kZ, kX} : std::pair{kX, kY};
}

using Line = std::vector<glm::dvec2>;

// Nothing if a point lies behind the eye.
std::optional<Line> projected(const GizmoView& view, std::span<const glm::dvec3> points) {
    Line line;
    for (const glm::dvec3& p : points) {
        const auto at = view.project(p);
        if (!at) return std::nullopt;
        line.push_back(*at);
    }
    return line;
}

double doubleArea(const Line& corners) {
    double area = 0;
    for (size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        area += a.x * b.y - b.x * a.y;
    }
    return std::abs(area);
}

std::optional<ScreenPart> axisOf(const GizmoPart& part, const glm::dvec3& pivot, const GizmoView& view) {
    constexpr double kLeast = 14;  // pixels: below, it points at the eye
    const glm::dvec3 ends[] = {pivot + part.axis * (16 * view.metresPerPixel),
                               pivot + part.axis * (kArm * view.metresPerPixel)};
    auto line = projected(view, ends);
    if (!line || glm::length((*line)[1] - (*line)[0]) < kLeast) return std::nullopt;
    const glm::dvec2 tip = line->back();
    return ScreenPart{&part, std::move(*line), tip};
}

std::optional<ScreenPart> planeOf(const GizmoPart& part, const glm::dvec3& pivot, const GizmoView& view) {
    constexpr double kLeast = 120;  // square pixels, twice: below, it is seen from its edge
    const auto [a, b] = across(part.axis);
    const double low = kPlaneLow * view.metresPerPixel, high = kPlaneHigh * view.metresPerPixel;
    const glm::dvec3 corners[] = {pivot + a * low + b * low, pivot + a * high + b * low, pivot + a * high + b * high,
                                  pivot + a * low + b * high};
    auto line = projected(view, corners);
    if (!line || doubleArea(*line) < kLeast) return std::nullopt;
    const glm::dvec2 middle = ((*line)[0] + (*line)[2]) / 2.0;
    return ScreenPart{&part, std::move(*line), middle};
}

// The half that faces the eye; its grip is in the middle of that.
std::optional<ScreenPart> ringOf(const GizmoPart& part, const glm::dvec3& pivot, const GizmoView& view) {
    const auto [a, b] = across(part.axis);
    const glm::dvec3 toEye = view.eye - pivot, flat{glm::dot(toEye, a), glm::dot(toEye, b), 0};
    const double nearest = std::atan2(flat.y, flat.x), radius = kRing * view.metresPerPixel;
    const bool whole = glm::length(flat) < 0.1 * glm::length(toEye);  // seen from its axis: all of it faces the eye
    const double half = whole ? 3.14159265358979 : 3.14159265358979 / 2;
    std::vector<glm::dvec3> points;
    for (int i = 0; i <= kRingPoints; ++i) {
        const double angle = nearest + half * (2.0 * i / kRingPoints - 1);
        points.push_back(pivot + (a * std::cos(angle) + b * std::sin(angle)) * radius);
    }
    auto line = projected(view, points);
    if (!line) return std::nullopt;
    const glm::dvec2 grip = (*line)[kRingPoints / 2];
    return ScreenPart{&part, std::move(*line), grip};
}

std::optional<ScreenPart> flatRing(const GizmoPart& part, const glm::dvec3& pivot, const GizmoView& view,
                                   double radius) {
    const auto centre = view.project(pivot);
    if (!centre) return std::nullopt;
    ScreenPart out{&part, {}, *centre};
    for (int i = 0; i <= kRingPoints; ++i) {
        const double angle =
            6.283185307179586 * (static_cast<double>(i) / kRingPoints - 0.125);  // from the upper right
        out.line.push_back(*centre + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    if (part.shape == GizmoShape::Size) out.grip = out.line.front();
    return out;
}

std::optional<ScreenPart> onScreen(const GizmoPart& part, const glm::dvec3& pivot, const GizmoView& view) {
    switch (part.shape) {
        case GizmoShape::Axis:
            return axisOf(part, pivot, view);
        case GizmoShape::Plane:
            return planeOf(part, pivot, view);
        case GizmoShape::Ring:
            return ringOf(part, pivot, view);
        case GizmoShape::Free:
            return flatRing(part, pivot, view, kMiddle);
        case GizmoShape::Size:
            return flatRing(part, pivot, view, kSizeRing);
    }
    return std::nullopt;
}

double distanceTo(const Line& line, const glm::dvec2& p) {
    double least = std::numeric_limits<double>::max();
    for (size_t i = 0; i + 1 < line.size(); ++i) {
        const glm::dvec2 d = line[i + 1] - line[i];
        const double length2 = glm::dot(d, d);
        const double share = length2 > 0 ? std::clamp(glm::dot(p - line[i], d) / length2, 0.0, 1.0) : 0;
        least = std::min(least, glm::length(p - line[i] - d * share));
    }
    return least;
}

bool inside(const Line& corners, const glm::dvec2& p) {
    bool in = false;
    for (size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        const glm::dvec2 &a = corners[i], &b = corners[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
    }
    return in;
}

// How far the pointer is from being on a part, in the order in which parts are meant; infinite: it is not on it.
double missed(const ScreenPart& s, const glm::dvec2& pointer) {
    constexpr double kNo = std::numeric_limits<double>::infinity();
    if (s.part->shape == GizmoShape::Free) return glm::length(pointer - s.grip) <= kMiddle ? -2 : kNo;
    if (s.part->shape == GizmoShape::Plane) return inside(s.line, pointer) ? -1 : kNo;
    const double pixels = distanceTo(s.line, pointer);
    return pixels <= kReach ? pixels : kNo;
}

std::optional<Motion> moved(const GizmoGrab& g, const GizmoRay& ray, const GizmoSteps* steps) {
    Motion m;
    m.pivot = g.pivot;
    if (g.part->shape == GizmoShape::Axis) {
        const auto from = alongAxis(g.pivot, g.part->axis, g.ray), to = alongAxis(g.pivot, g.part->axis, ray);
        if (!from || !to) return std::nullopt;
        m.move = g.part->axis * (*to - *from);
    } else {
        const glm::dvec3 normal = g.part->shape == GizmoShape::Plane ? g.part->axis : g.forward;
        const auto from = onPlane(g.pivot, normal, g.ray), to = onPlane(g.pivot, normal, ray);
        if (!from || !to) return std::nullopt;
        m.move = *to - *from;
        for (int i = 0; i < 3; ++i)
            if (g.part->axis[i] != 0) m.move[i] = 0;  // to the bit
    }
    for (int i = 0; steps && i < 3; ++i)
        if (m.move[i] != 0) m.move[i] = snapped(g.pivot[i] + m.move[i], static_cast<double>(steps->grid)) - g.pivot[i];
    return m;
}

}  // namespace

std::span<const GizmoPart> gizmoParts() { return kParts; }

bool partFits(const GizmoPart& part, std::span<const HandleKind> chosen) {
    using enum HandleKind;
    const bool several = chosen.size() > 1;
    switch (part.shape) {
        case GizmoShape::Axis:
            return any(chosen, {Object, Lamp, Camera, Force, Pond, Other}) || (part.axis == kY && any(chosen, {Water}));
        case GizmoShape::Plane:
        case GizmoShape::Free:
            return any(chosen, {Object, Lamp, Camera, Force, Pond, Other});
        case GizmoShape::Ring:
            return any(chosen, {Object, Camera}) || (part.axis == kY && (several || any(chosen, {Force})));
        case GizmoShape::Size:
            return any(chosen, {Object, Pond});
    }
    return false;
}

std::vector<ScreenPart> screenParts(GizmoMode mode, std::span<const HandleKind> chosen, const glm::dvec3& pivot,
                                    const GizmoView& view) {
    std::vector<ScreenPart> out;
    for (const GizmoPart& part : kParts) {
        if (part.mode != mode || !partFits(part, chosen)) continue;
        if (auto s = onScreen(part, pivot, view)) out.push_back(std::move(*s));
    }
    return out;
}

const ScreenPart* partAt(std::span<const ScreenPart> parts, const glm::dvec2& pointer) {
    const ScreenPart* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const ScreenPart& s : parts)
        if (const double mine = missed(s, pointer); mine < least) least = mine, best = &s;
    return best;
}

std::optional<double> alongAxis(const glm::dvec3& pivot, const glm::dvec3& axis, const GizmoRay& ray) {
    const glm::dvec3 apart = pivot - ray.from;
    const double b = glm::dot(axis, ray.way), sine2 = 1 - b * b;
    if (sine2 < kParallel * kParallel) return std::nullopt;
    const double a = glm::dot(axis, apart), r = glm::dot(ray.way, apart);
    const double far = (r - b * a) / sine2;  // along the ray
    if (!(far > 0) || far > kFarthestTimes * glm::length(apart)) return std::nullopt;
    return (b * r - a) / sine2;
}

std::optional<glm::dvec3> onPlane(const glm::dvec3& pivot, const glm::dvec3& normal, const GizmoRay& ray) {
    const glm::dvec3 apart = pivot - ray.from;
    const double sine = glm::dot(normal, ray.way);
    if (std::abs(sine) < kParallel) return std::nullopt;
    const double far = glm::dot(normal, apart) / sine;
    if (!(far > 0) || far > kFarthestTimes * glm::length(apart)) return std::nullopt;
    return ray.from + ray.way * far;
}

double snapped(double value, double step) { return step > 0 ? std::round(value / step) * step : value; }

GizmoGrab grabPart(const ScreenPart& s, const glm::dvec3& pivot, const GizmoView& view, const glm::dvec2& pointer,
                   const GizmoRay& ray) {
    GizmoGrab g{s.part, pivot, view.project(pivot).value_or(pointer), pointer, ray, view.forward};
    if (s.part->shape != GizmoShape::Ring) return g;
    // The ring's line runs counter-clockwise about its axis: its way at the nearest point, as long as a radian there.
    size_t best = 0;
    for (size_t i = 0; i + 1 < s.line.size(); ++i)
        if (glm::length(s.line[i] - pointer) < glm::length(s.line[best] - pointer)) best = i;
    const glm::dvec2 way = s.line[best + 1] - s.line[best];
    const double length = glm::length(way);
    g.tangent = length > 1e-9 ? way / length * kRing : glm::dvec2(kRing, 0);
    return g;
}

std::optional<Motion> motionOf(const GizmoGrab& g, const glm::dvec2& pointer, const GizmoRay& ray,
                               const GizmoSteps* steps) {
    if (g.part->mode == GizmoMode::Move) return moved(g, ray, steps);
    Motion m;
    m.pivot = g.pivot;
    if (g.part->shape == GizmoShape::Ring) {
        m.axis = g.part->axis;
        m.angle = glm::dot(pointer - g.pointer, g.tangent) / glm::dot(g.tangent, g.tangent);
        if (steps) m.angle = glm::radians(snapped(glm::degrees(m.angle), static_cast<double>(steps->angleDeg)));
        return m;
    }
    const double before = std::max(glm::length(g.pointer - g.centre), 1.0);
    m.scale = std::clamp(glm::length(pointer - g.centre) / before, kLeastScale, kMostScale);
    if (steps)
        m.scale = std::max(snapped(m.scale, static_cast<double>(steps->scale)), static_cast<double>(steps->scale));
    return m;
}

}  // namespace sward
