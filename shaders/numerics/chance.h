// Coverage by chance: each sample of a pixel is covered with the probability alpha (lib/transparency.glsl).

#ifndef __cplusplus
#include "numerics/glsl.h"
#include "numerics/hash.h"
#endif

// Whether a pixel's only sample is, by what is drawn with the random number `seed`; shift: by how many 256ths this
// frame moves chances on, [0, 255].
FN bool chanceCovers(real alpha, uint seed, uint shift) {
    if (!(alpha >= real(0.004))) return false;
    return alpha >= 1.0f || ((hash3(seed, 1u, 0u) + shift) & 255u) < uint(alpha * 256.0f + 0.5f);
}
