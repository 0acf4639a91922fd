// Which blades exist and how opaque they are while fading: Boulanger, Pattanaik, Bouatouch 2006, eq 5 and section 3.4,
// with every blade drawn exactly once. Densities, thresholds, weights and opacities are in [0, 1].

#ifndef __cplusplus
#include "numerics/glsl.h"
#include "numerics/sowing.h"
#endif

// Threshold number k of 255; k in 1..255, because 0 is reserved for "no blade".
FN real thresholdOf(int k) { return real(k) / real(255.0); }

// Eq 5 as printed, without the guard: 0/0 at omega 0.
FN real opacityPublished(real density, real threshold, real omega) {
    return clamp((density - threshold + omega) / (2.0f * omega), real(0.0), real(1.0));
}

// Eq 5: a ramp of half-width omega around density = threshold; at omega 0 the step, drawn at equality (figure 14a).
FN real opacityEq5(real density, real threshold, real omega) {
    if (!(omega > real(1e-20))) return density >= threshold ? real(1.0) : real(0.0);
    return clamp(0.5f + 0.5f * ((density - threshold) / omega), real(0.0), real(1.0));
}

// The half-width at which fading neither adds nor removes grass at this density.
FN real conservingWidth(real density, real omega) { return min(omega, min(density, 1.0f - density)); }

// Eq 5 with its width narrowed towards density 0 and 1, so that bare ground is bare, full ground is full and the mean
// over uniform thresholds is the density. Equal to eq 5 for omega <= density <= 1 - omega. Thresholds are above 0.
FN real opacityConserving(real density, real threshold, real omega) {
    return opacityEq5(density, threshold, conservingWidth(density, omega));
}

// The share of the density that slices draw. Every shader must use this one product: it decides who draws a blade.
FN real sliceDensity(real density, real sliceWeight) {
    precise real t = density * sliceWeight;
    return t;
}

// Opacity of a blade in the slices, whose weight is sliceWeight.
FN real sliceOpacity(real density, real sliceWeight, real threshold, real omega) {
    return opacityConserving(sliceDensity(density, sliceWeight), threshold, omega);
}

// Opacity of the same blade as geometry: what the slices leave of it. Never negative, since eq 5 is monotone.
FN real geometryOpacity(real density, real sliceWeight, real threshold, real omega) {
    real whole = opacityConserving(density, threshold, omega);
    return max(whole - sliceOpacity(density, sliceWeight, threshold, omega), real(0.0));
}

// The same without fading: exactly one of the two is true for a blade with threshold <= density.
FN bool sliceHolds(real density, real sliceWeight, real threshold) {
    return threshold <= sliceDensity(density, sliceWeight);
}
FN bool geometryHolds(real density, real sliceWeight, real threshold) {
    return threshold > sliceDensity(density, sliceWeight) && threshold <= density;
}

// Who draws the blade by the paper's rule: slices compare the threshold, geometry 1 - threshold (section 3.4, with
// equality drawn). Right only at density 1, and even there equality is drawn twice.
FN bool geometryHoldsPublished(real density, real geometryWeight, real threshold) {
    return 1.0f - threshold <= density * geometryWeight;
}

// The thresholds of geometry that is drawn at all lie in [lowest, highest]: outside, geometryOpacity is exactly 0.
FN real highestThresholdDrawn(real density, real omega) {
    return min(density + conservingWidth(density, omega), real(1.0));
}
FN real lowestThresholdDrawn(real densityTimesWs, real omega) {
    return max(densityTimesWs - conservingWidth(densityTimesWs, omega), real(0.0));
}

// Opacity of a slice's texel that stores `alpha`, the share that blades cover, and thresholdAlpha, the mean of
// thresholds times what each covers; where blades cover each other, of the least threshold there. The quotient is the
// blades' own threshold wherever the texel shows one blade, however little of it, so that no outline is left of a
// hidden one (B-14). Texels of many blades (level: of detail) cannot be compared: there, the mean is what n blades one
// behind the other leave of the texel, 1 - (1 - density)^n. Their least threshold is 1 / (n + 1) in the mean, which
// gives n: the surer, the more blades are in it. s, chance: of the patch and the cell (numerics/sowing.h).
FN real texelOpacity(real thresholdAlpha, real alpha, real density, real omega, real level, Sown s, real chance) {
    real threshold = thresholdAlpha / max(alpha, real(1.0 / 512.0));
    real middle = thresholdIn(threshold, s, real(0.5)) * s.share;
    real least = clamp(mix(real(0.5), middle, clamp(level / 6.0f, real(0.0), real(1.0))), real(0.05), real(0.75));
    real many = 1.0f - pow(clamp(1.0f - density * s.share, real(0.0), real(1.0)), 1.0f / least - 1.0f);
    return alpha * mix(opacityConserving(density, thresholdIn(threshold, s, chance), omega), many,
                       clamp(level / 3.0f, real(0.0), real(1.0)));
}
