// What makes one blade of a repeated patch differ from its copies, and what colour it has: the part of the population
// that is not in the patch. Every technique and the reference pose and colour blades by these lines.

#ifndef __cplusplus
#include "numerics/basics.h"
#include "numerics/glsl.h"
#include "numerics/hash.h"
#endif

// Which version of the patch a cell is: mirrored (Boulanger, Pattanaik and Bouatouch 2006, section 3.1), and begun
// elsewhere. Four mirrored versions alone make every fourth pair of cells equal, which shows as a lattice from afar;
// these are a hundred. The patch goes on at its far edge with its near one, as its images do. Fifths, whatever a
// technique's slices: which blades exist must not hang on how they are drawn. Slices by fives stay whole; others are
// shown up to half their distance aside.
const int kPatchStarts = 5;
struct CellVersion {
    vec2 mirror;  // +1 or -1
    vec2 shift;   // in cells: k/5, k in 0..4
};
FN CellVersion cellVersion(int cellX, int cellZ, uint seed) {
    uint h = cellHash(cellX, cellZ, seed);
    CellVersion v;
    v.mirror = cellMirror(h);
    v.shift =
        vec2(real((((h >> 2) & 0x7FFFu) * uint(kPatchStarts)) >> 15), real(((h >> 17) * uint(kPatchStarts)) >> 15)) /
        real(kPatchStarts);
    return v;
}
// Where in its cell a blade stands whose root in the patch is `root`, both in [0, cellSize].
FN vec2 rootInCell(vec2 root, vec2 mirror, vec2 shift, real cellSize) {
    vec2 at = root + shift * cellSize;
    at = vec2(at.x < cellSize ? at.x : at.x - cellSize, at.y < cellSize ? at.y : at.y - cellSize);
    return vec2(mirror.x < 0.0f ? cellSize - at.x : at.x, mirror.y < 0.0f ? cellSize - at.y : at.y);
}
// The inverse, in cells, for images that repeat: within ]-1, 1].
FN vec2 placeInPatch(vec2 inCell, vec2 mirror, vec2 shift) {
    return vec2(mirror.x < 0.0f ? 1.0f - inCell.x : inCell.x, mirror.y < 0.0f ? 1.0f - inCell.y : inCell.y) - shift;
}

struct BladePose {
    vec3 control;  // relative to the root, metres
    vec3 tip;
    vec2 facing;   // unit, horizontal: its own azimuth, mirrored; its width runs across it (numerics/blade.h)
    vec3 upright;  // what takes the place's lean off again (stoodUp)
};

// Where a point relative to the blade's root, or a direction, would be had the place not leant the blade: the linear
// map that takes its tip back, or, of one that curls, its bow. Neighbours lean as it does, nearly; and a ray meets the
// same of them when all are sheared together with it. So light among leaning blades is looked up as that among upright
// ones, in the direction that the map gives.
FN vec3 stoodUp(vec3 p, vec3 upright) { return vec3(p.x - upright.x * p.y, p.y * upright.y, p.z - upright.z * p.y); }

// A patch's blade in a cell: mirrored, scaled, and leant by `lean` (horizontal metres per metre of blade, on top of its
// own). The distance from root to tip is kept, so that a leaning blade comes down instead of growing; the tip stays at
// least a twentieth of it above the root. What leans a blade does not twist it: it faces as it did, so that neighbours
// face all ways whatever blows, and the curve may leave the plane of its azimuth.
FN BladePose poseBlade(vec3 control, vec3 tip, vec2 facing, vec2 mirror, vec2 lean, real scale) {
    vec3 c = vec3(control.x * mirror.x, control.y, control.z * mirror.y) * scale;
    vec3 t = vec3(tip.x * mirror.x, tip.y, tip.z * mirror.y) * scale;
    real size2 = dot(t, t);
    real size = sqrt(size2);
    BladePose p;
    vec2 reach = vec2(t.x, t.z) + lean * size;
    real reach2 = min(dot(reach, reach), size2 * real(0.9975));
    reach = reach * sqrt(reach2 / max(dot(reach, reach), kTiny));
    real height = sqrt(max(size2 - reach2, real(0.0)));
    p.tip = vec3(reach.x, height, reach.y);
    vec2 shift = (reach - vec2(t.x, t.z)) * real(0.5);
    // Lowered in proportion; raised by half, as the middle of a straight one is: in proportion, one that lay almost
    // flat would shoot up.
    real lowered = c.y * height / max(t.y, size * real(0.05) + kTiny), raised = c.y + (height - t.y) * real(0.5);
    p.control = vec3(c.x + shift.x, min(lowered, raised), c.z + shift.y);
    // A tip that hangs lower than the bow behind it says nothing of how high its blade stands.
    real high = max(max(height, p.control.y), size * real(0.05) + kTiny);
    p.upright = vec3(real(2.0) * shift.x / high, max(t.y, c.y) / high, real(2.0) * shift.y / high);
    p.facing = vec2(facing.x * mirror.x, facing.y * mirror.y);
    return p;
}

// Root to tip: dark and yellowish below, saturated in the middle, lighter at the tip.
FN vec3 bladeGradient(vec3 root, vec3 middle, vec3 tip, real v) {
    return v < 0.5f ? mix(root, middle, v * 2.0f) : mix(middle, tip, v * 2.0f - 1.0f);
}

// Colours at the rows of a strip of so many quads of equal height show less of the middle's colour than the gradient
// does, unless a row lies in the middle: share of the middle's colour, over the mean of root's and tip's, that their
// mean lacks. One quad has none of it.
FN real middleLacked(int quads) { return (quads & 1) == 1 ? real(0.5) / real(quads * quads) : real(0.0); }
// bladeGradient at a row, with what rows lack.
FN vec3 bladeGradientRow(vec3 root, vec3 middle, vec3 tip, real v, real lacked) {
    return bladeGradient(root, middle, tip, v) + (middle - (root + tip) * real(0.5)) * lacked;
}

// The colour turned by hue (radians, small) around the grey axis and scaled; never negative.
FN vec3 bladeTint(vec3 color, real hue, real lightness) {
    real k = real(0.57735026918962576);
    vec3 turned = vec3(color.z - color.y, color.x - color.z, color.y - color.x) * (k * hue);
    return max((color + turned) * lightness, vec3(real(0.0), real(0.0), real(0.0)));
}

// Painted direction of a texel of the orientation map (0.5 is none), its length the strength in [0, 1]; what is shorter
// than half a step of eight bits counts as not painted.
FN vec2 paintOf(real x, real z) {
    vec2 d = vec2(x - 0.5f, z - 0.5f) * real(2.0);
    real size = sqrt(dot(d, d));
    return size < real(1.0 / 255.0) ? vec2(real(0.0), real(0.0)) : d / max(size, real(1.0));
}
