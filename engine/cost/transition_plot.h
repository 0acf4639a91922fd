// Popping along a camera's path as a graph: a bar a step, the floor of other blades as a line over it.
// Does not: measure (cost/transitions.h), nor write files.
#pragma once
#include "cost/plot.h"
#include "cost/transitions.h"

namespace sward {

struct TransitionColors {
    std::string ink = "#333333", dim = "#777777", faint = "#e4e4e4";
    std::string above = "#c0392b", below = "#8fb98f", floor = "#333333", back = "#ffffff";
};
// Adds the graph with labels left of the box and below it, about 52 and 34 pixels. Bars above the floor have their own
// colour. `marked`: a step that gets a frame, or -1.
void addTransitionGraph(Plot& plot, const Transitions& t, const PlotBox& box, const TransitionColors& colors,
                        int marked);
// The step under a pixel across the box, which may lie outside; -1 beyond the path.
int stepAt(const Transitions& t, const PlotBox& box, double x);
// The graph alone under a line that says what it is.
Plot transitionPlot(const Transitions& t, int width = 900, int height = 420);

}  // namespace sward
