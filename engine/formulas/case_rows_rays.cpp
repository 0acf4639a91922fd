// Curves of H-1 to H-8: rays through slices, frames, layers, depth (Habel, Wimmer, Jeschke 2007).
#include "formulas/case_rows.h"

namespace sward {
namespace {

using Inputs = std::vector<double>;

Inputs alongSlices(double angle) { return {0.3, 0.13, 0, sinDeg(angle), 0.8 * cosDeg(angle), -0.3, 16, 16, 0.25}; }

void addHits(std::vector<CaseCurve>& curves) {
    curves.push_back({.id = "H-1",
                      .where = "rays through slices",
                      .source = "rays.h",
                      .function = "sliceHit",
                      .picture =
                          "Rays along the slices, and the view straight down, divide by 0: a column of pixels without "
                          "grass in the middle of the picture.",
                      .variable = "ray's angle to the slices",
                      .unit = "degrees",
                      .low = 1e-6,
                      .high = 60,
                      .scale = CaseScale::Log,
                      .zero = true,
                      .inputs = alongSlices,
                      .value = "way to the first slice",
                      .relative = true});
    curves.push_back({.id = "H-1",
                      .name = "all hits of a ray",
                      .where = "rays through slices",
                      .source = "rays.h",
                      .function = "sliceAfter",
                      .picture =
                          "The paper steps from slice to slice by adding; ours counts, so that each is met once, in "
                          "order.",
                      .variable = "ray's angle to the slices",
                      .unit = "degrees",
                      .low = 1e-6,
                      .high = 60,
                      .scale = CaseScale::Log,
                      .zero = true,
                      .inputs = alongSlices,
                      .output = 2,
                      .value = "way to the first slice"});
    curves.push_back({.id = "H-2",
                      .where = "rays through slices",
                      .source = "rays.h",
                      .function = "firstSlice",
                      .picture =
                          "A ray that begins on a slice misses it when it goes one way: gaps at the borders of tiles, "
                          "seen from one side alone.",
                      .variable = "slice on which the ray begins",
                      .low = -16,
                      .high = 16,
                      .whole = true,
                      .inputs = [](double at) { return Inputs{at / 16, 0.3, 0, 0.5, 0.2, -0.5, 16, 16, 0.25}; },
                      .value = "way to the first slice"});
    curves.push_back(
        {.id = "H-3",
         .where = "rays through slices",
         .source = "rays.h",
         .function = "sliceHit",
         .picture = "Where slices cross, two lie equally far along the ray: their order must be the same in "
                    "every pixel, else the crossing flickers.",
         .whyNot = "No printed form: the paper leaves open which of two slices at one distance comes first, so "
                   "that there is nothing to be off along a variable."});
}

void addEnds(std::vector<CaseCurve>& curves) {
    curves.push_back({.id = "H-4",
                      .where = "rays through slices",
                      .source = "rays.h",
                      .function = "sliceHit",
                      .picture =
                          "A place that is added up drifts: far along a ray the slices stand where no image of them "
                          "is.",
                      .variable = "steps of 0.1 along the ray",
                      .low = 1,
                      .high = 4000,
                      .scale = CaseScale::Log,
                      .whole = true,
                      .inputs =
                          [](double at) {
                              return Inputs{at, 10};
                          },
                      .value = "plane that is reached"});
    curves.push_back(
        {.id = "H-5",
         .where = "rays through slices",
         .source = "rays.h",
         .function = "sliceRay",
         .picture = "A ray that rises meets the ground behind the eye, a level one at infinity: the grass of "
                    "the horizon is drawn over the sky.",
         .variable = "angle at which the ray rises",
         .unit = "degrees",
         .low = -20,
         .high = 20,
         .hard = {0},
         .inputs =
             [](double at) { return Inputs{0.3, 0.1, -0.125, cosDeg(at), 0.5 * cosDeg(at), sinDeg(at), 16, 16, 0.25}; },
         .value = "way to the end of the grass"});
}

void addFrames(std::vector<CaseCurve>& curves) {
    curves.push_back({.id = "H-6",
                      .where = "grass on meshes",
                      .source = "rays.h",
                      .function = "tangentFrame",
                      .picture =
                          "On an underside that faces straight down the frame is infinite, and beside it skewed: a "
                          "star of torn grass at one point of a sphere.",
                      .variable = "normal's angle to straight down",
                      .unit = "degrees",
                      .low = 1e-4,
                      .high = 90,
                      .scale = CaseScale::Log,
                      .zero = true,
                      .inputs =
                          [](double at) {
                              return Inputs{sinDeg(at) * std::cos(1.0), sinDeg(at) * std::sin(1.0), -cosDeg(at)};
                          },
                      .value = "tangents' lengths off 1",
                      .truth =
                          [](double) {
                              return Inputs{0, 0, 0};
                          }});
    curves.push_back({.id = "H-7",
                      .where = "no shader; held for layers to come",
                      .source = "correction.h",
                      .function = "layersUnder",
                      .picture =
                          "Opacity that is added up has no digits left for what still shines through: light behind "
                          "many thin layers is wrong or negative.",
                      .variable = "layers of opacity 0.1",
                      .low = 1,
                      .high = 200,
                      .whole = true,
                      .inputs =
                          [](double at) {
                              return Inputs{0.1, at};
                          },
                      .value = "share of light that is let through"});
    curves.push_back({.id = "H-8",
                      .where = "rays through slices",
                      .source = "rays.h",
                      .function = "hitDepth",
                      .picture =
                          "A hit behind the near plane has an infinite or negative depth: grass about the camera "
                          "disappears, or covers everything.",
                      .variable = "distance of the hit before the eye",
                      .unit = "m",
                      .low = -1,
                      .high = 3,
                      .hard = {0},
                      .inputs = [](double at) { return Inputs{0, 0, 0.1, at, 0.9, 0.1}; },
                      .value = "depth"});
}

}  // namespace

void addRayCurves(std::vector<CaseCurve>& curves) {
    addHits(curves);
    addEnds(curves);
    addFrames(curves);
}

}  // namespace sward
