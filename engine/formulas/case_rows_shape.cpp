// Curves of B-19 to B-25: blades, shadows, grids (Boulanger, Pattanaik, Bouatouch 2006).
#include "formulas/case_rows.h"

namespace sward {
namespace {

using Inputs = std::vector<double>;

void addBlades(std::vector<CaseCurve>& curves) {
    curves.push_back({.id = "B-19",
                      .name = "tip of a blade, metres, whatever its segments",
                      .where = "blades drawn one by one",
                      .source = "blade.h",
                      .function = "bladePosition",
                      .picture =
                          "A path made step by step ends elsewhere with other steps: grass grows and shrinks where "
                          "the number of segments changes with distance.",
                      .variable = "segments of the blade",
                      .low = 1,
                      .high = 64,
                      .scale = CaseScale::Log,
                      .whole = true,
                      .inputs =
                          [](double at) {
                              return Inputs{0.3, 0.5, 0.6, 1, at};
                          },
                      .output = 1,
                      .value = "height of the tip, m"});
    curves.push_back({.id = "B-19",
                      .name = "frame of a blade, upright and at its apex too",
                      .where = "blades drawn one by one",
                      .source = "blade.h",
                      .function = "bladeFrame",
                      .picture =
                          "A blade that stands upright has no side by the cross product with up: it is not drawn, or "
                          "drawn black.",
                      .variable = "lean at the root",
                      .unit = "degrees",
                      .low = 1e-6,
                      .high = 60,
                      .scale = CaseScale::Log,
                      .zero = true,
                      .inputs =
                          [](double at) {
                              return Inputs{0.3, at * 0.017453292519943295, 0.2, 0.7, 0.25};
                          },
                      .output = 3,
                      .value = "x of the normal"});
}

void addGroundShadows(std::vector<CaseCurve>& curves) {
    curves.push_back({.id = "B-20",
                      .name = "ground shadow of a blade, sun at and below the horizon",
                      .where = "shadows of blades on the ground",
                      .source = "shadow.h",
                      .function = "shadowOfSun",
                      .picture =
                          "As the sun sets shadows grow without end; below the horizon they come back from the wrong "
                          "side and cover the scene.",
                      .variable = "sun's elevation, a blade of 0.3 m",
                      .unit = "degrees",
                      .low = -15,
                      .high = 45,
                      .hard = {0},
                      .inputs =
                          [](double at) {
                              return Inputs{0.3, cosDeg(at), sinDeg(at), 0};
                          },
                      .value = "where the tip's shadow falls, m"});
    curves.push_back({.id = "B-20",
                      .name = "ground shadow of a blade by a lantern",
                      .where = "shadows of blades on the ground",
                      .source = "shadow.h",
                      .function = "shadowOfLamp",
                      .picture = "A tip as high as the lantern throws its shadow to infinity, a higher one towards the "
                                 "light: dark bars across the grass.",
                      .variable = "lantern's height above the blade's tip",
                      .unit = "m",
                      .low = -0.2,
                      .high = 1,
                      .hard = {0},
                      .inputs = [](double at) { return Inputs{0, 0.25, 0, 0.5, 0.25 + at, 0.2}; },
                      .value = "where the tip's shadow falls, m"});
}

Inputs alongAxis(double angle) {
    return {0.01, 0, 0.005, sinDeg(angle) * std::cos(1.0), cosDeg(angle), sinDeg(angle) * std::sin(1.0), 0.03};
}

void addMasks(std::vector<CaseCurve>& curves) {
    curves.push_back({.id = "B-21",
                      .name = "way out of the shadow mask's cylinder, relative",
                      .where = "shadows of blades on one another",
                      .source = "shadow.h",
                      .function = "cylinderExit",
                      .picture =
                          "Light along a blade's axis never leaves its cylinder: 0 / 0, and at noon the shadow masks "
                          "of all blades go black.",
                      .variable = "light's angle to the blade's axis",
                      .unit = "degrees",
                      .low = 1e-6,
                      .high = 90,
                      .scale = CaseScale::Log,
                      .zero = true,
                      .inputs = alongAxis,
                      .value = "way to the cylinder, m",
                      .relative = true});
    curves.push_back(
        {.id = "B-21",
         .name = "mask coordinates of points in and out of the cylinder, light along its axis too",
         .where = "shadows of blades on one another",
         .source = "shadow.h",
         .function = "maskPointOf",
         .picture = "The paper gives no coordinate for light along the axis or points outside; ours asks for no way "
                    "out of the cylinder: its mask has a layer for each rise of the light.",
         .variable = "light's angle to the blade's axis",
         .unit = "degrees",
         .low = 1e-6,
         .high = 90,
         .scale = CaseScale::Log,
         .zero = true,
         .inputs = [](double at) { return Inputs{0.01, 0.02, 0.005, 1, 0, sinDeg(at), cosDeg(at), 0}; },
         .output = 2,
         .value = "layer of the mask, as a share"});
    curves.push_back({.id = "B-22",
                      .where = "lamps",
                      .source = "weights.h",
                      .function = "pointLight",
                      .picture =
                          "At the lamp itself the direction to it is 0 / 0: one pixel that is no number, and bloom or "
                          "blur makes a black square of it.",
                      .variable = "distance from the lamp",
                      .unit = "m",
                      .low = 1e-28,
                      .high = 10,
                      .scale = CaseScale::Log,
                      .zero = true,
                      .inputs =
                          [](double at) {
                              return Inputs{0.6 * at, 0.8 * at, 0, 1};
                          },
                      .output = 1,
                      .value = "y of the direction to the lamp"});
}

void addGrids(std::vector<CaseCurve>& curves) {
    curves.push_back({.id = "B-23",
                      .where = "no shader; held for macro-cells to come",
                      .source = "tess.h",
                      .function = "macroLevel",
                      .picture =
                          "With the eye inside a cell's sphere the logarithm is of a negative number: the coarsest "
                          "cell, or none, around the viewer.",
                      .variable = "distance from the middle of a cell of 5 m",
                      .unit = "m",
                      .low = 0,
                      .high = 100,
                      .hard = {5},
                      .inputs =
                          [](double at) {
                              return Inputs{at, 5, 10};
                          },
                      .value = "level of the cell"});
    curves.push_back({.id = "B-24",
                      .where = "where blades stand",
                      .source = "hash.h",
                      .function = "hashUnit",
                      .picture =
                          "The highest random numbers round to 1: their blades stand in the neighbouring cell, 19 of "
                          "the 627 million of a pitch.",
                      .variable = "random number, below the highest of 32 bits",
                      .low = 1,
                      .high = 1e6,
                      .scale = CaseScale::Log,
                      .zero = true,
                      .whole = true,
                      .inputs =
                          [](double at) {
                              const double h = 4294967295.0 - at;
                              return Inputs{std::floor(h / 65536), std::fmod(h, 65536)};
                          },
                      .value = "cells off"});
    curves.push_back({.id = "B-25",
                      .where = "baking of slices",
                      .source = "wrap.h",
                      .function = "captureSlice",
                      .picture =
                          "A blade on the boundary of two slices is captured by both or by none, so that rows of "
                          "double or missing blades repeat over the field.",
                      .variable = "boundary on which the blade stands, of 49 slices",
                      .low = 0,
                      .high = 48,
                      .whole = true,
                      .inputs =
                          [](double at) {
                              return Inputs{at, 49};
                          },
                      .value = "slices that capture it"});
}

}  // namespace

void addShapeCurves(std::vector<CaseCurve>& curves) {
    addBlades(curves);
    addGroundShadows(curves);
    addMasks(curves);
    addGrids(curves);
}

}  // namespace sward
