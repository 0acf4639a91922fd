// How curves of hard cases are written; for the case_rows_*.cpp files only.
#pragma once
#include <array>
#include <cmath>

#include "formulas/case_curve.h"

namespace sward {

// Sine and cosine of degrees, exact at whole quarters of a turn: there a case is hardest.
inline double sinDeg(double degrees) {
    const double quarter = std::fmod(degrees, 360) / 90;
    if (quarter == std::floor(quarter)) return std::array<double, 4>{0, 1, 0, -1}[(static_cast<int>(quarter) + 4) % 4];
    return std::sin(degrees * 0.017453292519943295);
}
inline double cosDeg(double degrees) { return sinDeg(degrees + 90); }

// Each appends the curves of some rows to `curves`; caseCurves calls all of them.
// Boulanger, Pattanaik, Bouatouch 2006: light weights; what fades and who draws it; blades, shadows, grids.
void addWeightCurves(std::vector<CaseCurve>& curves);
void addFieldCurves(std::vector<CaseCurve>& curves);
void addShapeCurves(std::vector<CaseCurve>& curves);
// Decaudin, Neyret 2004.
void addForestCurves(std::vector<CaseCurve>& curves);
// Habel, Wimmer, Jeschke 2007.
void addRayCurves(std::vector<CaseCurve>& curves);
// Jahrmann, Wimmer 2013.
void addBladeCurves(std::vector<CaseCurve>& curves);
// Time, strokes and lights.
void addSceneCurves(std::vector<CaseCurve>& curves);

}  // namespace sward
