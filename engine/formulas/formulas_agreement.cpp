// Rows without a hard case of the papers: what places, shades and shows grass must be the same in float and on the GPU.
// clang-format off: bodies are laid out as the shader lines that they become
#include "formulas/formula_table.h"

namespace sward {
namespace {

void addPlacementRows(std::vector<FormulaRow>& rows) {
    rows.push_back({
        .name = "integer hash, high and low half", .inputs = 3, .outputs = 2,
        .ours = BODY(uint h = hash3(uint(int(x[0])), uint(int(x[1])), uint(int(x[2]))); y[0] = real(h >> 16);
                     y[1] = real(h & 65535u);),
        .samples = sweep(2000,
                         [](Sweep& s, int) {
                             return std::vector<double>{double(s.whole(-180000, 180000)),
                                                        double(s.whole(-180000, 180000)), double(s.whole(0, 999))};
                         }),
        .low = 0, .high = 65535
    });
    rows.push_back({
        .name = "bilinear taps and their mix", .inputs = 4, .outputs = 6,
        .ours = BODY(BilinearTap t = bilinearTap(x[0], x[1], int(x[2]), int(x[3])); y[0] = real(t.x0);
                     y[1] = real(t.x1); y[2] = real(t.y0); y[3] = real(t.y1);
                     // NaN-free whatever (u, v); the mix of a checker shows fractions, 3 everywhere stays 3
                     y[4] = bilinearMix(real(0.0), real(1.0), real(1.0), real(0.0), t.fx, t.fy);
                     y[5] = bilinearMix(real(3.0), real(3.0), real(3.0), real(3.0), t.fx, t.fy);),
        .samples = sweep(2000,
                         [](Sweep& s, int i) {
                             const double n = double(1 << s.whole(0, 9));
                             // Multiples of 2^-12 so that no rounding moves a tap across a texel.
                             const auto at = [&] { return s.whole(-1024, 5120) / 4096.0; };
                             return std::vector<double>{at(), at(), n, i % 7 ? n : 1.0};
                         }),
        .tolerance = 2e-7, .low = 0, .high = 511
    });
    rows.push_back({
        .name = "bilinear taps of a map that repeats, and a mirrored place", .inputs = 4, .outputs = 6,
        .ours = BODY(BilinearTap t = bilinearTapRepeat(x[0], x[1], int(x[2]), int(x[3])); y[0] = real(t.x0);
                     y[1] = real(t.x1); y[2] = real(t.y0); y[3] = real(t.y1);
                     // The mix of a checker shows fractions
                     y[4] = bilinearMix(real(0.0), real(1.0), real(1.0), real(0.0), t.fx, t.fy);
                     y[5] = mirrorUnit(x[0]);),
        .samples = sweep(2000,
                         [](Sweep& s, int i) {
                             const double n = double(1 << s.whole(0, 9));
                             // Multiples of 2^-12 so that no rounding moves a tap across a texel.
                             const auto at = [&] { return s.whole(-1024, 5120) / 4096.0; };
                             return std::vector<double>{at(), at(), n, i % 7 ? n : 1.0};
                         }),
        .tolerance = 2e-7, .low = 0, .high = 511
    });
    rows.push_back({
        .name = "thresholds between which geometry is drawn", .inputs = 4, .outputs = 1,
        .ours = BODY(real t = sliceDensity(x[0], x[1]); real o = geometryOpacity(x[0], x[1], x[2], x[3]);
                     bool outside = x[2] > highestThresholdDrawn(x[0], x[3]) || x[2] < lowestThresholdDrawn(t, x[3]);
                     y[0] = outside ? o : real(0.0);),
        .samples =
            [](const ExpectedValues&) {
                FormulaSamples samples;
                Sweep s(11);
                for (int i = 0; i < 20000; ++i)
                    samples.add(
                        {s.unit(), s.unit(), double(float(s.whole(1, 255)) / 255.0f), i % 5 ? s.in(0, 0.5) : 0.0}, {0});
                return samples;
            },
        .gpuTolerance = 2e-7, .low = 0, .high = 2e-7
    });  // GPUs may divide x by x and miss 1
}

void addBladePlaceRows(std::vector<FormulaRow>& rows) {
    rows.push_back({
        .name = "clump values, the same whatever the cell id", .inputs = 6, .outputs = 3,
        .ours = BODY(vec3 c = clumpValues(int(x[0]), int(x[1]), vec2(x[2], x[3]), x[4], x[5], 7u); y[0] = c.x;
                     y[1] = c.y; y[2] = c.z;),
        .samples = sweep(2000,
                         [](Sweep& s, int) {
                             return std::vector<double>{double(s.whole(-180000, 180000)),
                                                        double(s.whole(0, 180000)),
                                                        s.whole(0, 128) / 64.0,
                                                        s.whole(0, 128) / 64.0,
                                                        2.0,
                                                        double(1 << s.whole(0, 4)) / 4.0};
                         }),
        .tolerance = 2e-5, .low = -1, .high = 1
    });
    rows.push_back({
        .name = "positions along a blade, never below its root", .inputs = 5, .outputs = 6,
        .ours = BODY(BladeShape s = bladeShape(x[0], x[1], x[2], x[3]);
                     BladeFrame f = bladeFrame(s.control, s.tip, x[3], x[4]); y[0] = abs(f.position.x);
                     y[1] = f.position.y; y[2] = abs(f.position.z); y[3] = abs(dot(f.tangent, f.normal));
                     y[4] = abs(dot(f.side, f.normal)); y[5] = abs(dot(f.side, f.side) - 1.0f);),
        .samples = sweep(
            2000,
            [](Sweep& s, int) {
                return std::vector<double>{s.in(0, 0.5), s.in(-1.7, 1.7), s.in(-0.2, 1.5), s.in(-3.1, 3.1), s.unit()};
            }),
        .tolerance = 1e-6, .gpuTolerance = 1e-5, .low = 0, .high = 1
    });
}

void addLightRows(std::vector<FormulaRow>& rows) {
    rows.push_back({
        .name = "light weights by polynomials, over the whole hemisphere", .inputs = 3, .outputs = 1,
        .ours = BODY(vec3 l = vec3(x[0], abs(x[1]), x[2]); LightWeights a = lightWeightsFast(l);
                     LightWeights b = lightWeights(l);
                     y[0] = max(max(abs(a.xPos - b.xPos), abs(a.xNeg - b.xNeg)),
                                max(abs(a.yPos - b.yPos), max(abs(a.zPos - b.zPos), abs(a.zNeg - b.zNeg))));),
        .samples =
            [](const ExpectedValues&) {
                FormulaSamples samples;
                Sweep s(31);
                for (int i = 0; i < 2000; ++i) samples.add(s.direction(), {0});
                return samples;
            },
        .tolerance = 4e-5, .gpuTolerance = 5e-5, .methodTolerance = 4e-5, .low = 0, .high = 5e-5
    });
    rows.push_back({
        .name = "sky radiance, relative", .inputs = 7, .outputs = 3,
        .ours = BODY(vec3 c = skyRadiance(vec3(x[0], x[1], x[2]), vec3(x[3], x[4], x[5]), x[6]); y[0] = c.x; y[1] = c.y;
                     y[2] = c.z;),
        .samples = sweep(2000,
                         [](Sweep& s, int i) {
                             auto in = s.direction();
                             auto sun = s.direction();
                             if (i % 20 == 0) sun = in;         // gamma 0
                             if (i % 20 == 1) sun = {0, 1, 0};  // noon in the tropics
                             if (i % 20 == 2) sun = {1, 0, 0};  // on the horizon
                             if (i % 20 == 3) in = {1, 0, 0};   // looking at the horizon
                             in.insert(in.end(), sun.begin(), sun.end());
                             in.push_back(s.in(1, 12));
                             return in;
                         }),
        .tolerance = 1e-4, .gpuTolerance = 1e-3, .low = 0, .high = 1e3,
        .error = [](double got, double want, double) { return relativeError(got, want, 0.1); }
    });
    rows.push_back({
        .name = "sun illuminance, relative", .inputs = 4, .outputs = 3,
        .ours = BODY(vec3 c = sunIlluminance(vec3(x[0], x[1], x[2]), x[3]); y[0] = c.x; y[1] = c.y; y[2] = c.z;),
        .samples = sweep(1000,
                         [](Sweep& s, int i) {
                             auto in = s.direction();
                             if (i % 10 == 0) in = {0, i % 20 ? 1.0 : -1.0, 0};
                             if (i % 10 == 1) in = {1, 0, 0};
                             in.push_back(s.in(1, 12));
                             return in;
                         }),
        .tolerance = 1e-4, .gpuTolerance = 1e-3, .low = 0, .high = 200,
        .error = [](double got, double want, double) { return relativeError(got, want, 1.0); }
    });
}

void addDisplayRows(std::vector<FormulaRow>& rows) {
    rows.push_back({
        .name = "tone mapping to sRGB", .inputs = 3, .outputs = 3,
        .ours = BODY(vec3 c = srgbEncode3(toneMapNeutral(vec3(x[0], x[1], x[2]))); y[0] = c.x; y[1] = c.y; y[2] = c.z;),
        .samples = sweep(2000,
                         [](Sweep& s, int i) {
                             if (i == 0) return std::vector<double>{0, 0, 0};
                             if (i == 1) return std::vector<double>{-1, 3e38, 1};
                             const double k = s.size(1e-3, 1e4);
                             return std::vector<double>{s.in(0, k), s.in(0, k), s.in(0, k)};
                         }),
        .tolerance = 2e-6, .gpuTolerance = 2e-5, .low = 0, .high = 1.0000002
    });
    rows.push_back({
        .name = "sRGB there and back", .inputs = 3, .outputs = 3,
        .ours = BODY(vec3 c = srgbDecode3(srgbEncode3(vec3(x[0], x[1], x[2]))); y[0] = c.x; y[1] = c.y; y[2] = c.z;),
        .samples =
            [](const ExpectedValues&) {
                FormulaSamples samples;
                for (int i = 0; i <= 255; ++i) {
                    const double v = double(float(i) / 255.0f);
                    samples.add({v, v, v}, {v, v, v});
                }
                return samples;
            },
        .tolerance = 1e-6, .gpuTolerance = 2e-5, .methodTolerance = 1e-7, .low = 0, .high = 1.0000002
    });
}

void addLeafRows(std::vector<FormulaRow>& rows) {
    rows.push_back({
        .name = "waxy highlight of a leaf, light and eye behind it and against each other too", .inputs = 10,
        .outputs = 2,
        .ours = BODY(vec3 n = vec3(x[0], x[1], x[2]); vec3 l = vec3(x[3], x[4], x[5]); vec3 v = vec3(x[6], x[7], x[8]);
                     y[0] = waxyLobe(n, l, v, x[9]); y[1] = waxyMean(dot(l, v));),
        .samples = sweep(
            2000,
            [](Sweep& s, int i) {
                std::vector<double> in = s.direction();
                const auto l = s.direction(), v = i % 5 ? s.direction() : std::vector<double>{-l[0], -l[1], -l[2]};
                in.insert(in.end(), l.begin(), l.end());
                in.insert(in.end(), v.begin(), v.end());
                in.push_back(s.in(0.3, 1));
                return in;
            }),
        .tolerance = 5e-4, .low = 0, .high = 3.2e5, .error = relativeError
    });
    rows.push_back({
        .name = "what a shadow mask lets through, by density", .inputs = 5, .outputs = 1,
        .ours = BODY(y[0] = maskVisibility(vec4(x[0], x[1], x[2], x[3]), x[4]);),
        .samples = listed({{0.5, 0.25, 0.125, 0, 0},
                           {0.5, 0.25, 0.125, 0, 0.125},
                           {0.5, 0.25, 0.125, 0, 0.25},
                           {0.5, 0.25, 0.125, 0, 0.875},
                           {0.5, 0.25, 0.125, 0, 1},
                           {0, 0, 0, 0, 2},
                           {1, 1, 1, 1, 0.3}},
                          {{1}, {0.75}, {0.5}, {0.0625}, {0}, {0}, {1}}),
        .tolerance = 1e-6, .low = 0, .high = 1
    });
    rows.push_back({
        .name = "colour of light through a leaf", .inputs = 3, .outputs = 3,
        .ours = BODY(vec3 c = leafThrough(vec3(x[0], x[1], x[2])); y[0] = c.x; y[1] = c.y; y[2] = c.z;),
        .samples = listed({{0, 0, 0}, {1, 1, 1}, {0.05, 0.12, 0.03}}), .tolerance = 1e-6, .low = 0, .high = 1.2
    });
    rows.push_back({
        .name = "light from blade to blade under paint", .inputs = 4, .outputs = 1,
        .ours = BODY(y[0] = paintScatters(vec3(x[0], x[0], x[0]), vec3(x[1], x[1], x[1]), x[2], x[3]).y;),
        .samples = listed({{0.125, 0.125, 0.5, 0.625}, {0.125, 0.75, 0, 0}, {0, 0.75, 0, 0.5}, {0, 1, 1, 0.9375}},
                          {{1}, {1}, {1.6}, {16}}),
        .tolerance = 1e-5, .low = 0, .high = 20.1
    });
}

}  // namespace

void addAgreementRows(std::vector<FormulaRow>& rows) {
    addPlacementRows(rows);
    addBladePlaceRows(rows);
    addLightRows(rows);
    addDisplayRows(rows);
    addLeafRows(rows);
}

}  // namespace sward
