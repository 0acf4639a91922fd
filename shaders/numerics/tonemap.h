// Display: the Khronos PBR Neutral tone mapper (Khronos Group, 2024) and the sRGB transfer function (IEC 61966-2-1).

#ifndef __cplusplus
#include "numerics/glsl.h"
#endif

// Linear colour (1 = display white), any finite size, to [0, 1]: colours below 0.8 keep their hue and value but for the
// Fresnel offset of 0.04; brighter ones are compressed, and desaturate towards white. Negative components count as 0.
FN vec3 toneMapNeutral(vec3 linear) {
    vec3 color = clamp(linear, real(0.0), real(1e6));
    real low = min(color.x, min(color.y, color.z));
    real offset = low < real(0.08) ? low - 6.25f * low * low : real(0.04);
    color = color - vec3(offset, offset, offset);
    real peak = max(color.x, max(color.y, color.z));
    real start = real(0.76);
    if (peak < start) return color;
    real room = 1.0f - start;
    real newPeak = 1.0f - room * room / (peak + room - start);
    real desaturate = 1.0f - 1.0f / (real(0.15) * (peak - newPeak) + 1.0f);
    return mix(color * (newPeak / peak), vec3(newPeak, newPeak, newPeak), desaturate);
}

// One channel, linear to sRGB-encoded and back; clamped to [0, 1].
FN real srgbEncode(real linear) {
    real x = clamp(linear, real(0.0), real(1.0));
    if (x <= real(0.0031308)) return real(12.92) * x;
    return min(real(1.055) * pow(x, real(1.0 / 2.4)) - real(0.055), real(1.0));
}
FN real srgbDecode(real encoded) {
    real x = clamp(encoded, real(0.0), real(1.0));
    if (x <= real(0.04045)) return x / real(12.92);
    return pow((x + real(0.055)) / real(1.055), real(2.4));
}
// What is added to a pixel before it is rounded to levels, in levels, within half a level either way: so a slow change
// ends in grain of the right mean instead of in bands. The same at each place of every picture. Interleaved gradient
// noise: Jimenez, "Next Generation Post Processing in Call of Duty: Advanced Warfare", SIGGRAPH 2014. x, y: pixels, 0
// to 16384.
FN real ditherOf(int x, int y) {
    real slope = real(0.06711056) * real(x) + real(0.00583715) * real(y);
    real turned = real(52.9829189) * (slope - floor(slope));
    return turned - floor(turned) - 0.5f;
}
FN vec3 srgbEncode3(vec3 c) { return vec3(srgbEncode(c.x), srgbEncode(c.y), srgbEncode(c.z)); }
FN vec3 srgbDecode3(vec3 c) { return vec3(srgbDecode(c.x), srgbDecode(c.y), srgbDecode(c.z)); }
