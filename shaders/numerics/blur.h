// Blur of what is far (Jahrmann and Wimmer 2013, section 6.4): a separable kernel of 7 pixels whose centre weighs the
// more the nearer a pixel is. Half of its taps lie between two pixels, where a linear filter reads both: five reads a
// direction. As printed, the centre's weight is the depth alone: 0 far away, and with weights of 0 beside it 0/0
// (J-10). Here the centre has a share of its own and weights are divided by their sum.

#ifndef __cplusplus
#include "numerics/basics.h"
#include "numerics/glsl.h"
#endif

// How far into the blur a distance lies: 0 at the eye, 1 at `reach` (metres, above 0) and beyond.
FN real farShare(real distance, real reach) { return clamp(distance / max(reach, kTiny), real(0.0), real(1.0)); }

// What far blades keep of their light: 1 at the eye, 1 - darkening at `reach` and beyond. Linear, as the paper found
// best.
FN real farLight(real distance, real darkening, real reach) { return 1.0f - darkening * farShare(distance, reach); }

// Weights of the centre, of the taps at 1.5 pixels (two pixels each) and of those at 3. gaussian: those of a bell of
// deviation 1.75 pixels, else all pixels weigh the same. x + 2 y + 2 z is 1.
FN vec3 blurWeights(real share, bool gaussian) {
    vec3 w = gaussian ? vec3(1.0f, real(1.36981593759), real(0.23006629899)) : vec3(1.0f, 2.0f, 1.0f);
    w = vec3(w.x, w.y * share, w.z * share);
    return w / (w.x + 2.0f * (w.y + w.z));
}
