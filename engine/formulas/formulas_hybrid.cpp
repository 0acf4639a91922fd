// Rows of Boulanger, Pattanaik, Bouatouch 2006: light weights, level of detail, opacity.
// clang-format off: bodies are laid out as the shader lines that they become
#include "formulas/formula_table.h"

namespace sward {
namespace {

const FormulaBody kEq13 = BODY(vec3 l = vec3(x[0], x[1], x[2]); LightWeights w = spreadWeights(l, weightsPublished(l));
                               y[0] = w.xPos; y[1] = w.yPos; y[2] = w.zPos; y[3] = w.xNeg; y[4] = w.zNeg;);

const FormulaBody kThreeAtan = BODY(LightWeights w = lightWeights(vec3(x[0], x[1], x[2])); y[0] = w.xPos; y[1] = w.yPos;
                                    y[2] = w.zPos; y[3] = w.xNeg; y[4] = w.zNeg;);

auto weightsGroup() { return fromGroup("spherical_weights", {"l"}, {"w"}); }

// The forms of the cost table; each spreads its octant's weights over the five images.
#define WEIGHT_FORM(form)                                                                                         \
    BODY(vec3 l = vec3(x[0], x[1], x[2]); LightWeights w = spreadWeights(l, form(lightOctant(l))); y[0] = w.xPos; \
         y[1] = w.yPos; y[2] = w.zPos; y[3] = w.xNeg; y[4] = w.zNeg;)

void addWeightForms(std::vector<FormulaRow>& rows) {
    const auto add = [&](const char* name, const FormulaBody& body, double error, double method, double gpu) {
        rows.push_back({.id = "B-1",
                        .name = name,
                        .inputs = 3,
                        .outputs = 5,
                        .ours = body,
                        .published = kEq13,
                        .samples = weightsGroup(),
                        .tolerance = error,
                        .gpuTolerance = gpu,
                        .methodTolerance = method,
                        .low = 0,
                        .high = 1.0000002});
    };
    add("light weights, three atan", WEIGHT_FORM(weightsThreeAtan), 4e-7, 1e-15, 1e-5);
    add("light weights, two atan and remainder", WEIGHT_FORM(weightsTwoAtan), 4e-7, 1e-15, 1e-5);
    add("light weights, degree 13", WEIGHT_FORM(weightsPoly13), 1.2e-6, 8e-7, 1.2e-6);
    add("light weights, degree 9", WEIGHT_FORM(weightsPoly9), 4e-5, 4e-5, 4e-5);
    add("light weights, degree 7", WEIGHT_FORM(weightsPoly7), 2.4e-4, 2.4e-4, 2.4e-4);
    add("light weights, degree 5", WEIGHT_FORM(weightsPoly5), 1.9e-3, 1.9e-3, 1.9e-3);
    add("light weights, degree 3", WEIGHT_FORM(weightsPoly3), 1.6e-2, 1.6e-2, 1.6e-2);
    add("light weights, normalised components", WEIGHT_FORM(weightsLinear), 6e-2, 6e-2, 6e-2);
    add("light weights, squares", WEIGHT_FORM(weightsSquares), 1.8e-1, 1.8e-1, 1.8e-1);
}

// Directions within 1e-2 of a quadrant plane, not on an axis.
std::vector<double> nearPlane(Sweep& s, int i) {
    const double angle = s.in(0.1, 1.4);
    const double off = s.size(1e-5, 1e-2);
    const double c = std::cos(angle), d = std::sin(angle);
    std::vector<double> l = i % 3 == 0   ? std::vector<double>{off, c, d}
                            : i % 3 == 1 ? std::vector<double>{c, off, d}
                                         : std::vector<double>{c, d, off};
    for (double& v : l) v = double(float(v));
    return l;
}

void addWeightCases(std::vector<FormulaRow>& rows) {
    rows.push_back({
        .id = "B-2", .name = "light weights near quadrant planes; eq 11 with sin from cos", .inputs = 3, .outputs = 5,
        .ours = kThreeAtan,
        .published = BODY(vec3 l = vec3(x[0], x[1], x[2]); LightWeights w = spreadWeights(l, weightsEq11(l));
                          y[0] = w.xPos; y[1] = w.yPos; y[2] = w.zPos; y[3] = w.xNeg; y[4] = w.zNeg;),
        .samples = sweep(3000, nearPlane), .tolerance = 4e-7, .gpuTolerance = 1e-5, .low = 0, .high = 1.0000002
    });
    rows.push_back({.id = "B-3",
                    .name = "small light weights, relative",
                    .inputs = 3,
                    .outputs = 5,
                    .ours = kThreeAtan,
                    .published = kEq13,
                    .samples = sweep(2000,
                                     [](Sweep& s, int) {
                                         return std::vector<double>{s.size(1e-13, 1e-3), 1.0, s.size(1e-13, 1e-3)};
                                     }),
                    .tolerance = 1e-6,
                    .gpuTolerance = 5e-5,
                    .low = 0,
                    .high = 1.0000002,
                    .error = [](double got, double want, double) { return relativeError(got, want, 1e-14); }});
    rows.push_back({.id = "B-4",
                    .name = "light weights below the horizon",
                    .inputs = 3,
                    .outputs = 5,
                    .ours = kThreeAtan,
                    .published = kEq13,
                    .samples = sweep(1000,
                                     [](Sweep& s, int) {
                                         return std::vector<double>{s.in(-1, 1), s.in(-0.5, 0), s.in(-1, 1)};
                                     }),
                    .tolerance = 4e-7,
                    .gpuTolerance = 1e-5,
                    .low = 0,
                    .high = 1.0000002});
    rows.push_back({
        .id = "B-4", .name = "diffuse light over the horizon", .inputs = 2, .outputs = 1,
        .ours = BODY(y[0] = horizonFade(x[0], x[1]);), .published = BODY(y[0] = x[0] / x[1];),
        .samples = listed({{-0.5, 0.05}, {0, 0.05}, {-1e-9, 0.05}, {0, 0}, {0.025, 0.05}, {0.4, 0.05}},
                          {{0}, {0}, {0}, {0}, {0.5}, {1}}),
        .tolerance = 2e-7, .methodTolerance = 2e-7, .low = 0, .high = 1
    });
}

void addContinuityCases(std::vector<FormulaRow>& rows) {
    rows.push_back({
        .id = "B-5", .name = "change of weights above 0.9 of the turn, across quadrants", .inputs = 7, .outputs = 1,
        .ours = BODY(LightWeights a = lightWeights(vec3(x[0], x[1], x[2]));
                     LightWeights b = lightWeights(vec3(x[3], x[4], x[5]));
                     real m = max(max(abs(a.xPos - b.xPos), abs(a.yPos - b.yPos)),
                                  max(abs(a.zPos - b.zPos), max(abs(a.xNeg - b.xNeg), abs(a.zNeg - b.zNeg))));
                     y[0] = max(m - real(0.9) * x[6], real(0.0));),
        .published =
            BODY(vec3 a = weightsPublished(vec3(x[0], x[1], x[2])); vec3 b = weightsPublished(vec3(x[3], x[4], x[5]));
                 vec3 d = vec3(a.x * sign(x[0]) - b.x * sign(x[3]), a.y - b.y, a.z * sign(x[2]) - b.z * sign(x[5]));
                 y[0] = max(maxAbs3(d) - real(0.9) * x[6], real(0.0));
                 if (!(maxAbs3(d) < 2.0f)) y[0] = maxAbs3(d) + d.x + d.y + d.z;),
        .samples =
            [](const ExpectedValues&) {
                FormulaSamples samples;
                Sweep s(5);
                for (int i = 0; i < 2000; ++i) {
                    const double turn = s.size(1e-4, 0.05), at = s.in(-3.1, 3.1), up = i % 3 == 0 ? 0 : s.in(0, 1.4);
                    const auto on = [&](double a) {
                        return std::vector<double>{std::cos(a) * std::cos(up), std::sin(up),
                                                   std::sin(a) * std::cos(up)};
                    };
                    const double centre = i % 2 == 0 ? std::round(at / 1.5707963) * 1.5707963 : at;
                    const auto a = on(centre - turn / 2), b = on(centre + turn / 2);
                    samples.add(
                        {float(a[0]), float(a[1]), float(a[2]), float(b[0]), float(b[1]), float(b[2]), float(turn)},
                        {0});
                }
                return samples;
            },
        .tolerance = 4e-7, .gpuTolerance = 1e-5, .methodTolerance = 2e-7, .low = 0, .high = 1
    });
    rows.push_back({
        .id = "B-6", .name = "sum of weights between a light from X+ and one from X-", .inputs = 6, .outputs = 1,
        .ours = BODY(LightWeights a = lightWeights(vec3(x[0], x[1], x[2]));
                     LightWeights b = lightWeights(vec3(x[3], x[4], x[5]));
                     y[0] = 0.5f * (a.xPos + b.xPos) + 0.5f * (a.yPos + b.yPos) + 0.5f * (a.zPos + b.zPos) +
                            0.5f * (a.xNeg + b.xNeg) + 0.5f * (a.zNeg + b.zNeg);),
        .published = BODY(
            vec3 a = weightsLinear(lightOctant(vec3(x[0], x[1], x[2])));
            vec3 b = weightsLinear(lightOctant(vec3(x[3], x[4], x[5])));
            vec3 m = (vec3(a.x * sign(x[0]), a.y, a.z * sign(x[2])) + vec3(b.x * sign(x[3]), b.y, b.z * sign(x[5]))) *
                     real(0.5);
            real sum = abs(m.x) + m.y + abs(m.z); y[0] = (abs(m.x) + m.y + abs(m.z)) / sum;),
        .samples = listed(
            {{1, 0, 0, -1, 0, 0}, {0.9, 0.05, 0, -0.9, 0.05, 0}, {0, 0, 1, 0, 0, -1}, {0.6, 0.1, 0.7, -0.6, 0.1, -0.7}},
            {{1}, {1}, {1}, {1}}),
        .tolerance = 4.8e-7, .gpuTolerance = 1e-5
    });
    rows.push_back({.id = "B-7",
                    .name = "light weights of vectors scaled by 1e18 and 1e-18",
                    .inputs = 3,
                    .outputs = 5,
                    .ours = kThreeAtan,
                    .published = kEq13,
                    .samples =
                        [](const ExpectedValues&) {
                            FormulaSamples samples;
                            Sweep s(7);
                            for (int i = 0; i < 600; ++i) {
                                const auto d = s.direction();
                                const float k = i % 2 ? 1e18f : 1e-18f;
                                samples.add({d[0] * double(k), d[1] * double(k), d[2] * double(k)}, {});
                            }
                            for (double& v : samples.x) v = double(float(v));
                            return samples;
                        },
                    .tolerance = 4e-7,
                    .gpuTolerance = 1e-5,
                    .low = 0,
                    .high = 1.0000002});
}

const FormulaBody kLod =
    BODY(LodWeights w = lodWeights(x[0], x[1], lodInverse(x[1], x[2]), x[3], lodInverse(x[3], x[4])); y[0] = w.geometry;
         y[1] = w.vertical; y[2] = w.horizontal;);
const FormulaBody kLodPublished = BODY(LodWeights w = lodWeightsPublished(x[0], x[1], x[2], x[3], x[4]);
                                       y[0] = w.geometry; y[1] = w.vertical; y[2] = w.horizontal;);

void addLodCases(std::vector<FormulaRow>& rows) {
    rows.push_back(
        {.id = "B-8",
         .name = "level-of-detail weights",
         .inputs = 5,
         .outputs = 3,
         .ours = kLod,
         .published = kLodPublished,
         .samples = fromGroup("lod_weights", {"d", "minGeom", "maxGeom", "minBTF", "maxBTF"}, {"wg", "wvs", "whs"}),
         .tolerance = 2e-7,
         .low = 0,
         .high = 1});
    rows.push_back({.id = "B-9",
                    .name = "level-of-detail weights that never fade",
                    .inputs = 5,
                    .outputs = 3,
                    .ours = kLod,
                    .published = kLodPublished,
                    .samples = listed({{0, 10, 20, 50, kInfinity},
                                       {15, 10, 20, 50, kInfinity},
                                       {1e6, 10, 20, 50, kInfinity},
                                       {1e6, 10, kInfinity, 50, kInfinity},
                                       {3e38, 10, 20, 50, 60}},
                                      {{1, 0, 0}, {0.5, 0.5, 0.5}, {0, 1, 1}, {1, 0, 0}, {0, 0, 1}}),
                    .tolerance = 2e-7,
                    .low = 0,
                    .high = 1});
}

void addOpacityCases(std::vector<FormulaRow>& rows) {
    rows.push_back({
        .id = "B-10", .name = "opacity, eq 5", .inputs = 3, .outputs = 1,
        .ours = BODY(y[0] = opacityEq5(x[0], x[1], x[2]);),
        .published = BODY(y[0] = opacityPublished(x[0], x[1], x[2]);),
        .samples = fromGroup("opacity_eq5", {"density", "dth", "omega"}, {"opacity"}), .tolerance = 2e-7, .low = 0,
        .high = 1
    });
    rows.push_back({
        .id = "B-11", .name = "opacity that conserves density", .inputs = 3, .outputs = 1,
        .ours = BODY(y[0] = opacityConserving(x[0], x[1], x[2]);),
        .published = BODY(y[0] = opacityEq5(x[0], x[1], x[2]);),
        .samples = fromGroup("opacity_eq5", {"density", "dth", "omega"}, {"conserving"}), .tolerance = 2e-7, .low = 0,
        .high = 1
    });
    rows.push_back({
        .id = "B-12", .name = "every blade once: who draws it, and how opaque", .inputs = 4, .outputs = 4,
        .ours = BODY(y[0] = sliceHolds(x[0], x[1], x[2]) ? real(1.0) : real(0.0);
                     y[1] = geometryHolds(x[0], x[1], x[2]) ? real(1.0) : real(0.0);
                     y[2] = sliceOpacity(x[0], x[1], x[2], x[3]); y[3] = geometryOpacity(x[0], x[1], x[2], x[3]);),
        .published = BODY(real wg = 1.0f - x[1]; y[0] = sliceHolds(x[0], x[1], x[2]) ? real(1.0) : real(0.0);
                          y[1] = geometryHoldsPublished(x[0], wg, x[2]) ? real(1.0) : real(0.0);
                          y[2] = opacityPublished(x[0] * x[1], x[2], x[3]);
                          y[3] = opacityPublished(x[0] * wg, 1.0f - x[2], x[3]);),
        .samples = fromGroup("partition", {"density", "ws", "dth", "omega"},
                             {"slice", "geometry", "slice_opacity", "geometry_opacity"}),
        .tolerance = 2e-7, .low = 0, .high = 1
    });
    rows.push_back({
        .id = "B-13", .name = "times a blade is drawn, thresholds of 8 bits in the slices", .inputs = 2, .outputs = 1,
        .ours = BODY(real t = thresholdOf(clamp(int(x[0] * 255.0f + 0.5f), 1, 255));
                     y[0] = (sliceHolds(real(1.0), x[1], t) ? real(1.0) : real(0.0)) +
                            (geometryHolds(real(1.0), x[1], t) ? real(1.0) : real(0.0));),
        .published = BODY(real t = thresholdOf(int(x[0] * 255.0f + 0.5f));
                          y[0] = (sliceHolds(real(1.0), x[1], t) ? real(1.0) : real(0.0)) +
                                 (geometryHolds(real(1.0), x[1], x[0]) ? real(1.0) : real(0.0));),
        .samples =
            [](const ExpectedValues&) {
                FormulaSamples samples;
                Sweep s(13);
                for (int i = 0; i < 20000; ++i) samples.add({s.unit(), s.unit()}, {1});
                return samples;
            },
        .low = 1, .high = 1
    });
}

}  // namespace

void addHybridRows(std::vector<FormulaRow>& rows) {
    addWeightForms(rows);
    addWeightCases(rows);
    addContinuityCases(rows);
    addLodCases(rows);
    addOpacityCases(rows);
}

}  // namespace sward
