// How a patch, which holds whole blades, stands for any number of blades a cell: which of its blades a cell has is
// decided by a random number of the cell, its chance, so that cells have as many in the mean as are asked for, however
// few (J-9; systematic sampling, Madow and Madow 1944). Thresholds stay numbers of 255, as slices store them exactly.

#ifndef __cplusplus
#include "numerics/basics.h"
#include "numerics/glsl.h"
#include "numerics/hash.h"
#endif

const int kThresholds = 255;
// Whole numbers from here on need no chance: rounding to whole blades adds less than one to a cell, where density is
// painted, and nothing where it is 1.
const real kEvenBlades = real(128.0);

struct Sown {
    real spread;  // factor of the patch's thresholds
    real step;    // what a chance of 1 takes off them; 0: all cells have the same blades
    real share;   // of the patch's blades that a cell has at density 1
};

// Whether a cell is asked for a whole number of blades, but for rounding.
FN bool isWholeBlades(real expected) {
    return abs(expected - floor(expected + 0.5f)) <= max(expected, real(0.0)) * real(1e-6);
}
// Blades of the patch of cells that have `expected` at density 1: 0 to 2^24.
FN int sownBlades(real expected) {
    return int(isWholeBlades(expected) ? floor(expected + 0.5f) : ceil(max(expected, real(0.0))));
}
FN bool isSownEvenly(real expected) { return isWholeBlades(expected) && expected > kEvenBlades - 0.5f; }

// Blades share a threshold where there are more of them than thresholds; else thresholds are `thresholdStep` apart.
FN int thresholdClasses(int blades) { return blades < kThresholds ? max(blades, 1) : kThresholds; }
FN int thresholdStep(int blades) { return kThresholds / thresholdClasses(blades); }

FN Sown sownEvenly() {
    Sown s;
    s.spread = real(1.0);
    s.step = real(0.0);
    s.share = real(1.0);
    return s;
}
FN Sown sownOf(real expected) {
    Sown s = sownEvenly();
    if (!(expected > 0.0f) || isSownEvenly(expected)) return s;
    int blades = sownBlades(expected);
    int classes = thresholdClasses(blades);
    // Of the last class a cell has as many as are left to it.
    real before = classes < kThresholds ? real(classes - 1) : ceil(real(blades) * (real(classes - 1) / real(classes)));
    real left = isWholeBlades(expected) ? real(1.0) : (expected - before) / (real(blades) - before);
    real whole = max(real(classes - 1) + left, kTiny);
    s.spread = real(kThresholds) / (real(thresholdStep(blades)) * whole);
    s.step = 1.0f / whole;
    s.share = whole / real(classes);
    return s;
}

// A cell's chance, in [0, 1[. seed: of the species in its field.
FN real cellChance(int cellX, int cellZ, uint seed) { return hashUnit(cellHash(cellX, cellZ, seed)); }

// The threshold of a patch's blade in a cell of this chance; above 0, and beyond 1 where density 1 does not bring it.
FN real thresholdIn(real threshold, Sown s, real chance) {
    precise real t = threshold * s.spread;
    precise real here = t - chance * s.step;
    return max(here, min(threshold, real(1e-6)));
}
