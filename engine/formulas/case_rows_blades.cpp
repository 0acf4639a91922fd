// Curves of J-1 to J-9: wind, levels, spline frames, counts (Jahrmann, Wimmer 2013).
#include <algorithm>

#include "formulas/case_rows.h"
#include "formulas/formula_table.h"

namespace sward {
namespace {

using Inputs = std::vector<double>;

constexpr double kWaves[3] = {1, 0.5, 0.7};  // the wind's c1 to c3
constexpr double kAcross = 3.3, kSmooth = 0.3, kPair = 0.01;

// An hour after its beginning, at a distance east of the origin.
constexpr double kHour = 3600;
Inputs windFar(double east) { return windInputs(east, kAcross, kHour, kWaves, kSmooth); }
Inputs windNear(double north) {
    Inputs in = windInputs(40, 1 / (2 * kWaves[1]) + north - kPair / 2, 60, kWaves, kSmooth);
    in.push_back(kPair);
    return in;
}

void addWind(std::vector<CaseCurve>& curves) {
    curves.push_back({.id = "J-1",
                      .where = "wind",
                      .source = "wind.h",
                      .function = "windAt",
                      .picture =
                          "Far from the origin, or after hours, the wind's phase has no digits left for the next "
                          "frame: grass jerks, then stands still.",
                      .variable = "distance from the origin, after an hour",
                      .unit = "m",
                      .low = 1,
                      .high = 1e6,
                      .scale = CaseScale::Log,
                      .inputs = windFar,
                      .value = "wind",
                      .truth = [](double at) {
                          return Inputs{f64::windPublished(at, kAcross, kHour, kWaves[0], kWaves[1], kWaves[2],
                                                           double(float(kSmooth)))};
                      }});
    curves.push_back({.id = "J-2",
                      .where = "wind",
                      .source = "wind.h",
                      .function = "windAt",
                      .picture = "With the paper's small epsilon the phase has a pole: lines in the field along which "
                                 "neighbouring blades move without regard to each other.",
                      .variable = "distance of two blades, 1 cm apart, from such a line",
                      .unit = "m",
                      .low = -0.2,
                      .high = 0.2,
                      .hard = {0},
                      .inputs = windNear,
                      .value = "how much their wind differs",
                      .truth = [](double) {
                          const double bound =
                              (kWaves[0] + kWaves[2]) * 0.785398 * kWaves[1] * 3.14159265 * kPair / (kSmooth * kSmooth);
                          return Inputs{std::min(bound, 2.0)};
                      }});
    curves.push_back(
        {.id = "J-3",
         .where = "where blades stand",
         .source = "hash.h",
         .function = "hashUnit",
         .picture = "The printed random numbers are 0 along the axes and equal along rays from the origin: rows "
                    "of equal blades that the eye finds at once.",
         .whyNot = "A random number has no value that it should have at a place: the row counts how evenly "
                   "thousands of them lie instead."});
}

// Level of a blade whose root is 2 m away and whose tip leans round the screen.
Inputs leaning(double angle) { return {0, 0, 2, 0.25 * sinDeg(angle), 0.25 * cosDeg(angle), 2, 8, 16}; }

void addLevels(std::vector<CaseCurve>& curves) {
    curves.push_back({.id = "J-5",
                      .where = "tessellated blades",
                      .source = "tess.h",
                      .function = "tessLevel",
                      .picture =
                          "Beyond the last distance the level is negative, which hardware takes for none or for the "
                          "most: blades vanish, or cost everything.",
                      .variable = "distance, levels up to 100 m",
                      .unit = "m",
                      .low = 0,
                      .high = 150,
                      .hard = {100},
                      .inputs =
                          [](double at) {
                              return Inputs{8, at, 100};
                          },
                      .value = "level"});
    curves.push_back({.id = "J-5",
                      .name = "tessellation level beyond every limit",
                      .where = "tessellated blades",
                      .source = "tess.h",
                      .function = "tessLevel",
                      .picture = "A reach of 0 divides by 0, and one shorter than the distance is negative.",
                      .variable = "reach of the levels, a blade at 5 m",
                      .unit = "m",
                      .low = 0,
                      .high = 20,
                      .hard = {0, 5},
                      .inputs =
                          [](double at) {
                              return Inputs{8, 5, at};
                          },
                      .value = "level"});
    curves.push_back({.id = "J-6",
                      .where = "tessellated blades",
                      .source = "tess.h",
                      .function = "tessLevelOnScreen",
                      .picture =
                          "The printed level is the difference of heights on the screen: a blade that leans sideways "
                          "is a straight line, one that leans to the viewer is culled.",
                      .variable = "lean of the blade on the screen",
                      .unit = "degrees",
                      .low = -180,
                      .high = 180,
                      .hard = {-90, 0, 90},
                      .inputs = leaning,
                      .value = "level"});
}

// The left edge's control point `gap` short of its tip; what is seen is the frame at its tip.
Inputs gapBelowTip(double gap) {
    const double x = 0.02, y = 0.3;
    return {0,        0,       0, x - 0.6 * gap, y - 0.8 * gap, 0, x, y, 0, 0.01, 0, 0,
            x + 0.01, 0.5 * y, 0, x + 0.01,      0.99 * y,      0, 1, 0, 0, 0,    1};
}

void addShapes(std::vector<CaseCurve>& curves) {
    curves.push_back({.id = "J-7",
                      .where = "tessellated blades",
                      .source = "spline.h",
                      .function = "splineFrame",
                      .picture =
                          "The paper's own straight blade has its control point in the tip: the normal there is 0 / 0 "
                          "and every tip is black.",
                      .variable = "distance of the control point from the tip",
                      .unit = "m",
                      .low = 1e-9,
                      .high = 0.2,
                      .scale = CaseScale::Log,
                      .zero = true,
                      .inputs = gapBelowTip,
                      .output = 3,
                      .value = "x of the blade's direction at the tip"});
    curves.push_back({.id = "J-9",
                      .where = "how many blades there are",
                      .source = "sowing.h",
                      .function = "sownOf",
                      .picture =
                          "Rounding down leaves nothing where less than one blade a cell is asked for: thin grass "
                          "does not exist, and densities come in steps.",
                      .variable = "blades asked for in a cell",
                      .low = 0,
                      .high = 4,
                      .inputs =
                          [](double at) {
                              return Inputs{at, 1};
                          },
                      .value = "blades that a cell has in the mean",
                      .truth = [](double at) { return Inputs{at}; }});
}

}  // namespace

void addBladeCurves(std::vector<CaseCurve>& curves) {
    addWind(curves);
    addLevels(curves);
    addShapes(curves);
}

}  // namespace sward
