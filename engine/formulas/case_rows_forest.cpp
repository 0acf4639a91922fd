// Curves of D-1 to D-8: opacity correction, tilted slices, pyramids (Decaudin, Neyret 2004).
#include "formulas/case_rows.h"

namespace sward {
namespace {

using Inputs = std::vector<double>;

constexpr double kWay = 8;  // lengths of the layer's own thickness that light goes through it
Inputs corrected(double opacity) {
    const double a = double(float(opacity));
    return {a >= 1 ? 1.0 : -std::expm1(kWay * std::log1p(-a))};
}

void addCorrection(std::vector<CaseCurve>& curves, const char* name, const char* function, bool relative, bool thin) {
    curves.push_back(
        {.id = "D-1",
         .name = name,
         .where = function == std::string("correctionPow") ? "slices seen at a slant" : "no shader; compared",
         .source = "correction.h",
         .function = function,
         .picture = "Seen along the ground each layer is crossed on a longer way. The printed first term of the "
                    "series is too opaque by up to a third: grass at grazing angles is a wall.",
         .variable = "opacity of a layer, crossed on 8 times its thickness",
         .low = thin       ? 1e-7
                : relative ? 1e-4
                           : 0,
         .high = thin ? 1e-2 : 1,
         .scale = relative ? CaseScale::Log : CaseScale::Even,
         .inputs =
             [](double at) {
                 return Inputs{at, kWay};
             },
         .value = "opacity on that way",
         .relative = relative,
         .truth = corrected});
}

void addLayers(std::vector<CaseCurve>& curves) {
    addCorrection(curves, "opacity correction, series, relative", "opacityCorrected", true, false);
    addCorrection(curves, "opacity correction, pow", "correctionPow", false, false);
    addCorrection(curves, "opacity correction, hyperbola", "correctionHyperbola", false, false);
    addCorrection(curves, "opacity correction of thin layers, relative", "opacityCorrected", true, true);
    curves.push_back({.id = "D-2",
                      .where = "no shader; held for forests to come",
                      .source = "correction.h",
                      .function = "colorCorrected",
                      .picture =
                          "Channels that are cut one by one change the hue: the far edge of a dark green crown turns "
                          "yellow.",
                      .variable = "way through the layer, in its thickness",
                      .low = 1,
                      .high = 16,
                      .inputs =
                          [](double at) {
                              return Inputs{0.2, 0.4, 0.1, 0.5, at};
                          },
                      .value = "red, premultiplied"});
    curves.push_back({.id = "D-3",
                      .where = "no shader; held for forests to come",
                      .source = "correction.h",
                      .function = "slantFactor",
                      .picture =
                          "A vertex seen edge-on has the factor 1 / 0, and interpolation floods the whole triangle "
                          "with it: opaque slivers along silhouettes.",
                      .variable = "cosine between view and the first vertex's normal",
                      .low = 1e-6,
                      .high = 1,
                      .scale = CaseScale::Log,
                      .zero = true,
                      .inputs =
                          [](double at) {
                              return Inputs{std::sqrt(1 - at * at), at, 0, 1, 0.5};
                          },
                      .value = "slant half-way to a vertex seen flat"});
}

Inputs tilted(double fromVertical) {
    const double s = sinDeg(fromVertical);
    return {0, 0, 0, 1, 0, 0, 0, 1, 0, s * std::cos(0.3), s * std::sin(0.3), -cosDeg(fromVertical), 2, 1, 64, 0};
}

void addTilts(std::vector<CaseCurve>& curves) {
    curves.push_back({.id = "D-4",
                      .where = "no shader; held for forests to come",
                      .source = "tilt.h",
                      .function = "tiltOf",
                      .picture =
                          "Straight from above, the view of every map, all slants are 0 / 0 and the forest is gone; on "
                          "the horizon they are infinite.",
                      .variable = "view's angle from straight down",
                      .unit = "degrees",
                      .low = 1e-6,
                      .high = 90,
                      .scale = CaseScale::Log,
                      .zero = true,
                      .inputs = tilted,
                      .output = 0,
                      .value = "offset of the first corner",
                      .measured = 2});
    curves.push_back({.id = "D-5",
                      .where = "no shader; held for forests to come",
                      .source = "tilt.h",
                      .function = "tiltCount",
                      .picture =
                          "The printed count is negative when one looks down, and near the horizon, where slices are "
                          "made for silhouettes, it falls to one.",
                      .variable = "view's elevation above the ground",
                      .unit = "degrees",
                      .low = 0,
                      .high = 90,
                      .inputs = [](double at) { return tilted(90 - at); },
                      .value = "slices",
                      .relative = true});
    curves.push_back({.id = "D-5",
                      .name = "number of slices",
                      .where = "no shader; held for forests to come",
                      .source = "tilt.h",
                      .function = "sliceCount",
                      .picture = "The printed count is negative when one looks down: nothing is drawn.",
                      .variable = "view's elevation above the ground",
                      .unit = "degrees",
                      .low = 0,
                      .high = 90,
                      .inputs = [](double at) { return tilted(90 - at); },
                      .value = "slices"});
}

void addPyramids(std::vector<CaseCurve>& curves) {
    curves.push_back({.id = "D-6",
                      .where = "no shader; held for forests to come",
                      .source = "tilt.h",
                      .function = "groundUsable",
                      .picture = "An upright or empty triangle divides by 0: trees across a cliff that are no number.",
                      .variable = "slope of the ground",
                      .unit = "degrees",
                      .low = 60,
                      .high = 90,
                      .hard = {90},
                      .inputs = [](double at) { return Inputs{0, 0, 0, 1, 0, 0, 0, cosDeg(at), sinDeg(at)}; },
                      .value = "whether forest grows"});
    curves.push_back({.id = "D-7",
                      .where = "no shader; held for forests to come",
                      .source = "correction.h",
                      .function = "layersUnder",
                      .picture =
                          "A pyramid that rounds to 8 bits at each level ends too opaque: crowns of thin leaves are "
                          "solid from afar.",
                      .variable = "opacity of each of 128 slices",
                      .low = 0.001,
                      .high = 0.05,
                      .inputs = [](double at) { return Inputs{at}; },
                      .value = "opacity of all",
                      .truth = [](double at) { return Inputs{1 - std::pow(1 - double(float(at)), 128)}; }});
    curves.push_back({.id = "D-8",
                      .where = "no shader; held for forests to come",
                      .source = "correction.h",
                      .function = "pyramidLevel",
                      .picture =
                          "The level of what is nearer than a texel is negative, of nothing at all minus infinity, and "
                          "far away past the last: the wrong picture or none.",
                      .variable = "texels a pixel",
                      .low = 1e-3,
                      .high = 1e9,
                      .scale = CaseScale::Log,
                      .zero = true,
                      .inputs =
                          [](double at) {
                              return Inputs{at, 6};
                          },
                      .value = "level of the pyramid"});
}

}  // namespace

void addForestCurves(std::vector<CaseCurve>& curves) {
    addLayers(curves);
    addTilts(curves);
    addPyramids(curves);
}

}  // namespace sward
