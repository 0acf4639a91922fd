// Four ways with pixels that are covered in part (Boulanger, Pattanaik and Bouatouch 2006, section 4.2 and figure 21).
// Fragment shaders only. Needs: const bool TEMPORAL.
//
// Coverage is a mask of our own, not GL's alpha to coverage: that one covers the same first samples whatever is drawn,
// so that any number of layers of opacity 0.1 never hide more than a quarter of a pixel; and drivers round it as they
// like. Here each sample is covered with probability alpha, independently: layers of any opacity hide what they should,
// in the mean exactly.
#include "lib/frame.glsl"
#include "numerics/hash.h"

const int COVERAGE = 0, BOTH = 1, TEST = 2;  // ways, as Transparency of scene/components.h; 3: blended

// Bits 0 to 3: whether those bytes of x are below a threshold in [0, 256]. Two at a time: a byte that is not below it
// carries into the bits over it.
uint bytesBelow(uint x, uint threshold) {
    uint lack = (256u - threshold) * 0x00010001u;
    uint carries = ((x & 0x00FF00FFu) + lack & 0x01000100u) >> 8 | ((x >> 8 & 0x00FF00FFu) + lack & 0x01000100u) >> 7;
    return ~(carries | carries >> 14) & 15u;
}

// The bytes of x, each with `shift` added to it and what it carries dropped.
uint bytesShifted(uint x, uint shift) {
    uint all = shift * 0x01010101u;
    return (x & 0x7F7F7F7Fu) + (all & 0x7F7F7F7Fu) ^ (x ^ all) & 0x80808080u;
}

// Covers the fragment's samples; returns the alpha to write, 0: discard. way: one of the four; `seed`: a random number
// of what is drawn, fixed to it.
float coveredAlpha(int way, float alpha, uint seed) {
    gl_SampleMask[0] = -1;  // a shader that writes it anywhere must write it everywhere
    if (!(alpha >= 0.004)) return 0.0;
    if (way == COVERAGE) {
        if (alpha >= 1.0) return 1.0;
        uint threshold = uint(alpha * 256.0 + 0.5), low = hash3(seed, 1u, 0u);
        if (TEMPORAL) low = bytesShifted(low, frame.chanceShift);  // frames that add up take turns
        uint mask = bytesBelow(low, threshold) | bytesBelow(hashMix(low), threshold) << 4;
        gl_SampleMask[0] = int(mask * 0x01010101u);  // the ninth sample as the first, and so on
        return (mask & ((1u << uint(min(gl_NumSamples, 8))) - 1u)) == 0u ? 0.0 : 1.0;
    }
    if (way == BOTH) return alpha >= 0.1 ? alpha : 0.0;
    if (way == TEST) return alpha >= 0.5 ? 1.0 : 0.0;
    return alpha;
}
