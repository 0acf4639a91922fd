// Brushes: a pure function from a tile, a stamp and parameters to a tile; one row a mode.
// Does not: keep state, undo, or know the scene; strokes are turned into stamps by stampsAlong.
// Hard case T-7: zero radius paints nothing; a stroke of zero length is one stamp; zero strength is the identity.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scene/map.h"

namespace sward {

struct BrushSettings {
    std::string map = "density";    // a map's PATH or an unambiguous tail of it
    std::string mode = "add";       // a row's name
    float radius = 1;               // metres
    float strength = 1;             // [0,1]: share of the full effect that a stamp has at its centre
    float value = 1;                // what set paints towards
    float falloff = 0.5f;           // 0: hard edge; 1: falls off from the centre
    float spacing = 0.1f;           // distance between stamps as a share of the diameter
    int seed = 0;                   // of noise
};

// In texels of the map; radiusX != radiusY where texels are not square.
struct Stamp {
    double x, y;
    double radiusX, radiusY;
};

struct BrushRow {
    const char* name;   // "add"
    const char* label;  // "Add"
    const char* help;
    // Reads `map` as it was before the stamp (smooth needs neighbours) and returns the new tile, or the old pointer if
    // nothing changed. Density stays in [0,1] and finite.
    std::shared_ptr<const Tile> (*apply)(const Map& map, int tx, int ty, const Stamp& stamp, const BrushSettings& brush);
};
std::span<const BrushRow> brushRows();
const BrushRow* findBrush(const std::string& name);

// Stamp centres along a line of points (metres), beginning with the first point; `carry` keeps the distance left over,
// so that a stroke cut into pieces gives the same stamps as a whole one.
std::vector<std::pair<double, double>> stampsAlong(std::span<const std::pair<double, double>> points, double step, double& carry);

// Applies one stamp to every tile it touches, on all cores.
void applyStamp(Map& map, const BrushRow& row, const Stamp& stamp, const BrushSettings& brush);

}  // namespace sward
