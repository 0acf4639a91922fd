// Daylight: Preetham, Shirley, Smits, "A Practical Analytic Model for Daylight", SIGGRAPH 1999; sky by Perez et al.
// 1993. Units: luminance in kcd/m^2 and illuminance in klx, as linear sRGB whose luminance is the photometric value. y
// is up. Directions are unit vectors. Turbidity is clamped to [2, 10], where the model's fits hold. The published
// zenith luminance is too high (Zotti, Wilkie, Purgathofer, "A Critical Review of the Preetham Skylight Model", 2007):
// at turbidity 3 it lights the ground with 24 klx at 30 degrees, measured clear skies with about 10, and their zenith
// is darker still. kSkyLevel brings sun and sky into one scale; colours and distribution are the paper's. Does not:
// clouds, the sun's disc, ozone and water vapour (their bands matter little next to Rayleigh and haze).

#ifndef __cplusplus
#include "numerics/basics.h"
#include "numerics/glsl.h"
#endif

const real kSkyLevel = real(0.37);

// Perez coefficients of (Y, x, y) and what makes zenith values of them. Make once a frame.
struct SkyModel {
    vec3 a;
    vec3 b;
    vec3 c;
    vec3 d;
    vec3 e;
    vec3 scale;  // zenith (Y in kcd/m^2, x, y) over the Perez value at the zenith
    vec3 sun;    // towards the sun, raised to the horizon if below it
    real night;  // 1 by day, falling to 0 as the sun sinks
};

FN real skyTurbidity(real turbidity) { return clamp(turbidity, real(2.0), real(10.0)); }

// Perez' function of (Y, x, y): cosTheta to the zenith, gamma to the sun (radians) and its cosine. cosTheta below 0.01
// counts as 0.01, the horizon.
FN vec3 perez(SkyModel m, real cosTheta, real gamma, real cosGamma) {
    real inverse = 1.0f / max(cosTheta, real(0.01));
    vec3 one = vec3(real(1.0), real(1.0), real(1.0));
    vec3 gradient = one + m.a * vec3(exp(m.b.x * inverse), exp(m.b.y * inverse), exp(m.b.z * inverse));
    vec3 glow = m.c * vec3(exp(m.d.x * gamma), exp(m.d.y * gamma), exp(m.d.z * gamma));
    return gradient * (one + glow + m.e * (cosGamma * cosGamma));
}

// Appendix A.2: the zenith's luminance (times kSkyLevel) and chromaticity; thetaS is the sun's angle to the zenith, in
// [0, pi/2].
FN vec3 skyZenith(real thetaS, real t) {
    real chi = (real(4.0 / 9.0) - t / 120.0f) * (kPi - 2.0f * thetaS);
    real luminance = (real(4.0453) * t - real(4.9710)) * tan(chi) - real(0.2155) * t + real(2.4192);
    real s = thetaS;
    real x2 = ((real(0.00166) * s - real(0.00375)) * s + real(0.00209)) * s;
    real x1 = ((real(-0.02903) * s + real(0.06377)) * s - real(0.03202)) * s + real(0.00394);
    real x0 = ((real(0.11693) * s - real(0.21196)) * s + real(0.06052)) * s + real(0.25886);
    real y2 = ((real(0.00275) * s - real(0.00610)) * s + real(0.00317)) * s;
    real y1 = ((real(-0.04214) * s + real(0.08970)) * s - real(0.04153)) * s + real(0.00516);
    real y0 = ((real(0.15346) * s - real(0.26756)) * s + real(0.06670)) * s + real(0.26688);
    return vec3(kSkyLevel * max(luminance, real(0.0)), (x2 * t + x1) * t + x0, (y2 * t + y1) * t + y0);
}

// The Perez coefficients by turbidity, appendix A.2: members a to e, the others 0.
FN SkyModel skyCoefficients(real t) {
    SkyModel m;
    m.a = vec3(real(0.1787), real(-0.0193), real(-0.0167)) * t + vec3(real(-1.4630), real(-0.2592), real(-0.2608));
    m.b = vec3(real(-0.3554), real(-0.0665), real(-0.0950)) * t + vec3(real(0.4275), real(0.0008), real(0.0092));
    m.c = vec3(real(-0.0227), real(-0.0004), real(-0.0079)) * t + vec3(real(5.3251), real(0.2125), real(0.2102));
    m.d = vec3(real(0.1206), real(-0.0641), real(-0.0441)) * t + vec3(real(-2.5771), real(-0.8989), real(-1.6537));
    m.e = vec3(real(-0.0670), real(-0.0033), real(-0.0109)) * t + vec3(real(0.3703), real(0.0452), real(0.0529));
    m.scale = vec3(0.0f, 0.0f, 0.0f);
    m.sun = m.scale;
    m.night = 0.0f;
    return m;
}

