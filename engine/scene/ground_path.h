// A path on the ground: points in order, the curve through them, and how much of a place it covers.
// The curve is a centripetal Catmull-Rom spline (Catmull and Rom 1974; Yuksel, Schaefer and Keyser 2011: no cusp and no
// loop within a piece), cut into cubic Beziers. Its nearest point to a place is found from the roots of a polynomial in
// Bernstein form (Schneider 1990, "Solving the nearest-point-on-curve problem"), so none is missed.
// Does not: know heights or maps; who applies it does.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <limits>
#include <string>
#include <vector>

#include "scene/rows.h"

namespace sward {

// A point of a path, in metres from the terrain's corner along x and z (Vec2's x and y).
struct PathPoint {
    std::string name;
    glm::dvec2 at{0};
    bool operator==(const PathPoint&) const = default;
};

// A path over the terrain and what it does to what grows there. Its height is the terrain's.
struct GroundPath {
    std::vector<PathPoint> points;
    bool closed = false;   // the last point leads back to the first
    float width = 1.5f;    // metres, across, over which it has its full effect
    float falloff = 0.5f;  // metres beside that over which the effect fades
    float grass = -1;      // -1: nothing grows on it; 0: as painted; 1: as dense as can be
    float flowers = -1;    // the same of flowers
    float tint = 0;        // share of `color` over the ground's own; 0: none
    glm::vec3 color{0.2f, 0.16f, 0.11f};
    bool operator==(const GroundPath&) const = default;
};

ComponentRow groundPathRow();

// A piece of the curve from one point to the next.
struct CurvePiece {
    std::array<glm::dvec2, 4> bezier;  // its control points
    size_t from = 0;                   // number of the point of GroundPath at which it begins
};
// The curve of a path. No piece: it has no point. One place, however often it is given, is one piece of length 0.
struct GroundCurve {
    std::vector<CurvePiece> pieces;
    bool closed = false;
};
// Points that are not finite, and points at the place of the one before them, are left out.
GroundCurve groundCurve(const GroundPath& path);

// The place of a piece at t in [0, 1], and its derivative by t.
glm::dvec2 placeOn(const CurvePiece& piece, double t);
glm::dvec2 slopeOn(const CurvePiece& piece, double t);

// The place of a curve that is nearest to another.
struct NearestOnCurve {
    double distance = std::numeric_limits<double>::infinity();  // metres; infinite: nothing is within reach
    glm::dvec2 at{0};
    size_t piece = 0;  // of GroundCurve::pieces
    double t = 0;      // there, in [0, 1]
};
// `reach`, metres: what is not nearer than this is not looked for. Places that are not finite are infinitely far. Cost:
// about 0.3 us a piece whose box is within reach, nothing much for others.
NearestOnCurve nearestOn(const GroundCurve& curve, const glm::dvec2& place,
                         double reach = std::numeric_limits<double>::infinity());

// How far beside the curve its effect ends, in metres: half of the width, and the falloff.
double reachOf(const GroundPath& path);
// Share of its effect that the path has at a distance from its curve: 1 over its width, then down to 0 over the falloff
// (3 s^2 - 2 s^3, without a kink). A falloff of 0 is an edge.
double weightAt(const GroundPath& path, double distance);
// Share of its effect at a place; 0 without points.
double weightAt(const GroundPath& path, const GroundCurve& curve, const glm::dvec2& place);

// A box over x and z in which all of the effect lies; empty (low above high) without points.
struct GroundBox {
    glm::dvec2 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
};
// `beside`: metres by which it is wider than the curve.
GroundBox boxOf(const GroundCurve& curve, double beside);

// The curve as a line of straight chords, each with its metres from the beginning: to go along it, or to draw it.
// `chords` a piece, at least 1. One that goes nowhere is one place; empty without points.
struct CurveStation {
    glm::dvec2 at{0};
    double metres = 0;
};
std::vector<CurveStation> stationsOn(const GroundCurve& curve, int chords = 32);
// The place so many metres along, between the stations; at the ends of an open curve it stands. Needs a station.
glm::dvec2 placeAlong(const std::vector<CurveStation>& stations, double metres);

}  // namespace sward
