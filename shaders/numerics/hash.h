// Integer hashes: the same bits on CPU and GPU, in place of the papers' sin- and fract-based randoms (Jahrmann and
// Wimmer 2013 eqs 10-12 are constant along lines, negative half the time or NaN). Does not: resist an adversary.

#ifndef __cplusplus
#include "numerics/glsl.h"
#endif

// A bijection of 32 bits that avalanches: xorshift-multiply with the constants that C. Wellons found by search (2018).
FN uint hashMix(uint x) {
    x += 0x9E3779B9u;  // so that 0 does not map to 0
    x ^= x >> 16;
    x *= 0x7FEB352Du;
    x ^= x >> 15;
    x *= 0x846CA68Bu;
    x ^= x >> 16;
    return x;
}

// Hashes of two and three numbers; the order of the arguments matters.
FN uint hash2(uint a, uint b) { return hashMix(hashMix(a) ^ b); }
FN uint hash3(uint a, uint b, uint c) { return hashMix(hash2(a, b) ^ c); }

// h as a number in [0, 1): 24 bits, because float(h) * 2^-32 rounds to 1 for the last 128 values.
FN real hashUnit(uint h) { return real(h >> 8) * real(5.9604644775390625e-8); }

// The hash of a cell of a grid, ids of either sign.
FN uint cellHash(int cellX, int cellZ, uint seed) { return hash3(uint(cellX), uint(cellZ), seed); }

// How a cell mirrors its patch, each component +1 or -1 (Boulanger et al. 2006, section 3.1): by the cell's hash and
// never by a filtered map, whose signs would pass through 0.
FN vec2 cellMirror(uint cell) {
    return vec2((cell & 1u) == 0u ? real(1.0) : real(-1.0), (cell & 2u) == 0u ? real(1.0) : real(-1.0));
}
