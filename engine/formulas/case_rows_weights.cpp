// Curves of B-1 to B-9: light weights and the weights of distance (Boulanger, Pattanaik, Bouatouch 2006).
#include "formulas/case_rows.h"
#include "formulas/formula_table.h"

namespace sward {
namespace {

using Inputs = std::vector<double>;

// The weights of all five images in double: what every form of them is held against.
Inputs exactWeights(const Inputs& l) {
    const f64::LightWeights w =
        f64::lightWeights(f64::vec3(double(float(l[0])), double(float(l[1])), double(float(l[2]))));
    return {w.xPos, w.yPos, w.zPos, w.xNeg, w.zNeg};
}

Inputs fromZenith(double angle) {
    return {sinDeg(angle) * std::cos(0.5), cosDeg(angle), sinDeg(angle) * std::sin(0.5)};
}
Inputs offPlane(double angle) { return {sinDeg(angle), cosDeg(angle) * std::cos(0.3), cosDeg(angle) * std::sin(0.3)}; }
Inputs atElevation(double angle) { return {0.6 * cosDeg(angle), sinDeg(angle), 0.8 * cosDeg(angle)}; }
constexpr double kTurn = 1e-4;  // radians between two lights
Inputs turned(double azimuth) {
    const double next = azimuth + kTurn / 0.017453292519943295;
    return {cosDeg(azimuth), 0, sinDeg(azimuth), cosDeg(next), 0, sinDeg(next), kTurn};
}

void addForms(std::vector<CaseCurve>& curves) {
    curves.push_back({.id = "B-1",
                      .where = "light of slices",
                      .source = "weights.h",
                      .function = "lightWeights",
                      .picture =
                          "With the sun exactly at noon the weights are no numbers: every slice that it lights is "
                          "black or white, and the fault spreads with each filter.",
                      .variable = "sun's angle from the zenith",
                      .unit = "degrees",
                      .low = 1e-6,
                      .high = 90,
                      .scale = CaseScale::Log,
                      .zero = true,
                      .inputs = fromZenith,
                      .value = "weight of the image lit from +x",
                      .truth = [](double at) { return exactWeights(fromZenith(at)); }});
    curves.push_back({.id = "B-2",
                      .where = "light of slices",
                      .source = "weights.h",
                      .function = "lightWeights",
                      .picture =
                          "Sines made of cosines lift others above 1, and their inverse is no number: slices flicker "
                          "while the light passes north, south, east or west.",
                      .variable = "light's angle off the plane x = 0",
                      .unit = "degrees",
                      .low = 1e-4,
                      .high = 30,
                      .scale = CaseScale::Log,
                      .zero = true,
                      .inputs = offPlane,
                      .value = "weight of the image lit from +x"});
    curves.push_back({.id = "B-3",
                      .where = "light of slices",
                      .source = "weights.h",
                      .function = "lightWeights",
                      .picture =
                          "Angles whose sum is pi but for almost nothing: what is left is noise, and below 1e-4 even "
                          "its sign. Strong light through a small weight shows as speckles.",
                      .variable = "x of the light's direction",
                      .low = 1e-13,
                      .high = 1e-3,
                      .scale = CaseScale::Log,
                      .inputs =
                          [](double at) {
                              return Inputs{at, 1, 0.7 * at};
                          },
                      .value = "weight of the image lit from +x"});
}

void addHorizon(std::vector<CaseCurve>& curves) {
    curves.push_back({.id = "B-4",
                      .name = "light weights below the horizon",
                      .where = "light of slices",
                      .source = "weights.h",
                      .function = "lightOctant",
                      .picture =
                          "A lantern lower than a blade's tip lights it as if it hung mirrored above: grass about it "
                          "is too bright.",
                      .variable = "light's elevation",
                      .unit = "degrees",
                      .low = -30,
                      .high = 30,
                      .hard = {0},
                      .inputs = atElevation,
                      .output = 1,
                      .value = "weight of the image lit from above"});
    curves.push_back({.id = "B-4",
                      .name = "diffuse light over the horizon",
                      .where = "daylight, lamps on slices",
                      .source = "weights.h",
                      .function = "horizonFade",
                      .picture =
                          "Below the horizon the share of light is negative and takes light away; high above it is "
                          "more than all.",
                      .variable = "light's elevation",
                      .unit = "degrees",
                      .low = -10,
                      .high = 10,
                      .hard = {0},
                      .inputs =
                          [](double at) {
                              return Inputs{sinDeg(at), 0.05};
                          },
                      .value = "share of the light that counts"});
}

void addVectors(std::vector<CaseCurve>& curves) {
    curves.push_back({.id = "B-5",
                      .where = "light of slices",
                      .source = "weights.h",
                      .function = "spreadWeights",
                      .picture =
                          "At a quadrant's boundary sign(0) chooses no image: a whole field jumps in brightness for "
                          "one frame as the sun passes.",
                      .variable = "light's azimuth, before a turn of 1e-4",
                      .unit = "degrees",
                      .low = -2,
                      .high = 2,
                      .hard = {0},
                      .inputs = turned,
                      .value = "change of the weights above its bound"});
    curves.push_back({.id = "B-6",
                      .where = "light of slices",
                      .source = "weights.h",
                      .function = "spreadWeights",
                      .picture =
                          "Between a vertex lit from the left and one lit from the right signed weights meet at 0, "
                          "and 0 / 0 is a hole in the slice.",
                      .variable = "both lights' elevation",
                      .unit = "degrees",
                      .low = 1e-6,
                      .high = 90,
                      .scale = CaseScale::Log,
                      .zero = true,
                      .inputs = [](double at) { return Inputs{cosDeg(at), sinDeg(at), 0, -cosDeg(at), sinDeg(at), 0}; },
                      .value = "sum of the weights half-way"});
    curves.push_back({.id = "B-7",
                      .where = "light of slices",
                      .source = "weights.h",
                      .function = "lightOctant",
                      .picture =
                          "A direction that nobody normalised under- or overflows when it is squared: slices are "
                          "black or no number.",
                      .variable = "length of the light's direction",
                      .low = 1e-28,
                      .high = 1e28,
                      .scale = CaseScale::Log,
                      .inputs =
                          [](double at) {
                              return Inputs{0.5 * at, 0.6 * at, 0.3 * at};
                          },
                      .value = "weight of the image lit from +x"});
}

void addDistances(std::vector<CaseCurve>& curves) {
    curves.push_back({.id = "B-8",
                      .where = "tiers: blades, slices, ground",
                      .source = "lod.h",
                      .function = "lodRamp",
                      .picture =
                          "Where blades are to end at one distance instead of over a range, the printed weights turn "
                          "round: nothing near, all of it twice far away.",
                      .variable = "distance, blades ending at 10 m",
                      .unit = "m",
                      .low = 0,
                      .high = 40,
                      .hard = {10},
                      .inputs =
                          [](double at) {
                              return Inputs{at, 10, 10, 20, 30};
                          },
                      .value = "weight of blades drawn one by one"});
    curves.push_back({.id = "B-9",
                      .where = "tiers: blades, slices, ground",
                      .source = "lod.h",
                      .function = "lodInverse",
                      .picture =
                          "A range without end, meant as \"never fade\", is infinity by infinity: the slices of the "
                          "whole field are gone.",
                      .variable = "distance, slices without end",
                      .unit = "m",
                      .low = 1,
                      .high = 1e6,
                      .scale = CaseScale::Log,
                      .inputs =
                          [](double at) {
                              return Inputs{at, 10, 20, 50, kInfinity};
                          },
                      .output = 1,
                      .value = "weight of slices"});
}

}  // namespace

void addWeightCurves(std::vector<CaseCurve>& curves) {
    addForms(curves);
    addHorizon(curves);
    addVectors(curves);
    addDistances(curves);
}

}  // namespace sward
