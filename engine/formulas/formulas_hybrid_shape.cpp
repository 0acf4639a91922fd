// Rows of Boulanger, Pattanaik, Bouatouch 2006: tiling, blades, shadows, quadtree, placement.
// clang-format off: bodies are laid out as the shader lines that they become
#include "formulas/formula_table.h"

namespace sward {
namespace {

// The shape of a blade by the paper's explicit Euler steps.
const FormulaBody kEulerTip =
    BODY(real dt = 1.0f / x[4]; vec3 p = vec3(0.0f, 0.0f, 0.0f);
         vec3 v = vec3(x[0] * sin(x[1]) * cos(x[3]), x[0] * cos(x[1]), x[0] * sin(x[1]) * sin(x[3]));
         for (int i = 0; i < int(x[4]); i++) {
             p = p + v * dt;
             v = v + vec3(real(0.0), -2.0f * x[2] * x[0] * dt, real(0.0));
         } y[0] = p.x;
         y[1] = p.y; y[2] = p.z;);

// The paper's frame: side from the cross product of the tangent with up.
const FormulaBody kCrossFrame = BODY(
    BladeShape s = bladeShape(x[0], x[1], x[2], x[3]); vec3 d = s.control * (1.0f - x[4]) + (s.tip - s.control) * x[4];
    vec3 t = d / sqrt(dot(d, d)); vec3 c = cross(t, vec3(0.0f, 1.0f, 0.0f)); vec3 side = c / sqrt(dot(c, c));
    vec3 n = cross(side, t); y[0] = t.x; y[1] = t.y; y[2] = t.z; y[3] = n.x; y[4] = n.y; y[5] = n.z;);

void addTilingCases(std::vector<FormulaRow>& rows) {
    rows.push_back({
        .id = "B-15", .name = "coordinate modulo 1", .inputs = 1, .outputs = 1, .ours = BODY(y[0] = wrapUnit(x[0]);),
        .published = BODY(y[0] = wrapTruncated(x[0]);), .samples = fromGroup("wrap", {"x"}, {"wrapped"}),
        .tolerance = 6e-8, .methodTolerance = 6e-8, .low = 0, .high = 0.99999994039535522,
        .error = [](double got, double want, double scale) {
            return got < 0 || got >= 1 ? std::abs(got - want) : circleError(got, want, scale);
        }
    });
    rows.push_back({
        .id = "B-17", .name = "place in a patch, 512 texels, of 180,000 cells", .inputs = 3, .outputs = 1,
        .ours = BODY(y[0] = patchCoordinate(x[1], real(1.0)) * 512.0f;),
        .published = BODY(y[0] = patchCoordinatePublished((x[0] + x[1]) / x[2], x[2]) * 512.0f;),
        .samples = sweep(2000,
                         [](Sweep& s, int) {
                             return std::vector<double>{double(s.whole(0, 179999)), s.unit(), 180000.0};
                         }),
        .tolerance = 1e-4, .low = 0, .high = 512,
        .error = [](double got, double want, double) { return 512 * circleError(got / 512, want / 512, 1.0); }
    });
    rows.push_back({
        .id = "B-18", .name = "signs of a cell's mirroring, magnitude", .inputs = 3, .outputs = 2,
        .ours = BODY(vec2 m = cellMirror(cellHash(int(x[0]), int(x[1]), 1u)); y[0] = abs(m.x); y[1] = abs(m.y);),
        .published = BODY(vec2 a = cellMirror(cellHash(int(x[0]), int(x[1]), 1u));
                          vec2 b = cellMirror(cellHash(int(x[0]) + 1, int(x[1]), 1u)); vec2 m = mix(a, b, x[2]);
                          y[0] = abs(m.x); y[1] = abs(m.y);),
        .samples =
            [](const ExpectedValues&) {
                FormulaSamples samples;
                Sweep s(18);
                for (int i = 0; i < 500; ++i)
                    samples.add({double(s.whole(-90000, 90000)), double(s.whole(-90000, 90000)), s.unit()}, {1, 1});
                return samples;
            },
        .low = 1, .high = 1
    });
}

void addShapeCases(std::vector<FormulaRow>& rows) {
    rows.push_back({
        .id = "B-19", .name = "tip of a blade, metres, whatever its segments", .inputs = 5, .outputs = 3,
        .ours = BODY(BladeShape s = bladeShape(x[0], x[1], x[2], x[3]);
                     vec3 p = bladePosition(s.control, s.tip, real(1.0)); y[0] = p.x; y[1] = p.y; y[2] = p.z;),
        .published = kEulerTip,
        .samples = sweep(800,
                         [](Sweep& s, int i) {
                             return std::vector<double>{s.in(0.05, 0.4), s.in(0, 0.9), s.in(0, 0.6), s.in(-3, 3),
                                                        double(2 << (i % 4))};
                         }),
        .tolerance = 1e-6, .gpuTolerance = 1e-5, .low = -2, .high = 2
    });
    rows.push_back({
        .id = "B-19", .name = "frame of a blade, upright and at its apex too", .inputs = 5, .outputs = 6,
        .ours = BODY(BladeShape s = bladeShape(x[0], x[1], x[2], x[3]);
                     BladeFrame f = bladeFrame(s.control, s.tip, x[3], x[4]); y[0] = f.tangent.x; y[1] = f.tangent.y;
                     y[2] = f.tangent.z; y[3] = f.normal.x; y[4] = f.normal.y; y[5] = f.normal.z;),
        .published = kCrossFrame,
        .samples =
            sweep(800,
                  [](Sweep& s, int i) {
                      const bool upright = i % 4 == 0;
                      return std::vector<double>{i % 10 == 0 ? 0.0 : s.in(0.05, 0.4), upright ? 0.0 : s.in(0.01, 1.2),
                                                 upright ? 0.5 * (i % 3) : s.in(0, 0.9), s.in(-3, 3), 0.25 * (i % 5)};
                  }),
        .tolerance = 4e-6, .gpuTolerance = 5e-5, .low = -1.00001, .high = 1.00001
    });
}

const FormulaBody kSunShadow = BODY(GroundShadow g = shadowOfSun(x[0], vec3(x[1], x[2], x[3]), real(2.0));
                                    y[0] = g.offset.x; y[1] = g.offset.y; y[2] = g.alpha;);

void addShadowCases(std::vector<FormulaRow>& rows) {
    rows.push_back({
        .id = "B-20", .name = "ground shadow of a blade, sun at and below the horizon", .inputs = 4, .outputs = 3,
        .ours = kSunShadow,
        .published =
            BODY(vec2 o = shadowPublished(x[0], vec3(x[1], x[2], x[3])); y[0] = o.x; y[1] = o.y; y[2] = real(1.0);),
        .samples = sweep(1000,
                         [](Sweep& s, int i) {
                             const double up = i % 10 == 0 ? 0.0 : s.in(-0.3, 1.4), a = s.in(-3, 3);
                             return std::vector<double>{s.in(0, 0.4), double(float(std::cos(up) * std::cos(a))),
                                                        double(float(std::sin(up))),
                                                        double(float(std::cos(up) * std::sin(a)))};
                         }),
        .tolerance = 1e-6, .gpuTolerance = 2e-6, .low = -2.00001, .high = 2.00001
    });
    rows.push_back({
        .id = "B-20", .name = "ground shadow of a blade by a lantern", .inputs = 6, .outputs = 3,
        .ours = BODY(GroundShadow g = shadowOfLamp(vec3(x[0], x[1], x[2]), vec3(x[3], x[4], x[5]), real(2.0));
                     y[0] = g.offset.x; y[1] = g.offset.y; y[2] = g.alpha;),
        .published = BODY(vec2 o = shadowPublished(x[1], vec3(x[3] - x[0], x[4] - x[1], x[5] - x[2])); y[0] = o.x;
                          y[1] = o.y; y[2] = real(1.0);),
        .samples = sweep(1000,
                         [](Sweep& s, int i) {
                             const double h = s.in(0, 0.4);
                             return std::vector<double>{
                                 s.in(-1, 1), h, s.in(-1, 1), s.in(-1, 1), i % 8 == 0 ? h : s.in(0, 1), s.in(-1, 1)};
                         }),
        .tolerance = 1e-6, .gpuTolerance = 2e-6, .low = -2.00001, .high = 2.00001
    });
    rows.push_back({
        .id = "B-21", .name = "way out of the shadow mask's cylinder, relative", .inputs = 7, .outputs = 1,
        .ours = BODY(y[0] = cylinderExit(vec3(x[0], x[1], x[2]), vec3(x[3], x[4], x[5]), x[6]);),
        .published = BODY(y[0] = cylinderExitPublished(vec3(x[0], x[1], x[2]), vec3(x[3], x[4], x[5]), x[6]);),
        .samples = fromGroup("shadow_cylinder", {"o", "d", "R"}, {"t"}, relativeUnit), .tolerance = 1e-4,
        .methodTolerance = 1e-9, .low = 0, .high = 1e20, .error = [](double got, double want, double scale) {
            if (want >= 1e300) return std::isfinite(got) && got > 1e6 ? 0.0 : std::abs(got - want);
            return std::abs(got - want) / scale;
        }
    });
    rows.push_back({
        .id = "B-21", .name = "mask coordinates of points in and out of the cylinder, light along its axis too",
        .inputs = 8, .outputs = 3,
        .ours = BODY(MaskPoint p = maskPointOf(vec3(x[0], x[1], x[2]), vec2(x[3], x[4]), vec3(x[5], x[6], x[7]),
                                               real(0.05), real(0.1));
                     y[0] = wrapUnit(p.turn); y[1] = p.height; y[2] = p.rise;),
        .samples = listed({{0, 0, 0, 1, 0, 0, 1, 0},
                           {0, 0.02, 0, 0, 1, 0.6, 0.8, 0},
                           {0, 0.02, 0, 1, 0, -0.6, 0.8, 0},
                           {0.2, 0, 0, 1, 0, 0.6, 0.8, 0},
                           {0, 0.02, 0.03125, 1, 0, 0.6, 0.8, 0},
                           {0, 0.05, 0, 1, 0, 0.6, -0.8, 0},
                           {0.01, 0.05, 0, 1, 0, 0, 0, 0}},
                          {{0, 0, 1},
                           {0.75, 0.2, 4 / 7.0},
                           {0.5, 0.2, 4 / 7.0},
                           {0, 0, 4 / 7.0},
                           {0.03125 / (0.05 * 6.283185307179586), 0.2, 4 / 7.0},
                           {0, 0.5, 0},
                           {0, 0.5, 0}}),
        .tolerance = 2e-6, .gpuTolerance = 1e-5, .methodTolerance = 1e-6, .low = 0, .high = 1,
        .error = [](double got, double want, double) {
            return std::min(std::abs(got - want), std::abs(std::abs(got - want) - 1));
        }
    });
    rows.push_back({
        .id = "B-22", .name = "point light seen from where it is", .inputs = 4, .outputs = 4,
        .ours = BODY(PointLight p = pointLight(vec3(x[0], x[1], x[2]), x[3]); y[0] = p.direction.x;
                     y[1] = p.direction.y; y[2] = p.direction.z; y[3] = p.attenuation;),
        .published = BODY(vec3 l = vec3(x[0], x[1], x[2]); vec3 d = l / sqrt(dot(l, l)); y[0] = d.x; y[1] = d.y;
                          y[2] = d.z; y[3] = 1.0f / (1.0f + x[3] * dot(l, l));),
        .samples = listed({{0, 0, 0, 1}, {1e-25, 0, 0, 1}, {0, -2, 0, 0.5}, {3, 4, 0, 1}, {3e-20, 4e-20, 0, 0}}),
        .tolerance = 3e-7, .low = -1.000001, .high = 1.000001
    });
}

void addGridCases(std::vector<FormulaRow>& rows) {
    rows.push_back({
        .id = "B-23", .name = "level of a macro-cell, the eye inside its sphere too", .inputs = 3, .outputs = 1,
        .ours = BODY(y[0] = real(macroLevel(x[0], x[1], x[2], 12));),
        .published = BODY(y[0] = macroLevelPublished(x[0], x[1], x[2]);),
        .samples = listed(
            {{0, 5, 10}, {5, 5, 10}, {6, 5, 10}, {15, 5, 10}, {24, 5, 10}, {25, 5, 10}, {85, 5, 10}, {1e9, 5, 10}},
            {{0}, {0}, {0}, {0}, {0}, {1}, {3}, {12}}),
        .low = 0, .high = 12
    });
    rows.push_back({
        .id = "B-24", .name = "cells by which a blade's root lies outside its own", .inputs = 2, .outputs = 1,
        .ours = BODY(uint h = (uint(x[0]) << 16) | uint(x[1]); y[0] = floor(hashUnit(h));),
        .published =
            BODY(uint h = (uint(x[0]) << 16) | uint(x[1]); y[0] = floor(real(h) * real(2.3283064365386963e-10));),
        .samples =
            [](const ExpectedValues&) {
                FormulaSamples samples;
                for (int low : {0, 1, 255, 65407, 65408, 65535})
                    for (int high : {0, 1, 32768, 65534, 65535}) samples.add({double(high), double(low)}, {0});
                return samples;
            },
        .low = 0, .high = 0
    });
    rows.push_back({
        .id = "B-25", .name = "slices that capture a blade on their boundary", .inputs = 2, .outputs = 1,
        .ours = BODY(int n = int(x[1]); real at = x[0] / x[1]; int hits = 0; for (int k = 0; k < n; k++) {
            if (captureSlice(at, n) == k && at >= real(k) / real(n)) hits++;
        } y[0] = real(hits);),
        .published = BODY(int n = int(x[1]); real at = x[0] / x[1]; real width = 1.0f / x[1]; int hits = 0;
                          for (int k = 0; k < n; k++) {
                              if (at >= real(k) * width && at <= real(k + 1) * width) hits++;
                          } y[0] = real(hits);),
        .samples =
            [](const ExpectedValues&) {
                FormulaSamples samples;
                for (int n : {8, 10, 20, 49})
                    for (int k = 0; k < n; ++k) samples.add({double(k), double(n)}, {1});
                return samples;
            },
        .low = 1, .high = 1
    });
}

}  // namespace

void addHybridShapeRows(std::vector<FormulaRow>& rows) {
    addTilingCases(rows);
    addShapeCases(rows);
    addShadowCases(rows);
    addGridCases(rows);
}

}  // namespace sward
