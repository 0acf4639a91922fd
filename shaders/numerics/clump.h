// Clumps: slow variation over a field, as value noise on a lattice of integers. The lattice is addressed by cell id and
// local position in 16.16 fixed point, so that cell 180,000 is as precise as cell 0 and neighbouring cells meet
// exactly.

#ifndef __cplusplus
#include "numerics/basics.h"
#include "numerics/glsl.h"
#include "numerics/hash.h"
#endif

// One axis of a lattice point: the 16-bit lattice id and where between it and the next the point lies.
struct ClumpAxis {
    uint id;
    real fraction;  // in [0, 1]
};

// stepsPerCell: clumps per cell in 1/65536. Multiplication wraps at 2^32, which is lattice id 65536: the noise repeats
// after 65,536 clumps, without a seam.
FN ClumpAxis clumpAxis(int cell, real localInCells, uint stepsPerCell) {
    real steps = localInCells * real(stepsPerCell);
    real whole = floor(steps);
    uint position = uint(cell) * stepsPerCell + uint(int(whole));
    ClumpAxis a;
    a.id = position >> 16;
    a.fraction = (real(position & 0xFFFFu) + (steps - whole)) * real(1.52587890625e-5);
    return a;
}

// Three independent values in [-1, 1] of lattice point (x, z), ten bits each.
FN vec3 clumpLattice(uint x, uint z, uint seed) {
    uint h = hash3(x & 0xFFFFu, z & 0xFFFFu, seed);
    vec3 bits = vec3(real(h & 1023u), real((h >> 10) & 1023u), real((h >> 20) & 1023u));
    return bits * real(0.0019550342130987293) - vec3(real(1.0), real(1.0), real(1.0));
}

// Fade with zero slope and curvature at both ends, so that the lattice does not show as creases.
FN real clumpFade(real t) { return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f); }

// Three independent smooth values in [-1, 1] (lean along x, lean along z, height or tint) at cell * cellSize + local.
// cellSize, clumpSize: metres, above 0. local: metres from the cell's corner; it may lie a little outside the cell.
// Clumps are rounded to a 65536th of a cell's share: their true size is cellSize * 65536 / n with n a whole number up
// to 2^24, so that a clump is never smaller than a 256th of a cell.
FN vec3 clumpValues(int cellX, int cellZ, vec2 local, real cellSize, real clumpSize, uint seed) {
    real ratio = clamp(cellSize / max(clumpSize, kTiny) * 65536.0f, real(1.0), real(16777216.0));
    uint stepsPerCell = uint(ratio + 0.5f);
    ClumpAxis x = clumpAxis(cellX, local.x / cellSize, stepsPerCell);
    ClumpAxis z = clumpAxis(cellZ, local.y / cellSize, stepsPerCell);
    real fx = clumpFade(x.fraction);
    vec3 low = mix(clumpLattice(x.id, z.id, seed), clumpLattice(x.id + 1u, z.id, seed), fx);
    vec3 high = mix(clumpLattice(x.id, z.id + 1u, seed), clumpLattice(x.id + 1u, z.id + 1u, seed), fx);
    return clamp(mix(low, high, clumpFade(z.fraction)), real(-1.0), real(1.0));
}
