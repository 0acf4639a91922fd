// Water: a level surface with small ripples, clear enough to see into. Directions are unit vectors, y is up; slopes are
// metres a metre. Ripples are sines that each travel by the law of deep water, spread about the wind; their phases at
// the eye are wrapped in double (world/water.h), so that a month moves as the first second. Does not: breakers, foam,
// caustics.

const real kWaterIndex = real(1.333);
const real kSmoothest =
    real(2e-4);  // variance of slopes that even still water has along each axis: it gives the sun's glint a size

// Share of light that the surface reflects: Fresnel, unpolarised, from air; cosine to the normal in [0, 1].
FN real waterFresnel(real cosine) {
    real c = clamp(cosine, real(0.0), real(1.0));
    real g = sqrt(kWaterIndex * kWaterIndex - 1.0f + c * c);
    real a = (g - c) / (g + c);
    real b = (c * (g + c) - 1.0f) / (c * (g - c) + 1.0f);
    return 0.5f * a * a * (1.0f + b * b);
}

// The cosine by which rough water reflects, where slopes of this variance are not seen one by one: waves that turn away
// hide behind others, so that it never looks as flat as at grazing angles.
FN real roughCosine(real cosine, real variance) { return sqrt(cosine * cosine + variance); }

// Light left of what lies under water: of the way to the eye (m), and of the light's own way down to a depth (m).
FN vec3 waterLeft(vec3 extinction, real way, real depth) {
    real through = max(way, real(0.0)) + max(depth, real(0.0));
    return vec3(exp(-extinction.x * through), exp(-extinction.y * through), exp(-extinction.z * through));
}
// The way under water to what is `depth` below the surface, along the straight ray (m) or the refracted one, whichever
// is shorter. cosine: of the ray in air.
FN real waterWay(real straight, real depth, real cosine) {
    real sine2 = (1.0f - cosine * cosine) / (kWaterIndex * kWaterIndex);
    return min(straight, depth / sqrt(max(1.0f - sine2, real(0.1))));
}

FN vec3 rippleNormal(vec2 slope) { return vec3(-slope.x, real(1.0), -slope.y) / sqrt(1.0f + dot(slope, slope)); }
// Where a ray of direction `way` goes that the surface throws back; never down again: the next wave would throw it up.
FN vec3 mirrored(vec3 way, vec3 normal) {
    vec3 r = way - normal * (2.0f * dot(way, normal));
    r.y = max(abs(r.y), real(1e-3));
    return r / sqrt(dot(r, r));
}
// Where it goes that enters (Snell).
FN vec3 refracted(vec3 way, vec3 normal) {
    real c = -dot(way, normal);
    real k = 1.0f / kWaterIndex;
    real under = 1.0f - k * k * (1.0f - c * c);
    return way * k + normal * (k * c - sqrt(max(under, real(0.0))));
}

// How much stronger ripples are in a gust than between: share of their slopes where it blows so hard (numerics/gust.h).
FN real rippleShare(real blows) { return real(0.35) + real(0.65) * min(abs(blows), real(1.0)); }
// Slope of one wave along its way. along: its turns a metre, x and z; phase: at the eye, turns; steepest: its greatest
// slope. at: x, z from the eye.
FN real waveSlope(vec2 along, real phase, real steepest, vec2 at) {
    return steepest * sinTurns(turns(phase + along.x * at.x + along.y * at.y));
}
// Share of a wave that is seen one by one where a pixel spans so many of its turns; of the rest only the variance
// shows.
FN real waveSeen(real across) { return clamp(real(2.0) - 4.0f * across, real(0.0), real(1.0)); }
FN vec2 waveWay(vec2 along) { return along / sqrt(max(along.x * along.x + along.y * along.y, kTiny)); }

// Radiance that the sun's glint sends to the eye, for sunlight of 1 (irradiance on what faces it, over pi): Gaussian
// slopes of this variance along each axis about `slope` (Cox and Munk, "Measurement of the Roughness of the Sea
// Surface", 1954).
FN real sunGlint(vec2 slope, real variance, vec3 toEye, vec3 toSun) {
    vec3 h = unitOr(toEye + toSun, real(1e-6), vec3(0.0f, 1.0f, 0.0f));
    if (!(h.y > real(0.05)) || !(toSun.y > 0.0f)) return real(0.0);
    vec2 off = vec2(-h.x / h.y - slope.x, -h.z / h.y - slope.y);
    real likely = exp(-dot(off, off) / (2.0f * variance)) / (kTau * variance);
    return kPi * waterFresnel(dot(toEye, h)) * likely / (4.0f * max(toEye.y, real(0.05)) * h.y * h.y * h.y * h.y);
}
