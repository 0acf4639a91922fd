// Curves of T-3, T-7 and T-8: long running times, strokes without length, lights without limit.
#include <cfloat>

#include "formulas/case_rows.h"
#include "formulas/formula_table.h"

namespace sward {
namespace {

using Inputs = std::vector<double>;

constexpr double kTicksAnHour = 216000, kPeriod = 600;
double ticksAt(double hours) { return std::round(hours * kTicksAnHour); }

// Beyond the largest float a light is infinite.
Inputs lightOf(double red) { return {red > FLT_MAX ? kInfinity : red, 1, 1, 0}; }

}  // namespace

void addSceneCurves(std::vector<CaseCurve>& curves) {
    curves.push_back({.id = "T-3",
                      .where = "no shader; held for what repeats",
                      .source = "wind.h",
                      .function = "tickPhase",
                      .picture =
                          "Time that is added up frame by frame loses seconds in the first hour and stands still "
                          "after days: what repeats drifts, jerks and stops.",
                      .variable = "uptime at 60 frames a second",
                      .unit = "hours",
                      .low = 1e-3,
                      .high = 10,
                      .scale = CaseScale::Log,
                      .inputs =
                          [](double at) {
                              return Inputs{ticksAt(at), kPeriod};
                          },
                      .value = "phase of what repeats every 10 s"});
    curves.push_back({.id = "T-7",
                      .name = "distance from a stroke, of no length too",
                      .where = "paths drawn into maps",
                      .source = "wrap.h",
                      .function = "segmentDistance",
                      .picture =
                          "A click without a motion is a stroke of no length: 0 / 0, and the map has a hole that no "
                          "brush fills.",
                      .variable = "length of the stroke",
                      .unit = "m",
                      .low = 1e-25,
                      .high = 10,
                      .scale = CaseScale::Log,
                      .zero = true,
                      .inputs = [](double at) { return Inputs{3, 4, 0, 0, at, 0}; },
                      .value = "distance from it, m"});
    curves.push_back({.id = "T-7",
                      .name = "weight of a brush, of no radius too",
                      .where = "no brush; held for shaders to come",
                      .source = "wrap.h",
                      .function = "brushWeight",
                      .picture = "A brush of no radius divides by 0 in its middle and paints what is no number.",
                      .variable = "radius of the brush",
                      .unit = "m",
                      .low = 1e-6,
                      .high = 10,
                      .scale = CaseScale::Log,
                      .zero = true,
                      .inputs =
                          [](double at) {
                              return Inputs{0, at, 0.5};
                          },
                      .value = "weight in its middle"});
    curves.push_back({.id = "T-8",
                      .where = "sun and sky",
                      .source = "weights.h",
                      .function = "soundLight",
                      .picture =
                          "An infinite light times the 0 of a face turned away is no number, and it survives every "
                          "filter after it.",
                      .variable = "light's strength",
                      .low = 1e30,
                      .high = 1e40,
                      .scale = CaseScale::Log,
                      .inputs = lightOf,
                      .value = "light on a face turned away"});
}

}  // namespace sward
