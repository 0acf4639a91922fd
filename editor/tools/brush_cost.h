// What painting adds: blades under the brush, blades that a stroke brought or took, and about how many ms a frame that
// is. Does not: paint or draw. Cost: the texels under the brush (at most some 10,000), and 0.1 ms a tile that the
// stroke has changed.
#pragma once
#include <optional>

#include "maps/map.h"
#include "tools/stroke.h"

namespace sward {

class Document;
struct BrushBook;
struct FrameStats;

// Blades that came and that went; both from 0 up.
struct BladeChange {
    double added = 0, removed = 0;
    double sum() const { return added - removed; }
};
struct BrushCost {
    std::optional<double> under;        // blades; nothing: no density is painted, or the pointer is elsewhere
    std::optional<BladeChange> stroke;  // of the present or last stroke, all species that it paints; nothing: it paints
                                        // no density, or something else was edited since
    double grassMs = 0;                 // of the last measured frame's grass; 0: none was measured
    uint64_t revision = ~uint64_t(0);   // that the stroke was counted for
};
// Once a frame. `ground`: the world point under the pointer, if there is one; `measured`: the last drawing if its
// passes were timed, else null.
void followBrushCost(BrushCost& cost, const Document& document, BrushBook& brushes,
                     const std::optional<glm::dvec3>& ground, const FrameStats* measured);
// "+0.4 ms": the measured grass's time times the share by which the blades in view grow. Nothing without a measured
// frame or a stroke, or with no blades in view.
std::optional<double> strokeMs(const BrushCost& cost, uint64_t bladesInView);

// Blades that grow within a disc on the terrain, in metres: density x bladesPerM2 over the texels whose centres lie in
// it. An empty map is density 1. Large discs are sampled at every second, third ... texel.
double bladesInDisc(const Map& density, double bladesPerM2, const MapScale& scale, double x, double z, double radius);
// Blades that `now` has and `before` had not, and the other way round; only tiles that differ are read. Of a map that
// repeats those of one repeat. Maps of different shape: nothing.
BladeChange bladesChanged(const Map& before, const Map& now, double bladesPerM2, const MapScale& scale);

}  // namespace sward
