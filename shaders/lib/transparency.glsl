// Four ways with pixels that are covered in part (Boulanger, Pattanaik and Bouatouch 2006, section 4.2 and figure 21).
// Fragment shaders only.
//
// Coverage is a mask of our own, not GL's alpha to coverage: that one covers the same first samples whatever is drawn,
// so that any number of layers of opacity 0.1 never hide more than a quarter of a pixel; and drivers round it as they
// like. Here each sample is covered with probability alpha, independently: layers of any opacity hide what they should,
// in the mean exactly.
#include "numerics/hash.h"

const int COVERAGE = 0, BOTH = 1, TEST = 2;  // ways, as Transparency of scene/components.h; 3: blended

// Covers the fragment's samples; returns the alpha to write, 0: discard. way: one of the four; `seed`: a random number
// of what is drawn, fixed to it.
float coveredAlpha(int way, float alpha, uint seed) {
    gl_SampleMask[0] = -1;  // a shader that writes it anywhere must write it everywhere
    if (!(alpha >= 0.004)) return 0.0;
    if (way == COVERAGE) {
        if (alpha >= 1.0) return 1.0;
        uint threshold = uint(alpha * 256.0 + 0.5), low = hash3(seed, 1u, 0u), high = hash3(seed, 2u, 0u);
        uvec4 a = uvec4(low, low >> 8, low >> 16, low >> 24) & 255u,
              b = uvec4(high, high >> 8, high >> 16, high >> 24) & 255u;
        uvec4 bits = uvec4(1u, 2u, 4u, 8u);
        uint mask = 0u;
        for (int i = 0; i < 4; ++i) mask |= (a[i] < threshold ? bits[i] : 0u) | (b[i] < threshold ? bits[i] << 4 : 0u);
        gl_SampleMask[0] = int(mask * 0x01010101u);  // the ninth sample as the first, and so on
        return (mask & ((1u << uint(min(gl_NumSamples, 8))) - 1u)) == 0u ? 0.0 : 1.0;
    }
    if (way == BOTH) return alpha >= 0.1 ? alpha : 0.0;
    if (way == TEST) return alpha >= 0.5 ? 1.0 : 0.0;
    return alpha;
}
