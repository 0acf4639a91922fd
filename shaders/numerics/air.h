// Air that light passes: S. Hillaire, "A Scalable and Production Ready Sky and Atmosphere Rendering Technique", EGSR
// 2020, whose coefficients (table 1), phase functions (section 3.2) and spherical planet these are. Lengths in km, so
// that squares of the planet's radius keep their digits; coefficients in 1/km; red, green and blue stand for 680, 550
// and 440 nm. A height counts from the ground, and is never the difference of two radii: at 6360 km a float knows half
// a metre. mu: the cosine to the zenith. On the GPU only the formula suite runs this: of it tables are made
// (sky/air_tables.h), which numerics/air_view.h reads. Does not: clouds, the colour of haze by wavelength, refraction.

#ifndef __cplusplus
#include "numerics/glsl.h"
#include "numerics/sky.h"
#endif

const real kPlanet = real(6360.0);   // its radius
const real kAirTop = real(100.0);    // above it nothing scatters
const real kRayleighKm = real(8.0);  // over which the air's density falls to 1/e,
const real kHazeKm = real(1.2);      // and that of haze (Mie)
const real kHazeForward = real(0.8);
const real kHazeScatters = real(0.9);  // share of what haze takes that it scatters: 3.996 of 4.44
const real kSunsWidth = real(0.0093);  // radians across the disc

// What a km of air at the ground does, and of ozone where there is most.
struct Air {
    vec3 rayleigh;  // scatters
    real haze;      // takes, of which it scatters kHazeScatters
    vec3 ozone;     // takes
};
// Of a turbidity: how many times as much light all air above takes as its molecules do (McCartney 1976). 1.05 is the
// paper's air. 1 to 12.
FN Air airOf(real turbidity) {
    Air a;
    a.rayleigh = vec3(real(5.802e-3), real(13.558e-3), real(33.1e-3));
    a.haze = (clamp(turbidity, real(1.0), real(12.0)) - 1.0f) * a.rayleigh.y * (kRayleighKm / kHazeKm);
    a.ozone = vec3(real(0.650e-3), real(1.881e-3), real(0.085e-3));
    return a;
}

// Densities at a height, as shares of those at the ground (x air, y haze) or of the ozone's greatest (z).
FN vec3 airDensity(real height) {
    real h = max(height, real(0.0));
    return vec3(exp(-h / kRayleighKm), exp(-h / kHazeKm), max(1.0f - abs(h - 25.0f) / 15.0f, real(0.0)));
}
// What air of these densities, or of these columns (km), takes of light.
FN vec3 airTakes(Air a, vec3 amount) {
    real haze = a.haze * amount.y;
    return a.rayleigh * amount.x + vec3(haze, haze, haze) + a.ozone * amount.z;
}

// Height after a distance along a ray.
FN real airHeight(real height, real mu, real distance) {
    real r = kPlanet + height, further = distance * (2.0f * r * mu + distance);
    return (height * (2.0f * kPlanet + height) + further) / (sqrt(max(r * r + further, real(1.0))) + kPlanet);
}
// Distance to the top of the air, from a height in it.
FN real airExit(real height, real mu) {
    real r = kPlanet + height, c = max((kAirTop - height) * (2.0f * kPlanet + kAirTop + height), real(0.0));
    real root = sqrt(r * r * mu * mu + c);
    return mu > 0.0f ? c / (r * mu + root) : root - r * mu;
}
// Distance to the ground; less than 0 where the ray passes it.
FN real groundAt(real height, real mu) {
    real r = kPlanet + height, c = max(height, real(0.0)) * (2.0f * kPlanet + height), d = r * r * mu * mu - c;
    if (!(mu < 0.0f) || !(d >= 0.0f)) return real(-1.0);
    return c / (sqrt(d) - r * mu);
}
// mu of the horizon, at most 0.
FN real horizonMu(real height) {
    real h = max(height, real(0.0));
    return -sqrt(h * (2.0f * kPlanet + h)) / (kPlanet + h);
}
// Share of the sun's disc above the horizon of a height; mu: to its middle.
FN real sunOverHorizon(real height, real mu) {
    return clamp(real(0.5) + (mu - horizonMu(height)) / kSunsWidth, real(0.0), real(1.0));
}
// The least height of a ray that sinks (mu below 0) and passes the ground.
FN real lowestOf(real height, real mu) {
    real s = sqrt(max(1.0f - mu * mu, real(0.0)));
    return max(height - (kPlanet + height) * (mu * mu / (1.0f + s)), real(0.0));
}

// Columns that a ray meets to the top, km at the ground's density: mu of 0 or more. Steps grow with the square of their
// number, since air is dense where the ray begins.
FN vec3 airColumns(real height, real mu, int steps) {
    real all = airExit(height, mu);
    vec3 sum = vec3(0.0f, 0.0f, 0.0f);
    for (int i = 0; i < steps; ++i) {
        real at = (real(i) + 0.5f) / real(steps);
        sum = sum + airDensity(airHeight(height, mu, all * at * at)) * (2.0f * at * all / real(steps));
    }
    return sum;
}

// How light is scattered by an angle of this cosine, 1/sr: by air (Rayleigh), by haze (Cornette and Shanks 1992).
FN real rayleighPhase(real c) { return real(0.059683103659460751) * (1.0f + c * c); }
FN real hazePhase(real c) {
    real g = kHazeForward, wide = max(1.0f + g * g - 2.0f * g * c, real(1e-4));
    return real(0.11936620731892150) * (1.0f - g * g) * (1.0f + c * c) / ((2.0f + g * g) * wide * sqrt(wide));
}

// Light above the air on what faces the sun, klx: 5800 K (as numerics/sky.h).
FN vec3 sunAboveAir() { return xyYToLinear(real(0.3260), real(0.3354), real(133.1)); }
// On the ground, of a sun in direction sunDir; 0 below the horizon.
FN vec3 sunThroughAir(vec3 sunDir, real turbidity) {
    real mu = clamp(sunDir.y, real(0.0), real(1.0));
    vec3 taken = airTakes(airOf(turbidity), airColumns(real(0.0), mu, 64));
    return sunAboveAir() * vec3(exp(-taken.x), exp(-taken.y), exp(-taken.z)) * sunOverHorizon(real(0.0), sunDir.y);
}
