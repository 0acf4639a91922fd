// Coverage by chance: each sample of a pixel is covered with the probability alpha (lib/transparency.glsl).

#ifndef __cplusplus
#include "numerics/glsl.h"
#include "numerics/hash.h"
#endif

// Whether a pixel's only sample is, by what is drawn with the random number `seed`.
FN bool chanceCovers(real alpha, uint seed) {
    if (!(alpha >= real(0.004))) return false;
    return alpha >= 1.0f || (hash3(seed, 1u, 0u) & 255u) < uint(alpha * 256.0f + 0.5f);
}
