// How near to the frontier a project ships: of each camera of a sweep the row `as it is`, by what its error is to be
// held against, and what beats it.
#pragma once
#include "cost/cost.h"

namespace sward {

// At one camera, or moment of a path.
struct ShippedStanding {
    const CostRow* row = nullptr;          // `as it is`, of the run
    double ofBlades = 0;                   // times the error of other blades of the field
    double ofFlatRows = 0;                 // share of the error of rows at their mean colour
    std::vector<const CostRow*> beatenBy;  // rows of the same machine (cost.h, beats), nearest first
};

// Cameras in the order of the run's floors; those without a drawn row `as it is` are left out.
std::vector<ShippedStanding> shippedStandings(const CostRun& run);

// In one line: times and shares, and whether it is on the frontier or which setting beats it.
std::string standingText(const ShippedStanding& standing);

// Rows of a table in Markdown, a camera each, and the head that belongs over them.
std::string shippedHeader();
std::string shippedRows(const CostRun& run);

}  // namespace sward