// An overcast sky, equally bright wherever one looks: white, 5 kcd/m^2, which lights level ground with 16 klx.
const real kUniformSky = real(5.0);
FN SkyModel skyUniform() {
    SkyModel m;
    m.a = vec3(0.0f, 0.0f, 0.0f);
    m.b = m.a;
    m.c = m.a;
    m.d = m.a;
    m.e = m.a;
    m.scale = vec3(kUniformSky, real(0.3127), real(0.3290));
    m.sun = vec3(0.0f, 1.0f, 0.0f);
    m.night = 1.0f;
    return m;
}

// The sky for a sun in direction sunDir; of turbidity 0 or less: the uniform one. With the sun below the horizon, where
// the model is silent: the sky of sunset, darkened as measured twilight is, by a factor of about 100 over the first 6
// degrees.
FN SkyModel skyModel(vec3 sunDir, real turbidity) {
    if (!(turbidity > 0.0f)) return skyUniform();
    real t = skyTurbidity(turbidity);
    SkyModel m = skyCoefficients(t);
    m.sun = unitOr(vec3(sunDir.x, max(sunDir.y, real(0.0)), sunDir.z), real(1e-6), vec3(1.0f, 0.0f, 0.0f));
    m.night = exp(min(real(45.0) * sunDir.y, real(0.0)));
    real thetaS = atan(sqrt(m.sun.x * m.sun.x + m.sun.z * m.sun.z), max(m.sun.y, real(1e-9)));
    vec3 atZenith = max(perez(m, real(1.0), thetaS, m.sun.y), vec3(real(1e-3), real(1e-3), real(1e-3)));
    m.scale = skyZenith(thetaS, t) / atZenith;
    return m;
}

// CIE xyY to linear sRGB (IEC 61966-2-1: Rec. 709 primaries, D65); what lies outside the gamut is clipped at 0.
FN vec3 xyYToLinear(real x, real y, real luminance) {
    real k = luminance / max(y, real(1e-4));
    real cx = x * k;
    real cz = (1.0f - x - y) * k;
    return max(vec3(real(3.2404542) * cx - real(1.5371385) * luminance - real(0.4985314) * cz,
                    real(-0.9692660) * cx + real(1.8760108) * luminance + real(0.0415560) * cz,
                    real(0.0556434) * cx - real(0.2040259) * luminance + real(1.0572252) * cz),
               vec3(real(0.0), real(0.0), real(0.0)));
}

// Luminance of the sky in direction dir, kcd/m^2. Below the horizon: as at the horizon.
FN vec3 skyRadianceOf(SkyModel m, vec3 dir) {
    vec3 axis = cross(dir, m.sun);
    real cosGamma = clamp(dot(dir, m.sun), real(-1.0), real(1.0));
    real gamma = atan(max(sqrt(dot(axis, axis)), real(1e-9)), cosGamma);
    vec3 v = m.scale * perez(m, dir.y, gamma, cosGamma);
    return xyYToLinear(v.y, v.z, max(v.x, real(0.0))) * m.night;
}
FN vec3 skyRadiance(vec3 dir, vec3 sunDir, real turbidity) { return skyRadianceOf(skyModel(sunDir, turbidity), dir); }

// Relative optical mass of the air towards the sun: 1 at the zenith, 36.5 on the horizon (Kasten 1966, by the paper's
// A.1).
FN real airMass(real thetaS) {
    real below = max(real(93.885) - thetaS * real(57.29577951308232), real(3.885));
    return 1.0f / (max(cos(thetaS), real(0.0)) + real(0.15) * pow(below, real(-1.253)));
}

// Transmittance at one wavelength (micrometres): Rayleigh and Angstrom's turbidity formula, appendix A.1.
FN real sunTransmittance(real wavelength, real mass, real t) {
    real beta = real(0.04608) * t - real(0.04586);
    real rayleigh = real(0.008735) * pow(wavelength, real(-4.08));
    return exp(-mass * (rayleigh + beta * pow(wavelength, real(-1.3))));
}

// Illuminance of the sun on a surface facing it, klx: 133.1 klx of 5800 K light above the air, attenuated at the
// dominant wavelengths of the three primaries. The disc sets over its half degree; below, exactly 0.
FN vec3 sunIlluminance(vec3 sunDir, real turbidity) {
    real t = skyTurbidity(turbidity);
    real height = clamp(sunDir.y, real(-1.0), real(1.0));
    real thetaS = atan(sqrt(max(1.0f - height * height, real(0.0))), max(height, real(1e-9)));
    real mass = airMass(thetaS);
    vec3 through = vec3(sunTransmittance(real(0.6114), mass, t), sunTransmittance(real(0.5491), mass, t),
                        sunTransmittance(real(0.4642), mass, t));
    real disc = clamp(real(0.5) + height / real(0.0093), real(0.0), real(1.0));
    return xyYToLinear(real(0.3260), real(0.3354), real(133.1)) * through * disc;
}
