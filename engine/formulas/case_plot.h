// A hard case's sweep drawn (cost/plot.h): what the printed form and ours give, and how far both are off, along the
// variable that makes it hard; and as a table. Does not: compute it (formulas/case_curve.h), nor write files.
#pragma once
#include <span>
#include <string>

#include "cost/plot.h"
#include "formulas/case_curve.h"

namespace sward {

struct CaseColors {
    std::string ink = "#333333", dim = "#777777", faint = "#e4e4e4";
    std::string published = "#c0392b", ours = "#2e7d32", truth = "#9a9a9a", back = "#ffffff";
};
// Whether to draw the values or the errors, whose axis is logarithmic. What is no number is a mark at the graph's upper
// edge; an error of 0 lies on its lower one.
enum class CaseGraph { Values, Errors };
// Adds a graph of the points to `plot`, with labels left of the box, below and above it: about 60, 34 and 18 pixels.
// `marked`: a value of the variable that gets a line; a NaN: none.
void addCaseGraph(Plot& plot, const HardCase& hardCase, std::span<const CasePoint> points, CaseGraph graph,
                  const PlotBox& box, const CaseColors& colors, double marked);
// Both graphs, one above the other, with the case's name and what goes wrong. Of a case that can be swept.
Plot casePlot(const HardCase& hardCase, int width = 900, int height = 700);

// A line a point: the variable, what both forms give and what is wanted of the shown output, and both errors. What is
// no number is "nan" or "inf", and empty where the row has no printed form.
std::string caseCsv(const HardCase& hardCase, std::span<const CasePoint> points);
// "0.0001", "1.5e-08", "NaN", "inf": short, for people.
std::string caseNumber(double value);

}  // namespace sward
