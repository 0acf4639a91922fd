// Waves of wind (Jahrmann, Wimmer 2013, eq 9): w = sin(c1 a) cos(c3 a), a = pi x + t + (pi/4) / (|cos(c2 pi z)| + eps).
// Phases are in turns, wrapped in double on the CPU once per cell and frame: in float, eq 9 is off by 8e-3 at 1 km, by
// 0.5 at 90 km and after a week, where half the frames stand still. Error here: 2e-6 anywhere, any time. Unit of x and
// z: metres, of t: seconds. eps of 0.1 or more; below, neighbouring blades move without relation.

#ifndef __cplusplus
#include "numerics/basics.h"
#include "numerics/glsl.h"
#endif

// The part of the phases that depends on the cell's corner and the time; make in double and round to float.
struct WindPhase {
    real first;   // of c1 a, turns in [-1/2, 1/2]
    real second;  // of c3 a
    real across;  // of c2 z, half turns of the cosine
};

FN real turns(real x) { return x - round(x); }
// sin(2 pi x) for x in turns; the argument stays in [-pi, pi], where GPUs promise precision.
FN real sinTurns(real x) { return sin(kTau * turns(x)); }

FN WindPhase windPhase(real cellX, real cellZ, real t, real c1, real c2, real c3) {
    real halfTurns = 0.5f * cellX + t / kTau;
    WindPhase p;
    p.first = turns(c1 * halfTurns);
    p.second = turns(c3 * halfTurns);
    p.across = turns(c2 * cellZ);
    return p;
}

// Wind in [-1, 1] at (x, z) metres from the cell's corner.
FN real windAt(WindPhase p, real x, real z, real c1, real c2, real c3, real eps) {
    real r = turns(p.across + c2 * z);
    real gust = 1.0f / (abs(sin(kPi * (0.5f - abs(r)))) + eps);
    real first = p.first + c1 * (0.5f * x + 0.125f * gust);
    real second = p.second + c3 * (0.5f * x + 0.125f * gust);
    return sinTurns(first) * sinTurns(second + 0.25f);
}

// Eq 9 as printed.
FN real windPublished(real x, real z, real t, real c1, real c2, real c3, real eps) {
    real a = kPi * x + t + (kPi / 4.0f) / (abs(cos(c2 * kPi * z)) + eps);
    return sin(c1 * a) * cos(c3 * a);
}

// Phase in [0, 1) of something that repeats every `period` ticks (period >= 1): whole ticks are counted, so that after
// any time motion is what it was at the start. Adding 1/60 s in float loses 2.8 s in the first hour and stops after six
// days.
FN real tickPhase(uint tick, uint period) { return real(tick % period) / real(period); }
