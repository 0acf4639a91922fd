// The project's time-appearance plot, in what is left of the current column.
// Does not: measure (accuracy/accuracy.h).
#pragma once
#include <optional>

#include "cost/cost.h"
#include "model/document.h"

namespace sward {

// Where the viewport stands in the plot, as far as that is known.
struct ViewportPoint {
    double ms = 0, error = 0;  // of the last drawing; its appearance error
};

// Of `run`, or an empty frame if nothing was measured. `isMeasured`: the document is still what was measured. The point
// of the project's own settings is marked, else the viewport's. Returns the settings of a point that was clicked.
std::optional<CostSetting> drawCostPlot(const std::optional<CostRun>& run, const Document& document, bool isMeasured,
                                        const std::optional<ViewportPoint>& viewport);

}  // namespace sward
