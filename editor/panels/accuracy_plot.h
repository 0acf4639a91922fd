// The project's time-appearance plot, in what is left of the current column.
// Does not: measure (accuracy/accuracy.h).
#pragma once
#include <optional>

#include "app/app.h"

namespace sward {

// The settings of a point that was clicked.
std::optional<CostSetting> drawCostPlot(EditorApp& app);

}  // namespace sward
