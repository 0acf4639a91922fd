// Hard cases as curves: each row of the table of formulas along the variable that makes it hard, in the printed form
// and in ours, both in float as the table runs them, and what they come to. The forms are the rows' own bodies
// (formulas/formula_rows.h), which call shaders/numerics/. Does not: judge a row on its samples (formulas/hardcases.h),
// nor draw (formulas/case_plot.h). Cost: a sweep takes 0.1 to 100 ms.
#pragma once
#include <string>
#include <vector>

#include "formulas/formula_rows.h"

namespace sward {

enum class CaseScale { Even, Log };

// How rows of the table are swept, or why they are not.
struct CaseCurve {
    std::string id = {};        // of the hard case
    std::string name = {};      // of the row; empty: of every row of that id
    std::string where = {};     // what draws by the formula
    std::string source = {};    // its file in shaders/numerics
    std::string function = {};  // the formula in that file
    std::string picture = {};   // what goes wrong in the picture, in a sentence or two
    std::string whyNot = {};    // why there is nothing to sweep; then nothing below is set
    std::string variable = {};  // what makes it hard
    std::string unit = {};      // its unit; may be empty
    double low = 0, high = 1;
    CaseScale scale = CaseScale::Even;
    bool zero = false;              // of a logarithmic axis: 0 too, left of `low`
    bool whole = false;             // whole numbers alone
    std::vector<double> hard = {};  // where it is hardest: these are among the points
    // The row's inputs at a value of the variable; they are rounded to float.
    std::vector<double> (*inputs)(double at) = nullptr;
    int output = 0;          // which of the outputs is shown
    std::string value = {};  // what that is
    double measured = 1.0;   // the unit of its errors, beside the row's own measure
    bool relative = false;   // errors in units of what is wanted
    // What is wanted, all outputs; null: the double form of ours at the rounded inputs.
    std::vector<double> (*truth)(double at) = nullptr;
};

// A row of the table with its curve.
struct HardCase {
    std::string key;  // "B-1"; the second row of an id is "B-1.2"
    FormulaRow row;
    CaseCurve curve;
};
// All rows that are hard cases, in the order of `sward hardcases`.
std::vector<HardCase> hardCases();
// The curves alone, in no order that matters.
std::vector<CaseCurve> caseCurves();
// Whether it can be swept.
bool isSwept(const HardCase& hardCase);

struct CasePoint {
    double at = 0;  // the variable
    // What the float forms give and what is wanted: the row's outputs. `published` is empty where the row has none.
    std::vector<double> published, ours, truth;
    // The largest error over the outputs, by the row's measure; NaN where an output is no number.
    double publishedError = 0, oursError = 0;
};
// Of a case that can be swept; `at` is taken into its range, and to a whole number where it has those alone.
CasePoint caseAt(const HardCase& hardCase, double at);
// About `steps` points from low to high, in that order, the hard ones among them.
std::vector<CasePoint> sweepCase(const HardCase& hardCase, int steps = 400);

// Where a value lies on the curve's axis, 0 to 1, and the value at a share of it. On a logarithmic axis with 0 the
// first kZeroShare is kept for that.
inline constexpr double kZeroShare = 0.06;
double shareOn(const CaseCurve& curve, double at);
double valueAt(const CaseCurve& curve, double share);

}  // namespace sward
