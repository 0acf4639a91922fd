// The truths that a sweep holds pictures against, and its floors; kept as files, since rays take longest.
#pragma once
#include "cost/cost.h"

namespace sward {

struct CostTruth {
    Picture picture;
    std::vector<float> grass;  // share of each pixel
    CostFloors floors;
};
// The truth of a view. Traces it unless it is in the folder.
Result<CostTruth> costTruthAlone(const CostRequest& request, const Project& project, const Tables& tables,
                                 const CostView& view, const CostProgress& progress);
// With its floors, for which the same is traced at few samples and with other blades.
Result<CostTruth> costTruth(const CostRequest& request, const Project& project, const Tables& tables,
                            const CostView& view, const CostProgress& progress);
// A picture whose grass has in each row its mean colour, by the share of grass.
Picture flatRows(const Picture& picture, const std::vector<float>& grass);

}  // namespace sward
