// Rows of Jahrmann, Wimmer 2013: wind, random values, tessellation levels, spline frames, blade counts.
// clang-format off: bodies are laid out as the shader lines that they become
#include "formulas/formula_table.h"

namespace sward {

std::vector<double> windInputs(double px, double pz, double t, const double c[3], double eps) {
    const double cellX = 8 * std::floor(px / 8), cellZ = 8 * std::floor(pz / 8);
    const f64::WindPhase p = f64::windPhase(cellX, cellZ, t, c[0], c[1], c[2]);
    std::vector<double> in = {p.first, p.second, p.across, px - cellX, pz - cellZ, c[0], c[1], c[2], eps, px, pz, t};
    for (double& v : in) v = double(float(v));
    return in;
}

namespace {

// Tolerance 4e-6 + 5e-7 da/dpz: what float positions can reach at the sensitivity of the phase.
FormulaSamples windSamples(const ExpectedValues& values) {
    FormulaSamples samples;
    const auto group = values.find("wind");
    if (group == values.end()) return samples;
    for (const ExpectedRecord& r : group->second) {
        const auto v = [&](const char* field) { return r.at(field)[0]; };
        const double c[3] = {v("c1"), v("c2"), v("c3")};
        samples.add(windInputs(v("px"), v("pz"), v("t"), c, v("eps")), {v("w")}, {1 + 0.125 * std::abs(v("da_dpz"))});
    }
    return samples;
}

// Neighbours 1 cm apart astride the lines z = (2k+1) / (2 c2): how much more they differ than the bound allows.
FormulaSamples windSpikes(const ExpectedValues&) {
    FormulaSamples samples;
    Sweep s(102);
    const double c[3] = {1, 0.5, 0.7};
    for (int i = 0; i < 400; ++i) {
        const double z = (2 * s.whole(0, 45000) + 1) / (2 * c[1]), eps = i % 2 ? 0.1 : 0.3, t = s.in(0, 604800);
        const double bound = (c[0] + c[2]) * 0.785398 * c[1] * 3.14159265 * 0.01 / (eps * eps);
        auto in = windInputs(s.in(0, 90000), z - 0.005, t, c, eps);
        in.push_back(0.01);
        samples.add(in, {std::min(bound, 2.0)});
    }
    return samples;
}

const FormulaBody kWind = BODY(WindPhase p; p.first = x[0]; p.second = x[1]; p.across = x[2];
                               y[0] = windAt(p, x[3], x[4], x[5], x[6], x[7], x[8]););

void addWindCases(std::vector<FormulaRow>& rows) {
    rows.push_back({
        .id = "J-1", .name = "wind far away and late, by its sensitivity", .inputs = 12, .outputs = 1, .ours = kWind,
        .published = BODY(y[0] = windPublished(x[9], x[10], x[11], x[5], x[6], x[7], x[8]);), .samples = windSamples,
        .tolerance = 4e-6, .gpuTolerance = 8e-6, .methodTolerance = 4e-6, .low = -1.000001, .high = 1.000001
    });
    rows.push_back({
        .id = "J-2", .name = "wind between blades 1 cm apart, above its bound", .inputs = 13, .outputs = 1,
        .ours = BODY(WindPhase p; p.first = x[0]; p.second = x[1]; p.across = x[2];
                     y[0] = abs(windAt(p, x[3], x[4] + x[12], x[5], x[6], x[7], x[8]) -
                                windAt(p, x[3], x[4], x[5], x[6], x[7], x[8]));),
        .published = BODY(y[0] = abs(windPublished(x[9], x[10] + x[12], x[11], x[5], x[6], x[7], real(1e-6)) -
                                     windPublished(x[9], x[10], x[11], x[5], x[6], x[7], real(1e-6)));),
        .samples = windSpikes, .tolerance = 1e-4, .methodTolerance = 1e-4, .low = 0, .high = 2, .error = excessError
    });
}

// Pearson's chi-square per degree of freedom of 32 bins, over 64 x 64 blades of a cell row.
const FormulaBody kRandomUniform = BODY(
    int bins[32]; for (int i = 0; i < 32; i++) { bins[i] = 0; } for (int i = 0; i < 4096; i++) {
        bins[int(hashUnit(hash3(uint(i % 64), uint(i / 64), uint(x[0]))) * 32.0f)]++;
    } real chi = 0.0f;
    for (int i = 0; i < 32; i++) { chi += real((bins[i] - 128) * (bins[i] - 128)); } y[0] = chi / 3968.0f;);
const FormulaBody kRandomPublished = BODY(
    int bins[32]; for (int i = 0; i < 32; i++) { bins[i] = 0; } for (int i = 0; i < 4096; i++) {
        real r = randomEq10(real(0.7), real(i % 64), real(i / 64));
        if (!(r >= 0.0f)) r = 0.0f;
        bins[int(r * 32.0f)]++;
    } real chi = 0.0f;
    for (int i = 0; i < 32; i++) { chi += real((bins[i] - 128) * (bins[i] - 128)); } y[0] = chi / 3968.0f;);

void addRandomCases(std::vector<FormulaRow>& rows) {
    // 31 degrees of freedom: 1 +- 0.25; 2.2 is beyond all but one in a million.
    rows.push_back({.id = "J-3",
                    .name = "random values: chi-square per degree of freedom above 1",
                    .inputs = 1,
                    .outputs = 1,
                    .ours = kRandomUniform,
                    .published = kRandomPublished,
                    .samples = listed({{0}, {1}, {2}, {3}, {180000}}, {{1}, {1}, {1}, {1}, {1}}),
                    .tolerance = 1.2,
                    .methodTolerance = 1.2,
                    .low = 0,
                    .high = 1e9,
                    .error = excessError});
    rows.push_back({
        .id = "J-3", .name = "random values of eqs 11 and 12 outside [0, 1) or stuck at 0", .inputs = 2, .outputs = 1,
        .ours = BODY(real r = hashUnit(hash2(uint(int(x[0])), uint(int(x[1]))));
                     y[0] = r > 0.0f && r < 1.0f ? real(0.0) : real(1.0);),
        .published = BODY(real a = randomEq11(x[1], x[0], real(100.0)); real b = randomEq12(x[1], x[0], real(3.0));
                          y[0] = a > 0.0f && a < 1.0f && b > 0.0f && b < 1.0f ? real(0.0) : real(1.0);),
        .samples = listed({{0, 0.5}, {17, 0.5}, {1, 0.25}, {99, 0.9}}, {{0}, {0}, {0}, {0}}), .low = 0, .high = 0
    });
}

// Within 1e-4 above an integer one level less is accepted.
// Levels are exact; of scale kEither one less is as good.
constexpr double kEither = 2;
double levelError(double got, double want, double scale) {
    return scale == kEither ? std::min(std::abs(got - want), std::abs(got - (want - 1))) : std::abs(got - want);
}

FormulaSamples tessSamples(const ExpectedValues& values) {
    FormulaSamples samples;
    const auto group = values.find("tess_level");
    if (group == values.end()) return samples;
    for (const ExpectedRecord& r : group->second) {
        const double s = r.at("s")[0], d = r.at("d")[0], most = r.at("dmax")[0];
        const double level = most > 0 ? s * (1 - d / most) : 0;
        const bool either = level - std::floor(level) > 0 && level - std::floor(level) < 1e-4;
        samples.add({s, d, most}, r.at("level"), {either ? kEither : 1.0});
    }
    return samples;
}

void addLevelCases(std::vector<FormulaRow>& rows) {
    rows.push_back({
        .id = "J-5", .name = "tessellation level by distance", .inputs = 3, .outputs = 1,
        .ours = BODY(y[0] = real(tessLevel(x[0], x[1], x[2]));),
        .published = BODY(y[0] = tessLevelPublished(x[0], x[1], x[2]);), .samples = tessSamples, .low = 0, .high = 64,
        .error = levelError
    });
    rows.push_back({
        .id = "J-5", .name = "tessellation level beyond every limit", .inputs = 3, .outputs = 1,
        .ours = BODY(y[0] = real(tessLevel(x[0], x[1], x[2]));),
        .published = BODY(y[0] = tessLevelPublished(x[0], x[1], x[2]);),
        .samples = listed({{8, 250, 100}, {8, 5, 0}, {200, 0, 100}, {8, 3e38, 100}, {10, 10, 100}, {0, 1, 2}},
                          {{0}, {0}, {64}, {0}, {9}, {0}}),
        .low = 0, .high = 64
    });
    rows.push_back({
        .id = "J-6", .name = "tessellation level by size on screen", .inputs = 8, .outputs = 1,
        .ours = BODY(y[0] = real(tessLevelOnScreen(vec4(x[0], x[1], real(0.0), x[2]), vec4(x[3], x[4], real(0.0), x[5]),
                                                   vec2(real(1024.0), real(768.0)), real(0.1), x[6], x[7]));),
        .published = BODY(
            y[0] = ceil(tessLevelOnScreenPublished(vec4(x[0], x[1], real(0.0), x[2]), vec4(x[3], x[4], real(0.0), x[5]),
                                                   vec2(real(1024.0), real(768.0)), x[6], x[7]));),
        // root (x, y, w), tip (x, y, w), pixels per quad, smoothness: upright, leaning to the viewer, sideways, near
        // end behind, both behind, a point
            .samples = listed({{0, 0, 2, 0, 0.25, 2, 8, 16},
                               {0, 0, 2, 0, -0.25, 2, 8, 16},
                               {0, 0, 2, 0.5, 0, 2, 8, 16},
                               {0, 0, 2, 0, -0.5, 0, 8, 16},
                               {0, 0, -1, 0, 0.2, -1, 8, 16},
                               {0, 0, 2, 0, 0, 2, 8, 16}},
                              {{6}, {6}, {16}, {16}, {0}, {1}}),
        .low = 0, .high = 64
    });
}

// Positions far from the origin: within half a float's step there, where that is more than rounding on the way to it.
constexpr double kSplineTolerance = 2e-6;
double splineUnit(const ExpectedRecord&, size_t output, double want) {
    if (output >= 3) return 1.0;
    const float at = std::abs(static_cast<float>(want)),
                next = std::nextafter(at, std::numeric_limits<float>::infinity());
    const double near = kSplineTolerance + std::abs(want) * 1.2e-7, halfStep = 0.5 * (double(next) - double(at));
    return std::min(near, std::max(4e-6, halfStep)) / kSplineTolerance;
}

void addSplineCases(std::vector<FormulaRow>& rows) {
    rows.push_back({
        .id = "J-7", .name = "frame of a blade between two splines", .inputs = 23, .outputs = 12,
        .ours = BODY(SplineFrame f = splineFrame(vec3(x[0], x[1], x[2]), vec3(x[3], x[4], x[5]), vec3(x[6], x[7], x[8]),
                                                 vec3(x[9], x[10], x[11]), vec3(x[12], x[13], x[14]),
                                                 vec3(x[15], x[16], x[17]), vec3(x[18], x[19], x[20]), x[21], x[22]);
                     y[0] = f.position.x; y[1] = f.position.y; y[2] = f.position.z; y[3] = f.tangent.x;
                     y[4] = f.tangent.y; y[5] = f.tangent.z; y[6] = f.bitangent.x; y[7] = f.bitangent.y;
                     y[8] = f.bitangent.z; y[9] = f.normal.x; y[10] = f.normal.y; y[11] = f.normal.z;),
        .published =
            BODY(SplineFrame f = splineFramePublished(
                     vec3(x[0], x[1], x[2]), vec3(x[3], x[4], x[5]), vec3(x[6], x[7], x[8]), vec3(x[9], x[10], x[11]),
                     vec3(x[12], x[13], x[14]), vec3(x[15], x[16], x[17]), x[21], x[22]);
                 y[0] = f.position.x; y[1] = f.position.y; y[2] = f.position.z; y[3] = f.tangent.x; y[4] = f.tangent.y;
                 y[5] = f.tangent.z; y[6] = f.bitangent.x; y[7] = f.bitangent.y; y[8] = f.bitangent.z;
                 y[9] = f.normal.x; y[10] = f.normal.y; y[11] = f.normal.z;),
        .samples = fromGroup("spline_frames", {"left", "right", "side", "u", "v"}, {"pos", "T", "B", "N"}, splineUnit),
        .tolerance = kSplineTolerance, .methodTolerance = 2e-8, .low = -1e6, .high = 1e6
    });
    rows.push_back({
        .id = "J-9", .name = "mean blades of cells that expect few, where density is painted", .inputs = 2,
        .outputs = 1,
        .ours = BODY(int total = 0; Sown s = sownOf(x[0]); int n = sownBlades(x[0]); for (int i = 0; i < 4096; i++) {
            for (int rank = 0; rank < n; rank++) {
                real threshold = real(thresholdStep(n) * (rank + 1)) / real(kThresholds);
                total += thresholdIn(threshold, s, cellChance(i % 64, i / 64, 9u)) <= x[1] ? 1 : 0;
            }
        } y[0] = real(total) / 4096.0f;),
        .published = BODY(y[0] = floor(x[0] * x[1]);),
        .samples = listed({{0, 1}, {0.05, 1}, {0.5, 1}, {0.9, 1}, {0.9, 0.5}, {1, 1}, {1, 0.3}, {2.5, 1}, {2.5, 0}},
                          {{0}, {0.05}, {0.5}, {0.9}, {0.45}, {1}, {0.3}, {2.5}, {0}}),
        .tolerance = 0.024, .methodTolerance = 0.024, .low = 0, .high = 4
    });
}

}  // namespace

void addBladeRows(std::vector<FormulaRow>& rows) {
    addWindCases(rows);
    addRandomCases(rows);
    addLevelCases(rows);
    addSplineCases(rows);
}

}  // namespace sward
