// Flowers (Jahrmann and Wimmer 2013: instanced billboards): which exist, how they stand and turn to the eye, what they
// send of light. A flower is two flat pieces: a stem that turns about itself to the eye, and a head that faces half
// upward, half to the eye. Where it stands and whether follows from an integer hash of (cell, number), as a blade's
// threshold does: a flower exists where the density reaches its threshold.

#ifndef __cplusplus
#include "numerics/basics.h"
#include "numerics/glsl.h"
#include "numerics/hash.h"
#include "numerics/population.h"
#endif

struct Flower {
    vec2 place;      // in its cell, in cells
    real threshold;  // above 0, rises with the number; beyond 1: it exists nowhere
    real taller;     // in [-1, 1]
    real larger;     // factor of its head, about 1
    real second;     // in [0, 1]: share of the second colour
    real grain;      // in [0, 1]: its own number, by which it quivers
    vec2 facing;     // unit: to where it leans by itself
};

// Flower `number` of a cell in which, at density 1, `expected` flowers stand in the mean (above 0).
FN Flower flowerOf(int cellX, int cellZ, uint number, real expected, uint seed) {
    uint h = hash2(cellHash(cellX, cellZ, seed), number);
    Flower f;
    f.place = vec2(hashUnit(hash2(h, 1u)), hashUnit(hash2(h, 2u)));
    f.threshold = (real(number) + 1.0f - hashUnit(hash2(h, 3u))) / expected;
    f.taller = 2.0f * hashUnit(hash2(h, 4u)) - 1.0f;
    f.larger = real(0.8) + real(0.4) * hashUnit(hash2(h, 5u));
    f.second = hashUnit(hash2(h, 6u));
    f.grain = hashUnit(hash2(h, 7u));
    real turn = kTau * hashUnit(hash2(h, 8u));
    f.facing = vec2(cos(turn), sin(turn));
    return f;
}

// Root to head of a flower of this height that leans by `lean` (m per m) beside its own.
FN vec3 flowerStem(Flower f, real height, vec2 lean) {
    real h = max(height, kTiny);
    vec2 own = f.facing * (real(0.05) + real(0.15) * f.second);
    return poseBlade(vec3(real(0.0), 0.5f * h, real(0.0)), vec3(real(0.0), h, real(0.0)), f.facing,
                     vec2(real(1.0), real(1.0)), own + lean, real(1.0))
        .tip;
}

// How its pieces lie, seen from `toEye` (unit). stem: root to head.
struct FlowerFrame {
    vec3 side;  // unit: across both pieces
    vec3 up;    // unit: across the head, upward
    vec3 face;  // unit: the head's normal, towards the eye
};
FN FlowerFrame flowerFrame(vec3 stem, vec2 facing, vec3 toEye) {
    vec3 axis = unitOr(stem, real(1e-6), vec3(0.0f, 1.0f, 0.0f));
    FlowerFrame f;
    f.side = unitOr(cross(axis, toEye), real(1e-4), vec3(-facing.y, real(0.0), facing.x));
    f.face = unitOr(axis * real(0.7) + toEye, real(1e-4), axis);
    f.up = unitOr(cross(f.face, f.side), real(1e-6), axis);
    return f;
}
// The normal by which a stem is lit: round, seen from the eye's side.
FN vec3 stemNormal(vec3 toEye) { return unitOr(vec3(toEye.x, real(0.5), toEye.z), real(1e-6), vec3(0.0f, 1.0f, 0.0f)); }

// Share of flowers that stand for all, larger each by one over its root, where heads are small: size of a head, as a
// share of the least that is drawn. [4e-4, 1].
FN real flowersStanding(real size) {
    real s = clamp(size, real(0.02), real(1.0));
    return s * s;
}
// How far below that share of the ranks flowers are no longer whole; they are gone twice as far above it, so that they
// cover as much as all.
FN real flowersBetween(real standing) { return clamp(1.0f - standing, real(1e-6), real(0.1) * standing); }
FN real flowersGone(real standing) { return standing + 2.0f * flowersBetween(standing) + real(2e-6); }

// Share of its size that a flower has where so many stand for all, and of those the distance leaves `kept`: they shrink
// one after the other, the highest thresholds first; those left are larger by at most `widest` each way beyond what
// they stand for. threshold and density: as they stand, density above 0.
FN real flowerSize(real threshold, real density, real standing, real kept, real widest) {
    if (!(threshold <= density)) return real(0.0);
    real rank = threshold / density, between = flowersBetween(standing);
    real stands = clamp((flowersGone(standing) - rank) / (3.0f * between), real(0.0), real(1.0)),
         left = clamp((real(1.25) * kept - rank / standing) * 4.0f, real(0.0), real(1.0));
    return stands * left * min(1.0f / sqrt(max(kept, real(1e-3))), widest) / sqrt(standing);
}
// The highest rank, threshold over density, of a flower that has a size.
FN real flowerRankMost(real standing, real kept) { return min(flowersGone(standing), real(1.25) * kept * standing); }

// What petals and stems send of light from `towards`, as a share of what faces it would: some shines through.
FN real flowerSends(vec3 normal, vec3 towards) {
    real facing = dot(normal, towards);
    return facing > 0.0f ? facing : real(-0.5) * facing;
}
// Ambient light left at a share of the height.
FN real flowerOpen(real v) { return mix(real(0.35), real(1.0), v); }

// Reflectance: of the made image, whose channels say how much is petal and how much centre, and how light; or of
// another, with a factor.
FN vec3 flowerColor(vec3 texel, vec3 petal, vec3 center, vec3 stem, bool made) {
    if (!made) return texel * petal;
    return (petal * texel.x + center * texel.y + stem * max(1.0f - texel.x - texel.y, real(0.0))) * (2.0f * texel.z);
}
