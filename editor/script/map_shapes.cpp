#include "script/map_shapes.h"

#include <cmath>

#include "script/texel_edit.h"

namespace sward {
namespace {

double segmentDistance(const ShapePoint& a, const ShapePoint& b, double x, double z) {
    const double dx = b.first - a.first, dz = b.second - a.second;
    const double t = ((x - a.first) * dx + (z - a.second) * dz) / std::max(dx * dx + dz * dz, 1e-30);
    const double s = std::clamp(t, 0.0, 1.0);
    return std::hypot(x - a.first - s * dx, z - a.second - s * dz);
}

double outlineDistance(const std::vector<ShapePoint>& points, bool closed, double x, double z) {
    if (points.size() == 1) return std::hypot(x - points[0].first, z - points[0].second);
    double nearest = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i + 1 < points.size(); ++i)
        nearest = std::min(nearest, segmentDistance(points[i], points[i + 1], x, z));
    if (closed) nearest = std::min(nearest, segmentDistance(points.back(), points.front(), x, z));
    return nearest;
}

// By the number of edges that a ray towards +x crosses.
bool isWithin(const std::vector<ShapePoint>& points, double x, double z) {
    bool inside = false;
    for (size_t i = 0, j = points.size() - 1; i < points.size(); j = i++) {
        const auto& [ax, az] = points[i];
        const auto& [bx, bz] = points[j];
        if ((az > z) != (bz > z) && x < (bx - ax) * (z - az) / (bz - az) + ax) inside = !inside;
    }
    return inside;
}

double rectDistance(const Shape& s, double x, double z) {
    const auto& [x0, z0] = s.points[0];
    const auto& [x1, z1] = s.points[1];
    const double dx = std::abs(x - (x0 + x1) / 2) - std::abs(x1 - x0) / 2;
    const double dz = std::abs(z - (z0 + z1) / 2) - std::abs(z1 - z0) / 2;
    return std::hypot(std::max(dx, 0.0), std::max(dz, 0.0)) + std::min(std::max(dx, dz), 0.0);
}

double discDistance(const Shape& s, double x, double z) {
    const double r = std::hypot(x - s.points[0].first, z - s.points[0].second);
    return s.inner > 0 ? std::max(r - s.radius, s.inner - r) : r - s.radius;
}

float blend(BlendMode mode, float old, float value, float c) {
    switch (mode) {
        case BlendMode::Set:
            return old + (value - old) * c;
        case BlendMode::Add:
            return old + value * c;
        case BlendMode::Multiply:
            return old * (1 + (value - 1) * c);
        case BlendMode::Max:
            return old + (std::max(value, old) - old) * c;
        case BlendMode::Min:
            return old + (std::min(value, old) - old) * c;
    }
    return old;
}

struct Bounds {
    double x0 = 1e300, z0 = 1e300, x1 = -1e300, z1 = -1e300;
};
Bounds boundsOf(const Shape& s, double grow) {
    Bounds b;
    for (const auto& [x, z] : s.points)
        b = {std::min(b.x0, x), std::min(b.z0, z), std::max(b.x1, x), std::max(b.z1, z)};
    if (s.kind == ShapeKind::Disc) grow += s.radius;
    if (s.kind == ShapeKind::Polyline) grow += s.width / 2;
    return {b.x0 - grow, b.z0 - grow, b.x1 + grow, b.z1 + grow};
}
TexelRect texelsOf(const Bounds& b, const MapInfo& info, double dx, double dz) {
    const auto texel = [](double at, double size, int most) {
        return static_cast<int>(std::clamp(at / size, 0.0, double(most)));
    };
    return {texel(b.x0, dx, info.width), texel(b.z0, dz, info.height), texel(b.x1 + dx, dx, info.width),
            texel(b.z1 + dz, dz, info.height)};
}

// A tile's part of a shape: of a line or outline only the edges that may be the nearest to one of its texels, so that a
// long path costs what its length does.
struct Piece {
    TexelRect rect;
    std::vector<std::pair<ShapePoint, ShapePoint>> edges;
    bool drawn = true;  // false: the shape does not reach it
};

bool hasEdges(const Shape& s) { return s.kind == ShapeKind::Polyline || s.kind == ShapeKind::Polygon; }

Piece pieceOf(const Shape& s, const TexelRect& rect, double dx, double dz, double fade) {
    Piece piece{rect, {}, true};
    if (!hasEdges(s)) return piece;
    const double x = (rect.x0 + rect.x1) * dx / 2, z = (rect.y0 + rect.y1) * dz / 2;
    const double reach = std::hypot((rect.x1 - rect.x0) * dx, (rect.y1 - rect.y0) * dz) / 2 + s.width / 2 + fade;
    const size_t n = s.points.size(), edges = s.kind == ShapeKind::Polygon || s.closed ? n : std::max<size_t>(n - 1, 1);
    for (size_t i = 0; i < edges; ++i) {
        const ShapePoint &a = s.points[i], &b = s.points[(i + 1) % n];
        if (segmentDistance(a, b, x, z) <= reach) piece.edges.emplace_back(a, b);
    }
    piece.drawn = !piece.edges.empty() || (s.kind == ShapeKind::Polygon && isWithin(s.points, x, z));
    return piece;
}

double pieceDistance(const Shape& s, const Piece& piece, double x, double z) {
    if (!hasEdges(s)) return shapeDistance(s, x, z);
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : piece.edges) nearest = std::min(nearest, segmentDistance(a, b, x, z));
    if (s.kind == ShapeKind::Polyline) return nearest - s.width / 2;
    return isWithin(s.points, x, z) ? -nearest : nearest;
}

