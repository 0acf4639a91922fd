// Bilinear fetches with one rule for CPU and GPU: hardware filters with 8-bit fractions, so that a texel 10 m wide has
// only 257 densities, and CPU and GPU would disagree about which blades exist.

#ifndef __cplusplus
#include "numerics/glsl.h"
#endif

struct BilinearTap {
    int x0;  // the four texels are (x0|x1, y0|y1), all inside the map
    int x1;
    int y0;
    int y1;
    real fx;  // weight of x1 against x0, in [0, 1)
    real fy;  // weight of y1 against y0, in [0, 1)
};

// The taps at (u, v) of a map of width x height texels (1 or more each). Texel centres lie at (i + 0.5) / n; beyond the
// outermost centres the edge texel holds. u and v are finite, any size.
FN BilinearTap bilinearTap(real u, real v, int width, int height) {
    precise real x = u * real(width);
    precise real y = v * real(height);
    x = clamp(x - 0.5f, real(0.0), real(width - 1));
    y = clamp(y - 0.5f, real(0.0), real(height - 1));
    BilinearTap tap;
    tap.x0 = int(x);
    tap.y0 = int(y);
    tap.x1 = min(tap.x0 + 1, width - 1);
    tap.y1 = min(tap.y0 + 1, height - 1);
    tap.fx = x - real(tap.x0);
    tap.fy = y - real(tap.y0);
    return tap;
}

// The mix of the four texels, aXY with X = 0 at x0 and 1 at x1. Equal texels give that value exactly.
FN real bilinearMix(real a00, real a10, real a01, real a11, real fx, real fy) {
    precise real low = a00 + (a10 - a00) * fx;
    precise real high = a01 + (a11 - a01) * fx;
    precise real value = low + (high - low) * fy;
    return value;
}

// The same of a map that repeats: u and v are finite, any size, and count repeats.
FN BilinearTap bilinearTapRepeat(real u, real v, int width, int height) {
    precise real x = (u - floor(u)) * real(width) - 0.5f;
    precise real y = (v - floor(v)) * real(height) - 0.5f;
    BilinearTap tap;
    tap.fx = x - floor(x);
    tap.fy = y - floor(y);
    int left = int(floor(x));
    int top = int(floor(y));
    tap.x0 = left < 0 ? width - 1 : min(left, width - 1);
    tap.y0 = top < 0 ? height - 1 : min(top, height - 1);
    tap.x1 = tap.x0 + 1 < width ? tap.x0 + 1 : 0;
    tap.y1 = tap.y0 + 1 < height ? tap.y0 + 1 : 0;
    return tap;
}

// Where in [0, 1] of a map u lies that is mirrored at every whole number: up, down, up again.
FN real mirrorUnit(real u) {
    precise real m = u - 2.0f * floor(u * 0.5f);
    return m <= 1.0f ? m : 2.0f - m;
}
