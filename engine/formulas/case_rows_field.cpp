// Curves of B-10 to B-18: who draws a blade and how opaque it is, and where a patch repeats (Boulanger, Pattanaik,
// Bouatouch 2006).
#include "formulas/case_rows.h"

namespace sward {
namespace {

using Inputs = std::vector<double>;

void addOpacity(std::vector<CaseCurve>& curves) {
    curves.push_back({.id = "B-10",
                      .where = "fading of blades and slices",
                      .source = "opacity.h",
                      .function = "opacityEq5",
                      .picture =
                          "Without a width to fade in, a blade whose threshold is the density itself is 0 / 0: single "
                          "black blades in painted ground.",
                      .variable = "density, a blade of threshold 0.5",
                      .low = 0,
                      .high = 1,
                      .hard = {0.5},
                      .inputs =
                          [](double at) {
                              return Inputs{at, 0.5, 0};
                          },
                      .value = "opacity"});
    curves.push_back({.id = "B-11",
                      .where = "fading of blades and slices",
                      .source = "opacity.h",
                      .function = "opacityConserving",
                      .picture =
                          "On ground painted bare every blade of a low threshold stays half there, and full density "
                          "is never reached: the mean is 0.1 where 0 was painted.",
                      .variable = "density, a blade of threshold 0.2",
                      .low = 0,
                      .high = 1,
                      .hard = {0, 1},
                      .inputs =
                          [](double at) {
                              return Inputs{at, 0.2, 0.4};
                          },
                      .value = "opacity"});
    curves.push_back({.id = "B-12",
                      .where = "transition from blades to slices",
                      .source = "opacity.h",
                      .function = "geometryOpacity",
                      .picture =
                          "Where grass is thin, blades and slices show different blades: the whole field is exchanged "
                          "for another while one walks towards it.",
                      .variable = "weight of slices, density 0.5",
                      .low = 0,
                      .high = 1,
                      .hard = {0, 1},
                      .inputs =
                          [](double at) {
                              return Inputs{0.5, at, 0.3, 0.1};
                          },
                      .output = 3,
                      .value = "opacity of the blade drawn by itself"});
    curves.push_back({.id = "B-13",
                      .where = "transition from blades to slices",
                      .source = "opacity.h",
                      .function = "thresholdOf",
                      .picture =
                          "Slices hold thresholds of 8 bits and blades finer ones: some blades are drawn twice in the "
                          "transition, others not at all.",
                      .variable = "weight of slices, a blade of threshold 0.5",
                      .low = 0.49,
                      .high = 0.51,
                      .hard = {0.5},
                      .inputs =
                          [](double at) {
                              return Inputs{0.5, at};
                          },
                      .value = "times that the blade is drawn"});
}

void addTiling(std::vector<CaseCurve>& curves) {
    curves.push_back({.id = "B-15",
                      .where = "no shader; held for repeats to come",
                      .source = "wrap.h",
                      .function = "wrapUnit",
                      .picture =
                          "The remainder of a negative number is negative in C and HLSL: west of the origin every "
                          "tile is one smeared column.",
                      .variable = "coordinate",
                      .low = -2,
                      .high = 2,
                      .hard = {-1, 0, 1},
                      .inputs = [](double at) { return Inputs{at}; },
                      .value = "place in the tile"});
    curves.push_back({.id = "B-17",
                      .where = "no shader; held for repeats to come",
                      .source = "wrap.h",
                      .function = "patchCoordinate",
                      .picture =
                          "One coordinate over the whole terrain loses the place within a cell: far out images of "
                          "grass stand whole texels off, and swim.",
                      .variable = "cells from the origin",
                      .low = 1,
                      .high = 179999,
                      .scale = CaseScale::Log,
                      .whole = true,
                      .inputs =
                          [](double at) {
                              return Inputs{at, 0.37, 180000};
                          },
                      .value = "texel, of 512"});
    curves.push_back({.id = "B-18",
                      .where = "how patches are mirrored",
                      .source = "hash.h",
                      .function = "cellMirror",
                      .picture =
                          "A filtered map of signs is neither 1 nor -1 at a cell's border: a stretched column of "
                          "grass along each.",
                      .variable = "place between two cells' middles",
                      .low = 0,
                      .high = 1,
                      .hard = {0.5},
                      .inputs =
                          [](double at) {
                              return Inputs{12, -5, at};
                          },
                      .value = "magnitude of the sign"});
}

}  // namespace

void addFieldCurves(std::vector<CaseCurve>& curves) {
    addOpacity(curves);
    addTiling(curves);
}

}  // namespace sward
