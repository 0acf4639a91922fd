#include "scene/ground_path.h"

#include <algorithm>
#include <cmath>

#include "core/overhauser.h"
#include "scene/field_rows.h"

namespace sward {
namespace {

bool finite(const glm::dvec2& p) { return std::isfinite(p.x) && std::isfinite(p.y); }
double lengthOf(const glm::dvec2& v) { return std::hypot(v.x, v.y); }

// --- the curve ---------------------------------------------------------------------------------------------------

struct Knot {
    glm::dvec2 at;
    size_t point;
};
std::vector<Knot> knotsOf(const GroundPath& path) {
    std::vector<Knot> out;
    for (size_t i = 0; i < path.points.size(); ++i) {
        const glm::dvec2& at = path.points[i].at;
        if (finite(at) && (out.empty() || lengthOf(at - out.back().at) > 0)) out.push_back({at, i});
    }
    if (path.closed)
        while (out.size() > 1 && !(lengthOf(out.front().at - out.back().at) > 0)) out.pop_back();
    return out;
}

// Centripetal: knots are the roots of the distances.
double span(const glm::dvec2& a, const glm::dvec2& b) { return std::sqrt(lengthOf(b - a)); }
glm::dvec2 rate(const glm::dvec2& a, const glm::dvec2& b) {
    const double dt = span(a, b);
    return dt > 0 ? (b - a) / dt : glm::dvec2(0);
}

// --- Bernstein polynomials of degree 5 ---------------------------------------------------------------------------

using Quintic = std::array<double, 6>;

// Value and derivative at t (de Casteljau).
std::pair<double, double> valueOf(Quintic q, double t) {
    for (size_t n = 5; n > 1; --n)
        for (size_t i = 0; i < n; ++i) q[i] += t * (q[i + 1] - q[i]);
    return {q[0] + t * (q[1] - q[0]), 5 * (q[1] - q[0])};
}
std::pair<Quintic, Quintic> halves(Quintic q) {
    Quintic left;
    for (size_t n = 0; n < 6; ++n) {
        left[n] = q[0];
        for (size_t i = 0; i + n < 5; ++i) q[i] = 0.5 * (q[i] + q[i + 1]);
    }
    return {left, q};  // what is left in place are the right half's coefficients
}
int signChanges(const Quintic& q) {
    int changes = 0;
    double last = 0;
    for (const double c : q) {
        if (c == 0) continue;
        changes += last != 0 && (last < 0) != (c < 0);
        last = c;
    }
    return changes;
}
// Where it rises through 0, of which there is one place: by Newton's steps, and by halving where they leave the
// bracket.
double rise(const Quintic& q) {
    double low = 0, high = 1, t = 0.5;
    for (int i = 0; i < 60 && high - low > 1e-15; ++i) {
        const auto [f, slope] = valueOf(q, t);
        if (f == 0) return t;
        (f < 0 ? low : high) = t;
        const double next = t - f / slope, before = t;
        t = next > low && next < high ? next : 0.5 * (low + high);
        if (std::abs(t - before) < 1e-15) return t;
    }
    return t;
}

constexpr int kMostHalvings = 40;
// Calls `found(t)` where q, given over [low, high], rises through 0.
template <class F>
void eachRise(const Quintic& q, double low, double high, int depth, const F& found) {
    const int changes = signChanges(q);
    if (changes == 0) return;
    if (changes == 1) {
        const auto first = std::find_if(q.begin(), q.end(), [](double c) { return c != 0; });
        if (*first < 0) found(low + (high - low) * rise(q));
        return;
    }
    const double mid = 0.5 * (low + high);
    if (depth == kMostHalvings) return found(mid);
    const auto [left, right] = halves(q);
    if (right[0] == 0) found(mid);  // neither half has a change of sign there
    eachRise(left, low, mid, depth + 1, found);
    eachRise(right, mid, high, depth + 1, found);
}

// Half the slope of the squared distance of a place to the piece: (B(t) - place) . B'(t).
Quintic distanceSlope(const CurvePiece& piece, const glm::dvec2& place) {
    static constexpr double kOf3[] = {1, 3, 3, 1}, kOf2[] = {1, 2, 1}, kOf5[] = {1, 5, 10, 10, 5, 1};
    Quintic q{};
    for (size_t i = 0; i < 4; ++i)
        for (size_t j = 0; j < 3; ++j)
            q[i + j] += kOf3[i] * kOf2[j] / kOf5[i + j] *
                        glm::dot(piece.bezier[i] - place, piece.bezier[j + 1] - piece.bezier[j]);
    return q;
}

double distanceToBox(const CurvePiece& piece, const glm::dvec2& place) {
    glm::dvec2 low = piece.bezier[0], high = low;
    for (const glm::dvec2& p : piece.bezier) low = glm::min(low, p), high = glm::max(high, p);
    return glm::length(glm::max(glm::max(low - place, place - high), glm::dvec2(0)));
}

// --- the row -----------------------------------------------------------------------------------------------------

constexpr FieldRow kPointFields[] = {
    text("name", offsetof(PathPoint, name), "what this point is called; none: its number"),
    number(FieldType::Vec2, "at", offsetof(PathPoint, at), "m", kPosition,
           "where it lies, along x and z from the terrain's corner"),
};
constexpr ListRow kPointList = listRow<PathPoint>(kPointFields);
constexpr FieldRow kFields[] = {
    flag("closed", offsetof(GroundPath, closed), "the last point leads back to the first"),
    real("width", offsetof(GroundPath, width), "m", {0, 1e5, 0.2, 10}, "across, where it has its full effect"),
    real("falloff", offsetof(GroundPath, falloff), "m", {0, 1e5, 0, 5},
         "beside its width, over which its effect fades; 0: an edge"),
    real("grass", offsetof(GroundPath, grass), "", {-1, 1, -1, 1},
         "-1: no grass grows on it; 0: as painted; 1: as dense as a full map"),
    real("flowers", offsetof(GroundPath, flowers), "", {-1, 1, -1, 1},
         "-1: no flowers grow on it; 0: as painted; 1: as dense as a full map"),
    real("tint", offsetof(GroundPath, tint), "", kShare, "share of its colour over the ground's own; 0: none"),
    color("color", offsetof(GroundPath, color), kReflectance, "reflectance of the tinted ground"),
    under("Points",
          listOf("points", offsetof(GroundPath, points), &kPointList, "places that the path passes, in order")),
};

void checkPath(const Registry& registry, Entity e, const std::string& path, std::vector<ComponentFault>& out) {
    const size_t knots = knotsOf(*registry.get<GroundPath>(e)).size();
    if (knots == 0)
        out.push_back({"points",
                       path + ".points: there is none, and so no path; draw it with the path tool, or remove "
                              "the component",
                       true});
    if (knots == 1)
        out.push_back({"points", path + ".points: all lie at one place, where the path is a round spot; add another"});
}

}  // namespace

ComponentRow groundPathRow() {
    ComponentRow row = componentRow<GroundPath>("GroundPath", "A path over the ground: what grows there gives way.",
                                                kFields, [](const void*) { return FeatureSet{}; });
    row.check = checkPath;
    return row;
}

GroundCurve groundCurve(const GroundPath& path) {
    const std::vector<Knot> knots = knotsOf(path);
    const size_t n = knots.size();
    GroundCurve out{{}, path.closed && n > 1};
    if (n == 1) out.pieces.push_back({{knots[0].at, knots[0].at, knots[0].at, knots[0].at}, knots[0].point});
    const auto at = [&](size_t i) { return knots[i % n].at; };
    const auto slope = [&](size_t i) {
        const bool first = !out.closed && i == 0, last = !out.closed && i + 1 == n;
        const glm::dvec2 here = at(i), before = first ? here : at(i + n - 1), after = last ? here : at(i + 1);
        return overhauserSlope(span(before, here), rate(before, here), span(here, after), rate(here, after));
    };
    for (size_t i = 0; i + (out.closed ? 0 : 1) < n && n > 1; ++i) {
        const double third = span(at(i), at(i + 1)) / 3;
        out.pieces.push_back(
            {{at(i), at(i) + third * slope(i), at(i + 1) - third * slope((i + 1) % n), at(i + 1)}, knots[i].point});
    }
    return out;
}

glm::dvec2 placeOn(const CurvePiece& piece, double t) {
    const double u = 1 - t;
    const auto& b = piece.bezier;
    return u * u * u * b[0] + 3 * u * u * t * b[1] + 3 * u * t * t * b[2] + t * t * t * b[3];
}
glm::dvec2 slopeOn(const CurvePiece& piece, double t) {
    const double u = 1 - t;
    const auto& b = piece.bezier;
    return 3 * u * u * (b[1] - b[0]) + 6 * u * t * (b[2] - b[1]) + 3 * t * t * (b[3] - b[2]);
}

NearestOnCurve nearestOn(const GroundCurve& curve, const glm::dvec2& place, double reach) {
    NearestOnCurve best;
    if (!finite(place)) return best;
    double least = reach;
    for (size_t i = 0; i < curve.pieces.size(); ++i) {
        const CurvePiece& piece = curve.pieces[i];
        if (!(distanceToBox(piece, place) < least)) continue;
        const auto offer = [&](double t) {
            const glm::dvec2 at = placeOn(piece, t);
            const double d = lengthOf(at - place);
            if (d < least) best = {d, at, i, t}, least = d;
        };
        offer(0), offer(1);
        eachRise(distanceSlope(piece, place), 0, 1, 0, offer);
    }
    return best;
}

double reachOf(const GroundPath& path) { return 0.5 * double(path.width) + double(path.falloff); }
double weightAt(const GroundPath& path, double distance) {
    const double beside = distance - 0.5 * double(path.width);
    if (!(distance < INFINITY)) return 0;
    if (beside <= 0) return 1;
    if (beside >= double(path.falloff)) return 0;
    const double s = 1 - beside / double(path.falloff);
    return s * s * (3 - 2 * s);
}
double weightAt(const GroundPath& path, const GroundCurve& curve, const glm::dvec2& place) {
    // A bit more than its reach: what lies exactly at an edge counts.
    return weightAt(path, nearestOn(curve, place, reachOf(path) * (1 + 1e-12) + 1e-300).distance);
}

GroundBox boxOf(const GroundCurve& curve, double beside) {
    GroundBox box;
    for (const CurvePiece& piece : curve.pieces)
        for (const glm::dvec2& p : piece.bezier)
            box.low = glm::min(box.low, p - beside), box.high = glm::max(box.high, p + beside);
    return box;
}

std::vector<CurveStation> stationsOn(const GroundCurve& curve, int chords) {
    std::vector<CurveStation> out;
    if (curve.pieces.empty()) return out;
    out.push_back({curve.pieces.front().bezier[0], 0});
    for (const CurvePiece& piece : curve.pieces)
        for (int i = 1; i <= chords; ++i) {
            const glm::dvec2 at = placeOn(piece, double(i) / chords);
            const double metres = out.back().metres + lengthOf(at - out.back().at);
            if (metres > out.back().metres) out.push_back({at, metres});
        }
    return out;
}
glm::dvec2 placeAlong(const std::vector<CurveStation>& stations, double metres) {
    const auto after = std::upper_bound(stations.begin(), stations.end(), metres,
                                        [](double m, const CurveStation& s) { return m < s.metres; });
    if (after == stations.begin()) return stations.front().at;
    if (after == stations.end()) return stations.back().at;
    const CurveStation &a = after[-1], &b = *after;
    return glm::mix(a.at, b.at, (metres - a.metres) / (b.metres - a.metres));
}

}  // namespace sward
