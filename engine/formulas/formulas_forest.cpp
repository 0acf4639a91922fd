// Rows of Decaudin, Neyret 2004: opacity correction, tilted slices, pyramids of slices.
// clang-format off: bodies are laid out as the shader lines that they become
#include "formulas/formula_table.h"

namespace sward {
namespace {

const FormulaBody kTaylor = BODY(y[0] = correctionTaylor(x[0], x[1]););

// Opacities of 8 bits and path ratios of 1 to 16, with the C library's own functions as truth.
FormulaSamples correctionSweep(const ExpectedValues&) {
    FormulaSamples samples;
    Sweep s(41);
    for (int i = 0; i < 4000; ++i) {
        const double a = double(float(s.whole(1, 255)) / 255.0f), k = s.in(1, 16);
        samples.add({a, k}, {a >= 1 ? 1.0 : -std::expm1(k * std::log1p(-a))});
    }
    return samples;
}

FormulaSamples thinLayers(const ExpectedValues&) {
    FormulaSamples samples;
    Sweep s(42);
    for (int i = 0; i < 2000; ++i) {
        const double a = s.size(1e-7, 1e-2), k = s.in(1, 16), want = -std::expm1(k * std::log1p(-a));
        samples.add({a, k}, {want}, {want});
    }
    return samples;
}

void addCorrectionCases(std::vector<FormulaRow>& rows) {
    const FormulaBody series = BODY(y[0] = opacityCorrected(x[0], x[1]););
    rows.push_back({.id = "D-1",
                    .name = "opacity correction, series, relative",
                    .inputs = 2,
                    .outputs = 1,
                    .ours = series,
                    .published = kTaylor,
                    .samples = fromGroup("opacity_correction", {"A", "k"}, {"expected"}, relativeUnit),
                    .tolerance = 4e-6,
                    .gpuTolerance = 2e-5,
                    .methodTolerance = 6e-7,
                    .low = 0,
                    .high = 1});
    rows.push_back({
        .id = "D-1", .name = "opacity correction, pow", .inputs = 2, .outputs = 1,
        .ours = BODY(y[0] = correctionPow(x[0], x[1]);), .published = kTaylor, .samples = correctionSweep,
        .tolerance = 1e-6, .gpuTolerance = 4e-6, .low = 0, .high = 1
    });
    rows.push_back({
        .id = "D-1", .name = "opacity correction, hyperbola", .inputs = 2, .outputs = 1,
        .ours = BODY(y[0] = correctionHyperbola(x[0], x[1]);), .published = kTaylor, .samples = correctionSweep,
        .tolerance = 0.19, .methodTolerance = 0.19, .low = 0, .high = 1.0000002
    });
    rows.push_back({.id = "D-1",
                    .name = "opacity correction of thin layers, relative",
                    .inputs = 2,
                    .outputs = 1,
                    .ours = series,
                    .published = kTaylor,
                    .samples = thinLayers,
                    .tolerance = 4e-7,
                    .gpuTolerance = 1e-6,
                    .methodTolerance = 2e-7,
                    .low = 0,
                    .high = 1});
    rows.push_back({
        .id = "D-2", .name = "premultiplied colour of a corrected layer", .inputs = 5, .outputs = 4,
        .ours = BODY(vec4 c = colorCorrected(vec4(x[0], x[1], x[2], x[3]), x[4]); y[0] = c.x; y[1] = c.y; y[2] = c.z;
                     y[3] = c.w;),
        .published = BODY(vec4 c = colorCorrectedPublished(vec4(x[0], x[1], x[2], x[3]), x[4]); y[0] = c.x; y[1] = c.y;
                          y[2] = c.z; y[3] = c.w;),
        .samples =
            listed({{0.2, 0.4, 0.1, 0.5, 4}, {0, 0, 0, 0, 16}, {0.3, 0.2, 0.1, 1, 8}, {0.05, 0.04, 0.01, 0.05, 2}}, {}),
        .tolerance = 1e-6, .gpuTolerance = 4e-6, .low = 0, .high = 1.0000002
    });
    rows.push_back({
        .id = "D-3", .name = "slant between a vertex seen edge-on and one seen flat", .inputs = 5, .outputs = 1,
        .ours = BODY(vec3 n = unitOr(mix(vec3(x[0], real(0.0), x[1]), vec3(x[2], real(0.0), x[3]), x[4]), kTiny,
                                     vec3(0.0f, 0.0f, 1.0f));
                     y[0] = slantFactor(n, vec3(0.0f, 0.0f, -1.0f)) / 1.0f;),
        .published = BODY(real a = x[1] / abs(x[1]); real b = x[3] / abs(x[3]); y[0] = mix(a, b, x[4]);),
        .samples = listed({{1, 0, 0, 1, 0.5}, {1, 0, 0.6, 0.8, 0.25}, {0.6, 0.8, 0, 1, 0.5}}, {{1}, {1}, {1}}),
        .tolerance = 2e-6, .low = 0, .high = 1e6
    });
}

double tiltUnit(const ExpectedRecord& record, size_t, double) { return record.at("kM")[0] + record.at("dhp")[0]; }

const FormulaBody kTiltOffsets =
    BODY(Tilt t = tiltOf(vec3(x[0], x[1], x[2]), vec3(x[3], x[4], x[5]), vec3(x[6], x[7], x[8]),
                         vec3(x[9], x[10], x[11]), x[12], x[13], x[14] / pow(real(2.0), x[15]));
         y[0] = t.offset.x; y[1] = t.offset.y; y[2] = t.offset.z; y[3] = t.rise;);
const FormulaBody kTiltOffsetsPublished =
    BODY(Tilt t = tiltPublished(vec3(x[0], x[1], x[2]), vec3(x[3], x[4], x[5]), vec3(x[6], x[7], x[8]),
                                vec3(x[9], x[10], x[11]), x[12], x[13], x[14] / pow(real(2.0), x[15]));
         y[0] = t.offset.x; y[1] = t.offset.y; y[2] = t.offset.z; y[3] = t.rise;);
const FormulaBody kTiltCount =
    BODY(Tilt t = tiltOf(vec3(x[0], x[1], x[2]), vec3(x[3], x[4], x[5]), vec3(x[6], x[7], x[8]),
                         vec3(x[9], x[10], x[11]), x[12], x[13], x[14] / pow(real(2.0), x[15]));
         y[0] = t.count;);
const FormulaBody kTiltCountPublished =
    BODY(Tilt t = tiltPublished(vec3(x[0], x[1], x[2]), vec3(x[3], x[4], x[5]), vec3(x[6], x[7], x[8]),
                                vec3(x[9], x[10], x[11]), x[12], x[13], x[14] / pow(real(2.0), x[15]));
         y[0] = t.count;);
const FormulaBody kTiltSlices =
    BODY(Tilt t = tiltOf(vec3(x[0], x[1], x[2]), vec3(x[3], x[4], x[5]), vec3(x[6], x[7], x[8]),
                         vec3(x[9], x[10], x[11]), x[12], x[13], x[14] / pow(real(2.0), x[15]));
         y[0] = real(sliceCount(t.count, 4096)););

void addTiltCases(std::vector<FormulaRow>& rows) {
    const std::vector<std::string> in = {"P", "V", "kM", "h", "L", "l"};
    rows.push_back({.id = "D-4",
                    .name = "offsets of tilted slices, in units of slant",
                    .inputs = 16,
                    .outputs = 4,
                    .ours = kTiltOffsets,
                    .published = kTiltOffsetsPublished,
                    .samples = fromGroup("tilt", in, {"off", "dhp"}, tiltUnit),
                    .tolerance = 4e-6,
                    .methodTolerance = 1e-9,
                    .low = -1e6,
                    .high = 1e6});
    rows.push_back({.id = "D-5",
                    .name = "number of slices before rounding, relative",
                    .inputs = 16,
                    .outputs = 1,
                    .ours = kTiltCount,
                    .published = kTiltCountPublished,
                    .samples = fromGroup("tilt", in, {"n_real"}, relativeUnit),
                    .tolerance = 1e-6,
                    .gpuTolerance = 4e-6,
                    .methodTolerance = 1e-9,
                    .low = 0,
                    .high = 1e6});
    rows.push_back({.id = "D-5",
                    .name = "number of slices",
                    .inputs = 16,
                    .outputs = 1,
                    .ours = kTiltSlices,
                    .published = kTiltCountPublished,
                    .samples = fromGroup("tilt", in, {"n_int"}),
                    .low = 2,
                    .high = 4096});
}

// What 2^level slices of one opacity add up to, as a pyramid of pairs.
void addPyramidCases(std::vector<FormulaRow>& rows) {
    rows.push_back({
        .id = "D-6", .name = "opacity factor of ground triangles, 0 where forest cannot grow", .inputs = 9,
        .outputs = 1,
        .ours = BODY(vec3 a = vec3(x[0], x[1], x[2]); vec3 b = vec3(x[3], x[4], x[5]); vec3 c = vec3(x[6], x[7], x[8]);
                     y[0] = groundUsable(a, b, c) ? real(1.0) : real(0.0);),
        .published =
            BODY(vec3 n = triangleNormal(vec3(x[0], x[1], x[2]), vec3(x[3], x[4], x[5]), vec3(x[6], x[7], x[8]));
                 vec3 u = n / sqrt(dot(n, n)); y[0] = abs(u.z) / abs(u.z);),
        .samples = listed({{0, 0, 0, 1, 0, 0, 0, 1, 0},
                           {0, 0, 0, 1, 0, 0, 0, 0, 1},
                           {0, 0, 0, 1, 0, 0, 2, 0, 0},
                           {0, 0, 0, 1e-20, 0, 0, 0, 1e-20, 0},
                           {90000, 0, 0, 90001, 0, 0, 90000, 1, 0.5},
                           {1, 1, 1, 1, 1, 1, 1, 1, 1}},
                          {{1}, {0}, {0}, {0}, {1}, {0}}),
        .low = 0, .high = 1
    });
    rows.push_back({
        .id = "D-7", .name = "opacity of 128 slices built as a pyramid", .inputs = 1, .outputs = 1,
        .ours = BODY(real a = x[0];
                     for (int i = 0; i < 7; i++) { a = a + (1.0f - a) * a; } y[0] = floor(a * 255.0f + 0.5f) / 255.0f;),
        .published = BODY(real a = floor(x[0] * 255.0f + 0.5f) / 255.0f; for (int i = 0; i < 7; i++) {
            a = floor((a + (1.0f - a) * a) * 255.0f + 0.5f) / 255.0f;
        } y[0] = a;),
        .samples =
            [](const ExpectedValues&) {
                FormulaSamples samples;
                for (float a : {0.002f, 0.005f, 0.01f, 0.0123f, 0.03f, 0.05f})
                    samples.add({double(a)}, {1 - std::pow(1 - double(a), 128)});
                return samples;
            },
        .tolerance = 0.00197, .methodTolerance = 0.00197, .low = 0, .high = 1
    });
    rows.push_back({
        .id = "D-8", .name = "level of a pyramid, degenerate sizes too", .inputs = 2, .outputs = 1,
        .ours = BODY(y[0] = pyramidLevel(x[0], int(x[1]));), .published = BODY(y[0] = log2(x[0]);),
        .samples = listed({{0, 6}, {0.25, 6}, {1, 6}, {3, 6}, {64, 6}, {1e30, 6}, {8, 0}}, {}), .tolerance = 1e-6,
        .gpuTolerance = 2e-5, .low = 0, .high = 6
    });
}

// Where tiles lie, and how their leaves are lit: no hard cases of the paper, but the same on CPU and GPU.
void addTileRows(std::vector<FormulaRow>& rows) {
    rows.push_back({
        .name = "colours around a tile of forest, and where it is stored", .inputs = 4, .outputs = 5,
        .ours = BODY(EdgeColors c = edgeColors(int(x[0]), int(x[1]), x[2] > 0.5f, uint(int(x[3])), 2);
                     vec2 cell = tileCell(c); y[0] = real(c.row); y[1] = real(c.slant); y[2] = real(c.across);
                     y[3] = cell.x; y[4] = cell.y;),
        .samples = sweep(1000,
                         [](Sweep& s, int i) {
                             return std::vector<double>{double(s.whole(-9000, 9000)), double(s.whole(-9000, 9000)),
                                                        double(i % 2), double(s.whole(0, 999))};
                         }),
        .low = 0, .high = 1
    });
    rows.push_back({
        .name = "places on the lattice of a forest, there and back", .inputs = 3, .outputs = 2,
        .ours = BODY(vec2 uv = toLattice(vec2(x[0], x[1]), x[2]); vec2 back = fromLattice(uv, x[2]);
                     y[0] = (back.x - x[0]) / x[2]; y[1] = (back.y - x[1]) / x[2];),
        .samples = sweep(1000,
                         [](Sweep& s, int) {
                             return std::vector<double>{s.in(-50, 50), s.in(-50, 50), s.in(2, 60)};
                         }),
        .tolerance = 2e-5, .low = -1e-4, .high = 1e-4
    });
    rows.push_back({
        .name = "light that leaves in all directions send back", .inputs = 1, .outputs = 1,
        .ours = BODY(y[0] = foliagePhase(x[0]);),
        .samples =
            [](const ExpectedValues&) {
                FormulaSamples samples;
                for (int i = -1024; i <= 1024; ++i) {
                    const double c = i / 1024.0, a = std::acos(c), pi = std::acos(-1.0);
                    samples.add({c}, {2 / (3 * pi) * (std::sin(a) + (pi - a) * c)});
                }
                return samples;
            },
        .tolerance = 1e-6, .gpuTolerance = 4e-6, .low = 0, .high = 0.66667
    });
}

}  // namespace

void addForestRows(std::vector<FormulaRow>& rows) {
    addCorrectionCases(rows);
    addTiltCases(rows);
    addPyramidCases(rows);
    addTileRows(rows);
}

}  // namespace sward
