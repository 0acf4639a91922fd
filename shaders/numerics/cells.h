// Which cells of a field's grid draw blades, and which of their blades: the same bits on CPU and GPU, so that either
// may choose. Lengths are metres, places are relative to the eye. Every rounding is monotone: what holds a cell's box
// passes what it passes.

#ifndef __cplusplus
#include "numerics/glsl.h"
#include "numerics/lod.h"
#include "numerics/opacity.h"
#include "numerics/tess.h"
#endif

struct CellGrid {
    vec2 eyeCell;  // the cell that the eye is over: whole numbers below 2^24
    vec2 inCell;   // where in it
    vec2 edge;     // where the terrain ends
    real size;     // of a cell
};
struct CellBox {
    vec3 low;
    vec3 high;
};

// Where cell number `cell` of a row begins.
FN real cellStart(int cell, real eyeCell, real inCell, real size) {
    precise real at = real(cell - int(eyeCell)) * size;
    precise real start = at - inCell;
    return start;
}
FN vec2 cellCorner(CellGrid g, int x, int z) {
    return vec2(cellStart(x, g.eyeCell.x, g.inCell.x, g.size), cellStart(z, g.eyeCell.y, g.inCell.y, g.size));
}
// The box of `cells` x `cells` cells on ground between two heights.
FN CellBox cellBox(CellGrid g, int x, int z, int cells, real low, real high) {
    vec2 from = cellCorner(g, x, z);
    vec2 to = cellCorner(g, x + cells, z + cells);
    CellBox b;
    b.low = vec3(from.x, low, from.y);
    b.high = vec3(min(to.x, g.edge.x), high, min(to.y, g.edge.y));
    return b;
}

// Cells are chosen by nodes of kNodeSide x kNodeSide. Number i of its cells, from the side of the eye.
const int kNodeSide = 8;
FN ivec2 nodeCell(CellGrid g, int x, int z, int i) {
    vec2 middle = cellCorner(g, x + kNodeSide / 2, z + kNodeSide / 2);
    int column = i % kNodeSide;
    int row = i / kNodeSide;
    return ivec2(x + (middle.x < 0.0f ? kNodeSide - 1 - column : column),
                 z + (middle.y < 0.0f ? kNodeSide - 1 - row : row));
}

// Squares of the distances from the eye to the box's nearest point, 0 inside, and to its farthest.
FN real boxNearest2(CellBox b) {
    real x = max(max(b.low.x, -b.high.x), real(0.0));
    real y = max(max(b.low.y, -b.high.y), real(0.0));
    real z = max(max(b.low.z, -b.high.z), real(0.0));
    precise real d = x * x + y * y + z * z;
    return d;
}
FN real boxFarthest2(CellBox b) {
    real x = max(abs(b.low.x), abs(b.high.x));
    real y = max(abs(b.low.y), abs(b.high.y));
    real z = max(abs(b.low.z), abs(b.high.z));
    precise real d = x * x + y * y + z * z;
    return d;
}

// Whether any of what reaches `reach` beyond the box and above it is on the inner side of a plane (normal inwards,
// distance); and whether all of it is.
FN real planeSide(vec4 plane, vec3 p) {
    precise real d = plane.x * p.x + plane.y * p.y + plane.z * p.z + plane.w;
    return d;
}
FN bool boxTouches(vec4 plane, CellBox b, real reach) {
    vec3 p = vec3(plane.x > 0.0f ? b.high.x + reach : b.low.x - reach, plane.y > 0.0f ? b.high.y + reach : b.low.y,
                  plane.z > 0.0f ? b.high.z + reach : b.low.z - reach);
    return planeSide(plane, p) >= 0.0f;
}
FN bool boxWithin(vec4 plane, CellBox b, real reach) {
    vec3 p = vec3(plane.x > 0.0f ? b.low.x - reach : b.high.x + reach, plane.y > 0.0f ? b.low.y : b.high.y + reach,
                  plane.z > 0.0f ? b.low.z - reach : b.high.z + reach);
    return planeSide(plane, p) >= 0.0f;
}

// The texels of a density map that bilinear samples within a cell read, of `texels` in a row; a little more for
// rounding.
struct CellTexels {
    int first;
    int last;
};
FN CellTexels cellTexels(int cell, real texelsPerCell, int texels) {
    precise real from = real(cell) * texelsPerCell;
    precise real to = real(cell + 1) * texelsPerCell;
    CellTexels t;
    t.first = clamp(int(floor(from - 0.5f - real(0.004))), 0, texels - 1);
    t.last = clamp(int(floor(to - 0.5f + real(0.004))) + 1, 0, texels - 1);
    return t;
}

// How blades of a cell are chosen, by its nearest distance and the least and most density in it.
struct CellRule {
    real fade;  // omega of numerics/opacity.h
    Thinning thinning;
    real rangeMin;  // as lodRamp takes them
    real rangeInv;
    real unspread;  // 1 / Sown.spread; chances take off Sown.step * unspread
    real unstep;
};
// The thresholds of its blades that may be drawn, as numbers of 0 to 255: above `low`, up to `high`.
struct CellShare {
    int low;
    int high;
};
FN int thresholdNumber(real t) { return int(clamp(floor(t * 255.0f), real(0.0), real(255.0))); }
// The patch's threshold that is t in a cell of this chance (thresholdIn).
FN real patchThreshold(CellRule r, real t, real chance) {
    precise real own = t * r.unspread;
    precise real here = own + chance * r.unstep;
    return here;
}
FN CellShare cellShare(CellRule r, real nearest, real least, real most, real chance) {
    real slices = sliceDensity(least, lodRamp(nearest, r.rangeMin, r.rangeInv));
    CellShare s;
    real low = lowestThresholdDrawn(slices, r.fade) - real(1e-5);
    real high = highestThresholdDrawn(densityKept(most, nearest, r.thinning), r.fade) + real(1e-5);
    s.low = thresholdNumber(patchThreshold(r, low, chance));
    s.high = thresholdNumber(patchThreshold(r, high, chance));
    return s;
}

// Quads that a strip needs so as to leave its curve by at most half a pixel: a quadratic curve cut into n chords leaves
// them by its sagitta / n^2. Two at least: one is lit by its ends alone, and shows a twentieth more light than two.
// sagittaPixels: of the sagitta at 1 m.
FN int chordQuads(real sagittaPixels, real distance, int most) {
    real pixels = sagittaPixels / max(distance, real(0.05));
    return clamp(int(ceil(sqrt(pixels / real(0.5)))), min(2, most), most);
}
