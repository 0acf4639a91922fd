// Shapes drawn into maps with soft or antialiased edges: discs and rings, rectangles, polygons, lines of a width.
// Does not: know undo or Lua. Lengths in metres; the map covers [0, width] by [0, depth].
#pragma once
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "maps/map.h"

namespace sward {

using ShapePoint = std::pair<double, double>;  // x, z

enum class ShapeKind { Disc, Rect, Polygon, Polyline };
struct Shape {
    ShapeKind kind = ShapeKind::Disc;
    std::vector<ShapePoint> points;  // Disc: its centre; Rect: two corners; else the outline or line
    double radius = 1;               // Disc
    double inner = 0;                // Disc: what is within is left out; 0: nothing
    double width = 1;                // Polyline: of the line, its ends round
    bool closed = false;             // Polyline: back to its beginning
};

enum class BlendMode { Set, Add, Multiply, Max, Min };
struct ShapePaint {
    std::array<float, 4> value{1, 1, 1, 1};
    BlendMode mode = BlendMode::Set;
    double opacity = 1;  // [0,1]
    double soft = 0;     // metres over which the edge fades, half of them inside; 0: antialiased
};

// How far a point lies outside the shape's edge; negative inside.
double shapeDistance(const Shape& shape, double x, double z);
// With c = opacity times coverage: Set mixes value to value by c, Add adds value c, Multiply multiplies by 1 + (value -
// 1) c, Max and Min mix by c towards the greater or smaller of both. Returns how many distances it took.
size_t drawShape(Map& map, double width, double depth, const Shape& shape, const ShapePaint& paint);

}  // namespace sward