struct Texel {
    double x, z;  // its sides
    double fade;  // over which the edge goes from 1 to 0
    bool soft;    // as asked for, in an S; else only antialiased
};

// The share of [a, b] that lies within [low, high].
double overlap(double a, double b, double low, double high) {
    return std::max(0.0, std::min(b, high) - std::max(a, low)) / (b - a);
}

// Share of the texel around (x, z) that the shape covers: exact for hard rectangles, else by the distance of its
// centre.
double coverage(const Shape& s, const Piece& piece, const Texel& texel, double x, double z) {
    if (s.kind == ShapeKind::Rect && !texel.soft) {
        const auto [x0, x1] = std::minmax(s.points[0].first, s.points[1].first);
        const auto [z0, z1] = std::minmax(s.points[0].second, s.points[1].second);
        return overlap(x - texel.x / 2, x + texel.x / 2, x0, x1) * overlap(z - texel.z / 2, z + texel.z / 2, z0, z1);
    }
    const double t = std::clamp(0.5 - pieceDistance(s, piece, x, z) / texel.fade, 0.0, 1.0);
    if (texel.soft) return t * t * (3 - 2 * t);
    if (s.kind != ShapeKind::Polyline || s.width >= texel.fade) return t;
    return t * 4 * s.width * texel.fade /
           ((s.width + texel.fade) * (s.width + texel.fade));  // a line thinner than a texel
}

}  // namespace

double shapeDistance(const Shape& s, double x, double z) {
    switch (s.kind) {
        case ShapeKind::Disc:
            return discDistance(s, x, z);
        case ShapeKind::Rect:
            return rectDistance(s, x, z);
        case ShapeKind::Polyline:
            return outlineDistance(s.points, s.closed, x, z) - s.width / 2;
        case ShapeKind::Polygon:
            break;
    }
    const double edge = outlineDistance(s.points, true, x, z);
    return isWithin(s.points, x, z) ? -edge : edge;
}

size_t drawShape(Map& map, double width, double depth, const Shape& shape, const ShapePaint& paint) {
    const MapInfo info = map.info();
    const double dx = width / info.width, dz = depth / info.height, texel = std::sqrt(dx * dz);
    const double fade = std::max(paint.soft, texel);
    std::vector<Piece> pieces;
    std::vector<TexelRect> rects;
    size_t texels = 0;
    for (const TexelRect& r : tilePieces(texelsOf(boundsOf(shape, fade / 2), info, dx, dz))) {
        Piece piece = pieceOf(shape, r, dx, dz, fade);
        if (!piece.drawn) continue;
        texels += r.count() * (1 + piece.edges.size());
        rects.push_back(r);
        pieces.push_back(std::move(piece));
    }
    const Texel size{dx, dz, fade, paint.soft > texel};
    editPieces(map, rects, [&](size_t i, int x, int y, float* values) {
        const auto c =
            static_cast<float>(paint.opacity * coverage(shape, pieces[i], size, (x + 0.5) * dx, (y + 0.5) * dz));
        if (c <= 0) return;
        for (int k = 0; k < info.channels; ++k) values[k] = blend(paint.mode, values[k], paint.value[size_t(k)], c);
    });
    return texels;
}

}  // namespace sward
