// The inputs over which the forms of continuous formulas are compared, beside the samples of their rows.
// clang-format off: one line an input
#include "formulas/formula_table.h"
#include "formulas/kernels.h"

namespace sward {
namespace {

using Values = std::vector<double>;

struct KernelDomain {
    const char* name;  // of the row
    Values (*make)(Sweep& s, int i);
    // The unit of the error of an output; nullptr: 1.
    double (*unit)(const double* x, const double* want, int output) = nullptr;
};
constexpr int kDomainInputs = 4096;

Values joined(std::initializer_list<Values> parts) {
    Values all;
    for (const Values& p : parts) all.insert(all.end(), p.begin(), p.end());
    return all;
}
double relative(const double*, const double* want, int output) {
    return want[output] == 0 ? 1.0 : std::abs(want[output]);
}

// The upper hemisphere, the first in 16 close to a quadrant plane; the axes are among the row's own. They lie side by
// side, as pixels do that are hard: their subnormal numbers slow down a whole vector of invocations.
Values lightAbove(Sweep& s, int i) {
    Values l = s.direction();
    l[1] = std::abs(l[1]);
    if (i < kDomainInputs / 16) l[size_t(i % 3)] = s.size(1e-6, 1e-2);
    return l;
}
Values lodRanges(Sweep& s, int i) {
    const double near = s.in(2, 20), far = s.in(40, 80);
    return {s.in(0, 120), near, i % 16 ? near + s.in(1, 20) : near, far, i % 16 == 1 ? kInfinity : far + s.in(1, 40)};
}
double threshold(Sweep& s) { return double(float(s.whole(1, 255)) / 255.0f); }
Values fading(Sweep& s, int i) { return {s.unit(), threshold(s), i % 16 ? s.in(0.05, 0.5) : 0.0}; }
Values fadingBetween(Sweep& s, int i) { return {s.unit(), s.unit(), threshold(s), i % 16 ? s.in(0.05, 0.5) : 0.0}; }
Values cylinderRay(Sweep& s, int i) {
    Values d = s.direction();
    if (i % 16 == 0) d = {0, 1, 0};
    return joined({{s.in(-0.035, 0.035), s.in(0, 0.3), s.in(-0.035, 0.035)}, d, {0.05}});
}
Values layerColor(Sweep& s, int) {
    const double a = threshold(s);
    return {a * s.unit(), a * s.unit(), a * s.unit(), a, s.in(1, 16)};
}
// A triangle of a gentle slope seen from anywhere but along it; one in 16 straight from above.
Values tiltedTriangle(Sweep& s, int i) {
    Values v = s.direction();
    if (std::abs(v[2]) < 0.01) v[2] = 0.01;
    if (i % 16 == 0) v = {0, 0, -1};
    return joined({{0, 0, 0, 1, 0, s.in(-0.25, 0.25), 0, 1, s.in(-0.25, 0.25)}, v, {2, 1, 64, double(s.whole(0, 3))}});
}
double slant(const double* x, const double* want, int) { return x[12] + want[3]; }
// Up to 90 km out and an hour on: phases wrapped in double, as the engine hands them over.
Values windFarOut(Sweep& s, int i) {
    const double x = s.size(1, 9e4), z = s.size(1, 9e4), t = s.in(0, 3600), cellX = 8 * std::floor(x / 8),
                 cellZ = 8 * std::floor(z / 8);
    const f64::WindPhase p = f64::windPhase(cellX, cellZ, t, 1.0, 0.5, double(0.7f));
    return {p.first, p.second, p.across, x - cellX, z - cellZ, 1, 0.5, 0.7, i % 2 ? 0.1 : 0.3, x, z, t};
}
// What the phase's sensitivity to z adds, as for the row's own samples.
double windUnit(const double* x, const double*, int) {
    const double turn = 3.14159265358979 * (x[2] + x[6] * x[4]), gust = std::abs(std::cos(turn)) + x[8];
    return 1 + 0.125 * 0.785398 * x[6] * 3.14159265358979 * std::abs(std::sin(turn)) / (gust * gust);
}
// A leaning blade 1 cm wide; one in 16 straight, seen at its tip, where the printed tangent vanishes.
Values splineBlade(Sweep& s, int i) {
    const double height = s.in(0.1, 0.4), lean = s.in(0.02, 0.2), side = s.in(-0.05, 0.05);
    const bool straight = i % 16 == 0;
    const Values control = {straight ? lean : 0.0, height, straight ? side : 0.0};
    const auto edge = [&](double x) {
        return Values{x, 0, 0, x + control[0], control[1], control[2], x + lean, height * (straight ? 1.0 : 0.9), side};
    };
    Values in = joined({edge(-0.005), edge(0.005), {1, 0, 0, s.unit(), straight ? 1.0 : s.unit()}});
    if (straight) in[3] = in[6], in[12] = in[15];
    return in;
}
// Rays down into slices; one in 16 along an axis, one in 16 straight down.
Values rayDown(Sweep& s, int i) {
    const double n = double(8 << s.whole(0, 2));
    return {s.unit(), s.unit(), 0,   i % 16 < 2 ? 0.0 : s.in(-1, 1), i % 16 == 0 ? 0.0 : s.in(-1, 1), -s.in(0.05, 1),
            n,        n,        0.25};
}
Values bladeAtDistance(Sweep& s, int) { return {double(s.whole(1, 64)), s.in(0, 150), 100}; }
Values bladeOnScreen(Sweep& s, int i) {
    return {s.in(-1, 1), s.in(-1, 1), i % 16 ? s.in(0.5, 10) : 0.05, s.in(-1, 1), s.in(-1, 1), s.in(0.5, 10), 8, 16};
}

const KernelDomain kDomains[] = {
    {"light weights, three atan", lightAbove},
    {"diffuse light over the horizon",
     [](Sweep& s, int) {
         return Values{s.in(-0.5, 1), 0.0625};
     }},
    {"level-of-detail weights", lodRanges},
    {"opacity, eq 5", fading},
    {"opacity that conserves density", fading},
    {"every blade once: who draws it, and how opaque", fadingBetween},
    {"coordinate modulo 1", [](Sweep& s, int i) { return Values{(i % 2 ? 1 : -1) * s.size(1e-9, 1e3)}; }},
    {"way out of the shadow mask's cylinder, relative", cylinderRay, relative},
    {"point light seen from where it is",
     [](Sweep& s, int) {
         return Values{s.in(-4, 4), s.in(-4, 4), s.in(-4, 4), s.unit()};
     }},
    {"level of a macro-cell, the eye inside its sphere too",
     [](Sweep& s, int) {
         return Values{s.size(1, 1e4), 5, 10};
     }},
    {"premultiplied colour of a corrected layer", layerColor},
    {"offsets of tilted slices, in units of slant", tiltedTriangle, slant},
    {"number of slices before rounding, relative", tiltedTriangle, relative},
    {"wind far away and late, by its sensitivity", windFarOut, windUnit},
    {"tessellation level by distance", bladeAtDistance},
    {"tessellation level by size on screen", bladeOnScreen},
    {"frame of a blade between two splines", splineBlade},
    {"first hit of a ray, relative; parallel and vertical rays too", rayDown, relative},
    {"transmittance after layers of opacity above and below 1",
     [](Sweep& s, int) {
         return Values{s.in(0, 1.2), 4};
     }},
    {"depth of a hit, behind the near plane too",
     [](Sweep& s, int) { return Values{0, 0, 0.1, s.in(-1, 10), s.unit(), 0.1}; }},
    {"distance from a stroke, of no length too",
     [](Sweep& s, int) {
         return Values{s.in(-1, 1), s.in(-1, 1), s.in(-1, 1), s.in(-1, 1), s.in(-1, 1), s.in(-1, 1)};
     }},
    {"weight of a brush, of no radius too",
     [](Sweep& s, int) {
         return Values{s.in(0, 4), s.in(0.5, 4), s.in(0.25, 1)};
     }},
};

}  // namespace

FormulaSamples kernelDomain(const FormulaRow& row) {
    FormulaSamples samples;
    for (const KernelDomain& d : kDomains) {
        if (row.name != d.name) continue;
        Sweep random(20130613u);
        for (int i = 0; i < kDomainInputs; ++i) samples.add(d.make(random, i), {});
        if (samples.x.size() != size_t(kDomainInputs) * size_t(row.inputs))
            checkFailed(__FILE__, __LINE__, row.name + " takes another number of inputs");
        samples.want = runDouble(row, row.ours, samples);
        for (size_t i = 0; i < samples.want.size(); ++i) {
            const size_t at = i / size_t(row.outputs), output = i % size_t(row.outputs);
            const double* wants = &samples.want[at * size_t(row.outputs)];
            samples.scale.push_back(d.unit ? d.unit(&samples.x[at * size_t(row.inputs)], wants, int(output)) : 1.0);
        }
    }
    return samples;
}

}  // namespace sward
